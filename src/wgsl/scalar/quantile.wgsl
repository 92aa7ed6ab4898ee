// Quantiles of the standard normal distribution. Rust: src/scalar/quantile.rs.

// Rust: `QUANTILE`.
const LOBE_QUANTILE = array<f32, 10>(
    2.8804495, 6.273712, 5.6879573, 3.2061503, 13.248417, 26.726229, -4.0470843, -19.790651,
    134.69165, 212.40358
);

// Rust: `normal_quantile`. NaN counts as the smallest number.
fn lobe_normal_quantile(probability: f32) -> f32 {
    let v = lobe_min(lobe_max(probability, 5.820766e-11), 0.99999994);
    let w = -lobe_ln(4.0 * v * (1.0 - v));
    let t = w / (w + 8.0) - 0.375;
    let c = LOBE_QUANTILE;
    let high = (((c[9] * t + c[8]) * t + c[7]) * t + c[6]) * t + c[5];
    return (1.0 - 2.0 * v) * (((((high * t + c[4]) * t + c[3]) * t + c[2]) * t + c[1]) * t + c[0]);
}
