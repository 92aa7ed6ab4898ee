// The cells that a pixel covers, on two levels, and what each of them has drawn. Rust:
// src/material/multilobe/cells.rs.

// WGSL only: `farthest` of single precision.
const LOBE_CELLS_FARTHEST: i32 = 20;
// Rust: `QUANTILE`.
const LOBE_CELLS_QUANTILE: f32 = 6.5;
// Rust: `HALF_TURN`.
const LOBE_CELLS_HALF_TURN = array<f32,
5>(0.7854006, 0.16136818, 0.040797774, 7.447305e-3, 4.9829185e-3);

// Rust: `Cells`.
struct LobeCells {
    ellipse: LobeEllipse,
    exponent: i32,
    coarser: f32,
    facets: f32,
    variation: f32,
    share: f32,
    seed: u32,
}

// Rust: `Facets`. A level of -1 is none, the smooth lobe.
struct LobeFacets {
    level: i32,
    turn: vec2f,
    marginals: vec2u,
}

// Rust: `Cells::new`, of the fields of a material, which no other file may import.
fn lobe_cells_new(
    ellipse: LobeEllipse, facet_size: f32, density: f32, variation: f32, share: f32, seed: u32
) -> LobeCells {
    let distance = lobe_max(abs(ellipse.uv.x), lobe_max(abs(ellipse.uv.y), 0.0));
    let farthest = distance * lobe_power_of_two(-LOBE_CELLS_FARTHEST);
    let resolved = lobe_max(lobe_max(ellipse.width, facet_size), farthest);
    let least = lobe_max(resolved, lobe_tile_finest(ellipse.tile));
    let size = lobe_min(lobe_max(least, lobe_power_of_two(-100)), lobe_power_of_two(100));
    let exponent = lobe_exponent(size);
    // The number is ln(2), as `Real::ln` has it.
    let coarser = lobe_ln(size * lobe_power_of_two(-exponent)) / 0.6931472;
    let number = 0.5 * lobe_ln(density) / 0.6931472 + f32(exponent);
    return LobeCells(
        ellipse, exponent, lobe_min(lobe_max(coarser, 0.0), 1.0), number, variation, share, seed
    );
}

// Rust: `Cells::are_smooth`.
fn lobe_cells_are_smooth(cells: LobeCells, levels: u32) -> bool {
    return cells.facets - LOBE_CELLS_QUANTILE * cells.variation > f32(levels);
}

// WGSL only: a place in the rows of a level's cells, which `Cells::level` visits in Rust.
struct LobeCellsWalk {
    rows: LobeEllipseRows,
    row: LobeEllipseRow,
    s: i32,
    t: i32,
}

// WGSL only: of `Cells::level`, its first cell.
fn lobe_cells_first(cells: LobeCells, step: i32) -> LobeCellsWalk {
    let rows = lobe_ellipse_rows(cells.ellipse, cells.exponent + step);
    let row = lobe_ellipse_row(rows, rows.first);
    return LobeCellsWalk(rows, row, row.first, rows.first);
}

// WGSL only: of `Cells::level`, the next one.
fn lobe_cells_next(walk: LobeCellsWalk) -> LobeCellsWalk {
    if walk.s < walk.row.last {
        return LobeCellsWalk(walk.rows, walk.row, walk.s + 1, walk.t);
    }
    let row = lobe_ellipse_row(walk.rows, walk.t + 1);
    return LobeCellsWalk(walk.rows, row, row.first, walk.t + 1);
}

// WGSL only: of `Cells::level`, whether there are more.
fn lobe_cells_more(walk: LobeCellsWalk) -> bool {
    return walk.t <= walk.rows.last;
}

// WGSL only: of `Cells::level`, a cell's weight; 0 of a row without cells.
fn lobe_cells_weight(walk: LobeCellsWalk) -> f32 {
    if walk.s > walk.row.last {
        return 0.0;
    }
    return lobe_ellipse_weight(walk.row, walk.s);
}

// WGSL only: of `Cells::level`, the cell.
fn lobe_cells_cell(cells: LobeCells, step: i32, walk: LobeCellsWalk) -> LobeCell {
    return lobe_cell_at_wide(
        lobe_ellipse_index(walk.rows, walk.s, walk.t), cells.exponent + step, cells.seed
    );
}

// Rust: `Cells::chosen`.
fn lobe_cells_chosen(cells: LobeCells, dictionary: LobeDictionary, u: f32) -> LobeFacets {
    var chosen = LobeCell(vec4u(0u, 0u, 0u, 0u));
    var chosen_step = -1;
    var sum = 0.0;
    for (var step = 0; step < 2; step++) {
        let level = select(1.0 - cells.coarser, cells.coarser, step == 1);
        if level > 0.0 {
            // Twice over the cells: for the sum of their weights, and with it for their shares.
            var whole = 0.0;
            for (
                var walk = lobe_cells_first(cells, step);
                lobe_cells_more(walk);
                walk = lobe_cells_next(walk)
            ) {
                whole = whole + lobe_cells_weight(walk);
            }
            let share = level / lobe_max(whole, LOBE_MIN_POSITIVE);
            for (
                var walk = lobe_cells_first(cells, step);
                lobe_cells_more(walk);
                walk = lobe_cells_next(walk)
            ) {
                let weight = lobe_cells_weight(walk);
                if weight > 0.0 && (chosen_step < 0 || sum <= u) {
                    chosen = lobe_cells_cell(cells, step, walk);
                    chosen_step = step;
                }
                sum = sum + share * weight;
            }
        }
    }
    return lobe_cells_numbers(cells, dictionary, chosen, chosen_step);
}

// Rust: `Cells::numbers`.
fn lobe_cells_numbers(
    cells: LobeCells, dictionary: LobeDictionary, cell: LobeCell, step: i32
) -> LobeFacets {
    let words = cell.words;
    let deviation = cells.variation * lobe_normal_quantile(lobe_hash_tail(words.y));
    let rounding = f32(words.z & 0xffu) * 0.00390625;
    let drawn = lobe_floor(cells.facets + f32(step) + deviation + rounding);
    let level = select(0, drawn, drawn > 0);
    if level >= i32(dictionary.levels) || lobe_hash_tail(words.x) > cells.share {
        return LobeFacets(-1, vec2f(0.0, 0.0), vec2u(0u, 0u));
    }
    let first = ((words.w >> 16u) * dictionary.marginals) >> 16u;
    let second = ((words.w & 0xffffu) * dictionary.marginals) >> 16u;
    return LobeFacets(level, lobe_cells_quarter_turn(words.z), vec2u(first, second));
}

// Rust: `quarter_turn`.
fn lobe_cells_quarter_turn(word: u32) -> vec2f {
    let u = lobe_hash_uniform(word);
    let v = u * u;
    let h = LOBE_CELLS_HALF_TURN;
    let t = ((((h[4] * v + h[3]) * v + h[2]) * v + h[1]) * v + h[0]) * u;
    let scale = 1.0 / (1.0 + t * t);
    return vec2f((1.0 - t * t) * scale, 2.0 * t * scale);
}
