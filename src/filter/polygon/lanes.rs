//! GGX over a parallelogram without a branch.
//!
//! Layer 3. The tree (tree.rs) chooses among five ways by the footprint; here all samples take one
//! way (halves.rs), so that a loop over them fills the lanes of vectors, and a GPU's warp does not
//! diverge. The price is accuracy, stated at [`Ndf::parallelogram_mean_in_lanes`].

use super::halves::Halves;
use crate::ndf::{GgxDistribution, Ndf};
use crate::scalar::Real;
use crate::slope::{Footprint, Whiten};
use core::f64::consts::FRAC_1_PI;

/// $1/\sqrt{\det A}$, and what a mean may be at most: 0 for a mirror or a groove. A limit instead
/// of a branch keeps loops over samples free of jumps.
#[inline(always)]
pub(super) fn inverse_and_limit<R: Real>(root_det: R) -> (R, R) {
    let resolved = root_det >= R::MIN_POSITIVE;
    (R::ONE / root_det.max(R::MIN_POSITIVE), if resolved { R::MAX } else { R::ZERO })
}

impl<S: Whiten> Ndf<GgxDistribution, S> {
    /// Mean of $P_{22}$ over the parallelogram `slope +- u/2 +- v/2` of a footprint, without a
    /// branch: [`Ndf::parallelogram_mean`] for loops that become vectors, and for GPUs.
    ///
    /// Whitened, $\bar P = \frac{1}{8 \pi \sqrt{\det A}\; a \times b} \sum \frac{k}{r}
    /// \mathrm{atan2}(r, x)$ over the four edges, with a and b the half sides, k half the
    /// cross product of an edge's corners, $r^2 = k^2$ plus its squared half length, and x half of
    /// 1 plus their scalar product. A zero footprint gives $P_{22}$, a segment the mean along it.
    ///
    /// Relative error, for sides of 0.01 to 100 alphas whose lengths differ by at most 1000 and a
    /// center that lies within 3 or 30 alphas of the lobe's; "sheared" are footprints with
    /// nearly parallel sides, to a thousandth of a radian:
    ///
    /// | | median | 99 of 100 below | largest of 400,000 |
    /// |---|---|---|---|
    /// | f32, 3 alphas | 7e-7 | 1.4e-4, sheared 5e-4 | 3e-3 |
    /// | f32, 30 alphas | 1.3e-5 | 4e-3, sheared 9e-3 | 4e-2 |
    /// | f64, 3 alphas | 2e-12 | 6e-8, sheared 3e-7 | 7e-6 |
    /// | f64, 30 alphas | 5e-10 | 4e-7, sheared 2e-6 | 3e-5 |
    ///
    /// Beyond, f32 is no longer an estimate of the tail: at 300 alphas one in ten is off by 3 %,
    /// one in a hundred by 30 %; farther out errors of a factor 400 occur, and a mean that is not 0
    /// may come out as 0. What is missing or too much there is at most 8e-5 of the lobe's mass. f64
    /// is within 5e-5 in 99 of 100 to 300 alphas.
    ///
    /// Whitening is plain: of a long and thin lobe the error is that of moving it by some roundings
    /// of the slope. The mean of a mirror or a groove is 0 here; `parallelogram_mean` knows better.
    /// It is 0 as well where lengths exceed 1e9 alphas in f32 (1e75 in f64), and for numbers that
    /// are NaN; never NaN, negative or infinite.
    ///
    /// Cost: 13 divisions and 5 roots; in a loop over f32 samples about nine times the isotropic
    /// BRDF, a tenth of `parallelogram_mean`; in f64 twice that.
    ///
    /// Source: Lambert's formula for polygons; nodes, height, bound and polynomial are ours.
    ///
    /// ```
    /// use lobe::{Anisotropic, Footprint, Ggx, Roughness};
    /// let ggx = Ggx::new(Anisotropic::new(Roughness::from_alphas(0.1_f32, 0.02, 0.4)?));
    /// let pixel = Footprint::from_slopes([0.03, 0.0], [0.01, 0.04]);
    /// let mean = ggx.parallelogram_mean_in_lanes([0.05, 0.0], &pixel);
    /// assert!((mean / ggx.parallelogram_mean([0.05, 0.0], &pixel) - 1.0).abs() < 1e-3);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_ggx_parallelogram_mean_in_lanes")]
    #[inline(always)]
    pub fn parallelogram_mean_in_lanes(
        &self,
        slope: impl Into<[S::Scalar; 2]>,
        footprint: &Footprint<S::Scalar>,
    ) -> S::Scalar {
        let (inverse, limit) = inverse_and_limit(self.shape().root_det());
        let (offset, _) = self.shape().offset(slope.into());
        let whiten = |v| self.shape().whiten_with(v, inverse);
        let halves = Halves::new(offset, footprint, whiten);
        let mean = (S::Scalar::lit(FRAC_1_PI) * inverse) * halves.mean().value;
        mean.max(S::Scalar::ZERO).min(limit)
    }
}
