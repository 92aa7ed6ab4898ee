// GGX over a parallelogram as a sum over its edges. Rust: src/filter/polygon/edges.rs.

// Rust: `CLOSE`.
const LOBE_EDGES_CLOSE: f32 = 16.0;
// Rust: `SHORT`.
const LOBE_EDGES_SHORT: f32 = 1024.0;
// Rust: `TALL`.
const LOBE_EDGES_TALL: f32 = 0.010000000000000002;
// Rust: `TALL_FOR_SIDE`.
const LOBE_EDGES_TALL_FOR_SIDE: f32 = 0.00015876;
// Rust: `HALF_DISTANCE`.
const LOBE_EDGES_HALF_DISTANCE: f32 = 0.25;
// Rust: `DEEP`.
const LOBE_EDGES_DEEP: f32 = 0.010000000000000002;

// Rust: `serves_plain_corners`.
fn lobe_edges_serves_plain_corners(side_squared: f32) -> bool {
    return side_squared <= LOBE_EDGES_LONGEST * LOBE_EDGES_LONGEST;
}

// WGSL only: of `serves_plain_corners`.
const LOBE_EDGES_LONGEST: f32 = 4294967296.0;

// WGSL only: 1/(2 pi).
const LOBE_EDGES_TURN: f32 = 0.15915494309189535;

// Rust: `around_the_lobe`; negative in place of None.
fn lobe_edges_around_the_lobe(
    w: LobeWhitened, midpoint_squared: f32, side_squared: f32, footprint: LobeFootprint,
    root_det: f32
) -> f32 {
    let area = w.u.x * w.v.y - w.u.y * w.v.x;
    let q = 1.0 + midpoint_squared;
    let near = midpoint_squared <= LOBE_EDGES_CLOSE && side_squared <= LOBE_EDGES_SHORT;
    let tall = lobe_max(LOBE_EDGES_TALL * q * q * q, LOBE_EDGES_TALL_FOR_SIDE * side_squared);
    let deep = LOBE_EDGES_DEEP * sqrt(side_squared);
    let height_squared = select(4.0 * deep, lobe_min(tall, LOBE_EDGES_HALF_DISTANCE * q), near);
    let depth_squared = select(deep, 0.0, near);
    if area * area < height_squared * side_squared {
        return -1.0;
    }
    let turn = select(1.0, -1.0, area < 0.0);
    let px = lobe_edges_corners(w.midpoint.x, w.u.x, w.v.x);
    let py = lobe_edges_corners(w.midpoint.y, w.u.y, w.v.y);
    let dx = px.yzwx - px;
    let dy = py.yzwx - py;
    let c = px * dy - py * dx;
    let squared = dx * dx + dy * dy;
    let product = 1.0 + px * px.yzwx + py * py.yzwx;
    var terms = vec4f(0.0, 0.0, 0.0, 0.0);
    var inward = true;
    for (var k = 0u; k < 4u; k++) {
        if near {
            let r = sqrt(squared[k] + c[k] * c[k]);
            terms[k] = c[k] / r * lobe_upper_angle(r, product[k]);
        } else {
            // Cross products of a billion lobes by a billion have no squares in f32.
            let e = sqrt(squared[k]);
            let d = c[k] / e;
            let s = sqrt(1.0 + d * d);
            terms[k] = d / s * lobe_upper_angle(e * s, product[k]);
            inward = inward && turn * d * abs(d) - depth_squared > 0.0;
        }
    }
    let sum = (terms.x + terms.y) + (terms.z + terms.w);
    if !inward {
        return -1.0;
    }
    // Whitened corners of a far footprint have lost its area.
    var over = area;
    if !near {
        over = turn * (lobe_footprint_area(footprint) / root_det);
    }
    return lobe_max(sum / over * LOBE_EDGES_TURN, 0.0);
}

// WGSL only: Rust has it as a closure.
fn lobe_edges_corners(midpoint: f32, u: f32, v: f32) -> vec4f {
    let along = 0.5 * (u + v);
    let across = 0.5 * (u - v);
    return vec4f(midpoint - along, midpoint + across, midpoint + along, midpoint - across);
}

// Rust: `Edges`.
struct LobeEdges {
    d: vec4f,
    start: vec4f,
    end: vec4f,
    extent: vec4f,
}

