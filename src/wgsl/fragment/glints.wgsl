// A pixel's place on a surface from the quad, for fragment shaders only: as in fragment.wgsl, call this at the top level
// of the entry point. No Rust twin: CPUs have no quads.

// WGSL only: the pixel's patch from its texture coordinates. `up` points to the next row of the target, down in most: no
// grid looks at the sign of a side. Coordinates and steps beyond the largest number count as that, NaN as 0.
fn lobe_fragment_patch(uv: vec2f) -> LobePatch {
    return LobePatch(
        lobe_both_within(uv, LOBE_MAX), lobe_both_within(dpdxFine(uv), LOBE_MAX), lobe_both_within(dpdyFine(uv), LOBE_MAX)
    );
}
