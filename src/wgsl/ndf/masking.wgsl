// Masking of the numbers that a distribution has, the same for every one. Rust: src/ndf/masking.rs.

// WGSL only: `Ndf::projected_area` of a mean plane's area and the excess over it. 0 for NaN.
fn lobe_projected_area_of(c: f32, excess: f32) -> f32 {
    return lobe_defined(lobe_max(c, 0.0) + excess);
}

// WGSL only: `Ndf::lambda` of the same. The largest number from below, and for NaN.
fn lobe_lambda_of(c: f32, excess: f32) -> f32 {
    let ratio = lobe_defined(excess / lobe_max(c, LOBE_MIN_POSITIVE));
    return select(LOBE_MAX, lobe_below_infinity(ratio), c > 0.0);
}

// WGSL only: `Ndf::g1` of the same. 0 for NaN.
fn lobe_masking_of(c: f32, excess: f32) -> f32 {
    return lobe_max(c / lobe_max(c + excess, LOBE_MIN_POSITIVE), 0.0);
}

// WGSL only: `Ndf::visibility_terms`: the sum, of two directions' even areas.
fn lobe_visibility_terms(wo: LobeView, even_o: f32, wi: LobeView, even_i: f32) -> f32 {
    return even_o * wi.mean_area + even_i * wo.mean_area;
}

// WGSL only: `Ndf::g2` of the sum. 0 for NaN.
fn lobe_masking_shadowing_of(wo: LobeView, wi: LobeView, sum: f32) -> f32 {
    let ratio = lobe_min(2.0 * wo.mean_area * wi.mean_area / lobe_max(sum, LOBE_MIN_POSITIVE), 1.0);
    return select(0.0, lobe_defined(ratio), lobe_min(wo.mean_area, wi.mean_area) > 0.0);
}

// WGSL only: `Ndf::visibility` of the sum. 0 for NaN.
fn lobe_visibility_of(wo: LobeView, wi: LobeView, sum: f32) -> f32 {
    return select(
        0.0, 0.5 / lobe_max(sum, LOBE_MIN_POSITIVE), lobe_min(wo.mean_area, wi.mean_area) > 0.0
    );
}

// WGSL only: what `Ndf::brdf` multiplies the density by, of the sum.
fn lobe_brdf_weight(sum: f32) -> f32 {
    return 0.5 * LOBE_INVERSE_PI / sum;
}
