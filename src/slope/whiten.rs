//! Slopes in units of a lobe: what exact means over polygons ask of a shape.
//!
//! Layer 1.

use super::shape::{AxisAligned, Isotropic, LobeShape};
use crate::scalar::Real;

/// What exact means over polygons ask of a shape beside: its coordinates in units of the lobe.
pub trait Whiten: LobeShape {
    /// The slope relative to the mean, $s - \mu$, as an unevaluated sum, high and low.
    #[doc(alias = "lobe_non_centered_offset")]
    #[inline(always)]
    fn offset(&self, slope: [Self::Scalar; 2]) -> ([Self::Scalar; 2], [Self::Scalar; 2]) {
        (slope, [Self::Scalar::ZERO; 2])
    }

    /// $L^{-1} v$ with $L L^T = A$, for the difference of slopes `v + v_low`: lengths in units of
    /// the lobe. Not defined for a mirror.
    #[doc(alias = "lobe_anisotropic_whiten")]
    fn whiten(&self, v: [Self::Scalar; 2], v_low: [Self::Scalar; 2]) -> [Self::Scalar; 2];

    /// The unit vector of the major axis of A, and alpha along it: all that is left of a groove,
    /// whose A has rank one.
    ///
    /// $A \approx \alpha^2 g g^T$ for the vector g and alpha, up to the minor axis. `[1, 0]` for a
    /// round A.
    ///
    /// ```
    /// use lobe::{AxisAligned, slope::Whiten};
    /// assert_eq!(AxisAligned::new(0.0_f32, 0.3)?.major(), ([0.0, 1.0], 0.3));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_anisotropic_major")]
    fn major(&self) -> ([Self::Scalar; 2], Self::Scalar);

    /// The factor itself, lower triangular: $[l_{xx}, l_{yx}, l_{yy}]$.
    ///
    /// ```
    /// use lobe::{AxisAligned, slope::Whiten};
    /// assert_eq!(AxisAligned::new(0.5_f32, 0.3)?.factor(), [0.5, 0.0, 0.3]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    fn factor(&self) -> [Self::Scalar; 3];

    /// $L^{-1} v$ of a difference of slopes in plain arithmetic, given $1/\sqrt{\det A}$: one
    /// division serves all vectors of a lobe. Good to some roundings of the largest product, where
    /// [`Whiten::whiten`] is good to some of its result.
    ///
    /// ```
    /// use lobe::{AxisAligned, slope::Whiten};
    /// assert_eq!(AxisAligned::new(0.5_f64, 0.25)?.whiten_with([1.0, 1.0], 8.0), [2.0, 4.0]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[inline(always)]
    fn whiten_with(
        &self,
        v: [Self::Scalar; 2],
        inverse_root_det: Self::Scalar,
    ) -> [Self::Scalar; 2] {
        let [l_xx, l_yx, l_yy] = self.factor();
        let across = (l_xx * v[1] - l_yx * v[0]) * inverse_root_det;
        [(l_yy * inverse_root_det) * v[0], across]
    }
}

impl<R: Real> Whiten for Isotropic<R> {
    #[inline(always)]
    fn whiten(&self, v: [R; 2], _: [R; 2]) -> [R; 2] {
        let inverse = R::ONE / self.alpha();
        [v[0] * inverse, v[1] * inverse]
    }
    #[inline(always)]
    fn major(&self) -> ([R; 2], R) {
        ([R::ONE, R::ZERO], self.alpha())
    }
    #[inline(always)]
    fn factor(&self) -> [R; 3] {
        [self.alpha(), R::ZERO, self.alpha()]
    }
    #[inline(always)]
    fn whiten_with(&self, v: [R; 2], inverse_root_det: R) -> [R; 2] {
        let inverse = self.alpha() * inverse_root_det;
        [inverse * v[0], inverse * v[1]]
    }
}

impl<R: Real> Whiten for AxisAligned<R> {
    #[inline(always)]
    fn whiten(&self, v: [R; 2], _: [R; 2]) -> [R; 2] {
        [v[0] / self.alphas()[0], v[1] / self.alphas()[1]]
    }
    #[inline(always)]
    fn major(&self) -> ([R; 2], R) {
        let ([x, y], (zero, one)) = (self.alphas(), (R::ZERO, R::ONE));
        if y > x { ([zero, one], y) } else { ([one, zero], x) }
    }
    #[inline(always)]
    fn factor(&self) -> [R; 3] {
        [self.alphas()[0], R::ZERO, self.alphas()[1]]
    }
    #[inline(always)]
    fn whiten_with(&self, v: [R; 2], inverse_root_det: R) -> [R; 2] {
        let [alpha_x, alpha_y] = self.alphas();
        [(alpha_y * inverse_root_det) * v[0], (alpha_x * inverse_root_det) * v[1]]
    }
}
