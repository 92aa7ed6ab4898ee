//! The one trait over f32 and f64 that every formula is written in.
//!
//! Layer 0. Sealed by [`Internal`]: the polynomials behind `exp`, `atan` and `erfc` exist for these
//! two widths only. (The feature `probe` adds f32s that measure.)

use crate::error::Value;
use core::fmt::{Debug, Display};
use core::ops::{Add, Div, Mul, Neg, Sub};

/// A floating-point precision: `f32` for engines, `f64` for offline renderers and as reference.
///
/// Every function of the crate is written once over this trait. Elementary functions are our own
/// polynomials with stated errors, so their bits do not depend on the platform; sine and cosine,
/// which only constructors call, come from std or libm.
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
    Internal
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
    /// Zero.
    const ZERO: Self;
    /// One half.
    const HALF: Self;
    /// One.
    const ONE: Self;
    /// Two.
    const TWO: Self;
    /// Ratio of a circle's circumference to its diameter.
    const PI: Self;
    /// Distance from 1 to the next larger number.
    const EPSILON: Self;
    /// Smallest positive normal number.
    const MIN_POSITIVE: Self;
    /// Largest finite number.
    const MAX: Self;
    /// $10^9$, the largest alpha, deviation, slope and variance that constructors accept, in both
    /// precisions: fourth powers of it are still f32.
    const LARGEST: Self;

    /// The literal `x`, rounded to this precision.
    fn lit(x: f64) -> Self;
    /// This number as f64 (exact).
    fn to_f64(self) -> f64;
    /// Square root, correctly rounded.
    fn sqrt(self) -> Self;
    /// Absolute value.
    fn abs(self) -> Self;
    /// The smaller of two numbers, `other` if `self` is NaN: one instruction, unlike `f32::min`.
    #[doc(alias = "lobe_min")]
    #[inline(always)]
    fn min(self, other: Self) -> Self {
        if self < other { self } else { other }
    }
    /// The larger of two numbers, `other` if `self` is NaN.
    #[doc(alias = "lobe_max")]
    #[inline(always)]
    fn max(self, other: Self) -> Self {
        if self > other { self } else { other }
    }
    /// True unless infinite or NaN.
    #[doc(alias = "lobe_is_finite")]
    #[inline(always)]
    fn is_finite(self) -> bool {
        self.abs() <= Self::MAX
    }
    /// Sine and cosine (for constructors: computed in f64, then rounded).
    fn sin_cos(self) -> (Self, Self);
    /// $e^x$; 0 below the smallest number, infinity above the largest.
    #[doc(alias = "lobe_exp")]
    fn exp(self) -> Self;
    /// Natural logarithm; minus infinity at 0, NaN below.
    #[doc(alias = "lobe_ln")]
    fn ln(self) -> Self;
    /// Arctangent in $[-\pi/2, \pi/2]$.
    #[doc(alias = "lobe_atan")]
    fn atan(self) -> Self;
    /// Angle of the point (`x`, `self`) in $[-\pi, \pi]$; 0 at the origin.
    #[doc(alias = "lobe_atan_of")]
    fn atan2(self, x: Self) -> Self;
    /// Complementary error function $2/\sqrt\pi \int_x^\infty e^{-t^2} dt$.
    #[doc(alias = "lobe_erfc")]
    fn erfc(self) -> Self;
    /// Scaled complementary error function $e^{x^2} \mathrm{erfc}(x)$, for $x \ge 0$.
    #[doc(alias = "lobe_erfcx")]
    fn erfcx(self) -> Self;
    /// Scaled first integral of erfc, $1/\sqrt\pi - x\,\mathrm{erfcx}(x)$, for $x \ge 0$, without
    /// the cancellation of that difference.
    #[doc(alias = "lobe_ierfcx")]
    fn ierfcx(self) -> Self;
    /// $g(x) = (v + \mathrm{ierfc}(v))^2 - v^2$ for $v^2 = x \ge 0$, with the first integral of
    /// erfc, $\mathrm{ierfc}(v) = e^{-v^2}/\sqrt\pi - v\,\mathrm{erfc}(v)$.
    ///
    /// Meant as an addend to x: the error is relative to $x + g(x)$. Neither a root nor an
    /// exponential is taken.
    #[doc(alias = "lobe_ierfc_excess")]
    fn ierfc_excess(self) -> Self;
}

impl<R: Real> From<R> for Value {
    #[cold]
    fn from(x: R) -> Self {
        Self::new(x.to_f64())
    }
}

/// What formulas ask of a precision beside [`Real`], which it seals: no name outside of this crate
/// reaches it.
pub trait Internal: Copy {
    /// True for f32, whose quadratures need fewer nodes.
    const SINGLE: bool;
    /// The angle of [`Real::atan2`] for `self >= 0`, not both 0, in $[0, \pi]$.
    fn upper_angle(self, x: Self) -> Self;
    /// $\arctan x - x/(1 + x^2)$ on \[0, 1\], without the cancellation of that difference.
    fn atan_excess(self) -> Self;
    /// $2^x$ for $x \le 0$ at the price of a few roundings; 0 where it has no digits
    /// (`lobe_exp2_of_negative` in WGSL).
    fn exp2_of_negative(self) -> Self;
    /// The product of two numbers that are not negative; 0, or what rounding leaves, where it is
    /// too small for a normal number (`lobe_product_or_zero` in WGSL).
    fn product_or_zero(self, other: Self) -> Self;
    /// The upper half of the significand, the lower half set to zero; what is left, `self - upper`,
    /// is exact, and products of upper halves are exact.
    fn upper_half(self) -> Self;
    /// The largest whole number not above this, within $\pm 2^{30}$; 0 for NaN (`lobe_floor` in
    /// WGSL).
    #[inline(always)]
    fn floor(self) -> i32
    where
        Self: Real,
    {
        floor_of(self.to_f64())
    }
    /// $\lfloor \log_2 x \rfloor$ of a positive normal number (`lobe_exponent` in WGSL).
    fn exponent(self) -> i32;
    /// $2^k$ for `k` from -126 to 126 (`lobe_power_of_two` in WGSL).
    #[inline(always)]
    fn power_of_two(k: i32) -> Self
    where
        Self: Real,
    {
        Self::lit(f64::from_bits(u64::from((k + 1023).unsigned_abs()) << 52))
    }
    /// This value as it was rounded: on a GPU no compiler may fold or fuse it away (`lobe_kept` in
    /// WGSL).
    #[inline(always)]
    fn kept(self) -> Self {
        self
    }
    /// A rounded sum or product, and what rounding left of it: the two together are exact.
    #[inline(always)]
    fn with_rest(self, rest: Self) -> (Self, Self) {
        (self, rest)
    }
    /// True in $[0, 10^9]$: the range of alphas, deviations and variances.
    #[inline(always)]
    fn is_magnitude(self) -> bool
    where
        Self: Real,
    {
        self >= Self::ZERO && self <= Self::LARGEST
    }
    /// True in $[-10^9, 10^9]$: the range of slopes.
    #[inline(always)]
    fn is_slope(self) -> bool
    where
        Self: Real,
    {
        self.abs() <= Self::LARGEST
    }
}

/// [`Internal::floor`], of any precision.
#[inline(always)]
fn floor_of(x: f64) -> i32 {
    const LIMIT: f64 = (1_i32 << 30) as f64;
    let bounded = x.clamp(-LIMIT, LIMIT);
    // The cast cuts towards 0, and NaN to 0.
    let cut = bounded as i32;
    if f64::from(cut) > bounded { cut - 1 } else { cut }
}
