//! A mapped plane in view: lookups and kernels at a place of the picture, in the precision of an
//! engine.

use lobe::{
    Error, Footprint, Isotropic, Kernel, Lobe, NonCentered, PixelFilter, Roughness, SlopeMoments,
};

use super::texels::Texels;
use super::view::{Spot, Steps, View};

/// A mapped plane in view, and the material on it.
pub(super) struct Ground<'a> {
    pub(super) texels: &'a Texels,
    pub(super) view: View<f32>,
    alpha: f32,
    /// The same as a matrix.
    pub(super) base: Roughness<f32>,
}

impl<'a> Ground<'a> {
    pub(super) fn new(texels: &'a Texels, view: &View<f64>, alpha: f64) -> Result<Self, Error> {
        let alpha = alpha as f32;
        let base = Roughness::from_alpha(alpha)?;
        Ok(Self { texels, view: view.cast(), alpha, base })
    }

    /// The base around a slope.
    #[inline]
    pub(super) fn bare(&self, slope: [f32; 2]) -> Result<NonCentered<Isotropic<f32>>, Error> {
        NonCentered::new(Isotropic::new(self.alpha)?, slope)
    }

    /// The base around a slope, with as much variance on either axis.
    #[inline]
    pub(super) fn rougher(
        &self,
        slope: [f32; 2],
        variance: f32,
    ) -> Result<NonCentered<Isotropic<f32>>, Error> {
        let alpha = (self.alpha * self.alpha + 2.0 * variance).sqrt();
        NonCentered::new(Isotropic::new(alpha)?, slope)
    }

    /// The mean normal as trilinear mips have it, shorter the more it stands for.
    #[inline]
    pub(super) fn mean_normal(&self, spot: &Spot<f32>, steps: &Steps<f32>) -> [f32; 3] {
        self.texels.normals.trilinear(spot.uv, self.texels.lod(steps.du, steps.dv))
    }

    #[inline]
    pub(super) fn trilinear(&self, uv: [f32; 2], steps: &Steps<f32>) -> SlopeMoments<f32> {
        self.texels.moments.trilinear(uv, self.texels.lod(steps.du, steps.dv))
    }

    /// Along the pixel's longer side as GPUs filter: as many trilinear lookups of the shorter one
    /// as cover it.
    #[inline]
    pub(super) fn anisotropic(
        &self,
        spot: &Spot<f32>,
        steps: &Steps<f32>,
    ) -> Result<SlopeMoments<f32>, Error> {
        let [a, b] = [steps.du, steps.dv].map(|side| self.texels.squared(side).sqrt());
        let (long, short, side) = if a >= b { (a, b, steps.du) } else { (b, a, steps.dv) };
        let count =
            f32::from((1..PROBES).find(|&n| f32::from(n) * short >= long).unwrap_or(PROBES));
        let lod = short.max(long / count).log2();
        let at = |k: f32| {
            let t = (k + 0.5) / count - 0.5;
            self.texels.moments.trilinear([0, 1].map(|axis| spot.uv[axis] + t * side[axis]), lod)
        };
        let (mut sum, mut k) = (at(0.0), 1.0);
        while k < count {
            sum = sum.merged(k, &at(k), 1.0)?;
            k += 1.0;
        }
        Ok(sum)
    }

    /// The same by probes that are not wider than the pixel.
    #[inline]
    pub(super) fn narrow(&self, spot: &Spot<f32>, steps: &Steps<f32>) -> SlopeMoments<f32> {
        self.texels.moments.anisotropic(spot.uv, steps.du, steps.dv, PROBES.into())
    }

    /// The kernel of the half vector's motion over the flat plane; the normal map does not enter.
    #[inline]
    pub(super) fn kernel(&self, spot: &Spot<f32>, steps: &Steps<f32>) -> Kernel<f32> {
        Kernel::of(&self.view.footprint(spot, steps), PixelFilter::BOX)
    }

    /// The kernel of the half vector's motion in the frame of the mean slope, by differences to the
    /// next pixels, as in a shader.
    #[inline]
    pub(super) fn shading_kernel(
        &self,
        spot: &Spot<f32>,
        steps: &Steps<f32>,
        mean: [f32; 2],
    ) -> Kernel<f32> {
        let flat = self.view.footprint(spot, steps);
        let [u, v] = spot.uv;
        let [right, below] = [steps.du, steps.dv].map(|step| {
            let there = self.trilinear([u + step[0], v + step[1]], steps).mean();
            [there[0] - mean[0], there[1] - mean[1]]
        });
        Kernel::of(&(flat - Footprint::from_slopes(right, below)), PixelFilter::BOX)
    }

    #[inline]
    pub(super) fn lean(&self, moments: &SlopeMoments<f32>) -> Lobe<f32> {
        moments.lobe(self.base)
    }
}

/// Trilinear lookups along a pixel, at most: what GPUs offer.
pub(crate) const PROBES: u8 = 16;
