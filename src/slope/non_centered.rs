//! A shape moved off center: what a normal map or a displacement map leaves of a lobe.
//!
//! Layer 1.

use super::direction::checked_slope;
use super::shape::LobeShape;
use crate::error::Error;
use crate::scalar::Internal;
use crate::scalar::exact::{add_product, add_products, two_sum};

/// A shape moved to a mean slope: the microsurface over a tilted plane, as LEAN and LEADR have it.
#[doc(alias = "LobeNonCentered")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NonCentered<S: LobeShape> {
    shape: S,
    mean: [S::Scalar; 2],
}

impl<S: LobeShape> NonCentered<S> {
    /// `shape` with its center moved by `mean`, a slope.
    ///
    /// # Errors
    /// [`Error::Mean`] unless both components lie in $[-10^9, 10^9]$.
    ///
    /// ```
    /// use lobe::{Ggx, Isotropic, NonCentered};
    /// let moved = Ggx::new(NonCentered::new(Isotropic::new(0.1_f32)?, [0.3, 0.0])?);
    /// let centered = Ggx::new(Isotropic::new(0.1_f32)?);
    /// assert_eq!(moved.slope_pdf([0.3, 0.0]), centered.slope_pdf([0.0, 0.0]));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_non_centered_new")]
    #[inline]
    pub fn new(shape: S, mean: impl Into<[S::Scalar; 2]>) -> Result<Self, Error> {
        Ok(Self { shape, mean: checked_slope(mean)? })
    }

    /// The shape around the mean.
    pub const fn shape(&self) -> &S {
        &self.shape
    }

    /// The mean slope.
    pub const fn mean(&self) -> [S::Scalar; 2] {
        self.mean
    }

    /// The same for a mean that is known to be valid.
    pub(crate) const fn unchecked(shape: S, mean: [S::Scalar; 2]) -> Self {
        Self { shape, mean }
    }
}

impl<S: LobeShape> LobeShape for NonCentered<S> {
    type Scalar = S::Scalar;
    const CENTERED: bool = false;

    #[inline(always)]
    fn root_det(&self) -> S::Scalar {
        self.shape.root_det()
    }
    /// The shift is exact to twice the precision: at mean 1 and alpha 1e-4 a rounded slope
    /// difference is off by 1e-3 alphas in f32.
    #[inline(always)]
    fn form(&self, m: [S::Scalar; 3], m_low: [S::Scalar; 3]) -> S::Scalar {
        let (x, x_low) = add_product(m[0], self.mean[0], m[2]);
        let (y, y_low) = add_product(m[1], self.mean[1], m[2]);
        let low = [
            x_low + (m_low[0] + self.mean[0] * m_low[2]),
            y_low + (m_low[1] + self.mean[1] * m_low[2]),
        ];
        // Renormalized, as centered shapes other than `Anisotropic` ignore the low part.
        let (x_sum, y_sum) = ((x + low[0]).kept(), (y + low[1]).kept());
        let rest = [low[0] - (x_sum - x).kept(), low[1] - (y_sum - y).kept(), m_low[2]];
        self.shape.form([x_sum, y_sum, m[2]], rest)
    }
    #[inline(always)]
    fn offset(&self, slope: [S::Scalar; 2]) -> ([S::Scalar; 2], [S::Scalar; 2]) {
        let ([x, y], low) = self.shape.offset(slope);
        let (x, x_low) = two_sum(x, -self.mean[0]);
        let (y, y_low) = two_sum(y, -self.mean[1]);
        ([x, y], [x_low + low[0], y_low + low[1]])
    }
    #[inline(always)]
    fn whiten(&self, v: [S::Scalar; 2], v_low: [S::Scalar; 2]) -> [S::Scalar; 2] {
        self.shape.whiten(v, v_low)
    }
    #[inline(always)]
    fn major(&self) -> ([S::Scalar; 2], S::Scalar) {
        self.shape.major()
    }
    #[inline(always)]
    fn stretch_squared(&self, w: [S::Scalar; 3]) -> S::Scalar {
        self.shape.stretch_squared(w)
    }
    #[inline(always)]
    fn mean_area(&self, w: [S::Scalar; 3]) -> S::Scalar {
        let [x, y] = self.mean;
        add_products(self.shape.mean_area(w), -x, w[0], -y, w[1])
    }
}
