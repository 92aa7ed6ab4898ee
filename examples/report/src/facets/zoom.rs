//! A zoom away from a ball: from facets that are seen one by one to a smooth highlight.

use lobe::Error;
use serde::Serialize;

use super::body::Body;
use super::method::{Derivatives, Filter, Method, Surface};
use super::reference::Reference;
use super::stage::{Normals, Stage};
use super::trial::picture;
use crate::camera::{Camera, Size};
use crate::metric::{Errors, scale};
use crate::vector::scaled;

/// Steps, each twice as far.
pub(crate) const STEPS: u32 = 8;

/// Facets in a pixel of the first step.
pub(crate) const FIRST: f64 = 2.0;

/// Of the facets from afar.
pub(crate) const ALPHA: f64 = 0.35;

/// Radius of the last ball over the picture's side.
const LAST: f64 = 0.42;

/// One step.
#[derive(Serialize)]
pub(crate) struct Frame {
    /// Facets in a pixel that faces the eye.
    pub(crate) facets: f64,
    /// Radius of the ball in pixels.
    pub(crate) radius: f64,
    /// Root mean square errors in means of the reference: without a filter, and with the box.
    pub(crate) errors: [f64; 2],
    /// The same two.
    #[serde(skip)]
    pub(crate) pictures: [Vec<f64>; 2],
}

/// All steps.
#[derive(Serialize)]
pub(crate) struct Zoom {
    pub(crate) size: Size,
    /// Of the references, per pixel.
    pub(crate) samples: u32,
    pub(crate) frames: Vec<Frame>,
}

impl Zoom {
    pub(super) fn seen(width: usize, side: u32) -> Result<Self, Error> {
        let size = Size { width, height: width };
        let steps = (0..STEPS).map(|step| Frame::of(size, step, side));
        Ok(Self { size, samples: side * side, frames: steps.collect::<Result<_, _>>()? })
    }
}

impl Frame {
    fn of(size: Size, step: u32, side: u32) -> Result<Self, Error> {
        let radius = LAST * size.width as f64 * f64::from(1 << (STEPS - 1 - step));
        let facets = FIRST * 4.0_f64.powi(step.try_into().unwrap_or(0));
        // One surface: its coordinates stay, and pixels grow.
        let stage = Stage { unit: f64::from(1 << step), ..stage(size, radius) };
        let surface = Surface::new(ALPHA, FIRST)?;
        let Reference { radiance, judged, .. } = Reference::of(&stage, &surface, side);
        let scale = scale(&radiance, &judged);
        let shown = [Filter::None, Filter::Box(Derivatives::Disk)].map(|filter| {
            let method = Method { name: "", filter, normals: Normals::Mean, side: 1 };
            let picture = picture(&stage, &surface, &method);
            let single: Vec<_> = picture.iter().map(|&x| x as f32).collect();
            (Errors::of(&single, &radiance, &judged, scale).rmse, picture)
        });
        let [(none, unfiltered), (filter, filtered)] = shown;
        Ok(Self { facets, radius, errors: [none, filter], pictures: [unfiltered, filtered] })
    }
}

/// A ball of this radius in pixels, the highlight in the middle of the picture.
fn stage(size: Size, radius: f64) -> Stage {
    let light = lobe::slope::direction::normalize([0.35, -0.9, 0.3]);
    let front = [0.0, -1.0, 0.0];
    // Where the normal is half way between light and eye, drawn towards the middle as the ball gets
    // whole.
    let bright = lobe::slope::direction::half_vector(front, light);
    let share = 1.0 - size.width as f64 * LAST / radius;
    let target = scaled(share * radius, bright);
    let distance = 8.0 * radius.max(size.width as f64);
    let eye = [target[0], target[1] - distance, target[2]];
    Stage {
        size,
        camera: Camera::looking(size, eye, target, distance),
        body: Body::ball(radius),
        lights: vec![light],
        fibers: None,
        unit: 1.0,
    }
}
