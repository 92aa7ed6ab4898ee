// Symmetric positive semi-definite 2x2 matrices that carry the root of their determinant. Rust:
// src/scalar/psd.rs.

// Rust: `Psd`.
struct LobePsd {
    xx: f32,
    xy: f32,
    yy: f32,
    root_det: f32,
}

// Rust: `Eigen`.
struct LobeEigen {
    major: f32,
    minor: f32,
    axis: vec2f,
}

// Rust: `Psd::new`. Where that refuses the entries, the nearest matrix with entries up to 1e18; 0
// for NaN.
fn lobe_psd_new(xx: f32, xy: f32, yy: f32) -> LobePsd {
    let x = lobe_within(xx, 1e18);
    let m = lobe_within(xy, 1e18);
    let y = lobe_within(yy, 1e18);
    let det = lobe_difference_of_products(x, y, m, m);
    let rounding = 2.0 * LOBE_EPSILON * abs(x * y) + LOBE_MIN_POSITIVE;
    if x < 0.0 || y < 0.0 || det < -rounding {
        return lobe_psd_nearest(x, m, y);
    }
    return lobe_psd_from_entries(x, m, y);
}

// Rust: `Psd::from_entries`.
fn lobe_psd_from_entries(xx: f32, xy: f32, yy: f32) -> LobePsd {
    let det = lobe_difference_of_products(xx, yy, xy, xy);
    return LobePsd(xx, xy, yy, sqrt(lobe_max(det, 0.0)));
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

// Rust: `Psd::from_axes`. Numbers outside their ranges count as the nearest, NaN as 0.
fn lobe_psd_from_axes(along: f32, across: f32, cos_of_turn: f32, sin_of_turn: f32) -> LobePsd {
    // A little more than the ranges, which rounding may leave.
    let x = lobe_min(lobe_max(along, 0.0), 4e9);
    let y = lobe_min(lobe_max(across, 0.0), 4e9);
    let cosine = lobe_within(cos_of_turn, 2.0);
    let sine = lobe_within(sin_of_turn, 2.0);
    let xx = x * x;
    let yy = y * y;
    return LobePsd(
        xx * cosine * cosine + yy * sine * sine,
        (x - y) * (x + y) * cosine * sine,
        xx * sine * sine + yy * cosine * cosine,
        x * y
    );
}

// Rust: `Psd::from_deviations`.
fn lobe_psd_from_deviations(x: f32, y: f32, rho: f32) -> LobePsd {
    let complement = sqrt((1.0 - rho) * (1.0 + rho));
    return LobePsd(x * x, rho * x * y, y * y, x * y * complement);
}

// Rust: `Psd::outer_sum`. Components beyond 2e9 count as that; 0 for NaN.
fn lobe_psd_outer_sum(u: vec2f, v: vec2f) -> LobePsd {
    let a = lobe_both_within(u, 2e9);
    let b = lobe_both_within(v, 2e9);
    return LobePsd(
        a.x * a.x + b.x * b.x,
        lobe_sum_of_products(a.x, a.y, b.x, b.y),
        a.y * a.y + b.y * b.y,
        abs(lobe_cross(a, b))
    );
}

// Rust: `Psd::det`.
fn lobe_psd_det(m: LobePsd) -> f32 {
    return m.root_det * m.root_det;
}

// Rust: `Psd::trace`.
fn lobe_psd_trace(m: LobePsd) -> f32 {
    return m.xx + m.yy;
}

// Rust: `Psd::is_singular`.
fn lobe_psd_is_singular(m: LobePsd) -> bool {
    let minor = m.root_det * lobe_kept(m.root_det / lobe_max(lobe_psd_trace(m), LOBE_MIN_POSITIVE));
    let least = lobe_min(lobe_min(minor, m.xx), m.yy);
    return !(least >= LOBE_MIN_POSITIVE);
}

// Rust: `Psd::mixed_det`.
fn lobe_psd_mixed_det(a: LobePsd, b: LobePsd) -> f32 {
    let u = lobe_difference_of_products(a.xx, b.xy, a.xy, b.xx);
    let least = LOBE_MIN_POSITIVE / (LOBE_EPSILON * LOBE_EPSILON);
    let of_a = 1.0 / lobe_max(a.xx, least);
    let of_b = 1.0 / lobe_max(b.xx, least);
    let squares = lobe_below_infinity(abs(u * of_a)) * lobe_below_infinity(abs(u * of_b))
        + b.xx * lobe_kept(a.root_det * lobe_kept(a.root_det * of_a))
        + a.xx * lobe_kept(b.root_det * lobe_kept(b.root_det * of_b));
    let products = a.xx * b.yy + a.yy * b.xx - 2.0 * a.xy * b.xy;
    return select(squares, lobe_max(products, 0.0), lobe_min(a.xx, b.xx) < least);
}

// Rust: `Psd::quadratic`. 0 for NaN.
fn lobe_psd_quadratic(m: LobePsd, w: vec2f) -> f32 {
    if m.xx < LOBE_MIN_POSITIVE {
        return lobe_defined(m.yy * w.y * w.y);
    }
    let u = lobe_sum_of_products(m.xx, w.x, m.xy, w.y);
    let along_y = m.root_det * w.y;
    return lobe_defined((u * u + along_y * along_y) / m.xx);
}

// Rust: `Psd::cholesky`: l11, l21, l22.
fn lobe_psd_cholesky(m: LobePsd) -> vec3f {
    if m.xx < LOBE_MIN_POSITIVE {
        return vec3f(0.0, 0.0, sqrt(m.yy));
    }
    let diagonal = sqrt(m.xx);
    return vec3f(diagonal, m.xy / diagonal, m.root_det / diagonal);
}

// Rust: `Psd::eigen`.
fn lobe_psd_eigen(m: LobePsd) -> LobeEigen {
    let along = lobe_psd_principal(m.xx, m.xy, m.yy);
    let major = along.x;
    let minor = m.root_det * lobe_kept(m.root_det / lobe_max(major, LOBE_MIN_POSITIVE));
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

// Rust: `Psd::mul`.
fn lobe_psd_mul(m: LobePsd, factor: f32) -> LobePsd {
    let f = lobe_below_infinity(lobe_max(factor, 0.0));
    return LobePsd(m.xx * f, m.xy * f, m.yy * f, m.root_det * f);
}

// Rust: `Psd::add`.
fn lobe_psd_add(a: LobePsd, b: LobePsd) -> LobePsd {
    let det = lobe_psd_det(a) + lobe_psd_mixed_det(a, b) + lobe_psd_det(b);
    // A root of infinity by a reciprocal estimate is NaN.
    return LobePsd(a.xx + b.xx, a.xy + b.xy, a.yy + b.yy, sqrt(lobe_below_infinity(det)));
}

// Rust: `principal`: the larger eigenvalue, and its unit vector.
fn lobe_psd_principal(xx: f32, xy: f32, yy: f32) -> vec3f {
    let half_difference = 0.5 * (xx - yy);
    let scale = lobe_max(abs(half_difference), abs(xy));
    if scale < LOBE_MIN_POSITIVE {
        return vec3f(xx, 1.0, 0.0);
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
