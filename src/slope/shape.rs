//! Shapes: what a distribution needs to know of roughness and mean, at the price of what a scene
//! has.
//!
//! Layer 1. Whatever its anisotropy and tilt, a lobe meets its distribution in four numbers: the
//! root of the determinant, the form n(m), the squared stretch a^2(w) and the mean projected area
//! c(w). `Isotropic` answers with plain products, `Anisotropic` with compensated ones; the compiler
//! keeps only what the shape in use needs.

use super::roughness::Roughness;
use crate::error::Error;
use crate::scalar::Real;
use crate::scalar::exact::{difference_of_products, sum_of_products};

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
    pub(crate) fn unit() -> Self {
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

impl<R: Real> From<Roughness<R>> for Anisotropic<R> {
    fn from(roughness: Roughness<R>) -> Self {
        Self::new(roughness)
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
