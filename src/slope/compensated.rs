//! The shape of a matrix of exact entries, in compensated arithmetic.
//!
//! Layer 1. Validation and offline work use it; the other shapes cost a third of its price.

use super::anisotropic::major_of;
use super::direction::checked_slope;
use super::shape::{Extent, LobeShape};
use super::whiten::Whiten;
use crate::error::Error;
use crate::scalar::exact::{
    add_product, add_products, difference_of_products, sum_of_products, two_sum,
};
use crate::scalar::{Psd, Real};

/// Any A and any mean, forward accurate: the answers are right to a few roundings for parameters
/// and directions that are exact as they are given.
///
/// The other shapes are backward accurate: right for parameters moved by a few roundings, which
/// shows where a lobe is long and thin or narrow and tilted. The two agree within what the
/// parameters' own rounding does. Determinant, form and mean area are compensated: the textbook
/// $a_{yy} v_x^2 - 2 a_{xy} v_x v_y + a_{xx} v_y^2$ loses four digits at rho = 0.9999 in f32, and a
/// rounded difference of slopes 1e-3 alphas at mean 1 and alpha 1e-4.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Compensated<R> {
    mean: [R; 2],
    xx: R,
    xy: R,
    yy: R,
    root_det: R,
    inverse_xx: R,
    along: R,
    across: R,
    /// det A / a_xx: what the stretch has left across the first row; a_yy where a_xx is 0.
    schur: R,
}

impl<R: Real> Compensated<R> {
    /// From a mean slope and the entries `[xx, xy, yy]` of A.
    ///
    /// # Errors
    /// As [`Lobe::new`](super::Lobe::new) and [`Psd::new`].
    ///
    /// ```
    /// use lobe::{Ggx, Lobe, Psd, Roughness, slope::Compensated};
    /// let entries = [0.04_f64, 0.01, 0.09];
    /// let exact = Ggx::new(Compensated::new([0.1, 0.0], entries)?);
    /// let [xx, xy, yy] = entries;
    /// let lobe = Lobe::new([0.1, 0.0], Roughness::from_matrix(Psd::new(xx, xy, yy)?))?;
    /// let plain = Ggx::new(lobe.shape());
    /// assert!((exact.slope_pdf([0.2, 0.1]) / plain.slope_pdf([0.2, 0.1]) - 1.0).abs() < 1e-14);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn new(mean: impl Into<[R; 2]>, [xx, xy, yy]: [R; 3]) -> Result<Self, Error> {
        let mean = checked_slope(mean)?;
        Psd::new(xx, xy, yy)?;
        let (zero, least) = (R::ZERO, R::MIN_POSITIVE);
        let root_det = difference_of_products(xx, yy, xy, xy).max(zero).sqrt();
        let minor = root_det * (root_det / (xx + yy).max(least)).kept();
        let root_det = if minor.min(xx).min(yy) >= least { root_det } else { zero };
        let flat = xx < least;
        let inverse = R::ONE / xx.max(least);
        let along = root_det * inverse;
        Ok(Self {
            mean,
            xx,
            xy,
            yy,
            root_det,
            inverse_xx: if flat { zero } else { inverse },
            along,
            across: (xx / root_det.max(least)).min(R::MAX),
            schur: if flat { yy } else { root_det * along },
        })
    }

    /// The form of $m + m_{low}$, an unevaluated sum whose second part is of the order of rounding:
    /// $n = v_x^2 \sqrt{\det A}/a_{xx} + t^2 a_{xx}/\sqrt{\det A}$ with $t = v_y - v_x
    /// a_{xy}/a_{xx}$ from one compensated product.
    #[inline(always)]
    fn form_of(&self, m: [R; 3], m_low: [R; 3]) -> R {
        let (x, x_low) = add_product(m[0], self.mean[0], m[2]);
        let (y, y_low) = add_product(m[1], self.mean[1], m[2]);
        let x_low = x_low + (m_low[0] + self.mean[0] * m_low[2]);
        let y_low = y_low + (m_low[1] + self.mean[1] * m_low[2]);
        let low = self.xx * y_low - self.xy * x_low;
        let u = difference_of_products(self.xx, y, self.xy, x) + low;
        let (x, t) = (x + x_low, u * self.inverse_xx);
        x * x * self.along + t * t * self.across
    }
}

impl<R: Real> LobeShape for Compensated<R> {
    type Scalar = R;
    const CENTERED: bool = false;

    #[inline(always)]
    fn extent(&self) -> Extent<R> {
        Extent { root_det: self.root_det, unit: self.root_det, scale: R::ONE }
    }
    #[inline(always)]
    fn form(&self, m: [R; 3]) -> R {
        self.form_of(m, [R::ZERO; 3])
    }
    #[inline(always)]
    fn form_of_sum(&self, wo: [R; 3], wi: [R; 3]) -> R {
        let [x, y, z] = [0, 1, 2].map(|k| two_sum(wo[k], wi[k]));
        self.form_of([x.0, y.0, z.0], [x.1, y.1, z.1])
    }
    #[inline(always)]
    fn adjugate_form(&self, v: [R; 2]) -> R {
        let u = difference_of_products(self.xx, v[1], self.xy, v[0]);
        u * (u * self.inverse_xx) + self.schur * v[0] * v[0]
    }
    #[inline(always)]
    fn stretch_squared(&self, w: [R; 3]) -> R {
        let u = sum_of_products(self.xx, w[0], self.xy, w[1]);
        // In this order a column of float noise does not underflow.
        u * (u * self.inverse_xx) + self.schur * w[1] * w[1]
    }
    #[inline(always)]
    fn mean_area(&self, w: [R; 3]) -> R {
        let [x, y] = self.mean;
        add_products(w[2], -x, w[0], -y, w[1])
    }
}

impl<R: Real> Whiten for Compensated<R> {
    #[inline(always)]
    fn offset(&self, slope: [R; 2]) -> ([R; 2], [R; 2]) {
        let (x, x_low) = two_sum(slope[0], -self.mean[0]);
        let (y, y_low) = two_sum(slope[1], -self.mean[1]);
        ([x, y], [x_low, y_low])
    }
    #[inline(always)]
    fn whiten(&self, v: [R; 2], v_low: [R; 2]) -> [R; 2] {
        let low = self.xx * v_low[1] - self.xy * v_low[0];
        let u = difference_of_products(self.xx, v[1], self.xy, v[0]) + low;
        let l_xx = self.xx.sqrt();
        [(v[0] + v_low[0]) / l_xx, u * self.inverse_xx * l_xx / self.root_det]
    }
    #[inline(always)]
    fn major(&self) -> ([R; 2], R) {
        major_of([self.xx, self.xy, self.yy])
    }
    #[inline(always)]
    fn factor(&self) -> [R; 3] {
        Psd::with_root_det([self.xx, self.xy, self.yy], self.root_det).cholesky()
    }
}
