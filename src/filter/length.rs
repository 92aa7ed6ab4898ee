//! What engines read off a mean of normals: Toksvig, CLEAN, and widening by a von Mises-Fisher
//! lobe.
//!
//! Layer 3. One scalar each, so no direction of a brushed map survives; moments of slopes keep it
//! ([`SlopeMoments`](crate::SlopeMoments)). Here to reproduce and to compare.

use crate::error::Error;
use crate::scalar::Real;
use crate::slope::direction::checked_slope;

/// How much longer than 1 a mean of unit normals may be: $\sqrt 3/254$, what storing its components
/// in 8 bits adds.
///
/// A step is $2/255$ in unorm (`n = 2 b/255 - 1`) and $1/127$ in snorm; each component is off by at
/// most half of the larger, $1/254$, and the vector by at most $\sqrt 3$ times that. A flat texel
/// of a normal map, (128, 128, 255), has length 1.0000154. Functions of a mean normal's length take
/// lengths up to that for 1 and refuse longer ones. Lengths below 1 keep what storage made of them:
/// it takes them for variance of up to 0.007.
///
/// ```
/// use lobe::filter::{MEAN_LENGTH_TOLERANCE, toksvig_variance};
/// let [x, y, z] = [128.0, 128.0, 255.0].map(|b: f32| 2.0 * b / 255.0 - 1.0);
/// assert_eq!(toksvig_variance((x * x + y * y + z * z).sqrt())?, 0.0);
/// assert!(toksvig_variance(1.001 + MEAN_LENGTH_TOLERANCE).is_err());
/// # Ok::<(), lobe::Error>(())
/// ```
pub const MEAN_LENGTH_TOLERANCE: f64 = 0.006_819_097_667_594_005;

/// The length of a mean of unit normals, in (0, 1].
fn checked<R: Real>(length: R) -> Result<R, Error> {
    let most = R::ONE + R::lit(MEAN_LENGTH_TOLERANCE);
    if length > R::ZERO && length <= most {
        Ok(length.min(R::ONE))
    } else {
        Err(Error::MeanLength(length.into()))
    }
}

/// Slope variance per axis from the length of a mean unit normal, $\sigma^2 = (1 - |N|)/|N|$.
///
/// Right to first order for isotropic slopes, $|N| \approx 1 - \sigma^2$; 0 for length 1, and for
/// what 8 bits make longer. A map in 8 bits has lengths in steps of 1/255: alpha 0.09. Beckmann
/// takes it as it is, $\alpha^2 = 2 \sigma^2$.
///
/// Source: Toksvig 2005, read as a variance.
///
/// # Errors
/// [`Error::MeanLength`] unless the length lies in (0, 1], or above 1 by at most
/// [`MEAN_LENGTH_TOLERANCE`].
///
/// ```
/// assert_eq!(lobe::filter::toksvig_variance(0.8_f64)?, 0.25 * (1.0 - 0.8) / 0.2);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_toksvig_variance")]
pub fn toksvig_variance<R: Real>(length: R) -> Result<R, Error> {
    let length = checked(length)?;
    Ok(((R::ONE - length) / length).min(R::LARGEST))
}

/// The Blinn-Phong exponent of a mean unit normal's length, $s' = \frac{s |N|}{|N| + s (1 - |N|)}$.
///
/// The same as adding [`toksvig_variance`] to the lobe's own, 1/s.
///
/// Source: Toksvig 2005.
///
/// # Errors
/// [`Error::Exponent`] unless the exponent lies in $\[0, 10^9\]$; [`Error::MeanLength`].
///
/// ```
/// let wider = lobe::filter::toksvig_exponent(100.0_f64, 0.9)?;
/// let variances = 1.0 / 100.0 + lobe::filter::toksvig_variance(0.9)?;
/// assert!((wider * variances - 1.0).abs() < 1e-14);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_toksvig_exponent")]
pub fn toksvig_exponent<R: Real>(exponent: R, length: R) -> Result<R, Error> {
    if !exponent.is_magnitude() {
        return Err(Error::Exponent(exponent.into()));
    }
    let length = checked(length)?;
    Ok(exponent * length / (length + exponent * (R::ONE - length)))
}

