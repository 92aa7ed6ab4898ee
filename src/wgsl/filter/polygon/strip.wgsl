// Footprints that are narrow against the distance to the lobe. Rust: src/filter/polygon/strip.rs.

// Rust: `LONG`.
const LOBE_STRIP_LONG: f32 = 32.0;

// Rust: `Whitened`.
struct LobeWhitened {
    midpoint: vec2f,
    u: vec2f,
    v: vec2f,
}

// Rust: `dot`.
fn lobe_strip_dot(a: vec2f, b: vec2f) -> f32 {
    return a.x * b.x + a.y * b.y;
}

// Rust: `Whitened::new`.
fn lobe_whitened_new(
    shape: LobeAnisotropic, offset: vec2f, low: vec2f, footprint: LobeFootprint
) -> LobeWhitened {
    let zero = vec2f(0.0, 0.0);
    return LobeWhitened(
        lobe_anisotropic_whiten(shape, offset, low),
        lobe_anisotropic_whiten(shape, footprint.u, zero),
        lobe_anisotropic_whiten(shape, footprint.v, zero)
    );
}

// Rust: `Whitened::is_swapped`.
fn lobe_whitened_is_swapped(w: LobeWhitened) -> bool {
    return lobe_strip_dot(w.v, w.v) > lobe_strip_dot(w.u, w.u);
}

// Rust: `Strip`.
struct LobeStrip {
    start: f32,
    end: f32,
    n: f32,
    axis: vec2f,
    extent: f32,
    lean: f32,
    rise: f32,
    nearness: f32,
}

// Rust: `nearness`.
fn lobe_strip_nearness(along: vec2f, across: vec2f) -> f32 {
    let t = lobe_max(lobe_max(along.x, -along.y), 0.0);
    let n = lobe_max(lobe_max(across.x, -across.y), 0.0);
    return 1.0 + t * t + n * n;
}

// Rust: `Strip::new`.
fn lobe_strip_new(w: LobeWhitened) -> LobeStrip {
    let swap = lobe_whitened_is_swapped(w);
    let a = select(w.u, w.v, swap);
    let b = select(w.v, w.u, swap);
    let length = sqrt(lobe_strip_dot(a, a));
    let inverse = 1.0 / length;
    let axis = vec2f(a.x * inverse, a.y * inverse);
    let turned = vec2f(-a.y * inverse, a.x * inverse);
    let first = vec2f(w.midpoint.x - 0.5 * a.x, w.midpoint.y - 0.5 * a.y);
    let last = vec2f(w.midpoint.x + 0.5 * a.x, w.midpoint.y + 0.5 * a.y);
    let start = lobe_strip_dot(axis, first);
    let end = lobe_strip_dot(axis, last);
    let closer = select(last, first, abs(start) < abs(end));
    let n = lobe_strip_dot(turned, select(closer, w.midpoint, start * end < 0.0));
    let strip = LobeStrip(
        start, end, n, axis, length, lobe_strip_dot(axis, b), lobe_strip_dot(turned, b), 1.0
    );
    return lobe_strip_placed(strip);
}

// Rust: `Strip::placed`.
fn lobe_strip_placed(strip: LobeStrip) -> LobeStrip {
    let slide = 0.5 * abs(strip.lean);
    let climb = 0.5 * abs(strip.rise);
    var placed = strip;
    placed.nearness = lobe_strip_nearness(
        vec2f(strip.start - slide, strip.end + slide), vec2f(strip.n - climb, strip.n + climb)
    );
    return placed;
}

// Rust: `Strip::sharpened_mean`, up to the mean: the strip with its ends and distance from slope
// space.
fn lobe_strip_sharpened(
    strip: LobeStrip, w: LobeWhitened, shape: LobeAnisotropic, offset: vec2f, offset_low: vec2f,
    footprint: LobeFootprint
) -> LobeStrip {
    let a = select(footprint.u, footprint.v, lobe_whitened_is_swapped(w));
    var sharpened = strip;
    sharpened.start = lobe_strip_end(
        strip.axis, shape, offset, offset_low, vec2f(-0.5 * a.x, -0.5 * a.y)
    );
    sharpened.end = lobe_strip_end(
        strip.axis, shape, offset, offset_low, vec2f(0.5 * a.x, 0.5 * a.y)
    );
    let low = a.x * offset_low.y - a.y * offset_low.x;
    sharpened.n = (lobe_cross(a, offset) + low) / (shape.root_det * strip.extent);
    return lobe_strip_placed(sharpened);
}

// WGSL only: Rust has it as a closure.
fn lobe_strip_end(
    axis: vec2f, shape: LobeAnisotropic, offset: vec2f, offset_low: vec2f, half: vec2f
) -> f32 {
    let first_x = lobe_two_sum(offset.x, half.x);
    let first_y = lobe_two_sum(offset.y, half.y);
    let x = lobe_two_sum(first_x.x, first_x.y + offset_low.x);
    let y = lobe_two_sum(first_y.x, first_y.y + offset_low.y);
    return lobe_strip_dot(axis, lobe_anisotropic_whiten(shape, vec2f(x.x, y.x), vec2f(x.y, y.y)));
}

// Rust: `Strip::keeps_digits`.
fn lobe_strip_keeps_digits(strip: LobeStrip) -> bool {
    return strip.extent * strip.extent <= LOBE_STRIP_LONG * LOBE_STRIP_LONG * strip.nearness;
}

// Rust: `Strip::is_narrow`.
fn lobe_strip_is_narrow(strip: LobeStrip) -> bool {
    return strip.lean * strip.lean + strip.rise * strip.rise <= 0.25 * strip.nearness;
}

// Rust: `Strip::mean`.
fn lobe_strip_mean(strip: LobeStrip) -> f32 {
    let near = strip.nearness <= 9.0 && strip.extent <= 1e6;
    var values = vec4f(0.0, 0.0, 0.0, 0.0);
    for (var k = 0u; k < 4u; k++) {
        let y = lobe_gauss_point(4u, k).x;
        let slide = y * strip.lean;
        let d = strip.n + y * strip.rise;
        values[k] = lobe_segment_mean(
            near, d, strip.start + slide, strip.end + slide, strip.extent
        );
    }
    return lobe_gauss_mean(values);
}
