//! A ball that was turned on a lathe: grooves along its circles of latitude.

use super::{Light, Scene, gradient};
use crate::camera::{Ray, View};
use crate::material::Material;
use crate::surface::{Spot, Surface};
use glam::{DVec3, Vec3};
use lobe::Error;
use lobe::material::Fresnel;

/// A sphere of radius 1 around the origin; u is the angle from its axis, v that around it.
struct Ball {
    /// Right-handed; the axis is the third.
    axes: [DVec3; 3],
}

impl Ball {
    /// With its axis along a direction.
    fn new(axis: DVec3) -> Self {
        let axis = axis.normalize();
        let side = DVec3::Z.cross(axis).normalize();
        Self { axes: [side, axis.cross(side), axis] }
    }
}

impl Surface for Ball {
    fn meet(&self, ray: &Ray) -> Option<[f64; 2]> {
        let middle = -ray.origin.dot(ray.direction);
        let nearest = ray.origin + middle * ray.direction;
        let half = 1.0 - nearest.length_squared();
        if half < 0.0 {
            return None;
        }
        let point = nearest - half.sqrt() * ray.direction;
        let [x, y, z] = self.axes.map(|axis| axis.dot(point));
        Some([x.hypot(y).atan2(z), y.atan2(x)])
    }

    fn spot(&self, [u, v]: [f64; 2]) -> Spot {
        let ((sin_u, cos_u), (sin_v, cos_v)) = (u.sin_cos(), v.sin_cos());
        let [x, y, z] = self.axes;
        let around = |a: f64, b: f64| a * x + b * y;
        let point = sin_u * around(cos_v, sin_v) + cos_u * z;
        let along = cos_u * around(cos_v, sin_v) - sin_u * z;
        // At the poles all of v is one point, and has a direction still.
        Spot { point, tangents: [along, sin_u.max(1e-9) * around(-sin_v, cos_v)] }
    }
}

/// The ball before a plain wall.
pub(super) fn ball() -> Result<Scene, Error> {
    // Grooves: along v a detail has all slopes. Three thousand lie on a unit of length across.
    let mut material = Material::new([0.6, 0.15], [0.05, 1.0], 1e7, 0.0)?;
    material.fresnel = Fresnel::schlick([0.95, 0.78, 0.5])?;
    Ok(Scene {
        view: View { eye: DVec3::new(0.0, -6.0, 1.2), target: DVec3::ZERO, half_height: 0.2 },
        surface: Box::new(Ball::new(DVec3::new(0.35, -0.45, 1.0))),
        material,
        lights: vec![
            Light::new(DVec3::new(-0.6, -0.7, 0.8), Vec3::splat(2.0), 0.02),
            Light::new(DVec3::new(1.0, -0.3, 0.3), Vec3::new(0.5, 0.7, 1.0), 0.02),
            Light::new(DVec3::new(-1.0, 0.4, -0.1), Vec3::new(0.5, 0.45, 0.4), 0.02),
        ],
        environment: |direction| {
            gradient(direction, Vec3::new(0.01, 0.01, 0.01), Vec3::new(0.07, 0.08, 0.1))
        },
        backdrop: |direction| gradient(direction, Vec3::splat(0.09), Vec3::splat(0.17)),
        exposure: 1.0,
    })
}
