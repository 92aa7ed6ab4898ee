//! Minified normal maps: what a texture holds of what a pixel no longer resolves.
//!
//! A renderer of its own, as methods look up textures here: a plane in its tangent frame, a
//! perspective view of it, the light's mirror image at the picture's middle. The truth is the
//! supersampled normal map, which is LEAN's own.

mod clock;
mod ground;
mod lean;
mod method;
mod panel;
mod reference;
mod technique;
mod texels;
mod view;
mod zoom;

use lobe::{Error, Footprint};
use serde::Serialize;

use crate::camera::Size;
use crate::light::LightKind;
use crate::method::Distribution;
use crate::scene::NormalMap;
use ground::Ground;
use panel::Making;
use reference::Strata;
use texels::Texels;
use view::{Station, View};

pub(crate) use method::{all as methods, name};
pub(crate) use panel::{Panel, Row};
pub(crate) use texels::{STEEPEST, moments};
pub(crate) use view::TURN;
pub(crate) use zoom::{Track, Zoom};

/// Texels per pixel of the sweep, and the view's elevation in it, in degrees.
pub(crate) const RATIOS: [f64; 7] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0];
pub(crate) const SWEPT: f64 = 45.0;

/// Elevations that are compared, in degrees, and texels per pixel across the view there.
pub(crate) const ELEVATIONS: [f64; 4] = [90.0, SWEPT, 15.0, 5.0];
pub(crate) const GRAZED: f64 = 4.0;

/// The ratios whose pictures are shown.
pub(crate) const SHOWN: [f64; 2] = [4.0, 32.0];

/// How much work minification is.
#[derive(Clone)]
pub(crate) struct Plan {
    pub(crate) size: Size,
    /// One or two.
    pub(crate) alphas: Vec<f64>,
    pub(crate) light: LightKind,
    /// Strata on a pixel's axes in each half of a reference, at least.
    pub(crate) fewest: u32,
    /// Of timing.
    pub(crate) rounds: usize,
    /// Of the zoom.
    pub(crate) frames: usize,
}

impl Plan {
    /// Steps of progress that one map reports.
    pub(crate) fn steps(&self) -> u64 {
        ((stations().count() + self.frames) * self.size.height) as u64
    }

    fn motion(&self, texels: &Texels) -> f64 {
        let view = View::from(&self.station(texels, SWEPT, RATIOS[0]));
        let spot = view.spot([self.size.width, self.size.height].map(|side| 0.5 * side as f64));
        let Footprint { u, v } = view.footprint(&spot, &view.steps(&spot));
        u[0].hypot(u[1]).max(v[0].hypot(v[1]))
    }

    fn station(&self, texels: &Texels, elevation: f64, ratio: f64) -> Station {
        let map = texels.slopes.size();
        Station { size: self.size, elevation, ratio, light: self.light, map }
    }
}

/// Elevation and ratio of every view: the sweep, then what it does not hold of the comparison of
/// elevations.
fn stations() -> impl Iterator<Item = (f64, f64)> {
    let grazing = ELEVATIONS.into_iter().filter(|&elevation| elevation != SWEPT);
    RATIOS.into_iter().map(|ratio| (SWEPT, ratio)).chain(grazing.map(|e| (e, GRAZED)))
}

/// What was measured of one map.
#[derive(Serialize)]
pub(crate) struct Minified {
    pub(crate) name: String,
    /// In texels.
    pub(crate) map: [usize; 2],
    pub(crate) size: Size,
    pub(crate) light: LightKind,
    /// Standard deviation of the slopes, both axes together.
    pub(crate) deviation: f64,
    /// Of the slopes: 3 of a Gaussian.
    pub(crate) kurtosis: f64,
    /// The part of the texels that were steeper than the cap.
    pub(crate) clipped: f64,
    /// How far the half vector's slope moves over a pixel in the middle of the sweep's pictures.
    pub(crate) motion: f64,
    /// By view, then alpha, then distribution.
    pub(crate) panels: Vec<Panel>,
    pub(crate) zoom: Zoom,
}

impl Minified {
    /// Renders, measures and compares; calls `progress` with the steps done.
    pub(crate) fn run(
        map: &NormalMap,
        plan: &Plan,
        progress: &(impl Fn(u64) + Sync),
    ) -> Result<Self, Error> {
        let texels = Texels::of(&map.texture)?;
        let methods = methods();
        let row_done = || progress(1);
        let mut panels = Vec::new();
        for (elevation, ratio) in stations() {
            let station = plan.station(&texels, elevation, ratio);
            let view = View::from(&station);
            let strata = Strata::of(&station, plan.fewest);
            let references = reference::render(&texels, &station, &plan.alphas, strata, &row_done)?;
            for (index, &alpha) in plan.alphas.iter().enumerate() {
                let first = index == 0;
                let making = Making {
                    station: &station,
                    ground: &Ground::new(&texels, &view, alpha)?,
                    methods: &methods,
                    alpha,
                    rounds: if first { plan.rounds } else { 0 },
                    shown: first && elevation == SWEPT && SHOWN.contains(&ratio),
                };
                panels.extend(Distribution::ALL.map(|distribution| {
                    let reference = references.of(index, distribution);
                    making.panel(distribution, reference, references.samples)
                }));
            }
        }
        let [deviation, kurtosis] = texels.spread();
        Ok(Self {
            name: map.name.clone(),
            map: texels.slopes.size(),
            size: plan.size,
            light: plan.light,
            deviation,
            kurtosis,
            clipped: texels.clipped,
            motion: plan.motion(&texels),
            panels,
            zoom: Zoom::run(&texels, &methods, plan, &row_done)?,
        })
    }

    /// The panels of a distribution at an alpha over a set of views.
    pub(crate) fn of(
        &self,
        distribution: Distribution,
        alpha: f64,
    ) -> impl Iterator<Item = &Panel> + Clone {
        let asked =
            move |panel: &&Panel| panel.distribution == distribution && panel.alpha == alpha;
        self.panels.iter().filter(asked)
    }

    /// The first alpha.
    pub(crate) fn alpha(&self) -> f64 {
        self.panels.first().map_or(f64::NAN, |panel| panel.alpha)
    }
}

#[cfg(test)]
mod tests;
