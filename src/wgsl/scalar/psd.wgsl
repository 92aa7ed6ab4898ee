// Symmetric positive semi-definite 2x2 matrices, kept as a factor. Rust: src/scalar/psd.rs.

// Rust: `Psd`.
struct LobePsd {
    l_xx: f32,
    l_yx: f32,
    l_yy: f32,
}

// WGSL only: the bound of `flat`.
const LOBE_PSD_LEAST: f32 = 9.860761315262648e-32;

// Rust: `Psd::new`. Diagonal entries beyond [0, 1e18] count as the nearest, an xy beyond what they
// allow as that, NaN as 0.
fn lobe_psd_new(xx: f32, xy: f32, yy: f32) -> LobePsd {
    let x = lobe_min(lobe_max(xx, 0.0), 1e18);
    let y = lobe_min(lobe_max(yy, 0.0), 1e18);
    // A rounding more, which the determinant drops.
    let most = 1.000001 * (sqrt(x) * sqrt(y));
    return lobe_psd_from_entries(x, lobe_within(xy, most), y);
}

// Rust: `Psd::from_entries`.
fn lobe_psd_from_entries(xx: f32, xy: f32, yy: f32) -> LobePsd {
    let det = lobe_difference_of_products(xx, yy, xy, xy);
    return lobe_psd_with_root_det(vec3f(xx, xy, yy), sqrt(lobe_max(det, 0.0)));
}

// Rust: `Psd::with_root_det`.
fn lobe_psd_with_root_det(entries: vec3f, root_det: f32) -> LobePsd {
    let flat = entries.x < LOBE_PSD_LEAST;
    let length = sqrt(lobe_max(entries.x, LOBE_MIN_POSITIVE));
    let inverse = 1.0 / length;
    return LobePsd(
        select(length, 0.0, flat),
        select(entries.y * inverse, 0.0, flat),
        select(root_det * inverse, sqrt(lobe_max(entries.z, 0.0)), flat)
    );
}

// Rust: `Psd::from_axes`. Numbers outside their ranges count as the nearest, NaN as 0.
fn lobe_psd_from_axes(along: f32, across: f32, cos_of_turn: f32, sin_of_turn: f32) -> LobePsd {
    // A little more than the ranges, which rounding may leave.
    let x = lobe_min(lobe_max(along, 0.0), 4e9);
    let y = lobe_min(lobe_max(across, 0.0), 4e9);
    let cosine = lobe_within(cos_of_turn, 2.0);
    let sine = lobe_within(sin_of_turn, 2.0);
    if sine == 0.0 {
        return LobePsd(x, 0.0, y);
    }
    let xx = x * x;
    let yy = y * y;
    let entries = vec3f(
        xx * cosine * cosine + yy * sine * sine,
        (x - y) * (x + y) * cosine * sine,
        xx * sine * sine + yy * cosine * cosine
    );
    return lobe_psd_with_root_det(entries, x * y);
}

// Rust: `Psd::from_deviations`.
fn lobe_psd_from_deviations(x: f32, y: f32, rho: f32) -> LobePsd {
    let complement = sqrt((1.0 - rho) * (1.0 + rho));
    let regular = x > 0.0;
    return LobePsd(
        select(0.0, x, regular), select(0.0, rho * y, regular), select(y, y * complement, regular)
    );
}

// Rust: `Psd::outer_sum`. Components beyond 2e9 count as that; 0 for NaN.
fn lobe_psd_outer_sum(u: vec2f, v: vec2f) -> LobePsd {
    let a = lobe_both_within(u, 2e9);
    let b = lobe_both_within(v, 2e9);
    return lobe_psd_outer_sum_with_root_det(a, b, abs(a.x * b.y - a.y * b.x));
}

