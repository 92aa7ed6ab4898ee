//! What scenes need of a float beyond [`lobe::Real`]: fast sines and a floor.

/// `f32` for the methods, as an engine computes; `f64` for the reference.
pub(crate) trait Scalar: lobe::Real {
    /// Cosine in this precision. (`Real::sin_cos` is for constructors: it goes through f64.)
    fn cos(self) -> Self;

    /// Sine in this precision.
    fn sin(self) -> Self;

    /// The integer below and the fraction above it. For numbers that fit an `i32`.
    fn split(self) -> (i32, Self);
}

macro_rules! impl_scalar {
    ($t:ident, $from:expr) => {
        impl Scalar for $t {
            #[inline]
            fn cos(self) -> Self {
                $t::cos(self)
            }
            #[inline]
            fn sin(self) -> Self {
                $t::sin(self)
            }
            // A cast and a comparison: without SSE 4.1, `floor` is a call.
            #[inline]
            fn split(self) -> (i32, Self) {
                let from: fn(i32) -> $t = $from;
                let toward_zero = self as i32;
                let whole = toward_zero - i32::from(self < from(toward_zero));
                (whole, self - from(whole))
            }
        }
    };
}

impl_scalar!(f32, |x| x as f32);
impl_scalar!(f64, f64::from);

#[cfg(test)]
mod tests {
    use super::Scalar;

    #[test]
    fn split_is_floor_and_fraction_on_both_sides_of_zero() {
        assert_eq!(2.25_f32.split(), (2, 0.25));
        assert_eq!((-0.25_f64).split(), (-1, 0.75));
        assert_eq!((-3.0_f64).split(), (-3, 0.0));
    }
}
