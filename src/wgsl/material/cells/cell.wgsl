// A cell of the nested grids: the same numbers wherever the same place is a center again. Rust:
// src/material/cells/cell.rs.

// Rust: `COLOR`.
const LOBE_CELL_COLOR: u32 = 2654435769u;
// Rust: `FAR`.
const LOBE_CELL_FAR = vec2u(3242174889u, 2447445413u);

// Rust: `Cell`.
struct LobeCell {
    words: vec4u,
}

// Rust: `Cell::at`, of indices of 32 bits.
fn lobe_cell_at(index: vec2i, exponent: i32, seed: u32) -> LobeCell {
    return lobe_cell_at_wide(lobe_cell_index(vec2u(0u, 0u), vec2u(0u, 0u), index), exponent, seed);
}

// Rust: `Cell::at`, of indices of 64 bits: lower and upper word along u, lower and upper word along
// v.
fn lobe_cell_at_wide(index: vec4u, exponent: i32, seed: u32) -> LobeCell {
    let bounded = select(select(exponent, -300, exponent < -300), 300, exponent > 300);
    let u = lobe_cell_center(index.xy, bounded);
    let v = lobe_cell_center(index.zw, bounded);
    let exponents = (u32(u.exponent) & 0xffffu) | (u32(v.exponent) << 16u);
    let far = u.more * LOBE_CELL_FAR.x + v.more * LOBE_CELL_FAR.y;
    return LobeCell(lobe_hash(vec4u(u.odd, v.odd, exponents, seed + far)));
}

// Rust: `Cell::jitter`.
fn lobe_cell_jitter(cell: LobeCell) -> vec2f {
    return vec2f(lobe_hash_uniform(cell.words.x), lobe_hash_uniform(cell.words.y));
}

// Rust: `Cell::size`.
fn lobe_cell_size(cell: LobeCell) -> f32 {
    return lobe_hash_tail(cell.words.z);
}

// Rust: `Cell::turn`.
fn lobe_cell_turn(cell: LobeCell) -> f32 {
    return lobe_hash_uniform(cell.words.w);
}

// Rust: `Cell::hue`.
fn lobe_cell_hue(cell: LobeCell) -> f32 {
    return lobe_hash_uniform(lobe_hash(vec4u(cell.words.xy, LOBE_CELL_COLOR, LOBE_CELL_COLOR)).w);
}

// Rust: `Cell::count`.
fn lobe_cell_count(cell: LobeCell, bin: vec2i) -> f32 {
    return lobe_hash_tail(lobe_hash(vec4u(cell.words.x, cell.words.y, u32(bin.x), u32(bin.y))).w);
}

// WGSL only: 64 bits are two words here. Indices counted from a corner.
fn lobe_cell_index(corner_u: vec2u, corner_v: vec2u, index: vec2i) -> vec4u {
    return vec4u(lobe_cell_sum(corner_u, index.x), lobe_cell_sum(corner_v, index.y));
}

// WGSL only: 64 bits are two words here.
fn lobe_cell_sum(corner: vec2u, index: i32) -> vec2u {
    let low = corner.x + u32(index);
    return vec2u(low, corner.y + u32(index >> 31u) + select(0u, 1u, low < corner.x));
}

// Rust: `Center`.
struct LobeCellCenter {
    odd: u32,
    more: u32,
    exponent: i32,
}

// WGSL only: the place of the lowest bit of a word that is not 0. WebGL 2 counts no bits: the
// lowest bit alone is a power of two, whose exponent an f32 has.
fn lobe_cell_lowest_bit(word: u32) -> u32 {
    return (bitcast<u32>(f32(word & (~word + 1u))) >> 23u) - 127u;
}

// Rust: `Center::of`, of the lower word and the upper one.
fn lobe_cell_center(index: vec2u, exponent: i32) -> LobeCellCenter {
    if index.x == 0u && index.y == 0u {
        return LobeCellCenter(0u, 0u, -16384);
    }
    let low = i32(index.x);
    if u32(low >> 31u) == index.y {
        let few = lobe_cell_lowest_bit(index.x);
        return LobeCellCenter(u32(low >> few), 0u, exponent + i32(few));
    }
    let sign = u32(i32(index.y) >> 31u);
    let even = index.x == 0u;
    let words = select(index, vec2u(index.y, sign), even);
    let zeros = lobe_cell_lowest_bit(words.x);
    let odd = (words.x >> zeros) | ((words.y << 1u) << (31u - zeros));
    let more = u32(i32(words.y) >> zeros) + (odd >> 31u);
    return LobeCellCenter(odd, more, exponent + i32(zeros) + select(0, 32, even));
}
