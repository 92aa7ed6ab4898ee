//! The complementary error function, scaled (erfcx), integrated (ierfc), both (ierfcx), and plain.
//!
//! Layer 0. Selects instead of branches, for lanes and for shaders.

use super::exp::{exp_difference_f32, exp_difference_f64, polynomial_f64};
use super::single::Single;

/// The scale of t = pole/(pole + x), which maps 0 <= x <= infinity to 1 >= t >= 0.
///
/// Of the multiples of 1/32 near the best the one whose rounded coefficients are good for both
/// functions, so that the two can share one division.
const POLE_F32: f32 = 2.593_75;

/// Likewise; any value near 4 does.
const POLE_F64: f64 = 4.0;

/// Coefficients of erfcx(x) (1 + x) in u = t - 3/8, t = pole/(pole + x), x >= 0.
///
/// Maximal error relative to the function: 3.1e-8 (2^-24.94), at x = 1.038.
/// Fitted by `tests/golden/fit.py`, `fit_erfcx("erfcx_f32", ...)`.
const ERFCX_F32: [f32; 11] = [
    0.677_436_4,
    0.405_740_9,
    0.323_098_36,
    0.083_233_77,
    -0.211_262_73,
    -0.364_964,
    -0.251_299_77,
    0.024_642_756,
    0.161_348_03,
    0.027_223_475,
    -0.066_623_26,
];

/// Coefficients of ierfcx(x) (1/2 + 7/8 x + x^2) in u = t - 3/8, t = pole/(pole + x), x >= 0.
///
/// Maximal error relative to the function: 3.8e-8 (2^-24.65), at x = 0.04006.
/// Fitted by `tests/golden/fit.py`, `fit_ierfcx("ierfcx_f32", ...)`.
const IERFCX_F32: [f32; 13] = [
    0.322_066_1,
    0.098_530_05,
    -0.113_223_255,
    -0.373_649_57,
    -0.366_126_87,
    0.138_919_88,
    0.839_857_04,
    0.957_440_56,
    0.088_848_88,
    -0.825_844_3,
    -0.235_583_83,
    0.620_903_55,
    -0.182_479_99,
];

/// Coefficients of g(w)^(1/4) in w, 0 <= w <= 11.5, with g(v^2) = (v + ierfc(v))^2 - v^2.
///
/// Maximal error of sqrt(w + g), relative: 7.98e-8 (2^-23.58), at w = 0, no more beyond 11.5, where
/// g keeps its value.
/// Fitted by `tests/golden/fit.py`, `fit_ierfc_excess("ierfc_excess_f32", ...)`.
const IERFC_EXCESS_F32: [f32; 8] = [
    0.751_125_5,
    -0.214_368_54,
    0.033_407_684,
    -3.984_427_5e-3,
    4.133_824_8e-4,
    -3.559_847_4e-5,
    2.071_12e-6,
    -5.561_211e-8,
];

/// Where the polynomial of g ends.
const IERFC_EXCESS_END_F32: f32 = 11.5;

/// Coefficients of erfcx(x) (1 + x) in u = t - 3/8, t = pole/(pole + x), x >= 0.
///
/// Maximal error relative to the function: 6.91e-17 (2^-53.68), at x = 17.63.
/// Fitted by `tests/golden/fit.py`, `fit_erfcx("erfcx_f64", ...)`.
const ERFCX_F64: [f64; 25] = [
    0.641_752_302_068_849_4,
    0.298_745_310_017_155_1,
    0.336_214_888_752_720_7,
    0.309_202_736_992_020_33,
    0.190_607_873_444_631_95,
    -0.020_256_438_863_221_204,
    -0.282_172_820_139_995_56,
    -0.514_730_466_047_322,
    -0.627_913_377_959_528_8,
    -0.570_210_767_058_876_4,
    -0.367_168_838_186_483_4,
    -0.117_770_587_539_484_4,
    0.060_511_082_905_867_72,
    0.105_851_353_076_396_87,
    0.048_640_486_391_953_1,
    -0.023_129_635_890_538_798,
    -0.041_973_560_663_271_67,
    -0.010_552_591_372_424_85,
    0.021_124_077_122_151_47,
    0.016_451_525_874_562_01,
    -9.742_010_638_753_944e-3,
    -0.012_200_262_055_256_75,
    6.212_170_940_956_895e-3,
    3.919_678_442_075_137e-3,
    -2.396_361_376_735_443_3e-3,
];

