// Mirrors and grooves over a footprint. Rust: src/filter/groove.rs.

// WGSL only: a call of `limit` in Rust.
const LOBE_GROOVE_LIMIT: f32 = 281474976710656.0;
// WGSL only: a sixteenth of the largest number.
const LOBE_GROOVE_SQUARES: f32 = 2.1267646664908054e37;

// Rust: `may_be_unresolved`.
fn lobe_groove_may_be_unresolved(root_det: f32, longer_side_squared: f32) -> bool {
    return !(
        root_det >= LOBE_MIN_POSITIVE
            && longer_side_squared <= LOBE_GROOVE_LIMIT * LOBE_GROOVE_LIMIT
    );
}

// Rust: `Covered`.
struct LobeGrooveCovered {
    mean: f32,
    place: vec2f,
}

// Rust: `unresolved`: whether it is some.
fn lobe_groove_is_unresolved(
    shape: LobeAnisotropic, longer_side_squared: f32, footprint: LobeFootprint
) -> bool {
    return lobe_groove_may_be_unresolved(shape.root_det, longer_side_squared)
        && lobe_groove_is_narrow(shape, longer_side_squared, footprint);
}

// Rust: `narrow`: whether it is some.
fn lobe_groove_is_narrow(
    shape: LobeAnisotropic, longer_side_squared: f32, footprint: LobeFootprint
) -> bool {
    let root_det = shape.root_det;
    if !(root_det >= LOBE_MIN_POSITIVE && longer_side_squared <= LOBE_GROOVE_SQUARES) {
        return true;
    }
    let major = lobe_anisotropic_major(shape);
    let minor = lobe_kept(root_det / major.z);
    let thick = lobe_groove_is_mirror(major.z, footprint);
    let brushed = major.z >= 16777216.0 * minor;
    return thick
        || (brushed && lobe_groove_reach_across(major.xy, footprint) >= LOBE_GROOVE_LIMIT * minor);
}

// Rust: `reach_across`.
fn lobe_groove_reach_across(axis: vec2f, footprint: LobeFootprint) -> f32 {
    return lobe_max(abs(lobe_cross(axis, footprint.u)), abs(lobe_cross(axis, footprint.v)));
}

// Rust: `is_mirror`.
fn lobe_groove_is_mirror(alpha: f32, footprint: LobeFootprint) -> bool {
    let largest = lobe_max(lobe_footprint_largest_component(footprint), LOBE_MIN_POSITIVE);
    return alpha * LOBE_GROOVE_LIMIT <= lobe_kept(lobe_footprint_area(footprint) / largest);
}

// Rust: `BRUSHED`.
const LOBE_GROOVE_BRUSHED: f32 = 300.0;

// Rust: `LARGEST_GAIN`.
const LOBE_GROOVE_LARGEST_GAIN: f32 = 1e30;

// Rust: `covered`.
fn lobe_groove_covered(
    shape: LobeAnisotropic, offset: vec4f, footprint: LobeFootprint
) -> LobeGrooveCovered {
    let major = lobe_anisotropic_major(shape);
    if lobe_groove_is_mirror(major.z, footprint) {
        return LobeGrooveCovered(lobe_groove_mirror_mean(offset, footprint), vec2f(0.0, 0.0));
    }
    return lobe_groove_of(major.xy, major.z, offset, footprint);
}

// Rust: `Border`.
struct LobeBorder {
    high: vec2f,
    low: vec2f,
}

// Rust: `Border::new`.
fn lobe_border_new(offset: vec4f, a: vec2f, b: vec2f) -> LobeBorder {
    let x = lobe_border_at(offset.x, offset.z, a.x, b.x);
    let y = lobe_border_at(offset.y, offset.w, a.y, b.y);
    return LobeBorder(vec2f(x.x, y.x), vec2f(x.y, y.y));
}

// WGSL only: Rust has it as a closure.
fn lobe_border_at(offset: f32, low: f32, a: f32, b: f32) -> vec2f {
    let first = lobe_two_sum(offset, a);
    let second = lobe_two_sum(first.x, b);
    return lobe_two_sum(second.x, first.y + second.y + low);
}

// Rust: `Border::cross`.
fn lobe_border_cross(border: LobeBorder, side: vec2f) -> f32 {
    return lobe_cross(border.high, side) + (border.low.x * side.y - border.low.y * side.x);
}

// Rust: `edges`.
fn lobe_groove_edges(offset: vec4f, other: vec2f, side: vec2f) -> vec2f {
    let zero = vec2f(0.0, 0.0);
    let half = vec2f(0.5 * other.x, 0.5 * other.y);
    return vec2f(
        lobe_border_cross(lobe_border_new(offset, -half, zero), side),
        lobe_border_cross(lobe_border_new(offset, half, zero), side)
    );
}

