//! Algebra of slope moments: reliefs that add, lean, stretch and turn.
//!
//! Layer 1. Heights add, so slopes add; texture coordinates are linear in position, so slopes
//! transform linearly. Blending by area is [`SlopeMoments::merged`].

use super::jacobian::{Matrix, apply};
use super::moments::SlopeMoments;
use crate::error::Error;
use crate::scalar::exact::{cross, difference_of_products};
use crate::scalar::{Psd, Real};
use core::ops::{Add, AddAssign, Mul};

impl<R: Real> Add for SlopeMoments<R> {
    type Output = Self;

    /// Two independent reliefs, one on the other: $\mu_1 + \mu_2$, $\Sigma_1 + \Sigma_2$.
    ///
    /// Source: Olano & Baker 2010, section 5 (their raw moments also need $\mu_1 \mu_2^T + \mu_2
    /// \mu_1^T$, which central ones do not).
    ///
    /// ```
    /// use lobe::{Roughness, SlopeMoments};
    /// let waves = SlopeMoments::new(
    ///     [0.1_f64, 0.0],
    ///     Roughness::from_sigma_rho(0.3, 0.0, 0.0)?.covariance(),
    /// )?;
    /// let ripples =
    ///     SlopeMoments::new([0.0, 0.2], Roughness::from_sigma_rho(0.4, 0.1, 0.0)?.covariance())?;
    /// let both = waves + ripples;
    /// assert_eq!(both.mean(), [0.1, 0.2]);
    /// assert!((both.covariance().entries()[0] - 0.25).abs() < 1e-15);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    fn add(self, other: Self) -> Self {
        let ([x, y], [p, q]) = (self.mean(), other.mean());
        Self::bounded([x + p, y + q], self.covariance() + other.covariance())
    }
}

impl<R: Real> AddAssign for SlopeMoments<R> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<R: Real> Mul<R> for SlopeMoments<R> {
    type Output = Self;

    /// Heights times `factor`: $t \mu$, $t^2 \Sigma$. Of either sign; beyond $10^9$ it counts as
    /// that, NaN as 0.
    ///
    /// ```
    /// let relief = lobe::SlopeMoments::of_slope([0.1_f32, -0.2])? * -2.0;
    /// assert_eq!(relief.mean(), [-0.2, 0.4]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    fn mul(self, factor: R) -> Self {
        let factor = within(factor, R::LARGEST);
        let [x, y] = self.mean();
        Self::bounded([factor * x, factor * y], self.covariance() * (factor * factor))
    }
}

impl<R: Real> SlopeMoments<R> {
    /// Two reliefs that are correlated: $\Sigma_1 + \Sigma_2 + C + C^T$ with
    /// $C = \mathrm{E}\,s_1 s_2^T - \mu_1 \mu_2^T$, rows first.
    ///
    /// A `cross` that the two covariances do not allow can make the sum indefinite: its negative
    /// eigenvalues are then set to 0, as in [`SlopeMoments::from_raw`]. Entries of `cross` beyond
    /// $10^{18}$ count as that, NaN as 0.
    ///
    /// Source: Olano & Baker 2010, section 5, of central moments.
    ///
    /// ```
    /// use lobe::{Roughness, SlopeMoments};
    /// let relief = SlopeMoments::new(
    ///     [0.1_f64, 0.0],
    ///     Roughness::from_sigma_rho(0.3, 0.2, 0.0)?.covariance(),
    /// )?;
    /// // A relief on itself is twice as high, on its negative flat.
    /// let cross = [[0.09, 0.0], [0.0, 0.04]];
    /// let (twice, same) = (relief * 2.0, relief.plus_correlated(&relief, cross));
    /// assert!((twice.covariance().trace() - same.covariance().trace()).abs() < 1e-14);
    /// let flat = relief.plus_correlated(&(relief * -1.0), cross.map(|row| row.map(|c| -c)));
    /// assert!(flat.covariance().trace() < 1e-14);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_slope_moments_plus_correlated")]
    #[must_use]
    pub fn plus_correlated(&self, other: &Self, cross: Matrix<R>) -> Self {
        let kept = |x: R| within(x, R::LARGEST * R::LARGEST);
        let ([x, y], [p, q]) = (self.mean(), other.mean());
        let (a, b) = (self.covariance().entries(), other.covariance().entries());
        let covariance = Psd::nearest(
            a[0] + b[0] + R::TWO * kept(cross[0][0]),
            a[1] + b[1] + (kept(cross[0][1]) + kept(cross[1][0])),
            a[2] + b[2] + R::TWO * kept(cross[1][1]),
        );
        Self::bounded([x + p, y + q], covariance)
    }

