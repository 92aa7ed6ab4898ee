// Which cells of a level an elliptic pixel covers, and how much of each. Rust:
// src/material/multilobe/ellipse.rs.

// Rust: `ELLIPSE_LIMIT`.
const LOBE_ELLIPSE_LIMIT: u32 = 8u;
// Rust: `ROWS`.
const LOBE_ELLIPSE_ROWS: i32 = 34;
// Rust: `RIM`.
const LOBE_ELLIPSE_RIM: f32 = 0.13533528;

// Rust: `Ellipse`.
struct LobeEllipse {
    tile: vec2i,
    uv: vec2f,
    square: LobePsd,
    width: f32,
}

// Rust: `Rows`.
struct LobeEllipseRows {
    corner_u: vec2u,
    corner_v: vec2u,
    midpoint: vec2f,
    square: LobePsd,
    first: i32,
    last: i32,
}

// Rust: `Row`.
struct LobeEllipseRow {
    first: i32,
    last: i32,
    middle: f32,
    scale: f32,
    rest: f32,
}

// Rust: `Ellipse::of`. NaN counts as 0.
fn lobe_ellipse_of(pixel: LobePatch) -> LobeEllipse {
    let square = lobe_psd_outer_sum(
        lobe_both_within(pixel.right, LOBE_LARGEST), lobe_both_within(pixel.up, LOBE_LARGEST)
    );
    let eigen = lobe_psd_eigen(square);
    let limit = f32(LOBE_ELLIPSE_LIMIT * LOBE_ELLIPSE_LIMIT);
    let least = eigen.major / limit;
    let width = sqrt(lobe_max(eigen.minor, least));
    let uv = lobe_both_within(pixel.uv, LOBE_LARGEST);
    if eigen.minor < least {
        let missing = sqrt(least - eigen.minor);
        let x = eigen.axis.x * missing;
        let y = eigen.axis.y * missing;
        let root_det = eigen.major / f32(LOBE_ELLIPSE_LIMIT);
        let entries = lobe_psd_entries(square);
        let wide = lobe_psd_with_root_det(
            vec3f(entries.x + y * y, entries.y - x * y, entries.z + x * x), root_det
        );
        return LobeEllipse(pixel.tile, uv, wide, width);
    }
    return LobeEllipse(pixel.tile, uv, square, width);
}

// Rust: `Ellipse::rows`.
fn lobe_ellipse_rows(ellipse: LobeEllipse, exponent: i32) -> LobeEllipseRows {
    let inverse = lobe_power_of_two(-exponent);
    let midpoint = vec2f(
        lobe_ellipse_bounded(lobe_tile_place(ellipse.tile.x, ellipse.uv.x, exponent)) - 0.5,
        lobe_ellipse_bounded(lobe_tile_place(ellipse.tile.y, ellipse.uv.y, exponent)) - 0.5
    );
    let square =
        lobe_psd_add(lobe_psd_mul(ellipse.square, inverse * inverse), LobePsd(1.0, 0.0, 1.0));
    let ends = lobe_ellipse_between(midpoint.y, sqrt(lobe_psd_entries(square).z));
    return LobeEllipseRows(
        lobe_tile_corner(ellipse.tile.x, exponent), lobe_tile_corner(ellipse.tile.y, exponent),
        midpoint, square, ends.x,
        ends.y
    );
}

// WGSL only: of `Ellipse::rows`, which has it as a closure. NaN counts as the smallest.
fn lobe_ellipse_bounded(x: f32) -> f32 {
    let limit = lobe_power_of_two(21);
    return lobe_min(lobe_max(x, -limit), limit);
}

// Rust: `between`.
fn lobe_ellipse_between(midpoint: f32, reach: f32) -> vec2i {
    let first = -lobe_floor(reach - midpoint);
    let last = lobe_floor(midpoint + reach);
    let most = first + LOBE_ELLIPSE_ROWS - 1;
    return vec2i(first, select(most, last, last < most));
}

// Rust: `Rows::row`.
fn lobe_ellipse_row(rows: LobeEllipseRows, t: i32) -> LobeEllipseRow {
    let psd = lobe_psd_entries(rows.square);
    let root_det = lobe_psd_root_det(rows.square);
    let offset = f32(t) - rows.midpoint.y;
    let rest = lobe_max(1.0 - offset * offset / psd.z, 0.0);
    let middle = rows.midpoint.x + psd.y / psd.z * offset;
    let square = root_det * (root_det / psd.z);
    let ends = lobe_ellipse_between(middle, sqrt(square * rest));
    return LobeEllipseRow(ends.x, ends.y, middle, 1.0 / square, rest);
}

// Rust: `Rows::index`.
fn lobe_ellipse_index(rows: LobeEllipseRows, s: i32, t: i32) -> vec4u {
    return lobe_cell_index(rows.corner_u, rows.corner_v, vec2i(s, t));
}

// Rust: `Row::weight`.
fn lobe_ellipse_weight(row: LobeEllipseRow, s: i32) -> f32 {
    let offset = f32(s) - row.middle;
    let inside = row.rest - offset * offset * row.scale;
    return lobe_max(LOBE_ELLIPSE_RIM * (lobe_exp(2.0 * inside) - 1.0), 0.0);
}
