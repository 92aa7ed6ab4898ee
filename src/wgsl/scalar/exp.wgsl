// The exponential function, by plain arithmetic in a fixed order. Rust: src/scalar/exp.rs.

// Rust: `EXP_F32`.
const LOBE_EXP = array<f32, 5>(0.49999994, 0.1666652, 0.041668408, 8.368899e-3, 1.3814218e-3);
// Rust: `EXP2_F32`.
const LOBE_EXP_BASE_TWO = array<f32, 5>(
    0.693147, 0.24022242, 0.055507336, 9.671509e-3, 1.326476e-3
);
// Rust: `LN_TWO_F32`.
const LOBE_LN_TWO = array<f32, 2>(0.69314575, 1.4286068e-6);
// Rust: `ROUNDER_F32`.
const LOBE_ROUNDER: f32 = 12582912.0;

// Rust: `Real::exp`. 0 for NaN.
fn lobe_exp(x: f32) -> f32 {
    return lobe_exp_difference(x, 0.0);
}

// Rust: `exp_difference_f32`.
fn lobe_exp_difference(x: f32, d: f32) -> f32 {
    // Also true for NaN.
    let vanishes = !(x >= -104.0);
    let bounded = select(select(x, 89.0, x > 89.0), 0.0, vanishes);
    // log2(e), rounded as core::f32::consts::LOG2_E.
    let shifted = lobe_kept((bounded - d) * 1.442695 + LOBE_ROUNDER);
    let k = shifted - LOBE_ROUNDER;
    let high = lobe_kept(bounded - k * LOBE_LN_TWO[0]);
    let low = k * LOBE_LN_TWO[1] + d;
    let r = high - low;
    let c = LOBE_EXP;
    let p = (((c[4] * r + c[3]) * r + c[2]) * r + c[1]) * r + c[0];
    let q = (high + (p * (r * r) - low)) + 1.0;
    let biased = bitcast<u32>(shifted) - bitcast<u32>(LOBE_ROUNDER) + 254u;
    let half = biased >> 1u;
    let e = lobe_kept(q * bitcast<f32>(half << 23u)) * bitcast<f32>((biased - half) << 23u);
    return select(e, 0.0, vanishes);
}

// Rust: `exp2_of_negative_f32`. 0 for NaN.
fn lobe_exp2_of_negative(x: f32) -> f32 {
    let bounded = lobe_max(x, -126.0);
    let shifted = lobe_kept(bounded + LOBE_ROUNDER);
    let r = bounded - lobe_kept(shifted - LOBE_ROUNDER);
    let c = LOBE_EXP_BASE_TWO;
    let square = r * r;
    let p = ((c[4] * r + c[3]) * square + (c[2] * r + c[1])) * square + (c[0] * r + 1.0);
    let e = bitcast<f32>(bitcast<u32>(p) + (bitcast<u32>(shifted) << 23u));
    return select(0.0, e, x >= -126.0);
}

// Rust: `product_or_zero_f32`.
fn lobe_product_or_zero(a: f32, b: f32) -> f32 {
    return a * select(0.0, b, bitcast<u32>(a) + bitcast<u32>(b) >= 0x3f800000u);
}
