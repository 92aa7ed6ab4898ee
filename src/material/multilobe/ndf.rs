//! What a pixel sees of many facets: a density of slopes that integrates to 1.
//!
//! Layer 4.

use super::cells::{Cells, Facets};
use super::dictionary::Dictionary;
use super::ellipse::Ellipse;
use super::material::MultiLobe;
use super::plane::Plane;
use crate::filter::Kernel;
use crate::material::cells::Patch;
use crate::ndf::{Beckmann, cavity_masking, cavity_masking_shadowing};
use crate::scalar::Real;
use crate::slope::direction::{half_vector, slope_of};
use crate::slope::{Anisotropic, Footprint, LobeShape, MeanFrame, Roughness, SlopeMoments};

/// A pixel of a surface of many facets, for any number of lights.
///
/// $P_{22}(s) = \sum_l w_l \sum_c W_c P_c(s)$. Two levels of cells are blended, as in a mip chain;
/// cells of the finer one are no wider than the pixel's shorter axis, or than one facet's square
/// where that is more. Cells of a level count by $W \propto e^{-2r^2} - e^{-2}$, where r is 1 on an
/// ellipse whose half axes are the derivatives' singular values, grown by a cell. Each has a
/// density of its own, $P_c(s) = p_i(x)\, p_j(y)/|\det M|$ at $(x, y) = R^{-1} M^{-1} s$, with
/// Chermain's matrix M ([`Roughness::chermain_matrix`] of $\sigma_o = 1$) and a rotation R,
/// marginals i and j and their level from its random numbers: $4^{L + 1}$ lobes for $4^L$ facets,
/// and beyond the dictionary's last level the Gaussian that all tend to. A coarse cell has the
/// numbers of the finer cell at its lower left corner, and four times the facets, so that glints
/// stay where they are.
///
/// The integral is 1 in every pixel; tables end at 4 deviations along each axis of a cell. The mean
/// over pixels is the smooth lobe within 2 % up to two deviations (tests/laws/multilobe_mean.rs);
/// beyond three, where cells have few facets, it is less, as 192 lobes on an axis seldom reach that
/// far. As a pixel grows, the variance of its density over the surface halves with every doubling
/// of its width. It does not fall evenly: a blend of two levels varies less than either, so that
/// halfway between them it is lower than at the next level, by 19 %
/// (tests/laws/multilobe_scales.rs).
///
/// Everything is continuous in the pixel, its kernel, the normal map and the roughness. Not so in
/// density, variation and share, with which single cells change at once: they belong to a surface,
/// and no texture should hold them.
///
/// Masking is that of V-cavities, exact for it ([`cavity_masking`]). Directions in the shading
/// frame: its normal is the mean of the slopes, as no masking of cavities with another mean is
/// known.
///
/// Source: Chermain et al. 2020; 2021a, Eq. 3 to 6, 10, 15 and 18.
// Further methods: material/multilobe/sample.rs.
#[doc(alias = "LobePatchNdf")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchNdf<'a, R> {
    dictionary: &'a Dictionary<R>,
    roughness: Roughness<R>,
    kernel: Kernel<R>,
    /// As published, instead of the kernel.
    mips: Option<Footprint<R>>,
    cells: Cells<R>,
}

impl<R: Real> MultiLobe<R> {
    /// What a pixel sees of it.
    ///
    /// Cells are no smaller than $2^{-20}$ of the distance of `uv` from the tile's corner, in f64
    /// $2^{-28}$: far from the origin facets of plain coordinates get larger and fade
    /// ([`Patch::new`] says where). Coordinates of large surfaces belong into [`Patch::in_tile`].
    /// NaN counts as 0, and numbers beyond $10^9$ as that.
    #[doc(alias = "lobe_multi_lobe_ndf")]
    #[inline]
    pub fn ndf<'a>(&self, dictionary: &'a Dictionary<R>, patch: &Patch<R>) -> PatchNdf<'a, R> {
        PatchNdf::new(dictionary, self.roughness, Cells::new(self, Ellipse::of(patch)))
    }
}

