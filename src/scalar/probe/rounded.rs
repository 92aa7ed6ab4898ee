//! An f32 with a bound of its rounding errors, carried along.
//!
//! Layer 0, feature `probe`. Running error analysis (Wilkinson 1986, "Error analysis revisited").

use crate::scalar::{Internal, Real};
use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// Half of the distance from 1 to the next f32: bounds are stored in units of it.
const UNIT: f64 = f32::EPSILON as f64 / 2.0;

/// What flushing a subnormal result to zero may cost, in units.
const FLUSHED: f64 = f32::MIN_POSITIVE as f64 / UNIT;

/// Two turns of the half circle: no two angles differ by more. In units.
const TURN: f64 = core::f64::consts::TAU / UNIT;

/// An f32, bit for bit, and how far rounding may have moved it.
///
/// The bound is what rounding every operation by at most $2^{-24}$, relative, could have done to
/// the value, and flushing every subnormal result to zero: f32 lies within it of the same formula
/// without rounding, and so does f32 in another order of contraction ([`Fused`](super::Fused)) or
/// with other correctly rounded functions. Two such results differ by at most twice the bound.
/// Elementary functions add the errors that they state. To first order in the results that follow,
/// and more where that would not be enough: divisors and roots that may be zero. A bound that is no
/// number is infinite. Of a branch it knows the side taken, of a minimum both where they are near.
///
/// Exact sums and products (`scalar::exact`), whose parts are kept, cost nothing: the pair has the
/// errors of the operands only. The cut of `Internal::upper_half` is deliberate, and adds nothing.
///
/// ```
/// use lobe::probe::Rounded;
/// let (a, b) = (Rounded::exact(1.1), Rounded::exact(1.0));
/// let difference = a * a - b;
/// assert_eq!(difference.value(), 1.1 * 1.1 - 1.0);
/// assert_eq!(difference.bound(), f64::from(1.1_f32 * 1.1 + (1.1 * 1.1 - 1.0)) / 16_777_216.0);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Rounded {
    value: f32,
    /// What came with the operands, in units.
    carried: f64,
    /// What rounding the last result added, in units.
    own: f64,
}

impl Rounded {
    /// The number `x`, which nothing has rounded yet.
    ///
    /// ```
    /// use lobe::probe::Rounded;
    /// assert_eq!(Rounded::exact(0.1).bound(), 0.0);
    /// ```
    pub const fn exact(x: f32) -> Self {
        Self { value: x, carried: 0.0, own: 0.0 }
    }

    /// The number in f32.
    ///
    /// ```
    /// use lobe::probe::Rounded;
    /// assert_eq!((Rounded::exact(0.1) * Rounded::exact(3.0)).value(), 0.1 * 3.0);
    /// ```
    pub const fn value(self) -> f32 {
        self.value
    }

    /// How far rounding may have moved the number: absolute, not negative, infinity where nothing
    /// is known.
    ///
    /// ```
    /// use lobe::Real;
    /// use lobe::probe::Rounded;
    /// assert_eq!((Rounded::exact(1.0) + Rounded::exact(0.5)).bound(), 1.5 / 16_777_216.0);
    /// assert_eq!((Rounded::ONE / Rounded::ZERO).bound(), f64::INFINITY);
    /// ```
    pub const fn bound(self) -> f64 {
        self.units() * UNIT
    }

    /// The bound in units.
    const fn units(self) -> f64 {
        self.carried + self.own
    }

    /// A result rounded `times` over, with what errors of the operands do to it.
    fn result(value: f32, times: f64, carried: f64) -> Self {
        let size = f64::from(value).abs();
        let flushed = if size > 0.0 && value.abs() < f32::MIN_POSITIVE { FLUSHED } else { 0.0 };
        let (own, infinite) = (times * size + flushed, f64::INFINITY);
        if (own + carried).is_nan() {
            return Self { value, carried: infinite, own: infinite };
        }
        Self { value, carried, own }
    }

    /// The same, of a product, quotient or function: a 0 that is not `exact` was too small for a
    /// number.
    fn scaled(value: f32, times: f64, carried: f64, exact: bool) -> Self {
        let lost = if value == 0.0 && !exact { FLUSHED } else { 0.0 };
        Self::result(value, times, carried + lost)
    }

