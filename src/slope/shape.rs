//! Shapes: what a distribution needs to know of roughness and mean, at the price of what a scene
//! has.
//!
//! Layer 1. Whatever its anisotropy and tilt, a lobe meets its distribution in four numbers: the
//! root of the determinant, the form n(m), the squared stretch a^2(w) and the mean projected area
//! c(w). `Isotropic` answers with plain products, `Anisotropic` with compensated ones; the compiler
//! keeps only what the shape in use needs.

use super::roughness::Roughness;
use crate::error::Error;
use crate::scalar::{Psd, Real};

/// The questions that a distribution and its filters ask.
///
/// Directions are in the tangent frame and need not have unit length: every answer is homogeneous.
pub trait LobeShape: Copy {
    /// The precision.
    type Scalar: Real;

    /// True if the mean is 0 for every value of this shape.
    const CENTERED: bool;

    /// $\sqrt{\det A}$; 0 for a mirror along some axis.
    #[doc(alias = "lobe_isotropic_root_det")]
    #[doc(alias = "lobe_axis_aligned_root_det")]
    fn root_det(&self) -> Self::Scalar;

    /// $n(m) = \sqrt{\det A}\; v^T A^{-1} v$ with $v = m_{xy} + \mu m_z$, for the direction
    /// `m + m_low`, an unevaluated sum whose second part is of the order of rounding.
    ///
    /// With $s$ the slope of $m$ and $q = (s - \mu)^T A^{-1} (s - \mu)$: $n = \sqrt{\det A}\, q\,
    /// m_z^2$. Free of divisions by $m_z$, hence valid up to the horizon.
    #[doc(alias = "lobe_isotropic_form")]
    #[doc(alias = "lobe_axis_aligned_form")]
    #[doc(alias = "lobe_anisotropic_form")]
    #[doc(alias = "lobe_non_centered_form")]
    fn form(&self, m: [Self::Scalar; 3], m_low: [Self::Scalar; 3]) -> Self::Scalar;

    /// The slope relative to the mean, $s - \mu$, as an unevaluated sum, high and low.
    #[doc(alias = "lobe_non_centered_offset")]
    fn offset(&self, slope: [Self::Scalar; 2]) -> ([Self::Scalar; 2], [Self::Scalar; 2]);

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
    /// use lobe::{AxisAligned, LobeShape};
    /// assert_eq!(AxisAligned::new(0.0_f32, 0.3)?.major(), ([0.0, 1.0], 0.3));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_anisotropic_major")]
    fn major(&self) -> ([Self::Scalar; 2], Self::Scalar);

    /// $a^2(w) = w_{xy}^T A\, w_{xy}$.
    #[doc(alias = "lobe_isotropic_stretch_squared")]
    #[doc(alias = "lobe_axis_aligned_stretch_squared")]
    #[doc(alias = "lobe_anisotropic_stretch_squared")]
    fn stretch_squared(&self, w: [Self::Scalar; 3]) -> Self::Scalar;

    /// $c(w) = w_z - \mu \cdot w_{xy}$, the projected area of the mean plane.
    #[doc(alias = "lobe_non_centered_mean_area")]
    fn mean_area(&self, w: [Self::Scalar; 3]) -> Self::Scalar;
}

/// $A = \alpha^2 I$, centered.
#[doc(alias = "LobeIsotropic")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isotropic<R> {
    alpha: R,
}

impl<R: Real> Isotropic<R> {
    /// alpha = 1: slopes in units of the lobe.
    #[inline(always)]
    pub(crate) const fn unit() -> Self {
        Self { alpha: R::ONE }
    }

    /// From alpha.
    ///
    /// # Errors
    /// [`Error::Alpha`].
    ///
    /// ```
    /// use lobe::{Ggx, Isotropic};
    /// let ggx = Ggx::new(Isotropic::new(0.5_f32)?);
    /// assert!((ggx.d([0.0, 0.0, 1.0]) - 4.0 / core::f32::consts::PI).abs() < 1e-6);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_isotropic_new")]
    #[inline]
    pub fn new(alpha: R) -> Result<Self, Error> {
        if alpha.is_magnitude() { Ok(Self { alpha }) } else { Err(Error::Alpha(alpha.into())) }
    }
}

/// $\alpha^2 I$.
impl<R: Real> From<Isotropic<R>> for Roughness<R> {
    fn from(shape: Isotropic<R>) -> Self {
        Self::from_matrix(Psd::from_axes(shape.alpha, shape.alpha, R::ONE, R::ZERO))
    }
}

impl<R: Real> Isotropic<R> {
    /// alpha.
    pub const fn alpha(&self) -> R {
        self.alpha
    }
}

impl<R: Real> LobeShape for Isotropic<R> {
    type Scalar = R;
    const CENTERED: bool = true;

