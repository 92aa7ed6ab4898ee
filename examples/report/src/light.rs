//! Lights: a direction, or a point that shines alike in all directions.

use serde::Serialize;

use crate::scalar::Scalar;
use crate::vector::{Vector, along, cast, dot, scaled, sub, tangential, turned};

/// Which of a scene's two lights.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum LightKind {
    Distant,
    Point,
}

impl LightKind {
    pub(crate) const ALL: [Self; 2] = [Self::Distant, Self::Point];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Distant => "distant light",
            Self::Point => "point light",
        }
    }
}

/// A light.
#[derive(Clone)]
pub(crate) enum Light<R> {
    /// From this unit direction everywhere, of irradiance 1 on a surface that faces it.
    Distant(Vector<R>),
    /// At a position, of irradiance `power` over squared distance.
    Point { position: Vector<R>, power: R },
}

/// A light as a point sees it.
pub(crate) struct Arrival<R> {
    /// Unit direction to the light.
    pub(crate) wi: Vector<R>,
    /// Irradiance on a surface that faces it.
    pub(crate) strength: R,
    /// One over its distance; 0 for a distant light.
    inverse_distance: R,
}

impl Light<f64> {
    /// A point light seen from `target` in the unit direction `towards`; its irradiance at `target`
    /// is that of the distant light.
    pub(crate) fn point(target: Vector<f64>, towards: Vector<f64>, distance: f64) -> Self {
        Self::Point { position: along(target, distance, towards), power: distance * distance }
    }

    /// The light, turned about the world's z axis.
    pub(crate) fn turned(&self, angle: f64) -> Self {
        match *self {
            Self::Distant(direction) => Self::Distant(turned(direction, angle)),
            Self::Point { position, power } => {
                Self::Point { position: turned(position, angle), power }
            }
        }
    }

    /// The same in another precision.
    pub(crate) fn cast<R: Scalar>(&self) -> Light<R> {
        match *self {
            Self::Distant(direction) => Light::Distant(cast(direction)),
            Self::Point { position, power } => {
                Light::Point { position: cast(position), power: R::lit(power) }
            }
        }
    }
}

impl<R: Scalar> Light<R> {
    /// Direction and strength at a point.
    #[inline]
    pub(crate) fn at(&self, point: Vector<R>) -> Arrival<R> {
        match *self {
            Self::Distant(wi) => Arrival { wi, strength: R::ONE, inverse_distance: R::ZERO },
            Self::Point { position, power } => {
                let to = sub(position, point);
                let inverse_distance = R::ONE / dot(to, to).sqrt();
                let wi = scaled(inverse_distance, to);
                let strength = power * inverse_distance * inverse_distance;
                Arrival { wi, strength, inverse_distance }
            }
        }
    }
}

impl<R: Scalar> Arrival<R> {
    /// How the direction changes when the lit point moves by `step`: $-(I - w_i w_i^T)\,dx/r$.
    #[inline]
    pub(crate) fn turn(&self, step: Vector<R>) -> Vector<R> {
        scaled(-self.inverse_distance, tangential(step, self.wi))
    }
}

#[cfg(test)]
mod tests {
    use super::Light;

    #[test]
    fn a_point_light_is_as_strong_as_the_distant_one_where_it_aims_and_falls_off_with_the_square() {
        let light = Light::point([1.0, 2.0, 0.0], [0.0, 0.6, 0.8], 5.0);
        let aimed = light.at([1.0, 2.0, 0.0]);
        assert!((aimed.strength - 1.0).abs() < 1e-15);
        assert!((aimed.wi[1] - 0.6).abs() < 1e-15 && (aimed.wi[2] - 0.8).abs() < 1e-15);
        // Five further back along the same line.
        let behind = light.at([1.0, -1.0, -4.0]);
        assert!((behind.strength - 0.25).abs() < 1e-15);
    }

    #[test]
    fn directions_turn_by_their_difference() {
        let light = Light::point([0.0, 0.0, 0.0], [0.48, 0.36, 0.8], 3.0);
        let (point, step, h) = ([0.2, -0.3, 0.1], [0.3, 0.5, -0.2], 1e-5);
        let turn = light.at(point).turn(step);
        let [after, before] = [h, -h].map(|t| {
            light.at([point[0] + t * step[0], point[1] + t * step[1], point[2] + t * step[2]]).wi
        });
        for k in 0..3 {
            assert!((turn[k] - (after[k] - before[k]) / (2.0 * h)).abs() < 1e-9);
        }
    }
}
