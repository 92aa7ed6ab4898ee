//! The natural logarithm, by plain arithmetic in a fixed order.
//!
//! Layer 0. Selects instead of branches, for lanes and for shaders.

use super::exp::{LN_TWO_F32, LN_TWO_F64, polynomial_f64};
use super::single::Single;

/// Coefficients of (ln((1 + s)/(1 - s)) - 2 s)/s^3 in z = s^2, 0 <= z <= 0.02944 (a little over 3 -
/// 2 sqrt(2), squared).
///
/// Maximal error relative to the logarithm: 8.25e-10 (2^-30.17), at z = 0.02944.
/// Fitted by `tests/golden/fit.py`, `fit_ln("ln_f32", ...)`.
const LN_F32: [f32; 3] = [0.666_667_76, 0.399_775_7, 0.298_710_44];

/// Coefficients of (ln((1 + s)/(1 - s)) - 2 s)/s^3 in z = s^2, 0 <= z <= 0.02944 (a little over 3 -
/// 2 sqrt(2), squared).
///
/// Maximal error relative to the logarithm: 1.53e-18 (2^-59.19), at z = 0.0251.
/// Fitted by `tests/golden/fit.py`, `fit_ln("ln_f64", ...)`.
const LN_F64: [f64; 7] = [
    0.666_666_666_666_673_4,
    0.399_999_999_994_158_36,
    0.285_714_287_421_236_8,
    0.222_221_985_991_637_14,
    0.181_835_630_497_803_82,
    0.153_140_813_959_959_74,
    0.147_956_585_715_079_1,
];

/// The natural logarithm, ln(x) = k ln(2) + ln(1 + f) with 1 + f from sqrt(1/2) to sqrt(2).
///
/// All x: -infinity at 0, NaN below, infinity at infinity; subnormal numbers included. Measured
/// error: at most 0.84 ulp (at 1.413319; tests/laws/certificates.rs).
#[inline(always)]
pub(crate) fn ln_f32<S: Single>(x: S) -> S {
    const ROOT_HALF: u32 = 0x3F35_04F3;
    const ONE: u32 = 0x3F80_0000;
    let small = x < S::MIN_POSITIVE;
    let bits = (if small { x * S::of(8_388_608.0) } else { x }).bits();
    let shifted = bits.wrapping_add(ONE - ROOT_HALF);
    let k = S::of((shifted >> 23) as f32) - S::of(if small { 150.0 } else { 127.0 });
    let f = S::of_bits((shifted & 0x007F_FFFF) + ROOT_HALF) - S::ONE;
    let s = f / (S::TWO + f);
    let z = s * s;
    let c = |n: usize| S::of(LN_F32[n]);
    let rest = z * ((c(2) * z + c(1)) * z + c(0));
    let half_square = S::HALF * f * f;
    // f - f^2/2 + ...: the large terms last.
    let low = half_square - (s * (half_square + rest) + k * S::of(LN_TWO_F32[1]));
    let ln = k * S::of(LN_TWO_F32[0]) - (low - f);
    if x > S::ZERO && x <= S::MAX { ln } else { edge_f32(x) }
}

/// The natural logarithm, as [`ln_f32`]. Measured error: 0.85 ulp (at 0.707103) over 4 million
/// random numbers against mpmath; tests/laws/scalar.rs holds one rounding.
#[inline]
pub(crate) fn ln_f64(x: f64) -> f64 {
    const ROOT_HALF: u64 = 0x3FE6_A09E_667F_3BCD;
    const ONE: u64 = 0x3FF0_0000_0000_0000;
    let small = x < f64::MIN_POSITIVE;
    let bits = (if small { x * 4_503_599_627_370_496.0 } else { x }).to_bits();
    let shifted = bits.wrapping_add(ONE - ROOT_HALF);
    let k = (shifted >> 52) as f64 - if small { 1075.0 } else { 1023.0 };
    let f = f64::from_bits((shifted & 0x000F_FFFF_FFFF_FFFF) + ROOT_HALF) - 1.0;
    let s = f / (2.0 + f);
    let z = s * s;
    let rest = z * polynomial_f64(&LN_F64, z);
    let half_square = 0.5 * f * f;
    let low = half_square - (s * (half_square + rest) + k * LN_TWO_F64[1]);
    let ln = k * LN_TWO_F64[0] - (low - f);
    if x > 0.0 && x <= f64::MAX { ln } else { edge_f64(x) }
}

/// The logarithm of what is not a positive finite number.
#[inline(always)]
fn edge_f32<S: Single>(x: S) -> S {
    let below = S::of(if x == S::ZERO { f32::NEG_INFINITY } else { f32::NAN });
    if x > S::ZERO { x } else { below }
}

/// The same in f64.
#[inline(always)]
fn edge_f64(x: f64) -> f64 {
    let below = if x == 0.0 { f64::NEG_INFINITY } else { f64::NAN };
    if x > 0.0 { x } else { below }
}
