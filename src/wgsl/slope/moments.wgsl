// Mean and covariance of a patch of slopes. Rust: src/slope/moments.rs.

// Rust: `SlopeMoments`.
struct LobeSlopeMoments {
    mean: vec2f,
    covariance: LobePsd,
}

// Rust: `SlopeMoments::new`. Means beyond 1e9 count as that, NaN as 0.
fn lobe_slope_moments_new(mean: vec2f, covariance: LobePsd) -> LobeSlopeMoments {
    return LobeSlopeMoments(lobe_both_within(mean, LOBE_LARGEST), covariance);
}

// Rust: `SlopeMoments::of_slope`.
fn lobe_slope_moments_of_slope(slope: vec2f) -> LobeSlopeMoments {
    return lobe_slope_moments_new(slope, LobePsd(0.0, 0.0, 0.0));
}

// Rust: `SlopeMoments::from_raw`. Moments beyond the ranges count as the nearest, NaN as 0.
fn lobe_slope_moments_from_raw(mean: vec2f, second: vec3f) -> LobeSlopeMoments {
    let x = lobe_within(mean.x, LOBE_LARGEST);
    let y = lobe_within(mean.y, LOBE_LARGEST);
    let covariance = lobe_psd_nearest(
        lobe_difference_of_products(lobe_within(second.x, 1e18), 1.0, x, x),
        lobe_difference_of_products(lobe_within(second.y, 1e18), 1.0, x, y),
        lobe_difference_of_products(lobe_within(second.z, 1e18), 1.0, y, y)
    );
    return LobeSlopeMoments(vec2f(x, y), covariance);
}

// Rust: `SlopeMoments::merged`. A weight that is no weight counts as 0; two of them leave the first
// moments.
fn lobe_slope_moments_merged(
    moments: LobeSlopeMoments, weight: f32, other: LobeSlopeMoments, other_weight: f32
) -> LobeSlopeMoments {
    let a = lobe_max(weight, 0.0);
    let b = lobe_max(other_weight, 0.0);
    let sum = a + b;
    if !(sum > 0.0 && lobe_is_finite(sum)) {
        return moments;
    }
    let p = a / sum;
    let q = b / sum;
    let d = vec2f(other.mean.x - moments.mean.x, other.mean.y - moments.mean.y);
    let spread = sqrt(p * q);
    let between = lobe_psd_outer_sum(vec2f(d.x * spread, d.y * spread), vec2f(0.0, 0.0));
    let within = lobe_psd_add(
        lobe_psd_mul(moments.covariance, p), lobe_psd_mul(other.covariance, q)
    );
    return LobeSlopeMoments(
        vec2f(moments.mean.x + q * d.x, moments.mean.y + q * d.y), lobe_psd_add(within, between)
    );
}

// Rust: `SlopeMoments::lobe`.
fn lobe_slope_moments_lobe(moments: LobeSlopeMoments, base: LobeRoughness) -> LobeLobe {
    let roughness = lobe_roughness_add(base, lobe_roughness_from_covariance(moments.covariance));
    return LobeLobe(moments.mean, roughness);
}
