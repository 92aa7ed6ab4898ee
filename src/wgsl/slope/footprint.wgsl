// Two derivative vectors on the slope plane and their parallelogram. Rust: src/slope/footprint.rs.

// Rust: `Footprint`.
struct LobeFootprint {
    u: vec2f,
    v: vec2f,
}

// Rust: `Footprint::WIDTH_LIMIT`.
const LOBE_FOOTPRINT_WIDTH_LIMIT: f32 = 1.0;

// Rust: `Footprint::from_slopes`. 0 for NaN.
fn lobe_footprint_from_slopes(u: vec2f, v: vec2f) -> LobeFootprint {
    return LobeFootprint(
        vec2f(lobe_defined(u.x), lobe_defined(u.y)), vec2f(lobe_defined(v.x), lobe_defined(v.y))
    );
}

// Rust: `Footprint::rectangle`.
fn lobe_footprint_rectangle(widths: vec2f) -> LobeFootprint {
    return lobe_footprint_from_slopes(vec2f(widths.x, 0.0), vec2f(0.0, widths.y));
}

// Rust: `Footprint::from_disk`. 0 for NaN.
fn lobe_footprint_from_disk(h: vec3f, u: vec2f, v: vec2f) -> LobeFootprint {
    let jacobian = lobe_disk_to_slope(vec3f(h.x, h.y, lobe_max(h.z, 1.0 / LOBE_LARGEST)));
    return LobeFootprint(lobe_jacobian_apply(jacobian, u), lobe_jacobian_apply(jacobian, v));
}

// Rust: `Footprint::from_disk_narrowed`.
fn lobe_footprint_from_disk_narrowed(u: vec2f, v: vec2f) -> LobeFootprint {
    return lobe_footprint_from_slopes(u, v);
}

// Rust: `Footprint::from_half_vectors`. The zero footprint where that returns an error.
fn lobe_footprint_from_half_vectors(h: vec3f, right: vec3f, up: vec3f) -> LobeFootprint {
    let above = h.z > 0.0 && right.z > 0.0 && up.z > 0.0;
    let s = lobe_slope_of(h);
    let r = lobe_slope_of(right);
    let t = lobe_slope_of(up);
    let u = vec2f(r.x - s.x, r.y - s.y);
    let v = vec2f(t.x - s.x, t.y - s.y);
    let known = lobe_footprint_is_known(h) && lobe_footprint_is_known(right)
        && lobe_footprint_is_known(up);
    return lobe_footprint_if(above && known, u, v);
}

// WGSL only: all components are finite numbers.
fn lobe_footprint_is_known(w: vec3f) -> bool {
    return lobe_is_finite(w.x) && lobe_is_finite(w.y) && lobe_is_finite(w.z);
}

// WGSL only: the footprint where it is wanted and finite, else zero.
fn lobe_footprint_if(wanted: bool, u: vec2f, v: vec2f) -> LobeFootprint {
    let finite = lobe_is_finite(u.x) && lobe_is_finite(u.y) && lobe_is_finite(v.x)
        && lobe_is_finite(v.y);
    let zero = vec2f(0.0, 0.0);
    return LobeFootprint(select(zero, u, wanted && finite), select(zero, v, wanted && finite));
}

// Rust: `Footprint::from_positions`. 0 for NaN.
fn lobe_footprint_from_positions(slope_jacobian: mat2x2f, u: vec2f, v: vec2f) -> LobeFootprint {
    return LobeFootprint(
        lobe_jacobian_apply(slope_jacobian, u), lobe_jacobian_apply(slope_jacobian, v)
    );
}

// Rust: `Footprint::extents`.
fn lobe_footprint_extents(footprint: LobeFootprint) -> vec2f {
    let u = footprint.u;
    let v = footprint.v;
    return vec2f(abs(u.x) + abs(v.x), abs(u.y) + abs(v.y));
}

// Rust: `Footprint::bounding`.
fn lobe_footprint_bounding(footprint: LobeFootprint) -> LobeFootprint {
    return lobe_footprint_rectangle(lobe_footprint_extents(footprint));
}

