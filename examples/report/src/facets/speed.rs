//! Nanoseconds per pixel, one thread, all methods in turns.

use std::hint::black_box;

use lobe::Error;

use super::method::{Method, Surface};
use super::stage::{Seen, Stage};
use super::trial::{Setting, seen};
use crate::timing::in_turns;

/// How much is timed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Load {
    pub(super) pixels: usize,
    pub(super) rounds: usize,
}

/// Medians of shading a pixel in f32 for each method, from directions, patch and derivatives that
/// are there: what rays and differences take is the same for all and left out.
pub(super) fn times(
    stage: &Stage,
    methods: &[Method],
    setting: &Setting,
    judged: &[bool],
    load: Load,
) -> Result<Vec<f64>, Error> {
    let surface = Surface::<f32>::new(setting.alpha, setting.facets)?;
    // Spread over the picture.
    let hit: Vec<_> = (0..judged.len()).filter(|&index| judged[index]).collect();
    let every = (hit.len() / load.pixels.max(1)).max(1);
    let pixels: Vec<_> = hit.into_iter().step_by(every).take(load.pixels).collect();
    let prepared = methods.iter().map(|method| {
        let pixels = pixels.iter().map(|&index| {
            seen(stage, method, index).iter().map(Seen::cast).collect::<Result<Vec<_>, _>>()
        });
        pixels.collect::<Result<Vec<_>, _>>()
    });
    let prepared = prepared.collect::<Result<Vec<_>, _>>()?;
    let times = in_turns(methods.len(), load.rounds, |task| {
        for seen in &prepared[task] {
            black_box(black_box(&surface).sum(methods[task].filter, black_box(seen)));
        }
    });
    Ok(times.into_iter().map(|time| time / pixels.len().max(1) as f64).collect())
}
