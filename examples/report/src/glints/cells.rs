//! How many cells a pixel asks by its shape, and what published loops leave out.

use lobe::Error;
use lobe::material::cells::Patch;
use rayon::prelude::*;
use serde::Serialize;

use super::material::snow;
use super::model::Made;
use super::sample::Pixel;

/// Pixels of one aspect, at random places, turned by anything.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Visited {
    pub(crate) aspect: f64,
    /// Cells of the default model: mean and most.
    pub(crate) default: [f64; 2],
    /// Of the published one.
    pub(crate) published: [f64; 2],
    /// Share of the pixel that the published loops do not reach: mean and most.
    pub(crate) lost: [f64; 2],
}

/// Steps of the aspect per octave, and octaves.
const STEPS: u32 = 4;
const OCTAVES: u32 = 6;

/// Aspects from 1 to 64, each on `count` pixels.
pub(super) fn visited(count: u64) -> Result<Vec<Visited>, Error> {
    let aspects = (0..=STEPS * OCTAVES).map(|k| f64::exp2(f64::from(k) / f64::from(STEPS)));
    aspects.map(|aspect| Visited::of(aspect, count)).collect()
}

impl Visited {
    pub(super) fn of(aspect: f64, count: u64) -> Result<Self, Error> {
        // Far more details than cells: none is as small as a detail.
        let made = Made::<f64>::new(&snow("", 1e6), 1.0, 0)?;
        let pixels: Vec<_> = (0..count)
            .into_par_iter()
            .map(|index| {
                let patch = Pixel::random(aspect, None, index).patch;
                let (default, published) = (whole(&made, &patch), cut(&made, &patch));
                [default, published[0], published[1]]
            })
            .collect();
        let over = |k: usize| {
            let values = || pixels.iter().map(|pixel| pixel[k]);
            [values().sum::<f64>() / count as f64, values().fold(0.0, f64::max)]
        };
        Ok(Self { aspect, default: over(0), published: over(1), lost: over(2) })
    }
}

/// Cells of the default model.
pub(super) fn whole(made: &Made<f64>, patch: &Patch<f64>) -> f64 {
    let mut cells = 0_u32;
    made.glints.ndf(patch).grid().visit(|_| cells += 1);
    f64::from(cells)
}

/// Cells of the published one, and the share of the pixel that they leave out.
pub(super) fn cut(made: &Made<f64>, patch: &Patch<f64>) -> [f64; 2] {
    let (mut cells, mut seen) = (0_u32, 0.0);
    made.published.visit(patch, |cell| {
        cells += 1;
        seen += cell.share;
    });
    [f64::from(cells), (1.0 - seen).max(0.0)]
}
