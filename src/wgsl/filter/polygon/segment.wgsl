// The unit GGX density, and its means along a segment. Rust: src/filter/polygon/segment.rs.

// Rust: `unit_density`.
fn lobe_segment_unit_density(x: f32, y: f32) -> f32 {
    let inverse = 1.0 / (1.0 + x * x + y * y);
    return inverse * inverse * LOBE_INVERSE_PI;
}

// Rust: `tail`.
fn lobe_segment_tail(s: f32, t: f32) -> f32 {
    let far = abs(t);
    let x = lobe_min(s, far) / lobe_max(s, far);
    let excess = lobe_atan_excess(x);
    let complement = 0.5 * LOBE_PI - excess - 2.0 * x / (1.0 + x * x);
    return select(complement, excess, s <= far);
}

// Rust: `integral`.
fn lobe_segment_integral(s: f32, start: f32, end: f32) -> f32 {
    let head = lobe_segment_tail(s, start);
    let last = lobe_segment_tail(s, end);
    return select(LOBE_PI - head - last, abs(head - last), start * end > 0.0);
}

// WGSL only: Rust chooses between two functions.
fn lobe_segment_mean(near: bool, d: f32, start: f32, end: f32, length: f32) -> f32 {
    if near {
        return lobe_segment_near_mean(d, start, end, length);
    }
    return lobe_segment_uniform_mean(d, start, end, length);
}

// Rust: `uniform_mean`.
fn lobe_segment_uniform_mean(d: f32, start: f32, end: f32, length: f32) -> f32 {
    let q = 1.0 + d * d;
    let s = sqrt(q);
    return lobe_segment_integral(s, start, end) / (2.0 * LOBE_PI * q * s * length);
}

// Rust: `near_mean`.
fn lobe_segment_near_mean(d: f32, start: f32, end: f32, length: f32) -> f32 {
    let q = 1.0 + d * d;
    let s = sqrt(q);
    let product = start * end;
    let run = length * s;
    let ends = (q + start * start) * (q + end * end);
    let sum = run * (q - product) + ends * lobe_upper_angle(run, q + product);
    return lobe_max(sum / (2.0 * LOBE_PI * q * run * ends), 0.0);
}

// WGSL only: Rust chooses between two functions.
fn lobe_segment_apex(near: bool, d: f32, start: f32, end: f32, length: f32) -> f32 {
    if near {
        return lobe_segment_near_apex_mean(d, start, end, length);
    }
    return lobe_segment_apex_mean(d, start, end, length);
}

// Rust: `near_apex_mean`.
fn lobe_segment_near_apex_mean(d: f32, start: f32, end: f32, length: f32) -> f32 {
    let q = 1.0 + d * d;
    let s = sqrt(q);
    let run = length * s;
    let base = q + end * end;
    let sum = run * end - start * base * lobe_upper_angle(run, q + start * end);
    return lobe_max(sum / (LOBE_PI * q * s * base * (length * length)), 0.0);
}

// Rust: `apex_mean`.
fn lobe_segment_apex_mean(d: f32, start: f32, end: f32, length: f32) -> f32 {
    let q = 1.0 + d * d;
    let s = sqrt(q);
    let ends = length * (start + end) / (2.0 * (q + start * start) * (q + end * end));
    let line = lobe_segment_integral(s, start, end) / (2.0 * q * s);
    return lobe_max(2.0 * (ends - start * line) / (LOBE_PI * length * length), 0.0);
}
