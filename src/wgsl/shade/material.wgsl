// One call per light: BRDF, reflectance and the light's cosine. Rust: src/shade/material.rs.

// Rust: `Material::bake`: once per pixel, for all its lights, of a lobe with a mean or any matrix.
// An isotropic lobe without a mean takes `lobe_kernel_widen` instead, and meets no matrix.
fn lobe_material_bake(lobe: LobeLobe, kernel: LobeKernel) -> LobeNonCentered {
    return lobe_lobe_shape(lobe_lobe_widened(lobe, kernel));
}

// WGSL only: the cosine that a Fresnel term takes, between a direction and the half vector.
fn lobe_half_cosine(wo: vec3f, wi: vec3f) -> f32 {
    let h = lobe_half_vector(wo, wi);
    return lobe_defined(wo.x * h.x + wo.y * h.y + wo.z * h.z);
}

// Rust: `Shading::evaluate`, of GGX and of a shape's answers at a pair of directions, with the
// reflectance at `lobe_half_cosine`. 0 for NaN.
fn lobe_ggx_evaluate(at: LobePair, reflectance: vec3f) -> vec3f {
    return lobe_shade_color(lobe_ggx_brdf(at), at.wi.mean_area, reflectance);
}

// Rust: `Shading::evaluate`, of Beckmann and of a shape's answers at a pair of directions, with the
// reflectance at `lobe_half_cosine`. 0 for NaN.
fn lobe_beckmann_evaluate(at: LobePair, reflectance: vec3f) -> vec3f {
    return lobe_shade_color(lobe_beckmann_brdf(at), at.wi.mean_area, reflectance);
}

// Rust: `color`.
fn lobe_shade_color(brdf: f32, mean_area: f32, reflectance: vec3f) -> vec3f {
    let area = lobe_max(mean_area, 0.0);
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
    return lobe_shade_color(
        lobe_ggx_brdf_over(shape, wo, wi, footprint), lobe_non_centered_mean_area(shape, wi),
        reflectance
    );
}