impl<'a, R: Real> PatchNdf<'a, R> {
    #[inline]
    fn new(dictionary: &'a Dictionary<R>, roughness: Roughness<R>, cells: Cells<R>) -> Self {
        Self { dictionary, roughness, kernel: Kernel::default(), mips: None, cells }
    }

    /// Cells of the finer level have the size $2^k$, k being this.
    pub const fn exponent(&self) -> i32 {
        self.cells.exponent
    }

    /// How much of the pixel is of the coarser level, in [0, 1].
    pub const fn coarser(&self) -> R {
        self.cells.coarser
    }

    /// Over a patch of a normal map: its covariance, seen from its mean, is added to the roughness,
    /// $\Sigma + J \Sigma_{map} J^T$ ([`MeanFrame::moments`]).
    ///
    /// The map's mean is the normal of the frame in which all directions are given from here on:
    /// [`MeanFrame::of`] it takes them there. Moments with mean 0 change no frame.
    ///
    /// Source: Chermain et al. 2021a, section 5, who leave J out.
    #[doc(alias = "lobe_patch_ndf_over")]
    #[must_use]
    #[inline]
    pub fn over(&self, moments: &SlopeMoments<R>) -> Self {
        let seen = MeanFrame::of(moments.mean()).moments(moments);
        let roughness = self.roughness + Roughness::from_covariance(seen.covariance());
        Self { roughness, ..*self }
    }

    /// Under the pixel's kernel, the half vector's spread over the pixel: every cell's density is
    /// averaged over it.
    ///
    /// The kernel is taken as a rectangle of its covariance, cut along its long side into pieces of
    /// 1.5 deviations of the lobe, or of its width where that is more. Over each piece both
    /// marginals are averaged over boxes that have the piece's variance along them. Their means are
    /// exact; the covariance of a piece along a cell's axes is dropped. In the mean over rotations
    /// that takes at most 4.7 % of the lobe's own variance from one axis to the other, and of a
    /// kernel wider than 1.5 deviations up to a tenth of its own. A lobe counts as no narrower than
    /// a thousandth of the kernel's deviation.
    ///
    /// Cells beyond the last level have the Gaussian of the same covariance instead, as
    /// [`PatchNdf::smooth`]. Under a square kernel of the lobe's deviation its peak is 14 % higher
    /// than a box's, and $6/\pi$ times as high where the lobe is nothing against the kernel.
    ///
    /// Half vectors on the disk: [`DiskKernel::as_slopes`](crate::filter::DiskKernel::as_slopes),
    /// as Chermain et al. 2021a, Eq. 21; slopes: Eq. 20.
    #[doc(alias = "lobe_patch_ndf_widened")]
    #[must_use]
    #[inline]
    pub fn widened(&self, kernel: &Kernel<R>) -> Self {
        Self { kernel: self.kernel + *kernel, ..*self }
    }

    /// Under the published filter of the same purpose: lookups in mips by the half vector's
    /// derivatives times `scale`, $s_K$; they take the place of kernels, which count no more,
    /// whether given before or after.
    ///
    /// As published, the last level, which has no table, is not filtered.
    ///
    /// Source: Chermain et al. 2021a, Eq. 19 and section 6.1, with $s_K$ of 0.5 or 1.
    ///
    /// ```
    /// use lobe::material::cells::Patch;
    /// use lobe::material::multilobe::{Dictionary, MultiLobe, Recipe};
    /// use lobe::{Footprint, Kernel, PixelFilter, Roughness};
    /// let dictionary = Dictionary::<f64>::new(&Recipe { levels: 8, ..Recipe::default() })?;
    /// let sand = MultiLobe::new(Roughness::from_alpha(0.3)?, 1e3)?;
    /// let pixel = sand.ndf(&dictionary, &Patch::default());
    /// let footprint = Footprint::from_slopes([0.1, 0.0], [0.0, 0.2]);
    /// let mips = pixel.with_mips(&footprint, 0.5).slope_pdf([0.1, 0.0]);
    /// let boxes = pixel.widened(&Kernel::of(&footprint, PixelFilter::BOX)).slope_pdf([0.1, 0.0]);
    /// assert!(mips >= 0.0 && boxes >= 0.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[must_use]
    pub fn with_mips(&self, footprint: &Footprint<R>, scale: R) -> Self {
        let [u, v] = [footprint.u, footprint.v].map(|d| d.map(|x| scale * x));
        Self { mips: Some(Footprint::from_slopes(u, v)), ..*self }
    }

