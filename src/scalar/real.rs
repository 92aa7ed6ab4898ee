//! The one trait over f32 and f64 that every formula is written in.
//!
//! Floor 0. Sealed: the polynomials behind `exp`, `atan` and `erfc` exist for these two widths only. (The feature
//! `probe` adds f32s that measure.)

use super::{atan, erfc, exp, ln, math};
use core::fmt::{Debug, Display};
use core::ops::{Add, Div, Mul, Neg, Sub};

pub(super) mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
}

/// A floating-point precision: `f32` for engines, `f64` for offline renderers and as reference.
///
/// Every function of the crate is written once over this trait. Elementary functions are our own
/// polynomials with stated errors, so their bits do not depend on the platform; sine and cosine, which only
/// constructors call, come from std or libm.
///
/// ```
/// use lobe::Real;
/// fn half_of<R: Real>(x: R) -> R {
///     R::HALF * x
/// }
/// assert_eq!(half_of(3.0_f32), 1.5);
/// assert_eq!(f64::lit(0.1).exp(), 0.1_f64.exp());
/// ```
pub trait Real:
    sealed::Sealed
    + Copy
    + PartialOrd
    + Default
    + Debug
    + Display
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// 0.
    const ZERO: Self;
    /// 1/2.
    const HALF: Self;
    /// 1.
    const ONE: Self;
    /// 2.
    const TWO: Self;
    /// Ratio of a circle's circumference to its diameter.
    const PI: Self;
    /// Distance from 1 to the next larger number.
    const EPSILON: Self;
    /// Smallest positive normal number.
    const MIN_POSITIVE: Self;
    /// Largest finite number.
    const MAX: Self;
    /// True for f32, whose quadratures need fewer nodes.
    const SINGLE: bool;
    /// $10^9$, the largest alpha, deviation, slope and variance that constructors accept, in both
    /// precisions: fourth powers of it are still f32.
    const LARGEST: Self;

    /// The literal `x`, rounded to this precision.
    ///
    /// WGSL: none, literals there.
    fn lit(x: f64) -> Self;
    /// This number as f64 (exact).
    ///
    /// WGSL: none, no f64 there.
    fn to_f64(self) -> f64;
    /// Square root, correctly rounded.
    ///
    /// WGSL: none, a builtin there.
    fn sqrt(self) -> Self;
    /// Absolute value.
    ///
    /// WGSL: none, a builtin there.
    fn abs(self) -> Self;
    /// The smaller of two numbers, `other` if `self` is NaN: one instruction, unlike `f32::min`.
    ///
    /// WGSL: `lobe_min`.
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    /// The larger of two numbers, `other` if `self` is NaN.
    ///
    /// WGSL: `lobe_max`.
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    /// True unless infinite or NaN.
    ///
    /// WGSL: `lobe_is_finite`.
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.abs() <= Self::MAX
    }
    /// True in $[0, 10^9]$: the range of alphas, deviations and variances.
    ///
    /// WGSL: none, constructors clamp there.
    #[inline(always)]
    fn is_magnitude(self) -> bool {
        self >= Self::ZERO && self <= Self::LARGEST
    }
    /// True in $[-10^9, 10^9]$: the range of slopes.
    ///
    /// WGSL: none, constructors clamp there.
    #[inline(always)]
    fn is_slope(self) -> bool {
        self.abs() <= Self::LARGEST
    }
    /// Sine and cosine (for constructors: computed in f64, then rounded).
    ///
    /// WGSL: none, a builtin may miss by 2^-11 there; only constructors use them.
    fn sin_cos(self) -> (Self, Self);
    /// $e^x$; 0 below the smallest number, infinity above the largest.
    ///
    /// WGSL: `lobe_exp`.
    fn exp(self) -> Self;
    /// Natural logarithm; minus infinity at 0, NaN below.
    ///
    /// WGSL: `lobe_ln`.
    fn ln(self) -> Self;
    /// Arctangent in $[-\pi/2, \pi/2]$.
    ///
    /// WGSL: `lobe_atan`.
    fn atan(self) -> Self;
    /// Angle of the point (`x`, `self`) in $[-\pi, \pi]$; 0 at the origin.
    ///
    /// WGSL: `lobe_atan_of`.
    fn atan2(self, x: Self) -> Self;
    /// Complementary error function $2/\sqrt\pi \int_x^\infty e^{-t^2} dt$.
    ///
    /// WGSL: `lobe_erfc`.
    fn erfc(self) -> Self;
    /// Scaled complementary error function $e^{x^2} \mathrm{erfc}(x)$, for $x \ge 0$.
    ///
    /// WGSL: `lobe_erfcx`.
    fn erfcx(self) -> Self;
    /// Scaled first integral of erfc, $1/\sqrt\pi - x\,\mathrm{erfcx}(x)$, for $x \ge 0$, without
    /// the cancellation of that difference.
    ///
    /// WGSL: `lobe_ierfcx`.
    fn ierfcx(self) -> Self;
    /// The angle of [`Real::atan2`] for `self >= 0`, not both 0, in $[0, \pi]$.
    #[doc(hidden)]
    fn upper_angle(self, x: Self) -> Self;
    /// $\arctan x - x/(1 + x^2)$ on \[0, 1\], without the cancellation of that difference.
    #[doc(hidden)]
    fn atan_excess(self) -> Self;
    /// The upper half of the significand, the lower half set to zero; what is left, `self - upper`,
    /// is exact, and products of upper halves are exact.
    #[doc(hidden)]
    fn upper_half(self) -> Self;
    /// The largest whole number not above this, within $\pm 2^{30}$; 0 for NaN (`lobe_floor` in WGSL).
    #[doc(hidden)]
    #[inline(always)]
    fn floor(self) -> i32 {
        floor_of(self.to_f64())
    }
    /// $\lfloor \log_2 x \rfloor$ of a positive normal number (`lobe_exponent` in WGSL).
    #[doc(hidden)]
    fn exponent(self) -> i32;
    /// $2^k$ for `k` from -126 to 126 (`lobe_power_of_two` in WGSL).
    #[doc(hidden)]
    #[inline(always)]
    fn power_of_two(k: i32) -> Self {
        Self::lit(f64::from_bits(u64::from((k + 1023).unsigned_abs()) << 52))
    }
    /// This value as it was rounded: on a GPU no compiler may fold or fuse it away (`lobe_kept` in WGSL).
    #[doc(hidden)]
    #[inline(always)]
    fn kept(self) -> Self {
        self
    }
    /// A rounded sum or product, and what rounding left of it: the two together are exact.
    #[doc(hidden)]
    #[inline(always)]
    fn with_rest(self, rest: Self) -> (Self, Self) {
        (self, rest)
    }
}

