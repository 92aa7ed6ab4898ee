//! The exponential function, by plain arithmetic in a fixed order.
//!
//! Layer 0. Selects instead of branches, for lanes and for shaders.

use super::single::Single;

/// Coefficients of (exp(r) - 1 - r)/r^2 in r, |r| <= 0.3475 (a little over ln(2)/2).
///
/// Maximal error relative to exp(r): 4.03e-9 (2^-27.89), at r = -0.3475.
/// Fitted by `tests/golden/fit.py`, `fit_exp("exp_f32", ...)`.
const EXP_F32: [f32; 5] = [0.499_999_94, 0.166_665_2, 0.041_668_408, 8.368_899e-3, 1.381_421_8e-3];

/// Coefficients of (exp(r) - 1 - r)/r^2 in r, |r| <= 0.3475 (a little over ln(2)/2).
///
/// Maximal error relative to exp(r): 1.49e-18 (2^-59.21), at r = -0.3432.
/// Fitted by `tests/golden/fit.py`, `fit_exp("exp_f64", ...)`.
const EXP_F64: [f64; 11] = [
    0.5,
    0.166_666_666_666_666_85,
    0.041_666_666_666_666_08,
    8.333_333_333_316_689e-3,
    1.388_888_888_911_988_5e-3,
    1.984_126_989_725_994_7e-4,
    2.480_158_692_182_197_7e-5,
    2.755_723_396_827_845_4e-6,
    2.755_758_357_265_933e-7,
    2.511_235_399_813_925_4e-8,
    2.082_671_167_596_947e-9,
];

/// Coefficients of (2^r - 1)/r in r, |r| <= 1/2.
///
/// Maximal error relative to 2^r: 1.09e-7 (2^-23.13), at r = -0.5.
/// Fitted by `tests/golden/fit.py`, `fit_exp2("exp2_f32", ...)`.
#[expect(clippy::approx_constant, reason = "a fitted coefficient near ln(2)")]
const EXP2_F32: [f32; 5] = [0.693_147, 0.240_222_42, 0.055_507_336, 9.671_509e-3, 1.326_476e-3];

/// ln(2) in two parts: the first has 15 significant bits, so that its product with k is exact.
///
/// Together they miss ln(2) by 5.5e-14. Split by `tests/golden/fit.py`, `split("ln_two_f32", ...)`.
pub(super) const LN_TWO_F32: [f32; 2] = [0.693_145_75, 1.428_606_8e-6];

/// ln(2) in two parts: the first has 32 significant bits, so that its product with k is exact.
///
/// Together they miss ln(2) by 1.3e-27. Split by `tests/golden/fit.py`, `split("ln_two_f64", ...)`.
pub(super) const LN_TWO_F64: [f64; 2] = [0.693_147_180_601_954_5, -4.200_915_072_681_084_6e-11];

/// 1.5 * 2^23: adding it rounds to the nearest integer and leaves that integer in the low bits.
const ROUNDER_F32: f32 = 12_582_912.0;

/// 1.5 * 2^52, likewise.
const ROUNDER_F64: f64 = 6_755_399_441_055_744.0;

/// The exponential function, exp(x) = 2^k exp(r) with x = k ln(2) + r.
///
/// All x: infinity from 88.72284 on, subnormal results (flushed or not, as the machine does) below
/// -87.33655, 0 below -103.98; exp(-inf) = 0, exp(inf) = inf, NaN gives NaN. Measured error: at
/// most 0.9 ulp (at 4.506177; tests/laws/certificates.rs), 0.75 of the smallest number where the
/// result is subnormal.
#[inline(always)]
pub(crate) fn exp_f32<S: Single>(x: S) -> S {
    exp_difference_f32(x, S::ZERO)
}

/// exp(x - d) for a small correction d that x has no digits for.
///
/// All x, |d| <= 0.1; error and limits as those of `exp_f32`, where x - d is exact.
#[inline(always)]
pub(crate) fn exp_difference_f32<S: Single>(x: S, d: S) -> S {
    let largest = S::of(89.0);
    let x = if x > largest { largest } else { x };
    // Results that are 0 are computed as 1: subnormal intermediates cost a hundred cycles each.
    let vanishes = x < S::of(-104.0);
    let x = if vanishes { S::ZERO } else { x };
    // x - d = k ln(2) + r.
    let rounder = S::of(ROUNDER_F32);
    let shifted = ((x - d) * S::of(core::f32::consts::LOG2_E) + rounder).kept();
    let k = shifted - rounder;
    // r = high - low, kept in two parts for the linear term.
    let high = (x - k * S::of(LN_TWO_F32[0])).kept();
    let low = k * S::of(LN_TWO_F32[1]) + d;
    let r = high - low;
    let c = |n: usize| S::of(EXP_F32[n]);
    let p = (((c(4) * r + c(3)) * r + c(2)) * r + c(1)) * r + c(0);
    let p = (high + (p * (r * r) - low)) + S::ONE;
    // 2^k in two factors, for neither the largest nor the subnormal results have it in one.
    let biased = shifted.bits().wrapping_sub(ROUNDER_F32.to_bits()).wrapping_add(254);
    let half = biased >> 1;
    let e = (p * S::of_bits(half << 23)).kept() * S::of_bits(biased.wrapping_sub(half) << 23);
    if vanishes { S::ZERO } else { e }
}

