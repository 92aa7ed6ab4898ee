//! What a pixel sees of many facets: a density of slopes that integrates to 1.
//!
//! Floor 4.

use super::dictionary::Dictionary;
use super::ellipse::Ellipse;
use super::material::MultiLobe;
use super::plane::{Facets, Plane, quarter_turn};
use crate::filter::Kernel;
use crate::material::glint::Cell;
use crate::ndf::{Beckmann, cavity_masking, cavity_masking_shadowing};
use crate::scalar::Real;
use crate::scalar::hash::tail;
use crate::scalar::quantile::normal_quantile;
use crate::slope::direction::{half_vector, slope_of};
use crate::slope::{Footprint, Full, MeanFrame, Roughness, SlopeMoments};

/// Cells from the origin, as a power of two, beyond which f32 has no fraction of a cell left that is worth a weight, and f64 no
/// index.
fn farthest<R: Real>() -> i32 {
    if R::SINGLE { 20 } else { 28 }
}

/// The largest quantile that a cell may have.
const QUANTILE: f64 = 6.5;

/// A pixel of a surface of many facets, for any number of lights.
///
/// $P_{22}(s) = \sum_l w_l \sum_c W_c P_c(s)$: two levels of cells, one of which is at most as wide as the pixel; of each
/// the cells within the pixel's ellipse, whose half axes are as long as the derivatives, by a Gaussian of half that as its
/// deviation, less what is left of it at the rim; and of each cell its own density $P_c(s) = p_i(x)\, p_j(y)/|\det M|$ at
/// $(x, y) = R^{-1} M^{-1} s$, with Chermain's matrix M ([`Roughness::chermain_matrix`] of $\sigma_o = 1$), and a rotation R,
/// marginals i and j and their level from the cell's random numbers. On levels beyond the dictionary's last it is
/// the Gaussian that all tend to.
///
/// Masking is that of V-cavities, exact for it ([`cavity_masking`]). Directions in the shading frame: its normal is the mean
/// of the slopes, as no masking of cavities with another mean is known.
///
/// Source: Chermain et al. 2020; 2021, Eq. 3 to 6, 10, 15 and 18.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchLobe<'a, R> {
    dictionary: &'a Dictionary<R>,
    roughness: Roughness<R>,
    kernel: Kernel<R>,
    /// As published, instead of the kernel.
    mips: Option<Footprint<R>>,
    pub(super) ellipse: Ellipse<R>,
    /// Of the finer level, and how far the coarser one has come.
    exponent: i32,
    coarser: R,
    /// Base 4 logarithm of the facets in a cell of the finer level.
    facets: R,
    variation: R,
    share: R,
    seed: u32,
}

impl<'a, R: Real> PatchLobe<'a, R> {
    #[inline]
    pub(super) fn new(
        material: &MultiLobe<R>,
        dictionary: &'a Dictionary<R>,
        ellipse: Ellipse<R>,
    ) -> Self {
        let MultiLobe { roughness, density, variation, share, seed } = *material;
        let distance = ellipse.uv[0].abs().max(ellipse.uv[1].abs().max(R::ZERO));
        let size = ellipse
            .width
            .max(material.facet_size())
            .max(distance * R::power_of_two(-farthest::<R>()));
        let size = size.max(R::power_of_two(-100)).min(R::power_of_two(100));
        let exponent = size.exponent();
        let ln_two = R::TWO.ln();
        let coarser = (size * R::power_of_two(-exponent)).ln() / ln_two;
        let coarser = coarser.max(R::ZERO).min(R::ONE);
        let facets = R::HALF * density.ln() / ln_two + R::lit(f64::from(exponent));
        let kernel = Kernel::default();
        Self {
            dictionary,
            roughness,
            kernel,
            mips: None,
            ellipse,
            exponent,
            coarser,
            facets,
            variation,
            share,
            seed,
        }
    }

    /// Cells of the finer level have the size $2^k$, k being this.
    ///
    /// WGSL: none, a field there.
    pub fn exponent(&self) -> i32 {
        self.exponent
    }

    /// How much of the pixel is of the coarser level, in [0, 1].
    ///
    /// WGSL: none, a field there.
    pub fn coarser(&self) -> R {
        self.coarser
    }

