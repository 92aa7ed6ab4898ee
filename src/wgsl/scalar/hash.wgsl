// Four words from four words, by integer arithmetic alone: the same bits on every machine. Rust:
// src/scalar/hash.rs.

// Rust: `hash`.
fn lobe_hash(key: vec4u) -> vec4u {
    let stepped = key * 1664525u + vec4u(1013904223u);
    let once = lobe_hash_round(stepped);
    return lobe_hash_round(once ^ (once >> vec4u(16u)));
}

// WGSL only: of `hash`, which has it as a closure.
fn lobe_hash_round(words: vec4u) -> vec4u {
    let x = words.x + words.y * words.w;
    let y = words.y + words.z * x;
    let z = words.z + x * y;
    return vec4u(x, y, z, words.w + y * z);
}

// Rust: `uniform`. Integers below 2^24 are floats, whatever the driver's rounding.
fn lobe_hash_uniform(word: u32) -> f32 {
    return f32(word >> 8u) * 5.9604645e-8;
}

// Rust: `tail`.
fn lobe_hash_tail(word: u32) -> f32 {
    let small = word < 0x00800000u;
    return (f32(select(word >> 9u, word, small)) + 0.5)
        * select(1.1920929e-7, 2.3283064e-10, small);
}
