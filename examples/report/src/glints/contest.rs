//! Error against run time: how far the pixels of a model are distributed from those of real
//! details, and what they cost.

use std::hint::black_box;

use lobe::Error;
use lobe::slope::direction::normalize;
use serde::Serialize;

use super::material::{Material, snow};
use super::model::{Made, Model, Seen};
use super::moments::{Moments, distance};
use super::points::Points;
use super::sample::{Light, Pixel, Setting};
use super::speed::Load;
use crate::timing::in_turns;

/// Details in a pixel.
const DETAILS: [f64; 2] = [1e3, 1e5];

/// Of the pixels: a floor seen from above, and as low as pixels may be long.
const ASPECTS: [f64; 2] = [1.0, 16.0];

/// The models that take part.
const MODELS: [Model; 4] = [Model::Smooth, Model::Default, Model::Four, Model::Published];

/// A part of the details stands for all: one in a thousand and so on.
const SHARES: [f64; 4] = [1e-3, 1e-2, 1e-1, 1.0];

/// One number of details in one kind of pixels.
#[derive(Debug, Serialize)]
pub(crate) struct Contest {
    pub(crate) aspect: f64,
    pub(crate) details: f64,
    /// Distance of two samples of real details: nothing less can be seen.
    pub(crate) noise: f64,
    /// Relative variance of real details.
    pub(crate) truth: f64,
    pub(crate) models: Vec<Entry>,
    /// Details one by one; fewer of them, each brighter, before all of them.
    pub(crate) points: Vec<Entry>,
}

impl Contest {
    /// What a model has come to.
    pub(crate) fn of(&self, model: Model) -> Option<&Entry> {
        self.models.iter().find(|entry| entry.model == Some(model))
    }
}

/// One way to shade a pixel.
#[derive(Debug, Serialize)]
pub(crate) struct Entry {
    /// None of points.
    pub(crate) model: Option<Model>,
    /// As many as there are, of points fewer.
    pub(crate) details: f64,
    /// Nanoseconds per pixel.
    pub(crate) time: f64,
    /// Mean distance of its pixels' distribution from that of real details, in means.
    pub(crate) distance: f64,
    pub(crate) mean: f64,
    /// Relative variance over that of real details.
    pub(crate) variance: f64,
}

/// Every number of details in every kind of pixels.
pub(super) fn contests(pixels: u64, load: Load) -> Result<Vec<Contest>, Error> {
    let mut contests = Vec::new();
    for details in DETAILS {
        let truth = Truth::of(details, pixels);
        for aspect in ASPECTS {
            contests.push(truth.contest(aspect, load)?);
        }
    }
    Ok(contests)
}

/// At the pole, under a point light.
fn setting(material: &Material, aspect: f64) -> Setting<'_> {
    Setting { material, aspect, half: 0.0, light: Light::Point, octave: None }
}

/// Real details in pixels, whatever their shape.
struct Truth {
    material: Material,
    values: Vec<f64>,
    noise: f64,
    variance: f64,
    /// Of each of [`SHARES`].
    parts: [Vec<f64>; 4],
}

impl Truth {
    fn of(details: f64, pixels: u64) -> Self {
        let material = snow("", details);
        let of = |share: f64, seed: u64| {
            let part = material.with_details(share * details);
            setting(&part, 1.0).true_ratios(pixels, seed)
        };
        let values = of(1.0, 1);
        Self {
            material,
            noise: distance(&of(1.0, 2), &values),
            variance: setting(&material, 1.0).true_variance(1),
            parts: SHARES.map(|share| of(share, 3)),
            values,
        }
    }

    fn contest(&self, aspect: f64, load: Load) -> Result<Contest, Error> {
        let details = self.material.details;
        let times = times(&self.material, aspect, load)?;
        let (models, brute) = times.split_at(MODELS.len());
        let setting = setting(&self.material, aspect);
        let pixels = self.values.len() as u64;
        let models = MODELS.iter().zip(models).map(|(&model, &time)| {
            Ok(self.entry(Some(model), details, time, &setting.ratios(model, pixels)?))
        });
        let points = SHARES.iter().zip(&self.parts).zip(brute);
        let points = points
            .map(|((share, part), &time)| self.entry(None, share * details, time, part))
            .collect();
        Ok(Contest {
            aspect,
            details,
            noise: self.noise,
            truth: self.variance,
            models: models.collect::<Result<_, Error>>()?,
            points,
        })
    }

    fn entry(&self, model: Option<Model>, details: f64, time: f64, values: &[f64]) -> Entry {
        let moments = Moments::of(values);
        Entry {
            model,
            details,
            time,
            distance: distance(values, &self.values),
            mean: moments.mean,
            variance: moments.variance / self.variance,
        }
    }
}

/// Details that a pass goes through, at least one pixel's.
const PER_PASS: f64 = 1e4;

/// Nanoseconds per pixel of [`MODELS`] and of [`SHARES`].
fn times(material: &Material, aspect: f64, load: Load) -> Result<Vec<f64>, Error> {
    // Between two sizes of cells.
    let pixels: Vec<_> = (0..load.pixels).map(|i| Pixel::random(aspect, Some(0.5), i)).collect();
    let area = pixels.first().map_or(1.0, |pixel| pixel.area);
    let made = Made::<f32>::new(material, area, 0)?;
    // Half vectors at the pole; see `ELEVATIONS` for why no direction is.
    let [wo, wi] = [0.5, -0.5].map(|x| normalize([x, 0.0, 1.0]));
    let seen = |pixel: &Pixel| Seen { patch: pixel.patch, wo, wi, radius: 0.0 }.cast();
    let seen: Vec<Seen<f32>> = pixels.iter().map(seen).collect();
    let points = SHARES.map(|share| {
        let details = share * material.details;
        let count = (PER_PASS / details).clamp(1.0, load.pixels as f64);
        // Not negative, few.
        #[allow(clippy::cast_sign_loss)]
        let count = count as usize;
        (Points::new(material, details / area, 0), count)
    });
    let mut times = in_turns(MODELS.len() + SHARES.len(), load.rounds, |task| {
        if let Some(&model) = MODELS.get(task) {
            for pixel in &seen {
                black_box(black_box(&made).brdf(model, black_box(pixel)));
            }
        } else {
            let (surface, count) = &points[task - MODELS.len()];
            for pixel in &pixels[..*count] {
                black_box(surface.slope_pdf(black_box(&pixel.patch), [0.0; 2]));
            }
        }
    });
    let counts =
        [seen.len(); MODELS.len()].into_iter().chain(points.iter().map(|(_, count)| *count));
    for (time, count) in times.iter_mut().zip(counts) {
        *time /= count.max(1) as f64;
    }
    Ok(times)
}
