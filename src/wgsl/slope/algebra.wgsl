// Reliefs that add, lean, stretch and turn. Rust: src/slope/algebra.rs.

// Rust: `SlopeMoments::add`.
fn lobe_slope_moments_add(moments: LobeSlopeMoments, other: LobeSlopeMoments) -> LobeSlopeMoments {
    return lobe_slope_moments_bounded(
        vec2f(moments.mean.x + other.mean.x, moments.mean.y + other.mean.y),
        lobe_psd_add(moments.covariance, other.covariance)
    );
}

// Rust: `SlopeMoments::mul`. NaN counts as 0.
fn lobe_slope_moments_mul(moments: LobeSlopeMoments, factor: f32) -> LobeSlopeMoments {
    let f = lobe_within(factor, LOBE_LARGEST);
    return lobe_slope_moments_bounded(
        vec2f(f * moments.mean.x, f * moments.mean.y), lobe_psd_mul(moments.covariance, f * f)
    );
}

// Rust: `SlopeMoments::plus_correlated`. Rows of Rust's cross covariance are rows here. 0 for NaN.
fn lobe_slope_moments_plus_correlated(
    moments: LobeSlopeMoments, other: LobeSlopeMoments, cross: mat2x2f
) -> LobeSlopeMoments {
    let a = lobe_psd_entries(moments.covariance);
    let b = lobe_psd_entries(other.covariance);
    let between = lobe_within(cross[1][0], 1e18) + lobe_within(cross[0][1], 1e18);
    let covariance = lobe_psd_nearest(
        a.x + b.x + 2.0 * lobe_within(cross[0][0], 1e18),
        a.y + b.y + between,
        a.z + b.z + 2.0 * lobe_within(cross[1][1], 1e18)
    );
    let mean = vec2f(moments.mean.x + other.mean.x, moments.mean.y + other.mean.y);
    return lobe_slope_moments_bounded(mean, covariance);
}

// Rust: `SlopeMoments::cross_covariance`. 0 for NaN.
fn lobe_slope_moments_cross_covariance(
    moments: LobeSlopeMoments, other: LobeSlopeMoments, moment: mat2x2f
) -> mat2x2f {
    let a = moments.mean;
    let b = other.mean;
    return mat2x2f(
        lobe_slope_central(moment[0][0], a.x, b.x), lobe_slope_central(moment[0][1], a.y, b.x),
        lobe_slope_central(moment[1][0], a.x, b.y), lobe_slope_central(moment[1][1], a.y, b.y)
    );
}

// WGSL only: Rust has it as a closure.
fn lobe_slope_central(moment: f32, p: f32, q: f32) -> f32 {
    return lobe_difference_of_products(lobe_within(moment, 1e18), 1.0, p, q);
}

// Rust: `SlopeMoments::tilted`. Slopes beyond 1e9 count as that, NaN as 0.
fn lobe_slope_moments_tilted(moments: LobeSlopeMoments, slope: vec2f) -> LobeSlopeMoments {
    return lobe_slope_moments_add(moments, lobe_slope_moments_of_slope(slope));
}

// Rust: `SlopeMoments::transformed`. Entries beyond 1e9 count as that, NaN as 0.
fn lobe_slope_moments_transformed(moments: LobeSlopeMoments, matrix: mat2x2f) -> LobeSlopeMoments {
    let m = mat2x2f(
        lobe_both_within(matrix[0], LOBE_LARGEST), lobe_both_within(matrix[1], LOBE_LARGEST)
    );
    let factor = moments.covariance;
    let u = lobe_jacobian_apply(m, vec2f(factor.l_xx, factor.l_yx));
    let v = lobe_jacobian_apply(m, vec2f(0.0, factor.l_yy));
    let det = abs(lobe_cross(vec2f(m[0][0], m[1][0]), vec2f(m[0][1], m[1][1])));
    let root_det = det * lobe_psd_root_det(factor);
    return lobe_slope_moments_bounded(
        lobe_jacobian_apply(m, moments.mean), lobe_psd_outer_sum_with_root_det(u, v, root_det)
    );
}

// Rust: `SlopeMoments::bounded`. 0 for NaN.
fn lobe_slope_moments_bounded(mean: vec2f, covariance: LobePsd) -> LobeSlopeMoments {
    let limit = LOBE_LARGEST * LOBE_LARGEST;
    let entries = lobe_psd_entries(covariance);
    let most = lobe_max(entries.x, entries.z);
    let kept = lobe_both_within(mean, LOBE_LARGEST);
    if most > limit {
        return LobeSlopeMoments(kept, lobe_psd_mul(covariance, limit / most));
    }
    return LobeSlopeMoments(kept, covariance);
}
