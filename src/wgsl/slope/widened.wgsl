// An isotropic shape under two columns: a lobe that a pixel's kernel widens, without a matrix.
// Rust: src/slope/widened.rs, there of any shape.

// Rust: `Widened`.
struct LobeWidened {
    shape: LobeIsotropic,
    u: vec2f,
    v: vec2f,
}

// Rust: `Widened::new`. Components beyond 2e9 count as that, NaN as 0.
fn lobe_widened_new(shape: LobeIsotropic, u: vec2f, v: vec2f) -> LobeWidened {
    return LobeWidened(shape, lobe_both_within(u, 2e9), lobe_both_within(v, 2e9));
}

// Rust: `cross_squared`.
fn lobe_widened_cross_squared(a: vec2f, b: vec2f) -> f32 {
    let cross = a.x * b.y - a.y * b.x;
    return cross * cross;
}

// Rust: `Widened::extent`, with `Isotropic::widened_det`.
fn lobe_widened_extent(shape: LobeWidened) -> LobeExtent {
    let square = shape.shape.alpha * shape.shape.alpha;
    let lengths = (shape.u.x * shape.u.x + shape.u.y * shape.u.y)
        + (shape.v.x * shape.v.x + shape.v.y * shape.v.y);
    let det = square * (square + lengths) + lobe_widened_cross_squared(shape.u, shape.v);
    let root_det = sqrt(det);
    return LobeExtent(root_det, det, root_det);
}

// Rust: `Widened::form`. The largest number for NaN.
fn lobe_widened_form(shape: LobeWidened, v: vec2f) -> f32 {
    return lobe_far(
        lobe_isotropic_adjugate_form(shape.shape, v) + lobe_widened_cross_squared(shape.u, v)
            + lobe_widened_cross_squared(shape.v, v)
    );
}

// Rust: `Widened::stretch_squared`. 0 for NaN.
fn lobe_widened_stretch_squared(shape: LobeWidened, w: vec3f) -> f32 {
    let along_u = shape.u.x * w.x + shape.u.y * w.y;
    let along_v = shape.v.x * w.x + shape.v.y * w.y;
    return lobe_defined(
        shape.shape.alpha * shape.shape.alpha * (w.x * w.x + w.y * w.y) + along_u * along_u
            + along_v * along_v
    );
}

// WGSL only: its answers at a normal.
fn lobe_widened_normal(shape: LobeWidened, m: vec3f) -> LobeNormal {
    return LobeNormal(
        lobe_widened_form(shape, m.xy), lobe_widened_extent(shape), lobe_defined(m.z)
    );
}

// WGSL only: its answers at a direction.
fn lobe_widened_view(shape: LobeWidened, w: vec3f) -> LobeView {
    return lobe_view_of(w, w.z, lobe_widened_stretch_squared(shape, w));
}

// WGSL only: its answers at a pair of directions.
fn lobe_widened_pair(shape: LobeWidened, wo: vec3f, wi: vec3f) -> LobePair {
    let half = lobe_half_sum(wo, wi);
    return lobe_pair_of(
        half, lobe_widened_form(shape, half.xy), lobe_widened_extent(shape),
        lobe_widened_view(shape, wo), lobe_widened_view(shape, wi), lobe_min(wo.z, wi.z)
    );
}
