// One call per light for glints: BRDF, reflectance and the light's cosine. Rust:
// src/shade/glints.rs.

// Rust: `GlintShading::evaluate`, with the reflectance at `lobe_half_cosine`. 0 for NaN.
fn lobe_glint_shading_evaluate(
    lobe: LobeGlintNdf, wo: vec3f, wi: vec3f, radius: f32, reflectance: vec3f
) -> vec3f {
    let brdf = lobe_glint_ndf_brdf(lobe, wo, wi, radius);
    let shape = lobe_lobe_shape(lobe_glint_ndf_smooth_lobe(lobe));
    return lobe_shade_color(brdf, lobe_non_centered_mean_area(shape, wi), reflectance);
}

// Rust: `GlintShading::evaluate_colored`, with the hue wheel and the reflectance at
// `lobe_half_cosine`. 0 for NaN.
fn lobe_glint_shading_evaluate_colored(
    lobe: LobeGlintNdf, wo: vec3f, wi: vec3f, radius: f32, reflectance: vec3f
) -> vec3f {
    let shape = lobe_lobe_shape(lobe_glint_ndf_smooth_lobe(lobe));
    let color = lobe_beckmann_evaluate(lobe_non_centered_pair(shape, wo, wi), reflectance);
    if !(color.x > 0.0 || color.y > 0.0 || color.z > 0.0) {
        return color;
    }
    let sparkle =
        lobe_glint_ndf_colored_sparkle(
            lobe, lobe_half_vector(wo, wi), lobe_light_blur(wo, wi, radius)
        );
    return vec3f(
        lobe_below_infinity(lobe_defined(color.x * sparkle.x)),
        lobe_below_infinity(lobe_defined(color.y * sparkle.y)),
        lobe_below_infinity(lobe_defined(color.z * sparkle.z))
    );
}
