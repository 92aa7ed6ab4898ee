//! Wavy water: a sum of sines whose slopes are known exactly.

use lobe::slope::direction::normal_of;

use super::subject::View;
use super::surface::{Hit, Shape, plane_point, slope_turn, world_x, world_z};
use crate::camera::{Camera, Ray, Size};
use crate::frame::Turn;
use crate::scalar::Scalar;
use crate::vector::Vector;

/// Grazing, with the light's mirror image inside: its glitter path runs down the picture.
pub(super) const VIEW: View = View { top: 14.0, bottom: 30.0, light: 20.0 };

/// Pixels per shortest wave where the view is most grazing.
const FARTHEST_WAVE: f64 = 12.0;

/// Wavelength in units of the shortest, heading in degrees from +x, steepest slope, phase.
///
/// Slopes of 0.143 in the root mean square, what Cox & Munk 1954 measured under a wind of 3.4 m/s:
/// many times the lobe's width at alpha = 0.01, so that glints stand apart, and hardly ever steep
/// enough to face away from the eye.
const WAVES: [[f64; 4]; 7] = [
    [4.3, 74.0, 0.078, 0.3],
    [3.1, 118.0, 0.087, 1.9],
    [2.2, 37.0, 0.078, 4.1],
    [1.7, 95.0, 0.087, 2.2],
    [1.35, 151.0, 0.070, 5.3],
    [1.12, 62.0, 0.070, 0.9],
    [1.0, 128.0, 0.061, 3.6],
];

/// One wave, $\frac{a}{|k|} \sin(k \cdot p + \varphi)$ high and at most `a` steep.
#[derive(Clone, Copy)]
struct Wave<R> {
    k: [R; 2],
    phase: R,
    /// Slope at the crest's flank, along k.
    slope: [R; 2],
}

/// The sum of all waves.
pub(super) struct Waves<R>([Wave<R>; WAVES.len()]);

impl Waves<f64> {
    /// Waves whose shortest spans [`FARTHEST_WAVE`] pixels along the view at the top of the
    /// picture, and a caption. The picture's size decides how many waves it shows, never how many
    /// pixels a wave has: errors at different sizes compare.
    pub(super) fn seen_by(camera: &Camera<f64>, size: Size) -> (Self, String) {
        let middle = 0.5 * size.width as f64;
        let [_, top] = camera.steps(middle, 0.5);
        let [_, bottom] = camera.steps(middle, size.height as f64 - 0.5);
        let shortest = FARTHEST_WAVE * top;
        let caption = format!(
            "Seven sine waves on a plane, view {} to {} degrees above it, light {} degrees high \
             ahead; the shortest wave spans {FARTHEST_WAVE:.0} pixels along the view at the top \
             and \
             {:.0} at the bottom.",
            VIEW.top,
            VIEW.bottom,
            VIEW.light,
            shortest / bottom,
        );
        let waves = WAVES.map(|[length, heading, steepness, phase]| {
            let (sin, cos) = heading.to_radians().sin_cos();
            let k = core::f64::consts::TAU / (length * shortest);
            Wave { k: [k * cos, k * sin], phase, slope: [steepness * cos, steepness * sin] }
        });
        (Self(waves), caption)
    }

    /// The same in another precision.
    pub(super) fn cast<R: Scalar>(&self) -> Waves<R> {
        let cast = |v: [f64; 2]| v.map(R::lit);
        Waves(self.0.map(|w| Wave { k: cast(w.k), phase: R::lit(w.phase), slope: cast(w.slope) }))
    }

    /// What the slopes are the derivatives of.
    #[cfg(test)]
    fn height(&self, p: [f64; 2]) -> f64 {
        let height = |w: &Wave<f64>| {
            let [k, slope] = [w.k, w.slope].map(|v| v[0].hypot(v[1]));
            slope / k * (w.k[0] * p[0] + w.k[1] * p[1] + w.phase).sin()
        };
        self.0.iter().map(height).sum()
    }
}

impl<R: Scalar> Waves<R> {
    /// Slope of the surface, its height's gradient.
    #[inline]
    fn slope(&self, p: [R; 2]) -> [R; 2] {
        let mut sum = [R::ZERO; 2];
        for wave in &self.0 {
            let cos = (wave.k[0] * p[0] + wave.k[1] * p[1] + wave.phase).cos();
            sum = [sum[0] + wave.slope[0] * cos, sum[1] + wave.slope[1] * cos];
        }
        sum
    }

    /// Change of the slope along a step: the height's Hessian times it.
    #[inline]
    fn slope_change(&self, p: [R; 2], step: [R; 2]) -> [R; 2] {
        let mut sum = [R::ZERO; 2];
        for wave in &self.0 {
            let sin = (wave.k[0] * p[0] + wave.k[1] * p[1] + wave.phase).sin();
            let change = -sin * (wave.k[0] * step[0] + wave.k[1] * step[1]);
            sum = [sum[0] + wave.slope[0] * change, sum[1] + wave.slope[1] * change];
        }
        sum
    }
}

impl<R: Scalar> Shape<R> for Waves<R> {
    #[inline]
    fn hit(&self, ray: &Ray<R>) -> Option<Hit<R>> {
        let point = plane_point(ray)?;
        let normal = normal_of(self.slope([point[0], point[1]]));
        Some(Hit { point, geometric: world_z(), normal, tangent: world_x(), part: 0 })
    }

    #[inline]
    fn turn(&self, hit: &Hit<R>, step: Vector<R>) -> Turn<R> {
        let change = self.slope_change([hit.point[0], hit.point[1]], [step[0], step[1]]);
        Turn { normal: slope_turn(hit.normal, change), tangent: [R::ZERO; 3] }
    }
}

#[cfg(test)]
mod tests {
    use super::{VIEW, Waves};
    use crate::camera::{Camera, Size};

    #[test]
    fn slopes_are_the_differences_of_the_height() {
        let size = Size::of_width(64);
        let (waves, _) = Waves::seen_by(&Camera::spanning(size, VIEW.top, VIEW.bottom), size);
        let step = 1e-5;
        for k in 0..50 {
            let p = [0.37 * f64::from(k) - 9.0, 0.21 * f64::from(k)];
            let slope = waves.slope(p);
            for axis in 0..2 {
                let at = |offset: f64| {
                    let mut q = p;
                    q[axis] += offset;
                    waves.height(q)
                };
                let difference = (at(step) - at(-step)) / (2.0 * step);
                // Third derivatives are below 0.6 (2 pi / 0.5)^2: the step error is below 1e-8.
                assert!((slope[axis] - difference).abs() < 1e-7);
            }
            let single = waves.cast::<f32>().slope(p.map(|x| x as f32));
            assert!((f64::from(single[0]) - slope[0]).abs() < 1e-5);
        }
    }
}
