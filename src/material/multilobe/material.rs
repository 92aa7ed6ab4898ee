//! A surface of many facets: their slopes from afar, and how many there are.
//!
//! Layer 4.

use crate::error::Error;
use crate::scalar::Real;
use crate::slope::Roughness;

/// A surface of facets, each pixel of which has a density of slopes of its own: many narrow lobes,
/// whose integral is 1.
///
/// From afar it is the Beckmann lobe of its roughness. Where
/// [`Glints`](crate::material::glint::Glints) draw how many details reflect at each half vector, so
/// that one pixel's density integrates to 1 on average only, here every cell has a whole density, a
/// rotated product of two marginals of a [`Dictionary`](super::Dictionary).
///
/// Source: Chermain et al. 2020, 2021a. A dictionary of
/// [`LobeMeans::Chermain`](super::LobeMeans::Chermain) and
/// [`PatchNdf::with_mips`](super::PatchNdf::with_mips) are as published. Ours are: singular values
/// in place of the derivatives' lengths, and aspects up to 8, where they have 4; levels rounded by
/// chance; the smaller masking in place of the product; no cell smaller than one facet's square;
/// tables read at their nodes.
///
/// ```
/// use lobe::Roughness;
/// use lobe::material::cells::Patch;
/// use lobe::material::multilobe::{Dictionary, MultiLobe, Recipe};
/// let dictionary = Dictionary::<f32>::new(&Recipe { levels: 8, ..Recipe::default() })?;
/// let sand = MultiLobe::new(Roughness::from_alpha(0.5)?, 1e6)?;
/// let pixel = sand.ndf(&dictionary, &Patch::new([0.3, 0.7], [1e-3, 0.0], [0.0, 2e-3]));
/// assert!(pixel.brdf([0.6, 0.0, 0.8], [-0.28, 0.0, 0.96]) >= 0.0);
/// # Ok::<(), lobe::Error>(())
/// ```
// Further methods: material/multilobe/ndf.rs.
#[doc(alias = "LobeMultiLobe")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MultiLobe<R> {
    pub(super) roughness: Roughness<R>,
    pub(super) density: R,
    pub(super) variation: R,
    pub(super) share: R,
    pub(super) seed: u32,
}

impl<R: Real> MultiLobe<R> {
    /// From the roughness from afar and the number of facets per unit area of the texture, in the
    /// median of its cells: published are logarithms of it, from $e^{15}$, which glitters, to
    /// $e^{50}$, smooth.
    ///
    /// Cells have more or fewer by powers of 4 ([`MultiLobe::with_variation`]), at least one each.
    /// Their mean is therefore more than this median: of many facets, with a deviation of 2, 55
    /// times that. Deviations of the lobe below 1e-9, also across a correlation near $\pm 1$, count
    /// as 1e-9; a mirror has no density until a kernel widens it.
    ///
    /// # Errors
    /// [`Error::Facets`] unless in $[10^{-18}, 10^{30}]$.
    #[doc(alias = "lobe_multi_lobe_new")]
    pub fn new(roughness: Roughness<R>, density: R) -> Result<Self, Error> {
        if !(density >= R::lit(1e-18) && density <= R::lit(1e30)) {
            return Err(Error::Facets(density.into()));
        }
        Ok(Self { roughness, density, variation: R::TWO, share: R::ONE, seed: 0 })
    }

    /// With levels that vary from cell to cell with this deviation, so numbers of facets by powers
    /// of 4: 2 by default.
    ///
    /// # Errors
    /// [`Error::Variation`] outside [0, 4].
    pub fn with_variation(self, variation: R) -> Result<Self, Error> {
        if !(variation >= R::ZERO && variation <= R::lit(4.0)) {
            return Err(Error::Variation(variation.into()));
        }
        Ok(Self { variation, ..self })
    }

    /// With facets on this share of the cells, and the smooth lobe on the others: 1 by default.
    ///
    /// Published code has nothing on the others (Chermain et al. 2020), or the smooth lobe (2021b).
    ///
    /// # Errors
    /// [`Error::Share`] outside [0, 1].
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

    /// Density, variation and share; seed.
    #[cfg(any(feature = "bytemuck", feature = "serde"))]
    pub(crate) const fn numbers(&self) -> ([R; 3], u32) {
        ([self.density, self.variation, self.share], self.seed)
    }

    /// The roughness from afar.
    pub const fn roughness(&self) -> Roughness<R> {
        self.roughness
    }

    /// Side of the square that has one facet at this density: smaller pixels show what one of this
    /// size does.
    #[doc(alias = "lobe_multi_lobe_facet_size")]
    pub fn facet_size(&self) -> R {
        R::ONE / self.density.sqrt()
    }
}
