//! Mean and covariance of a patch of slopes: what a normal map leaves behind when it is minified.
//!
//! Layer 1. Raw moments filter linearly and cancel; the merge of means and covariances does
//! neither.

use super::direction::checked_slope;
use super::lobe::Lobe;
use super::roughness::Roughness;
use crate::error::Error;
use crate::scalar::exact::difference_of_products;
use crate::scalar::{Psd, Real};

/// Mean and covariance of slopes.
///
/// ```
/// use lobe::{Roughness, SlopeMoments};
/// let left = SlopeMoments::of_slope([0.1_f64, 0.0])?;
/// let right = SlopeMoments::of_slope([-0.1_f64, 0.0])?;
/// let both = left.merged(1.0, &right, 1.0)?;
/// assert_eq!(both.mean(), [0.0, 0.0]);
/// assert!((both.covariance().entries()[0] - 0.01).abs() < 1e-15);
/// let lobe = both.lobe(Roughness::from_alpha(0.05)?);
/// assert!((lobe.roughness().alphas().major - (0.0025_f64 + 0.02).sqrt()).abs() < 1e-15);
/// # Ok::<(), lobe::Error>(())
/// ```
// Further methods: slope/algebra.rs, material/lean/storage.rs.
#[doc(alias = "LobeSlopeMoments")]
#[doc(alias = "lobe_slope_moments_add")]
#[doc(alias = "lobe_slope_moments_mul")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SlopeMoments<R> {
    mean: [R; 2],
    covariance: Psd<R>,
}

impl<R: Real> SlopeMoments<R> {
    /// A mean and a covariance.
    ///
    /// # Errors
    /// [`Error::Mean`] unless both components lie in $[-10^9, 10^9]$.
    #[doc(alias = "lobe_slope_moments_new")]
    pub fn new(mean: impl Into<[R; 2]>, covariance: Psd<R>) -> Result<Self, Error> {
        Ok(Self { mean: checked_slope(mean)?, covariance })
    }

    /// The same of a mean and a covariance that are known to be in range.
    #[inline]
    pub(crate) const fn unchecked(mean: [R; 2], covariance: Psd<R>) -> Self {
        Self { mean, covariance }
    }

    /// One slope: no spread.
    ///
    /// # Errors
    /// [`Error::Mean`], as [`SlopeMoments::new`].
    #[doc(alias = "lobe_slope_moments_of_slope")]
    pub fn of_slope(slope: impl Into<[R; 2]>) -> Result<Self, Error> {
        Self::new(slope, Psd::zero())
    }

    /// From raw moments $\mathrm{E}\,s$ and $\mathrm{E}\,s s^T$ (`[xx, xy, yy]`), as LEAN textures
    /// store them.
    ///
    /// $\Sigma = \mathrm{E}\,s s^T - (\mathrm{E}\,s)(\mathrm{E}\,s)^T$ by compensated products:
    /// what precision the moments have left after storage is kept. Storage rounding can make
    /// $\Sigma$ indefinite: its negative eigenvalues are then set to 0, the nearest covariance
    /// there is.
    ///
    /// Source: Olano & Baker 2010, Eq. 5.
    ///
    /// # Errors
    /// [`Error::Mean`], [`Error::MatrixEntry`].
    ///
    /// ```
    /// let m = lobe::SlopeMoments::from_raw([0.5_f32, 0.0], [0.26, 0.0, 0.04])?;
    /// assert!((m.covariance().entries()[0] - 0.01).abs() < 1e-7);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_slope_moments_from_raw")]
    pub fn from_raw(mean: impl Into<[R; 2]>, second: [R; 3]) -> Result<Self, Error> {
        let [x, y] = mean.into();
        if let Some(&beyond) = second.iter().find(|m| !(m.abs() <= R::LARGEST * R::LARGEST)) {
            return Err(Error::MatrixEntry(beyond.into()));
        }
        let mean = checked_slope([x, y])?;
        Ok(Self { mean, covariance: central(mean, second) })
    }

