// How high the normals stand that a mean comes from. Rust: src/filter/polygon/secant.rs.

// WGSL only: an option in Rust: the first slope and its q, known if the lobe is a groove to the
// footprint; and whether the whitened sides are nearly parallel.
struct LobeSecantFirst {
    parallel: bool,
    known: bool,
    s: vec2f,
    squared: f32,
}

// WGSL only: of `secant_ratio`.
fn lobe_secant_is_parallel(w: LobeWhitened) -> bool {
    let u_squared = lobe_strip_dot(w.u, w.u);
    let area = w.u.x * w.v.y - w.u.y * w.v.x;
    return area * lobe_kept(area / lobe_max(u_squared, LOBE_MIN_POSITIVE))
        <= 1e-6 * lobe_strip_dot(w.v, w.v);
}

// Rust: `secant_ratio`.
fn lobe_secant_ratio(
    slope: vec2f, q: f32, ratio: f32, footprint: LobeFootprint, w: LobeWhitened,
    groove: LobeSecantFirst
) -> f32 {
    let there = lobe_below_infinity(
        lobe_max((1.0 + q - ratio) / lobe_max(ratio, LOBE_MIN_POSITIVE), 0.0)
    );
    let u_squared = lobe_strip_dot(w.u, w.u);
    let v_squared = lobe_strip_dot(w.v, w.v);
    let u = footprint.u;
    let v = footprint.v;
    var s = groove.s;
    var first_squared = groove.squared;
    if !groove.known {
        let place = lobe_secant_first_place(w, u_squared, v_squared, groove.parallel);
        s = vec2f(slope.x + place.x * u.x + place.y * v.x, slope.y + place.x * u.y + place.y * v.y);
        first_squared = place.z;
    }
    let sides = lobe_strip_dot(u, u) + lobe_strip_dot(v, v);
    let rate = lobe_kept(sides / lobe_max(u_squared + v_squared, LOBE_MIN_POSITIVE));
    let corner = vec2f(
        abs(slope.x) + 0.5 * (abs(u.x) + abs(v.x)), abs(slope.y) + 0.5 * (abs(u.y) + abs(v.y))
    );
    let free = 1.0 + lobe_strip_dot(s, s) + (there - first_squared) * rate;
    let secant = lobe_min(lobe_max(free, 1.0), 1.0 + lobe_strip_dot(corner, corner));
    let same = abs(1.0 - ratio) <= 16.0 * LOBE_EPSILON;
    return select(secant / (1.0 + lobe_strip_dot(slope, slope)), 1.0, same);
}

// Rust: `first_place`.
fn lobe_secant_first_place(
    w: LobeWhitened, u_squared: f32, v_squared: f32, parallel: bool
) -> vec3f {
    let densest = lobe_secant_densest(w, u_squared, v_squared, parallel);
    let nearest = lobe_secant_at(w, densest.x, densest.y);
    let reach = 4.0 * (1.0 + lobe_strip_dot(nearest, nearest));
    let of_u = u_squared / (u_squared + reach);
    let of_v = v_squared / (v_squared + reach);
    var i = densest.x * of_u;
    var j = densest.y * of_v;
    if u_squared >= v_squared {
        i = lobe_secant_along(lobe_secant_at(w, 0.0, j), w.u, u_squared).x * of_u;
    } else {
        j = lobe_secant_along(lobe_secant_at(w, i, 0.0), w.v, v_squared).x * of_v;
    }
    let first = lobe_secant_at(w, i, j);
    return vec3f(i, j, lobe_strip_dot(first, first));
}

// WGSL only: Rust has it as a closure.
fn lobe_secant_at(w: LobeWhitened, i: f32, j: f32) -> vec2f {
    return vec2f(w.midpoint.x + i * w.u.x + j * w.v.x, w.midpoint.y + i * w.u.y + j * w.v.y);
}

// Rust: `densest`.
fn lobe_secant_densest(w: LobeWhitened, u_squared: f32, v_squared: f32, parallel: bool) -> vec2f {
    let u = w.u;
    let v = w.v;
    let midpoint = w.midpoint;
    let area = u.x * v.y - u.y * v.x;
    let i = -((midpoint.x * v.y - midpoint.y * v.x) / area);
    let j = (midpoint.x * u.y - midpoint.y * u.x) / area;
    if parallel {
        let sign = select(1.0, -1.0, lobe_strip_dot(u, v) < 0.0);
        let both = vec2f(u.x + sign * v.x, u.y + sign * v.y);
        let t = lobe_secant_along(midpoint, both, lobe_strip_dot(both, both)).x;
        return vec2f(t, sign * t);
    }
    if abs(i) <= 0.5 && abs(j) <= 0.5 {
        return vec2f(i, j);
    }
    let low = lobe_secant_edge(w, -0.5, u_squared, v_squared);
    let high = lobe_secant_edge(w, 0.5, u_squared, v_squared);
    return select(high.yz, low.yz, low.x <= high.x);
}

// WGSL only: Rust has it as a closure.
fn lobe_secant_edge(w: LobeWhitened, t: f32, u_squared: f32, v_squared: f32) -> vec3f {
    let from_u = vec2f(w.midpoint.x + t * w.u.x, w.midpoint.y + t * w.u.y);
    let from_v = vec2f(w.midpoint.x + t * w.v.x, w.midpoint.y + t * w.v.y);
    let along_v = lobe_secant_along(from_u, w.v, v_squared);
    let along_u = lobe_secant_along(from_v, w.u, u_squared);
    return select(
        vec3f(along_u.y, along_u.x, t), vec3f(along_v.y, t, along_v.x), along_v.y <= along_u.y
    );
}

// Rust: `along`.
fn lobe_secant_along(start: vec2f, side: vec2f, squared: f32) -> vec2f {
    let t = lobe_max(
        lobe_min(-lobe_strip_dot(start, side) / lobe_max(squared, LOBE_MIN_POSITIVE), 0.5), -0.5
    );
    let end = vec2f(start.x + t * side.x, start.y + t * side.y);
    return vec2f(t, lobe_strip_dot(end, end));
}
