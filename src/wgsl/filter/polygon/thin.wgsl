// GGX over a frame by thin pieces: a rectangle and two triangles. Rust: src/filter/polygon/thin.rs.

// Rust: `SLIDE`.
const LOBE_THIN_SLIDE: f32 = 0.0625;

// Rust: `thickness_squared`.
fn lobe_thin_thickness_squared(p: LobeFrame) -> f32 {
    let height = p.height * p.height;
    let shear = p.shear * p.shear;
    if shear <= LOBE_THIN_SLIDE * p.nearness {
        return height / p.nearness;
    }
    let across = lobe_max(abs(p.n) - 0.5 * p.height, 0.0);
    let start = p.high.x;
    let end = p.low.y;
    let left_distance = lobe_thin_distance_squared(across, p.low.x, start);
    let right_distance = lobe_thin_distance_squared(across, end, p.high.y);
    let left = lobe_thin_triangle(height, shear, p.low.x, p.low_n, left_distance);
    let right = lobe_thin_triangle(height, shear, p.high.y, p.high_n, right_distance);
    return lobe_max(lobe_max(left, right), height / lobe_thin_distance_squared(across, start, end));
}

// WGSL only: Rust has it as a closure.
fn lobe_thin_distance_squared(across: f32, start: f32, end: f32) -> f32 {
    let along = lobe_max(lobe_max(start, -end), 0.0);
    return 1.0 + across * across + along * along;
}

// WGSL only: Rust has it as a closure.
fn lobe_thin_triangle(
    height_squared: f32, shear_squared: f32, apex: f32, apex_n: f32, distance_squared: f32
) -> f32 {
    let corner = (1.0 + apex * apex + apex_n * apex_n) / shear_squared;
    return height_squared * lobe_min(corner, 1.0 / distance_squared);
}

// Rust: `mean`, by a rule of four or eight nodes.
fn lobe_thin_mean(p: LobeFrame, count: u32) -> f32 {
    let near = p.nearness <= 9.0 && p.height * p.height <= 9.0 && p.extent <= 1e6;
    return lobe_thin_mean_of(p, count, near);
}

// Rust: `mean_of`.
fn lobe_thin_mean_of(p: LobeFrame, count: u32, near: bool) -> f32 {
    if p.shear * p.shear <= LOBE_THIN_SLIDE * p.nearness {
        let left = 0.5 * (p.low.x + p.high.x);
        let right = 0.5 * (p.low.y + p.high.y);
        var mean = 0.0;
        for (var k = 0u; k < count; k++) {
            let point = lobe_gauss_point(count, k);
            let slide = point.x * p.shear;
            let d = p.n + point.x * p.height;
            mean = mean
                + point.y * lobe_segment_mean(near, d, left + slide, right + slide, p.extent);
        }
        return mean;
    }
    let start = p.high.x;
    let end = p.low.y;
    let reach = 1.0 + p.n * p.n + lobe_max(start * start, end * end);
    let short = p.square * p.square <= 0.0025000000000000005 * reach;
    let midpoint = 0.5 * (start + end);
    var middle = 0.0;
    for (var k = 0u; k < count; k++) {
        let point = lobe_gauss_point(count, k);
        let d = p.n + point.x * p.height;
        var fiber = 0.0;
        if short {
            let x = midpoint + LOBE_GAUSS_FOUR * p.square;
            fiber = lobe_gauss_mean(vec4f(
                lobe_segment_unit_density(x.x, d), lobe_segment_unit_density(x.y, d),
                lobe_segment_unit_density(x.z, d), lobe_segment_unit_density(x.w, d)
            ));
        } else {
            fiber = lobe_segment_mean(near, d, start, end, p.square);
        }
        middle = middle + point.y * fiber;
    }
    var triangles = 0.0;
    for (var k = 0u; k < 2u * count; k++) {
        let right = k >= count;
        let point = lobe_gauss_point(count, select(k, k - count, right));
        let apex = select(vec2f(p.low.x, p.low_n), vec2f(-p.high.y, -p.high_n), right);
        let fiber = lobe_thin_triangle_fiber(p, apex, select(start, -end, right), point.x);
        triangles = triangles
            + point.y * lobe_segment_apex(near, fiber.x, fiber.y, fiber.z, fiber.w);
    }
    return (middle * p.square + triangles * (0.5 * p.shear)) / p.extent;
}

// Rust: `triangle_fiber`.
fn lobe_thin_triangle_fiber(p: LobeFrame, apex: vec2f, base: f32, y: f32) -> vec4f {
    let rise = (y + 0.5) * p.height;
    let inverse = 1.0 / sqrt(p.shear * p.shear + rise * rise);
    let run = p.shear * inverse;
    let climb = rise * inverse;
    let end = vec2f(base, apex.y + rise);
    let first = apex.x * run + apex.y * climb;
    let last = end.x * run + end.y * climb;
    let nearer = select(end, apex, abs(first) < abs(last));
    return vec4f(nearer.x * climb - nearer.y * run, first, last, run * p.shear + climb * rise);
}
