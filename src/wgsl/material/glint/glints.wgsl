// A glittering material: details of two scales, and how many there are. Rust:
// src/material/glint/glints.rs.

// WGSL only: `Groove` as a number.
const LOBE_GROOVE_NONE: u32 = 0u;
// WGSL only: `Groove` as a number.
const LOBE_GROOVE_ALONG_U: u32 = 1u;
// WGSL only: `Groove` as a number.
const LOBE_GROOVE_ALONG_V: u32 = 2u;

// Rust: `Glints`. The variation lies in [0, 4], the share in [0, 1]; the seed may be any.
struct LobeGlints {
    biscale: LobeBiscale,
    density: f32,
    variation: f32,
    share: f32,
    stretch: vec2f,
    groove: u32,
    seed: u32,
}

// Rust: `Glints::new`. A density beyond [1e-18, 1e18] counts as the nearest, NaN as the smallest.
fn lobe_glints_new(biscale: LobeBiscale, density: f32) -> LobeGlints {
    let number = lobe_min(lobe_max(density, 1e-18), 1e18);
    let spread = lobe_psd_entries(biscale.spread.psd);
    let stretch = vec2f(
        lobe_glints_ratio(spread.x, spread.z), lobe_glints_ratio(spread.z, spread.x)
    );
    let groove = select(
        select(LOBE_GROOVE_NONE, LOBE_GROOVE_ALONG_V, stretch.y == 0.0), LOBE_GROOVE_ALONG_U,
        stretch.x == 0.0
    );
    return LobeGlints(biscale, number, 0.0, 1.0, stretch, groove, 0u);
}

// WGSL only: of `Glints::new`, which has it as a closure.
fn lobe_glints_ratio(a: f32, b: f32) -> f32 {
    return select(1.0, sqrt(a / b), a < b);
}

// Rust: `Glints::detail_size`.
fn lobe_glints_detail_size(glints: LobeGlints) -> f32 {
    return lobe_power_of_two(lobe_exponent(sqrt(2.0) / sqrt(glints.density)));
}