/// Slope variance per axis of CLEAN maps, which keep the mean slope and one second moment,
/// $\mathrm{E}\,|s|^2$: $\sigma^2 = \frac{1}{2} (\mathrm{E}\,|s|^2 - |\mathrm{E}\,s|^2)$, not
/// below 0.
///
/// LEAN without direction: the mean of its two variances.
///
/// Source: Baker 2011 (CLEAN mapping), whose variance is that of both axes together.
///
/// # Errors
/// [`Error::Mean`], [`Error::MatrixEntry`].
///
/// ```
/// // Slopes +-0.2 along x.
/// let sigma_squared = lobe::filter::clean_variance([0.0_f64, 0.0], 0.04)?;
/// assert_eq!(sigma_squared, 0.02);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_clean_variance")]
pub fn clean_variance<R: Real>(mean: impl Into<[R; 2]>, second: R) -> Result<R, Error> {
    let [x, y] = checked_slope(mean)?;
    if !(second.abs() <= R::LARGEST * R::LARGEST) {
        return Err(Error::MatrixEntry(second.into()));
    }
    let squares = crate::scalar::exact::add_products(second, -x, x, -y, y);
    Ok((R::HALF * squares).max(R::ZERO))
}

/// The sharpness $\kappa$ of the von Mises-Fisher lobe with a mean of length `length`,
/// $\kappa = \frac{3 r - r^3}{1 - r^2}$; at most $10^9$.
///
/// Source: Banerjee et al. 2005, Eq. 4.4 in three dimensions. Within 5 % of the exact one.
///
/// # Errors
/// [`Error::MeanLength`].
///
/// ```
/// let kappa = lobe::filter::vmf_sharpness(0.98_f64)?;
/// assert!((1.0 / kappa.tanh() - 1.0 / kappa - 0.98).abs() < 2e-3);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "kappa")]
#[doc(alias = "lobe_vmf_sharpness")]
pub fn vmf_sharpness<R: Real>(length: R) -> Result<R, Error> {
    let r = checked(length)?;
    let spread = (R::ONE - r) * (R::ONE + r);
    Ok((r * (R::lit(3.0) - r * r) / spread.max(R::lit(1e-9))).min(R::LARGEST))
}

/// What alpha^2 gains of a von Mises-Fisher lobe's $1/\kappa$: engines disagree by a factor of 4.
///
/// To first order the slope variance of the lobe is $1/\kappa$ per axis, so Beckmann's $\alpha^2 =
/// 2 \sigma^2$ gains $2/\kappa$ ([`VmfWidening::SPECULAR_AA`]); Unity and The Order: 1886 add
/// $1/(2\kappa)$ ([`VmfWidening::THE_ORDER`]), a quarter. GGX has no second moment to decide by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VmfWidening {
    gain: f64,
}

impl VmfWidening {
    /// $1/(2\kappa)$: The Order: 1886 (Neubelt & Pettineo 2013, after Han et al. 2007), Unity's
    /// `TextureNormalVariance`, MJP's sample until 2018. Half the lobe's deviation.
    pub const THE_ORDER: Self = Self { gain: 0.5 };
    /// $2/\kappa$: MJP's SpecularAA from 2018 on, Karis 2018. What Beckmann's variance asks for.
    pub const SPECULAR_AA: Self = Self { gain: 2.0 };

    /// What is divided by $\kappa$ and added to alpha^2.
    pub const fn gain(self) -> f64 {
        self.gain
    }

    /// alpha of a lobe of `alpha` under a mean normal of length `length`: $\sqrt{\alpha^2 +
    /// g/\kappa}$.
    ///
    /// # Errors
    /// [`Error::Alpha`], [`Error::MeanLength`].
    ///
    /// ```
    /// use lobe::filter::VmfWidening;
    /// let [published, right] = [VmfWidening::THE_ORDER, VmfWidening::SPECULAR_AA];
    /// let alpha = published.alpha(0.0_f64, 0.99)?;
    /// assert!((right.alpha(0.0, 0.99)? / alpha - 2.0).abs() < 1e-14);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_vmf_widening_alpha")]
    pub fn alpha<R: Real>(self, alpha: R, length: R) -> Result<R, Error> {
        if !alpha.is_magnitude() {
            return Err(Error::Alpha(alpha.into()));
        }
        let added = (R::lit(self.gain) / vmf_sharpness(length)?).min(R::LARGEST * R::LARGEST);
        Ok((alpha * alpha + added).sqrt())
    }
}
