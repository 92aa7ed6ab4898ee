// A shape moved to a mean slope. Rust: src/slope/tilted.rs.

// Rust: `Tilted`, over `Full`.
struct LobeTilted {
    shape: LobeFull,
    mean: vec2f,
}

// Rust: `Tilted::new`. Means beyond 1e9 count as that, NaN as 0.
fn lobe_tilted_new(shape: LobeFull, mean: vec2f) -> LobeTilted {
    return LobeTilted(shape, lobe_both_within(mean, LOBE_LARGEST));
}

// Rust: `Tilted::form`.
fn lobe_tilted_form(shape: LobeTilted, m: vec3f, m_low: vec3f) -> f32 {
    let mean = shape.mean;
    let x = lobe_add_product(m.x, mean.x, m.z);
    let y = lobe_add_product(m.y, mean.y, m.z);
    let low = vec2f(x.y + (m_low.x + mean.x * m_low.z), y.y + (m_low.y + mean.y * m_low.z));
    let x_sum = lobe_kept(x.x + low.x);
    let y_sum = lobe_kept(y.x + low.y);
    let rest = vec3f(low.x - lobe_kept(x_sum - x.x), low.y - lobe_kept(y_sum - y.x), m_low.z);
    return lobe_full_form(shape.shape, vec3f(x_sum, y_sum, m.z), rest);
}

// Rust: `Tilted::offset`: high parts, then low ones. 0 for NaN.
fn lobe_tilted_offset(shape: LobeTilted, slope: vec2f) -> vec4f {
    let x = lobe_two_sum(slope.x, -shape.mean.x);
    let y = lobe_two_sum(slope.y, -shape.mean.y);
    return vec4f(lobe_defined(x.x), lobe_defined(y.x), lobe_defined(x.y), lobe_defined(y.y));
}

// Rust: `Tilted::mean_area`. 0 for NaN.
fn lobe_tilted_mean_area(shape: LobeTilted, w: vec3f) -> f32 {
    return lobe_defined(lobe_add_products(w.z, -shape.mean.x, w.x, -shape.mean.y, w.y));
}

// WGSL only: its answers at a normal.
fn lobe_tilted_normal(shape: LobeTilted, m: vec3f) -> LobeNormal {
    return LobeNormal(lobe_tilted_form(shape, m, vec3f(0.0, 0.0, 0.0)), shape.shape.root_det, lobe_defined(m.z));
}

// WGSL only: its answers at a direction.
fn lobe_tilted_view(shape: LobeTilted, w: vec3f) -> LobeView {
    return lobe_view_of(w, lobe_tilted_mean_area(shape, w), lobe_full_stretch_squared(shape.shape, w));
}

// WGSL only: its answers at a pair of directions. Above a tilted plane a half vector may point down.
fn lobe_tilted_pair(shape: LobeTilted, wo: vec3f, wi: vec3f) -> LobePair {
    let half = lobe_half_sum(wo, wi);
    let form = lobe_tilted_form(shape, half.high, half.low);
    let o = lobe_tilted_view(shape, wo);
    let i = lobe_tilted_view(shape, wi);
    let lowest = lobe_min(lobe_min(o.mean_area, i.mean_area), half.high.z);
    return lobe_pair_of(half.high, form, shape.shape.root_det, o, i, lowest);
}
