//! A dress of sparkling fabric: a surface of revolution with folds.

use super::{Light, Scene, gradient};
use crate::camera::{Ray, View};
use crate::material::Material;
use crate::surface::{Spot, Surface};
use glam::{DVec3, Vec3};
use lobe::Error;
use lobe::material::Fresnel;
use lobe::material::glint::hue_wheel;

/// Around the z axis, in meters; u runs around it as a length without folds, v upwards.
struct Dress;

/// Of the hem and of the seam at the top.
const HEIGHTS: [f64; 2] = [0.0, 1.3];
/// The cylinder around it.
const WIDEST: f64 = 0.75;

/// Radii by height, of a line through the middles of their distances.
const PROFILE: [[f64; 2]; 10] = [
    [0.0, 0.56],
    [0.2, 0.47],
    [0.4, 0.375],
    [0.6, 0.275],
    [0.75, 0.2],
    [0.86, 0.145],
    [0.95, 0.125],
    [1.06, 0.148],
    [1.18, 0.172],
    [1.3, 0.168],
];

/// The radius without folds: a cubic through the profile, with tangents of neighbors.
fn profile(z: f64) -> f64 {
    let last = PROFILE.len() - 2;
    let k = PROFILE.iter().skip(1).position(|[height, _]| z < *height).unwrap_or(last).min(last);
    let at = |k: usize| PROFILE[k.min(last + 1)];
    let tangent = |k: usize| {
        let ([a, b], [c, d]) = (at(k.saturating_sub(1)), at(k + 1));
        (d - b) / (c - a)
    };
    let ([low, from], [high, to]) = (at(k), at(k + 1));
    let step = high - low;
    let t = (z - low) / step;
    let (tt, rest) = (t * t, 1.0 - t);
    from * (1.0 + 2.0 * t) * rest * rest
        + to * tt * (3.0 - 2.0 * t)
        + step * (tangent(k) * t * rest * rest - tangent(k + 1) * tt * rest)
}

/// The radius at a height and an angle: folds grow from the hips to the hem, and wander.
fn radius(angle: f64, z: f64) -> f64 {
    let part = ((0.78 - z) / 0.78).clamp(0.0, 1.0);
    let depth = 0.24 * part.powf(1.2);
    let bend = 0.35 * (2.3 * z + angle).sin();
    let folds = (9.0 * angle + 2.0 * bend).cos() + 0.45 * (5.0 * angle - 1.0 - bend).cos();
    // Small creases where the cloth is tight.
    let creases = 0.006 * (24.0 * z + 3.0 * (2.0 * angle).sin()).sin() * (3.0 * angle).cos();
    profile(z) * (1.0 + depth * folds / 1.45 + creases)
}

impl Surface for Dress {
    fn meet(&self, ray: &Ray) -> Option<[f64; 2]> {
        let (o, d) = (ray.origin, ray.direction);
        // Within the cylinder and between the heights.
        let flat = d.x * d.x + d.y * d.y;
        let middle = -(o.x * d.x + o.y * d.y) / flat;
        let nearest = (o.x + middle * d.x).hypot(o.y + middle * d.y);
        let half = ((WIDEST * WIDEST - nearest * nearest).max(0.0) / flat).sqrt();
        let [mut near, mut far] = [middle - half, middle + half];
        let [a, b] = HEIGHTS.map(|z| (z - o.z) / d.z);
        (near, far) = (near.max(a.min(b)), far.min(a.max(b)));
        let outside = |t: f64| {
            let p = o + t * d;
            p.x.hypot(p.y) - radius(p.y.atan2(p.x), p.z)
        };
        let mut t = near;
        let mut before = t;
        while t < far {
            let gap = outside(t);
            if gap <= 0.0 {
                return Some(coordinates(o + root(&outside, before, t) * d));
            }
            before = t;
            // Folds are steep: a part of the gap is safe.
            t += (0.35 * gap).max(0.002);
        }
        None
    }

    fn spot(&self, [u, v]: [f64; 2]) -> Spot {
        let point = |u: f64, v: f64| {
            let angle = u / profile(v);
            let ((sin, cos), radius) = (angle.sin_cos(), radius(angle, v));
            DVec3::new(radius * cos, radius * sin, v)
        };
        let step = 1e-5;
        let by_u = (point(u + step, v) - point(u - step, v)) / (2.0 * step);
        let by_v = (point(u, v + step) - point(u, v - step)) / (2.0 * step);
        Spot { point: point(u, v), tangents: [by_u, by_v] }
    }
}

/// Texture coordinates of a point of the dress. The seam is on its back, away from the camera.
fn coordinates(point: DVec3) -> [f64; 2] {
    [profile(point.z) * point.y.atan2(point.x), point.z]
}

/// Where a function that falls through 0 between two places is 0, by halving.
fn root(f: &impl Fn(f64) -> f64, mut above: f64, mut below: f64) -> f64 {
    for _ in 0..40 {
        let middle = 0.5 * (above + below);
        if f(middle) > 0.0 { above = middle } else { below = middle }
    }
    0.5 * (above + below)
}

/// The dress in a dark room, under a key light and a rim light.
pub(super) fn dress() -> Result<Scene, Error> {
    let mut material = Material::new([0.55; 2], [0.05; 2], 4e6, 1.2)?;
    material.fresnel = Fresnel::schlick([0.35, 0.32, 0.4])?;
    material.base = Vec3::new(0.05, 0.03, 0.125);
    // Less than pure colors, of the same mean.
    material.palette = Some(|hue| hue_wheel(hue).map(|channel| 0.3 + 0.7 * channel));
    Ok(Scene {
        view: View {
            eye: DVec3::new(3.6, 0.0, 1.15),
            target: DVec3::new(0.0, 0.0, 0.565),
            half_height: 0.225,
        },
        surface: Box::new(Dress),
        material,
        lights: vec![
            Light::new(DVec3::new(0.55, -0.8, 0.6), Vec3::new(2.6, 2.5, 2.3), 0.02),
            Light::new(DVec3::new(0.1, 1.0, 0.4), Vec3::new(0.9, 1.0, 1.5), 0.02),
        ],
        environment: |direction| {
            gradient(direction, Vec3::new(0.01, 0.01, 0.015), Vec3::new(0.05, 0.05, 0.07))
        },
        backdrop: |direction| {
            gradient(direction, Vec3::new(0.01, 0.01, 0.014), Vec3::new(0.035, 0.03, 0.045))
        },
        exposure: 1.6,
    })
}
