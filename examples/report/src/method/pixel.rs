//! A pixel as a filter sees it: its sample, and derivatives from a quad or from motions.

use lobe::filter::{ShadingFrame, quad_normal_footprint};
use lobe::slope::Motion;
use lobe::{Footprint, Real};
use serde::Serialize;

use crate::scene::{Motions, Sample};

/// Where a filter's footprint comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Derivatives {
    /// Nowhere: plain supersampling.
    None,
    /// Differences within two by two pixels, as a GPU takes them.
    Quad,
    /// Ray differentials and the surface's own derivatives at the pixel's center.
    Analytic,
}

/// What a shading function may ask of a pixel.
pub(crate) trait Pixel<R: Real> {
    /// At the pixel's center.
    fn sample(&self) -> &Sample<R>;

    /// The pixel's footprint on the slope plane; none where a half vector is below the horizon.
    fn footprint(&self) -> Footprint<R>;

    /// The same from derivatives on the projected disk, taken as slopes.
    fn narrowed_footprint(&self) -> Footprint<R>;

    /// Changes of the shading normal, in any frame.
    fn normal_steps(&self) -> [[R; 3]; 2];

    /// The footprint of a half vector that stands still at the normal: all that is known before the
    /// light is.
    fn normal_footprint(&self) -> Footprint<R>;
}

/// A pixel and the others of its quad. Those that share its row and column are what `ddx_fine` and
/// `ddy_fine` subtract, up to the sign, which no filter asks for.
pub(crate) struct QuadPixel<'a, R> {
    pub(crate) here: &'a Sample<R>,
    pub(crate) beside: &'a Sample<R>,
    pub(crate) below: &'a Sample<R>,
    pub(crate) across: &'a Sample<R>,
}

/// The axes of a sample's frame in the world.
#[inline]
fn frame<R: Real>(sample: &Sample<R>) -> ShadingFrame<R> {
    let ([a, b, c], [x, y, z]) = (sample.normal, sample.tangent);
    [sample.tangent, [b * z - c * y, c * x - a * z, a * y - b * x], sample.normal]
}

impl<R: Real> Pixel<R> for QuadPixel<'_, R> {
    #[inline]
    fn sample(&self) -> &Sample<R> {
        self.here
    }

    #[inline]
    fn footprint(&self) -> Footprint<R> {
        Footprint::from_half_vectors(self.here.half, self.beside.half, self.below.half)
            .unwrap_or_default()
    }

    #[inline]
    fn narrowed_footprint(&self) -> Footprint<R> {
        let [x, y, _] = self.here.half;
        let to = |other: &Sample<R>| [other.half[0] - x, other.half[1] - y];
        Footprint::from_disk_narrowed(to(self.beside), to(self.below))
    }

    #[inline]
    fn normal_steps(&self) -> [[R; 3]; 2] {
        let here = self.here.normal;
        [self.beside, self.below].map(|other| [0, 1, 2].map(|k| other.normal[k] - here[k]))
    }

    #[inline]
    fn normal_footprint(&self) -> Footprint<R> {
        let quad = [self.here, self.beside, self.below, self.across].map(frame);
        quad_normal_footprint(&quad).unwrap_or_default()
    }
}

/// A pixel with its motions.
pub(crate) struct MovingPixel<'a, R> {
    pub(crate) here: &'a Sample<R>,
    pub(crate) motions: &'a Motions<R>,
}

impl<R: Real> MovingPixel<'_, R> {
    /// $w_o + w_i$, what [`Motions`] hold the change of.
    #[inline]
    fn sum(&self) -> [R; 3] {
        let Sample { wo, wi, .. } = self.here;
        [wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]]
    }
}

impl<R: Real> Pixel<R> for MovingPixel<'_, R> {
    #[inline]
    fn sample(&self) -> &Sample<R> {
        self.here
    }

    #[inline]
    fn footprint(&self) -> Footprint<R> {
        let [across, down] = self.motions;
        Footprint::from_motion(self.sum(), across, down).unwrap_or_default()
    }

    /// In a frame that turns with the surface, $g = w_o + w_i$ changes by its own motion and
    /// against the frame's; $dh = (dg - h (h \cdot dg))/|g|$.
    #[inline]
    fn narrowed_footprint(&self) -> Footprint<R> {
        let (g, h) = (self.sum(), self.here.half);
        let length = g[0] * h[0] + g[1] * h[1] + g[2] * h[2];
        let [u, v] = self.motions.map(|motion| {
            let (n, spin) = (motion.normal, motion.spin);
            let dg = [
                motion.half_vector[0] - n[0] * g[2] + spin * g[1],
                motion.half_vector[1] - n[1] * g[2] - spin * g[0],
                motion.half_vector[2] + n[0] * g[0] + n[1] * g[1],
            ];
            let along = h[0] * dg[0] + h[1] * dg[1] + h[2] * dg[2];
            [(dg[0] - h[0] * along) / length, (dg[1] - h[1] * along) / length]
        });
        Footprint::from_disk_narrowed(u, v)
    }

    #[inline]
    fn normal_steps(&self) -> [[R; 3]; 2] {
        self.motions.map(|motion| [motion.normal[0], motion.normal[1], R::ZERO])
    }

    #[inline]
    fn normal_footprint(&self) -> Footprint<R> {
        let [u, v] = self.motions.map(|motion| Motion { half_vector: [R::ZERO; 3], ..motion });
        Footprint::from_motion([R::ZERO, R::ZERO, R::ONE], &u, &v).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::{MovingPixel, Pixel};
    use crate::scene::Sample;
    use lobe::Footprint;
    use lobe::slope::Motion;
    use lobe::slope::direction::{half_vector, normalize};

    #[test]
    fn derivatives_on_the_disk_are_those_on_the_slope_plane() {
        let wo = normalize([0.5_f64, 0.2, 0.6]);
        let wi = normalize([-0.1, 0.7, 0.5]);
        let here = Sample { wo, wi, half: half_vector(wo, wi), ..Sample::default() };
        let motions = [
            Motion { half_vector: [0.02, -0.01, 0.03], normal: [0.05, -0.02], spin: 0.07 },
            Motion { half_vector: [-0.01, 0.04, 0.01], normal: [0.01, 0.03], spin: -0.02 },
        ];
        let pixel = MovingPixel { here: &here, motions: &motions };
        let disk = pixel.narrowed_footprint();
        let carried = Footprint::from_disk(here.half, disk.u, disk.v);
        let direct = pixel.footprint();
        for (a, b) in [(carried.u, direct.u), (carried.v, direct.v)] {
            assert!((a[0] - b[0]).abs() < 1e-14 && (a[1] - b[1]).abs() < 1e-14, "{a:?} {b:?}");
        }
    }
}