// Rust: `Footprint::bounding_within`.
fn lobe_footprint_bounding_within(footprint: LobeFootprint, limit: f32) -> LobeFootprint {
    let widths = lobe_footprint_extents(footprint);
    let most = lobe_max(limit, 0.0);
    return lobe_footprint_rectangle(vec2f(lobe_min(widths.x, most), lobe_min(widths.y, most)));
}

// Rust: `Footprint::diameter`. 0 for NaN.
fn lobe_footprint_diameter(footprint: LobeFootprint) -> f32 {
    let u = footprint.u;
    let v = footprint.v;
    let sum = lobe_footprint_length(u.x + v.x, u.y + v.y);
    return lobe_defined(lobe_max(sum, lobe_footprint_length(u.x - v.x, u.y - v.y)));
}

// WGSL only: Rust has it as a closure.
fn lobe_footprint_length(x: f32, y: f32) -> f32 {
    let scale = lobe_max(lobe_max(abs(x), abs(y)), LOBE_MIN_POSITIVE);
    let p = lobe_kept(x / scale);
    let q = lobe_kept(y / scale);
    return scale * sqrt(p * p + q * q);
}

// Rust: `Footprint::capped`. 0 for NaN; sides beyond 1e30 count as shorter.
fn lobe_footprint_capped(sides: LobeFootprint, limit: f32) -> LobeFootprint {
    var footprint = sides;
    if !(lobe_footprint_largest_component(sides) <= 1e30) {
        footprint = lobe_footprint_bounded(sides);
    }
    let diameter = lobe_footprint_diameter(footprint);
    let most = lobe_max(limit, 0.0);
    if diameter <= most {
        return footprint;
    }
    let u = footprint.u;
    let v = footprint.v;
    return lobe_footprint_from_slopes(
        vec2f(lobe_kept(u.x / diameter) * most, lobe_kept(u.y / diameter) * most),
        vec2f(lobe_kept(v.x / diameter) * most, lobe_kept(v.y / diameter) * most)
    );
}

// Rust: `Footprint::largest_component`.
fn lobe_footprint_largest_component(footprint: LobeFootprint) -> f32 {
    let u = footprint.u;
    let v = footprint.v;
    return lobe_max(lobe_max(abs(u.x), abs(u.y)), lobe_max(abs(v.x), abs(v.y)));
}

// Rust: `Footprint::bounded`.
fn lobe_footprint_bounded(footprint: LobeFootprint) -> LobeFootprint {
    let largest = lobe_footprint_largest_component(footprint);
    if largest <= LOBE_LARGEST {
        return footprint;
    }
    let most = lobe_below_infinity(largest);
    let u = footprint.u;
    let v = footprint.v;
    return LobeFootprint(
        vec2f(lobe_footprint_shrunk(u.x, most), lobe_footprint_shrunk(u.y, most)),
        vec2f(lobe_footprint_shrunk(v.x, most), lobe_footprint_shrunk(v.y, most))
    );
}

// WGSL only: Rust has it as a closure.
fn lobe_footprint_shrunk(x: f32, largest: f32) -> f32 {
    return lobe_kept(lobe_finite(x) / largest) * LOBE_LARGEST;
}

// Rust: `Footprint::area`. 0 for NaN.
fn lobe_footprint_area(footprint: LobeFootprint) -> f32 {
    return lobe_defined(abs(lobe_cross(footprint.u, footprint.v)));
}

// Rust: `Footprint::mul`. 0 for NaN.
fn lobe_footprint_mul(footprint: LobeFootprint, factor: f32) -> LobeFootprint {
    let u = footprint.u;
    let v = footprint.v;
    return lobe_footprint_from_slopes(
        vec2f(u.x * factor, u.y * factor), vec2f(v.x * factor, v.y * factor)
    );
}

// Rust: `Footprint::sub`. 0 for NaN.
fn lobe_footprint_sub(footprint: LobeFootprint, mean_u: vec2f, mean_v: vec2f) -> LobeFootprint {
    let u = footprint.u;
    let v = footprint.v;
    return lobe_footprint_from_slopes(
        vec2f(u.x - mean_u.x, u.y - mean_u.y), vec2f(v.x - mean_v.x, v.y - mean_v.y)
    );
}
