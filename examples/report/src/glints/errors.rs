//! Mean and variance of both models against what they should be, kind of pixel by kind of pixel.

use lobe::Error;
use serde::Serialize;

use super::material::{MATERIALS, Material};
use super::model::Model;
use super::moments::Moments;
use super::sample::{ASPECTS, HALVES, Light, Setting};

/// One kind of pixels.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Judged {
    pub(crate) material: &'static str,
    pub(crate) aspect: f64,
    /// Slope of the half vector in alphas.
    pub(crate) half: f64,
    pub(crate) light: Light,
    /// That a detail reflects.
    pub(crate) probability: f64,
    /// Details that reflect in a pixel, in the mean.
    pub(crate) reflecting: f64,
    /// Pixels that were looked at.
    pub(crate) pixels: u64,
    /// Relative variance of real details.
    pub(crate) truth: f64,
    /// Of the default model by its own law: levels that draw independently, and together.
    pub(crate) law: [f64; 2],
    pub(crate) default: Moments,
    pub(crate) published: Moments,
}

/// Fewer pixels with a detail that reflects say nothing about variance.
const FEWEST: f64 = 100.0;

impl Judged {
    fn of(
        material: &Material,
        aspect: f64,
        half: f64,
        light: Light,
        pixels: u64,
    ) -> Result<Self, Error> {
        let setting = Setting { material, aspect, half, light, octave: None };
        let probability = setting.probability()?;
        let [default, published] =
            [Model::Default, Model::Published].map(|m| setting.ratios(m, pixels));
        Ok(Self {
            material: material.name,
            aspect,
            half,
            light,
            probability,
            reflecting: probability * material.details,
            pixels,
            truth: setting.true_variance(pixels),
            law: setting.law(pixels.min(4000))?,
            default: Moments::of(&default?),
            published: Moments::of(&published?),
        })
    }

    /// Whether there were enough details that reflect to know the variance.
    pub(crate) fn is_sure(&self) -> bool {
        self.reflecting * self.pixels as f64 > FEWEST
    }
}

/// Kinds that [`judged`] looks at.
pub(super) fn kinds() -> u64 {
    (MATERIALS.len() * ASPECTS.len() * HALVES.len() * Light::ALL.len()) as u64
}

/// All materials, half vectors, aspects and lights, in that order of loops.
pub(super) fn judged(pixels: u64, done: &impl Fn()) -> Result<Vec<Judged>, Error> {
    let mut all = Vec::new();
    for material in &MATERIALS {
        for half in HALVES {
            for aspect in ASPECTS {
                for light in Light::ALL {
                    all.push(Judged::of(material, aspect, half, light, pixels)?);
                    done();
                }
            }
        }
    }
    Ok(all)
}
