//! Glints: cells, run time, mean and variance of both models, against real details.
//!
//! Details are points of a random process on a plane, each a Gaussian lobe (`truth`, and one by one
//! in `points`): what a biscale material is, so that single pixels of it and of a model are two
//! draws, and only their distributions compare.

mod cells;
mod contest;
mod count;
mod errors;
mod gain;
mod hall;
mod material;
mod model;
mod moments;
mod points;
mod ripple;
mod sample;
mod speed;
mod truth;

use lobe::Error;
use serde::Serialize;

pub(crate) use cells::Visited;
pub(crate) use contest::{Contest, Entry};
pub(crate) use count::{Instructions, PerCell};
pub(crate) use errors::Judged;
pub(crate) use gain::Gain;
pub(crate) use hall::Hall;
pub(crate) use model::Model;
pub(crate) use moments::Moments;
pub(crate) use ripple::Ripple;
pub(crate) use sample::{ASPECTS, HALVES, Light};
pub(crate) use speed::Speed;

/// How much work.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    /// Of the picture.
    pub(crate) width: usize,
    /// For each aspect, where cells are counted.
    pub(crate) shapes: u64,
    /// For each kind, where mean and variance are measured, and distributions.
    pub(crate) pixels: u64,
    pub(crate) contest: u64,
    /// Cells for each variation of sizes.
    pub(crate) cells: u32,
    /// Pixels and rounds of timing.
    pub(crate) timed: u64,
    pub(crate) rounds: usize,
}

impl Plan {
    /// Of a full run.
    pub(crate) fn full() -> Self {
        Self {
            width: 560,
            shapes: 4096,
            pixels: 20_000,
            contest: 40_000,
            cells: 400_000,
            timed: 256,
            rounds: 41,
        }
    }

    /// Of a quick one.
    pub(crate) fn quick() -> Self {
        Self {
            width: 240,
            shapes: 256,
            pixels: 1200,
            contest: 2000,
            cells: 10_000,
            timed: 64,
            rounds: 9,
        }
    }
}

/// What `done` counts to, whatever the plan.
pub(crate) fn steps() -> u64 {
    errors::kinds()
}

/// All that was measured.
#[derive(Serialize)]
pub(crate) struct Glitter {
    /// Pixels for each kind, and cells for each variation.
    pub(crate) pixels: u64,
    pub(crate) cells: u32,
    pub(crate) visited: Vec<Visited>,
    pub(crate) speed: Speed,
    pub(crate) operations: Vec<PerCell>,
    pub(crate) instructions: Instructions,
    pub(crate) judged: Vec<Judged>,
    pub(crate) gains: Vec<Gain>,
    pub(crate) ripples: Vec<Ripple>,
    pub(crate) contests: Vec<Contest>,
    #[serde(skip)]
    pub(crate) hall: Hall,
}

impl Glitter {
    pub(crate) fn measured(plan: &Plan, done: &impl Fn()) -> Result<Self, String> {
        let instructions = Instructions::counted()?;
        Self::with(plan, instructions, done).map_err(|error| error.to_string())
    }

    fn with(plan: &Plan, instructions: Instructions, done: &impl Fn()) -> Result<Self, Error> {
        let load = speed::Load { pixels: plan.timed, rounds: plan.rounds };
        let speed = Speed::measured(load)?;
        Ok(Self {
            pixels: plan.pixels,
            cells: plan.cells,
            visited: cells::visited(plan.shapes)?,
            speed,
            operations: count::per_cell()?,
            instructions,
            judged: errors::judged(plan.pixels, done)?,
            gains: gain::gains(plan.cells)?,
            ripples: ripple::ripples(plan.pixels)?,
            contests: contest::contests(plan.contest, load)?,
            hall: Hall::seen(plan.width)?,
        })
    }
}

#[cfg(test)]
mod tests;
