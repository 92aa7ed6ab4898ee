//! The arc tangent, of a number and of a direction.
//!
//! Layer 0. Selects instead of branches, for lanes and for shaders.

use super::exp::polynomial_f64;
use super::single::Single;

/// Coefficients of (atan(t)/t - 1)/s in s = t^2, 0 <= s <= 1.
///
/// Maximal error relative to atan(t): 1.53e-8 (2^-25.96), at s = 0.9766.
/// Fitted by `tests/golden/fit.py`, `fit_atan("atan_f32", ...)`.
const ATAN_F32: [f32; 9] = [
    -0.333_333,
    0.199_985_49,
    -0.142_642_42,
    0.109_521_9,
    -0.084_034_644,
    0.057_957_83,
    -0.031_178_08,
    0.010_914_729,
    -1.793_648_6e-3,
];

/// Coefficients of (atan(t)/t - 1)/s in s = t^2, 0 <= s <= 1.
///
/// Maximal error relative to atan(t): 2.62e-17 (2^-55.08), at s = 1.0.
/// Fitted by `tests/golden/fit.py`, `fit_atan("atan_f64", ...)`.
const ATAN_F64: [f64; 21] = [
    -0.333_333_333_333_332_87,
    0.199_999_999_999_904_48,
    -0.142_857_142_850_366_63,
    0.111_111_110_864_477_13,
    -0.090_909_085_472_553_5,
    0.076_922_997_117_326_4,
    -0.066_665_837_221_707_91,
    0.058_817_161_488_305_94,
    -0.052_594_337_587_452_27,
    0.047_449_259_883_660_21,
    -0.042_863_904_931_792_825,
    0.038_210_052_894_591_18,
    -0.032_785_406_271_463_4,
    0.026_151_631_858_311_08,
    -0.018_614_157_965_800_89,
    0.011_317_614_080_850_656,
    -5.612_362_978_273_526e-3,
    2.151_576_095_779_816e-3,
    -5.928_891_927_375_973e-4,
    1.038_710_420_769_280_8e-4,
    -8.654_122_354_107_047e-6,
];

/// Coefficients of (atan(x) - x/(1 + x^2))/x^3 in s = x^2, 0 <= s <= 1.
///
/// Maximal relative error: 8.39e-8 (2^-23.51), at s = 0.7112.
/// Fitted by `tests/golden/fit.py`, `fit_atan_excess("atan_excess_f32", ...)`.
const ATAN_EXCESS_F32: [f32; 11] = [
    0.666_666_7,
    -0.799_998_16,
    0.857_068_6,
    -0.887_695_8,
    0.899_018_9,
    -0.871_843_34,
    0.762_99,
    -0.549_169_4,
    0.289_782_52,
    -0.096_196_71,
    0.014_774_918,
];

/// Coefficients of (atan(x) - x/(1 + x^2))/x^3 in s = x^2, 0 <= s <= 1.
///
/// Maximal relative error: 5.91e-17 (2^-53.91), at s = 1.0.
/// Fitted by `tests/golden/fit.py`, `fit_atan_excess("atan_excess_f64", ...)`.
const ATAN_EXCESS_F64: [f64; 23] = [
    0.666_666_666_666_666_6,
    -0.799_999_999_999_994_6,
    0.857_142_857_141_909_7,
    -0.888_888_888_822_346_2,
    0.909_090_906_600_703_1,
    -0.923_076_865_599_853_4,
    0.933_332_439_919_041_2,
    -0.941_166_558_301_678_8,
    0.947_286_642_988_396_6,
    -0.951_863_942_339_023_9,
    0.953_959_223_205_757_1,
    -0.949_863_697_821_717_9,
    0.930_499_233_457_422_7,
    -0.880_294_245_186_443_1,
    0.782_263_413_230_264,
    -0.631_039_061_800_543_6,
    0.445_306_225_341_237_15,
    -0.264_563_103_468_785_2,
    0.126_988_325_150_733_47,
    -0.046_859_673_198_843_92,
    0.012_393_833_789_458_342,
    -2.081_888_118_782_225e-3,
    1.663_205_638_709_507_7e-4,
];

/// pi/2 and pi, each with what its nearest f32 leaves out.
///
/// Split by `tests/golden/fit.py`, `split("half_pi_f32", ...)` and `split("pi_f32", ...)`.
const HALF_PI_PARTS_F32: [f32; 2] = [core::f32::consts::FRAC_PI_2, -4.371_139e-8];
const PI_PARTS_F32: [f32; 2] = [core::f32::consts::PI, -8.742_278e-8];

/// pi/2 and pi, each with what its nearest f64 leaves out.
///
/// Split by `tests/golden/fit.py`, `split("half_pi_f64", ...)` and `split("pi_f64", ...)`.
const HALF_PI_PARTS_F64: [f64; 2] = [core::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17];
const PI_PARTS_F64: [f64; 2] = [core::f64::consts::PI, 1.224_646_799_147_353_2e-16];

/// The arc tangent of x, odd, in [-pi/2, pi/2].
///
/// All x: zero keeps its sign, the limits are atan(inf) = pi/2 and atan(-inf) = -pi/2, NaN gives
/// NaN. Measured error: at most 1.86 ulp (at 1.0052128; tests/laws/certificates.rs).
#[inline(always)]
pub(crate) fn atan_f32<S: Single>(x: S) -> S {
    let a = upper_angle_f32(x.abs(), S::ONE);
    S::of_bits(a.bits() | (x.bits() & (1 << 31)))
}

