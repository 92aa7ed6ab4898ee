// What is the same for every distribution. Rust: src/ndf/distribution.rs.

// Rust: `inverse_pi`.
const LOBE_INVERSE_PI: f32 = 0.3183098861837907;

// WGSL only: the end of `Ndf::d`: 0 below the horizon, else finite and not negative.
fn lobe_density_at(density: f32, at: LobeNormal) -> f32 {
    return select(0.0, lobe_below_infinity(lobe_max(density, 0.0)), at.z > 0.0);
}

// WGSL only: the end of `Ndf::brdf`: 0 where a direction or the half vector is below, else finite
// and not negative.
fn lobe_brdf_at(brdf: f32, at: LobePair) -> f32 {
    return select(0.0, lobe_below_infinity(lobe_max(brdf, 0.0)), at.lowest > 0.0);
}

// WGSL only: the end of `Ndf::unshadowed_brdf_cos`: 0 where nothing is seen or the half vector is
// below.
fn lobe_unshadowed_at(value: f32, area: f32, at: LobePair) -> f32 {
    return select(0.0, lobe_below_infinity(lobe_max(value, 0.0)), lobe_min(area, at.z) > 0.0);
}
