//! A torus with a thin tube: strong curvature one way, weak of both signs the other.

use super::chart::Charted;
use super::surface::{Hit, Shape};
use crate::camera::{Ray, Size};
use crate::frame::{Comb, Turn};
use crate::scalar::Scalar;
use crate::vector::{Vector, add, along, cast, dot, scaled, sub};

/// Radius of the tube in pixels.
const TUBE: f64 = 10.0;

/// Radius of the ring over the picture's height.
const RING: f64 = 0.36;

/// Angle between the torus' axis and the view, in degrees.
const TILT: f64 = 50.0;

/// Steps after which a ray that comes no nearer has missed.
const STEPS: usize = 256;

/// A torus around the origin.
pub(crate) struct Torus<R> {
    /// Two directions in the ring's plane and its axis.
    axes: [Vector<R>; 3],
    ring: R,
    tube: R,
    comb: Comb<R>,
}

/// Distance to the surface, negative inside, and its gradient, in the torus' own frame.
struct Distance<R> {
    value: R,
    gradient: Vector<R>,
    /// Distance from the axis.
    radius: R,
}

impl Torus<f64> {
    /// The torus, its axis tilted upwards from the view along +y, and a caption; `unit` is a
    /// pixel's width.
    pub(super) fn seen_in(size: Size, unit: f64) -> (Self, String) {
        let tube = TUBE * unit;
        let ring = (RING * size.height as f64).max(1.6 * tube);
        let caption = format!(
            "A torus, its ring of {ring:.0} and its tube of {tube:.0} pixels radius, the axis \
                {TILT:.0} degrees \
             from the view, light from behind at the upper right.",
        );
        (Self::of(ring, tube), caption)
    }

    /// The same from radii of the ring and of the tube.
    pub(crate) fn of(ring: f64, tube: f64) -> Self {
        let (sin, cos) = TILT.to_radians().sin_cos();
        let axes = [[1.0, 0.0, 0.0], [0.0, sin, cos], [0.0, -cos, sin]];
        Self { axes, ring, tube, comb: Comb::around([0.0, -1.0, 0.0]) }
    }

    /// Where a ray meets it, with lengths around the tube, from its top on, and along the ring.
    pub(crate) fn charted(&self, ray: &Ray<f64>) -> Option<Charted<f64>> {
        let hit = self.hit(ray)?;
        let point = self.inward(hit.point);
        let Distance { gradient, radius, .. } = self.distance(point);
        let [x, y] = [0, 1].map(|k| point[k] / radius);
        let (sin, cos) = (x * gradient[0] + y * gradient[1], gradient[2]);
        let around = self.outward([cos * x, cos * y, -sin]);
        let along = scaled(self.ring / radius, self.outward([-y, x, 0.0]));
        Some(Charted {
            point: hit.point,
            normal: hit.geometric,
            tangent: around,
            uv: [self.tube * sin.atan2(cos), self.ring * y.atan2(x)],
            gradients: [around, along],
        })
    }

    /// The same in another precision.
    pub(super) fn cast<R: Scalar>(&self) -> Torus<R> {
        Torus {
            axes: self.axes.map(cast),
            ring: R::lit(self.ring),
            tube: R::lit(self.tube),
            comb: self.comb.cast(),
        }
    }
}

impl<R: Scalar> Torus<R> {
    /// A vector in the torus' frame.
    #[inline]
    fn inward(&self, v: Vector<R>) -> Vector<R> {
        self.axes.map(|axis| dot(axis, v))
    }

    /// And back.
    #[inline]
    fn outward(&self, v: Vector<R>) -> Vector<R> {
        let [x, y, z] = self.axes;
        along(along(scaled(v[0], x), v[1], y), v[2], z)
    }

    #[inline]
    fn distance(&self, p: Vector<R>) -> Distance<R> {
        let radius = (p[0] * p[0] + p[1] * p[1]).sqrt().max(R::MIN_POSITIVE);
        let out = radius - self.ring;
        let from_core = (out * out + p[2] * p[2]).sqrt().max(R::MIN_POSITIVE);
        let (cos, sin) = (out / from_core, p[2] / from_core);
        let gradient = [cos * p[0] / radius, cos * p[1] / radius, sin];
        Distance { value: from_core - self.tube, gradient, radius }
    }

