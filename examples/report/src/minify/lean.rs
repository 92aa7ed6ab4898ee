//! LEAN: mean slope and covariance, from several lookups, with and without kernels.

use lobe::slope::direction::{half_vector, slope_of};
use lobe::{Distribution, Error, Lobe, LobeShape, Ndf, Roughness, SlopeMoments};

use super::ground::Ground;
use super::technique::{Technique, lit};
use super::view::{Spot, Steps};

/// The mean slope and the covariance.
pub(super) struct Lean;

impl Technique for Lean {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        let moments = ground.trilinear(spot.uv, &ground.view.steps(spot));
        Ok(lit::<D, _>(ground.lean(&moments).shape(), spot))
    }
}

/// The mean slope and the covariance from the textures of Olano & Baker (2010): raw moments, each
/// interpolated as a number of its own.
pub(super) struct LeanRaw;

impl Technique for LeanRaw {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        let steps = ground.view.steps(spot);
        let lod = ground.texels.lod(steps.du, steps.dv);
        let [x, y, xx, xy, yy] = ground.texels.raw.trilinear(spot.uv, lod);
        let moments = SlopeMoments::from_raw([x, y], [xx, xy, yy])?;
        Ok(lit::<D, _>(ground.lean(&moments).shape(), spot))
    }
}

/// The same, and how the half vector moves over the pixel.
pub(super) struct LeanKernel;

impl Technique for LeanKernel {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        let steps = ground.view.steps(spot);
        let kernel = ground.kernel(spot, &steps);
        let moments = ground.trilinear(spot.uv, &steps);
        Ok(lit::<D, _>(ground.lean(&moments).widened(&kernel).shape(), spot))
    }
}

/// The mean slope, and how the half vector moves in its frame: specular antialiasing on top of
/// plain mips.
pub(super) struct Shaded;

impl Technique for Shaded {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        let steps = ground.view.steps(spot);
        let moments = ground.trilinear(spot.uv, &steps);
        let kernel = ground.shading_kernel(spot, &steps, moments.mean());
        Ok(lit::<D, _>(Lobe::new(moments.mean(), ground.base.widened(&kernel))?.shape(), spot))
    }
}

/// Covariance and that kernel: what the mean slopes of neighboring pixels differ by counts twice.
pub(super) struct LeanTwice;

impl Technique for LeanTwice {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        let steps = ground.view.steps(spot);
        let moments = ground.trilinear(spot.uv, &steps);
        let kernel = ground.shading_kernel(spot, &steps, moments.mean());
        Ok(lit::<D, _>(ground.lean(&moments).widened(&kernel).shape(), spot))
    }
}

/// The mean slope and the covariance of what lies under the pixel, however long it is.
pub(super) struct LeanAlong;

impl Technique for LeanAlong {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        let moments = ground.anisotropic(spot, &ground.view.steps(spot))?;
        Ok(lit::<D, _>(ground.lean(&moments).shape(), spot))
    }
}

/// The same with lookups whose own width is taken off the pixel's.
pub(super) struct LeanNarrow;

impl Technique for LeanNarrow {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        let moments = ground.narrow(spot, &ground.view.steps(spot));
        Ok(lit::<D, _>(ground.lean(&moments).shape(), spot))
    }
}

/// The moments of the pixel's own slopes, which no chain of mips has: what is left is the error of
/// one lobe.
pub(super) struct LeanExact;

/// Slopes along either side of the pixel.
pub(crate) const EXACT: u8 = 16;

impl Technique for LeanExact {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        let Steps { du, dv, .. } = ground.view.steps(spot);
        let offsets = (0..EXACT).map(|k| (f32::from(k) + 0.5) / f32::from(EXACT) - 0.5);
        let (mut mean, mut second) = ([0.0; 2], [0.0; 3]);
        // About the slope in the middle, so that little cancels.
        let middle = ground.texels.slopes.bilinear(spot.uv);
        for (right, below) in offsets.clone().flat_map(|r| offsets.clone().map(move |b| (r, b))) {
            let uv = [0, 1].map(|k| spot.uv[k] + right * du[k] + below * dv[k]);
            let slope = ground.texels.slopes.bilinear(uv);
            let [x, y] = [slope[0] - middle[0], slope[1] - middle[1]];
            mean = [mean[0] + x, mean[1] + y];
            second = [second[0] + x * x, second[1] + x * y, second[2] + y * y];
        }
        let weight = 1.0 / (f32::from(EXACT) * f32::from(EXACT));
        let moments = SlopeMoments::from_raw(mean.map(|m| weight * m), second.map(|m| weight * m))?;
        Ok(lit::<D, _>(ground.lean(&moments.tilted(middle)?).shape(), spot))
    }
}

/// The density of those narrow lookups, over the visibility of the base on the slopes that reflect:
/// a map's facets do not shadow each other, whatever the wide lobe's masking says.
pub(super) struct LeanUnmasked;

impl Technique for LeanUnmasked {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        let moments = ground.narrow(spot, &ground.view.steps(spot));
        let lobe = ground.lean(&moments);
        let half = half_vector(spot.wo, spot.wi);
        let facet = reflecting(&moments, lobe.roughness(), slope_of(half));
        let base = ground.bare(facet)?;
        let cosine = base.mean_area(spot.wi).max(0.0);
        let visibility = Ndf::<D, _>::new(base).visibility(spot.wo, spot.wi);
        Ok(Ndf::<D, _>::new(lobe.shape()).d(half) * visibility * cosine * spot.strength)
    }
}

/// The mean slope of those texels whose base lobe reflects towards the eye, all Gaussian:
/// $\mu + 2\Sigma A^{-1} (s_h - \mu)$ with A of both together.
#[inline]
fn reflecting(moments: &SlopeMoments<f32>, both: Roughness<f32>, half: [f32; 2]) -> [f32; 2] {
    let mean = moments.mean();
    let [x, y] = [half[0] - mean[0], half[1] - mean[1]];
    let ([xx, xy, yy], det) = (both.matrix().entries(), both.matrix().det());
    let [p, q] = [(yy * x - xy * y) / det, (xx * y - xy * x) / det];
    let [xx, xy, yy] = moments.covariance().entries();
    [mean[0] + 2.0 * (xx * p + xy * q), mean[1] + 2.0 * (xy * p + yy * q)]
}
