// Tiles: the whole part of a texture coordinate, of which cells are counted in integers. Rust:
// src/material/cells/tile.rs.

// Rust: `FINEST`.
const LOBE_TILE_FINEST: i32 = -31;

// Rust: `finest`.
fn lobe_tile_finest(tile: vec2i) -> f32 {
    return select(0.0, lobe_power_of_two(LOBE_TILE_FINEST), tile.x != 0 || tile.y != 0);
}

// Rust: `corner`: its lower word, and its upper one.
fn lobe_tile_corner(tile: i32, exponent: i32) -> vec2u {
    if exponent > 30 {
        return vec2u(0u, 0u);
    }
    if exponent > 0 {
        let whole = tile >> u32(exponent);
        return vec2u(u32(whole), u32(whole >> 31u));
    }
    let shift = select(u32(-exponent), u32(-LOBE_TILE_FINEST), exponent < LOBE_TILE_FINEST);
    return vec2u(u32(tile) << shift, u32((tile >> 1u) >> (31u - shift)));
}

// Rust: `place`.
fn lobe_tile_place(tile: i32, fraction: f32, exponent: i32) -> f32 {
    var whole = 0;
    if exponent > 30 {
        whole = tile;
    } else if exponent > 0 {
        whole = tile & ((1 << u32(exponent)) - 1);
    }
    let from_corner = select(lobe_tile_number(whole) + fraction, fraction, whole == 0);
    return from_corner * lobe_power_of_two(-exponent);
}

// WGSL only: what `compressed` returns as a pair.
struct LobeTilePlace {
    tile: i32,
    fraction: f32,
}

// Rust: `compressed`.
fn lobe_tile_compressed(tile: i32, fraction: f32, factor: f32) -> LobeTilePlace {
    let unit = lobe_power_of_two(16);
    let upper = lobe_two_product(lobe_tile_number(tile >> 16u), factor);
    let lower = lobe_two_product(lobe_tile_number(tile & 0xffff), factor);
    let a = lobe_tile_split(upper.x);
    let b = lobe_tile_split(a.fraction * unit);
    let c = lobe_tile_split(upper.y * unit);
    let d = lobe_tile_split(lower.x);
    let e = lobe_tile_split((b.fraction + c.fraction) + (d.fraction + lower.y));
    let whole = (a.tile << 16u) + b.tile + c.tile + d.tile + e.tile;
    return LobeTilePlace(whole, e.fraction + fraction * factor);
}

// Rust: `split`.
fn lobe_tile_split(x: f32) -> LobeTilePlace {
    let size = lobe_floor(abs(x));
    let whole = select(size, -size, x < 0.0);
    return LobeTilePlace(whole, x - lobe_tile_number(whole));
}

// Rust: `number`. Each half converts exactly, and their sum is rounded once; drivers may round the
// conversion of a whole number of 32 bits as they like.
fn lobe_tile_number(whole: i32) -> f32 {
    return f32(whole >> 16u) * lobe_power_of_two(16) + f32(whole & 0xffff);
}
