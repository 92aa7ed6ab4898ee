// Mean and roughness: what everything upstream ends in. Rust: src/slope/lobe.rs.

// Rust: `Lobe`.
struct LobeLobe {
    mean: vec2f,
    roughness: LobeRoughness,
}

// Rust: `Lobe::new`. Means beyond 1e9 count as that, NaN as 0.
fn lobe_lobe_new(mean: vec2f, roughness: LobeRoughness) -> LobeLobe {
    return LobeLobe(lobe_both_within(mean, LOBE_LARGEST), roughness);
}

// Rust: `Lobe::centered`.
fn lobe_lobe_centered(roughness: LobeRoughness) -> LobeLobe {
    return LobeLobe(vec2f(0.0, 0.0), roughness);
}

// Rust: `Lobe::shape`.
fn lobe_lobe_shape(lobe: LobeLobe) -> LobeNonCentered {
    return LobeNonCentered(lobe_anisotropic_new(lobe.roughness), lobe.mean);
}
