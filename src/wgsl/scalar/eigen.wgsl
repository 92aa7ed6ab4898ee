// Eigenvalues of symmetric 2x2 matrices, and what is made by them. Rust: src/scalar/eigen.rs.

// Rust: `Eigen`.
struct LobeEigen {
    major: f32,
    minor: f32,
    axis: vec2f,
}

// Rust: `Psd::nearest`. Entries beyond 4e18 count as about that; 0 for NaN.
fn lobe_psd_nearest(xx: f32, xy: f32, yy: f32) -> LobePsd {
    let x = lobe_within(xx, 4e18);
    let m = lobe_within(xy, 4e18);
    let y = lobe_within(yy, 4e18);
    let det = lobe_difference_of_products(x, y, m, m);
    if x >= 0.0 && y >= 0.0 && det >= 0.0 {
        return lobe_psd_from_entries(x, m, y);
    }
    let along = lobe_psd_principal(x, m, y);
    let length = sqrt(lobe_max(along.x, 0.0));
    return lobe_psd_outer_sum(vec2f(length * along.y, length * along.z), vec2f(0.0, 0.0));
}

// Rust: `Psd::eigen`.
fn lobe_psd_eigen(m: LobePsd) -> LobeEigen {
    let entries = lobe_psd_entries(m);
    let along = lobe_psd_principal(entries.x, entries.y, entries.z);
    let major = along.x;
    let root_det = lobe_psd_root_det(m);
    let minor = root_det * lobe_kept(root_det / lobe_max(major, LOBE_MIN_POSITIVE));
    return LobeEigen(major, lobe_min(minor, major), along.yz);
}

// Rust: `Psd::capped`.
fn lobe_psd_capped(m: LobePsd, limit: f32) -> LobePsd {
    let cap = lobe_max(limit, 0.0);
    let eigen = lobe_psd_eigen(m);
    if eigen.major <= cap {
        return m;
    }
    return lobe_psd_from_axes(
        sqrt(cap), sqrt(lobe_min(eigen.minor, cap)), eigen.axis.x, eigen.axis.y
    );
}

// Rust: `principal`: the larger eigenvalue, and its unit vector.
fn lobe_psd_principal(xx: f32, xy: f32, yy: f32) -> vec3f {
    let half_difference = 0.5 * (xx - yy);
    let scale = lobe_max(abs(half_difference), abs(xy));
    let least = 4.0 * LOBE_EPSILON * abs(xx + yy);
    if scale <= lobe_max(least, LOBE_MIN_POSITIVE) {
        return vec3f(lobe_max(xx, yy), 1.0, 0.0);
    }
    let h = lobe_kept(half_difference / scale);
    let k = lobe_kept(xy / scale);
    let r = sqrt(h * h + k * k);
    let forward = h >= 0.0;
    let x = select(k, h + r, forward);
    let y = select(r - h, k, forward);
    let length = sqrt(x * x + y * y);
    return vec3f(0.5 * (xx + yy) + r * scale, x / length, y / length);
}
