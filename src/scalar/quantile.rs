//! Quantiles of the standard normal distribution.
//!
//! Layer 0. One polynomial and one logarithm, without branches.

use super::Real;

/// Coefficients of z/(1 - 2v) in t = w/(w + 8) - 3/8, w = -ln(4v(1 - v)), for v from 2^-34 to 1/2.
///
/// Maximal error relative to z: 5.31e-6 (2^-17.52), at v = 0.02587.
/// Fitted by `tests/golden/fit.py`, `fit_quantile("quantile", ...)`.
const QUANTILE: [f32; 10] = [
    2.880_449_5,
    6.273_712,
    5.687_957_3,
    3.206_150_3,
    13.248_417,
    26.726_229,
    -4.047_084_3,
    -19.790_651,
    134.691_65,
    212.403_58,
];

/// The z that a standard normal number exceeds with probability `v`, for v from 2^-34 to 1 - 2^-24.
///
/// Relative error 5.4e-6 in f64, 1e-5 in f32, enough for a law of what is random anyway. Odd
/// about 1/2, where it is 0. v outside counts as the nearest, NaN as the smallest.
#[inline(always)]
pub(crate) fn normal_quantile<R: Real>(v: R) -> R {
    let v = v.max(R::power_of_two(-34)).min(R::ONE - R::power_of_two(-24));
    let w = -(R::lit(4.0) * v * (R::ONE - v)).ln();
    let t = w / (w + R::lit(8.0)) - R::lit(0.375);
    let mut sum = R::ZERO;
    for c in QUANTILE.iter().rev() {
        sum = sum * t + R::lit(f64::from(*c));
    }
    (R::ONE - R::TWO * v) * sum
}

#[cfg(test)]
#[allow(clippy::incompatible_msrv, reason = "tests need a newer compiler, for their oracles")]
mod tests {
    use super::normal_quantile;

    /// Error of z relative to it, by one Newton step with the correctly rounded erfc.
    fn error(v: f64, z: f64) -> f64 {
        let density = (-0.5 * z * z).exp() / core::f64::consts::TAU.sqrt();
        let tail = 0.5 * pxfm::f_erfc(z * core::f64::consts::FRAC_1_SQRT_2);
        ((tail - v) / density / z).abs()
    }

    #[test]
    fn errs_as_stated() {
        let (mut double, mut single) = (0.0_f64, 0.0_f64);
        for k in 1..200_000 {
            // From 2^-34 to 1/2, evenly in the logarithm; and what mirrors it.
            let v = f64::exp2(-34.0 + 33.0 * f64::from(k) / 200_000.0);
            double = double.max(error(v, normal_quantile(v)));
            let v = v as f32;
            single = single.max(error(f64::from(v), f64::from(normal_quantile(v))));
            let odd = normal_quantile(1.0 - v) + normal_quantile(1.0 - (1.0 - v));
            assert!(odd == 0.0 || v < f32::EPSILON, "{v}: {odd}");
        }
        assert!(double < 5.4e-6 && double > 5e-6, "{double}");
        assert!(single < 1e-5, "{single}");
        assert_eq!(normal_quantile(0.5_f32), 0.0);
        for end in [f64::NAN, -1.0, 0.0, 1.0, 2.0, f64::INFINITY] {
            assert!(normal_quantile(end).abs() < 6.6);
        }
    }
}