/// Coefficients of ierfcx(x) (1/2 + 7/8 x + x^2) in u = t - 3/8, t = pole/(pole + x), x >= 0.
///
/// Maximal error relative to the function: 6.49e-17 (2^-53.78), at x = 0.01394.
/// Fitted by `tests/golden/fit.py`, `fit_ierfcx("ierfcx_f64", ...)`.
const IERFCX_F64: [f64; 27] = [
    0.311_983_921_551_607_5,
    0.095_667_637_404_582_06,
    0.018_803_019_645_991_677,
    -0.149_365_952_550_304_6,
    -0.373_991_797_714_045_1,
    -0.537_042_664_163_033_8,
    -0.459_051_425_579_722_45,
    3.342_003_921_671_682_6e-3,
    0.814_949_510_896_358,
    1.678_975_970_137_460_5,
    2.133_771_066_459_525_3,
    1.842_670_401_179_233_4,
    0.896_751_763_958_753_3,
    -0.155_650_869_043_650_75,
    -0.678_029_455_997_067,
    -0.463_094_837_888_018_64,
    0.088_437_301_968_053_73,
    0.367_789_098_947_329_2,
    0.168_298_038_898_387_32,
    -0.172_024_146_042_481,
    -0.223_260_114_141_963_9,
    0.059_756_451_621_448_92,
    0.214_742_437_829_309_57,
    -0.067_076_042_188_603_08,
    -0.136_418_059_860_165_92,
    0.110_601_957_152_713_62,
    -0.025_112_909_586_509_424,
];

/// Coefficients of g(w)^(1/4) in w, 0 <= w <= 31, with g as in `IERFC_EXCESS_F32`.
///
/// Maximal error of sqrt(w + g), relative: 6.5e-17 (2^-53.77), at w = 0; 7.8e-17 beyond 31.
/// Fitted by `tests/golden/fit.py`, `fit_ierfc_excess("ierfc_excess_f64", ...)`.
const IERFC_EXCESS_F64: [f64; 27] = [
    0.751_125_544_464_942_5,
    -0.214_369_850_871_204_64,
    0.033_416_448_154_558_79,
    -4.003_180_474_367_974e-3,
    4.305_971_358_750_082e-4,
    -4.337_763_954_104_086e-5,
    3.917_876_694_041_969e-6,
    -2.882_573_790_508_178e-7,
    1.402_338_110_753_206_2e-8,
    -2.409_178_888_336_978_2e-11,
    -6.100_373_184_441_993e-11,
    1.826_953_869_146_102_4e-12,
    1.048_370_190_793_967e-12,
    -2.386_128_362_683_081_3e-13,
    3.140_541_970_118_129e-14,
    -3.044_000_151_109_024_6e-15,
    2.323_150_517_223_489_6e-16,
    -1.430_334_301_962_349_6e-17,
    7.156_414_224_654_443e-19,
    -2.904_180_814_132_382_4e-20,
    9.476_666_455_118_284e-22,
    -2.448_482_613_069_454_7e-23,
    4.889_958_987_785_336e-25,
    -7.272_050_754_840_927e-27,
    7.572_572_339_373_098e-29,
    -4.921_576_944_560_375e-31,
    1.501_060_274_473_828_7e-33,
];

/// Where the polynomial of g ends.
const IERFC_EXCESS_END_F64: f64 = 31.0;

/// The scaled complementary error function, exp(x^2) erfc(x), for x >= 0.
///
/// For x < 0 use 2 exp(x^2) - erfcx(-x); here the argument is not checked. Measured error: at most
/// 3.16 ulp (at 0.00238).
///
/// Limits: 1 at x = 0, 1/(sqrt(pi) x) for large x, subnormal above 4.8e37, 0 at infinity.
#[inline(always)]
pub(crate) fn erfcx_f32<S: Single>(x: S) -> S {
    let pole = S::of(POLE_F32);
    let u = pole / (pole + x) - S::of(0.375);
    let c = |n: usize| S::of(ERFCX_F32[n]);
    let p = (((c(10) * u + c(9)) * u + c(8)) * u + c(7)) * u + c(6);
    let p = (((p * u + c(5)) * u + c(4)) * u + c(3)) * u + c(2);
    let p = (p * u + c(1)) * u + c(0);
    p / (S::ONE + x)
}

/// exp(x^2) times the integral of erfc from x to infinity, 1/sqrt(pi) - x erfcx(x), for x >= 0.
///
/// Full relative accuracy, for the difference is never formed. For x < 0 use
/// 1/sqrt(pi) - x erfcx(x), where nothing cancels. Measured error up to 1e18: at most 3.69 ulp (at
/// 0.0793).
///
/// Limits: 1/sqrt(pi) at x = 0, 1/(2 sqrt(pi) x^2) for large x; 0 above 1.84e19, where
/// x^2 overflows.
#[inline(always)]
pub(crate) fn ierfcx_f32<S: Single>(x: S) -> S {
    let pole = S::of(POLE_F32);
    let u = pole / (pole + x) - S::of(0.375);
    let c = |n: usize| S::of(IERFCX_F32[n]);
    let p = (((c(12) * u + c(11)) * u + c(10)) * u + c(9)) * u + c(8);
    let p = (((p * u + c(7)) * u + c(6)) * u + c(5)) * u + c(4);
    let p = (((p * u + c(3)) * u + c(2)) * u + c(1)) * u + c(0);
    p / (x * (x + S::of(0.875)) + S::HALF)
}

