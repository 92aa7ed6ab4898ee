//! GGX over a parallelogram for numbers of f32, by the sum over its edges in f64.
//!
//! Layer 3. In f64 the sum over the edges (halves.rs) serves nearly every footprint, and the sizes
//! of its terms tell which: the others go to the tree.

use super::halves::Halves;
use crate::ndf::{GgxDistribution, Ndf};
use crate::slope::{Footprint, Whiten};
use core::f64::consts::FRAC_1_PI;

impl<S: Whiten<Scalar = f32>> Ndf<GgxDistribution, S> {
    /// [`Ndf::parallelogram_mean`] at the accuracy promised there, by f64 inside: without a branch
    /// wherever the sum over the edges in f64 is certain to keep that promise, by the tree
    /// elsewhere.
    ///
    /// The sum over the edges is $\bar P = \frac{1}{8 \pi \sqrt{\det A}\; a \times b} \sum
    /// \frac{k}{r} \mathrm{atan2}(r, x)$ of [`Ndf::parallelogram_mean_in_lanes`]. It is taken if
    /// its terms, each in error by 8e-12 at most, leave it within 5e-6 of the exact sum, or 5e-4
    /// beyond ten alphas. That holds for 99 of 100 footprints with sides of 0.01 to 100 alphas
    /// around centers within 3 alphas of the lobe's, for 95 within 30 alphas, and for 85 within
    /// 300.
    ///
    /// Error, relative: below 1e-5 within ten alphas of the lobe, and 1e-3 wherever the mean is a
    /// normal number. Mirrors, grooves and numbers that are NaN or infinite: as
    /// [`Ndf::parallelogram_mean`]. Shapes of entries ([`Compensated`](crate::slope::Compensated))
    /// count as their factor in f32: the error is then that of inputs moved by some roundings.
    ///
    /// Cost: in lanes ([`batch::Ndf`](crate::batch::Ndf)) about 18 times the isotropic BRDF, a
    /// sixth of `parallelogram_mean`; one at a time half of it.
    ///
    /// Source: as `parallelogram_mean_in_lanes`; which sums are certain is ours.
    ///
    /// ```
    /// use lobe::{Anisotropic, Footprint, Ggx, Roughness};
    /// let ggx = Ggx::new(Anisotropic::new(Roughness::from_alphas(0.1_f32, 0.02, 0.4)?));
    /// let pixel = Footprint::from_slopes([0.3, 0.0], [0.01, 0.4]);
    /// let mean = ggx.parallelogram_mean_in_double([0.05, 0.0], &pixel);
    /// assert!((mean / ggx.parallelogram_mean([0.05, 0.0], &pixel) - 1.0).abs() < 2e-5);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[inline]
    pub fn parallelogram_mean_in_double(
        &self,
        slope: impl Into<[f32; 2]>,
        footprint: &Footprint<f32>,
    ) -> f32 {
        let slope = slope.into();
        let mean = self.parallelogram_mean_if_known(slope, footprint);
        if mean.is_nan() { self.parallelogram_mean(slope, footprint) } else { mean }
    }

    /// The mean by the sum over the edges in f64, without a branch; NaN where that is not certain.
    #[inline(always)]
    pub(crate) fn parallelogram_mean_if_known(
        &self,
        slope: [f32; 2],
        footprint: &Footprint<f32>,
    ) -> f32 {
        let wide = |v: [f32; 2]| v.map(f64::from);
        let [l_xx, l_yx, l_yy] = self.shape().factor().map(f64::from);
        let root_det = l_xx * l_yy;
        let inverse = 1.0 / root_det.max(f64::from(f32::MIN_POSITIVE));
        let whiten = |[x, y]: [f64; 2]| [l_yy * inverse * x, (l_xx * y - l_yx * x) * inverse];
        let (high, low) = self.shape().offset(slope);
        let offset =
            [f64::from(high[0]) + f64::from(low[0]), f64::from(high[1]) + f64::from(low[1])];
        let over = Footprint { u: wide(footprint.u), v: wide(footprint.v) };
        let mean = Halves::new(offset, &over, whiten).mean();
        let known = mean.known && root_det >= f64::from(f32::MIN_POSITIVE);
        if known { (FRAC_1_PI * inverse * mean.value) as f32 } else { f32::NAN }
    }
}

#[cfg(test)]
mod tests {
    use crate::ndf::Ggx;
    use crate::slope::{Anisotropic, Footprint, Roughness};

    /// The share of footprints with sides of 0.01 to 100 alphas, around centers within `reach`
    /// alphas, whose sum over the edges is certain.
    fn share_of_known(reach: f32) -> f32 {
        let mut known = 0;
        for k in 0..20_000 {
            // Multiples of irrational numbers fill a cube evenly.
            let [a, b, c, d, e, f] = [2.0_f64, 3.0, 5.0, 7.0, 11.0, 13.0]
                .map(|n| (n.sqrt() * f64::from(k)).fract() as f32);
            let turned = |length: f32, share: f32| {
                let (sin, cos) = (core::f32::consts::TAU * share).sin_cos();
                [length * cos, length * sin]
            };
            let alphas = [10.0_f32.powf(-2.0 * a), 10.0_f32.powf(-2.0 * b)];
            let matrix = Roughness::from_alphas(alphas[0], alphas[1], 3.0 * c).expect("in range");
            let [l_xx, l_yx, l_yy] = matrix.matrix().cholesky();
            let slope = |[x, y]: [f32; 2]| [l_xx * x, l_yx * x + l_yy * y];
            let over = Footprint {
                u: slope(turned(10.0_f32.powf(4.0 * d - 2.0), e)),
                v: slope(turned(10.0_f32.powf(4.0 * f - 2.0), (7.0 * a + e).fract())),
            };
            let at = slope(turned(reach * (17.0 * b).fract(), (19.0 * c).fract()));
            let mean = Ggx::new(Anisotropic::new(matrix)).parallelogram_mean_if_known(at, &over);
            known += u16::from(!mean.is_nan());
        }
        f32::from(known) / 20_000.0
    }

    #[test]
    fn the_sum_serves_as_often_as_stated() {
        for (reach, share) in [(3.0, 0.99), (30.0, 0.95), (300.0, 0.85)] {
            let known = share_of_known(reach);
            assert!(known >= share, "{reach} alphas: {known}");
        }
    }
}
