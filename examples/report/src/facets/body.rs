//! What is seen: a bent tube, a ball, or many small ones.

use crate::camera::Ray;
use crate::frame::Comb;
use crate::scene::{Ball, Charted, Lambert, Torus};
use crate::vector::{Vector, add, dot, scaled, sub};

/// A surface with lengths along it as texture coordinates; the unit is a pixel.
pub(super) enum Body {
    Tube(Torus<f64>),
    Ball(Ball<f64>, Lambert<f64>),
    /// In rows and columns at this distance, around a ball at the origin.
    Beads(Ball<f64>, Lambert<f64>, f64),
}

/// Towards the eye.
const FRONT: Vector<f64> = [0.0, -1.0, 0.0];

impl Body {
    /// A tube, bent to a ring.
    pub(super) fn tube(ring: f64, radius: f64) -> Self {
        Self::Tube(Torus::of(ring, radius))
    }

    /// A ball around the origin.
    pub(super) fn ball(radius: f64) -> Self {
        let (ball, chart) = charted(radius);
        Self::Ball(ball, chart)
    }

    /// Balls of this radius, each with a part of the texture of its own, and a fifth of their width
    /// between them.
    pub(super) fn beads(radius: f64) -> Self {
        let (ball, chart) = charted(radius);
        Self::Beads(ball, chart, 2.4 * radius)
    }

    /// Where a ray meets it.
    pub(super) fn hit(&self, ray: &Ray<f64>) -> Option<Charted<f64>> {
        match self {
            Self::Tube(torus) => torus.charted(ray),
            Self::Ball(ball, chart) => met(ball, chart, ray),
            Self::Beads(ball, chart, pitch) => {
                // Near enough to parallel: rays cross the middle plane beside the ball that they
                // meet.
                let [x, _, z] = ray.at(-ray.eye[1] / ray.direction[1]);
                let place = [x, z].map(|x| (x / pitch).round());
                let center = [pitch * place[0], 0.0, pitch * place[1]];
                let mut hit = met(&Ball { center, ..*ball }, chart, ray)?;
                hit.uv = [0, 1].map(|k| hit.uv[k] + APART * pitch * place[k]);
                Some(hit)
            }
        }
    }
}

/// Distance of beads on the texture over that in space: charts of a front reach to sqrt(2) radii,
/// so no two share facets.
const APART: f64 = 1.37;

/// A ball around the origin, and lengths on it.
fn charted(radius: f64) -> (Ball<f64>, Lambert<f64>) {
    (Ball { center: [0.0; 3], radius }, Lambert { comb: Comb::around(FRONT), density: radius })
}

/// Where a ray meets a ball.
fn met(ball: &Ball<f64>, chart: &Lambert<f64>, ray: &Ray<f64>) -> Option<Charted<f64>> {
    let (distance, normal) = ball.enter(ray)?;
    let axes = [0, 1].map(|side| chart.comb.tangent(side, normal));
    // A gradient by the coordinate's change along both tangents.
    let [first, second] = axes.map(|axis| chart.change(normal, scaled(1.0 / ball.radius, axis)));
    let gradients = [0, 1].map(|k| add(scaled(first[k], axes[0]), scaled(second[k], axes[1])));
    Some(Charted {
        point: ray.at(distance),
        normal,
        tangent: axes[0],
        uv: chart.at(normal),
        gradients,
    })
}

/// How far along a ray a point of it is, in the ray's direction.
pub(super) fn distance(ray: &Ray<f64>, point: Vector<f64>) -> f64 {
    dot(sub(point, ray.eye), ray.direction) / dot(ray.direction, ray.direction)
}
