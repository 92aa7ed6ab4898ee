// The arc tangent, of a number and of a direction. Rust: src/scalar/atan.rs.

// Rust: `ATAN_F32`.
const LOBE_ATAN = array<f32, 9>(
    -0.333333, 0.19998549, -0.14264242, 0.1095219, -0.084034644, 0.05795783, -0.03117808,
    0.010914729, -1.7936486e-3
);
// Rust: `ATAN_EXCESS_F32`.
const LOBE_ATAN_EXCESS = array<f32, 11>(
    0.6666667, -0.79999816, 0.8570686, -0.8876958, 0.8990189, -0.87184334, 0.76299, -0.5491694,
    0.28978252, -0.09619671,
    0.014774918
);
// Rust: `HALF_PI_PARTS_F32`.
const LOBE_HALF_PI_PARTS = array<f32, 2>(1.5707964, -4.371139e-8);
// Rust: `PI_PARTS_F32`.
const LOBE_PI_PARTS = array<f32, 2>(3.1415927, -8.742278e-8);

// Rust: `Real::atan`. 0 for NaN.
fn lobe_atan(x: f32) -> f32 {
    let a = lobe_upper_angle(abs(x), 1.0);
    return lobe_defined(bitcast<f32>(bitcast<u32>(a) | (bitcast<u32>(x) & 0x80000000u)));
}

// Rust: `Real::atan2`, with its arguments in that order: y, x. 0 for NaN and for two infinities.
fn lobe_atan_of(y: f32, x: f32) -> f32 {
    let upper = lobe_upper_angle(abs(y), x);
    let angle = select(lobe_defined(upper), 0.0, y == 0.0 && x == 0.0);
    return select(angle, -angle, y < 0.0);
}

// Rust: `upper_angle_f32`.
fn lobe_upper_angle(y: f32, x: f32) -> f32 {
    let width = abs(x);
    let steep = y > width;
    let t = select(y, width, steep) / select(width, y, steep);
    let s = t * t;
    let c = LOBE_ATAN;
    let square = s * s;
    let fourth = (s * s) * (s * s);
    let bottom = (c[0] + c[1] * s) + (c[2] + c[3] * s) * square;
    let top = (c[4] + c[5] * s) + (c[6] + c[7] * s) * square;
    let p = bottom + (top + c[8] * fourth) * fourth;
    let near = p * s * t + t;
    let back = x < 0.0;
    let a = select(-near, near, steep == back);
    let base = select(select(0.0, LOBE_PI_PARTS[0], back), LOBE_HALF_PI_PARTS[0], steep);
    let base_low = select(select(0.0, LOBE_PI_PARTS[1], back), LOBE_HALF_PI_PARTS[1], steep);
    return base + (a + base_low);
}

// Rust: `atan_excess_f32`.
fn lobe_atan_excess(x: f32) -> f32 {
    let s = x * x;
    let c = LOBE_ATAN_EXCESS;
    let first = (((c[10] * s + c[9]) * s + c[8]) * s + c[7]) * s + c[6];
    let p = (((first * s + c[5]) * s + c[4]) * s + c[3]) * s + c[2];
    return ((p * s + c[1]) * s + c[0]) * s * x;
}
