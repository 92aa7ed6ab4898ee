//! A disk of metal, brushed in circles.

use super::{Light, Scene, gradient};
use crate::camera::{Ray, View};
use crate::material::Material;
use crate::surface::{Spot, Surface};
use glam::{DVec3, Vec3};
use lobe::Error;
use lobe::material::Fresnel;

/// A ring in the plane z = 0; u is the distance from its center, v the angle around it.
struct Disk {
    radii: [f64; 2],
}

impl Surface for Disk {
    fn meet(&self, ray: &Ray) -> Option<[f64; 2]> {
        let distance = -ray.origin.z / ray.direction.z;
        let point = ray.origin + distance * ray.direction;
        let radius = point.x.hypot(point.y);
        let inside = radius >= self.radii[0] && radius <= self.radii[1];
        (distance > 0.0 && inside).then(|| [radius, point.y.atan2(point.x)])
    }

    fn spot(&self, [radius, angle]: [f64; 2]) -> Spot {
        let (sin, cos) = angle.sin_cos();
        let across = DVec3::new(cos, sin, 0.0);
        let around = DVec3::new(-sin, cos, 0.0);
        Spot { point: radius * across, tangents: [across, radius * around] }
    }
}

/// The disk under two lamps.
pub(super) fn disk() -> Result<Scene, Error> {
    let mut material = Material::new([0.35, 0.06], [0.06, 1.0], 4e7, 0.0)?;
    material.fresnel = Fresnel::schlick([0.92, 0.9, 0.88])?;
    Ok(Scene {
        view: View {
            eye: DVec3::new(0.0, -2.6, 2.6),
            target: DVec3::new(0.0, -0.02, 0.0),
            half_height: 0.235,
        },
        surface: Box::new(Disk { radii: [0.14, 1.0] }),
        material,
        lights: vec![
            Light::new(DVec3::new(0.25, 0.75, 1.0), Vec3::new(0.6, 0.57, 0.54), 0.02),
            Light::new(DVec3::new(-1.0, 0.1, 0.9), Vec3::new(0.2, 0.25, 0.33), 0.02),
        ],
        environment: |direction| {
            gradient(direction, Vec3::splat(0.02), Vec3::new(0.05, 0.055, 0.065))
        },
        backdrop: |direction| gradient(direction, Vec3::splat(0.012), Vec3::splat(0.05)),
        exposure: 1.0,
    })
}
