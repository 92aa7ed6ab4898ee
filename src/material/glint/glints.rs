//! A glittering material: details of two scales, how many there are, and what a pixel sees of them.
//!
//! Layer 4.

use super::biscale::Biscale;
use crate::error::Error;
use crate::scalar::Real;

/// A surface of discrete, Beckmann-rough details: snow, sparkling fabric, brushed metal.
///
/// ```
/// use lobe::material::cells::Patch;
/// use lobe::material::glint::{Biscale, Glints};
/// let snow = Glints::new(Biscale::from_fractions([0.6_f32, 0.6], [0.05, 0.05])?, 1e6)?;
/// // A pixel that is a thousandth of the texture wide, the sun half a degree.
/// let pixel = snow.ndf(&Patch::new([0.3, 0.7], [1e-3, 0.0], [0.0, 1e-3]));
/// let (wo, wi) = ([0.6, 0.0, 0.8], [-0.28, 0.0, 0.96]);
/// let brdf = pixel.brdf(wo, wi, 0.00465);
/// assert!(brdf >= 0.0);
/// # Ok::<(), lobe::Error>(())
/// ```
///
/// Coordinates: u and v are the axes of the tangent frame, x and y, and `density` counts in their
/// units. Where the spread of slopes is smaller along one axis, details are longer along it, in the
/// proportion of the two: a groove, without end, where there is none at all.
///
/// The paper's user parameters (section 4.5): both roughnesses are [`Biscale::from_fractions`], the
/// density is `density` (sliders want its logarithm), the scale variation
/// [`Glints::with_variation`], the overall intensity a Fresnel term
/// ([`GlintMaterial`](crate::shade::GlintMaterial)), the palette an argument of
/// [`colored_sparkle`](super::GlintNdf::colored_sparkle).
///
/// Source: Zirr & Kaplanyan 2016. What is printed and was published of it, mistakes included, is
/// [`ZirrKaplanyan`](super::ZirrKaplanyan); this one conserves the mean: over cells and angular
/// bins $P_{22}$ averages to that of the smooth lobe, for any number, size, light and pixel.
// Further methods: material/glint/ndf.rs.
#[doc(alias = "LobeGlints")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Glints<R> {
    pub(super) biscale: Biscale<R>,
    pub(super) density: R,
    pub(super) variation: R,
    pub(super) share: R,
    pub(super) stretch: [R; 2],
    pub(super) groove: Groove,
    pub(super) seed: u32,
}

/// Along which axis details have no end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Groove {
    None,
    AlongU,
    AlongV,
}

impl<R: Real> Glints<R> {
    /// From roughness and the number of details per unit area of the texture.
    ///
    /// Of details that are stretched, per unit area of the compressed texture; of grooves the root
    /// of it counts, per unit length across.
    ///
    /// # Errors
    /// [`Error::Density`] unless in $[10^{-18}, 10^{18}]$.
    #[doc(alias = "lobe_glints_new")]
    pub fn new(biscale: Biscale<R>, density: R) -> Result<Self, Error> {
        let most = R::LARGEST * R::LARGEST;
        if !(density >= R::ONE / most && density <= most) {
            return Err(Error::Density(density.into()));
        }
        let [xx, _, yy] = biscale.spread().matrix().entries();
        let ratio = |a: R, b: R| if a < b { (a / b).sqrt() } else { R::ONE };
        let stretch = [ratio(xx, yy), ratio(yy, xx)];
        let groove = if stretch[0] == R::ZERO {
            Groove::AlongU
        } else if stretch[1] == R::ZERO {
            Groove::AlongV
        } else {
            Groove::None
        };
        let (variation, share, seed) = (R::ZERO, R::ONE, 0);
        Ok(Self { biscale, density, variation, share, stretch, groove, seed })
    }

    /// With numbers of details that vary from cell to cell: their logarithms have this deviation.
    ///
    /// Log-normal with mean 1, so cells differ and the density stays, but for cells that would have
    /// less than one detail: they have one. Of cells with one in the mean that is more than half,
    /// and a deviation of 1 makes 1.4 times as many details. Light keeps its mean in any case. At
    /// 0, the default, all cells have as many.
    ///
    /// # Errors
    /// [`Error::Variation`] outside [0, 4].
    pub fn with_variation(self, variation: R) -> Result<Self, Error> {
        if !(variation >= R::ZERO && variation <= R::lit(4.0)) {
            return Err(Error::Variation(variation.into()));
        }
        Ok(Self { variation, ..self })
    }

    /// With this share of the light from details and the rest from the smooth lobe: 1 by default.
    ///
    /// # Errors
    /// [`Error::Share`] outside [0, 1].
    ///
    /// ```
    /// use lobe::material::cells::Patch;
    /// use lobe::material::glint::{Biscale, Glints};
    /// let lacquer = Glints::new(Biscale::from_fractions([0.3_f64, 0.3], [0.1, 0.1])?, 1e4)?;
    /// let dull = lacquer.with_share(0.0)?.ndf(&Patch::default());
    /// assert_eq!(dull.sparkle([0.0, 0.0, 1.0], 0.0), 1.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn with_share(self, share: R) -> Result<Self, Error> {
        if !(share >= R::ZERO && share <= R::ONE) {
            return Err(Error::Share(share.into()));
        }
        Ok(Self { share, ..self })
    }

    /// With other random numbers.
    #[must_use]
    pub const fn with_seed(self, seed: u32) -> Self {
        Self { seed, ..self }
    }

    /// Density, variation and share; stretch; the groove as the port numbers it; seed.
    #[cfg(any(feature = "bytemuck", feature = "serde"))]
    pub(crate) const fn numbers(&self) -> ([R; 3], [R; 2], u32, u32) {
        let groove = match self.groove {
            Groove::None => 0,
            Groove::AlongU => 1,
            Groove::AlongV => 2,
        };
        ([self.density, self.variation, self.share], self.stretch, groove, self.seed)
    }

    /// The two roughnesses.
    pub const fn biscale(&self) -> Biscale<R> {
        self.biscale
    }

    /// Edge of the smallest cell: the square that one detail has, rounded to a power of two.
    ///
    /// What is closer shows details, not fewer of them: both grids end there, and a cell has one or
    /// two draws.
    ///
    /// ```
    /// use lobe::material::glint::{Biscale, Glints};
    /// let glints = Glints::new(Biscale::from_fractions([0.3_f32, 0.3], [0.1, 0.1])?, 1e6)?;
    /// assert_eq!(glints.detail_size(), 1.0 / 1024.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_glints_detail_size")]
    #[inline]
    pub fn detail_size(&self) -> R {
        // Up from 0.7 of it.
        R::power_of_two((R::TWO.sqrt() / self.density.sqrt()).exponent())
    }
}
