// GGX over a parallelogram in straight-line code, four edges as a `vec4f`.
// Rust: src/filter/polygon/lanes.rs, halves.rs.

// WGSL only: `Limits::small`.
const LOBE_LANES_SMALL: f32 = 0.09;
// WGSL only: a quarter of it.
const LOBE_LANES_LEAST_SQUARE: f32 = 0.0225;
// Rust: `SMALL_FAR`.
const LOBE_LANES_SMALL_FAR: f32 = 4.0;
// WGSL only: `Limits::far`.
const LOBE_LANES_FAR: f32 = 2e4;
// WGSL only: `Limits::largest`.
const LOBE_LANES_LARGEST: f32 = 1e18;

// Rust: `atan_joined`, of f32.
fn lobe_lanes_atan_joined(s: vec4f) -> vec4f {
    let squared = s * s;
    let high = s * 0.007917344 - 0.037283733;
    let mid = s * 0.0843276 - 0.13521491;
    let low = s * 0.198934 - 0.33328214;
    return (high * squared + mid) * squared + low;
}

// Rust: `terms`.
fn lobe_lanes_terms(k: vec4f, side_squared: vec4f, x: vec4f) -> f32 {
    let r_squared = k * k + side_squared;
    let x_squared = x * x;
    let steep = x_squared < r_squared;
    let inverse = 1.0 / select(x_squared, r_squared, r_squared > x_squared);
    let s = select(x_squared, r_squared, r_squared < x_squared) * inverse;
    let straight = (k * x) * inverse;
    let line = select(straight, -straight, steep);
    let p = lobe_lanes_atan_joined(s);
    let front = k / sqrt(r_squared);
    let beside = select(vec4f(0.0), vec4f(LOBE_PI), x < vec4f(0.0));
    let base = select(beside, vec4f(0.5 * LOBE_PI), steep);
    let first = front * base + line;
    let second = (line * s) * p;
    return ((first.x + first.z) + (first.y + first.w))
        + ((second.x + second.z) + (second.y + second.w));
}

// Rust: `dot`. The builtin may round in any order.
fn lobe_lanes_dot(a: vec2f, b: vec2f) -> f32 {
    return a.x * b.x + a.y * b.y;
}

// Rust: `cross`.
fn lobe_lanes_cross(a: vec2f, b: vec2f) -> f32 {
    return a.x * b.y - a.y * b.x;
}

// Rust: `Halves`.
struct LobeHalves {
    c: vec2f,
    a: vec2f,
    b: vec2f,
    aa: f32,
    bb: f32,
    ca: f32,
    cb: f32,
    ab: f32,
    pa: f32,
    pb: f32,
    d: f32,
}

// Rust: `Halves::new`.
fn lobe_halves_new(c: vec2f, u: vec2f, v: vec2f) -> LobeHalves {
    let half_u = 0.5 * u;
    let half_v = 0.5 * v;
    let uu = lobe_lanes_dot(half_u, half_u);
    let vv = lobe_lanes_dot(half_v, half_v);
    let swap = uu < vv;
    let a = select(half_u, half_v, swap);
    let b = select(half_v, half_u, swap);
    return LobeHalves(
        c, a, b, lobe_max(uu, vv), lobe_min(uu, vv), lobe_lanes_cross(c, a),
        lobe_lanes_cross(c, b), lobe_lanes_cross(a, b), lobe_lanes_dot(c, a), lobe_lanes_dot(c, b),
        lobe_lanes_dot(a, b)
    );
}

// Rust: `Halves::mean`. 0 beyond the largest lengths.
fn lobe_halves_mean(h: LobeHalves) -> f32 {
    let q = 1.0 + lobe_lanes_dot(h.c, h.c);

    // Small: Gauss' 2x2 nodes, in pairs.
    let middle = q + 0.33333334 * (h.aa + h.bb);
    let skew = 0.6666667 * h.d;
    let xz = vec2f(middle + skew, middle - skew);
    let yt = 1.1547005 * vec2f(h.pa + h.pb, h.pa - h.pb);
    let xz_squared = xz * xz;
    let yt_squared = yt * yt;
    let product = xz_squared - yt_squared;
    let ij = 1.0 / select(vec2f(1.0), product, product > vec2f(1.0));
    // The square of a reciprocal is below the range.
    let over = (xz_squared + yt_squared) * ij;
    let nodes = vec2f(lobe_kept(over.x), lobe_kept(over.y)) * ij;
    let small = 0.5 * (nodes.x + nodes.y);

    // The distance of the rectangle around it, and the least height that the terms resolve there.
    let length_squared = 4.0 * h.aa;
    let aa = lobe_max(h.aa, LOBE_LANES_LEAST_SQUARE);
    let inverse_aa = 1.0 / aa;
    let across = lobe_max(abs(h.ca) - abs(h.ab), 0.0);
    let along = lobe_max(abs(h.pa) - (aa + abs(h.d)), 0.0);
    let beyond_squared = across * across + along * along;
    let far_squared = 1.0 + beyond_squared * inverse_aa;
    let long = sqrt(aa + beyond_squared);
    let least = long * lobe_min(0.0005 * far_squared, 0.015);
    let size = lobe_max(abs(h.ab), least);
    let area = select(size, -size, h.ab < 0.0);
    let nudge = (area - h.ab) * inverse_aa;
    let nudged_pb = h.pb - nudge * h.ca;
    let cb = h.cb + nudge * h.pa;
    let bb = h.bb + nudge * (h.ab + area);

    let is_far = LOBE_LANES_FAR < far_squared;
    let bound = far_squared * (far_squared + (1.2732395 * long + 2.546479 * size));
    let inverse_below = 1.0 / select(8.0 * area, bound, is_far);

    // Edges below, right, above and left.
    let gap = aa - bb;
    let low = 0.5 * (q - gap);
    let high = 0.5 * (q + gap);
    let sum = lobe_lanes_terms(
        vec4f(area + h.ca, area + cb, area - h.ca, area - cb),
        vec4f(aa, bb, aa, bb),
        vec4f(low - nudged_pb, high + h.pa, low + nudged_pb, high - h.pa)
    );
    let large = lobe_max(select(sum, 1.0, is_far) * inverse_below, 0.0);
    let up_to = select(LOBE_LANES_SMALL, LOBE_LANES_SMALL_FAR, is_far);
    let mean = select(large, small, length_squared < up_to * far_squared);
    return select(0.0, mean, q + length_squared < LOBE_LANES_LARGEST);
}