    #[inline(always)]
    fn root_det(&self) -> R {
        self.alpha * self.alpha
    }
    #[inline(always)]
    fn form(&self, m: [R; 3], _: [R; 3]) -> R {
        m[0] * m[0] + m[1] * m[1]
    }
    #[inline(always)]
    fn offset(&self, slope: [R; 2]) -> ([R; 2], [R; 2]) {
        (slope, [R::ZERO; 2])
    }
    #[inline(always)]
    fn whiten(&self, v: [R; 2], _: [R; 2]) -> [R; 2] {
        let inverse = R::ONE / self.alpha;
        [v[0] * inverse, v[1] * inverse]
    }
    #[inline(always)]
    fn major(&self) -> ([R; 2], R) {
        ([R::ONE, R::ZERO], self.alpha)
    }
    #[inline(always)]
    fn stretch_squared(&self, w: [R; 3]) -> R {
        self.root_det() * (w[0] * w[0] + w[1] * w[1])
    }
    #[inline(always)]
    fn mean_area(&self, w: [R; 3]) -> R {
        w[2]
    }
}

/// $A = \mathrm{diag}(\alpha_x^2, \alpha_y^2)$, centered.
#[doc(alias = "LobeAxisAligned")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisAligned<R> {
    alphas: [R; 2],
    /// One over each, at most the largest number.
    inverse: [R; 2],
}

impl<R: Real> AxisAligned<R> {
    /// From alpha along x and along y.
    ///
    /// # Errors
    /// [`Error::AlphaX`], [`Error::AlphaY`].
    ///
    /// ```
    /// use lobe::{AxisAligned, Beckmann};
    /// let brushed = Beckmann::new(AxisAligned::new(0.5_f32, 0.05)?);
    /// assert!(brushed.slope_pdf([0.2, 0.0]) > brushed.slope_pdf([0.0, 0.2]));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_axis_aligned_new")]
    #[inline]
    pub fn new(alpha_x: R, alpha_y: R) -> Result<Self, Error> {
        if !alpha_x.is_magnitude() {
            return Err(Error::AlphaX(alpha_x.into()));
        }
        if !alpha_y.is_magnitude() {
            return Err(Error::AlphaY(alpha_y.into()));
        }
        let inverse = [alpha_x, alpha_y].map(|alpha| R::ONE / alpha.max(R::MIN_POSITIVE));
        Ok(Self { alphas: [alpha_x, alpha_y], inverse })
    }
}

/// $\mathrm{diag}(\alpha_x^2, \alpha_y^2)$.
///
/// ```
/// use lobe::{AxisAligned, Roughness};
/// let roughness = Roughness::from(AxisAligned::new(0.5_f64, 0.1)?);
/// assert_eq!(roughness, Roughness::from_alphas(0.5, 0.1, 0.0)?);
/// # Ok::<(), lobe::Error>(())
/// ```
impl<R: Real> From<AxisAligned<R>> for Roughness<R> {
    fn from(shape: AxisAligned<R>) -> Self {
        let [x, y] = shape.alphas;
        Self::from_matrix(Psd::from_axes(x, y, R::ONE, R::ZERO))
    }
}

impl<R: Real> AxisAligned<R> {
    /// alpha along x and along y.
    pub const fn alphas(&self) -> [R; 2] {
        self.alphas
    }
}

impl<R: Real> LobeShape for AxisAligned<R> {
    type Scalar = R;
    const CENTERED: bool = true;

    #[inline(always)]
    fn root_det(&self) -> R {
        self.alphas[0] * self.alphas[1]
    }
    #[inline(always)]
    fn form(&self, m: [R; 3], _: [R; 3]) -> R {
        let (x, y) = (m[0] * self.inverse[0], m[1] * self.inverse[1]);
        (x * x + y * y) * self.root_det()
    }
    #[inline(always)]
    fn offset(&self, slope: [R; 2]) -> ([R; 2], [R; 2]) {
        (slope, [R::ZERO; 2])
    }
    #[inline(always)]
    fn whiten(&self, v: [R; 2], _: [R; 2]) -> [R; 2] {
        [v[0] * self.inverse[0], v[1] * self.inverse[1]]
    }
    #[inline(always)]
    fn major(&self) -> ([R; 2], R) {
        let ([x, y], (zero, one)) = (self.alphas, (R::ZERO, R::ONE));
        if y > x { ([zero, one], y) } else { ([one, zero], x) }
    }
    #[inline(always)]
    fn stretch_squared(&self, w: [R; 3]) -> R {
        let (x, y) = (self.alphas[0] * w[0], self.alphas[1] * w[1]);
        x * x + y * y
    }
    #[inline(always)]
    fn mean_area(&self, w: [R; 3]) -> R {
        w[2]
    }
}
