//! f32 and f64 as precisions: the bits of each, and the polynomials that it takes.
//!
//! Layer 0.

use super::real::{Internal, Real};
use super::{atan, erfc, exp, ln, math};
use core::ops::Mul;

macro_rules! impl_real {
    ($t:ident, $single:literal, $mask:literal, $fraction:literal, $bias:literal, $sqrt:ident,
     $exp:ident, $exp2_of_negative:ident, $product:path, $ln:ident, $atan:ident, $atan2:ident,
     $upper_angle:ident, $atan_excess:ident, $erfc:ident, $erfcx:ident, $ierfcx:ident,
     $ierfc_excess:ident) => {
        impl Internal for $t {
            const SINGLE: bool = $single;

            #[inline(always)]
            fn upper_angle(self, x: Self) -> Self {
                atan::$upper_angle(self, x)
            }
            #[inline(always)]
            fn atan_excess(self) -> Self {
                atan::$atan_excess(self)
            }
            #[inline(always)]
            fn exp2_of_negative(self) -> Self {
                exp::$exp2_of_negative(self)
            }
            #[inline(always)]
            fn product_or_zero(self, other: Self) -> Self {
                $product(self, other)
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

        impl Real for $t {
            const ZERO: Self = 0.0;
            const HALF: Self = 0.5;
            const ONE: Self = 1.0;
            const TWO: Self = 2.0;
            const PI: Self = core::$t::consts::PI;
            const EPSILON: Self = $t::EPSILON;
            const MIN_POSITIVE: Self = $t::MIN_POSITIVE;
            const MAX: Self = $t::MAX;
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
            fn ierfc_excess(self) -> Self {
                erfc::$ierfc_excess(self)
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
    exp2_of_negative_f32,
    exp::product_or_zero_f32,
    ln_f32,
    atan_f32,
    atan2_f32,
    upper_angle_f32,
    atan_excess_f32,
    erfc_f32,
    erfcx_f32,
    ierfcx_f32,
    ierfc_excess_f32
);
impl_real!(
    f64,
    false,
    0xFFFF_FFFF_F800_0000,
    52,
    1023,
    sqrt_f64,
    exp_f64,
    exp2_of_negative_f64,
    Mul::mul,
    ln_f64,
    atan_f64,
    atan2_f64,
    upper_angle_f64,
    atan_excess_f64,
    erfc_f64,
    erfcx_f64,
    ierfcx_f64,
    ierfc_excess_f64
);
