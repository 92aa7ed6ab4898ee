//! What is rendered: a surface, a camera, a light; in f32 for the methods and in f64 for the
//! reference.
//!
//! A new scene is a new [`Surface`] in a file of its own and one more constructor of [`Subject`].

mod balls;
mod chart;
mod disk;
mod map;
mod mapped_ball;
mod movement;
mod plane;
mod strips;
mod subject;
mod surface;
mod torus;
mod traced;
mod water;

use lobe::slope::Motion;
use lobe::slope::direction::half_vector;

use crate::camera::{Camera, Ray};
use crate::frame::Frame;
use crate::light::Light;
use crate::scalar::Scalar;
use crate::vector::{add, along, dot, scaled, sub, tangential};
use surface::{Hit, Shape, Surface, on_shape};

pub(crate) use balls::Ball;
pub(crate) use chart::{Charted, Lambert};
pub(crate) use disk::ACROSS;
pub(crate) use map::{NormalMap, carried_maps, combed_map, restless_map};
pub(crate) use movement::Movement;
pub(crate) use subject::Subject;
pub(crate) use torus::Torus;
pub use traced::Traced;

/// What shading needs of one point of the picture, in the point's own shading frame.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sample<R> {
    /// To the eye.
    pub(crate) wo: [R; 3],
    /// To the light.
    pub(crate) wi: [R; 3],
    /// Their unit half vector.
    pub(crate) half: [R; 3],
    /// The shading frame's first axis and its normal, in the world: what a G-buffer pass knows.
    pub(crate) tangent: [R; 3],
    pub(crate) normal: [R; 3],
    /// Irradiance on a surface that faces the light.
    pub(crate) strength: R,
    /// Whether there is a surface. Without one all directions are zero and shade to black.
    pub(crate) hit: bool,
}

/// Changes of a sample to the pixel at the right and to the one below: of $w_o + w_i$, of the
/// shading normal and of the frame about it.
pub(crate) type Motions<R> = [Motion<R>; 2];

/// A lit surface in one precision.
pub(crate) struct Scene<R> {
    camera: Camera<R>,
    light: Light<R>,
    surface: Surface<R>,
}

impl<R: Scalar> Scene<R> {
    /// The sample at the picture's point (x, y); pixel centers are at halves.
    ///
    /// Ray, hit, normal, frame, directions: what the report calls geometry.
    #[inline]
    pub(crate) fn sample(&self, x: R, y: R) -> Sample<R> {
        on_shape!(&self.surface, shape => self.sample_on(shape, x, y))
    }

    #[inline(always)]
    fn sample_on(&self, shape: &impl Shape<R>, x: R, y: R) -> Sample<R> {
        let ray = self.camera.ray(x, y);
        match shape.hit(&ray) {
            Some(hit) => self.lit(&ray, &hit, &Frame::around(hit.normal, hit.tangent)),
            None => Sample::default(),
        }
    }

    /// The sample with its motions, by ray differentials and the surface's own derivatives.
    #[inline]
    pub(crate) fn sample_in_motion(&self, x: R, y: R) -> (Sample<R>, Motions<R>) {
        on_shape!(&self.surface, shape => self.sample_in_motion_on(shape, x, y))
    }

    #[inline(always)]
    fn sample_in_motion_on(&self, shape: &impl Shape<R>, x: R, y: R) -> (Sample<R>, Motions<R>) {
        let ray = self.camera.ray(x, y);
        let Some(hit) = shape.hit(&ray) else { return Default::default() };
        let frame = Frame::around(hit.normal, hit.tangent);
        let motions = [self.camera.right, self.camera.down]
            .map(|change| self.motion(shape, &ray, change, &hit, &frame));
        (self.lit(&ray, &hit, &frame), motions)
    }

    /// Whether the ray through (x, y) meets the surface.
    pub(crate) fn covers(&self, x: R, y: R) -> bool {
        on_shape!(&self.surface, shape => shape.hit(&self.camera.ray(x, y)).is_some())
    }

    #[inline]
    fn lit(&self, ray: &Ray<R>, hit: &Hit<R>, frame: &Frame<R>) -> Sample<R> {
        let arrival = self.light.at(hit.point);
        let away = scaled(-R::ONE / dot(ray.direction, ray.direction).sqrt(), ray.direction);
        let (wo, wi) = (frame.to_local(away), frame.to_local(arrival.wi));
        let [tangent, _, normal] = frame.axes();
        let (half, strength) = (half_vector(wo, wi), arrival.strength);
        Sample { wo, wi, half, tangent, normal, strength, hit: true }
    }

    /// What changes where the ray's direction does.
    ///
    /// Out of line: inlined twice, the two are packed into lanes through memory, at up to ten times
    /// the cost.
    #[inline(never)]
    fn motion(
        &self,
        shape: &impl Shape<R>,
        ray: &Ray<R>,
        change: [R; 3],
        hit: &Hit<R>,
        frame: &Frame<R>,
    ) -> Motion<R> {
        let step = step(ray, change, hit);
        let length = dot(ray.direction, ray.direction).sqrt();
        let forward = scaled(R::ONE / length, ray.direction);
        let eye_turn = scaled(-R::ONE / length, tangential(change, forward));
        let light_turn = self.light.at(hit.point).turn(step);
        let turn = shape.turn(hit, step);
        let [first, second, _] = frame.to_local(turn.normal);
        Motion {
            half_vector: frame.to_local(add(eye_turn, light_turn)),
            normal: [first, second],
            spin: frame.spin(&turn),
        }
    }
}

/// Where the hit goes on its tangent plane as the ray's direction changes (Igehy 1999).
#[inline(always)]
fn step<R: Scalar>(ray: &Ray<R>, change: [R; 3], hit: &Hit<R>) -> [R; 3] {
    let length_squared = dot(ray.direction, ray.direction);
    let distance = dot(sub(hit.point, ray.eye), ray.direction) / length_squared;
    let longer = -distance * dot(change, hit.geometric) / dot(ray.direction, hit.geometric);
    along(scaled(distance, change), longer, ray.direction)
}

#[cfg(test)]
mod tests;