/// [`Real::floor`], of any precision.
#[inline(always)]
fn floor_of(x: f64) -> i32 {
    const LIMIT: f64 = (1_i32 << 30) as f64;
    let bounded = x.clamp(-LIMIT, LIMIT);
    // The cast cuts towards 0, and NaN to 0.
    let cut = bounded as i32;
    if f64::from(cut) > bounded { cut - 1 } else { cut }
}

macro_rules! impl_real {
    ($t:ident, $single:literal, $mask:literal, $fraction:literal, $bias:literal, $sqrt:ident, $exp:ident, $ln:ident, $atan:ident, $atan2:ident,
     $upper_angle:ident, $atan_excess:ident, $erfc:ident, $erfcx:ident, $ierfcx:ident) => {
        impl Real for $t {
            const ZERO: Self = 0.0;
            const HALF: Self = 0.5;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const PI: Self = core::$t::consts::PI;
            const EPSILON: Self = $t::EPSILON;
            const MIN_POSITIVE: Self = $t::MIN_POSITIVE;
            const MAX: Self = $t::MAX;
            const SINGLE: bool = $single;
            const LARGEST: Self = 1e9;

            #[inline(always)]
            fn lit(x: f64) -> Self {
                x as $t
            }
            #[inline(always)]
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                math::$sqrt(self)
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $t::abs(self)
            }
            #[inline]
            fn sin_cos(self) -> (Self, Self) {
                let (sin, cos) = math::sin_cos(self.to_f64());
                (sin as $t, cos as $t)
            }
            #[inline(always)]
            fn exp(self) -> Self {
                exp::$exp(self)
            }
            #[inline(always)]
            fn ln(self) -> Self {
                ln::$ln(self)
            }
            #[inline(always)]
            fn atan(self) -> Self {
                atan::$atan(self)
            }
            #[inline(always)]
            fn atan2(self, x: Self) -> Self {
                atan::$atan2(self, x)
            }
            #[inline(always)]
            fn upper_angle(self, x: Self) -> Self {
                atan::$upper_angle(self, x)
            }
            #[inline(always)]
            fn atan_excess(self) -> Self {
                atan::$atan_excess(self)
            }
            #[inline(always)]
            fn erfc(self) -> Self {
                erfc::$erfc(self)
            }
            #[inline(always)]
            fn erfcx(self) -> Self {
                erfc::$erfcx(self)
            }
            #[inline(always)]
            fn ierfcx(self) -> Self {
                erfc::$ierfcx(self)
            }
            #[inline(always)]
            fn upper_half(self) -> Self {
                $t::from_bits(self.to_bits() & $mask)
            }
            #[inline(always)]
            #[allow(clippy::cast_possible_wrap, reason = "of a positive number: a few bits")]
            fn exponent(self) -> i32 {
                (self.to_bits() >> $fraction) as i32 - $bias
            }
        }
    };
}

impl_real!(
    f32,
    true,
    0xFFFF_F000,
    23,
    127,
    sqrt_f32,
    exp_f32,
    ln_f32,
    atan_f32,
    atan2_f32,
    upper_angle_f32,
    atan_excess_f32,
    erfc_f32,
    erfcx_f32,
    ierfcx_f32
);
impl_real!(
    f64,
    false,
    0xFFFF_FFFF_F800_0000,
    52,
    1023,
    sqrt_f64,
    exp_f64,
    ln_f64,
    atan_f64,
    atan2_f64,
    upper_angle_f64,
    atan_excess_f64,
    erfc_f64,
    erfcx_f64,
    ierfcx_f64
);
