//! Balls of different sizes: strong curvature, highlights of a pixel and less.

use super::surface::{Hit, Shape};
use crate::camera::{Ray, Size};
use crate::frame::{Comb, Turn};
use crate::scalar::Scalar;
use crate::vector::{Vector, along, cast, dot, scaled, sub};

/// Radii in pixels, from one that shows its highlight to one that hides it.
const RADII: [f64; 8] = [60.0, 44.0, 32.0, 24.0, 18.0, 14.0, 11.0, 8.0];

/// Rounds of placing one ball of each radius: few enough to trace them all for every ray.
const ROUNDS: usize = 2;

/// Pixels between balls, and between balls and the picture's edge.
const GAP: f64 = 3.0;

/// One ball.
#[derive(Clone, Copy)]
pub(crate) struct Ball<R> {
    pub(crate) center: Vector<R>,
    pub(crate) radius: R,
}

impl Ball<f64> {
    pub(super) fn cast<R: Scalar>(&self) -> Ball<R> {
        Ball { center: cast(self.center), radius: R::lit(self.radius) }
    }
}

impl<R: Scalar> Ball<R> {
    /// Where a ray enters: its parameter and the unit normal there.
    ///
    /// From the point of the ray nearest to the center, which keeps the digits that the quadratic's
    /// coefficients lose far away.
    #[inline]
    pub(crate) fn enter(&self, ray: &Ray<R>) -> Option<(R, Vector<R>)> {
        let to = sub(self.center, ray.eye);
        let length_squared = dot(ray.direction, ray.direction);
        let nearest = dot(to, ray.direction) / length_squared;
        let offset = along(scaled(-R::ONE, to), nearest, ray.direction);
        let inside = self.radius * self.radius - dot(offset, offset);
        if !(inside > R::ZERO) {
            return None;
        }
        let back = (inside / length_squared).sqrt();
        let normal = scaled(R::ONE / self.radius, along(offset, -back, ray.direction));
        Some((nearest - back, normal))
    }
}

/// All balls, in front of nothing.
pub(super) struct Balls<R> {
    balls: Vec<Ball<R>>,
    comb: Comb<R>,
}

impl Balls<f64> {
    /// As many as fit into the picture, facing the eye along +y; `unit` is a pixel's width there.
    pub(super) fn seen_in(size: Size, unit: f64) -> (Self, String) {
        let disks = pack(size, unit);
        let radii = disks.iter().map(|disk| disk[2]);
        let largest = radii.clone().fold(0.0, f64::max);
        let smallest = radii.fold(f64::INFINITY, f64::min);
        let caption = format!(
            "{} balls, radii from {largest:.0} to {smallest:.0} pixels, light from behind at the \
                upper right.",
            disks.len(),
        );
        let balls =
            disks.into_iter().map(|[x, z, radius]| Ball { center: [x, 0.0, z], radius }).collect();
        (Self { balls, comb: Comb::around([0.0, -1.0, 0.0]) }, caption)
    }

    /// The same in another precision.
    pub(super) fn cast<R: Scalar>(&self) -> Balls<R> {
        Balls { balls: self.balls.iter().map(Ball::cast).collect(), comb: self.comb.cast() }
    }
}

/// Disks (x, z, radius) that fit into a picture around the origin, each the first place that is
/// free, from the upper left; one that fills the picture if there is no room for any.
fn pack(size: Size, unit: f64) -> Vec<[f64; 3]> {
    let [half_width, half_height] = [size.width, size.height].map(|side| 0.5 * side as f64);
    let mut disks: Vec<[f64; 3]> = Vec::new();
    for _ in 0..ROUNDS {
        for radius in RADII.map(|radius| radius * unit) {
            let reach = radius + GAP * unit;
            let steps = |half: f64| {
                let count = ((2.0 * (half - reach) / (2.0 * unit)).floor() + 1.0).max(0.0);
                (0..count as i32).map(move |k| f64::from(k) * 2.0 * unit - half + reach)
            };
            let free = |&(x, z): &(f64, f64)| {
                disks.iter().all(|d| (x - d[0]).hypot(z - d[1]) >= reach + d[2])
            };
            let place =
                steps(half_height).flat_map(|z| steps(half_width).map(move |x| (x, -z))).find(free);
            disks.extend(place.map(|(x, z)| [x, z, radius]));
        }
    }
    if disks.is_empty() {
        disks.push([0.0, 0.0, 0.9 * half_width.min(half_height)]);
    }
    disks
}

impl<R: Scalar> Shape<R> for Balls<R> {
    #[inline]
    fn hit(&self, ray: &Ray<R>) -> Option<Hit<R>> {
        let mut nearest: Option<(R, Hit<R>)> = None;
        for (part, ball) in self.balls.iter().enumerate() {
            let Some((t, normal)) = ball.enter(ray) else { continue };
            if nearest.as_ref().is_none_or(|&(before, _)| t < before) {
                let point = along(ball.center, ball.radius, normal);
                let tangent = self.comb.tangent(0, normal);
                nearest = Some((t, Hit { point, geometric: normal, normal, tangent, part }));
            }
        }
        nearest.map(|(_, hit)| hit)
    }

    #[inline]
    fn turn(&self, hit: &Hit<R>, step: Vector<R>) -> Turn<R> {
        let normal = scaled(R::ONE / self.balls[hit.part].radius, step);
        Turn { normal, tangent: self.comb.turn(0, hit.normal, normal) }
    }
}

#[cfg(test)]
mod tests {
    use super::{Ball, RADII, pack};
    use crate::camera::{Ray, Size};
    use crate::vector::{dot, sub};

    #[test]
    fn balls_lie_apart_inside_the_picture_and_every_radius_is_there() {
        let size = Size::of_width(400);
        let disks = pack(size, 1.0);
        for radius in RADII {
            assert!(disks.iter().any(|disk| disk[2] == radius), "{radius}");
        }
        for (k, a) in disks.iter().enumerate() {
            assert!(a[0].abs() + a[2] < 200.0 && a[1].abs() + a[2] < 112.5);
            for b in &disks[..k] {
                assert!((a[0] - b[0]).hypot(a[1] - b[1]) > a[2] + b[2] + 2.9);
            }
        }
        assert_eq!(pack(Size::of_width(16), 1.0).len(), 1);
    }

    #[test]
    fn rays_enter_where_they_meet_the_ball_first() {
        let ball = Ball { center: [10.0_f64, 900.0, -4.0], radius: 8.0 };
        let ray = Ray { eye: [0.0; 3], direction: [0.014, 1.0, -0.001] };
        let (t, normal) = ball.enter(&ray).unwrap();
        let point = ray.at(t);
        let from = sub(point, ball.center);
        assert!((dot(from, from).sqrt() - 8.0).abs() < 1e-9);
        assert!(dot(normal, ray.direction) < 0.0);
        assert!(sub(from, normal.map(|x| 8.0 * x)).iter().all(|x| x.abs() < 1e-9));
        assert!(ball.enter(&Ray { direction: [0.03, 1.0, 0.0], ..ray }).is_none());
    }
}
