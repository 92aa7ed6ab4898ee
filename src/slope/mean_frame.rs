//! The frame about the mean of slopes: where a relief leans, its own normal is +z.
//!
//! Layer 1. A lobe with a mean of its own stays where it is ([`NonCentered`](super::NonCentered));
//! masking that knows even lobes alone needs the frame in which it is one.

use super::direction::{dot, normal_of};
use super::jacobian::Matrix;
use super::moments::SlopeMoments;
use crate::scalar::Real;

/// The tangent frame turned, by the shortest way, until +z is the normal of a mean slope.
///
/// ```
/// use lobe::SlopeMoments;
/// use lobe::slope::MeanFrame;
/// let frame = MeanFrame::of([0.75_f64, 0.0]);
/// let [x, y, z] = frame.to_local([-0.6, 0.0, 0.8]);
/// assert!(x.abs() < 1e-15 && y == 0.0 && (z - 1.0).abs() < 1e-15);
/// // Seen from there, slopes along the tilt are cos^2 of it as steep, and across it cos.
/// let leaning = SlopeMoments::new([0.75, 0.0], lobe::Psd::new(1.0, 0.0, 1.0)?)?;
/// let [xx, xy, yy] = frame.moments(&leaning).covariance().entries();
/// assert!((xx - 0.8_f64.powi(4)).abs() < 1e-12 && xy == 0.0 && (yy - 0.64).abs() < 1e-12);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "LobeMeanFrame")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanFrame<R> {
    /// Its axes, in the tangent frame: x, y, and the normal.
    axes: [[R; 3]; 3],
}

impl<R: Real> MeanFrame<R> {
    /// About this mean slope, with components in $[-10^9, 10^9]$.
    #[doc(alias = "lobe_mean_frame_of")]
    #[inline]
    pub fn of(mean: impl Into<[R; 2]>) -> Self {
        let normal = normal_of(mean);
        let [a, b, c] = normal;
        // c > 0: no division by nothing.
        let inverse = R::ONE / (R::ONE + c);
        let skew = -a * b * inverse;
        Self {
            axes: [
                [R::ONE - a * a * inverse, skew, -a],
                [skew, R::ONE - b * b * inverse, -b],
                normal,
            ],
        }
    }

    /// A direction of the tangent frame, in this one.
    #[doc(alias = "lobe_mean_frame_to_local")]
    #[inline]
    pub fn to_local(&self, w: impl Into<[R; 3]>) -> [R; 3] {
        let w = w.into();
        self.axes.map(|axis| dot(axis, w))
    }

    /// A direction of this frame, in the tangent frame.
    ///
    /// ```
    /// let frame = lobe::slope::MeanFrame::of([0.75_f64, 0.2]);
    /// let back = frame.to_tangent(frame.to_local([0.6, 0.0, 0.8]));
    /// assert!(
    ///     (back[0] - 0.6).abs() < 1e-15 && back[1].abs() < 1e-15 && (back[2] - 0.8).abs() < 1e-15
    /// );
    /// ```
    #[doc(alias = "lobe_mean_frame_to_tangent")]
    #[inline]
    pub fn to_tangent(&self, w: impl Into<[R; 3]>) -> [R; 3] {
        let w = w.into();
        let [x, y, normal] = self.axes;
        [0, 1, 2].map(|k| dot([x[k], y[k], normal[k]], w))
    }

    /// Derivative of the slope in this frame by that in the tangent frame, at the mean: $c
    /// \begin{pmatrix} x_x & x_y \\\\ y_x & y_y \end{pmatrix}$ of the axes x and y, c being the
    /// cosine of the tilt.
    ///
    /// Along the tilt $c^2$, across it c; $\det = c^3$.
    #[doc(alias = "lobe_mean_frame_jacobian")]
    #[inline]
    pub fn jacobian(&self) -> Matrix<R> {
        let [x, y, [_, _, c]] = self.axes;
        [[c * x[0], c * x[1]], [c * y[0], c * y[1]]]
    }

    /// Moments about their mean in this frame, to first order: mean 0, $J \Sigma J^T$.
    ///
    /// Source: in place of Chermain, Lucas et al. 2021, section 5, who take over the covariance as
    /// it is.
    #[doc(alias = "lobe_mean_frame_moments")]
    #[must_use]
    #[inline]
    pub fn moments(&self, moments: &SlopeMoments<R>) -> SlopeMoments<R> {
        SlopeMoments::unchecked([R::ZERO; 2], moments.covariance()).transformed(self.jacobian())
    }
}
