//! A scene: a surface of one material under a few lights, in front of something.

mod ball;
mod disk;
mod dress;
mod plane;
mod snow;

use super::camera::View;
use super::material::Material;
use super::options::Subject;
use super::surface::Surface;
use glam::{DVec3, Vec3};
use lobe::Error;

pub(crate) use plane::glitter;

/// All that a picture needs but its size.
pub(crate) struct Scene {
    pub(crate) view: View,
    pub(crate) surface: Box<dyn Surface>,
    pub(crate) material: Material,
    pub(crate) lights: Vec<Light>,
    /// Radiance that the surface mirrors and scatters beside the lights', by direction; smooth.
    pub(crate) environment: fn(DVec3) -> Vec3,
    /// Radiance behind the surface, by direction.
    pub(crate) backdrop: fn(DVec3) -> Vec3,
    /// What radiance is multiplied by before it becomes a color.
    pub(crate) exposure: f32,
}

/// A disk of one radiance, far away.
pub(crate) struct Light {
    /// Towards it.
    pub(crate) direction: DVec3,
    radiance: Vec3,
    /// As it appears, in radians.
    pub(crate) radius: f32,
}

impl Light {
    /// A light of this irradiance across its direction: for so small a light, irradiance says more
    /// than radiance.
    pub(crate) fn new(direction: DVec3, irradiance: Vec3, radius: f32) -> Self {
        let light = Self { direction: direction.normalize(), radiance: Vec3::ONE, radius };
        Self { radiance: irradiance / light.irradiance(), ..light }
    }

    /// The light's irradiance across its direction.
    pub(crate) fn irradiance(&self) -> Vec3 {
        self.radiance * (std::f32::consts::PI * self.radius.sin().powi(2))
    }
}

impl Scene {
    /// With other details.
    pub(crate) fn seeded(self, seed: u32) -> Self {
        Self { material: self.material.seeded(seed), ..self }
    }
}

/// The scene of a subject; the zoom's is one of its frames.
pub(crate) fn scene(subject: Subject) -> Result<Scene, Error> {
    match subject {
        Subject::Snow => snow::snow(),
        Subject::Fabric => dress::dress(),
        Subject::Brushed => disk::disk(),
        Subject::Ball => ball::ball(),
        Subject::Zoom => glitter(1.0),
    }
}

/// From `below` to `above` as a direction rises, without a corner.
fn gradient(direction: DVec3, below: Vec3, above: Vec3) -> Vec3 {
    let part = (0.5 + 0.5 * direction.z).clamp(0.0, 1.0);
    below.lerp(above, (part * part * (3.0 - 2.0 * part)) as f32)
}
