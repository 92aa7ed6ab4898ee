//! A map made ready: its slopes, their moments, and the mean normals that plain mips hold.

use lobe::Error;
use lobe::material::lean::{Border, ClippedTexels, MomentMap, SlopeCap};
use lobe::slope::direction::normal_of;

use crate::level::{Chain, Level};
use crate::texture::Texture;

/// The steepest slope, 84 degrees: maps of 8 bits hold nothing between it and the horizon but
/// rounding.
pub(crate) const STEEPEST: f32 = 10.0;

/// A map's slopes, none steeper than [`STEEPEST`], and how many were.
fn slopes(texture: &Texture) -> Result<(Vec<[f32; 2]>, ClippedTexels), Error> {
    let cap = SlopeCap::new(STEEPEST)?;
    let mut clipped = ClippedTexels { texels: 0, of: texture.normals().len() };
    let slopes = texture.normals().iter().map(|&normal| {
        let (slope, steeper) = cap.slope(normal);
        clipped.texels += usize::from(steeper);
        slope
    });
    Ok((slopes.collect(), clipped))
}

/// A map's chain of moments, and how many of its texels were steeper than [`STEEPEST`].
pub(crate) fn moments(texture: &Texture) -> Result<(MomentMap<f32>, ClippedTexels), Error> {
    let (slopes, clipped) = slopes(texture)?;
    Ok((MomentMap::from_slopes(texture.size(), slopes, Border::Wrap)?, clipped))
}

/// What the methods look up. All of it is made of the same slopes.
pub(super) struct Texels {
    /// The finest level.
    pub(super) slopes: Level<2>,
    /// Means of unit normals.
    pub(super) normals: Chain<3>,
    pub(super) moments: MomentMap<f32>,
    /// Means of the slopes and of their squared lengths: CLEAN's textures.
    pub(super) clean: Chain<3>,
    /// Means of the slopes and of their products: LEAN's.
    pub(super) raw: Chain<5>,
    /// The part of the texels that were steeper than [`STEEPEST`].
    pub(super) clipped: f64,
}

impl Texels {
    pub(super) fn of(texture: &Texture) -> Result<Self, Error> {
        let (slopes, clipped) = slopes(texture)?;
        Ok(Self { clipped: clipped.fraction(), ..Self::of_slopes(texture.size(), slopes)? })
    }

    pub(super) fn of_slopes(size: [usize; 2], slopes: Vec<[f32; 2]>) -> Result<Self, Error> {
        fn chain<const N: usize>(
            size: [usize; 2],
            slopes: &[[f32; 2]],
            of: impl Fn([f32; 2]) -> [f32; N],
        ) -> Chain<N> {
            Chain::of(Level::new(size, slopes.iter().map(|&slope| of(slope)).collect()))
        }
        Ok(Self {
            normals: chain(size, &slopes, normal_of),
            clean: chain(size, &slopes, |[x, y]| [x, y, x * x + y * y]),
            raw: chain(size, &slopes, |[x, y]| [x, y, x * x, x * y, y * y]),
            moments: MomentMap::from_slopes(size, slopes.clone(), Border::Wrap)?,
            slopes: Level::new(size, slopes),
            clipped: 0.0,
        })
    }

    /// The squared length of a step, in texels.
    #[inline]
    pub(super) fn squared(&self, step: [f32; 2]) -> f32 {
        let [width, height] = self.slopes.size().map(|side| side as f32);
        (step[0] * width).powi(2) + (step[1] * height).powi(2)
    }

    /// The level at which a pixel's longer side is a texel wide: what GPUs take without anisotropy.
    #[inline]
    pub(super) fn lod(&self, du: [f32; 2], dv: [f32; 2]) -> f32 {
        0.5 * self.squared(du).max(self.squared(dv)).log2()
    }

    /// Standard deviation of the slopes, both axes together, and their kurtosis: fourth moments
    /// over squared second ones, each a sum over the axes; 3 of a Gaussian.
    pub(super) fn spread(&self) -> [f64; 2] {
        let texels = self.slopes.texels();
        let count = texels.len() as f64;
        let [x, y] = [0, 1].map(|axis| {
            let values = texels.iter().map(|slope| f64::from(slope[axis]));
            let mean = values.clone().sum::<f64>() / count;
            [2, 4].map(|n| values.clone().map(|s| (s - mean).powi(n)).sum::<f64>() / count)
        });
        [(x[0] + y[0]).sqrt(), (x[1] + y[1]) / (x[0] * x[0] + y[0] * y[0])]
    }
}