    /// Parameter of the first hit on a ray of unit direction, in the torus' frame.
    ///
    /// Safe steps of the distance far away; within a tube's radius of the surface Newton's, at most
    /// as long as that radius. On a ray towards the outside of the tube the distance is convex, so
    /// that Newton's steps do not pass the root; where the tube curves away they may, and the next
    /// one comes back.
    #[inline]
    fn march(&self, eye: Vector<R>, direction: Vector<R>) -> Option<R> {
        let bound = self.ring + self.tube;
        let nearest = -dot(eye, direction);
        let offset = along(eye, nearest, direction);
        let inside = bound * bound - dot(offset, offset);
        if !(inside > R::ZERO) {
            return None;
        }
        let reach = inside.sqrt();
        // From the point nearest to the center: far eyes cost no digits.
        let mut t = -reach;
        let tolerance = R::lit(4.0) * R::EPSILON * bound;
        for _ in 0..STEPS {
            let distance = self.distance(along(offset, t, direction));
            if distance.value.abs() <= tolerance {
                return Some(t + nearest);
            }
            let rate = dot(distance.gradient, direction);
            let near = distance.value < self.tube && rate < R::ZERO;
            let step = if near {
                (distance.value / -rate).min(self.tube).max(-self.tube)
            } else {
                distance.value.abs()
            };
            t = t + step;
            if t > reach {
                return None;
            }
        }
        None
    }
}

impl<R: Scalar> Shape<R> for Torus<R> {
    #[inline]
    fn hit(&self, ray: &Ray<R>) -> Option<Hit<R>> {
        let length = dot(ray.direction, ray.direction).sqrt();
        let direction = scaled(R::ONE / length, ray.direction);
        let (eye, towards) = (self.inward(ray.eye), self.inward(direction));
        let point = along(eye, self.march(eye, towards)?, towards);
        let normal = self.outward(self.distance(point).gradient);
        let tangent = self.comb.tangent(0, normal);
        Some(Hit { point: self.outward(point), geometric: normal, normal, tangent, part: 0 })
    }

    /// Curvature 1/tube around the tube, and around the axis the normal's part away from it over
    /// the distance.
    #[inline]
    fn turn(&self, hit: &Hit<R>, step: Vector<R>) -> Turn<R> {
        let (point, step) = (self.inward(hit.point), self.inward(step));
        let Distance { gradient, radius, .. } = self.distance(point);
        let around = [-point[1] / radius, point[0] / radius, R::ZERO];
        let outward = (gradient[0] * point[0] + gradient[1] * point[1]) / radius;
        let part = scaled(dot(step, around), around);
        let rest = scaled(R::ONE / self.tube, sub(step, part));
        let normal = self.outward(add(rest, scaled(outward / radius, part)));
        Turn { normal, tangent: self.comb.turn(0, hit.normal, normal) }
    }
}

#[cfg(test)]
mod tests {
    use super::Torus;
    use crate::camera::Size;
    use crate::vector::along;
    use lobe::slope::direction::normalize;

    /// Rays from afar over the whole torus: every hit is on it, no ray passes through it before,
    /// and both precisions agree.
    #[test]
    fn hits_are_the_first_points_of_the_torus_on_their_rays() {
        let (torus, _) = Torus::seen_in(Size::of_width(400), 1.0);
        let single = torus.cast::<f32>();
        let (mut hits, mut disagreements) = (0, 0);
        for k in 0..4000 {
            let (x, z) = (f64::from(k % 80) * 2.6 - 104.0, f64::from(k / 80) * 4.1 - 103.0);
            let eye = [0.0, -1000.0, 0.0];
            let direction = normalize([x, 1000.0, z]);
            let (eye, direction) = (torus.inward(eye), torus.inward(direction));
            let found = torus.march(eye, direction);
            let at = |t: f64| torus.distance(along(eye, t, direction)).value;
            if let Some(t) = found {
                hits += 1;
                assert!(at(t).abs() < 1e-12);
            }
            let end = found.map_or(1150.0, |t| t - 0.01);
            let mut before =
                (0..6000).map(|n| 850.0 + 0.05 * f64::from(n)).take_while(|t| *t < end);
            assert!(before.all(|t| at(t) > 0.0), "{x} {z}");

            let (eye, direction) = (eye.map(|c| c as f32), direction.map(|c| c as f32));
            match (found, single.march(eye, direction)) {
                (Some(t), Some(s)) => {
                    // Within a hundred-thousandth of the ring, over the cosine.
                    let cos = torus.distance(along(
                        torus.inward([0.0, -1000.0, 0.0]),
                        t,
                        direction.map(f64::from),
                    ));
                    let rate: f64 = (0..3).map(|k| cos.gradient[k] * f64::from(direction[k])).sum();
                    assert!((f64::from(s) - t).abs() * rate.abs().max(0.02) < 2e-3, "{t} {s}");
                }
                (None, None) => {}
                _ => disagreements += 1,
            }
        }
        assert!(hits > 500 && disagreements < 10, "{hits} {disagreements}");
    }
}
