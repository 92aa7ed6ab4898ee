// A shape moved to a mean slope. Rust: src/slope/non_centered.rs.

// Rust: `NonCentered`, over `Anisotropic`.
struct LobeNonCentered {
    shape: LobeAnisotropic,
    mean: vec2f,
}

// Rust: `NonCentered::new`. Means beyond 1e9 count as that, NaN as 0.
fn lobe_non_centered_new(shape: LobeAnisotropic, mean: vec2f) -> LobeNonCentered {
    return LobeNonCentered(shape, lobe_both_within(mean, LOBE_LARGEST));
}

// Rust: `NonCentered::form`.
fn lobe_non_centered_form(shape: LobeNonCentered, m: vec3f) -> f32 {
    return lobe_anisotropic_form(shape.shape, lobe_non_centered_relative(shape, m));
}

// WGSL only: what Rust has in `LobeShape`, of a shape with a mean.
fn lobe_non_centered_relative(shape: LobeNonCentered, m: vec3f) -> vec2f {
    return vec2f(m.x + shape.mean.x * m.z, m.y + shape.mean.y * m.z);
}

// Rust: `NonCentered::mean_area`. 0 for NaN.
fn lobe_non_centered_mean_area(shape: LobeNonCentered, w: vec3f) -> f32 {
    return lobe_defined(w.z - (shape.mean.x * w.x + shape.mean.y * w.y));
}

// Rust: `NonCentered::offset`: high parts, then low ones. 0 for NaN.
fn lobe_non_centered_offset(shape: LobeNonCentered, slope: vec2f) -> vec4f {
    let x = lobe_two_sum(slope.x, -shape.mean.x);
    let y = lobe_two_sum(slope.y, -shape.mean.y);
    return vec4f(lobe_defined(x.x), lobe_defined(y.x), lobe_defined(x.y), lobe_defined(y.y));
}

// WGSL only: its answers at a normal.
fn lobe_non_centered_normal(shape: LobeNonCentered, m: vec3f) -> LobeNormal {
    return LobeNormal(
        lobe_non_centered_form(shape, m), lobe_anisotropic_extent(shape.shape), lobe_defined(m.z)
    );
}

// WGSL only: its answers at a direction.
fn lobe_non_centered_view(shape: LobeNonCentered, w: vec3f) -> LobeView {
    return lobe_view_of(
        w, lobe_non_centered_mean_area(shape, w), lobe_anisotropic_stretch_squared(shape.shape, w)
    );
}

// WGSL only: its answers at a pair of directions. Above a tilted plane a half vector may point
// down.
fn lobe_non_centered_pair(shape: LobeNonCentered, wo: vec3f, wi: vec3f) -> LobePair {
    let half = lobe_half_sum(wo, wi);
    let o = lobe_non_centered_view(shape, wo);
    let i = lobe_non_centered_view(shape, wi);
    return lobe_pair_of(
        half, lobe_non_centered_form(shape, half), lobe_anisotropic_extent(shape.shape), o, i,
        lobe_min(lobe_min(o.mean_area, i.mean_area), half.z)
    );
}
