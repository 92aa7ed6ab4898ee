//! Roughness: the matrix A of a lobe, from any of the numbers users have for it.
//!
//! Layer 1. Four numbers get mixed up in practice: perceptual roughness r, alpha = r^2, alpha^2 (an
//! entry of A) and slope variance sigma^2 = alpha^2 / 2 (Beckmann). Each has its own constructor;
//! `A = 2 Sigma` is what [`Roughness::from_covariance`] and [`Roughness::covariance`] are for.

use super::jacobian::Matrix;
use crate::error::{Error, Value};
use crate::scalar::{Psd, Real};
use core::ops::{Add, AddAssign, Mul};

/// The roughness matrix A of a lobe: symmetric, positive semi-definite, in squared slope units.
///
/// $A = \mathrm{diag}(\alpha_x^2, \alpha_y^2)$ in the frame of its axes. For Beckmann $A = 2\Sigma$
/// with $\Sigma$ the slope covariance. GGX has no second moment: there A is a scale matrix, and
/// reading a covariance into it is a convention.
///
/// alpha = 0 is a mirror along that axis: densities of a singular lobe are 0 everywhere (a delta
/// has no density), its projected area, masking and Gaussian filtering are exact. The smallest
/// alpha that is answered for, other than 0, is 1e-9.
///
/// ```
/// use lobe::Roughness;
/// let a = Roughness::from_alpha(0.1_f32)?;
/// let b = Roughness::from_perceptual(0.1_f32.sqrt())?;
/// let c = Roughness::from_sigma_rho(0.1 * 0.5_f32.sqrt(), 0.1 * 0.5_f32.sqrt(), 0.0)?;
/// for other in [b, c] {
///     assert!((other.alphas().major - a.alphas().major).abs() < 1e-7);
/// }
/// # Ok::<(), lobe::Error>(())
/// ```
// Further methods: filter/gaussian.rs, filter/projected.rs, filter/proxy.rs.
#[doc(alias = "LobeRoughness")]
#[doc(alias = "lobe_roughness_add")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Roughness<R> {
    matrix: Psd<R>,
}

/// Roughness along the axes of a lobe, and where the axes point.
#[doc(alias = "LobeAlphas")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Alphas<R> {
    /// alpha along the major axis: the larger.
    pub major: R,
    /// alpha along the minor axis.
    pub minor: R,
    /// Angle of the major axis from +x, counter-clockwise, in $(-\pi/2, \pi/2]$; 0 when isotropic.
    pub angle: R,
}

/// `x` if it lies in the range of alphas and deviations.
fn non_negative<R: Real>(x: R, error: fn(Value) -> Error) -> Result<R, Error> {
    if x.is_magnitude() { Ok(x) } else { Err(error(x.into())) }
}

impl<R: Real> Roughness<R> {
    /// Isotropic, $A = \alpha^2 I$.
    ///
    /// # Errors
    /// [`Error::Alpha`] unless alpha lies in $[0, 10^9]$.
    #[doc(alias = "lobe_roughness_from_alpha")]
    pub fn from_alpha(alpha: R) -> Result<Self, Error> {
        let alpha = non_negative(alpha, Error::Alpha)?;
        Ok(Self { matrix: Psd::diagonal(alpha, alpha) })
    }

    /// Anisotropic: `alpha_x` along the axis at `angle` (radians, counter-clockwise from +x),
    /// `alpha_y` across.
    ///
    /// # Errors
    /// [`Error::AlphaX`], [`Error::AlphaY`], [`Error::Angle`].
    pub fn from_alphas(alpha_x: R, alpha_y: R, angle: R) -> Result<Self, Error> {
        let alpha_x = non_negative(alpha_x, Error::AlphaX)?;
        let alpha_y = non_negative(alpha_y, Error::AlphaY)?;
        if !angle.is_finite() {
            return Err(Error::Angle(angle.into()));
        }
        let (sin, cos) = angle.sin_cos();
        Ok(Self { matrix: Psd::from_axes(alpha_x, alpha_y, cos, sin) })
    }

    /// From perceptual roughness r in \[0, 1\]: $\alpha = r^2$ (Burley 2012), so $A = r^4 I$.
    ///
    /// # Errors
    /// [`Error::Perceptual`] outside \[0, 1\].
    #[doc(alias = "lobe_roughness_from_perceptual")]
    pub fn from_perceptual(perceptual: R) -> Result<Self, Error> {
        if !(perceptual >= R::ZERO && perceptual <= R::ONE) {
            return Err(Error::Perceptual(perceptual.into()));
        }
        Self::from_alpha(perceptual * perceptual)
    }

    /// From a roughness matrix.
    #[doc(alias = "lobe_roughness_from_matrix")]
    #[inline]
    pub const fn from_matrix(matrix: Psd<R>) -> Self {
        Self { matrix }
    }