    /// The same without that filter.
    pub(super) const fn without_mips(&self) -> Self {
        Self { mips: None, ..*self }
    }

    /// The smooth lobe that it tends to from afar.
    #[doc(alias = "lobe_patch_ndf_smooth")]
    #[inline]
    pub fn smooth(&self) -> Beckmann<Anisotropic<R>> {
        let widened = match self.mips {
            Some(_) => self.roughness,
            None => self.roughness.widened(&self.kernel),
        };
        Beckmann::new(Anisotropic::new(widened))
    }

    /// Density of slopes at a slope: 0 for a mirror that no kernel widens.
    #[doc(alias = "lobe_patch_ndf_slope_pdf")]
    pub fn slope_pdf(&self, slope: impl Into<[R; 2]>) -> R {
        let slope = slope.into();
        let smooth = self.smooth();
        let tended = smooth.slope_pdf(slope);
        if self.is_smooth() || !(smooth.shape().root_det() > R::ZERO) {
            return tended;
        }
        let (plane, at) = Plane::new(&self.roughness, &self.kernel, self.mips).around(slope);
        let mean = self.cells.mean(self.dictionary.recipe(), |facets| match facets {
            Some(facets) => plane.density(self.dictionary, at, &facets),
            None => tended,
        });
        bounded(mean)
    }

    /// Density of normals, $D(m) = P_{22}(s)/m_z^4$; 0 below the horizon.
    #[doc(alias = "lobe_patch_ndf_d")]
    #[inline]
    pub fn d(&self, m: impl Into<[R; 3]>) -> R {
        let m = m.into();
        if !(m[2] > R::ZERO) {
            return R::ZERO;
        }
        let square = m[2] * m[2];
        bounded(self.slope_pdf(slope_of(m)) / (square * square))
    }

    /// The BRDF without Fresnel, $D G_2/(4 o_z i_z)$; 0 where a direction lies below the horizon.
    #[doc(alias = "lobe_patch_ndf_brdf")]
    #[inline]
    pub fn brdf(&self, wo: impl Into<[R; 3]>, wi: impl Into<[R; 3]>) -> R {
        let (wo, wi) = (wo.into(), wi.into());
        let h = half_vector(wo, wi);
        let masking = cavity_masking_shadowing(wo, wi, h);
        if masking > R::ZERO {
            bounded(self.d(h) * (masking / (R::lit(4.0) * wo[2] * wi[2])))
        } else {
            R::ZERO
        }
    }

    /// Masking of a facet, of V-cavities.
    #[inline]
    pub fn g1(&self, w: impl Into<[R; 3]>, m: impl Into<[R; 3]>) -> R {
        cavity_masking(w, m)
    }

    /// The dictionary of its marginals, its roughness and its kernel.
    #[inline]
    pub(super) const fn dictionary(&self) -> &'a Dictionary<R> {
        self.dictionary
    }

    #[inline]
    pub(super) const fn roughness(&self) -> &Roughness<R> {
        &self.roughness
    }

    #[inline]
    pub(super) const fn kernel(&self) -> &Kernel<R> {
        &self.kernel
    }

    /// Whether it is the smooth lobe, whatever its cells have drawn.
    #[inline]
    pub(super) fn is_smooth(&self) -> bool {
        self.cells.are_smooth(self.dictionary.recipe())
    }

    /// What one of its cells has drawn, by a uniform number; none: the smooth lobe.
    #[inline]
    pub(super) fn chosen(&self, u: R) -> Option<Facets<R>> {
        if self.is_smooth() { None } else { self.cells.chosen(self.dictionary.recipe(), u) }
    }
}

/// A density as it is answered: 0 where it is 0 of nothing, and never infinite.
#[inline]
pub(super) fn bounded<R: Real>(density: R) -> R {
    density.max(R::ZERO).min(R::MAX)
}
