//! The scenes of the report: surface, view and both lights, with names and captions.

use super::Scene;
use super::balls::Balls;
use super::disk::Disk;
use super::map::NormalMap;
use super::mapped_ball::MappedBall;
use super::plane::{self, MappedPlane};
use super::strips::{Strips, towards};
use super::surface::{Surface, plane_point};
use super::torus::Torus;
use super::water::{self, Waves};
use crate::camera::{Camera, Size};
use crate::light::{Light, LightKind};
use crate::method::Finish;
use crate::vector::{Vector, along};

/// A scene with its name, ready to be lit.
pub(crate) struct Subject {
    /// Short, for tables.
    pub(crate) name: String,
    /// One sentence on what is seen.
    pub(crate) caption: String,
    pub(crate) size: Size,
    /// What the material is like, apart from its alpha.
    pub(crate) finish: Finish,
    pub(super) camera: Camera<f64>,
    pub(super) surface: Surface<f64>,
    /// In the order of [`LightKind::ALL`].
    pub(super) lights: [Light<f64>; 2],
}

/// A scene under one of its lights, in both precisions.
pub(crate) struct Lit {
    /// What the methods render: f32, as an engine would.
    pub(crate) engine: Scene<f32>,
    /// The same, for the reference.
    pub(crate) exact: Scene<f64>,
}

/// Angles of a view over a plane, in degrees.
pub(super) struct View {
    /// Of the view at the picture's top and bottom edge.
    pub(super) top: f64,
    pub(super) bottom: f64,
    /// Of the light, straight ahead of the camera.
    pub(super) light: f64,
}

/// Distance of the eye from scenes around the origin, in pixels.
const EYE: f64 = 1000.0;

/// The same for strips, which see nearly the same direction everywhere.
const FAR_EYE: f64 = 6000.0;

/// Elevation of view and light over the disk, in degrees.
const DISC_VIEW: f64 = 40.0;

/// Elevation of the light over strips, in degrees: they are seen at about half of it.
const STRIP_LIGHT: f64 = 8.0;

/// Pictures narrower than this keep their features' sizes in pixels and show fewer of them; in
/// wider ones the features grow.
const FULL_WIDTH: f64 = 400.0;

impl Subject {
    /// Waves at grazing view.
    pub(crate) fn water(size: Size) -> Self {
        let camera = Camera::spanning(size, water::VIEW.top, water::VIEW.bottom);
        let (waves, caption) = Waves::seen_by(&camera, size);
        Self::over_plane("water".into(), caption, size, &water::VIEW, camera, Surface::Water(waves))
    }

    /// A plane with a normal map.
    pub(crate) fn plane(size: Size, map: &NormalMap) -> Self {
        let camera = Camera::spanning(size, plane::VIEW.top, plane::VIEW.bottom);
        let (surface, caption) = MappedPlane::seen_by(&camera, size, map);
        let name = format!("plane: {}", map.name);
        Self::over_plane(name, caption, size, &plane::VIEW, camera, Surface::Plane(surface))
    }

    /// Balls of many sizes.
    pub(crate) fn balls(size: Size) -> Self {
        let (balls, caption) = Balls::seen_in(size, unit(size));
        Self::before_eye("sphere".into(), caption, size, BACK_LIGHT, Surface::Balls(balls))
    }

    /// A ball with a normal map.
    pub(crate) fn mapped_ball(size: Size, map: &NormalMap) -> Self {
        let (ball, caption) = MappedBall::seen_in(size, map);
        let name = format!("sphere: {}", map.name);
        Self::before_eye(name, caption, size, FRONT_LIGHT, Surface::MappedBall(ball))
    }

    /// A thin torus.
    pub(crate) fn torus(size: Size) -> Self {
        let (torus, caption) = Torus::seen_in(size, unit(size));
        Self::before_eye("torus".into(), caption, size, BACK_LIGHT, Surface::Torus(torus))
    }

