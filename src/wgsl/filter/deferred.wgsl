// Roughness from the normal's change, before the light is known. Rust: src/filter/deferred.rs.

// Rust: `tokuyoshi_deferred_alpha`, with a filter's variance.
fn lobe_tokuyoshi_deferred_alpha(
    alpha: f32, dn_u: vec3f, dn_v: vec3f, variance: f32, limit: f32
) -> f32 {
    let spread = lobe_dot(dn_u, dn_u) + lobe_dot(dn_v, dn_v);
    return lobe_deferred_widened(alpha, 2.0 * lobe_magnitude(variance) * spread, limit);
}

// Rust: `tokuyoshi_kaplanyan_deferred_alpha`, with a filter's variance.
fn lobe_tokuyoshi_kaplanyan_deferred_alpha(
    alpha: f32, dn_u: vec3f, dn_v: vec3f, variance: f32, limit: f32
) -> f32 {
    let spread = lobe_dot(dn_u, dn_u) + lobe_dot(dn_v, dn_v);
    return lobe_deferred_widened(alpha, lobe_magnitude(variance) * spread, limit);
}

// Rust: `largest_deferred_alpha`, with a filter's variance.
fn lobe_largest_deferred_alpha(
    alpha: f32, dn_u: vec3f, dn_v: vec3f, variance: f32, limit: f32
) -> f32 {
    let u = lobe_dot(dn_u, dn_u);
    let v = lobe_dot(dn_v, dn_v);
    let trace = u + v;
    let largest = select(
        trace, lobe_psd_principal(u, lobe_dot(dn_u, dn_v), v).x, lobe_is_finite(trace)
    );
    return lobe_deferred_widened(alpha, 2.0 * lobe_magnitude(variance) * largest, limit);
}

// Rust: `kaplanyan_deferred_alphas`, with a filter's variance.
fn lobe_kaplanyan_deferred_alphas(
    alphas: vec2f, footprint: LobeFootprint, variance: f32, limit: f32
) -> vec2f {
    let widths = lobe_footprint_extents(footprint);
    let twice = 2.0 * lobe_magnitude(variance);
    return vec2f(
        lobe_deferred_widened(alphas.x, twice * widths.x * widths.x, limit),
        lobe_deferred_widened(alphas.y, twice * widths.y * widths.y, limit)
    );
}

// Rust: `kaplanyan_deferred_alpha`, with a filter's variance.
fn lobe_kaplanyan_deferred_alpha(
    alpha: f32, footprint: LobeFootprint, variance: f32, limit: f32
) -> f32 {
    let widths = lobe_footprint_extents(footprint);
    let widest = lobe_max(widths.x, widths.y);
    return lobe_deferred_widened(alpha, 2.0 * lobe_magnitude(variance) * widest * widest, limit);
}

// Rust: `quad_normal_footprint`, with each pixel's tangent, bitangent and normal as columns. The
// zero footprint where that returns an error.
fn lobe_quad_normal_footprint(
    here: mat3x3f, right: mat3x3f, up: mat3x3f, across: mat3x3f
) -> LobeFootprint {
    let average = vec3f(
        here[2].x + right[2].x + up[2].x + across[2].x,
        here[2].y + right[2].y + up[2].y + across[2].y,
        here[2].z + right[2].z + up[2].z + across[2].z
    );
    return lobe_footprint_from_half_vectors(
        lobe_deferred_seen(here, average), lobe_deferred_seen(right, average),
        lobe_deferred_seen(up, average)
    );
}

// WGSL only: Rust has it as a closure.
fn lobe_deferred_seen(frame: mat3x3f, v: vec3f) -> vec3f {
    return vec3f(lobe_dot(frame[0], v), lobe_dot(frame[1], v), lobe_dot(frame[2], v));
}

// Rust: `widened`. Alpha beyond [0, 1e9] counts as the nearest, a limit below 0 as 0, NaN as 0.
fn lobe_deferred_widened(alpha: f32, added: f32, limit: f32) -> f32 {
    let a = lobe_magnitude(alpha);
    let bounded = lobe_min(lobe_max(added, 0.0), lobe_max(limit, 0.0));
    return lobe_min(sqrt(a * a + bounded), lobe_max(a, 1.0));
}
