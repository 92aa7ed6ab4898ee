// Derivatives from the quad, for fragment shaders only. Call these at the top level of the entry
// point, before any branch that pixels of a quad could take differently: browsers refuse them
// elsewhere. No Rust twin: CPUs have no quads. They are fine: differences within the pixel's own
// row and column, the same on every driver. Plain ones may come from another row of the quad, and
// so may these in MSL and GLSL ES, which have no fine ones. WebGPU's compatibility mode has only
// those: give them to `lobe_footprint_from_slopes` yourself.

// WGSL only: the footprint of half vectors in one tangent frame, from the quad's slopes. Zero where
// `h` here, beside, below or above does not point above its horizon. Kernels count what has no
// number as huge.
fn lobe_fragment_footprint(h: vec3f) -> LobeFootprint {
    let slope = -vec2f(h.x, h.y) / h.z;
    let missing = select(1.0, 0.0, h.z > 0.0);
    let u = dpdxFine(vec3f(slope, missing));
    let v = dpdyFine(vec3f(slope, missing));
    let all = missing + abs(u.z) + abs(v.z) == 0.0;
    let zero = vec2f(0.0, 0.0);
    return LobeFootprint(select(zero, u.xy, all), select(zero, v.xy, all));
}

// WGSL only: the kernel on the projected disk, from the quad's unit half vectors in one tangent
// frame.
fn lobe_fragment_disk_kernel(h: vec3f, variance: f32) -> LobeDiskKernel {
    let u = dpdxFine(vec2f(h.x, h.y));
    let v = dpdyFine(vec2f(h.x, h.y));
    return lobe_disk_kernel_of(u, v, variance);
}

// WGSL only: `lobe_tokuyoshi_kaplanyan_deferred_alpha` of the quad's normals, in any one space.
fn lobe_fragment_deferred_alpha(alpha: f32, normal: vec3f, variance: f32, limit: f32) -> f32 {
    let u = dpdxFine(normal);
    let v = dpdyFine(normal);
    return lobe_tokuyoshi_kaplanyan_deferred_alpha(alpha, u, v, variance, limit);
}
