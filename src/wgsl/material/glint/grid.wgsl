// Which cells a pixel covers, on two nested grids, and how much of each. Rust:
// src/material/glint/grid.rs.

// Rust: `RAMP`.
const LOBE_GRID_RAMP: f32 = 0.5;
// Rust: `EVEN`.
const LOBE_GRID_EVEN: f32 = 0.03;

// Rust: `Grid`.
struct LobeGrid {
    pixel: LobePatch,
    width: f32,
    exponent: i32,
    coarser: f32,
    seed: u32,
}

// Rust: `Grid::new`. NaN counts as 0, of coordinates as far away.
fn lobe_grid_new(pixel: LobePatch, least: f32) -> LobeGrid {
    return lobe_grid_stretched(pixel, vec2f(1.0, 1.0), least);
}

// Rust: `Grid::stretched`. NaN counts as 0, of coordinates as far away.
fn lobe_grid_stretched(pixel: LobePatch, factors: vec2f, least: f32) -> LobeGrid {
    let extents = lobe_patch_extents(pixel);
    let anisotropic = lobe_max(extents.x, extents.y) / f32(LOBE_ANISOTROPY_LIMIT);
    let is_rounded = (pixel.tile.x != 0 || pixel.tile.y != 0)
        && (factors.x != 1.0 || factors.y != 1.0);
    let distance = lobe_max(lobe_patch_distance(pixel), select(0.0, 2.0, is_rounded));
    let farthest = distance * lobe_power_of_two(-LOBE_LEVEL_FARTHEST);
    let size = lobe_max(lobe_max(lobe_max(lobe_patch_width(pixel), anisotropic), least), farthest);
    let stretched = lobe_patch_stretched(pixel, factors);
    return lobe_grid_of_size(stretched, lobe_patch_width(stretched), size);
}

// Rust: `Grid::of_size`. The last number is ln(2), as `Real::ln` has it.
fn lobe_grid_of_size(pixel: LobePatch, width: f32, size: f32) -> LobeGrid {
    let least = lobe_max(size, lobe_tile_finest(pixel.tile));
    let bounded = lobe_min(lobe_max(least, lobe_power_of_two(-100)), lobe_power_of_two(100));
    let exponent = lobe_exponent(bounded);
    let mantissa = bounded * lobe_power_of_two(-exponent);
    return LobeGrid(
        pixel, width, exponent, lobe_min(lobe_max(lobe_ln(mantissa) / 0.6931472, 0.0), 1.0), 0u
    );
}

// Rust: `Grid::presence`.
fn lobe_grid_presence(progress: f32, cell: LobeCell, coarser: bool) -> f32 {
    let passed = (progress * (1.0 + LOBE_GRID_RAMP) - lobe_cell_turn(cell))
        * (1.0 / LOBE_GRID_RAMP);
    let come = LOBE_GRID_EVEN * progress
        + (1.0 - LOBE_GRID_EVEN) * lobe_min(lobe_max(passed, 0.0), 1.0);
    return select(1.0 - come, come, coarser);
}

// Rust: `Grid::levels`: the finer one, or the coarser one.
fn lobe_grid_level(grid: LobeGrid, coarser: bool) -> LobeLevel {
    return lobe_level_new(grid.pixel, grid.width, grid.exponent + select(0, 1, coarser));
}
