//! The shading functions: BRDF times cosine of one pixel, a few lines each.
//!
//! All f32, as an engine computes. Footprints are differences of the half vectors of the pixel and of
//! its right and upper neighbours, each in its own shading frame: what `ddx` and `ddy` give.

use lobe::filter::{beckmann_rectangle_mean, kaplanyan_rectangle_mean};
use lobe::slope::direction::slope_of;
use lobe::{Beckmann, Distribution, Footprint, Full, Ggx, Kernel, Ndf, PixelFilter, Shape};

use super::Material;
use crate::scene::Sample;

/// A pixel and the neighbours that its differences reach for.
pub(super) struct Quad<'a> {
    pub(super) here: &'a Sample<f32>,
    pub(super) right: &'a Sample<f32>,
    pub(super) above: &'a Sample<f32>,
}

impl Quad<'_> {
    /// The pixel's footprint on the slope plane; none where a half vector is below the horizon.
    #[inline]
    fn footprint(&self) -> Footprint<f32> {
        Footprint::from_half_vectors(self.here.half, self.right.half, self.above.half)
            .unwrap_or_default()
    }

    /// The same from differences on the projected disk, taken as slopes.
    #[inline]
    fn narrowed_footprint(&self) -> Footprint<f32> {
        let [x, y, _] = self.here.half;
        let to = |other: &Sample<f32>| [other.half[0] - x, other.half[1] - y];
        Footprint::from_disk_narrowed(to(self.right), to(self.above))
    }
}

/// BRDF times cosine.
#[inline]
fn lit<D: Distribution, S: Shape<Scalar = f32>>(ndf: Ndf<D, S>, sample: &Sample<f32>) -> f32 {
    ndf.brdf(sample.wo, sample.wi) * sample.wi[2]
}

/// One sample, no filter: GGX.
#[inline]
pub(super) fn plain_ggx(material: &Material, quad: &Quad<'_>) -> f32 {
    lit(Ggx::new(material.shape), quad.here)
}

/// One sample, no filter: Beckmann.
#[inline]
pub(super) fn plain_beckmann(material: &Material, quad: &Quad<'_>) -> f32 {
    lit(Beckmann::new(material.shape), quad.here)
}

/// A Gaussian kernel of the given pixel filter, its variance added to GGX's roughness.
#[inline]
pub(super) fn widened_ggx(filter: PixelFilter) -> impl Fn(&Material, &Quad<'_>) -> f32 {
    move |material, quad| {
        let kernel = Kernel::of(&quad.footprint(), filter);
        lit(Ggx::new(Full::new(material.roughness.widened(&kernel))), quad.here)
    }
}

/// A Gaussian kernel of the given pixel filter, convolved with Beckmann.
#[inline]
pub(super) fn widened_beckmann(filter: PixelFilter) -> impl Fn(&Material, &Quad<'_>) -> f32 {
    move |material, quad| {
        let kernel = Kernel::of(&quad.footprint(), filter);
        lit(Beckmann::new(Full::new(material.roughness.widened(&kernel))), quad.here)
    }
}

/// Disk derivatives used unchanged, a wide kernel, a cap on what it adds.
#[inline]
pub(super) fn tokuyoshi(material: &Material, quad: &Quad<'_>) -> f32 {
    let kernel = Kernel::of(&quad.narrowed_footprint(), PixelFilter::KAPLANYAN)
        .capped(Kernel::<f32>::ALPHA_SQUARED_LIMIT as f32);
    lit(Ggx::new(Full::new(material.roughness.widened(&kernel))), quad.here)
}

/// Extents of the rectangle, below and above: Kaplanyan et al. 2016, section 5.2. The lower one keeps
/// Appendix A out of its cancellation.
const EXTENTS: (f32, f32) = (1e-3, 1.0);

/// GGX over the footprint's bounding rectangle, by eight arctangents.
#[inline]
pub(super) fn rectangle_ggx(material: &Material, quad: &Quad<'_>) -> f32 {
    rectangle(Ggx::new(material.shape), material, quad, kaplanyan_rectangle_mean)
}

/// Beckmann over the footprint's bounding rectangle, by differences of the error function.
#[inline]
pub(super) fn rectangle_beckmann(material: &Material, quad: &Quad<'_>) -> f32 {
    rectangle(Beckmann::new(material.shape), material, quad, beckmann_rectangle_mean)
}

/// BRDF times cosine with the NDF's mean over the clamped bounding rectangle.
#[inline]
fn rectangle<D: Distribution, S: Shape<Scalar = f32>>(
    ndf: Ndf<D, S>,
    material: &Material,
    quad: &Quad<'_>,
    mean: impl Fn([f32; 2], [f32; 2], [f32; 2]) -> f32,
) -> f32 {
    let Sample { wo, wi, half } = *quad.here;
    if half[2] <= 0.0 {
        return 0.0;
    }
    let widths = quad.footprint().extents().map(|width| width.clamp(EXTENTS.0, EXTENTS.1));
    let cos2 = half[2] * half[2];
    let d = mean([material.alpha; 2], slope_of(half), widths) / (cos2 * cos2);
    d * ndf.visibility(wo, wi) * wi[2]
}

/// GGX over the footprint itself.
#[inline]
pub(super) fn parallelogram_ggx(material: &Material, quad: &Quad<'_>) -> f32 {
    let Sample { wo, wi, .. } = *quad.here;
    Ggx::new(material.shape).brdf_over(wo, wi, &quad.footprint()) * wi[2]
}
