// Mean and roughness: what everything upstream ends in. Rust: src/slope/lobe.rs.

// Rust: `Lobe`.
struct Lobe {
    mean: vec2f,
    roughness: LobeRoughness,
}

// Rust: `Lobe::new`. Means beyond 1e9 count as that, NaN as 0.
fn lobe_new(mean: vec2f, roughness: LobeRoughness) -> Lobe {
    return Lobe(lobe_both_within(mean, LOBE_LARGEST), roughness);
}

// Rust: `Lobe::centred`.
fn lobe_centred(roughness: LobeRoughness) -> Lobe {
    return Lobe(vec2f(0.0, 0.0), roughness);
}

// Rust: `Lobe::shape`.
fn lobe_shape(lobe: Lobe) -> LobeTilted {
    return LobeTilted(lobe_full_new(lobe.roughness), lobe.mean);
}
