// Beckmann: what it owes as a distribution, and what follows. Rust: src/ndf/beckmann.rs,
// distribution.rs and masking.rs.

// Rust: `BeckmannDistribution::density`. 0 for NaN.
fn lobe_beckmann_density(
    form: f32, extent: LobeExtent, z: f32, length_squared: f32, weight: f32
) -> f32 {
    // A mirror has nothing to divide by: four times the smallest number leaves length^2 over it
    // finite.
    let inverse = lobe_kept(1.0 / lobe_max(extent.unit * (z * z), 4.0 * LOBE_MIN_POSITIVE));
    // -log2(e)/2
    let e = lobe_exp2_of_negative(-0.72134752 * form * inverse);
    let ratio = lobe_kept(length_squared * inverse);
    let half = e * (extent.unit * ratio);
    let density = lobe_product_or_zero(half, e * lobe_kept(extent.scale * ratio) * weight);
    return select(0.0, lobe_defined(density), extent.root_det > 0.0);
}

// Rust: `BeckmannDistribution::excess`. 0 for NaN.
fn lobe_beckmann_excess(c: f32, stretch_squared: f32) -> f32 {
    let square = lobe_max(stretch_squared, LOBE_MIN_POSITIVE);
    let a = sqrt(square);
    return lobe_defined(0.5 * a * lobe_exp(-(c * c / square)) * lobe_ierfcx(c / a));
}

// Rust: `BeckmannDistribution::even_area`. 0 for NaN.
fn lobe_beckmann_even_area(c: f32, stretch_squared: f32) -> f32 {
    let c_squared = c * c;
    let excess = lobe_ierfc_excess(c_squared / lobe_max(stretch_squared, LOBE_MIN_POSITIVE));
    return lobe_defined(sqrt(c_squared + stretch_squared * excess));
}

// Rust: `Ndf::slope_pdf`, of a shape's answers at (-slope, 1).
fn lobe_beckmann_slope_pdf(at: LobeNormal) -> f32 {
    return lobe_beckmann_d(at);
}

// Rust: `Ndf::d`, of a shape's answers at a normal.
fn lobe_beckmann_d(at: LobeNormal) -> f32 {
    return lobe_density_at(
        lobe_beckmann_density(at.form, at.extent, at.z, 1.0, LOBE_INVERSE_PI), at
    );
}

// Rust: `Ndf::brdf`, of a shape's answers at a pair of directions.
fn lobe_beckmann_brdf(at: LobePair) -> f32 {
    let weight = lobe_brdf_weight(lobe_beckmann_visibility_terms(at.wo, at.wi));
    return lobe_brdf_at(
        lobe_beckmann_density(at.form, at.extent, at.z, at.length_squared, weight), at
    );
}

// Rust: `Ndf::unshadowed_brdf_cos`, of a shape's answers at a pair of directions. 0 for NaN.
fn lobe_beckmann_unshadowed_brdf_cos(at: LobePair) -> f32 {
    let area = lobe_beckmann_projected_area(at.wo);
    let weight = 0.25 * LOBE_INVERSE_PI / area;
    return lobe_unshadowed_at(
        lobe_beckmann_density(at.form, at.extent, at.z, at.length_squared, weight), area, at
    );
}

// Rust: `Ndf::projected_area`, of a shape's answers at a direction. 0 for NaN.
fn lobe_beckmann_projected_area(at: LobeView) -> f32 {
    return lobe_projected_area_of(
        at.mean_area, lobe_beckmann_excess(abs(at.mean_area), at.stretch_squared)
    );
}

// Rust: `Ndf::lambda`. The largest number from below, and for NaN.
fn lobe_beckmann_lambda(at: LobeView) -> f32 {
    return lobe_lambda_of(
        at.mean_area, lobe_beckmann_excess(abs(at.mean_area), at.stretch_squared)
    );
}

// Rust: `Ndf::g1`. 0 for NaN.
fn lobe_beckmann_masking(at: LobeView) -> f32 {
    let c = lobe_max(at.mean_area, 0.0);
    return lobe_masking_of(c, lobe_beckmann_excess(c, at.stretch_squared));
}

// Rust: `Ndf::g2`. 0 for NaN.
fn lobe_beckmann_masking_shadowing(wo: LobeView, wi: LobeView) -> f32 {
    return lobe_masking_shadowing_of(wo, wi, lobe_beckmann_visibility_terms(wo, wi));
}

// Rust: `Ndf::visibility`. 0 for NaN.
fn lobe_beckmann_visibility(wo: LobeView, wi: LobeView) -> f32 {
    return lobe_visibility_of(wo, wi, lobe_beckmann_visibility_terms(wo, wi));
}

// Rust: `Ndf::visibility_terms`: the sum.
fn lobe_beckmann_visibility_terms(wo: LobeView, wi: LobeView) -> f32 {
    let even_o = lobe_beckmann_even_area(wo.mean_area, wo.stretch_squared);
    return lobe_visibility_terms(
        wo, even_o, wi, lobe_beckmann_even_area(wi.mean_area, wi.stretch_squared)
    );
}

// Rust: `Ndf::lambda_walter`. The largest number from below, and for NaN.
fn lobe_beckmann_lambda_walter(at: LobeView) -> f32 {
    if !(at.mean_area > 0.0) {
        return LOBE_MAX;
    }
    let v = at.mean_area / sqrt(lobe_max(at.stretch_squared, LOBE_MIN_POSITIVE));
    if v >= 1.6 {
        return 0.0;
    }
    let numerator = 1.0 - 1.259 * v + 0.396 * v * v;
    let denominator = lobe_max(3.535 * v + 2.181 * v * v, LOBE_MIN_POSITIVE);
    return lobe_below_infinity(lobe_far(numerator / denominator));
}