// Rust: `share`.
fn lobe_groove_share(depth: f32) -> f32 {
    return select(select(0.0, 0.5, depth >= 0.0), 1.0, depth > 0.0);
}

// Rust: `mirror_mean`.
fn lobe_groove_mirror_mean(offset: vec4f, footprint: LobeFootprint) -> f32 {
    let area = lobe_footprint_area(footprint);
    if !(area >= LOBE_MIN_POSITIVE) {
        return 0.0;
    }
    let weight = lobe_groove_between(offset, footprint.u, footprint.v)
        * lobe_groove_between(offset, footprint.v, footprint.u);
    return weight / area;
}

// WGSL only: Rust has it as a closure.
fn lobe_groove_between(offset: vec4f, other: vec2f, side: vec2f) -> f32 {
    let ends = lobe_groove_edges(offset, other, side);
    return lobe_groove_share(lobe_min(lobe_max(ends.x, ends.y), -lobe_min(ends.x, ends.y)));
}

// Rust: `marginal_mean`.
fn lobe_groove_marginal_mean(alpha: f32, start: f32, end: f32) -> f32 {
    let inverse = 1.0 / lobe_max(lobe_max(alpha, abs(start)), abs(end));
    let a = lobe_kept(alpha * inverse);
    let x = lobe_kept(start * inverse);
    let y = lobe_kept(end * inverse);
    let square = lobe_max(a * a, LOBE_MIN_POSITIVE);
    let s_x = sqrt(square + x * x);
    let s_y = sqrt(square + y * y);
    let product = x * y;
    let ends = s_x * s_y;
    let beside = square * ((square + x * x + y * y) / (ends + abs(product)));
    let excess = select(ends - product, beside, product > 0.0);
    return inverse * lobe_kept((square + excess) / (2.0 * ends * (s_x + s_y)));
}

// Rust: `groove`.
fn lobe_groove_of(
    axis: vec2f, alpha: f32, offset: vec4f, footprint: LobeFootprint
) -> LobeGrooveCovered {
    let zero = vec2f(0.0, 0.0);
    let swap = abs(lobe_cross(axis, footprint.u)) > abs(lobe_cross(axis, footprint.v));
    let u = select(footprint.u, footprint.v, swap);
    let v = select(footprint.v, footprint.u, swap);
    let along_u = lobe_cross(axis, u);
    let along_v = lobe_cross(axis, v);
    let short = abs(along_u);
    let long = abs(along_v);
    if !(long > 0.0) {
        return LobeGrooveCovered(0.0, zero);
    }
    let apart = lobe_border_cross(lobe_border_new(offset, zero, zero), axis);
    let side = select(0.5, -0.5, apart < 0.0);
    let step_u = select(side, -side, along_u < 0.0);
    let step_v = select(side, -side, along_v < 0.0);
    let beyond_u = vec2f(step_u * u.x, step_u * u.y);
    let beyond_v = vec2f(step_v * v.x, step_v * v.y);
    let corner = lobe_border_cross(lobe_border_new(offset, beyond_u, beyond_v), axis);
    let depth = select(-corner, corner, apart < 0.0);
    var part = lobe_groove_share(depth);
    let ends = lobe_groove_ends(offset, u, v, along_v);
    var start = ends.x;
    var end = ends.y;
    if short > 0.0 {
        part = lobe_min(lobe_max(depth / short, 0.0), 1.0);
        let others = lobe_groove_ends(offset, v, u, along_u);
        start = lobe_max(start, others.x);
        end = lobe_min(end, others.y);
    }
    let densest = lobe_min(lobe_max(0.0, start), end);
    let middle = 0.5 * (start + end);
    let length = end - start;
    let reach = 4.0 * (alpha * alpha + densest * densest);
    let near = length * length / lobe_max(length * length + reach, LOBE_MIN_POSITIVE);
    let pull = select(near, 1.0, short > 0.0);
    let place = middle + (densest - middle) * pull;
    let mean = part / long * lobe_groove_marginal_mean(alpha, start, end);
    return LobeGrooveCovered(
        lobe_below_infinity(lobe_max(lobe_defined(mean), 0.0)),
        vec2f(lobe_defined(axis.x * place), lobe_defined(axis.y * place))
    );
}

// WGSL only: Rust has it as a closure.
fn lobe_groove_ends(offset: vec4f, other: vec2f, side: vec2f, across: f32) -> vec2f {
    let edges = lobe_groove_edges(offset, other, side);
    let first = edges.x / across;
    let last = edges.y / across;
    return vec2f(lobe_min(first, last), lobe_max(first, last));
}
