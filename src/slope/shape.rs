//! Shapes: what a distribution needs to know of roughness and mean, at the price of what a scene
//! has.
//!
//! Layer 1. Whatever its anisotropy and tilt, a lobe meets its distribution in a few numbers: its
//! [`Extent`], the form n(m), the squared stretch a^2(w) and the mean projected area c(w). Every
//! answer is a sum of squares in plain arithmetic; the compiler keeps only what the shape in use
//! needs.

use super::roughness::Roughness;
use crate::error::Error;
use crate::scalar::{Psd, Real};

/// How large a lobe is: $\sqrt{\det A}$, and the unit of its [`LobeShape::form`].
#[doc(alias = "LobeExtent")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent<R> {
    /// $\sqrt{\det A}$; 0 for a mirror along some axis.
    pub root_det: R,
    /// The form of a normal one lobe away from the mean: $n = \mathrm{unit}\; q\, m_z^2$.
    pub unit: R,
    /// The unit over the root of the determinant. 1 where a shape has nothing to scale by.
    pub scale: R,
}

/// The questions that a distribution asks. Exact means over polygons ask more:
/// [`Whiten`](super::Whiten).
///
/// Directions are in the tangent frame and need not have unit length: every answer is homogeneous.
/// Answers are backward accurate: each is the exact one for parameters and directions moved by a
/// few roundings. [`Compensated`](super::Compensated) is forward accurate instead.
pub trait LobeShape: Copy {
    /// The precision.
    type Scalar: Real;

    /// True if the mean is 0 for every value of this shape.
    const CENTERED: bool;

    /// The lobe's size and the unit of its form.
    #[doc(alias = "lobe_isotropic_extent")]
    #[doc(alias = "lobe_axis_aligned_extent")]
    #[doc(alias = "lobe_anisotropic_extent")]
    #[doc(alias = "lobe_widened_extent")]
    fn extent(&self) -> Extent<Self::Scalar>;

    /// $\sqrt{\det A}$; 0 for a mirror along some axis.
    #[inline(always)]
    fn root_det(&self) -> Self::Scalar {
        self.extent().root_det
    }

    /// $n(m) = \mathrm{unit}\; v^T A^{-1} v$ with $v = m_{xy} + \mu m_z$ and the unit of
    /// [`LobeShape::extent`].
    ///
    /// With $s$ the slope of $m$ and $q = (s - \mu)^T A^{-1} (s - \mu)$: $n = \mathrm{unit}\; q\,
    /// m_z^2$. Free of divisions by $m_z$, hence valid up to the horizon.
    #[doc(alias = "lobe_isotropic_form")]
    #[doc(alias = "lobe_axis_aligned_form")]
    #[doc(alias = "lobe_anisotropic_form")]
    #[doc(alias = "lobe_non_centered_form")]
    #[doc(alias = "lobe_widened_form")]
    #[inline(always)]
    fn form(&self, m: [Self::Scalar; 3]) -> Self::Scalar {
        self.adjugate_form(self.relative(m))
    }

    /// $m_{xy} + \mu m_z$, of slope s: $(\mu - s)\, m_z$.
    #[inline(always)]
    fn relative(&self, m: [Self::Scalar; 3]) -> [Self::Scalar; 2] {
        [m[0], m[1]]
    }

    /// The form of a sum of two directions.
    #[inline(always)]
    fn form_of_sum(&self, wo: [Self::Scalar; 3], wi: [Self::Scalar; 3]) -> Self::Scalar {
        self.form([wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]])
    }

    /// $v^T \mathrm{adj}(A)\, v = \det(A)\, v^T A^{-1} v$ of a difference of slopes.
    fn adjugate_form(&self, v: [Self::Scalar; 2]) -> Self::Scalar;

    /// $\det(A + u u^T + v v^T) = \det A + u^T \mathrm{adj}(A)\, u + v^T \mathrm{adj}(A)\, v + (u
    /// \times v)^2$: a sum of squares.
    #[inline(always)]
    fn widened_det(&self, u: [Self::Scalar; 2], v: [Self::Scalar; 2]) -> Self::Scalar {
        let own = self.root_det();
        let mixed = self.adjugate_form(u) + self.adjugate_form(v);
        own * own + mixed + cross_squared(u, v)
    }

    /// $a^2(w) = w_{xy}^T A\, w_{xy}$.
    #[doc(alias = "lobe_isotropic_stretch_squared")]
    #[doc(alias = "lobe_axis_aligned_stretch_squared")]
    #[doc(alias = "lobe_anisotropic_stretch_squared")]
    #[doc(alias = "lobe_widened_stretch_squared")]
    fn stretch_squared(&self, w: [Self::Scalar; 3]) -> Self::Scalar;

    /// $c(w) = w_z - \mu \cdot w_{xy}$, the projected area of the mean plane.
    #[doc(alias = "lobe_non_centered_mean_area")]
    #[inline(always)]
    fn mean_area(&self, w: [Self::Scalar; 3]) -> Self::Scalar {
        w[2]
    }
}

