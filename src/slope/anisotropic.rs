//! The shape of any roughness matrix.
//!
//! Layer 1. [`LobeShape`] says what it answers.

use super::roughness::Roughness;
use super::shape::{AxisAligned, Extent, Isotropic, LobeShape, extent_of};
use super::whiten::Whiten;
use crate::scalar::exact::difference_of_products;
use crate::scalar::{Psd, Real};

/// Any A, centered: the factor of its roughness.
///
/// With $A = L L^T$ the form is $(l_{xx} v_y - l_{yx} v_x)^2 + (l_{yy} v_x)^2$ and the squared
/// stretch $(l_{xx} w_x + l_{yx} w_y)^2 + (l_{yy} w_y)^2$: two squares each. A roughness whose
/// determinant is below the smallest normal number is a mirror along some axis.
#[doc(alias = "LobeAnisotropic")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anisotropic<R> {
    factor: Psd<R>,
    root_det: R,
}

impl<R: Real> Anisotropic<R> {
    /// From a roughness.
    ///
    /// ```
    /// use lobe::{Anisotropic, Ggx, Roughness};
    /// let ggx = Ggx::new(Anisotropic::new(Roughness::from_alphas(0.5_f64, 0.05, 0.7)?));
    /// assert!(ggx.slope_pdf([0.1, 0.1]) > 0.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_anisotropic_new")]
    #[inline(always)]
    pub fn new(roughness: Roughness<R>) -> Self {
        let factor = roughness.matrix();
        let root_det = if factor.is_singular() { R::ZERO } else { factor.root_det() };
        Self { factor, root_det }
    }

    /// From the factor `[l_xx, l_yx, l_yy]` of a texture or a buffer, $A = L L^T$: the nearest
    /// l_xx and l_yy in $[0, 10^9]$ and l_yx in $[-10^9, 10^9]$ count. Total and without a branch.
    ///
    /// ```
    /// use lobe::{Anisotropic, Roughness};
    /// let roughness = Roughness::from_alphas(0.5_f32, 0.05, 0.7)?;
    /// let shape = Anisotropic::saturating(roughness.matrix().cholesky());
    /// assert_eq!(shape, Anisotropic::new(roughness));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[inline(always)]
    pub fn saturating(factor: [R; 3]) -> Self {
        Self::new(Roughness::from_matrix(Psd::saturating_cholesky(factor)))
    }

    /// The roughness.
    #[inline]
    pub const fn roughness(&self) -> Roughness<R> {
        Roughness::from_matrix(self.factor)
    }
}

impl<R: Real> From<Roughness<R>> for Anisotropic<R> {
    fn from(roughness: Roughness<R>) -> Self {
        Self::new(roughness)
    }
}

/// [`Anisotropic::roughness`].
impl<R: Real> From<Anisotropic<R>> for Roughness<R> {
    fn from(shape: Anisotropic<R>) -> Self {
        shape.roughness()
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
    fn extent(&self) -> Extent<R> {
        extent_of(self.root_det)
    }
    #[inline(always)]
    fn adjugate_form(&self, v: [R; 2]) -> R {
        self.factor.adjugate_form(v)
    }
    #[inline(always)]
    fn stretch_squared(&self, w: [R; 3]) -> R {
        self.factor.quadratic([w[0], w[1]])
    }
}

impl<R: Real> Whiten for Anisotropic<R> {
    /// The cross product with the factor's first column is compensated: exact means over polygons
    /// are forward accurate in the factor.
    #[inline(always)]
    fn whiten(&self, v: [R; 2], v_low: [R; 2]) -> [R; 2] {
        let [l_xx, l_yx, _] = self.factor.cholesky();
        let low = l_xx * v_low[1] - l_yx * v_low[0];
        let across = difference_of_products(l_xx, v[1], l_yx, v[0]) + low;
        [(v[0] + v_low[0]) / l_xx, across / self.root_det]
    }
    /// From the row of A with the larger diagonal entry, $(x, y)$ with $x$ that entry: $\alpha^2 =
    /// (x^2 + y^2)/x$.
    #[inline(always)]
    fn major(&self) -> ([R; 2], R) {
        major_of(self.factor.entries())
    }
    #[inline(always)]
    fn factor(&self) -> [R; 3] {
        self.factor.cholesky()
    }
}

/// [`Whiten::major`] of a matrix with these entries.
#[inline(always)]
pub(super) fn major_of<R: Real>([xx, xy, yy]: [R; 3]) -> ([R; 2], R) {
    let swap = yy > xx;
    let large = if swap { yy } else { xx };
    let ratio = xy / large.max(R::MIN_POSITIVE);
    let square = R::ONE + ratio * ratio;
    let inverse = R::ONE / square.sqrt();
    let (along, across) = (inverse, ratio * inverse);
    let axis = if swap { [across, along] } else { [along, across] };
    (axis, (large * square).sqrt())
}