    /// Thin strips at grazing angles.
    pub(crate) fn strips(size: Size) -> Self {
        let unit = unit(size);
        let distance = FAR_EYE * unit;
        let camera = Camera::looking(size, [0.0, -distance, 0.0], [0.0; 3], distance);
        let (sin, cos) = STRIP_LIGHT.to_radians().sin_cos();
        let ahead = [0.0, cos, sin];
        let lamp = distance;
        let aim = |odd: bool, from: Vector<f64>| {
            if odd { towards(from, along([0.0; 3], lamp, ahead)) } else { ahead }
        };
        let (strips, caption) = Strips::seen_by(&camera, size, unit, distance, aim);
        Self {
            name: "strip".into(),
            caption,
            size,
            finish: Finish::Isotropic,
            camera,
            surface: Surface::Strips(strips),
            lights: [Light::Distant(ahead), Light::point([0.0; 3], ahead, lamp)],
        }
    }

    /// A brushed disk.
    pub(crate) fn disk(size: Size) -> Self {
        let unit = unit(size);
        let (sin, cos) = DISC_VIEW.to_radians().sin_cos();
        let distance = EYE * unit;
        let eye = [0.0, -cos * distance, sin * distance];
        let camera = Camera::looking(size, eye, [0.0; 3], distance);
        let (disk, caption) = Disk::seen_in(size, unit, DISC_VIEW);
        let ahead = [0.0, cos, sin];
        Self {
            name: "disk".into(),
            caption,
            size,
            finish: Finish::Brushed,
            camera,
            surface: Surface::Disk(disk),
            lights: [Light::Distant(ahead), Light::point([0.0; 3], ahead, size.width as f64)],
        }
    }

    /// A plane below a camera at height 1, a light straight ahead; the point light's mirror image
    /// is where the distant one's is, at twice the distance of the eye.
    fn over_plane(
        name: String,
        caption: String,
        size: Size,
        view: &View,
        camera: Camera<f64>,
        surface: Surface<f64>,
    ) -> Self {
        let (sin, cos) = view.light.to_radians().sin_cos();
        let ahead = [0.0, cos, sin];
        let center = camera.ray(0.5 * size.width as f64, 0.5 * size.height as f64);
        // A camera that spans angles above the horizon would have none.
        let target = plane_point(&center).unwrap_or([0.0; 3]);
        let distance = 2.0 * (target[0].powi(2) + target[1].powi(2) + 1.0).sqrt();
        let lights = [Light::Distant(ahead), Light::point(target, ahead, distance)];
        Self { name, caption, size, finish: Finish::Isotropic, camera, surface, lights }
    }

    /// Something around the origin, a pixel as wide as the unit of length, looked at along +y.
    fn before_eye(
        name: String,
        caption: String,
        size: Size,
        light: Vector<f64>,
        surface: Surface<f64>,
    ) -> Self {
        let distance = EYE * unit(size);
        let camera = Camera::looking(size, [0.0, -distance, 0.0], [0.0; 3], distance);
        let towards = lobe::slope::direction::normalize(light);
        let lights =
            [Light::Distant(towards), Light::point([0.0; 3], towards, 1.2 * size.width as f64)];
        Self { name, caption, size, finish: Finish::Isotropic, camera, surface, lights }
    }

    /// The scene under one of its lights.
    pub(crate) fn lit(&self, kind: LightKind) -> Lit {
        self.seen(self.camera.clone(), self.lights[kind as usize].clone())
    }

    /// The surface by another camera and under another light.
    pub(super) fn seen(&self, camera: Camera<f64>, light: Light<f64>) -> Lit {
        Lit {
            engine: Scene {
                camera: camera.cast(),
                light: light.cast(),
                surface: self.surface.cast(),
            },
            exact: Scene { camera, light, surface: self.surface.cast() },
        }
    }
}

/// To the light of balls and torus: highlights lie half way to the silhouette.
const BACK_LIGHT: Vector<f64> = [0.45, 0.15, 0.9];

/// To the light of mapped balls.
const FRONT_LIGHT: Vector<f64> = [0.5, -0.55, 0.67];

/// The length of a pixel in scenes around the origin.
fn unit(size: Size) -> f64 {
    (size.width as f64 / FULL_WIDTH).max(1.0)
}
