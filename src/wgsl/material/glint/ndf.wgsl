// What a pixel sees of a glittering material: its smooth lobe, and where its cells lie. Rust:
// src/material/glint/ndf.rs.

// Rust: `GlintNdf`.
struct LobeGlintNdf {
    mean: vec2f,
    biscale: LobeBiscale,
    global: LobeRoughness,
    grid: LobeGrid,
    density: f32,
    variation: f32,
    share: f32,
    groove: u32,
}

// Rust: `Glints::ndf`, then `GlintNdf::new`.
fn lobe_glints_ndf(glints: LobeGlints, pixel: LobePatch) -> LobeGlintNdf {
    let grid = lobe_grid_stretched(pixel, glints.stretch, lobe_glints_detail_size(glints));
    let seeded = LobeGrid(grid.pixel, grid.width, grid.exponent, grid.coarser, glints.seed);
    return LobeGlintNdf(
        vec2f(0.0, 0.0), glints.biscale, lobe_biscale_global(glints.biscale), seeded,
        glints.density, glints.variation,
        glints.share, glints.groove
    );
}

// Rust: `GlintNdf::over`.
fn lobe_glint_ndf_over(lobe: LobeGlintNdf, moments: LobeSlopeMoments) -> LobeGlintNdf {
    let biscale = lobe_biscale_over(lobe.biscale, moments);
    return LobeGlintNdf(
        lobe.mean + moments.mean, biscale, lobe_biscale_global(biscale), lobe.grid, lobe.density,
        lobe.variation, lobe.share,
        lobe.groove
    );
}

// Rust: `GlintNdf::widened`.
fn lobe_glint_ndf_widened(lobe: LobeGlintNdf, kernel: LobeKernel) -> LobeGlintNdf {
    let biscale = lobe_biscale_widened(lobe.biscale, kernel);
    return LobeGlintNdf(
        lobe.mean, biscale, lobe_biscale_global(biscale), lobe.grid, lobe.density, lobe.variation,
        lobe.share,
        lobe.groove
    );
}

// Rust: `GlintNdf::smooth_lobe`.
fn lobe_glint_ndf_smooth_lobe(lobe: LobeGlintNdf) -> LobeLobe {
    return LobeLobe(lobe.mean, lobe.global);
}
