// The shape of any roughness matrix. Rust: src/slope/anisotropic.rs.

// Rust: `Anisotropic`.
struct LobeAnisotropic {
    xx: f32,
    xy: f32,
    root_det: f32,
    inverse_xx: f32,
    along: f32,
    across: f32,
    schur: f32,
}

// Rust: `Anisotropic::new`.
fn lobe_anisotropic_new(roughness: LobeRoughness) -> LobeAnisotropic {
    let psd = roughness.psd;
    let xx = psd.xx;
    let root_det = select(psd.root_det, 0.0, lobe_psd_is_singular(psd));
    let flat = xx < LOBE_MIN_POSITIVE;
    let inverse = 1.0 / lobe_max(xx, LOBE_MIN_POSITIVE);
    let along = root_det * inverse;
    return LobeAnisotropic(
        xx,
        psd.xy,
        root_det,
        select(inverse, 0.0, flat),
        along,
        lobe_below_infinity(xx / lobe_max(root_det, LOBE_MIN_POSITIVE)),
        select(root_det * along, psd.yy, flat)
    );
}

// Rust: `Anisotropic::form`. The largest number for NaN.
fn lobe_anisotropic_form(shape: LobeAnisotropic, m: vec3f, m_low: vec3f) -> f32 {
    let low = shape.xx * m_low.y - shape.xy * m_low.x;
    let u = lobe_difference_of_products(shape.xx, m.y, shape.xy, m.x) + low;
    let t = u * shape.inverse_xx;
    return lobe_far(m.x * m.x * shape.along + t * t * shape.across);
}

// Rust: `Anisotropic::whiten`. 0 for NaN.
fn lobe_anisotropic_whiten(shape: LobeAnisotropic, v: vec2f, v_low: vec2f) -> vec2f {
    let low = shape.xx * v_low.y - shape.xy * v_low.x;
    let u = lobe_difference_of_products(shape.xx, v.y, shape.xy, v.x) + low;
    let diagonal = sqrt(shape.xx);
    return vec2f(
        lobe_defined((v.x + v_low.x) / diagonal),
        lobe_defined(u * shape.inverse_xx * diagonal / shape.root_det)
    );
}

// Rust: `Anisotropic::major`: the unit vector, then alpha. Along x for NaN.
fn lobe_anisotropic_major(shape: LobeAnisotropic) -> vec3f {
    let yy = lobe_defined(shape.xy * (shape.xy * shape.inverse_xx) + shape.schur);
    let swap = yy > shape.xx;
    let large = select(shape.xx, yy, swap);
    let ratio = lobe_defined(shape.xy / lobe_max(large, LOBE_MIN_POSITIVE));
    let square = 1.0 + ratio * ratio;
    let inverse = 1.0 / sqrt(square);
    let across = ratio * inverse;
    let alpha = lobe_defined(sqrt(large * square));
    return select(vec3f(inverse, across, alpha), vec3f(across, inverse, alpha), swap);
}

// Rust: `Anisotropic::stretch_squared`. 0 for NaN.
fn lobe_anisotropic_stretch_squared(shape: LobeAnisotropic, w: vec3f) -> f32 {
    let u = lobe_sum_of_products(shape.xx, w.x, shape.xy, w.y);
    return lobe_defined(u * (u * shape.inverse_xx) + shape.schur * w.y * w.y);
}

// WGSL only: its answers at a normal.
fn lobe_anisotropic_normal(shape: LobeAnisotropic, m: vec3f) -> LobeNormal {
    return LobeNormal(
        lobe_anisotropic_form(shape, m, vec3f(0.0, 0.0, 0.0)), shape.root_det, lobe_defined(m.z)
    );
}

// WGSL only: its answers at a direction.
fn lobe_anisotropic_view(shape: LobeAnisotropic, w: vec3f) -> LobeView {
    return lobe_view_of(w, w.z, lobe_anisotropic_stretch_squared(shape, w));
}

// WGSL only: its answers at a pair of directions.
fn lobe_anisotropic_pair(shape: LobeAnisotropic, wo: vec3f, wi: vec3f) -> LobePair {
    let half = lobe_half_sum(wo, wi);
    let form = lobe_anisotropic_form(shape, half.high, half.low);
    return lobe_pair_of(
        half.high, form, shape.root_det, lobe_anisotropic_view(shape, wo),
        lobe_anisotropic_view(shape, wi), lobe_min(wo.z, wi.z)
    );
}
