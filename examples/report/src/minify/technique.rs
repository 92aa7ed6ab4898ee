//! What each method looks up in a map for a pixel, and the light it makes of that: those of one
//! number or none.

use lobe::filter::{clean_variance, toksvig_variance};
use lobe::slope::direction::slope_of;
use lobe::{Distribution, Error, LobeShape, Ndf, NonCentered};

use super::ground::Ground;
use super::view::Spot;

/// A way to shade a place of the picture.
pub(super) trait Technique {
    /// Per pixel.
    const SAMPLES: u32 = 1;

    /// BRDF times cosine and light. No error for the slopes of a map, which are below its cap.
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error>;
}

/// Of one lobe.
#[inline]
pub(super) fn lit<D: Distribution, S: LobeShape<Scalar = f32>>(
    shape: NonCentered<S>,
    spot: &Spot<f32>,
) -> f32 {
    let cosine = shape.mean_area(spot.wi).max(0.0);
    Ndf::<D, _>::new(shape).brdf(spot.wo, spot.wi) * cosine * spot.strength
}

/// The nearest texel of the finest level.
pub(super) struct Point;

impl Technique for Point {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        Ok(lit::<D, _>(ground.bare(ground.texels.slopes.nearest(spot.uv))?, spot))
    }
}

/// Many samples of what the reference has more of.
pub(super) struct Supersampling<const COUNT: u32>;

impl<const COUNT: u32> Technique for Supersampling<COUNT> {
    const SAMPLES: u32 = COUNT;

    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        Ok(lit::<D, _>(ground.bare(ground.texels.slopes.bilinear(spot.uv))?, spot))
    }
}

/// The mean normal, as if it were the only one.
pub(super) struct Mips;

impl Technique for Mips {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        // A slope is a quotient: there is no length to bring to one.
        Ok(lit::<D, _>(
            ground.bare(slope_of(ground.mean_normal(spot, &ground.view.steps(spot))))?,
            spot,
        ))
    }
}

/// The mean normal, and roughness from its length.
pub(super) struct Toksvig;

impl Technique for Toksvig {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        let normal = ground.mean_normal(spot, &ground.view.steps(spot));
        let squared = normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2];
        Ok(lit::<D, _>(ground.rougher(slope_of(normal), toksvig_variance(squared.sqrt())?)?, spot))
    }
}

/// The mean slope, and one variance for both axes.
pub(super) struct Clean;

impl Technique for Clean {
    #[inline]
    fn radiance<D: Distribution>(ground: &Ground<'_>, spot: &Spot<f32>) -> Result<f32, Error> {
        let steps = ground.view.steps(spot);
        let lod = ground.texels.lod(steps.du, steps.dv);
        let [x, y, second] = ground.texels.clean.trilinear(spot.uv, lod);
        let shape = ground.rougher([x, y], clean_variance([x, y], second)?)?;
        Ok(lit::<D, _>(shape, spot))
    }
}
