// A surface of many facets: their slopes from afar, and how many there are. Rust: src/material/multilobe/material.rs.

// WGSL only: `farthest` of single precision.
const LOBE_MULTI_LOBE_FARTHEST: i32 = 20;

// Rust: `MultiLobe`. The variation lies in [0, 4], the share in [0, 1]; the seed may be any.
struct LobeMultiLobe {
    roughness: LobeRoughness,
    density: f32,
    variation: f32,
    share: f32,
    seed: u32,
}

// Rust: `MultiLobe::new`. A density beyond [1e-18, 1e30] counts as the nearest, NaN as the smallest.
fn lobe_multi_lobe_new(roughness: LobeRoughness, density: f32) -> LobeMultiLobe {
    return LobeMultiLobe(roughness, lobe_min(lobe_max(density, 1e-18), 1e30), 2.0, 1.0, 0u);
}

// Rust: `MultiLobe::facet_size`.
fn lobe_multi_lobe_facet_size(facets: LobeMultiLobe) -> f32 {
    return 1.0 / sqrt(facets.density);
}

// Rust: `MultiLobe::lobe`, with what `PatchLobe::new` does there: no two files import from each other. NaN counts as 0.
fn lobe_multi_lobe_lobe(facets: LobeMultiLobe, dictionary: LobeDictionary, pixel: LobePatch) -> LobePatchLobe {
    let ellipse = lobe_ellipse_of(pixel);
    let distance = lobe_max(abs(pixel.uv.x), lobe_max(abs(pixel.uv.y), 0.0));
    let farthest = distance * lobe_power_of_two(-LOBE_MULTI_LOBE_FARTHEST);
    let least = lobe_max(lobe_max(ellipse.width, lobe_multi_lobe_facet_size(facets)), farthest);
    let size = lobe_min(lobe_max(least, lobe_power_of_two(-100)), lobe_power_of_two(100));
    let exponent = lobe_exponent(size);
    // The number is ln(2), as `Real::ln` has it.
    let coarser = lobe_ln(size * lobe_power_of_two(-exponent)) / 0.6931472;
    let number = 0.5 * lobe_ln(facets.density) / 0.6931472 + f32(exponent);
    return LobePatchLobe(
        dictionary, facets.roughness, LobeKernel(LobePsd(0.0, 0.0, 0.0, 0.0)), ellipse, exponent,
        lobe_min(lobe_max(coarser, 0.0), 1.0), number, facets.variation, facets.share, facets.seed
    );
}
