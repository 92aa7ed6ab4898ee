//! What a pixel sees of a glittering material: its smooth lobe, and where its cells lie.
//!
//! Layer 4. The cells' draws are in `sparkle`.

use super::biscale::Biscale;
use super::glints::{Glints, Groove};
use super::grid::Grid;
use crate::filter::Kernel;
use crate::material::cells::Patch;
use crate::ndf::{Beckmann, BeckmannDistribution, Ndf};
use crate::scalar::Real;
use crate::slope::{Anisotropic, Lobe, NonCentered, Roughness, SlopeMoments};

/// A pixel of a glittering material, for any number of lights.
///
/// Its density of slopes is that of [`GlintNdf::smooth_lobe`], for masking and for everything else
/// that asks a lobe, times [`GlintNdf::sparkle`], whose mean is 1.
///
/// With details of roughness $A_l$, blurred by a light's extent, and the lobe's $A_g$: a detail
/// reflects with probability $P = P_g(s)/P_l(0) = \min(1, \sqrt{\det A_l/\det A_g})\, e^{-q}$ (Eq.
/// 7, on the slope plane; a wide light may blur details beyond the whole); of a cell's n details $r
/// \sim B(n, P)$ do, drawn from the cell and the half vector's angular bin, and the pixel's density
/// is $P_g(s) \sum_j w_j \frac{r_j}{n_j P}$. As a cell has one detail at least, it is never above
/// twice the larger of $P_l(0)$ and $P_g(0)$, nor above that where numbers of details are whole.
///
/// An angular bin is a cell of $L^{-1} q$, with $L L^T = A_l$ and the paraboloid $q = 2 h_{xy}/(1 +
/// h_z)$, of side $\sqrt\pi$: near the pole the area of one detail's lobe, for which the integral
/// of the density varies by 1/n. Steeper bins have more of the slope plane, and rough surfaces vary
/// more: 1.3/n at an alpha of 0.6, 1.8/n at 1. Of grooves (section 3, Eq. 6) only the slope across
/// them counts, $P = \sqrt{a_l/a_g}\, e^{-s^2/a_g}$ with the entries of that axis, and has bins;
/// along them the density is the smooth lobe's.
///
/// Source: Zirr & Kaplanyan 2016, section 4; departures are
/// [`ZirrKaplanyan`](super::ZirrKaplanyan)'s list.
// Further methods: material/glint/sparkle.rs.
#[doc(alias = "LobeGlintNdf")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlintNdf<R: Real> {
    pub(super) mean: [R; 2],
    pub(super) biscale: Biscale<R>,
    pub(super) global: Roughness<R>,
    pub(super) grid: Grid<R>,
    pub(super) density: R,
    pub(super) variation: R,
    pub(super) share: R,
    pub(super) groove: Groove,
}

impl<R: Real> Glints<R> {
    /// What a pixel sees: the material's lobe, and its cells under this patch.
    #[doc(alias = "lobe_glints_ndf")]
    #[inline]
    pub fn ndf(&self, patch: &Patch<R>) -> GlintNdf<R> {
        let grid = Grid::stretched(patch, self.stretch, self.detail_size());
        GlintNdf::new(self, grid.with_seed(self.seed))
    }
}

impl<R: Real> GlintNdf<R> {
    #[inline]
    fn new(glints: &Glints<R>, grid: Grid<R>) -> Self {
        let Glints { biscale, density, variation, share, groove, .. } = *glints;
        let (mean, global) = ([R::ZERO; 2], biscale.global());
        Self { mean, biscale, global, grid, density, variation, share, groove }
    }

    /// Over a patch of a normal map: its mean tilts the lobe, its covariance spreads the details.
    ///
    /// Cells and the length of details stay the material's. One map over another adds both means
    /// and both covariances, as `+` of moments does.
    ///
    /// ```
    /// use lobe::material::cells::Patch;
    /// use lobe::material::glint::{Biscale, Glints};
    /// use lobe::{Psd, SlopeMoments};
    /// let glints = Glints::new(Biscale::from_fractions([0.3_f64, 0.3], [0.1, 0.1])?, 1e4)?;
    /// let bumps = SlopeMoments::new([0.2, 0.0], Psd::new(0.01, 0.0, 0.02)?)?;
    /// let pixel = glints.ndf(&Patch::default()).over(&bumps);
    /// assert_eq!(pixel.smooth_lobe().mean(), [0.2, 0.0]);
    /// assert!((pixel.smooth_lobe().roughness().matrix().entries()[0] - 0.11).abs() < 1e-15);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_glint_ndf_over")]
    #[must_use]
    #[inline]
    pub fn over(&self, moments: &SlopeMoments<R>) -> Self {
        let biscale = self.biscale.over(moments);
        let mean = [0, 1].map(|k| self.mean[k] + moments.mean()[k]);
        Self { mean, biscale, global: biscale.global(), ..*self }
    }

    /// Under the pixel's kernel, the half vector's spread over the pixel: every detail is blurred
    /// by it.
    #[doc(alias = "lobe_glint_ndf_widened")]
    #[must_use]
    #[inline]
    pub fn widened(&self, kernel: &Kernel<R>) -> Self {
        let biscale = self.biscale.widened(kernel);
        Self { biscale, global: biscale.global(), ..*self }
    }

    /// The smooth lobe: what the pixel averages to, and what masks it.
    #[doc(alias = "lobe_glint_ndf_smooth_lobe")]
    #[inline]
    pub fn smooth_lobe(&self) -> Lobe<R> {
        Lobe::centered(self.global).with_mean(self.mean)
    }

    /// The cells that the pixel covers.
    pub const fn grid(&self) -> &Grid<R> {
        &self.grid
    }

    /// The smooth lobe's distribution.
    #[inline]
    pub fn smooth(&self) -> Ndf<BeckmannDistribution, NonCentered<Anisotropic<R>>> {
        Beckmann::new(self.smooth_lobe().shape())
    }
}
