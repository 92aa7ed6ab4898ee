//! How much a pixel varies against what it should, over its width between two sizes of cells.

use lobe::Error;
use serde::Serialize;

use super::material::snow;
use super::model::Model;
use super::moments::Moments;
use super::sample::{ASPECTS, Light, Setting};

/// A model at one aspect.
#[derive(Serialize)]
pub(crate) struct Ripple {
    pub(crate) model: Model,
    pub(crate) aspect: f64,
    /// Width against a power of two, relative variance over that of real details, and its standard
    /// error.
    pub(crate) points: Vec<[f64; 3]>,
}

/// Widths per octave.
const STEPS: u32 = 12;

/// Of many details, so that samples tell variances well: `count` pixels for each width.
pub(super) fn ripples(count: u64) -> Result<Vec<Ripple>, Error> {
    let material = snow("", 1e5);
    let kinds = ASPECTS.map(|aspect| (Model::Default, aspect));
    let one = |(model, aspect): (Model, f64)| {
        let at = |step: u32| {
            let octave = f64::from(step) / f64::from(STEPS);
            // The last width is the first of the next octave: cells twice as large.
            let setting = Setting {
                material: &material,
                aspect,
                half: 0.0,
                light: Light::Point,
                octave: Some(octave),
            };
            let moments = Moments::of(&setting.ratios(model, count)?);
            let truth = setting.true_variance(1);
            let ratios = [moments.variance, moments.variance_error].map(|x| x / truth);
            Ok([f64::exp2(octave), ratios[0], ratios[1]])
        };
        Ok(Ripple { model, aspect, points: (0..=STEPS).map(at).collect::<Result<_, Error>>()? })
    };
    kinds.into_iter().chain([(Model::Published, 1.0)]).map(one).collect()
}
