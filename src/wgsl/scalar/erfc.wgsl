// The complementary error function: plain, scaled, integrated. Rust: src/scalar/erfc.rs.

// Rust: `POLE_F32`.
const LOBE_POLE: f32 = 2.59375;
// Rust: `ERFCX_F32`.
const LOBE_ERFCX = array<f32, 11>(
    0.6774364, 0.4057409, 0.32309836, 0.08323377, -0.21126273, -0.364964, -0.25129977, 0.024642756,
    0.16134803,
    0.027223475, -0.06662326
);
// Rust: `IERFCX_F32`.
const LOBE_IERFCX = array<f32, 13>(
    0.3220661, 0.09853005, -0.113223255, -0.37364957, -0.36612687, 0.13891988, 0.83985704,
    0.95744056, 0.08884888,
    -0.8258443, -0.23558383, 0.62090355, -0.18247999
);
// Rust: `IERFC_EXCESS_F32`.
const LOBE_IERFC_EXCESS = array<f32, 8>(
    0.7511255, -0.21436854, 0.033407684, -3.9844275e-3, 4.1338248e-4, -3.5598474e-5, 2.07112e-6,
    -5.561211e-8
);
// Rust: `IERFC_EXCESS_END_F32`.
const LOBE_IERFC_EXCESS_END: f32 = 11.5;

// Rust: `Real::erfcx`. Its value at 0 for what is not at least 0.
fn lobe_erfcx(x: f32) -> f32 {
    let a = lobe_max(x, 0.0);
    let u = LOBE_POLE / (LOBE_POLE + a) - 0.375;
    let c = LOBE_ERFCX;
    let high = (((c[10] * u + c[9]) * u + c[8]) * u + c[7]) * u + c[6];
    let middle = (((high * u + c[5]) * u + c[4]) * u + c[3]) * u + c[2];
    let p = (middle * u + c[1]) * u + c[0];
    return p / (1.0 + a);
}

// Rust: `Real::ierfcx`. Its value at 0 for what is not at least 0.
fn lobe_ierfcx(x: f32) -> f32 {
    let a = lobe_max(x, 0.0);
    let u = LOBE_POLE / (LOBE_POLE + a) - 0.375;
    let c = LOBE_IERFCX;
    let high = (((c[12] * u + c[11]) * u + c[10]) * u + c[9]) * u + c[8];
    let middle = (((high * u + c[7]) * u + c[6]) * u + c[5]) * u + c[4];
    let p = (((middle * u + c[3]) * u + c[2]) * u + c[1]) * u + c[0];
    return p / (a * (a + 0.875) + 0.5);
}

// Rust: `Real::ierfc_excess`. Its value at 0 for what is not at least 0.
fn lobe_ierfc_excess(x: f32) -> f32 {
    let w = lobe_min(lobe_max(x, 0.0), LOBE_IERFC_EXCESS_END);
    let c = LOBE_IERFC_EXCESS;
    let squared = w * w;
    let high = (c[7] * w + c[6]) * squared + (c[5] * w + c[4]);
    let low = (c[3] * w + c[2]) * squared + (c[1] * w + c[0]);
    let p = high * (squared * squared) + low;
    let square = p * p;
    return square * square;
}

// Rust: `Real::erfc`. 0 for NaN.
fn lobe_erfc(x: f32) -> f32 {
    let size = abs(x);
    let a = select(size, 11.0, size > 11.0);
    let high = bitcast<f32>(bitcast<u32>(a) & 0xfffff000u);
    let e = lobe_exp_difference(-high * high, (a - high) * (a + high)) * lobe_erfcx(a);
    return lobe_defined(select(e, 2.0 - e, x < 0.0));
}
