//! Surfaces: where a ray meets one, and how its normal and tangent turn along it.

use super::balls::Balls;
use super::disk::Disk;
use super::mapped_ball::MappedBall;
use super::plane::MappedPlane;
use super::strips::Strips;
use super::torus::Torus;
use super::water::Waves;
use crate::camera::Ray;
use crate::frame::Turn;
use crate::scalar::Scalar;
use crate::vector::{Vector, scaled, tangential};

/// The nearest point of a surface on a ray.
#[derive(Clone, Copy)]
pub(super) struct Hit<R> {
    pub(super) point: Vector<R>,
    /// Unit normal of the surface itself.
    pub(super) geometric: Vector<R>,
    /// Unit normal to shade with.
    pub(super) normal: Vector<R>,
    /// What the shading frame's first axis is made of.
    pub(super) tangent: Vector<R>,
    /// Which of a surface's parts.
    pub(super) part: usize,
}

/// Anything that can be hit.
pub(super) trait Shape<R: Scalar> {
    /// The nearest hit on a ray.
    fn hit(&self, ray: &Ray<R>) -> Option<Hit<R>>;

    /// Derivatives of the shading normal and of the tangent along a step in the tangent plane.
    fn turn(&self, hit: &Hit<R>, step: Vector<R>) -> Turn<R>;
}

/// Every surface of the report.
pub(super) enum Surface<R> {
    Water(Waves<R>),
    Plane(MappedPlane<R>),
    Balls(Balls<R>),
    MappedBall(MappedBall<R>),
    Torus(Torus<R>),
    Strips(Strips<R>),
    Disk(Disk<R>),
}

impl Surface<f64> {
    /// The same in another precision.
    pub(super) fn cast<R: Scalar>(&self) -> Surface<R> {
        match self {
            Self::Water(water) => Surface::Water(water.cast()),
            Self::Plane(plane) => Surface::Plane(plane.cast()),
            Self::Balls(balls) => Surface::Balls(balls.cast()),
            Self::MappedBall(ball) => Surface::MappedBall(ball.cast()),
            Self::Torus(torus) => Surface::Torus(torus.cast()),
            Self::Strips(strips) => Surface::Strips(strips.cast()),
            Self::Disk(disk) => Surface::Disk(disk.cast()),
        }
    }
}

/// An expression of a surface's shape, compiled for each: hits then stay in registers.
macro_rules! on_shape {
    ($surface:expr, $shape:ident => $body:expr) => {
        match $surface {
            $crate::scene::surface::Surface::Water($shape) => $body,
            $crate::scene::surface::Surface::Plane($shape) => $body,
            $crate::scene::surface::Surface::Balls($shape) => $body,
            $crate::scene::surface::Surface::MappedBall($shape) => $body,
            $crate::scene::surface::Surface::Torus($shape) => $body,
            $crate::scene::surface::Surface::Strips($shape) => $body,
            $crate::scene::surface::Surface::Disk($shape) => $body,
        }
    };
}
pub(super) use on_shape;

/// The world's x axis: the tangent of surfaces whose normals stay away from it.
pub(super) fn world_x<R: Scalar>() -> Vector<R> {
    [R::ONE, R::ZERO, R::ZERO]
}

/// The world's z axis: the normal of the plane.
pub(super) fn world_z<R: Scalar>() -> Vector<R> {
    [R::ZERO, R::ZERO, R::ONE]
}

/// Where a ray meets the plane z = 0 from above.
#[inline]
pub(super) fn plane_point<R: Scalar>(ray: &Ray<R>) -> Option<Vector<R>> {
    if !(ray.direction[2] < R::ZERO) {
        return None;
    }
    Some(ray.at(-ray.eye[2] / ray.direction[2]))
}

/// Change of the unit normal of a slope that changes by `change`.
#[inline]
pub(super) fn slope_turn<R: Scalar>(normal: Vector<R>, change: [R; 2]) -> Vector<R> {
    // n = (-s, 1)/L, and n_z = 1/L.
    scaled(normal[2], tangential([-change[0], -change[1], R::ZERO], normal))
}

#[cfg(test)]
mod tests {
    use super::{plane_point, slope_turn};
    use crate::camera::Ray;
    use lobe::slope::direction::normal_of;

    #[test]
    fn rays_that_do_not_fall_miss_the_plane() {
        let ray = |z: f64| Ray { eye: [0.0, 0.0, 2.0], direction: [0.5, 1.0, z] };
        assert_eq!(plane_point(&ray(-1.0)), Some([1.0, 2.0, 0.0]));
        assert_eq!(plane_point(&ray(0.0)), None);
        assert_eq!(plane_point(&ray(1.0)), None);
    }

    #[test]
    fn normals_turn_with_their_slope() {
        let (slope, change, h) = ([0.4, -0.7], [0.3, 0.2], 1e-6);
        let at = |t: f64| normal_of([slope[0] + t * change[0], slope[1] + t * change[1]]);
        let turn = slope_turn(at(0.0), change);
        for ((turn, after), before) in turn.into_iter().zip(at(h)).zip(at(-h)) {
            assert!((turn - (after - before) / (2.0 * h)).abs() < 1e-9);
        }
    }
}