    /// Over a patch of a normal map: its covariance, seen from its mean, is added to the roughness, $\Sigma + J
    /// \Sigma_{map} J^T$ ([`MeanFrame::moments`]).
    ///
    /// The map's mean is the normal of the frame in which all directions are given from here on: [`MeanFrame::of`] it
    /// takes them there. Moments with mean 0 change no frame.
    ///
    /// Source: Chermain et al. 2021, section 5, who leave J out.
    ///
    /// WGSL: `lobe_patch_lobe_over`.
    #[must_use]
    #[inline]
    pub fn over(&self, moments: &SlopeMoments<R>) -> Self {
        let seen = MeanFrame::of(moments.mean()).moments(moments);
        let roughness = self.roughness.plus(&Roughness::from_covariance(seen.covariance()));
        Self { roughness, ..*self }
    }

    /// Under the pixel's kernel, the half vector's spread over the pixel: every marginal is averaged over a box of the
    /// kernel's deviation along it.
    ///
    /// Boxes of $\sqrt{12}$ deviations, of a parallelogram under [`PixelFilter::BOX`](crate::PixelFilter::BOX) as wide as
    /// its own marginal's deviation asks for; what the kernel's two axes share is lost. Of half vectors on the disk:
    /// [`DiskKernel::as_slopes`](crate::filter::DiskKernel::as_slopes), as Chermain et al. 2021, Eq. 21.
    ///
    /// WGSL: `lobe_patch_lobe_widened`.
    #[must_use]
    #[inline]
    pub fn widened(&self, kernel: &Kernel<R>) -> Self {
        Self { kernel: self.kernel.then(kernel), ..*self }
    }

    /// Under the published filter of the same purpose: lookups in mips by the half vector's derivatives times `scale`,
    /// $s_K$; they take the place of kernels, which count no more, whether given before or after.
    ///
    /// As published, the last level, which has no table, is not filtered.
    ///
    /// Source: Chermain et al. 2021, Eq. 19 and section 6.1, with $s_K$ of 0.5 or 1.
    ///
    /// ```
    /// use lobe::material::glint::Patch;
    /// use lobe::material::multilobe::{Dictionary, MultiLobe, Recipe};
    /// use lobe::{Footprint, Kernel, PixelFilter, Roughness};
    /// let dictionary = Dictionary::<f64>::new(&Recipe { levels: 8, ..Recipe::default() })?;
    /// let sand = MultiLobe::new(Roughness::from_alpha(0.3)?, 1e3)?;
    /// let pixel = sand.lobe(&dictionary, &Patch::default());
    /// let footprint = Footprint::from_slopes([0.1, 0.0], [0.0, 0.2]);
    /// let mips = pixel.with_mips(&footprint, 0.5).slope_pdf([0.1, 0.0]);
    /// let boxes = pixel.widened(&Kernel::of(&footprint, PixelFilter::BOX)).slope_pdf([0.1, 0.0]);
    /// assert!(mips >= 0.0 && boxes >= 0.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    ///
    /// WGSL: none, it stands for comparison.
    #[must_use]
    pub fn with_mips(&self, footprint: &Footprint<R>, scale: R) -> Self {
        let [u, v] = [footprint.u, footprint.v].map(|d| d.map(|x| scale * x));
        Self { mips: Some(Footprint::from_slopes(u, v)), ..*self }
    }

    /// The same without that filter.
    pub(super) fn without_mips(&self) -> Self {
        Self { mips: None, ..*self }
    }

    /// The smooth lobe that it tends to from afar.
    ///
    /// WGSL: `lobe_patch_lobe_smooth`.
    #[inline]
    pub fn smooth(&self) -> Beckmann<Full<R>> {
        let widened = match self.mips {
            Some(_) => self.roughness,
            None => self.roughness.widened(&self.kernel),
        };
        Beckmann::new(Full::new(widened))
    }

    /// Density of slopes at a slope.
    ///
    /// WGSL: `lobe_patch_lobe_slope_pdf`.
    pub fn slope_pdf(&self, slope: impl Into<[R; 2]>) -> R {
        let slope = slope.into();
        let smooth = self.smooth().slope_pdf(slope);
        if self.is_smooth() {
            return smooth;
        }
        let plane = Plane::new(&self.roughness, &self.kernel, self.mips);
        let at = plane.point(slope);
        let plane = plane.around(at);
        let density = |facets: Option<Facets<R>>| {
            facets.map_or(smooth, |facets| plane.density(self.dictionary, at, &facets))
        };
        let shares = [R::ONE - self.coarser, self.coarser];
        let mut mean = R::ZERO;
        for (step, share) in (0..).zip(shares) {
            if share > R::ZERO {
                let (mut sum, mut whole) = (R::ZERO, R::ZERO);
                self.cells(step, |weight, cell| {
                    sum = sum + weight * density(self.numbers(cell, step));
                    whole = whole + weight;
                });
                mean = mean + share * (sum / whole);
            }
        }
        mean.max(R::ZERO).min(R::MAX)
    }

