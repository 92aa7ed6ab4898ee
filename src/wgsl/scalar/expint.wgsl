// The exponential integral, in the one form that filters ask for. Rust: src/scalar/expint.rs.

// Rust: `EULER`.
const LOBE_EULER: f32 = 0.5772156649015329;

// Rust: `reciprocal_e2_tail`.
fn lobe_expint_reciprocal_tail(x: f32) -> f32 {
    if x < 1.0 {
        return lobe_expint_by_series(x);
    }
    var tail = 0.0;
    for (var k = 32; k >= 1; k--) {
        tail = f32(k * (k + 1)) / (x + f32(2 * k + 2) - tail);
    }
    return 2.0 - lobe_max(tail, 0.0);
}

// Rust: `by_series`.
fn lobe_expint_by_series(x: f32) -> f32 {
    if !(x >= LOBE_MIN_POSITIVE) {
        return 1.0;
    }
    var power = 1.0;
    var sum = 0.0;
    for (var k = 1; k <= 11; k++) {
        power = -(power * x) / f32(k);
        sum = sum + power / f32(k);
    }
    let integral = -(LOBE_EULER + lobe_ln(x) + sum);
    return 1.0 / (1.0 - x * lobe_exp(x) * integral) - x;
}
