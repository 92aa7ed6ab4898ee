// One call per light for glints: BRDF, reflectance and the light's cosine. Rust: src/shade/glints.rs.

// Rust: `GlintShading::evaluate`, with the reflectance at `lobe_half_cosine`. 0 for NaN.
fn lobe_glint_evaluate(lobe: LobeGlintLobe, wo: vec3f, wi: vec3f, radius: f32, reflectance: vec3f) -> vec3f {
    let brdf = lobe_glint_lobe_brdf(lobe, wo, wi, radius);
    return lobe_shade_colour(lobe_shape(lobe_glint_lobe_lobe(lobe)), brdf, wi, reflectance);
}

// Rust: `GlintShading::evaluate_coloured`, with the hue wheel and the reflectance at `lobe_half_cosine`. 0 for NaN.
fn lobe_glint_evaluate_coloured(
    lobe: LobeGlintLobe, wo: vec3f, wi: vec3f, radius: f32, reflectance: vec3f
) -> vec3f {
    let shape = lobe_shape(lobe_glint_lobe_lobe(lobe));
    let colour = lobe_shade_colour(shape, lobe_beckmann_brdf(lobe_tilted_pair(shape, wo, wi)), wi, reflectance);
    if !(colour.x > 0.0 || colour.y > 0.0 || colour.z > 0.0) {
        return colour;
    }
    let sparkle =
        lobe_glint_lobe_coloured_sparkle(lobe, lobe_half_vector(wo, wi), lobe_light_blur(wo, wi, radius));
    return vec3f(
        lobe_below_infinity(lobe_defined(colour.x * sparkle.x)), lobe_below_infinity(lobe_defined(colour.y * sparkle.y)),
        lobe_below_infinity(lobe_defined(colour.z * sparkle.z))
    );
}
