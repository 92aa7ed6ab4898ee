//! An f32 as a GPU computes it that contracts: every product that is added is fused.
//!
//! Layer 0, feature `probe`. One such machine of many, and the extreme: whatever a compiler may
//! fuse, it fuses.

use crate::scalar::single::Single;
use crate::scalar::{Internal, Real, atan, erfc, exp, ln};
use core::cmp::Ordering;
use core::fmt;
use core::ops::{Add, Div, Mul, Neg, Sub};

/// An f32 that remembers the factors of the product it just came from.
///
/// A product is rounded where it is used as it is. In a sum or difference its factors go into one
/// fused multiply-add instead, which rounds once: $a b + c$, $c - a b$. Of two products the left
/// one is fused, the right one was rounded. A sign passes through, and so does a choice between two
/// numbers, as through a compiler's eyes; everything else leaves a plain number: quotients, roots,
/// absolute values, minima and maxima, literals, results of elementary functions (which fuse within
/// their polynomials), and what is kept with `Internal::kept`. Comparisons see the rounded product.
/// Sine and cosine are those of f32.
///
/// ```
/// use lobe::probe::Fused;
/// let x = 1.0 + f32::EPSILON;
/// let (a, b) = (Fused::new(x), Fused::new(x * x));
/// assert_eq!((a * a).value(), x * x);
/// assert_eq!((a * a - b).value(), f32::EPSILON * f32::EPSILON); // in f32: 0
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Fused {
    value: f32,
    factors: Option<[f32; 2]>,
}

impl Fused {
    /// The number `x`, no product.
    ///
    /// ```
    /// use lobe::probe::Fused;
    /// assert_eq!(Fused::new(0.1).value(), 0.1);
    /// ```
    pub const fn new(x: f32) -> Self {
        Self { value: x, factors: None }
    }

    /// This number in f32, a product rounded.
    ///
    /// ```
    /// use lobe::probe::Fused;
    /// assert_eq!((Fused::new(0.1) * Fused::new(3.0)).value(), 0.1 * 3.0);
    /// ```
    pub const fn value(self) -> f32 {
        self.value
    }
}

impl fmt::Display for Fused {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value.fmt(f)
    }
}

impl PartialEq for Fused {
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl PartialOrd for Fused {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

impl Add for Fused {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self::new(match (self.factors, other.factors) {
            (Some([a, b]), _) => a.mul_add(b, other.value),
            (None, Some([a, b])) => a.mul_add(b, self.value),
            (None, None) => self.value + other.value,
        })
    }
}

impl Sub for Fused {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Fused {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        Self { value: self.value * other.value, factors: Some([self.value, other.value]) }
    }
}

impl Div for Fused {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        Self::new(self.value / other.value)
    }
}

impl Neg for Fused {
    type Output = Self;
    fn neg(self) -> Self {
        Self { value: -self.value, factors: self.factors.map(|[a, b]| [-a, b]) }
    }
}

impl Single for Fused {
    fn of(x: f32) -> Self {
        Self::new(x)
    }
    fn bits(self) -> u32 {
        self.value.to_bits()
    }
}

/// Functions of one number, by the polynomials of f32 in this arithmetic.
macro_rules! functions {
    ($($function:ident $by:path),*) => {
        $(fn $function(self) -> Self {
            $by(self).kept()
        })*
    };
}

impl Internal for Fused {
    const SINGLE: bool = true;

    fn upper_angle(self, x: Self) -> Self {
        atan::upper_angle_f32(self, x).kept()
    }
    fn exp2_of_negative(self) -> Self {
        exp::exp2_of_negative_f32(self).kept()
    }
    fn product_or_zero(self, other: Self) -> Self {
        exp::product_or_zero_f32(self, other)
    }
    fn exponent(self) -> i32 {
        self.value.exponent()
    }
    fn upper_half(self) -> Self {
        Self::new(self.value.upper_half())
    }
    fn kept(self) -> Self {
        Self::new(self.value)
    }
    fn atan_excess(self) -> Self {
        atan::atan_excess_f32(self).kept()
    }
}

impl Real for Fused {
    const ZERO: Self = Self::new(0.0);
    const HALF: Self = Self::new(0.5);
    const ONE: Self = Self::new(1.0);
    const TWO: Self = Self::new(2.0);
    const PI: Self = Self::new(f32::PI);
    const EPSILON: Self = Self::new(f32::EPSILON);
    const MIN_POSITIVE: Self = Self::new(f32::MIN_POSITIVE);
    const MAX: Self = Self::new(f32::MAX);
    const LARGEST: Self = Self::new(f32::LARGEST);

    fn lit(x: f64) -> Self {
        Self::new(Real::lit(x))
    }
    fn to_f64(self) -> f64 {
        self.value.to_f64()
    }
    fn sqrt(self) -> Self {
        Self::new(Real::sqrt(self.value))
    }
    fn abs(self) -> Self {
        Self::new(self.value.abs())
    }
    fn min(self, other: Self) -> Self {
        Self::new(Real::min(self.value, other.value))
    }
    fn max(self, other: Self) -> Self {
        Self::new(Real::max(self.value, other.value))
    }
    fn sin_cos(self) -> (Self, Self) {
        let (sin, cos) = Real::sin_cos(self.value);
        (Self::new(sin), Self::new(cos))
    }
    functions!(
        exp exp::exp_f32, ln ln::ln_f32, atan atan::atan_f32, erfc erfc::erfc_f32,
        erfcx erfc::erfcx_f32, ierfcx erfc::ierfcx_f32, ierfc_excess erfc::ierfc_excess_f32
    );
    fn atan2(self, x: Self) -> Self {
        atan::atan2_f32(self, x).kept()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::exact::{difference_of_products, two_product, two_sum};

    #[test]
    fn sums_that_keep_their_errors_keep_them_when_fused() {
        for (a, b) in [(1.1_f32, 3.3_f32), (1e9, -7.7), (12345.678, 0.001_234)] {
            let exact = f64::from(a) * f64::from(b);
            let (p, e) = two_product(Fused::new(a), Fused::new(b));
            assert_eq!((p.value, p.to_f64() + e.to_f64()), (a * b, exact), "{a} * {b}");
            let (s, e) = two_sum(Fused::new(a), Fused::new(b));
            let exact = f64::from(a) + f64::from(b);
            assert_eq!((s.value, s.to_f64() + e.to_f64()), (a + b, exact), "{a} + {b}");
        }
        // Were the product not kept, its error would be added twice.
        let x = 1.0 + f32::EPSILON;
        let [a, b] = [x, x * x].map(Fused::new);
        let det = difference_of_products(a, a, b, Fused::ONE);
        assert_eq!(det.value, f32::EPSILON * f32::EPSILON);
    }

    #[test]
    fn a_sign_and_a_difference_fuse_as_the_sum_does() {
        let x = 1.0 + f32::EPSILON;
        let (a, rounded) = (Fused::new(x), Fused::new(x * x));
        let rest = f32::EPSILON * f32::EPSILON;
        assert_eq!((-(a * a) + rounded).value, -rest);
        assert_eq!((rounded - a * a).value, -rest);
        assert_eq!((-rounded + a * a).value, rest);
        // Two products: the right one is rounded.
        assert_eq!((a * a - a * a).value, rest);
        for plain in [(a * a).kept(), (a * a).abs(), (a * a).max(a), (a * a).min(rounded)] {
            assert_eq!((plain - rounded).value, 0.0);
        }
    }
}
