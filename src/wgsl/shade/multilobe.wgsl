// One call per light for many lobes: BRDF, reflectance and the light's cosine. Rust:
// src/shade/multilobe.rs.

// Rust: `MultiLobeShading::evaluate`, with the reflectance at `lobe_half_cosine`. 0 for NaN.
fn lobe_multi_lobe_shading_evaluate(
    lobe: LobePatchNdf, frame: LobeMeanFrame, wo: vec3f, wi: vec3f, reflectance: vec3f
) -> vec3f {
    let local = lobe_mean_frame_to_local(frame, wi);
    let brdf = lobe_patch_ndf_brdf(lobe, lobe_mean_frame_to_local(frame, wo), local);
    return lobe_shade_color(brdf, local.z, reflectance);
}