// Rust: `Psd::outer_sum_with_root_det`.
fn lobe_psd_outer_sum_with_root_det(u: vec2f, v: vec2f, root_det: f32) -> LobePsd {
    let entries = vec3f(u.x * u.x + v.x * v.x, u.x * u.y + v.x * v.y, u.y * u.y + v.y * v.y);
    return lobe_psd_with_root_det(entries, root_det);
}

// Rust: `Psd::with_columns`.
fn lobe_psd_with_columns(m: LobePsd, u: vec2f, v: vec2f) -> LobePsd {
    let xx = m.l_xx * m.l_xx + (u.x * u.x + v.x * v.x);
    let flat = xx < LOBE_PSD_LEAST;
    let length = sqrt(lobe_max(xx, LOBE_MIN_POSITIVE));
    let inverse = 1.0 / length;
    let r = m.l_xx * inverse;
    let r_u = u.x * inverse;
    let r_v = v.x * inverse;
    let lean = r * m.l_yx + (r_u * u.y + r_v * v.y);
    let a = r * u.y - r_u * m.l_yx;
    let b = r * v.y - r_v * m.l_yx;
    let c = r_u * v.y - r_v * u.y;
    let along_y = m.l_yx * m.l_yx + (u.y * u.y + v.y * v.y);
    let across = a * a + (b * b + c * c);
    let yy = m.l_yy * m.l_yy + select(across, along_y, flat);
    return LobePsd(select(length, 0.0, flat), select(lean, 0.0, flat), sqrt(yy));
}

// Rust: `Psd::entries`: xx, xy, yy.
fn lobe_psd_entries(m: LobePsd) -> vec3f {
    return vec3f(m.l_xx * m.l_xx, m.l_xx * m.l_yx, m.l_yx * m.l_yx + m.l_yy * m.l_yy);
}

// Rust: `Psd::det`.
fn lobe_psd_det(m: LobePsd) -> f32 {
    return lobe_psd_root_det(m) * lobe_psd_root_det(m);
}

// Rust: `Psd::root_det`.
fn lobe_psd_root_det(m: LobePsd) -> f32 {
    return m.l_xx * m.l_yy;
}

// Rust: `Psd::trace`.
fn lobe_psd_trace(m: LobePsd) -> f32 {
    return m.l_xx * m.l_xx + (m.l_yx * m.l_yx + m.l_yy * m.l_yy);
}

// Rust: `Psd::is_singular`.
fn lobe_psd_is_singular(m: LobePsd) -> bool {
    return !(lobe_psd_det(m) >= LOBE_MIN_POSITIVE);
}

// Rust: `Psd::adjugate_form`.
fn lobe_psd_adjugate_form(m: LobePsd, v: vec2f) -> f32 {
    let along = m.l_xx * v.y - m.l_yx * v.x;
    let across = m.l_yy * v.x;
    return along * along + across * across;
}

// Rust: `Psd::mixed_det`.
fn lobe_psd_mixed_det(a: LobePsd, b: LobePsd) -> f32 {
    return lobe_psd_adjugate_form(a, vec2f(b.l_xx, b.l_yx))
        + lobe_psd_adjugate_form(a, vec2f(0.0, b.l_yy));
}

// Rust: `Psd::quadratic`. 0 for NaN.
fn lobe_psd_quadratic(m: LobePsd, w: vec2f) -> f32 {
    let along = m.l_xx * w.x + m.l_yx * w.y;
    let across = m.l_yy * w.y;
    return lobe_defined(along * along + across * across);
}

// Rust: `Psd::mul`.
fn lobe_psd_mul(m: LobePsd, factor: f32) -> LobePsd {
    let root = sqrt(lobe_below_infinity(lobe_max(factor, 0.0)));
    return LobePsd(m.l_xx * root, m.l_yx * root, m.l_yy * root);
}

// Rust: `Psd::add`.
fn lobe_psd_add(a: LobePsd, b: LobePsd) -> LobePsd {
    return lobe_psd_with_columns(a, vec2f(b.l_xx, b.l_yx), vec2f(0.0, b.l_yy));
}
