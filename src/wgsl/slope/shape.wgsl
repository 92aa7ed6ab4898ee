// Four questions about a lobe, and the shapes that answer them. Rust: src/slope/shape.rs.
// Generic functions of Rust are split in two here: a shape answers (`lobe_anisotropic_normal`,
// `_view`, `_pair`), and a distribution makes a density, a masking term or a BRDF of the answers
// (`lobe_ggx_d(lobe_anisotropic_normal(...))`).

// WGSL only: what a density asks of a shape at one normal.
struct LobeNormal {
    form: f32,
    root_det: f32,
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
    root_det: f32,
    z: f32,
    length_squared: f32,
    wo: LobeView,
    wi: LobeView,
    lowest: f32,
}

// WGSL only: wo + wi, and what the sums left out.
struct LobeHalfSum {
    high: vec3f,
    low: vec3f,
}

// WGSL only: a direction of NaN sees nothing, as from a mirror's horizon.
fn lobe_view_of(w: vec3f, mean_area: f32, stretch_squared: f32) -> LobeView {
    let known = lobe_is_number(w.x + w.y + w.z);
    return LobeView(
        select(0.0, lobe_defined(mean_area), known), select(0.0, stretch_squared, known)
    );
}

// WGSL only: of `Ndf::brdf`.
fn lobe_half_sum(wo: vec3f, wi: vec3f) -> LobeHalfSum {
    let x = lobe_two_sum(wo.x, wi.x);
    let y = lobe_two_sum(wo.y, wi.y);
    let z = lobe_two_sum(wo.z, wi.z);
    return LobeHalfSum(vec3f(x.x, y.x, z.x), vec3f(x.y, y.y, z.y));
}

// WGSL only: of `Ndf::brdf`.
fn lobe_pair_of(
    half: vec3f, form: f32, root_det: f32, wo: LobeView, wi: LobeView, lowest: f32
) -> LobePair {
    let length_squared = lobe_defined(half.x * half.x + half.y * half.y + half.z * half.z);
    return LobePair(form, root_det, lobe_defined(half.z), length_squared, wo, wi, lowest);
}

// Rust: `Isotropic`.
struct LobeIsotropic {
    alpha: f32,
}

// Rust: `Isotropic::new`. Alpha beyond [0, 1e9] counts as the nearest, NaN as 0.
fn lobe_isotropic_new(alpha: f32) -> LobeIsotropic {
    return LobeIsotropic(lobe_magnitude(alpha));
}

// Rust: `Isotropic::root_det`.
fn lobe_isotropic_root_det(shape: LobeIsotropic) -> f32 {
    return shape.alpha * shape.alpha;
}

// Rust: `Isotropic::form`. The largest number for NaN.
fn lobe_isotropic_form(m: vec3f) -> f32 {
    return lobe_far(m.x * m.x + m.y * m.y);
}

// Rust: `Isotropic::stretch_squared`. 0 for NaN.
fn lobe_isotropic_stretch_squared(shape: LobeIsotropic, w: vec3f) -> f32 {
    return lobe_defined(lobe_isotropic_root_det(shape) * (w.x * w.x + w.y * w.y));
}

// WGSL only: its answers at a normal.
fn lobe_isotropic_normal(shape: LobeIsotropic, m: vec3f) -> LobeNormal {
    return LobeNormal(lobe_isotropic_form(m), lobe_isotropic_root_det(shape), lobe_defined(m.z));
}

// WGSL only: its answers at a direction.
fn lobe_isotropic_view(shape: LobeIsotropic, w: vec3f) -> LobeView {
    return lobe_view_of(w, w.z, lobe_isotropic_stretch_squared(shape, w));
}

// WGSL only: its answers at a pair of directions.
fn lobe_isotropic_pair(shape: LobeIsotropic, wo: vec3f, wi: vec3f) -> LobePair {
    let half = vec3f(wo.x + wi.x, wo.y + wi.y, wo.z + wi.z);
    let form = lobe_isotropic_form(half);
    return lobe_pair_of(
        half, form, lobe_isotropic_root_det(shape), lobe_isotropic_view(shape, wo),
        lobe_isotropic_view(shape, wi),
        lobe_min(wo.z, wi.z)
    );
}

// Rust: `AxisAligned`.
struct LobeAxisAligned {
    alphas: vec2f,
    inverse_alphas: vec2f,
}

// Rust: `AxisAligned::new`. Alphas beyond [0, 1e9] count as the nearest, NaN as 0.
fn lobe_axis_aligned_new(alpha_x: f32, alpha_y: f32) -> LobeAxisAligned {
    let alphas = vec2f(lobe_magnitude(alpha_x), lobe_magnitude(alpha_y));
    let inverse = vec2f(
        1.0 / lobe_max(alphas.x, LOBE_MIN_POSITIVE), 1.0 / lobe_max(alphas.y, LOBE_MIN_POSITIVE)
    );
    return LobeAxisAligned(alphas, inverse);
}

// Rust: `AxisAligned::root_det`.
fn lobe_axis_aligned_root_det(shape: LobeAxisAligned) -> f32 {
    return shape.alphas.x * shape.alphas.y;
}

// Rust: `AxisAligned::form`. The largest number for NaN.
fn lobe_axis_aligned_form(shape: LobeAxisAligned, m: vec3f) -> f32 {
    let x = m.x * shape.inverse_alphas.x;
    let y = m.y * shape.inverse_alphas.y;
    return lobe_far((x * x + y * y) * lobe_axis_aligned_root_det(shape));
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
        lobe_axis_aligned_form(shape, m), lobe_axis_aligned_root_det(shape), lobe_defined(m.z)
    );
}

// WGSL only: its answers at a direction.
fn lobe_axis_aligned_view(shape: LobeAxisAligned, w: vec3f) -> LobeView {
    return lobe_view_of(w, w.z, lobe_axis_aligned_stretch_squared(shape, w));
}

// WGSL only: its answers at a pair of directions.
fn lobe_axis_aligned_pair(shape: LobeAxisAligned, wo: vec3f, wi: vec3f) -> LobePair {
    let half = vec3f(wo.x + wi.x, wo.y + wi.y, wo.z + wi.z);
    let form = lobe_axis_aligned_form(shape, half);
    return lobe_pair_of(
        half, form, lobe_axis_aligned_root_det(shape), lobe_axis_aligned_view(shape, wo),
        lobe_axis_aligned_view(shape, wi), lobe_min(wo.z, wi.z)
    );
}