    /// From a slope covariance: $A = 2\Sigma$ (exact for Beckmann, a convention for GGX).
    #[doc(alias = "lobe_roughness_from_covariance")]
    #[inline]
    pub fn from_covariance(covariance: Psd<R>) -> Self {
        Self { matrix: covariance * R::TWO }
    }

    /// From the slopes' standard deviations and correlation.
    ///
    /// # Errors
    /// [`Error::SigmaX`], [`Error::SigmaY`], [`Error::Rho`] if `|rho| > 1`.
    #[doc(alias = "rho")]
    #[doc(alias = "lobe_roughness_from_sigma_rho")]
    pub fn from_sigma_rho(sigma_x: R, sigma_y: R, rho: R) -> Result<Self, Error> {
        let sigma_x = non_negative(sigma_x, Error::SigmaX)?;
        let sigma_y = non_negative(sigma_y, Error::SigmaY)?;
        if !(rho.abs() <= R::ONE) {
            return Err(Error::Rho(rho.into()));
        }
        Ok(Self::from_covariance(Psd::from_deviations(sigma_x, sigma_y, rho)))
    }

    /// The matrix A.
    #[doc(alias = "A")]
    #[inline]
    pub const fn matrix(&self) -> Psd<R> {
        self.matrix
    }

    /// The slope covariance $\Sigma = A/2$.
    #[doc(alias = "Sigma")]
    #[doc(alias = "lobe_roughness_covariance")]
    pub fn covariance(&self) -> Psd<R> {
        self.matrix * R::HALF
    }

    /// Back to roughness along the axes and their angle.
    ///
    /// ```
    /// use lobe::Roughness;
    /// let back = Roughness::from_alphas(0.5_f64, 0.01, 0.3)?.alphas();
    /// assert!((back.major - 0.5).abs() < 1e-14 && (back.minor - 0.01).abs() < 1e-14);
    /// assert!((back.angle - 0.3).abs() < 1e-14);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_roughness_alphas")]
    pub fn alphas(&self) -> Alphas<R> {
        let eigen = self.matrix.eigen();
        let [cos, sin] = eigen.axis;
        // An axis has no direction: the quotient keeps to the half turn on the right, +y at its
        // end.
        let angle = if cos == R::ZERO { R::HALF * R::PI } else { (sin / cos).atan() };
        Alphas { major: eigen.major.sqrt(), minor: eigen.minor.sqrt(), angle }
    }

    /// Chermain's matrix M, which carries a reference lobe of deviation `sigma_o` to this one.
    ///
    /// $M = \frac{1}{\sigma_o} \begin{pmatrix} \sigma_x \sqrt{1 - \rho^2} & \rho \sigma_x \\\\
    /// 0 & \sigma_y \end{pmatrix}$, with $\sigma_o^2 M M^T = \Sigma$; rows first. As
    /// $\rho \to \pm 1$ the matrix becomes singular; nothing is clamped. `sigma_o > 0`.
    ///
    /// Source: Chermain et al. 2021, Eq. 18.
    ///
    /// ```
    /// use lobe::Roughness;
    /// let m = Roughness::from_sigma_rho(2.0_f64, 1.0, 0.6)?.chermain_matrix(0.5);
    /// assert!((m[0][0] - 3.2).abs() < 1e-12 && (m[0][1] - 2.4).abs() < 1e-12);
    /// assert!(m[1][0] == 0.0 && (m[1][1] - 2.0).abs() < 1e-12);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "M")]
    #[doc(alias = "lobe_roughness_chermain_matrix")]
    pub fn chermain_matrix(&self, sigma_o: R) -> Matrix<R> {
        let covariance = self.covariance();
        let [xx, xy, yy] = covariance.entries();
        let inverse = R::ONE / sigma_o;
        if yy < R::MIN_POSITIVE {
            return [[xx.sqrt() * inverse, R::ZERO], [R::ZERO; 2]];
        }
        let sigma_y = yy.sqrt();
        [
            [covariance.root_det() / sigma_y * inverse, xy / sigma_y * inverse],
            [R::ZERO, sigma_y * inverse],
        ]
    }
}

impl<R: Real> Add for Roughness<R> {
    type Output = Self;

    /// The sum of two roughness matrices: independent slopes add.
    #[inline]
    fn add(self, other: Self) -> Self {
        Self { matrix: self.matrix + other.matrix }
    }
}

impl<R: Real> AddAssign for Roughness<R> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<R: Real> Mul<R> for Roughness<R> {
    type Output = Self;

    /// A, the squares of alphas, times a finite factor; a negative one counts as 0.
    #[inline]
    fn mul(self, factor: R) -> Self {
        Self { matrix: self.matrix * factor }
    }
}
