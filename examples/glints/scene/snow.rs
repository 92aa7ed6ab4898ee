//! Snow on rolling ground, from the height of an eye to the horizon, against a low sun.

use super::{Light, Scene, gradient};
use crate::camera::{Ray, View};
use crate::material::Material;
use crate::surface::{Frame, Spot, Surface};
use glam::{DVec2, DVec3, Vec3};
use lobe::material::Fresnel;
use lobe::{Error, Psd, SlopeMoments};
use std::f64::consts::TAU;

/// A sum of waves over the plane, in meters.
struct Ground {
    waves: Vec<Wave>,
    /// No height is above this, and no slope steeper.
    highest: f64,
    steepest: f64,
}

/// $a \sin(k \cdot x + p)$.
struct Wave {
    amplitude: f64,
    vector: DVec2,
    phase: f64,
}

/// Wave lengths in meters, the largest slope of each, and its direction in turns: hills, dunes,
/// ripples of the wind.
const WAVES: [[f64; 3]; 11] = [
    [310.0, 0.09, 0.2],
    [170.0, 0.07, 0.41],
    [83.0, 0.05, 0.03],
    [47.0, 0.06, 0.62],
    [29.0, 0.05, 0.81],
    [13.0, 0.045, 0.11],
    [7.1, 0.05, 0.93],
    [3.3, 0.035, 0.07],
    [1.31, 0.03, 0.22],
    [0.83, 0.035, 0.13],
    [0.47, 0.03, 0.18],
];

/// Farther than this there is no ground.
const FARTHEST: f64 = 3000.0;

impl Ground {
    /// Of the waves above.
    fn new() -> Self {
        let waves: Vec<Wave> = WAVES
            .iter()
            .zip(0..)
            .map(|(&[length, slope, turns], k)| {
                let (sin, cos) = (TAU * turns).sin_cos();
                let vector = TAU / length * DVec2::new(cos, sin);
                // Phases without a pattern, by the golden ratio.
                let phase = TAU * (0.618_034 * f64::from(k)).fract();
                Wave { amplitude: slope * length / TAU, vector, phase }
            })
            .collect();
        let highest = waves.iter().map(|wave| wave.amplitude).sum();
        Self { waves, highest, steepest: WAVES.iter().map(|[_, slope, _]| slope).sum() }
    }

    /// Above the plane.
    fn height(&self, place: DVec2) -> f64 {
        let height = |w: &Wave| w.amplitude * (w.vector.dot(place) + w.phase).sin();
        self.waves.iter().map(height).sum()
    }

    /// A place on a ray just above the ground, moved onto it by Newton's steps.
    fn refined(&self, ray: &Ray, start: f64) -> f64 {
        let mut t = start;
        for _ in 0..4 {
            let point = ray.origin + t * ray.direction;
            let place = point.truncate();
            let rise = ray.direction.z - self.slope(place).dot(ray.direction.truncate());
            // Along a ridge a step would lead anywhere: the place is right to 1/1000 already.
            t -= (point.z - self.height(place)) / rise.min(-1e-3);
            t = t.clamp(start, 1.01 * start);
        }
        t
    }

    /// Derivatives of the height.
    fn slope(&self, place: DVec2) -> DVec2 {
        let slope = |w: &Wave| w.amplitude * (w.vector.dot(place) + w.phase).cos() * w.vector;
        self.waves.iter().map(slope).sum()
    }
}

impl Surface for Ground {
    fn meet(&self, ray: &Ray) -> Option<[f64; 2]> {
        let (o, d) = (ray.origin, ray.direction);
        let flat = d.truncate().length();
        // The height above the ground falls no faster than this.
        let fall = (self.steepest * flat - d.z).max(1e-9);
        let mut t = 0.0;
        while t < FARTHEST {
            let point = o + t * d;
            if d.z >= 0.0 && point.z > self.highest {
                return None;
            }
            let gap = point.z - self.height(point.truncate());
            if gap < 1e-3 * t {
                let point = o + self.refined(ray, t) * d;
                return Some([point.x, point.y]);
            }
            t += gap / fall;
        }
        None
    }

    fn spot(&self, [x, y]: [f64; 2]) -> Spot {
        let place = DVec2::new(x, y);
        let slope = self.slope(place);
        let tangents = [DVec3::new(1.0, 0.0, slope.x), DVec3::new(0.0, 1.0, slope.y)];
        Spot { point: place.extend(self.height(place)), tangents }
    }

    /// The plane's: its waves are a normal map, for far away a pixel is longer than they are.
    fn frame(&self, _spot: &Spot) -> Frame {
        Frame::WORLD
    }

    /// The mean of each wave's slope over a Gaussian pixel, and the variance that this takes from
    /// it.
    fn bumps(&self, uv: [f64; 2], steps: [[f64; 2]; 2], wo: DVec3) -> SlopeMoments<f32> {
        let place = DVec2::from(uv);
        let (mut mean, mut second) = (DVec2::ZERO, [0.0; 3]);
        for Wave { amplitude, vector, phase } in &self.waves {
            let across = steps.map(|step| vector.dot(step.into()).powi(2));
            // Of the box pixel's variance, 1/12 along both of its sides.
            let left = (-(across[0] + across[1]) / 24.0).exp();
            let slope = *amplitude * *vector;
            mean += left * (vector.dot(place) + phase).cos() * slope;
            let lost = 0.5 * (1.0 - left * left);
            second[0] += lost * slope.x * slope.x;
            second[1] += lost * slope.x * slope.y;
            second[2] += lost * slope.y * slope.y;
        }
        // Slopes that turn away from the eye hide: what it sees of the ground faces it.
        let across = wo.truncate();
        let missing = ((0.3 * wo.z).max(0.01) - (wo.z - mean.dot(across))).max(0.0);
        mean -= across * (missing / across.length_squared().max(1e-9));
        let [xx, xy, yy] = second.map(|x| x as f32);
        // A sum of squares, but for roundings.
        let covariance = Psd::new(xx, xy, yy).unwrap_or_default();
        SlopeMoments::new(mean.as_vec2(), covariance).unwrap_or_default()
    }
}

/// The ground and the sky above it.
pub(super) fn snow() -> Result<Scene, Error> {
    let mut material = Material::new([0.6; 2], [0.024; 2], 6e5, 1.0)?;
    material.fresnel = Fresnel::schlick([0.05; 3])?;
    material.base = Vec3::new(0.82, 0.84, 0.88);
    let ground = Ground::new();
    let eye = DVec2::new(4.37, 2.91);
    Ok(Scene {
        view: View {
            eye: eye.extend(ground.height(eye) + 1.5),
            target: (eye + DVec2::new(0.0, 10.0)).extend(ground.height(eye) - 0.9),
            half_height: 0.42,
        },
        surface: Box::new(ground),
        material,
        lights: vec![Light::new(DVec3::new(-0.35, 0.9, 0.3), Vec3::new(2.6, 2.35, 2.0), 0.00465)],
        environment: |direction| {
            gradient(direction, Vec3::new(0.25, 0.27, 0.3), Vec3::new(0.2, 0.3, 0.5))
        },
        backdrop: |direction| {
            let low = (1.0 - direction.z.max(0.0)).powi(6) as f32;
            Vec3::new(0.1, 0.24, 0.6).lerp(Vec3::new(0.55, 0.66, 0.8), low)
        },
        exposure: 2.0,
    })
}
