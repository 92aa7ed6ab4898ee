//! The shape of any roughness matrix.
//!
//! Layer 1. [`LobeShape`] says what it answers; these answers are compensated.

use super::roughness::Roughness;
use super::shape::{AxisAligned, Isotropic, LobeShape};
use crate::scalar::Real;
use crate::scalar::exact::{difference_of_products, sum_of_products};

/// Any A, centered.
///
/// The form is a sum of squares, $n = v_x^2 \sqrt{\det A}/a_{xx} + t^2 a_{xx}/\sqrt{\det A}$ with
/// $t = v_y - v_x a_{xy}/a_{xx}$ from one compensated product: the textbook
/// $a_{yy} v_x^2 - 2 a_{xy} v_x v_y + a_{xx} v_y^2$ loses four digits at rho = 0.9999.
#[doc(alias = "LobeAnisotropic")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anisotropic<R> {
    xx: R,
    xy: R,
    root_det: R,
    inverse_xx: R,
    along: R,
    across: R,
    /// det A / a_xx: what the stretch has left across the first row; a_yy where a_xx is 0.
    schur: R,
}

impl<R: Real> Anisotropic<R> {
    /// From a roughness; precomputes what evaluation needs.
    ///
    /// ```
    /// use lobe::{Anisotropic, Ggx, Roughness};
    /// let ggx = Ggx::new(Anisotropic::new(Roughness::from_alphas(0.5_f64, 0.05, 0.7)?));
    /// assert!(ggx.slope_pdf([0.1, 0.1]) > 0.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_anisotropic_new")]
    #[inline]
    pub fn new(roughness: Roughness<R>) -> Self {
        let matrix = roughness.matrix();
        let [xx, xy, yy] = matrix.entries();
        let (zero, least) = (R::ZERO, R::MIN_POSITIVE);
        // Selects instead of branches: loops over samples stay free of jumps.
        let root_det = if matrix.is_singular() { zero } else { matrix.root_det() };
        let flat = xx < least;
        let inverse = R::ONE / xx.max(least);
        let along = root_det * inverse;
        Self {
            xx,
            xy,
            root_det,
            inverse_xx: if flat { zero } else { inverse },
            along,
            across: (xx / root_det.max(least)).min(R::MAX),
            schur: if flat { yy } else { root_det * along },
        }
    }
}

#[cfg(feature = "bytemuck")]
impl<R: Real> Anisotropic<R> {
    /// All numbers, in the order of the port's structure.
    pub(crate) const fn numbers(&self) -> [R; 7] {
        let Self { xx, xy, root_det, inverse_xx, along, across, schur } = *self;
        [xx, xy, root_det, inverse_xx, along, across, schur]
    }
}

impl<R: Real> From<Roughness<R>> for Anisotropic<R> {
    fn from(roughness: Roughness<R>) -> Self {
        Self::new(roughness)
    }
}

impl<R: Real> From<Isotropic<R>> for Anisotropic<R> {
    fn from(shape: Isotropic<R>) -> Self {
        Self::new(shape.into())
    }
}

impl<R: Real> From<AxisAligned<R>> for Anisotropic<R> {
    fn from(shape: AxisAligned<R>) -> Self {
        Self::new(shape.into())
    }
}

impl<R: Real> LobeShape for Anisotropic<R> {
    type Scalar = R;
    const CENTERED: bool = true;

    #[inline(always)]
    fn root_det(&self) -> R {
        self.root_det
    }
    #[inline(always)]
    fn form(&self, m: [R; 3], m_low: [R; 3]) -> R {
        let low = self.xx * m_low[1] - self.xy * m_low[0];
        let u = difference_of_products(self.xx, m[1], self.xy, m[0]) + low;
        let t = u * self.inverse_xx;
        m[0] * m[0] * self.along + t * t * self.across
    }
    #[inline(always)]
    fn offset(&self, slope: [R; 2]) -> ([R; 2], [R; 2]) {
        (slope, [R::ZERO; 2])
    }
    #[inline(always)]
    fn whiten(&self, v: [R; 2], v_low: [R; 2]) -> [R; 2] {
        let low = self.xx * v_low[1] - self.xy * v_low[0];
        let u = difference_of_products(self.xx, v[1], self.xy, v[0]) + low;
        let l11 = self.xx.sqrt();
        [(v[0] + v_low[0]) / l11, u * self.inverse_xx * l11 / self.root_det]
    }
    /// From the row with the larger diagonal entry, $(x, y)$ with $x$ that entry: $\alpha^2 =
    /// (x^2 + y^2)/x$.
    #[inline(always)]
    fn major(&self) -> ([R; 2], R) {
        let yy = self.xy * (self.xy * self.inverse_xx) + self.schur;
        let swap = yy > self.xx;
        let large = if swap { yy } else { self.xx };
        let ratio = self.xy / large.max(R::MIN_POSITIVE);
        let square = R::ONE + ratio * ratio;
        let inverse = R::ONE / square.sqrt();
        let (along, across) = (inverse, ratio * inverse);
        let axis = if swap { [across, along] } else { [along, across] };
        (axis, (large * square).sqrt())
    }
    #[inline(always)]
    fn stretch_squared(&self, w: [R; 3]) -> R {
        let u = sum_of_products(self.xx, w[0], self.xy, w[1]);
        // In this order a column of float noise does not underflow.
        u * (u * self.inverse_xx) + self.schur * w[1] * w[1]
    }
    #[inline(always)]
    fn mean_area(&self, w: [R; 3]) -> R {
        w[2]
    }
}
