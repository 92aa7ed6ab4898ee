// One call per light: BRDF, reflectance and the light's cosine. Rust: src/shade.rs.

// Rust: `Material::bake`: once per pixel, for all its lights.
fn lobe_material_bake(lobe: LobeLobe, kernel: LobeKernel) -> LobeNonCentered {
    return lobe_lobe_shape(lobe_lobe_widened(lobe, kernel));
}

// WGSL only: the cosine that a Fresnel term takes, between a direction and the half vector.
fn lobe_half_cosine(wo: vec3f, wi: vec3f) -> f32 {
    let h = lobe_half_vector(wo, wi);
    return lobe_defined(wo.x * h.x + wo.y * h.y + wo.z * h.z);
}

// Rust: `Shading::evaluate`, of GGX, with the reflectance at `lobe_half_cosine`. 0 for NaN.
fn lobe_ggx_evaluate(shape: LobeNonCentered, wo: vec3f, wi: vec3f, reflectance: vec3f) -> vec3f {
    return lobe_shade_color(
        shape, lobe_ggx_brdf(lobe_non_centered_pair(shape, wo, wi)), wi, reflectance
    );
}

// Rust: `Shading::evaluate`, of Beckmann, with the reflectance at `lobe_half_cosine`. 0 for NaN.
fn lobe_beckmann_evaluate(
    shape: LobeNonCentered, wo: vec3f, wi: vec3f, reflectance: vec3f
) -> vec3f {
    return lobe_shade_color(
        shape, lobe_beckmann_brdf(lobe_non_centered_pair(shape, wo, wi)), wi, reflectance
    );
}

// Rust: `color`.
fn lobe_shade_color(shape: LobeNonCentered, brdf: f32, wi: vec3f, reflectance: vec3f) -> vec3f {
    let area = lobe_max(lobe_non_centered_mean_area(shape, wi), 0.0);
    return vec3f(
        lobe_shade_channel(reflectance.x, brdf, area),
        lobe_shade_channel(reflectance.y, brdf, area),
        lobe_shade_channel(reflectance.z, brdf, area)
    );
}

// WGSL only: Rust has it as a closure.
fn lobe_shade_channel(reflectance: f32, brdf: f32, area: f32) -> f32 {
    return lobe_below_infinity(lobe_defined(reflectance * brdf * area));
}

// Rust: `Shading::evaluate_over`, with the reflectance at `lobe_half_cosine`. 0 for NaN.
fn lobe_ggx_evaluate_over(
    shape: LobeNonCentered, wo: vec3f, wi: vec3f, footprint: LobeFootprint, reflectance: vec3f
) -> vec3f {
    return lobe_shade_color(shape, lobe_ggx_brdf_over(shape, wo, wi, footprint), wi, reflectance);
}
