//! How much brighter sizes that vary make a material.

use lobe::Error;
use lobe::material::cells::Patch;
use lobe::material::glint::{Glints, ZirrKaplanyan};
use rayon::prelude::*;
use serde::Serialize;

use super::material::Material;
use super::moments::Moments;

/// Variations, the last as in the published snow, and details in a cell.
const VARIATIONS: [f64; 3] = [0.3, 1.0, 100.0];
const NUMBERS: [f64; 3] = [1.0, 10.0, 1000.0];

/// Most that the default model allows.
const MOST: f64 = 4.0;

/// Pixels of one cell at the pole under a point light.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Gain {
    pub(crate) variation: f64,
    /// Details in a cell.
    pub(crate) details: f64,
    /// Over the smooth lobe.
    pub(crate) published: Moments,
    /// With as much variation as there may be.
    pub(crate) default: Moments,
}

/// Every variation on every number of details, on `count` cells each.
pub(super) fn gains(count: u32) -> Result<Vec<Gain>, Error> {
    let pairs = VARIATIONS.iter().flat_map(|&v| NUMBERS.map(|n| (v, n)));
    pairs
        .zip(0..)
        .map(|((variation, details), seed)| Gain::of(variation, details, count, seed))
        .collect()
}

impl Gain {
    pub(super) fn of(variation: f64, details: f64, count: u32, seed: u32) -> Result<Self, Error> {
        // Details wide enough to be met often.
        let material = Material { name: "", alpha: 0.6, fractions: [0.1; 2], details };
        let biscale = material.biscale::<f64>()?;
        let mut published = ZirrKaplanyan::new(biscale, details)?;
        published.variation = variation;
        let glints =
            Glints::new(biscale, details)?.with_variation(variation.min(MOST))?.with_seed(seed);
        let pole = [0.0, 0.0, 1.0];
        let smooth = 1.0 / (std::f64::consts::PI * material.alpha * material.alpha);
        // Odd places: published cells whose index is even have another's numbers.
        let cell = |k: u32| {
            let uv = [k % 1000, k / 1000].map(|x| f64::from(2 * x + 1));
            Patch::new(uv, [1.0, 0.0], [0.0, 1.0])
        };
        let over = |value: &(dyn Fn(&Patch<f64>) -> f64 + Sync)| {
            let values: Vec<_> = (0..count).into_par_iter().map(|k| value(&cell(k))).collect();
            Moments::of(&values)
        };
        Ok(Self {
            variation,
            details,
            published: over(&|patch| published.d(patch, pole, 1.0, 0.0) / smooth),
            default: over(&|patch| glints.ndf(patch).sparkle(pole, 0.0)),
        })
    }
}
