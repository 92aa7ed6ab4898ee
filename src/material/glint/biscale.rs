//! Two scales of roughness: where the details of a surface point, and how rough each of them is.
//!
//! Layer 4.

use crate::error::Error;
use crate::filter::Kernel;
use crate::scalar::Real;
use crate::slope::{Roughness, SlopeMoments};

/// Beckmann details spread over Beckmann slopes: $A_g = A_m + A_l$, in every matrix entry.
///
/// $A_m$ (`spread`) is how the details' own slopes are distributed, $A_l$ (`local`) how rough one
/// detail is, and their sum, the roughness of the surface from afar (`global`), cannot be below
/// either: no value of this type has a local roughness above the global one.
///
/// Source: Zirr & Kaplanyan 2016, Eq. 3 and 4, for any matrices.
///
/// ```
/// use lobe::material::glint::Biscale;
/// // What artists have: the roughness from afar, and which share of it one detail has, along u and
/// // v.
/// let snow = Biscale::from_fractions([0.6_f64, 0.6], [0.024, 0.024])?;
/// assert!((snow.global().alphas().major - 0.6).abs() < 1e-15);
/// assert!((snow.local().alphas().major - 0.0144).abs() < 1e-15);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "LobeBiscale")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Biscale<R> {
    spread: Roughness<R>,
    local: Roughness<R>,
}

impl<R: Real> Biscale<R> {
    /// From the two parts.
    pub const fn new(spread: Roughness<R>, local: Roughness<R>) -> Self {
        Self { spread, local }
    }

    /// From the global alphas along u and v, and the share of each that one detail has: $\alpha_l =
    /// f \alpha_g$.
    ///
    /// A share of 1 along one axis makes grooves along it: every detail has the whole range of
    /// slopes there.
    ///
    /// Source: Zirr & Kaplanyan 2016, sections 4.4 and 4.5.
    ///
    /// # Errors
    /// [`Error::AlphaX`], [`Error::AlphaY`] outside $[0, 10^9]$; [`Error::Fraction`] outside (0,
    /// 1].
    #[doc(alias = "lobe_biscale_from_fractions")]
    pub fn from_fractions(
        alphas: impl Into<[R; 2]>,
        fractions: impl Into<[R; 2]>,
    ) -> Result<Self, Error> {
        let ([a, b], [f, g]) = (alphas.into(), fractions.into());
        if let Some(&x) = [f, g].iter().find(|&&x| !(x > R::ZERO && x <= R::ONE)) {
            return Err(Error::Fraction(x.into()));
        }
        // Refused by the numbers that were given, not by their products.
        Roughness::from_alphas(a, b, R::ZERO)?;
        // (1 - f)(1 + f) keeps the digits of 1 - f^2.
        let rest = |f: R| ((R::ONE - f) * (R::ONE + f)).sqrt();
        let local = Roughness::from_alphas(a * f, b * g, R::ZERO)?;
        Ok(Self { spread: Roughness::from_alphas(a * rest(f), b * rest(g), R::ZERO)?, local })
    }

    /// $A_m$: how the slopes of details are distributed.
    pub const fn spread(&self) -> Roughness<R> {
        self.spread
    }

    /// $A_l$: the roughness of one detail.
    pub const fn local(&self) -> Roughness<R> {
        self.local
    }

    /// $A_g = A_m + A_l$: the roughness from afar.
    #[doc(alias = "lobe_biscale_global")]
    #[inline]
    pub fn global(&self) -> Roughness<R> {
        self.spread + self.local
    }

    /// Under a pixel's kernel, or a light's: it blurs every detail, $A_l + 2\Sigma_K$, and with
    /// them the whole.
    ///
    /// ```
    /// use lobe::material::glint::Biscale;
    /// use lobe::{Footprint, Kernel, PixelFilter};
    /// let details = Biscale::from_fractions([0.5_f32, 0.5], [0.1, 0.1])?;
    /// let pixel = Kernel::of(&Footprint::rectangle([0.2, 0.2]), PixelFilter::BOX);
    /// assert_eq!(details.widened(&pixel).spread(), details.spread());
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_biscale_widened")]
    #[must_use]
    #[inline]
    pub fn widened(&self, kernel: &Kernel<R>) -> Self {
        Self { local: self.local.widened(kernel), ..*self }
    }

    /// On a patch of a normal map: its covariance spreads the details, $A_m + 2\Sigma$, and leaves
    /// each as sharp as it was. The patch's mean is the lobe's, not of a roughness
    /// ([`GlintNdf::over`](super::GlintNdf::over)).
    #[doc(alias = "lobe_biscale_over")]
    #[must_use]
    #[inline]
    pub fn over(&self, moments: &SlopeMoments<R>) -> Self {
        Self { spread: self.spread + Roughness::from_covariance(moments.covariance()), ..*self }
    }
}
