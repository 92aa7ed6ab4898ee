//! The anisotropic normal map of the ball: moments of its slopes, laid on askew.

use lobe::material::cells::Patch;
use lobe::material::lean::{Border, MomentMap, SlopeCap};
use lobe::{Error, SlopeMoments};

use crate::minify::STEEPEST;
use crate::texture::Texture;

/// Degrees between the map's axes and the surface's: along its own axes fibers have no correlation.
pub(crate) const ASKEW: f64 = 40.0;

/// Probes along the longer side of a pixel, at most.
const PROBES: usize = 8;

/// A map on lengths.
pub(super) struct Fibers {
    moments: MomentMap<f64>,
    /// Texture coordinates per length, and the turn: cosine and sine.
    scale: f64,
    turn: [f64; 2],
}

impl Fibers {
    /// A map with this many texels per unit of length.
    pub(super) fn of(texture: &Texture, texels: f64) -> Result<Self, Error> {
        let (sin, cos) = ASKEW.to_radians().sin_cos();
        let cap = SlopeCap::new(f64::from(STEEPEST))?;
        let slopes = texture.normals().iter().map(|&normal| {
            let ([x, y], _) = cap.slope(normal);
            // Slopes turn with the map.
            [cos * x - sin * y, sin * x + cos * y]
        });
        let size = texture.size();
        let moments = MomentMap::from_slopes(size, slopes.collect(), Border::Wrap)?;
        Ok(Self { moments, scale: texels / size[0] as f64, turn: [cos, sin] })
    }

    /// Coordinates in the map, whose rows count down.
    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [cos, sin] = self.turn;
        [self.scale * (cos * x + sin * y), self.scale * (sin * x - cos * y)]
    }

    /// The map's own slope at a point.
    pub(super) fn slope(&self, uv: [f64; 2]) -> [f64; 2] {
        self.moments.bilinear(0, self.place(uv)).mean()
    }

    /// Moments of the slopes under a pixel.
    pub(super) fn moments(&self, patch: &Patch<f64>) -> SlopeMoments<f64> {
        let [right, up] = [patch.right, patch.up].map(|step| self.place(step));
        self.moments.anisotropic(self.place(patch.uv), right, up, PROBES)
    }
}
