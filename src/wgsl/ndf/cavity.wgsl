// Masking of V-shaped cavities: a function of the facet, not of the distribution. Rust:
// src/ndf/cavity.rs.

// Rust: `cavity_masking`. 0 for NaN.
fn lobe_cavity_masking(w: vec3f, m: vec3f) -> f32 {
    let facing = lobe_dot(w, m);
    if facing > 0.0 && w.z > 0.0 && m.z > 0.0 {
        return lobe_min(lobe_defined(2.0 * m.z * w.z / facing), 1.0);
    }
    return 0.0;
}

// Rust: `cavity_masking_shadowing`. 0 for NaN.
fn lobe_cavity_masking_shadowing(wo: vec3f, wi: vec3f, m: vec3f) -> f32 {
    return lobe_min(lobe_cavity_masking(wo, m), lobe_cavity_masking(wi, m));
}
