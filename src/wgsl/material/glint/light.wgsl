// What a light's extent does to details. Rust: src/material/glint/light.rs.

// Rust: `light_blur`.
fn lobe_light_blur(wo: vec3f, wi: vec3f, radius: f32) -> f32 {
    let h = lobe_half_vector(wo, wi);
    let solid = 4.0 * lobe_dot(wi, h) * (h.z * h.z * h.z);
    let size = lobe_max(radius, 0.0);
    return lobe_min(size * size / lobe_max(solid, LOBE_MIN_POSITIVE), LOBE_LARGEST);
}
