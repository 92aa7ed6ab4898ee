//! A shape moved off center: what a normal map or a displacement map leaves of a lobe.
//!
//! Layer 1.

use super::direction::checked_slope;
use super::shape::{Extent, LobeShape};
use super::whiten::Whiten;
use crate::error::Error;
use crate::scalar::Real;
use crate::scalar::exact::two_sum;

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

    /// From a mean slope of a texture: the nearest components in $[-10^9, 10^9]$ count, NaN as one
    /// of its ends.
    ///
    /// ```
    /// use lobe::{Isotropic, NonCentered};
    /// let shape = Isotropic::saturating(0.1_f32);
    /// let mean = [0.3, 0.0];
    /// assert_eq!(NonCentered::saturating(shape, mean), NonCentered::new(shape, mean)?);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[inline(always)]
    pub fn saturating(shape: S, mean: impl Into<[S::Scalar; 2]>) -> Self {
        let largest = S::Scalar::LARGEST;
        let [x, y] = mean.into();
        Self { shape, mean: [x.max(-largest).min(largest), y.max(-largest).min(largest)] }
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
    fn extent(&self) -> Extent<S::Scalar> {
        self.shape.extent()
    }
    #[inline(always)]
    fn form(&self, m: [S::Scalar; 3]) -> S::Scalar {
        let [x, y] = self.relative(m);
        self.shape.form([x, y, m[2]])
    }
    #[inline(always)]
    fn relative(&self, m: [S::Scalar; 3]) -> [S::Scalar; 2] {
        let ([x, y], [mean_x, mean_y]) = (self.shape.relative(m), self.mean);
        [x + mean_x * m[2], y + mean_y * m[2]]
    }
    #[inline(always)]
    fn adjugate_form(&self, v: [S::Scalar; 2]) -> S::Scalar {
        self.shape.adjugate_form(v)
    }
    #[inline(always)]
    fn widened_det(&self, u: [S::Scalar; 2], v: [S::Scalar; 2]) -> S::Scalar {
        self.shape.widened_det(u, v)
    }
    #[inline(always)]
    fn stretch_squared(&self, w: [S::Scalar; 3]) -> S::Scalar {
        self.shape.stretch_squared(w)
    }
    #[inline(always)]
    fn mean_area(&self, w: [S::Scalar; 3]) -> S::Scalar {
        let [x, y] = self.mean;
        self.shape.mean_area(w) - (x * w[0] + y * w[1])
    }
}

impl<S: Whiten> Whiten for NonCentered<S> {
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
    fn factor(&self) -> [S::Scalar; 3] {
        self.shape.factor()
    }
    #[inline(always)]
    fn whiten_with(&self, v: [S::Scalar; 2], inverse_root_det: S::Scalar) -> [S::Scalar; 2] {
        self.shape.whiten_with(v, inverse_root_det)
    }
}
