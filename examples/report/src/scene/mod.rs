//! What is rendered: a bumpy plane, a camera above it, a distant light.
//!
//! A new scene is a new [`Surface`] in a file of its own and one more entry in `main`'s list.

mod plane;
mod water;

use lobe::slope::direction::half_vector;

use crate::camera::{Camera, Size};
use crate::frame::Frame;
use crate::scalar::Scalar;
use plane::MappedPlane;
use water::Waves;

pub(crate) use plane::{NormalMap, carried_maps};

/// What shading needs of one point of the picture, in the point's own shading frame.
#[derive(Clone, Copy)]
pub(crate) struct Sample<R> {
    /// To the eye.
    pub(crate) wo: [R; 3],
    /// To the light.
    pub(crate) wi: [R; 3],
    /// Their unit half vector.
    pub(crate) half: [R; 3],
}

/// A scene in one precision.
pub(crate) struct Scene<R> {
    camera: Camera<R>,
    light: [R; 3],
    surface: Surface<R>,
}

/// Where the normals come from.
enum Surface<R> {
    Water(Waves<R>),
    Plane(MappedPlane<R>),
}

impl Surface<f64> {
    /// The same in another precision.
    fn cast<R: Scalar>(&self) -> Surface<R> {
        match self {
            Self::Water(waves) => Surface::Water(waves.cast()),
            Self::Plane(plane) => Surface::Plane(plane.cast()),
        }
    }
}

impl<R: Scalar> Scene<R> {
    /// The sample at the picture's point (x, y); pixel centres are at halves.
    ///
    /// Ray, hit of the mean plane, normal, frame, directions: what the report calls geometry.
    #[inline]
    pub(crate) fn sample(&self, x: R, y: R) -> Sample<R> {
        let (point, eye) = self.camera.hit(x, y);
        let normal = match &self.surface {
            Surface::Water(waves) => waves.normal(point),
            Surface::Plane(plane) => plane.normal(point),
        };
        let frame = Frame::around(normal);
        let (wo, wi) = (frame.to_local(eye), frame.to_local(self.light));
        Sample { wo, wi, half: half_vector(wo, wi) }
    }
}

/// A scene with its name, in both precisions.
pub(crate) struct Subject {
    /// Short, for tables.
    pub(crate) name: String,
    /// One sentence on what is seen.
    pub(crate) caption: String,
    pub(crate) size: Size,
    /// What the methods render: f32, as an engine would.
    pub(crate) engine: Scene<f32>,
    /// The same, for the reference.
    pub(crate) exact: Scene<f64>,
}

impl Subject {
    /// Waves at grazing view.
    pub(crate) fn water(size: Size) -> Self {
        let view = water::VIEW;
        let camera = Camera::spanning(size, view.top, view.bottom);
        let (waves, caption) = Waves::seen_by(&camera, size);
        Self::seen("water".into(), caption, size, &view, camera, Surface::Water(waves))
    }

    /// A plane with a normal map.
    pub(crate) fn plane(size: Size, map: &NormalMap) -> Self {
        let view = plane::VIEW;
        let camera = Camera::spanning(size, view.top, view.bottom);
        let (surface, caption) = MappedPlane::seen_by(&camera, size, map);
        let name = format!("plane: {}", map.name);
        Self::seen(name, caption, size, &view, camera, Surface::Plane(surface))
    }

    /// A surface under a view, in both precisions.
    fn seen(
        name: String,
        caption: String,
        size: Size,
        view: &View,
        camera: Camera<f64>,
        surface: Surface<f64>,
    ) -> Self {
        let light = view.light();
        let engine = Scene {
            camera: camera.cast(),
            light: light.map(|c| c as f32),
            surface: surface.cast(),
        };
        Self { name, caption, size, engine, exact: Scene { camera, light, surface } }
    }
}

/// Angles of a scene, in degrees over the plane.
struct View {
    /// Of the view at the picture's top and bottom edge.
    top: f64,
    bottom: f64,
    /// Of the light, straight ahead of the camera.
    light: f64,
}

impl View {
    /// Unit direction to the light.
    fn light(&self) -> [f64; 3] {
        let (sin, cos) = self.light.to_radians().sin_cos();
        [0.0, cos, sin]
    }
}
