//! Nanoseconds per pixel of every grid and of the closed form, one thread, in turns.

use std::hint::black_box;

use lobe::material::leadr::Shadowing;
use lobe::{Error, Lobe, Roughness};
use serde::Serialize;

use super::ball::Ball;
use super::closed::lit;
use super::rule::{Family, Pixel, Rule, Way};
use super::sky::Sky;
use crate::timing::in_turns;

/// Medians in nanoseconds per pixel.
#[derive(Serialize)]
pub(crate) struct Speed {
    pub(crate) grids: Vec<Clocked>,
    /// The lamp as a point, in closed form.
    pub(crate) closed: f64,
}

/// A grid's times.
#[derive(Serialize)]
pub(crate) struct Clocked {
    pub(crate) family: Family,
    pub(crate) count: usize,
    /// For each of [`Way::ALL`].
    pub(crate) times: [f64; 5],
}

/// Deviation of the slopes that is timed: nothing depends on it but what the lamps' exponentials
/// underflow to.
const SIGMA: f32 = 0.5;

/// Pixels along the sphere: as few as can be. The largest grid takes a millisecond for each, and a
/// pass should end before another process interrupts it.
const SIDE: usize = 2;

impl Speed {
    pub(super) fn measured(rules: &[Rule], rounds: usize) -> Result<Self, Error> {
        let lobe = Lobe::centered(Roughness::from_sigma_rho(SIGMA, SIGMA, 0.0)?);
        let ball = Ball { side: SIDE };
        let spots = ball.pixels().filter_map(|pixel| ball.spot(pixel));
        let pixels: Vec<_> = spots.map(|spot| Pixel { spot: spot.cast(), lobe }).collect();
        let (whole, lamp) = (Sky::whole().cast::<f32>(), Sky::lamp().cast::<f32>());

        let ways = Way::ALL.len();
        let times = in_turns(rules.len() * ways + 1, rounds, |task| {
            for pixel in &pixels {
                let (pixel, masking) = (black_box(pixel), Shadowing::MaskingOnly);
                match rules.get(task / ways) {
                    Some(rule) => {
                        let way = Way::ALL[task % ways];
                        black_box(rule.grid.shade(pixel, black_box(&whole), way, masking));
                    }
                    None => {
                        black_box(lit(pixel, black_box(&lamp), masking));
                    }
                }
            }
        });
        let per_pixel: Vec<_> = times.into_iter().map(|t| t / pixels.len() as f64).collect();
        let (grids, closed) = per_pixel.split_at(rules.len() * ways);
        let grids = rules.iter().zip(grids.chunks_exact(ways)).map(|(rule, times)| Clocked {
            family: rule.family,
            count: rule.count,
            times: std::array::from_fn(|way| times[way]),
        });
        Ok(Self { grids: grids.collect(), closed: closed.first().copied().unwrap_or_default() })
    }

    /// A grid's times.
    pub(crate) fn grid(&self, family: Family, count: usize) -> Option<&Clocked> {
        self.grids.iter().find(|grid| grid.family == family && grid.count == count)
    }
}

impl Clocked {
    pub(crate) fn time(&self, way: Way) -> f64 {
        self.times[way as usize]
    }
}