// Rust: `Edges::new`.
fn lobe_edges_new(p: LobeFrame) -> LobeEdges {
    let bt = p.shear / p.side;
    let bn = p.height / p.side;
    return LobeEdges(
        vec4f(-p.low_n, p.within_right, p.high_n, p.within_left),
        vec4f(p.low.x, p.low.y * bt + p.low_n * bn, -p.high.y, -(p.high.x * bt + p.high_n * bn)),
        vec4f(p.low.y, p.high.y * bt + p.high_n * bn, -p.high.x, -(p.low.x * bt + p.low_n * bn)),
        vec4f(p.extent, p.side, p.extent, p.side)
    );
}

// Rust: `Edges::distance_squared`.
fn lobe_edges_distance_squared(edges: LobeEdges) -> f32 {
    var nearest = LOBE_MAX;
    var deepest = LOBE_MAX;
    for (var k = 0u; k < 4u; k++) {
        let beyond = lobe_max(lobe_max(edges.start[k], -edges.end[k]), 0.0);
        nearest = lobe_min(nearest, edges.d[k] * edges.d[k] + beyond * beyond);
        deepest = lobe_min(deepest, edges.d[k]);
    }
    return select(nearest, 0.0, deepest > 0.0);
}

// Rust: `Edges::is_radial`.
fn lobe_edges_is_radial(d: f32, start: f32, end: f32, length: f32) -> bool {
    let product = start * end;
    let square = d * d;
    let q = 1.0 + square;
    return square * lobe_max(length, 1.0) <= product && sqrt(q) * length <= q + product;
}

// Rust: `mass`.
fn lobe_edges_mass(p: LobeFrame) -> f32 {
    let edges = lobe_edges_new(p);
    let near = lobe_edges_distance_squared(edges) <= 3.0;
    var terms = vec4f(0.0, 0.0, 0.0, 0.0);
    for (var k = 0u; k < 4u; k++) {
        let d = edges.d[k];
        let start = edges.start[k];
        let end = edges.end[k];
        let length = edges.extent[k];
        if near {
            terms[k] = lobe_edges_near(d, start, end, length);
        } else if lobe_edges_is_radial(d, start, end, length) {
            terms[k] = -lobe_edges_radial(d, start, end, length);
        } else {
            terms[k] = lobe_edges_far(d, start, end, length);
        }
    }
    let sum = (terms.x + terms.y) + (terms.z + terms.w);
    return lobe_max(sum * LOBE_EDGES_TURN, 0.0);
}

// Rust: `near`.
fn lobe_edges_near(d: f32, start: f32, end: f32, length: f32) -> f32 {
    let q = 1.0 + d * d;
    let s = sqrt(q);
    return d / s * lobe_upper_angle(length * s, q + start * end);
}

// Rust: `far`.
fn lobe_edges_far(d: f32, start: f32, end: f32, length: f32) -> f32 {
    let product = start * end;
    let depth = abs(d);
    let q = 1.0 + d * d;
    let s = sqrt(q);
    let delta = 1.0 / (s + depth);
    let angle = lobe_upper_angle(length * s, q + product);
    let inverse = 1.0 / length;
    let y = delta * ((product - s * depth) * inverse);
    let x = ((q + product) * inverse) * ((d * d + product) * inverse) + s * depth;
    let term = lobe_atan_of(y, x) - angle * delta / s;
    return select(-term, term, d > 0.0);
}

// Rust: `radial`.
fn lobe_edges_radial(d: f32, start: f32, end: f32, length: f32) -> f32 {
    let product = start * end;
    let square = d * d;
    let q = 1.0 + square;
    let s = sqrt(q);
    let flat_sum = square + product;
    let round_sum = q + product;
    let first = (square + start * start) * (q + start * start);
    let second = (square + end * end) * (q + end * end);
    let main = length
        * (
            (flat_sum / first) * (round_sum / second)
                + (product / first) * (length * length / second)
        );
    let rest = lobe_atan_excess(abs(d) * length / flat_sum)
        - abs(d) / s * lobe_atan_excess(s * length / round_sum);
    return d * main + select(-rest, rest, d > 0.0);
}