    /// Density of normals, $D(m) = P_{22}(s)/m_z^4$; 0 below the horizon.
    ///
    /// WGSL: `lobe_patch_lobe_d`.
    #[inline]
    pub fn d(&self, m: impl Into<[R; 3]>) -> R {
        let m = m.into();
        if !(m[2] > R::ZERO) {
            return R::ZERO;
        }
        let square = m[2] * m[2];
        (self.slope_pdf(slope_of(m)) / (square * square)).min(R::MAX)
    }

    /// The BRDF without Fresnel, $D G_2/(4 o_z i_z)$; 0 where a direction lies below the horizon.
    ///
    /// WGSL: `lobe_patch_lobe_brdf`.
    #[inline]
    pub fn brdf(&self, wo: impl Into<[R; 3]>, wi: impl Into<[R; 3]>) -> R {
        let (wo, wi) = (wo.into(), wi.into());
        let h = half_vector(wo, wi);
        let masking = cavity_masking_shadowing(wo, wi, h);
        if masking > R::ZERO {
            (self.d(h) * (masking / (R::lit(4.0) * wo[2] * wi[2]))).min(R::MAX)
        } else {
            R::ZERO
        }
    }

    /// Masking of a facet, of V-cavities.
    ///
    /// WGSL: none, `lobe_cavity_masking` there.
    #[inline]
    pub fn g1(&self, w: impl Into<[R; 3]>, m: impl Into<[R; 3]>) -> R {
        cavity_masking(w, m)
    }

    /// The dictionary of its marginals, its roughness and its kernel.
    #[inline]
    pub(super) fn dictionary(&self) -> &'a Dictionary<R> {
        self.dictionary
    }

    #[inline]
    pub(super) fn roughness(&self) -> &Roughness<R> {
        &self.roughness
    }

    #[inline]
    pub(super) fn kernel(&self) -> &Kernel<R> {
        &self.kernel
    }

    /// Whether all cells are beyond the dictionary's last level, whatever their random numbers.
    #[inline]
    pub(super) fn is_smooth(&self) -> bool {
        let levels = R::lit(f64::from(self.dictionary.recipe().levels));
        self.facets - R::lit(QUANTILE) * self.variation > levels
    }

    /// Calls `f` with the share of every cell, and its numbers. Shares sum to 1.
    #[inline]
    pub(super) fn visit(&self, mut f: impl FnMut(R, Option<Facets<R>>)) {
        let shares = [R::ONE - self.coarser, self.coarser];
        for (step, level) in (0..).zip(shares) {
            if !(level > R::ZERO) {
                continue;
            }
            let mut whole = R::ZERO;
            self.cells(step, |weight, _| whole = whole + weight);
            let share = level / whole;
            self.cells(step, |weight, cell| f(share * weight, self.numbers(cell, step)));
        }
    }

    /// Calls `f` with the weight of every cell of a level.
    #[inline]
    fn cells(&self, step: i32, mut f: impl FnMut(R, Cell)) {
        let exponent = self.exponent + step;
        let rows = self.ellipse.rows(exponent);
        for t in rows.first..=rows.last {
            let row = rows.row(t);
            for s in row.first..=row.last {
                let weight = row.weight(s);
                if weight > R::ZERO {
                    f(weight, Cell::at([s, t], exponent, self.seed));
                }
            }
        }
    }

    /// What a cell has drawn; none: the smooth lobe.
    #[inline]
    fn numbers(&self, cell: Cell, step: i32) -> Option<Facets<R>> {
        let [area, level, turn, pair] = cell.words();
        let recipe = self.dictionary.recipe();
        let deviation = self.variation * normal_quantile(tail::<R>(level));
        let mean = self.facets + R::lit(f64::from(step));
        // Rounded by chance, with bits that the turn leaves: numbers between powers of 4 have their share of both.
        let rounding = R::lit(f64::from(turn & 0xff)) * R::power_of_two(-8);
        let level = (mean + deviation + rounding).floor().max(0).unsigned_abs();
        if level >= recipe.levels || tail::<R>(area) > self.share {
            return None;
        }
        let pick = |word: u32| ((word & 0xffff) * recipe.marginals) >> 16;
        Some(Facets { level, turn: quarter_turn(turn), marginals: [pick(pair >> 16), pick(pair)] })
    }
}
