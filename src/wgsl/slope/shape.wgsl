// Four questions about a lobe, and the shapes that answer them. Rust: src/slope/shape.rs.
// Generic functions of Rust are split in two here: a shape answers (`lobe_anisotropic_normal`,
// `_view`, `_pair`), and a distribution makes a density, a masking term or a BRDF of the answers
// (`lobe_ggx_d(lobe_anisotropic_normal(...))`).

// Rust: `Extent`.
struct LobeExtent {
    root_det: f32,
    unit: f32,
    scale: f32,
}

// WGSL only: what a density asks of a shape at one normal.
struct LobeNormal {
    form: f32,
    extent: LobeExtent,
    z: f32,
}

// WGSL only: what masking asks of a shape at one direction.
struct LobeView {
    mean_area: f32,
    stretch_squared: f32,
}

// WGSL only: what a BRDF asks of a shape at a pair of directions.
struct LobePair {
    form: f32,
    extent: LobeExtent,
    z: f32,
    length_squared: f32,
    wo: LobeView,
    wi: LobeView,
    lowest: f32,
}

// WGSL only: a direction of NaN sees nothing, as from a mirror's horizon.
fn lobe_view_of(w: vec3f, mean_area: f32, stretch_squared: f32) -> LobeView {
    let known = lobe_is_number(w.x + w.y + w.z);
    return LobeView(
        select(0.0, lobe_defined(mean_area), known), select(0.0, stretch_squared, known)
    );
}

// WGSL only: of `Ndf::brdf`.
fn lobe_half_sum(wo: vec3f, wi: vec3f) -> vec3f {
    return vec3f(wo.x + wi.x, wo.y + wi.y, wo.z + wi.z);
}

// WGSL only: of `Ndf::brdf`.
fn lobe_pair_of(
    half: vec3f, form: f32, extent: LobeExtent, wo: LobeView, wi: LobeView, lowest: f32
) -> LobePair {
    let length_squared = lobe_defined(half.x * half.x + half.y * half.y + half.z * half.z);
    return LobePair(form, extent, lobe_defined(half.z), length_squared, wo, wi, lowest);
}

// Rust: `extent_of`.
fn lobe_extent_of(root_det: f32) -> LobeExtent {
    return LobeExtent(root_det, root_det * root_det, root_det);
}

// Rust: `Isotropic`.
struct LobeIsotropic {
    alpha: f32,
}

// Rust: `Isotropic::new`. Alpha beyond [0, 1e9] counts as the nearest, NaN as 0.
fn lobe_isotropic_new(alpha: f32) -> LobeIsotropic {
    return LobeIsotropic(lobe_magnitude(alpha));
}

// Rust: `Isotropic::extent`.
fn lobe_isotropic_extent(shape: LobeIsotropic) -> LobeExtent {
    let square = shape.alpha * shape.alpha;
    return LobeExtent(square, square, 1.0);
}

// Rust: `Isotropic::form`. The largest number for NaN.
fn lobe_isotropic_form(m: vec3f) -> f32 {
    return lobe_far(m.x * m.x + m.y * m.y);
}

// WGSL only: what Rust has in `LobeShape`, of an isotropic shape.
fn lobe_isotropic_adjugate_form(shape: LobeIsotropic, v: vec2f) -> f32 {
    return shape.alpha * shape.alpha * (v.x * v.x + v.y * v.y);
}

// Rust: `Isotropic::stretch_squared`. 0 for NaN.
fn lobe_isotropic_stretch_squared(shape: LobeIsotropic, w: vec3f) -> f32 {
    return lobe_defined(shape.alpha * shape.alpha * (w.x * w.x + w.y * w.y));
}

// WGSL only: its answers at a normal.
fn lobe_isotropic_normal(shape: LobeIsotropic, m: vec3f) -> LobeNormal {
    return LobeNormal(lobe_isotropic_form(m), lobe_isotropic_extent(shape), lobe_defined(m.z));
}

// WGSL only: its answers at a direction.
fn lobe_isotropic_view(shape: LobeIsotropic, w: vec3f) -> LobeView {
    return lobe_view_of(w, w.z, lobe_isotropic_stretch_squared(shape, w));
}

// WGSL only: its answers at a pair of directions.
fn lobe_isotropic_pair(shape: LobeIsotropic, wo: vec3f, wi: vec3f) -> LobePair {
    let half = lobe_half_sum(wo, wi);
    return lobe_pair_of(
        half, lobe_isotropic_form(half), lobe_isotropic_extent(shape),
        lobe_isotropic_view(shape, wo), lobe_isotropic_view(shape, wi), lobe_min(wo.z, wi.z)
    );
}

// Rust: `AxisAligned`.
struct LobeAxisAligned {
    alphas: vec2f,
}

// Rust: `AxisAligned::new`. Alphas beyond [0, 1e9] count as the nearest, NaN as 0.
fn lobe_axis_aligned_new(alpha_x: f32, alpha_y: f32) -> LobeAxisAligned {
    return LobeAxisAligned(vec2f(lobe_magnitude(alpha_x), lobe_magnitude(alpha_y)));
}

// Rust: `AxisAligned::extent`.
fn lobe_axis_aligned_extent(shape: LobeAxisAligned) -> LobeExtent {
    return lobe_extent_of(shape.alphas.x * shape.alphas.y);
}

// Rust: `AxisAligned::form`. The largest number for NaN.
fn lobe_axis_aligned_form(shape: LobeAxisAligned, m: vec3f) -> f32 {
    let x = m.x * shape.alphas.y;
    let y = m.y * shape.alphas.x;
    return lobe_far(x * x + y * y);
}

// Rust: `AxisAligned::stretch_squared`. 0 for NaN.
fn lobe_axis_aligned_stretch_squared(shape: LobeAxisAligned, w: vec3f) -> f32 {
    let x = shape.alphas.x * w.x;
    let y = shape.alphas.y * w.y;
    return lobe_defined(x * x + y * y);
}

// WGSL only: its answers at a normal.
fn lobe_axis_aligned_normal(shape: LobeAxisAligned, m: vec3f) -> LobeNormal {
    return LobeNormal(
        lobe_axis_aligned_form(shape, m), lobe_axis_aligned_extent(shape), lobe_defined(m.z)
    );
}

// WGSL only: its answers at a direction.
fn lobe_axis_aligned_view(shape: LobeAxisAligned, w: vec3f) -> LobeView {
    return lobe_view_of(w, w.z, lobe_axis_aligned_stretch_squared(shape, w));
}

// WGSL only: its answers at a pair of directions.
fn lobe_axis_aligned_pair(shape: LobeAxisAligned, wo: vec3f, wi: vec3f) -> LobePair {
    let half = lobe_half_sum(wo, wi);
    return lobe_pair_of(
        half, lobe_axis_aligned_form(shape, half), lobe_axis_aligned_extent(shape),
        lobe_axis_aligned_view(shape, wo), lobe_axis_aligned_view(shape, wi), lobe_min(wo.z, wi.z)
    );
}
