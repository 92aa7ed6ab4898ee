// One grid under a pixel: its columns of cells. Rust: src/material/glint/level.rs.

// Rust: `ANISOTROPY_LIMIT`.
const LOBE_ANISOTROPY_LIMIT: u32 = 16u;
// WGSL only: `COLUMNS`, an expression there.
const LOBE_LEVEL_COLUMNS: u32 = 34u;
// Rust: `FARTHEST`.
const LOBE_LEVEL_FARTHEST: i32 = 20;

// Rust: `CoveredCell`. The index has words as `lobe_cell_at_wide` takes them.
struct LobeCoveredCell {
    index: vec4u,
    exponent: i32,
    share: f32,
}

// Rust: `Level`.
struct LobeLevel {
    exponent: i32,
    corner_u: vec2u,
    corner_v: vec2u,
    along_v: bool,
    first: i32,
    count: u32,
    begin: f32,
    end: f32,
    midpoint: vec2f,
    skew: f32,
    share: f32,
}

// Rust: `Column`.
struct LobeColumn {
    first: i32,
    shares: vec2f,
}

// Rust: `Level::new`.
fn lobe_level_new(pixel: LobePatch, width: f32, exponent: i32) -> LobeLevel {
    let extents = lobe_patch_extents(pixel);
    let along_v = extents.y > extents.x;
    let inverse = lobe_power_of_two(-exponent);
    let limit = lobe_power_of_two(LOBE_LEVEL_FARTHEST + 1);
    let x = lobe_min(lobe_max(lobe_tile_place(pixel.tile.x, pixel.uv.x, exponent), -limit), limit);
    let y = lobe_min(lobe_max(lobe_tile_place(pixel.tile.y, pixel.uv.y, exponent), -limit), limit);
    let midpoint = select(vec2f(x, y), vec2f(y, x), along_v);
    let right = select(pixel.right, pixel.right.yx, along_v) * inverse;
    let up = select(pixel.up, pixel.up.yx, along_v) * inverse;
    // 0 where the pixel is too small for squares: no cell looks at it there.
    let skew = (right.x * right.y + up.x * up.y)
        / lobe_max(right.x * right.x + up.x * up.x, LOBE_MIN_POSITIVE);
    let most = f32(2u * LOBE_ANISOTROPY_LIMIT);
    let long = lobe_min(lobe_max(abs(right.x), lobe_max(abs(up.x), 0.0)), most);
    let half = 0.5 * lobe_max(long - lobe_max(width * inverse, 1.0), 0.0);
    let begin = midpoint.x - half;
    let end = midpoint.x + half;
    let first = lobe_floor(begin);
    let count = u32(lobe_floor(end) - first) + 2u;
    return LobeLevel(
        exponent, lobe_tile_corner(pixel.tile.x, exponent),
        lobe_tile_corner(pixel.tile.y, exponent), along_v, first,
        select(count, LOBE_LEVEL_COLUMNS, count > LOBE_LEVEL_COLUMNS), begin, end, midpoint,
        lobe_min(lobe_max(skew, -1.0), 1.0), 1.0 / (1.0 + (end - begin))
    );
}

// Rust: `Level::column`.
fn lobe_level_column(level: LobeLevel, n: u32) -> LobeColumn {
    let place = lobe_min(lobe_max(lobe_level_place(level, n), level.begin), level.end);
    return lobe_level_column_at(
        level, n, level.midpoint.y + level.skew * (place - level.midpoint.x)
    );
}

// Rust: `Level::place`.
fn lobe_level_place(level: LobeLevel, n: u32) -> f32 {
    return f32(level.first + i32(n));
}

// Rust: `Level::column_at`.
fn lobe_level_column_at(level: LobeLevel, n: u32, y: f32) -> LobeColumn {
    let at = lobe_level_place(level, n);
    let left = lobe_max(1.0 - lobe_max(level.begin - at, 0.0), 0.0);
    let right = lobe_max(1.0 - lobe_max(at - level.end, 0.0), 0.0);
    let first = lobe_floor(y);
    let part = y - f32(first);
    let share = level.share * left * right;
    return LobeColumn(first, vec2f(share * (1.0 - part), share * part));
}

// Rust: `Level::index`.
fn lobe_level_index(level: LobeLevel, n: u32, row: i32) -> vec4u {
    let column = level.first + i32(n);
    return lobe_cell_index(
        level.corner_u, level.corner_v,
        select(vec2i(column, row), vec2i(row, column), level.along_v)
    );
}

// WGSL only: of `Grid::walk`: one of the two cells of a column.
fn lobe_level_covered(level: LobeLevel, column: LobeColumn, n: u32, row: i32) -> LobeCoveredCell {
    let share = select(column.shares.x, column.shares.y, row == 1);
    return LobeCoveredCell(lobe_level_index(level, n, column.first + row), level.exponent, share);
}
