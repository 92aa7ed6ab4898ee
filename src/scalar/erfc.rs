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

/// Coefficients of ierfc(v)^(1/4) in v, 0 <= v <= 3.625.
///
/// Maximal error of the fourth power relative to v + ierfc(v): 1.4e-7 (2^-22.76), at v = 0.029, no
/// more beyond 3.625, where the power keeps its value.
/// Fitted by `tests/golden/fit.py`, `fit_ierfc("ierfc_f32", ...)`.
const IERFC_F32: [f32; 9] = [
    0.866_675,
    -0.384_034_96,
    -0.038_596_228,
    0.024_167_841,
    7.526_091e-3,
    -1.360_234e-3,
    -1.306_069_4e-3,
    4.409_148e-4,
    -4.085_741_2e-5,
];

/// Where the polynomial of ierfc ends.
const IERFC_END_F32: f32 = 3.625;

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

/// Coefficients of ierfc(v)^(1/4) in v, 0 <= v <= 5.625.
///
/// Maximal error of the fourth power relative to v + ierfc(v): 1.12e-16 (2^-52.99), at v = 0.0472,
/// no more beyond 5.625, where the power keeps its value.
/// Fitted by `tests/golden/fit.py`, `fit_ierfc("ierfc_f64", ...)`.
const IERFC_F64: [f64; 23] = [
    0.866_674_993_561_567_2,
    -0.384_035_357_455_430_16,
    -0.038_588_107_186_634_21,
    0.024_108_436_716_139_544,
    7.736_707_584_380_979e-3,
    -1.769_500_936_892_978_2e-3,
    -8.456_277_380_169_42e-4,
    1.399_893_221_564_611_5e-4,
    6.500_021_590_720_835e-5,
    -1.299_719_859_513_079e-5,
    -3.070_908_868_085_211e-6,
    1.029_983_209_645_860_8e-6,
    7.419_872_663_032_309e-8,
    -1.304_385_700_933_263_8e-7,
    6.300_045_091_583_843e-8,
    -2.166_983_157_680_047e-8,
    5.352_274_208_180_133e-9,
    -9.306_576_281_354_903e-10,
    1.120_494_977_742_383_2e-10,
    -9.015_756_872_090_231e-12,
    4.466_081_733_361_373e-13,
    -1.112_817_077_135_938_7e-14,
    6.310_665_231_132_224e-17,
];

/// Where the polynomial of ierfc ends.
const IERFC_END_F64: f64 = 5.625;

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

/// The integral of erfc from v to infinity, exp(-v^2)/sqrt(pi) - v erfc(v), for v >= 0, as an
/// addend to v.
///
/// The fourth power of a polynomial: not negative, and no exponential. Measured error: at most
/// 4e-7 of v + ierfc(v) (at 0.014).
///
/// Limits: 1/sqrt(pi) at v = 0, 1.8e-8 from 3.625 on.
#[inline(always)]
pub(crate) fn ierfc_f32<S: Single>(v: S) -> S {
    let v = v.min(S::of(IERFC_END_F32));
    let c = |n: usize| S::of(IERFC_F32[n]);
    let p = (((c(8) * v + c(7)) * v + c(6)) * v + c(5)) * v + c(4);
    let p = (((p * v + c(3)) * v + c(2)) * v + c(1)) * v + c(0);
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

/// The integral of erfc from v to infinity, exp(-v^2)/sqrt(pi) - v erfc(v), for v >= 0, as an
/// addend to v.
///
/// The fourth power of a polynomial, as in f32. Measured error: at most 6e-16 of v + ierfc(v).
///
/// Limits: 1/sqrt(pi) at v = 0, below 1e-16 from 5.625 on.
#[inline]
pub(crate) fn ierfc_f64(v: f64) -> f64 {
    let v = if v < IERFC_END_F64 { v } else { IERFC_END_F64 };
    let p = polynomial_f64(&IERFC_F64, v);
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