    /// $C = \mathrm{E}\,s_1 s_2^T - \mu_1 \mu_2^T$ of two reliefs from their stored cross moment
    /// $\mathrm{E}\,s_1 s_2^T$, both rows first, by compensated products.
    ///
    /// ```
    /// use lobe::SlopeMoments;
    /// let (a, b) = (SlopeMoments::of_slope([0.5_f64, 0.0])?, SlopeMoments::of_slope([0.0, 2.0])?);
    /// assert_eq!(a.cross_covariance(&b, [[0.0, 1.0], [0.0, 0.0]]), [[0.0; 2]; 2]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_slope_moments_cross_covariance")]
    pub fn cross_covariance(&self, other: &Self, moment: Matrix<R>) -> Matrix<R> {
        let (a, b) = (self.mean(), other.mean());
        let central = |m: R, p: R, q: R| difference_of_products(m, R::ONE, p, q);
        [
            [central(moment[0][0], a[0], b[0]), central(moment[0][1], a[0], b[1])],
            [central(moment[1][0], a[1], b[0]), central(moment[1][1], a[1], b[1])],
        ]
    }

    /// The same relief on a plane of slope `slope`: $\mu + s$, $\Sigma$ as it is.
    ///
    /// # Errors
    /// [`Error::Mean`] unless both components lie in $[-10^9, 10^9]$.
    ///
    /// ```
    /// let leaning = lobe::SlopeMoments::of_slope([0.1_f32, 0.0])?.tilted([0.4, 1.0])?;
    /// assert_eq!(leaning.mean(), [0.5, 1.0]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_slope_moments_tilted")]
    pub fn tilted(&self, slope: impl Into<[R; 2]>) -> Result<Self, Error> {
        Ok(*self + Self::of_slope(slope)?)
    }

    /// Slopes under a linear map, $s' = M s$, `matrix` rows first: $M \mu$, $M \Sigma M^T$.
    ///
    /// A texture with coordinates $u = T x$ of the position $x$ has slopes $T^T s$ there: repeated
    /// twice as often it is twice as steep. Entries beyond $10^9$ count as that, NaN as 0; results
    /// beyond the ranges of slopes and covariances are scaled into them.
    ///
    /// ```
    /// use lobe::{Roughness, SlopeMoments};
    /// let brushed = SlopeMoments::new(
    ///     [0.0_f64, 0.1],
    ///     Roughness::from_sigma_rho(0.4, 0.0, 0.0)?.covariance(),
    /// )?;
    /// let quarter_turn = brushed.transformed([[0.0, -1.0], [1.0, 0.0]]);
    /// assert_eq!(quarter_turn.mean(), [-0.1, 0.0]);
    /// assert!((quarter_turn.covariance().entries()[2] - 0.16).abs() < 1e-15);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_slope_moments_transformed")]
    #[must_use]
    pub fn transformed(&self, matrix: Matrix<R>) -> Self {
        let matrix = matrix.map(|row| row.map(|x| within(x, R::LARGEST)));
        let [l11, l21, l22] = self.covariance().cholesky();
        let (u, v) = (apply(matrix, [l11, l21]), apply(matrix, [R::ZERO, l22]));
        let det = cross(matrix[0], matrix[1]).abs();
        // The product of determinants, not that of the rounded product.
        let root_det = det * self.covariance().root_det();
        let covariance = Psd::outer_sum_with_root_det(u, v, root_det);
        Self::bounded(apply(matrix, self.mean()), covariance)
    }

    /// The relief turned by `angle`, counter-clockwise (radians): a texture's rotation. A tangent
    /// frame that turns by an angle sees the relief turned by its negative.
    ///
    /// # Errors
    /// [`Error::Angle`] unless finite.
    ///
    /// ```
    /// let turned =
    ///     lobe::SlopeMoments::of_slope([1.0_f64, 0.0])?.rotated(core::f64::consts::FRAC_PI_6)?;
    /// assert!((turned.mean()[1] - 0.5).abs() < 1e-15);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn rotated(&self, angle: R) -> Result<Self, Error> {
        if !angle.is_finite() {
            return Err(Error::Angle(angle.into()));
        }
        let (sin, cos) = angle.sin_cos();
        Ok(self.transformed([[cos, -sin], [sin, cos]]))
    }

    /// Mean and covariance brought into their ranges: what lies beyond is scaled to their ends.
    fn bounded(mean: [R; 2], covariance: Psd<R>) -> Self {
        let limit = R::LARGEST * R::LARGEST;
        let [xx, _, yy] = covariance.entries();
        let most = xx.max(yy);
        let covariance = if most > limit { covariance * (limit / most) } else { covariance };
        Self::unchecked(mean.map(|x| x.max(-R::LARGEST).min(R::LARGEST)), covariance)
    }
}

/// The nearest number in [-limit, limit]; 0 for NaN.
fn within<R: Real>(x: R, limit: R) -> R {
    let known = x <= R::ZERO || x >= R::ZERO;
    if known { x.max(-limit).min(limit) } else { R::ZERO }
}
