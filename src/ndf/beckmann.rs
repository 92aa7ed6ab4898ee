//! Beckmann: $P_{22} = e^{-q}/(\pi \sqrt{\det A})$, Gaussian slopes.
//!
//! Layer 2. Beckmann & Spizzichino 1963; Walter et al. 2007; any A and mean: Heitz 2014, LEADR.

use super::distribution::sealed::Sealed;
use super::distribution::{Distribution, Ndf};
use crate::scalar::Real;
use crate::slope::{Extent, LobeShape};

/// The scalar functions of Beckmann; see [`Beckmann`](crate::Beckmann).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BeckmannDistribution;

impl Sealed for BeckmannDistribution {
    #[cfg(feature = "serde")]
    const DATA_NAME: &'static str = "beckmann";
}

impl Distribution for BeckmannDistribution {
    #[inline(always)]
    fn density<R: Real>(form: R, extent: Extent<R>, z: R, length_squared: R, weight: R) -> R {
        let Extent { unit, scale, .. } = extent;
        // One division serves all. A mirror has nothing to divide by: four times the smallest
        // number leaves length^2 over it finite.
        let least = R::TWO * R::TWO * R::MIN_POSITIVE;
        let inverse = (R::ONE / (unit * (z * z)).max(least)).kept();
        // Two halves of the exponential: e^-q may be subnormal where e^-q / sqrt(det A) is not.
        let e = (R::lit(-0.5 * core::f64::consts::LOG2_E) * form * inverse).exp2_of_negative();
        // l^2/z^2, and the same over sqrt(det A), as the unit is sqrt(det A) times the scale.
        let inverse = (length_squared * inverse).kept();
        let half = e * (unit * inverse);
        half.product_or_zero(e * (scale * inverse).kept() * weight)
    }

    /// $\sigma = \frac{c}{2}(1 + \mathrm{erf}\,v) + \frac{a}{2\sqrt\pi} e^{-v^2}$ with $v = c/a$,
    /// so the excess is $\frac{a}{2} \mathrm{ierfc}(v) = \frac{a}{2} e^{-v^2} \mathrm{ierfcx}(v)$:
    /// no difference of nearly equal terms is left.
    #[inline(always)]
    fn excess<R: Real>(c: R, a2: R) -> R {
        let a2 = a2.max(R::MIN_POSITIVE);
        let a = a2.sqrt();
        R::HALF * a * (-(c * c / a2)).exp() * (c / a).ierfcx()
    }

    /// $|c| + a\,\mathrm{ierfc}(|c|/a) = \sqrt{c^2 + a^2 g(c^2/a^2)}$ with the function g of
    /// [`Real::ierfc_excess`], which takes no exponential.
    #[inline(always)]
    fn even_area<R: Real>(c: R, a2: R) -> R {
        let c2 = c * c;
        (c2 + a2 * (c2 / a2.max(R::MIN_POSITIVE)).ierfc_excess()).sqrt()
    }
}

impl<S: LobeShape> Ndf<BeckmannDistribution, S> {
    /// Walter's rational fit of Beckmann's Lambda, for comparison and for copying shaders.
    ///
    /// $\Lambda \approx \frac{1 - 1.259 v + 0.396 v^2}{3.535 v + 2.181 v^2}$ for $v = c/a < 1.6$,
    /// else 0. Error of $G_1$ up to 3.11e-3 (at v = 1.34). From v = 1.548 to the jump at 1.6 the
    /// fit lies below 0, by up to 6.2e-5: there Lambda is wrong by all it is. [`Ndf::lambda`] is
    /// exact. `c <= 0` gives the largest finite number.
    ///
    /// Source: Walter et al. 2007, Eq. 26, in the Lambda form of Heitz 2014; LEADR supplement 3.2
    /// (whose clamp of v to 1.599 leaves a Lambda of -5.8e-5 where its text says 0).
    ///
    /// ```
    /// use lobe::{Beckmann, Isotropic};
    /// let ndf = Beckmann::new(Isotropic::new(1.0_f64)?);
    /// let w = [0.8, 0.0, 0.6];
    /// let (fit, exact) = (ndf.lambda_walter(w), ndf.lambda(w));
    /// assert!((1.0 / (1.0 + fit) - 1.0 / (1.0 + exact)).abs() < 3.11e-3);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_beckmann_lambda_walter")]
    pub fn lambda_walter(&self, w: impl Into<[S::Scalar; 3]>) -> S::Scalar {
        let w = w.into();
        let (c, a2) = (self.shape().mean_area(w), self.shape().stretch_squared(w));
        if !(c > S::Scalar::ZERO) {
            return S::Scalar::MAX;
        }
        let v = c / a2.max(S::Scalar::MIN_POSITIVE).sqrt();
        if v >= S::Scalar::lit(1.6) {
            return S::Scalar::ZERO;
        }
        let numerator = S::Scalar::ONE - S::Scalar::lit(1.259) * v + S::Scalar::lit(0.396) * v * v;
        let denominator = S::Scalar::lit(3.535) * v + S::Scalar::lit(2.181) * v * v;
        let lambda = numerator / denominator.max(S::Scalar::MIN_POSITIVE);
        lambda.min(S::Scalar::MAX)
    }
}
