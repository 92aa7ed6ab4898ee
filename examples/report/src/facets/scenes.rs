//! The scenes of the comparison: a bent tube, and with a normal map beads and a ball.

use lobe::Error;
use lobe::slope::direction::normalize;

use super::Plan;
use super::body::Body;
use super::fibers::Fibers;
use super::method::{FILTERS, MAPPINGS};
use super::speed::Load;
use super::stage::Stage;
use super::trial::{Setting, Trial};
use crate::camera::{Camera, Size};
use crate::scene::combed_map;
use crate::vector::Vector;

/// Diameter and radius of the tube, and of the beads, in pixels.
pub(super) const DIAMETER: usize = 24;
pub(crate) const RADIUS: f64 = 0.5 * DIAMETER as f64;

/// Radii of the ring and of the ball over the picture's height.
const RING: f64 = 0.36;
const BALL: f64 = 0.46;

/// Texels in a pixel, along either side, where the ball faces the eye; and where the beads do: few
/// enough that half vectors move by more than the map spreads them.
pub(crate) const TEXELS: f64 = 8.0;
pub(crate) const BEAD_TEXELS: f64 = 1.0;

/// Roughness and facets in a pixel of tube and beads: half vectors move by a deviation and more in
/// a pixel, as they do where highlights are filtered at all, and no single glint decides over the
/// error. Others are in `sweep`.
const BENT_ALPHA: f64 = 0.1;
const BENT_FACETS: f64 = 1e4;

/// Roughness and facets in a pixel of the ball: its normal map widens a narrow lobe, and a pixel
/// has as many facets as one of a surface far away.
const BALL_ALPHA: f64 = 0.12;
const BALL_FACETS: f64 = 1e5;

/// Distance of the eye, in widths of the picture.
const FAR: f64 = 5.0;

fn stage(width: usize, body: Body, lights: &[Vector<f64>], fibers: Option<Fibers>) -> Stage {
    let size = Size::of_width(width);
    let distance = FAR * width as f64;
    let lights = lights.iter().map(|&light| normalize(light)).collect();
    let camera = Camera::looking(size, [0.0, -distance, 0.0], [0.0; 3], distance);
    Stage { size, camera, body, lights, fibers, unit: 1.0 }
}

fn setting(plan: &Plan, alpha: f64, facets: f64) -> Setting {
    let load = Load { pixels: plan.timed, rounds: plan.rounds };
    Setting { alpha, facets, side: plan.side, load }
}

/// The tube under two lights, one from the upper right, one from the left.
pub(super) fn bent(width: usize) -> Stage {
    let ring = (RING * Size::of_width(width).height as f64).max(1.6 * RADIUS);
    let lights = [[0.6, -0.5, 0.7], [-0.8, -0.6, 0.2]];
    stage(width, Body::tube(ring, RADIUS), &lights, None)
}

/// All filters on it.
pub(super) fn tube(plan: &Plan) -> Result<Trial, Error> {
    Trial::of(&bent(plan.width), &FILTERS, &setting(plan, BENT_ALPHA, BENT_FACETS))
}

/// Under one light from the upper right, with a map of this many texels in a pixel.
fn mapped(width: usize, body: Body, texels: f64) -> Result<Stage, String> {
    let map = combed_map()?;
    let fibers = Fibers::of(&map.texture, texels).map_err(|error| error.to_string())?;
    Ok(stage(width, body, &[[0.5, -0.7, 0.5]], Some(fibers)))
}

/// The beads: curvature as the tube's, and the map.
pub(super) fn beads(plan: &Plan) -> Result<Trial, String> {
    let stage = mapped(plan.width, Body::beads(RADIUS), BEAD_TEXELS)?;
    let setting = setting(plan, BENT_ALPHA, BENT_FACETS);
    Trial::of(&stage, &MAPPINGS, &setting).map_err(|error| error.to_string())
}

/// The ball: the map, and hardly any curvature.
pub(super) fn ball(plan: &Plan) -> Result<Trial, String> {
    let radius = BALL * Size::of_width(plan.width).height as f64;
    let stage = mapped(plan.width, Body::ball(radius), TEXELS)?;
    let setting = setting(plan, BALL_ALPHA, BALL_FACETS);
    Trial::of(&stage, &MAPPINGS, &setting).map_err(|error| error.to_string())
}
