// A cell of the nested grids: the same numbers wherever the same place is a centre again. Rust: src/material/glint/cell.rs.

// Rust: `COLOUR`.
const LOBE_CELL_COLOUR: u32 = 2654435769u;

// Rust: `Cell`.
struct LobeCell {
    words: vec4u,
}

// Rust: `Cell::at`.
fn lobe_cell_at(index: vec2i, exponent: i32, seed: u32) -> LobeCell {
    let bounded = select(select(exponent, -300, exponent < -300), 300, exponent > 300);
    let u = lobe_cell_canonical(index.x, bounded);
    let v = lobe_cell_canonical(index.y, bounded);
    let exponents = (u32(u.y) & 0xffffu) | (u32(v.y) << 16u);
    return LobeCell(lobe_hash(vec4u(u32(u.x), u32(v.x), exponents, seed)));
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
    return lobe_hash_uniform(lobe_hash(vec4u(cell.words.xy, LOBE_CELL_COLOUR, LOBE_CELL_COLOUR)).w);
}

// Rust: `Cell::count`.
fn lobe_cell_count(cell: LobeCell, bin: vec2i) -> f32 {
    return lobe_hash_tail(lobe_hash(vec4u(cell.words.x, cell.words.y, u32(bin.x), u32(bin.y))).w);
}

// Rust: `canonical`: the odd number, and the exponent.
fn lobe_cell_canonical(index: i32, exponent: i32) -> vec2i {
    if index == 0 {
        return vec2i(0, -16384);
    }
    // WebGL 2 counts no bits. The lowest one alone is a power of two, and f32 has its exponent.
    let word = u32(index);
    let lowest = f32(word & (~word + 1u));
    let zeros = i32(bitcast<u32>(lowest) >> 23u) - 127;
    return vec2i(index >> u32(zeros), exponent + zeros);
}
