//! A brushed disk: roughness along and across concentric grooves that are not quite round.

use lobe::slope::direction::normal_of;

use super::surface::{Hit, Shape, plane_point, slope_turn, world_z};
use crate::camera::{Ray, Size};
use crate::frame::Turn;
use crate::scalar::Scalar;
use crate::vector::Vector;

/// Roughness across the grooves over roughness along them.
pub(crate) const ACROSS: f64 = 5.0;

/// Radius of the disk over the picture's width, and of its hub in pixels.
const RIM: f64 = 0.42;
const HUB: f64 = 12.0;

/// Distance of the grooves in pixels, and their steepest slope.
const GROOVE: f64 = 7.0;
const STEEPNESS: f64 = 0.08;

/// What bends the grooves: sines of the point, their lengths in pixels, headings in degrees, and
/// how much the grooves' phase follows them, as a slope.
const WOBBLES: [[f64; 3]; 2] = [[61.0, 20.0, 0.14], [43.0, 131.0, 0.1]];

/// One sine that bends the grooves.
#[derive(Clone, Copy)]
struct Wobble<R> {
    k: [R; 2],
    /// Its slope at its steepest, along k.
    slope: [R; 2],
}

/// Height $\frac{a}{k} \sin(k (r + w(p)))$ over the plane, as a slope; the disk itself is flat.
pub(super) struct Disk<R> {
    rim: R,
    hub: R,
    /// Phase per length.
    k: R,
    steepness: R,
    wobbles: [Wobble<R>; WOBBLES.len()],
}

impl Disk<f64> {
    /// The disk around the origin, and a caption; `unit` is a pixel's width there.
    pub(super) fn seen_in(size: Size, unit: f64, elevation: f64) -> (Self, String) {
        let rim = RIM * size.width as f64;
        let hub = (HUB * unit).min(0.25 * rim);
        let tau = core::f64::consts::TAU;
        let wobbles = WOBBLES.map(|[length, heading, slope]| {
            let (sin, cos) = heading.to_radians().sin_cos();
            let k = tau / (length * unit);
            Wobble { k: [k * cos, k * sin], slope: [slope * cos, slope * sin] }
        });
        let caption = format!(
            "A brushed disk seen {elevation:.0} degrees above its plane, roughness alpha along \
                its grooves and \
             {ACROSS:.0} alpha across, a groove every {GROOVE:.0} pixels and not quite round; \
             light ahead at \
             {elevation:.0} degrees.",
        );
        let k = tau / (GROOVE * unit);
        (Self { rim, hub, k, steepness: STEEPNESS, wobbles }, caption)
    }

    /// The same in another precision.
    pub(super) fn cast<R: Scalar>(&self) -> Disk<R> {
        let pair = |v: [f64; 2]| v.map(R::lit);
        Disk {
            rim: R::lit(self.rim),
            hub: R::lit(self.hub),
            k: R::lit(self.k),
            steepness: R::lit(self.steepness),
            wobbles: self.wobbles.map(|w| Wobble { k: pair(w.k), slope: pair(w.slope) }),
        }
    }
}

/// The grooves at a point: phase, its gradient over k, and the point's distance from the center.
struct Grooves<R> {
    phase: R,
    gradient: [R; 2],
    radius: R,
}

impl<R: Scalar> Disk<R> {
    #[inline]
    fn grooves(&self, x: R, y: R, radius: R) -> Grooves<R> {
        let mut length = radius;
        let mut gradient = [x / radius, y / radius];
        for wobble in &self.wobbles {
            let [kx, ky] = wobble.k;
            let phase = kx * x + ky * y;
            // slope = height times k.
            let height = (wobble.slope[0] * kx + wobble.slope[1] * ky) / (kx * kx + ky * ky);
            length = length + height * phase.sin();
            let cos = phase.cos();
            gradient = [gradient[0] + wobble.slope[0] * cos, gradient[1] + wobble.slope[1] * cos];
        }
        Grooves { phase: self.k * length, gradient, radius }
    }

    #[inline]
    fn slope(&self, grooves: &Grooves<R>) -> [R; 2] {
        let cos = self.steepness * grooves.phase.cos();
        grooves.gradient.map(|g| cos * g)
    }

    /// Change of the slope along a step.
    #[inline]
    fn slope_change(&self, x: R, y: R, step: [R; 2], grooves: &Grooves<R>) -> [R; 2] {
        let radius = grooves.radius;
        let around = (x * step[1] - y * step[0]) / (radius * radius * radius);
        let mut bend = [-y * around, x * around];
        for wobble in &self.wobbles {
            let [kx, ky] = wobble.k;
            let change = -(kx * x + ky * y).sin() * (kx * step[0] + ky * step[1]);
            bend = [bend[0] + wobble.slope[0] * change, bend[1] + wobble.slope[1] * change];
        }
        let along = grooves.gradient[0] * step[0] + grooves.gradient[1] * step[1];
        let (sin, cos) = (grooves.phase.sin(), grooves.phase.cos());
        [0, 1].map(|axis| {
            self.steepness * (cos * bend[axis] - sin * self.k * along * grooves.gradient[axis])
        })
    }
}

impl<R: Scalar> Shape<R> for Disk<R> {
    #[inline]
    fn hit(&self, ray: &Ray<R>) -> Option<Hit<R>> {
        let point = plane_point(ray)?;
        let [x, y, _] = point;
        let radius = (x * x + y * y).sqrt();
        if !(radius >= self.hub && radius <= self.rim) {
            return None;
        }
        let normal = normal_of(self.slope(&self.grooves(x, y, radius)));
        let tangent = [-y / radius, x / radius, R::ZERO];
        Some(Hit { point, geometric: world_z(), normal, tangent, part: 0 })
    }

    #[inline]
    fn turn(&self, hit: &Hit<R>, step: Vector<R>) -> Turn<R> {
        let [x, y, _] = hit.point;
        let radius = (x * x + y * y).sqrt();
        let grooves = self.grooves(x, y, radius);
        let change = self.slope_change(x, y, [step[0], step[1]], &grooves);
        // The tangent turns by the angle around the center, towards it.
        let angle = (x * step[1] - y * step[0]) / (radius * radius);
        let tangent = [-x * angle / radius, -y * angle / radius, R::ZERO];
        Turn { normal: slope_turn(hit.normal, change), tangent }
    }
}
