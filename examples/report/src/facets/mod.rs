//! Facets: filters of half vectors and of normal maps, for surfaces of many lobes in a pixel.
//!
//! After Chermain et al. 2021. On a bent tube half vectors differ over a pixel, on a ball the
//! normals of a map, on beads both. Here one surface has one truth, the mean over many points of a
//! pixel, so single pixels compare.

mod body;
mod dictionary;
mod fibers;
mod lobes;
mod memory;
mod method;
mod reference;
mod scenes;
mod speed;
mod stage;
mod sweep;
mod trial;
mod zoom;

use serde::Serialize;

pub(crate) use fibers::ASKEW;
pub(crate) use lobes::{CORRELATIONS, COUNTS, Lobes, Shown};
pub(crate) use memory::Memory;
pub(crate) use method::{Filter, name};
pub(crate) use scenes::{BEAD_TEXELS, RADIUS, TEXELS};
pub(crate) use sweep::{SWEPT, Swept};
pub(crate) use trial::{Entry, SURE, Trial};
pub(crate) use zoom::{Frame, Zoom};

/// How much work.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    /// Of the pictures.
    pub(crate) width: usize,
    /// Points of the reference along either side of a pixel.
    pub(crate) side: u32,
    /// The same of a zoom, and the side of its pictures.
    pub(crate) zoom_side: u32,
    pub(crate) zoom: usize,
    /// Of pictures over roughness and facets: their width, and points along either side.
    pub(crate) sweep: usize,
    pub(crate) sweep_side: u32,
    /// Of the pictures of lobes.
    pub(crate) lobes: usize,
    /// Pixels and rounds of timing.
    pub(crate) timed: usize,
    pub(crate) rounds: usize,
}

impl Plan {
    /// The least width of a picture: all of the tube's and of the beads'. A narrower one shows no
    /// highlight.
    pub(crate) const LEAST_WIDTH: usize = scenes::DIAMETER;

    /// Of a full run.
    pub(crate) fn full() -> Self {
        Self {
            width: 320,
            side: 32,
            zoom_side: 8,
            zoom: 128,
            sweep: 320,
            sweep_side: 8,
            lobes: 128,
            timed: 256,
            rounds: 41,
        }
    }

    /// Of a quick one.
    pub(crate) fn quick() -> Self {
        Self {
            width: 160,
            side: 8,
            zoom_side: 4,
            zoom: 64,
            sweep: 128,
            sweep_side: 5,
            lobes: 64,
            timed: 64,
            rounds: 9,
        }
    }
}

/// What `done` counts to, whatever the plan.
pub(crate) fn steps() -> u64 {
    6
}

/// All that was measured.
#[derive(Serialize)]
pub(crate) struct Facets {
    pub(crate) tube: Trial,
    pub(crate) sweep: Vec<Swept>,
    pub(crate) beads: Trial,
    pub(crate) ball: Trial,
    pub(crate) lobes: Lobes,
    pub(crate) zoom: Zoom,
    pub(crate) memory: Memory,
}

impl Facets {
    pub(crate) fn measured(plan: &Plan, done: &impl Fn()) -> Result<Self, String> {
        let error = |error: lobe::Error| error.to_string();
        let tube = scenes::tube(plan).map_err(error)?;
        done();
        let sweep = sweep::swept(plan.sweep, plan.sweep_side).map_err(error)?;
        done();
        let beads = scenes::beads(plan)?;
        done();
        let ball = scenes::ball(plan)?;
        done();
        let zoom = Zoom::seen(plan.zoom, plan.zoom_side).map_err(error)?;
        done();
        let lobes = Lobes::seen(plan.lobes).map_err(error)?;
        done();
        let memory = Memory::counted().map_err(error)?;
        Ok(Self { tube, sweep, beads, ball, lobes, zoom, memory })
    }
}

#[cfg(test)]
mod tests;
