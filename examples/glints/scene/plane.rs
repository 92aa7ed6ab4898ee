//! A plane of glitter, without end: the zoom's.

use super::{Light, Scene, gradient};
use crate::camera::{Ray, View};
use crate::material::Material;
use crate::surface::{Spot, Surface};
use glam::{DVec3, Vec3};
use lobe::Error;
use lobe::material::Fresnel;

/// The ground, in meters.
struct Ground;

impl Surface for Ground {
    fn meet(&self, ray: &Ray) -> Option<[f64; 2]> {
        let distance = -ray.origin.z / ray.direction.z;
        let point = ray.origin + distance * ray.direction;
        (distance > 0.0 && distance < 1e6).then_some([point.x, point.y])
    }

    fn spot(&self, [x, y]: [f64; 2]) -> Spot {
        Spot { point: DVec3::new(x, y, 0.0), tangents: [DVec3::X, DVec3::Y] }
    }
}

/// The plane from a distance in meters: the farther, the more of it, and the same highlight.
pub(crate) fn glitter(distance: f64) -> Result<Scene, Error> {
    // No place of whole numbers, which cells of all sizes share.
    let target = DVec3::new(0.3719, 0.8263, 0.0);
    // Not along an axis of the texture, either: across the picture its pixels turn through a
    // diagonal.
    let (sin, cos) = 0.6_f64.sin_cos();
    let around = |x: f64, y: f64, z: f64| DVec3::new(cos * x - sin * y, sin * x + cos * y, z);
    let towards = around(0.0, -0.8, 0.62).normalize();
    let mut material = Material::new([0.15; 2], [0.1; 2], 1e6, 0.0)?;
    material.fresnel = Fresnel::schlick([0.9, 0.85, 0.8])?;
    material.base = Vec3::new(0.015, 0.02, 0.03);
    Ok(Scene {
        view: View { eye: target + distance * towards, target, half_height: 0.36 },
        surface: Box::new(Ground),
        material,
        lights: vec![Light::new(around(0.0, 0.8, 0.62), Vec3::splat(0.3), 0.01)],
        environment: |direction| gradient(direction, Vec3::splat(0.005), Vec3::splat(0.015)),
        backdrop: |_| Vec3::splat(0.02),
        exposure: 1.0,
    })
}
