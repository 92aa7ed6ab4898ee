// A dictionary of marginals: its buffer, and what it holds. Rust:
// src/material/multilobe/dictionary.rs.

// WGSL only: `Dictionary::nodes`, density and cumulative of each. Bound elsewhere: `rebound` of
// `lobe::wgsl`.
@group(1) @binding(0) var<storage, read> lobe_dictionary: array<vec2f>;

// WGSL only: one node of the dictionary. From a texture: `textured` of `lobe::wgsl`.
fn lobe_dictionary_node(place: u32) -> vec2f {
    return lobe_dictionary[place];
}

// Rust: `Dictionary`: the sizes of its `Recipe`, none of which is 0.
struct LobeDictionary {
    marginals: u32,
    levels: u32,
    intervals: u32,
}

// Rust: `Marginal`: where it begins in the buffer, and how many intervals it has.
struct LobeMarginal {
    begin: u32,
    intervals: i32,
}

// Rust: `Dictionary::marginal`.
fn lobe_dictionary_marginal(dictionary: LobeDictionary, index: u32, level: u32) -> LobeMarginal {
    let last = dictionary.marginals - 1u;
    let top = dictionary.levels - 1u;
    let place = select(last, index, index < last) * dictionary.levels
        + select(top, level, level < top);
    return LobeMarginal(place * (dictionary.intervals + 1u), i32(dictionary.intervals));
}
