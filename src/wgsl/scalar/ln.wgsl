// The natural logarithm, by plain arithmetic in a fixed order. Rust: src/scalar/ln.rs.

// Rust: `LN_F32`.
const LOBE_LN = array<f32, 3>(0.66666776, 0.3997757, 0.29871044);

// Rust: `Real::ln`. The negative of the largest number for 0 and below, which have no logarithm; 0
// for NaN.
fn lobe_ln(x: f32) -> f32 {
    let small = x < LOBE_MIN_POSITIVE;
    let bits = bitcast<u32>(select(x, x * 8388608.0, small));
    let shifted = bits + (0x3f800000u - 0x3f3504f3u);
    let k = f32(shifted >> 23u) - select(127.0, 150.0, small);
    let f = bitcast<f32>((shifted & 0x007fffffu) + 0x3f3504f3u) - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let c = LOBE_LN;
    let rest = z * ((c[2] * z + c[1]) * z + c[0]);
    let half_square = 0.5 * f * f;
    let low = half_square - (s * (half_square + rest) + k * LOBE_LN_TWO[1]);
    let ln = k * LOBE_LN_TWO[0] - (low - f);
    return select(lobe_ln_edge(x), ln, x > 0.0 && lobe_is_finite(x));
}

// Rust: `edge_f32`.
fn lobe_ln_edge(x: f32) -> f32 {
    return select(select(0.0, -LOBE_MAX, x <= 0.0), x, x > 0.0);
}
