// A surface of many facets: their slopes from afar, and how many there are. Rust:
// src/material/multilobe/material.rs.

// Rust: `MultiLobe`. The variation lies in [0, 4], the share in [0, 1]; the seed may be any.
struct LobeMultiLobe {
    roughness: LobeRoughness,
    density: f32,
    variation: f32,
    share: f32,
    seed: u32,
}

// Rust: `MultiLobe::new`. A density beyond [1e-18, 1e30] counts as the nearest, NaN as the
// smallest.
fn lobe_multi_lobe_new(roughness: LobeRoughness, density: f32) -> LobeMultiLobe {
    return LobeMultiLobe(roughness, lobe_min(lobe_max(density, 1e-18), 1e30), 2.0, 1.0, 0u);
}

// Rust: `MultiLobe::facet_size`.
fn lobe_multi_lobe_facet_size(facets: LobeMultiLobe) -> f32 {
    return 1.0 / sqrt(facets.density);
}