    /// From raw moments of a texture: [`SlopeMoments::from_raw`] of the nearest numbers in its
    /// ranges, of 0 where there is NaN.
    ///
    /// ```
    /// use lobe::SlopeMoments;
    /// let (mean, second) = ([0.5_f32, 0.0], [0.26, 0.0, 0.04]);
    /// let moments = SlopeMoments::from_raw(mean, second)?;
    /// assert_eq!(SlopeMoments::saturating_raw(mean, second), moments);
    /// assert_eq!(SlopeMoments::saturating_raw([f32::NAN, 0.0], [0.0; 3]), Default::default());
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[inline(always)]
    pub fn saturating_raw(mean: impl Into<[R; 2]>, second: [R; 3]) -> Self {
        let ([x, y], [xx, xy, yy]) = (mean.into(), second);
        let mean = [within(x, R::LARGEST), within(y, R::LARGEST)];
        let largest = R::LARGEST * R::LARGEST;
        let second = [within(xx, largest), within(xy, largest), within(yy, largest)];
        Self { mean, covariance: central(mean, second) }
    }

    /// The mean slope.
    pub const fn mean(&self) -> [R; 2] {
        self.mean
    }

    /// The covariance of the slopes.
    pub const fn covariance(&self) -> Psd<R> {
        self.covariance
    }

    /// The moments of two patches together, by area.
    ///
    /// The parallel-axis theorem: mean of the covariances plus covariance of the means, all terms
    /// positive semi-definite, nothing cancels.
    ///
    /// # Errors
    /// [`Error::Weight`] if a weight is negative or not finite; [`Error::WeightSum`] if their sum
    /// is 0 or infinite.
    #[doc(alias = "parallel-axis")]
    #[doc(alias = "lobe_slope_moments_merged")]
    pub fn merged(&self, weight: R, other: &Self, other_weight: R) -> Result<Self, Error> {
        let sum = weight + other_weight;
        let known = |weight: &&R| **weight >= R::ZERO && weight.is_finite();
        if let Some(&bad) = [weight, other_weight].iter().find(|weight| !known(weight)) {
            return Err(Error::Weight(bad.into()));
        }
        if !(sum > R::ZERO && sum.is_finite()) {
            return Err(Error::WeightSum(sum.into()));
        }
        Ok(self.shared(weight / sum, other, other_weight / sum))
    }

    /// [`SlopeMoments::merged`] by shares `p` and `q` of the whole, not negative, with sum 1.
    #[inline]
    pub(crate) fn shared(&self, p: R, other: &Self, q: R) -> Self {
        let d = [other.mean[0] - self.mean[0], other.mean[1] - self.mean[1]];
        let spread = (p * q).sqrt();
        let between = Psd::outer_sum(d.map(|x| x * spread), [R::ZERO; 2]);
        Self {
            mean: [self.mean[0] + q * d[0], self.mean[1] + q * d[1]],
            covariance: ((self.covariance * p) + other.covariance * q) + between,
        }
    }

    /// The lobe of this patch over a base material: mean slope, $A = A_{base} + 2\Sigma$.
    ///
    /// Exact for Beckmann (LEAN); for GGX the variance is added as if it were one.
    #[doc(alias = "lobe_slope_moments_lobe")]
    pub fn lobe(&self, base: Roughness<R>) -> Lobe<R> {
        let roughness = base + Roughness::from_covariance(self.covariance);
        Lobe::centered(roughness).with_mean(self.mean)
    }
}

/// The nearest covariance of raw second moments about a mean.
#[inline(always)]
fn central<R: Real>([x, y]: [R; 2], [xx, xy, yy]: [R; 3]) -> Psd<R> {
    let about = |raw: R, a: R, b: R| difference_of_products(raw, R::ONE, a, b);
    Psd::nearest(about(xx, x, x), about(xy, x, y), about(yy, y, y))
}

/// The nearest number up to `largest` in size, 0 for NaN.
#[inline(always)]
fn within<R: Real>(x: R, largest: R) -> R {
    let bounded = x.max(-largest).min(largest);
    if x.abs() >= R::ZERO { bounded } else { R::ZERO }
}
