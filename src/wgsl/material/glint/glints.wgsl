// A glittering material: details of two scales, and how many there are. Rust: src/material/glint/glints.rs.

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
    let spread = biscale.spread.psd;
    let stretch = vec2f(lobe_glints_ratio(spread.xx, spread.yy), lobe_glints_ratio(spread.yy, spread.xx));
    let groove = select(
        select(LOBE_GROOVE_NONE, LOBE_GROOVE_ALONG_V, stretch.y == 0.0), LOBE_GROOVE_ALONG_U, stretch.x == 0.0
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

// Rust: `Glints::lobe`, with what `GlintLobe::new` does there: no two files import from each other.
fn lobe_glints_lobe(glints: LobeGlints, pixel: LobePatch) -> LobeGlintLobe {
    let grid = lobe_grid_stretched(pixel, glints.stretch, lobe_glints_detail_size(glints));
    let seeded = LobeGrid(grid.pixel, grid.width, grid.exponent, grid.coarser, glints.seed);
    return LobeGlintLobe(
        vec2f(0.0, 0.0), glints.biscale, lobe_biscale_global(glints.biscale), seeded, glints.density, glints.variation,
        glints.share, glints.groove
    );
}