    /// The value in f64, and the absolute error.
    fn parts(self) -> (f64, f64) {
        (f64::from(self.value), self.bound())
    }

    /// The error of an angle of (`x`, `self`), in units.
    fn turned(self, x: Self) -> f64 {
        let ((y, y_error), (x, x_error)) = (self.parts(), x.parts());
        if y_error == 0.0 && x_error == 0.0 {
            return 0.0;
        }
        ((y.abs() * x_error + x.abs() * y_error) / (x * x + y * y) / UNIT).min(TURN)
    }

    /// One of two numbers that was chosen by comparing them: where they are near, it may be the
    /// other.
    fn chosen(self, rejected: Self) -> Self {
        let distance = (f64::from(self.value) - f64::from(rejected.value)).abs();
        if distance <= self.bound() + rejected.bound() && rejected.units() > self.units() {
            return Self { value: self.value, ..rejected };
        }
        self
    }
}

impl fmt::Display for Rounded {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value.fmt(f)
    }
}

impl PartialEq for Rounded {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl PartialOrd for Rounded {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl Add for Rounded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::result(self.value + other.value, 1.0, self.units() + other.units())
    }
}

impl Sub for Rounded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Rounded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let (a, b) = (f64::from(self.value).abs(), f64::from(other.value).abs());
        let carried = a * other.units() + b * self.units() + self.units() * other.bound();
        Self::scaled(self.value * other.value, 1.0, carried, a == 0.0 || b == 0.0)
    }
}

impl Div for Rounded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        // The divisor nearest to zero.
        let least = (f64::from(other.value).abs() - other.bound()).max(0.0);
        let carried = (self.units() + f64::from(value).abs() * other.units()) / least;
        Self::scaled(value, 1.0, carried, self.value == 0.0)
    }
}

impl Neg for Rounded {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, ..self }
    }
}

impl Internal for Rounded {
    const SINGLE: bool = true;

    fn upper_angle(self, x: Self) -> Self {
        Self::result(self.value.upper_angle(x.value), 4.0, self.turned(x))
    }
    fn atan_excess(self) -> Self {
        let (x, error) = self.parts();
        // 2 x^2 / (1 + x^2)^2, which grows up to 1.
        let most = (x + error).min(1.0);
        let slope = 2.0 * (most / (1.0 + most * most)).powi(2);
        Self::result(self.value.atan_excess(), 11.0, slope * self.units())
    }
    fn exp2_of_negative(self) -> Self {
        let (x, error) = self.parts();
        let value = self.value.exp2_of_negative();
        let slope = core::f64::consts::LN_2 * (x + error).min(0.0).exp2();
        let lost = if value == 0.0 { FLUSHED } else { 0.0 };
        Self::result(value, 5.0, slope * self.units() + lost)
    }
    fn product_or_zero(self, other: Self) -> Self {
        let (product, value) = (self * other, self.value.product_or_zero(other.value));
        let lost = if value == product.value { 0.0 } else { FLUSHED };
        Self { value, carried: product.carried + lost, ..product }
    }
    fn exponent(self) -> i32 {
        self.value.exponent()
    }
    fn upper_half(self) -> Self {
        Self { value: self.value.upper_half(), ..self }
    }
    fn with_rest(self, rest: Self) -> (Self, Self) {
        // The rest of a product this small, or a part of it, is too small for a number.
        let tiny = self.value != 0.0 && self.value.abs() < f32::MIN_POSITIVE / f32::EPSILON.powi(2);
        let flushed = if tiny { 4.0 * FLUSHED } else { 0.0 };
        let own = if rest.value.is_finite() { 0.0 } else { f64::INFINITY };
        (Self { own, ..self }, Self::result(rest.value, 1.0, flushed))
    }
}