/// 2^x for x <= 0, in half of the operations of `exp_f32`: one scale, a shorter polynomial.
///
/// 0 below -126, where results are about to turn subnormal, and for NaN. Measured error: at most
/// 2.59 ulp (at -34.4999).
#[inline(always)]
pub(crate) fn exp2_of_negative_f32<S: Single>(x: S) -> S {
    let (least, rounder) = (S::of(-126.0), S::of(ROUNDER_F32));
    let bounded = x.max(least);
    let shifted = (bounded + rounder).kept();
    let r = bounded - (shifted - rounder).kept();
    let c = |n: usize| S::of(EXP2_F32[n]);
    // Estrin's scheme: its chain of dependent operations is shorter than that of Horner's rule.
    let square = r * r;
    let p = ((c(4) * r + c(3)) * square + (c(2) * r + c(1))) * square + (c(0) * r + S::ONE);
    // The low bits of the shifted number are its integer: they go to the exponent, and the others
    // beyond.
    let e = S::of_bits(p.bits().wrapping_add(shifted.bits() << 23));
    if x >= least { e } else { S::ZERO }
}

/// The product of two numbers that are not negative; 0 where it is too small for a normal number.
///
/// Machines that do not flush take a hundred cycles for a product that is subnormal or too small
/// even for that. The sum of the bits is near the logarithm of the product, and never above it.
#[inline(always)]
pub(crate) fn product_or_zero_f32<S: Single>(a: S, b: S) -> S {
    let has_digits = a.bits().wrapping_add(b.bits()) >= 127 << 23;
    a * if has_digits { b } else { S::ZERO }
}

/// The exponential function, exp(x) = 2^k exp(r) with x = k ln(2) + r.
///
/// All x: infinity above 709.7827, subnormal results below -708.3964, 0 below -745.14;
/// exp(-inf) = 0, exp(inf) = inf, NaN gives NaN. Measured error: at most 0.853 ulp (at
/// -450.871).
#[inline]
pub(crate) fn exp_f64(x: f64) -> f64 {
    exp_difference_f64(x, 0.0)
}

/// exp(x - d) for a small correction d that x has no digits for.
///
/// All x, |d| <= 0.1; error and limits as those of `exp_f64`, where x - d is exact.
#[inline]
pub(crate) fn exp_difference_f64(x: f64, d: f64) -> f64 {
    let x = if x > 710.0 { 710.0 } else { x };
    let vanishes = x < -746.0;
    let x = if vanishes { 0.0 } else { x };
    let shifted = (x - d) * core::f64::consts::LOG2_E + ROUNDER_F64;
    let k = shifted - ROUNDER_F64;
    let high = x - k * LN_TWO_F64[0];
    let low = k * LN_TWO_F64[1] + d;
    let r = high - low;
    let p = (high + (polynomial_f64(&EXP_F64, r) * (r * r) - low)) + 1.0;
    let biased = shifted.to_bits().wrapping_sub(ROUNDER_F64.to_bits()).wrapping_add(2046);
    let half = biased >> 1;
    let e = (p * f64::from_bits(half << 52)) * f64::from_bits(biased.wrapping_sub(half) << 52);
    if vanishes { 0.0 } else { e }
}

/// 2^x for x <= 0.
///
/// 0 below -1022, where results are about to turn subnormal, and for NaN.
#[inline]
pub(crate) fn exp2_of_negative_f64(x: f64) -> f64 {
    let bounded = if x > -1022.0 { x } else { -1022.0 };
    let shifted = bounded + ROUNDER_F64;
    let r = (bounded - (shifted - ROUNDER_F64)) * core::f64::consts::LN_2;
    let p = (r + polynomial_f64(&EXP_F64, r) * (r * r)) + 1.0;
    let e = f64::from_bits(p.to_bits().wrapping_add(shifted.to_bits() << 52));
    if x >= -1022.0 { e } else { 0.0 }
}

/// The polynomial with the given coefficients, constant first, by Horner's rule.
#[inline]
pub(crate) fn polynomial_f64<const N: usize>(coefficients: &[f64; N], v: f64) -> f64 {
    let mut sum = 0.0;
    for c in coefficients.iter().rev() {
        sum = sum * v + c;
    }
    sum
}
