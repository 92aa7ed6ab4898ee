// A pixel's place on a surface from the quad, for fragment shaders only: as in fragment.wgsl, call
// this at the top level of the entry point. No Rust twin: CPUs have no quads.

// WGSL only: the pixel's patch from its texture coordinates. `up` points to the next row of the
// target, down in most: no grid looks at the sign of a side. Coordinates and steps beyond the
// largest number count as that, NaN as 0.
fn lobe_fragment_patch(uv: vec2f) -> LobePatch {
    return lobe_fragment_patch_in_tile(vec2i(0, 0), uv);
}

// WGSL only: the pixel's patch from an integer tile and the coordinates within it. The tile is a
// flat attribute of a triangle: where it changed between the pixels of a quad, the coordinates'
// derivatives would jump.
fn lobe_fragment_patch_in_tile(tile: vec2i, uv: vec2f) -> LobePatch {
    return LobePatch(
        tile, lobe_both_within(uv, LOBE_MAX), lobe_both_within(dpdxFine(uv), LOBE_MAX),
        lobe_both_within(dpdyFine(uv), LOBE_MAX)
    );
}