// WGSL only: of `inverse_and_limit`, the inverse.
fn lobe_lanes_inverse(root_det: f32) -> f32 {
    return 1.0 / lobe_max(root_det, LOBE_MIN_POSITIVE);
}

// WGSL only: of `inverse_and_limit`, the limit: 0 of a mirror or a groove, and for NaN.
fn lobe_lanes_limited(x: f32, resolved: bool) -> f32 {
    return select(0.0, lobe_below_infinity(lobe_max(lobe_defined(x), 0.0)), resolved);
}

// WGSL only: what a mean in lanes asks of a shape at a slope and a footprint.
struct LobeSlopeOver {
    halves: LobeHalves,
    inverse_root_det: f32,
    resolved: bool,
}

// WGSL only: of whitened vectors.
fn lobe_lanes_slope_over(
    root_det: f32, inverse: f32, c: vec2f, u: vec2f, v: vec2f
) -> LobeSlopeOver {
    return LobeSlopeOver(lobe_halves_new(c, u, v), inverse, root_det >= LOBE_MIN_POSITIVE);
}

// WGSL only: the answers of an isotropic shape at a slope and a footprint.
fn lobe_isotropic_slope_over(
    shape: LobeIsotropic, slope: vec2f, footprint: LobeFootprint
) -> LobeSlopeOver {
    let root_det = shape.alpha * shape.alpha;
    let inverse = lobe_lanes_inverse(root_det);
    let scale = shape.alpha * inverse;
    return lobe_lanes_slope_over(
        root_det, inverse, scale * slope, scale * footprint.u, scale * footprint.v
    );
}

// WGSL only: the answers of an axis-aligned shape at a slope and a footprint.
fn lobe_axis_aligned_slope_over(
    shape: LobeAxisAligned, slope: vec2f, footprint: LobeFootprint
) -> LobeSlopeOver {
    let root_det = shape.alphas.x * shape.alphas.y;
    let inverse = lobe_lanes_inverse(root_det);
    let scale = shape.alphas.yx * inverse;
    return lobe_lanes_slope_over(
        root_det, inverse, scale * slope, scale * footprint.u, scale * footprint.v
    );
}

// WGSL only: `Whiten::whiten_with` of `Anisotropic`. NaN stays NaN.
fn lobe_lanes_whiten(shape: LobeAnisotropic, v: vec2f, inverse_root_det: f32) -> vec2f {
    let factor = shape.factor;
    let across = (factor.l_xx * v.y - factor.l_yx * v.x) * inverse_root_det;
    return vec2f((factor.l_yy * inverse_root_det) * v.x, across);
}

// WGSL only: the answers of an anisotropic shape at a slope and a footprint.
fn lobe_anisotropic_slope_over(
    shape: LobeAnisotropic, slope: vec2f, footprint: LobeFootprint
) -> LobeSlopeOver {
    let inverse = lobe_lanes_inverse(shape.root_det);
    return lobe_lanes_slope_over(
        shape.root_det, inverse, lobe_lanes_whiten(shape, slope, inverse),
        lobe_lanes_whiten(shape, footprint.u, inverse),
        lobe_lanes_whiten(shape, footprint.v, inverse)
    );
}

// WGSL only: the answers of a shape with a mean at a slope and a footprint.
fn lobe_non_centered_slope_over(
    shape: LobeNonCentered, slope: vec2f, footprint: LobeFootprint
) -> LobeSlopeOver {
    return lobe_anisotropic_slope_over(shape.shape, slope - shape.mean, footprint);
}

// Rust: `Ndf::parallelogram_mean_in_lanes`, of a shape's answers at a slope and a footprint. 0 for
// NaN.
fn lobe_ggx_parallelogram_mean_in_lanes(at: LobeSlopeOver) -> f32 {
    return lobe_lanes_limited(
        (LOBE_INVERSE_PI * at.inverse_root_det) * lobe_halves_mean(at.halves), at.resolved
    );
}