/// The nearest number in [0, 1e9]; 0 for NaN.
#[inline(always)]
fn saturated<R: Real>(alpha: R) -> R {
    alpha.max(R::ZERO).min(R::LARGEST)
}

/// $(a \times b)^2$.
#[inline(always)]
pub(super) fn cross_squared<R: Real>(a: [R; 2], b: [R; 2]) -> R {
    let cross = a[0] * b[1] - a[1] * b[0];
    cross * cross
}

/// The extent of a shape whose form is $\det(A)\, q\, m_z^2$.
#[inline(always)]
pub(super) fn extent_of<R: Real>(root_det: R) -> Extent<R> {
    Extent { root_det, unit: root_det * root_det, scale: root_det }
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
    /// [`Error::Alpha`] unless in $[0, 10^9]$.
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

    /// From an alpha of a texture or a G-buffer: the nearest in $[0, 10^9]$ counts, 0 for NaN.
    ///
    /// ```
    /// use lobe::Isotropic;
    /// assert_eq!(Isotropic::saturating(0.5_f32), Isotropic::new(0.5)?);
    /// assert_eq!(Isotropic::saturating(-1.0_f32), Isotropic::new(0.0)?);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[inline(always)]
    pub fn saturating(alpha: R) -> Self {
        Self { alpha: saturated(alpha) }
    }

    /// alpha.
    pub const fn alpha(&self) -> R {
        self.alpha
    }
}

/// $\alpha^2 I$.
impl<R: Real> From<Isotropic<R>> for Roughness<R> {
    fn from(shape: Isotropic<R>) -> Self {
        Self::from_matrix(Psd::diagonal(shape.alpha, shape.alpha))
    }
}

impl<R: Real> LobeShape for Isotropic<R> {
    type Scalar = R;
    const CENTERED: bool = true;

    #[inline(always)]
    fn extent(&self) -> Extent<R> {
        let square = self.alpha * self.alpha;
        Extent { root_det: square, unit: square, scale: R::ONE }
    }
    #[inline(always)]
    fn form(&self, m: [R; 3]) -> R {
        m[0] * m[0] + m[1] * m[1]
    }
    #[inline(always)]
    fn adjugate_form(&self, v: [R; 2]) -> R {
        self.alpha * self.alpha * (v[0] * v[0] + v[1] * v[1])
    }
    /// $\alpha^2 (\alpha^2 + |u|^2 + |v|^2) + (u \times v)^2$.
    #[inline(always)]
    fn widened_det(&self, u: [R; 2], v: [R; 2]) -> R {
        let square = self.alpha * self.alpha;
        let lengths = (u[0] * u[0] + u[1] * u[1]) + (v[0] * v[0] + v[1] * v[1]);
        square * (square + lengths) + cross_squared(u, v)
    }
    #[inline(always)]
    fn stretch_squared(&self, w: [R; 3]) -> R {
        self.alpha * self.alpha * (w[0] * w[0] + w[1] * w[1])
    }
}

/// $A = \mathrm{diag}(\alpha_x^2, \alpha_y^2)$, centered.
#[doc(alias = "LobeAxisAligned")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisAligned<R> {
    alphas: [R; 2],
}

impl<R: Real> AxisAligned<R> {
    /// From alpha along x and along y.
    ///
    /// # Errors
    /// [`Error::AlphaX`], [`Error::AlphaY`] unless in $[0, 10^9]$.
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
        Ok(Self { alphas: [alpha_x, alpha_y] })
    }

    /// From alphas of a texture or a G-buffer: the nearest in $[0, 10^9]$ count, 0 for NaN.
    ///
    /// ```
    /// use lobe::AxisAligned;
    /// assert_eq!(AxisAligned::saturating(0.5_f32, -0.1), AxisAligned::new(0.5, 0.0)?);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[inline(always)]
    pub fn saturating(alpha_x: R, alpha_y: R) -> Self {
        Self { alphas: [saturated(alpha_x), saturated(alpha_y)] }
    }

    /// alpha along x and along y.
    pub const fn alphas(&self) -> [R; 2] {
        self.alphas
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
        Self::from_matrix(Psd::diagonal(x, y))
    }
}

impl<R: Real> LobeShape for AxisAligned<R> {
    type Scalar = R;
    const CENTERED: bool = true;

    #[inline(always)]
    fn extent(&self) -> Extent<R> {
        extent_of(self.alphas[0] * self.alphas[1])
    }
    #[inline(always)]
    fn adjugate_form(&self, v: [R; 2]) -> R {
        let (x, y) = (v[0] * self.alphas[1], v[1] * self.alphas[0]);
        x * x + y * y
    }
    #[inline(always)]
    fn stretch_squared(&self, w: [R; 3]) -> R {
        let (x, y) = (self.alphas[0] * w[0], self.alphas[1] * w[1]);
        x * x + y * y
    }
}
