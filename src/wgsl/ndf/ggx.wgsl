// GGX: what it owes as a distribution, and what follows. Rust: src/ndf/ggx.rs, distribution.rs and
// masking.rs.

// Rust: `GgxDistribution::density`. 0 for NaN.
fn lobe_ggx_density(
    form: f32, extent: LobeExtent, z: f32, length_squared: f32, weight: f32
) -> f32 {
    let ratio = (extent.scale * length_squared) / (extent.unit * (z * z) + form);
    return lobe_defined((extent.root_det * ratio) * ratio * weight);
}

// Rust: `GgxDistribution::excess`. 0 for NaN.
fn lobe_ggx_excess(c: f32, stretch_squared: f32) -> f32 {
    return lobe_defined(
        stretch_squared / lobe_max(2.0 * (sqrt(c * c + stretch_squared) + c), LOBE_MIN_POSITIVE)
    );
}

// Rust: `GgxDistribution::even_area`. 0 for NaN.
fn lobe_ggx_even_area(c: f32, stretch_squared: f32) -> f32 {
    return lobe_defined(sqrt(c * c + stretch_squared));
}

// Rust: `Ndf::slope_pdf`, of a shape's answers at (-slope, 1).
fn lobe_ggx_slope_pdf(at: LobeNormal) -> f32 {
    return lobe_ggx_d(at);
}

// Rust: `Ndf::d`, of a shape's answers at a normal.
fn lobe_ggx_d(at: LobeNormal) -> f32 {
    return lobe_density_at(lobe_ggx_density(at.form, at.extent, at.z, 1.0, LOBE_INVERSE_PI), at);
}

// Rust: `Ndf::brdf`, of a shape's answers at a pair of directions.
fn lobe_ggx_brdf(at: LobePair) -> f32 {
    let weight = lobe_brdf_weight(lobe_ggx_visibility_terms(at.wo, at.wi));
    return lobe_brdf_at(
        lobe_ggx_density(at.form, at.extent, at.z, at.length_squared, weight), at
    );
}

// Rust: `Ndf::unshadowed_brdf_cos`, of a shape's answers at a pair of directions. 0 for NaN.
fn lobe_ggx_unshadowed_brdf_cos(at: LobePair) -> f32 {
    let area = lobe_ggx_projected_area(at.wo);
    let weight = 0.25 * LOBE_INVERSE_PI / area;
    return lobe_unshadowed_at(
        lobe_ggx_density(at.form, at.extent, at.z, at.length_squared, weight), area, at
    );
}

// Rust: `Ndf::projected_area`, of a shape's answers at a direction. 0 for NaN.
fn lobe_ggx_projected_area(at: LobeView) -> f32 {
    return lobe_projected_area_of(
        at.mean_area, lobe_ggx_excess(abs(at.mean_area), at.stretch_squared)
    );
}

// Rust: `Ndf::lambda`. The largest number from below, and for NaN.
fn lobe_ggx_lambda(at: LobeView) -> f32 {
    return lobe_lambda_of(at.mean_area, lobe_ggx_excess(abs(at.mean_area), at.stretch_squared));
}

// Rust: `Ndf::g1`. 0 for NaN.
fn lobe_ggx_masking(at: LobeView) -> f32 {
    let c = lobe_max(at.mean_area, 0.0);
    return lobe_masking_of(c, lobe_ggx_excess(c, at.stretch_squared));
}

// Rust: `Ndf::g2`. 0 for NaN.
fn lobe_ggx_masking_shadowing(wo: LobeView, wi: LobeView) -> f32 {
    return lobe_masking_shadowing_of(wo, wi, lobe_ggx_visibility_terms(wo, wi));
}

// Rust: `Ndf::visibility`. 0 for NaN.
fn lobe_ggx_visibility(wo: LobeView, wi: LobeView) -> f32 {
    return lobe_visibility_of(wo, wi, lobe_ggx_visibility_terms(wo, wi));
}

// Rust: `Ndf::visibility_terms`: the sum.
fn lobe_ggx_visibility_terms(wo: LobeView, wi: LobeView) -> f32 {
    let even_o = lobe_ggx_even_area(wo.mean_area, wo.stretch_squared);
    return lobe_visibility_terms(
        wo, even_o, wi, lobe_ggx_even_area(wi.mean_area, wi.stretch_squared)
    );
}