/// The angle of the direction (x, y), in [-pi, pi].
///
/// That is 0, pi/2 or pi, plus or minus atan(t), t = min(|x|, |y|)/max(|x|, |y|) <= 1, so that no
/// ratio overflows. All finite arguments: atan2(0, 0) = 0 whatever the signs of the zeros,
/// atan2(0, negative) = pi, also for y = -0. Two infinities, or a NaN, give NaN. Measured error: at
/// most 1.86 ulp (beside the diagonals).
#[inline(always)]
pub(crate) fn atan2_f32<S: Single>(y: S, x: S) -> S {
    let angle = upper_angle_f32(y.abs(), x);
    let angle = if y == S::ZERO && x == S::ZERO { S::ZERO } else { angle };
    if y < S::ZERO { -angle } else { angle }
}

/// The angle of the direction (x, y) for y >= 0, in [0, pi]: `atan2_f32` without its last two
/// selects. NaN at the origin.
#[inline(always)]
pub(crate) fn upper_angle_f32<S: Single>(y: S, x: S) -> S {
    let width = x.abs();
    let steep = y > width;
    let low = if steep { width } else { y };
    let high = if steep { y } else { width };
    let t = low / high;
    let s = t * t;
    let c = |n: usize| S::of(ATAN_F32[n]);
    // Estrin's scheme: half the depth of Horner's, whose latency is most of an arctangent's time.
    let (s2, s4) = (s * s, (s * s) * (s * s));
    let bottom = (c(0) + c(1) * s) + (c(2) + c(3) * s) * s2;
    let top = (c(4) + c(5) * s) + (c(6) + c(7) * s) * s2;
    let p = bottom + (top + c(8) * s4) * s4;
    let a = p * s * t + t;
    let back = x < S::ZERO;
    let a = if steep == back { a } else { -a };
    let flat = if back { PI_PARTS_F32 } else { [0.0, 0.0] };
    let base = if steep { HALF_PI_PARTS_F32 } else { flat };
    S::of(base[0]) + (a + S::of(base[1]))
}

/// The arc tangent of x, odd, in [-pi/2, pi/2].
///
/// All x: zero keeps its sign, the limits are atan(inf) = pi/2 and atan(-inf) = -pi/2, NaN gives
/// NaN. Measured error: at most 1.76 ulp (at 1.0854).
#[inline]
pub(crate) fn atan_f64(x: f64) -> f64 {
    let a = upper_angle_f64(x.abs(), 1.0);
    f64::from_bits(a.to_bits() | (x.to_bits() & (1 << 63)))
}

/// The angle of the direction (x, y), in [-pi, pi].
///
/// That is 0, pi/2 or pi, plus or minus atan(t), t = min(|x|, |y|)/max(|x|, |y|) <= 1, so that no
/// ratio overflows. All finite arguments: atan2(0, 0) = 0 whatever the signs of the zeros,
/// atan2(0, negative) = pi, also for y = -0. Two infinities, or a NaN, give NaN. Measured error: at
/// most 1.78 ulp (beside the diagonals).
#[inline]
pub(crate) fn atan2_f64(y: f64, x: f64) -> f64 {
    let angle = upper_angle_f64(y.abs(), x);
    let angle = if y == 0.0 && x == 0.0 { 0.0 } else { angle };
    if y < 0.0 { -angle } else { angle }
}

/// The angle of the direction (x, y) for y >= 0, in [0, pi]: `atan2_f64` without its last two
/// selects. NaN at the origin.
#[inline]
pub(crate) fn upper_angle_f64(y: f64, x: f64) -> f64 {
    let width = x.abs();
    let steep = y > width;
    let low = if steep { width } else { y };
    let high = if steep { y } else { width };
    let t = low / high;
    let s = t * t;
    let a = polynomial_f64(&ATAN_F64, s) * s * t + t;
    let back = x < 0.0;
    let a = if steep == back { a } else { -a };
    let flat = if back { PI_PARTS_F64 } else { [0.0, 0.0] };
    let base = if steep { HALF_PI_PARTS_F64 } else { flat };
    base[0] + (a + base[1])
}

/// atan(x) - x/(1 + x^2), the tail of a GGX segment, on [0, 1]: 2/3 x^3 at 0.
///
/// The difference would start two orders below its terms. Measured error: at most 5.4 ulp (at
/// 0.92466855), 3.2e-7 relative, from the Horner scheme: the coefficients alternate and cancel.
#[inline(always)]
pub(crate) fn atan_excess_f32<S: Single>(x: S) -> S {
    let s = x * x;
    let c = |n: usize| S::of(ATAN_EXCESS_F32[n]);
    let p = (((c(10) * s + c(9)) * s + c(8)) * s + c(7)) * s + c(6);
    let p = (((p * s + c(5)) * s + c(4)) * s + c(3)) * s + c(2);
    ((p * s + c(1)) * s + c(0)) * s * x
}

/// atan(x) - x/(1 + x^2), the tail of a GGX segment, on [0, 1]: 2/3 x^3 at 0.
#[inline]
pub(crate) fn atan_excess_f64(x: f64) -> f64 {
    let s = x * x;
    polynomial_f64(&ATAN_EXCESS_F64, s) * s * x
}