impl Real for Rounded {
    const ZERO: Self = Self::exact(0.0);
    const HALF: Self = Self::exact(0.5);
    const ONE: Self = Self::exact(1.0);
    const TWO: Self = Self::exact(2.0);
    const PI: Self = Self { value: f32::PI, carried: f32::PI as f64, own: 0.0 };
    const EPSILON: Self = Self::exact(f32::EPSILON);
    const MIN_POSITIVE: Self = Self::exact(f32::MIN_POSITIVE);
    const MAX: Self = Self::exact(f32::MAX);
    const LARGEST: Self = Self::exact(f32::LARGEST);

    fn lit(x: f64) -> Self {
        let value = x as f32;
        // One rounding, and all of it where nothing is left.
        let missed = (f64::from(value) - x).abs() / UNIT;
        let error = if missed == 0.0 { 0.0 } else { missed.max(x.abs()) };
        Self::result(value, 0.0, error)
    }
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }
    fn sqrt(self) -> Self {
        let value = Real::sqrt(self.value);
        let (x, error) = self.parts();
        // |sqrt(x + e) - sqrt(x)|, and never more than sqrt(e).
        let steep = self.units() / (f64::from(value) + (x - error).max(0.0).sqrt());
        Self::result(value, 1.0, if error > 0.0 { steep.min(error.sqrt() / UNIT) } else { 0.0 })
    }
    fn abs(self) -> Self {
        Self { value: self.value.abs(), ..self }
    }
    fn min(self, other: Self) -> Self {
        if self < other { self.chosen(other) } else { other.chosen(self) }
    }
    fn max(self, other: Self) -> Self {
        if self > other { self.chosen(other) } else { other.chosen(self) }
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = Real::sin_cos(self.value);
        (Self::result(sin, 1.0, self.units()), Self::result(cos, 1.0, self.units()))
    }
    // Errors of elementary functions, in units: twice the ulps that the polynomials state, rounded
    // up.
    fn exp(self) -> Self {
        let (x, error) = self.parts();
        // e^(x + error) - e^x.
        let carried = (x + error).exp() * -(-error).exp_m1() / UNIT;
        Self::scaled(Real::exp(self.value), 2.0, carried, false)
    }
    fn ln(self) -> Self {
        let (x, error) = self.parts();
        let carried = if error < x { -(-error / x).ln_1p() / UNIT } else { f64::INFINITY };
        Self::result(Real::ln(self.value), 2.0, if error > 0.0 { carried } else { 0.0 })
    }
    fn atan(self) -> Self {
        let (x, error) = self.parts();
        let least = (x.abs() - error).max(0.0);
        Self::result(Real::atan(self.value), 4.0, self.units() / (1.0 + least * least))
    }
    fn atan2(self, x: Self) -> Self {
        let (y, error) = self.parts();
        // Across the negative x axis the angle jumps.
        let jumps = error > 0.0 && error >= y.abs() && x.value < 0.0;
        let carried = if jumps { TURN } else { self.turned(x) };
        Self::result(Real::atan2(self.value, x.value), 4.0, carried)
    }
    fn erfc(self) -> Self {
        let (x, error) = self.parts();
        let least = (x.abs() - error).max(0.0);
        let slope = core::f64::consts::FRAC_2_SQRT_PI * (-least * least).exp();
        Self::scaled(Real::erfc(self.value), 9.0, slope * self.units(), false)
    }
    // The two scaled ones and their slopes decrease: the steepest is at the smallest argument.
    fn erfcx(self) -> Self {
        let (x, error) = self.parts();
        let slope = 2.0 * (x - error).max(0.0).ierfcx();
        Self::scaled(Real::erfcx(self.value), 7.0, slope * self.units(), false)
    }
    fn ierfcx(self) -> Self {
        let (x, error) = self.parts();
        let least = (x - error).max(0.0);
        let slope = (least.erfcx() - 2.0 * least * least.ierfcx()).abs();
        Self::scaled(Real::ierfcx(self.value), 8.0, slope * self.units(), false)
    }
    // Its own error is a part of x + g(x), up to where it is constant. Its slope is steepest at 0.
    fn ierfc_excess(self) -> Self {
        let value = Real::ierfc_excess(self.value);
        let slope = 1.0 - 2.0 * core::f64::consts::FRAC_1_PI;
        let own = 13.0 * (self.parts().0.min(12.0) + f64::from(value));
        Self::result(value, 0.0, own + slope * self.units())
    }
}
