// The shape of any roughness matrix. Rust: src/slope/anisotropic.rs.

// Rust: `Anisotropic`.
struct LobeAnisotropic {
    factor: LobePsd,
    root_det: f32,
}

// Rust: `Anisotropic::new`.
fn lobe_anisotropic_new(roughness: LobeRoughness) -> LobeAnisotropic {
    let factor = roughness.psd;
    return LobeAnisotropic(
        factor, select(lobe_psd_root_det(factor), 0.0, lobe_psd_is_singular(factor))
    );
}

// Rust: `Anisotropic::extent`.
fn lobe_anisotropic_extent(shape: LobeAnisotropic) -> LobeExtent {
    return lobe_extent_of(shape.root_det);
}

// Rust: `Anisotropic::form`. The largest number for NaN.
fn lobe_anisotropic_form(shape: LobeAnisotropic, v: vec2f) -> f32 {
    return lobe_far(lobe_psd_adjugate_form(shape.factor, v));
}

// Rust: `Anisotropic::stretch_squared`. 0 for NaN.
fn lobe_anisotropic_stretch_squared(shape: LobeAnisotropic, w: vec3f) -> f32 {
    return lobe_psd_quadratic(shape.factor, w.xy);
}

// Rust: `Anisotropic::whiten`. 0 for NaN.
fn lobe_anisotropic_whiten(shape: LobeAnisotropic, v: vec2f, v_low: vec2f) -> vec2f {
    let factor = shape.factor;
    let low = factor.l_xx * v_low.y - factor.l_yx * v_low.x;
    let across = lobe_difference_of_products(factor.l_xx, v.y, factor.l_yx, v.x) + low;
    return vec2f(
        lobe_defined((v.x + v_low.x) / factor.l_xx), lobe_defined(across / shape.root_det)
    );
}

// Rust: `Anisotropic::major`: the unit vector, then alpha. Along x for NaN.
fn lobe_anisotropic_major(shape: LobeAnisotropic) -> vec3f {
    let entries = lobe_psd_entries(shape.factor);
    let swap = entries.z > entries.x;
    let large = select(entries.x, entries.z, swap);
    let ratio = lobe_defined(entries.y / lobe_max(large, LOBE_MIN_POSITIVE));
    let square = 1.0 + ratio * ratio;
    let inverse = 1.0 / sqrt(square);
    let across = ratio * inverse;
    let alpha = lobe_defined(sqrt(large * square));
    return select(vec3f(inverse, across, alpha), vec3f(across, inverse, alpha), swap);
}

// WGSL only: its answers at a normal.
fn lobe_anisotropic_normal(shape: LobeAnisotropic, m: vec3f) -> LobeNormal {
    return LobeNormal(
        lobe_anisotropic_form(shape, m.xy), lobe_anisotropic_extent(shape), lobe_defined(m.z)
    );
}

// WGSL only: its answers at a direction.
fn lobe_anisotropic_view(shape: LobeAnisotropic, w: vec3f) -> LobeView {
    return lobe_view_of(w, w.z, lobe_anisotropic_stretch_squared(shape, w));
}

// WGSL only: its answers at a pair of directions.
fn lobe_anisotropic_pair(shape: LobeAnisotropic, wo: vec3f, wi: vec3f) -> LobePair {
    let half = lobe_half_sum(wo, wi);
    return lobe_pair_of(
        half, lobe_anisotropic_form(shape, half.xy), lobe_anisotropic_extent(shape),
        lobe_anisotropic_view(shape, wo), lobe_anisotropic_view(shape, wi), lobe_min(wo.z, wi.z)
    );
}
