//! The one door between where variance comes from and what is done with it.
//!
//! Layer 1. Upstream (footprints, normal maps, displacement) everything ends in a mean slope and a
//! roughness; downstream (distributions, masking, shading) nothing else is asked for.

use super::anisotropic::Anisotropic;
use super::direction::checked_slope;
use super::non_centered::NonCentered;
use super::roughness::Roughness;
use crate::error::Error;
use crate::scalar::Real;

/// A mean slope and a roughness.
///
/// ```
/// use lobe::{Beckmann, Lobe, Roughness};
/// let lobe = Lobe::new([0.1_f32, 0.0], Roughness::from_alpha(0.2)?)?;
/// let ndf = Beckmann::new(lobe.shape());
/// assert!(ndf.slope_pdf([0.1, 0.0]) > ndf.slope_pdf([0.0, 0.0]));
/// # Ok::<(), lobe::Error>(())
/// ```
// Further methods: filter/gaussian.rs.
#[doc(alias = "LobeLobe")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lobe<R> {
    mean: [R; 2],
    roughness: Roughness<R>,
}

impl<R: Real> Lobe<R> {
    /// A lobe around `mean`, a slope.
    ///
    /// # Errors
    /// [`Error::Mean`] unless both components lie in $[-10^9, 10^9]$.
    #[doc(alias = "lobe_lobe_new")]
    pub fn new(mean: impl Into<[R; 2]>, roughness: Roughness<R>) -> Result<Self, Error> {
        Ok(Self { mean: checked_slope(mean)?, roughness })
    }

    /// A lobe around the normal.
    #[doc(alias = "lobe_lobe_centered")]
    pub const fn centered(roughness: Roughness<R>) -> Self {
        Self { mean: [R::ZERO; 2], roughness }
    }

    /// The mean slope.
    pub const fn mean(&self) -> [R; 2] {
        self.mean
    }

    /// The roughness.
    pub const fn roughness(&self) -> Roughness<R> {
        self.roughness
    }

    /// The same mean with another roughness.
    #[must_use]
    pub const fn with_roughness(&self, roughness: Roughness<R>) -> Self {
        Self { roughness, ..*self }
    }

    /// The same roughness around a mean that is known to be valid.
    pub(crate) const fn with_mean(self, mean: [R; 2]) -> Self {
        Self { mean, ..self }
    }

    /// The shape that distributions take: any A, any mean.
    #[doc(alias = "lobe_lobe_shape")]
    pub fn shape(&self) -> NonCentered<Anisotropic<R>> {
        NonCentered::unchecked(Anisotropic::new(self.roughness), self.mean)
    }
}

/// The centered lobe of a roughness: [`Lobe::centered`].
impl<R: Real> From<Roughness<R>> for Lobe<R> {
    fn from(roughness: Roughness<R>) -> Self {
        Self::centered(roughness)
    }
}

/// What distributions take: [`Lobe::shape`].
///
/// ```
/// use lobe::{Anisotropic, Ggx, Lobe, NonCentered, Roughness};
/// let lobe = Lobe::new([0.2_f32, 0.0], Roughness::from_alpha(0.1)?)?;
/// let shape: NonCentered<Anisotropic<f32>> = lobe.into();
/// assert_eq!(shape, lobe.shape());
/// assert_eq!(Ggx::from(lobe), Ggx::new(lobe.shape()));
/// # Ok::<(), lobe::Error>(())
/// ```
impl<R: Real> From<Lobe<R>> for NonCentered<Anisotropic<R>> {
    fn from(lobe: Lobe<R>) -> Self {
        lobe.shape()
    }
}
