// Where the details of a surface point, and how rough each of them is. Rust:
// src/material/glint/biscale.rs.

// Rust: `Biscale`.
struct LobeBiscale {
    spread: LobeRoughness,
    local: LobeRoughness,
}

// Rust: `Biscale::from_fractions`. Alphas beyond [0, 1e9] count as the nearest, fractions beyond
// [0, 1] too, NaN as 0.
fn lobe_biscale_from_fractions(alphas: vec2f, fractions: vec2f) -> LobeBiscale {
    let a = lobe_magnitude(alphas.x);
    let b = lobe_magnitude(alphas.y);
    let f = lobe_min(lobe_max(fractions.x, 0.0), 1.0);
    let g = lobe_min(lobe_max(fractions.y, 0.0), 1.0);
    let local = lobe_psd_from_axes(a * f, b * g, 1.0, 0.0);
    let spread = lobe_psd_from_axes(a * lobe_biscale_rest(f), b * lobe_biscale_rest(g), 1.0, 0.0);
    return LobeBiscale(LobeRoughness(spread), LobeRoughness(local));
}

// WGSL only: of `Biscale::from_fractions`, which has it as a closure.
fn lobe_biscale_rest(f: f32) -> f32 {
    return sqrt((1.0 - f) * (1.0 + f));
}

// Rust: `Biscale::global`.
fn lobe_biscale_global(biscale: LobeBiscale) -> LobeRoughness {
    return lobe_roughness_add(biscale.spread, biscale.local);
}

// Rust: `Biscale::widened`.
fn lobe_biscale_widened(biscale: LobeBiscale, kernel: LobeKernel) -> LobeBiscale {
    return LobeBiscale(biscale.spread, lobe_roughness_widened(biscale.local, kernel));
}

// Rust: `Biscale::over`.
fn lobe_biscale_over(biscale: LobeBiscale, moments: LobeSlopeMoments) -> LobeBiscale {
    let spread = lobe_roughness_add(
        biscale.spread, lobe_roughness_from_covariance(moments.covariance)
    );
    return LobeBiscale(spread, biscale.local);
}