/// g(w) = ierfc(v) (2 v + ierfc(v)) for w = v^2 >= 0, so that w + g(w) = (v + ierfc(v))^2.
///
/// ierfc(v) = exp(-v^2)/sqrt(pi) - v erfc(v) is the integral of erfc from v to infinity. Since
/// v + ierfc(v) = exp(-v^2)/sqrt(pi) + v erf(v) is even in v, g has a power series in w and takes
/// neither a root nor an exponential. The fourth power of a polynomial is not negative. Measured
/// error: at most 3.03e-7 of sqrt(w + g(w)) (at w = 0.000917).
///
/// Limits: 1/pi at w = 0, 1.5e-6 from 11.5 on.
#[inline(always)]
pub(crate) fn ierfc_excess_f32<S: Single>(w: S) -> S {
    let w = w.min(S::of(IERFC_EXCESS_END_F32));
    let c = |n: usize| S::of(IERFC_EXCESS_F32[n]);
    // Estrin's scheme: its chain of dependent operations is shorter than that of Horner's rule.
    let squared = w * w;
    let high = (c(7) * w + c(6)) * squared + (c(5) * w + c(4));
    let low = (c(3) * w + c(2)) * squared + (c(1) * w + c(0));
    let p = high * (squared * squared) + low;
    let square = p * p;
    square * square
}

/// The complementary error function, erfc(x) = exp(-x^2) erfcx(x) and erfc(-x) = 2 - erfc(x).
///
/// All x; the square is taken in two parts, for its rounding would cost the exponential up to
/// x^2 ulp. NaN gives NaN. Measured error: at most 4.5 ulp for x <= 9 (at 3.058), above that 2.6
/// ulp of the smallest normal number, for the result turns subnormal.
///
/// Limits: 2 at -infinity, 1 at 0, 0 above 10.06.
#[inline(always)]
pub(crate) fn erfc_f32<S: Single>(x: S) -> S {
    let a = x.abs();
    let largest = S::of(11.0);
    let a = if a > largest { largest } else { a };
    // a^2 = high^2 + (a - high)(a + high), the first term exact.
    let high = a.upper_half();
    let e = exp_difference_f32(-high * high, (a - high) * (a + high)) * erfcx_f32(a);
    if x < S::ZERO { S::TWO - e } else { e }
}

/// The scaled complementary error function, exp(x^2) erfc(x), for x >= 0.
///
/// For x < 0 use 2 exp(x^2) - erfcx(-x); here the argument is not checked. Measured error: at most
/// 3.53 ulp (at 0.000678).
///
/// Limits: 1 at x = 0, 1/(sqrt(pi) x) for large x, subnormal above 2.5e307, 0 at infinity.
#[inline]
pub(crate) fn erfcx_f64(x: f64) -> f64 {
    let u = POLE_F64 / (POLE_F64 + x) - 0.375;
    polynomial_f64(&ERFCX_F64, u) / (1.0 + x)
}

/// exp(x^2) times the integral of erfc from x to infinity, 1/sqrt(pi) - x erfcx(x), for x >= 0.
///
/// Full relative accuracy, for the difference is never formed. For x < 0 use
/// 1/sqrt(pi) - x erfcx(x), where nothing cancels. Measured error up to 1e18: at most 3.4 ulp (at
/// 0.139).
///
/// Limits: 1/sqrt(pi) at x = 0, 1/(2 sqrt(pi) x^2) for large x; 0 above 1.34e154, where
/// x^2 overflows.
#[inline]
pub(crate) fn ierfcx_f64(x: f64) -> f64 {
    let u = POLE_F64 / (POLE_F64 + x) - 0.375;
    polynomial_f64(&IERFCX_F64, u) / (x * (x + 0.875) + 0.5)
}

/// g(w) = ierfc(v) (2 v + ierfc(v)) for w = v^2 >= 0; see `ierfc_excess_f32`.
///
/// Measured error: at most 3.5e-16 of sqrt(w + g(w)) (at w = 0.000002).
///
/// Limits: 1/pi at w = 0, below 4e-15 from 31 on.
#[inline]
pub(crate) fn ierfc_excess_f64(w: f64) -> f64 {
    let w = if w < IERFC_EXCESS_END_F64 { w } else { IERFC_EXCESS_END_F64 };
    let p = polynomial_f64(&IERFC_EXCESS_F64, w);
    let square = p * p;
    square * square
}

/// The complementary error function, erfc(x) = exp(-x^2) erfcx(x) and erfc(-x) = 2 - erfc(x).
///
/// All x; the square is taken in two parts, for its rounding would cost the exponential up to
/// x^2 ulp. NaN gives NaN. Measured error: at most 3.53 ulp for x <= 26 (at 1.322).
///
/// Limits: 2 at -infinity, 1 at 0, 0 above 27.3.
#[inline]
pub(crate) fn erfc_f64(x: f64) -> f64 {
    let a = x.abs();
    let a = if a > 28.0 { 28.0 } else { a };
    let high = f64::from_bits(a.to_bits() & 0xffff_ffff_f800_0000);
    let e = exp_difference_f64(-high * high, (a - high) * (a + high)) * erfcx_f64(a);
    if x < 0.0 { 2.0 - e } else { e }
}
