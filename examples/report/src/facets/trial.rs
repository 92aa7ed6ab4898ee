//! All methods on one stage: pictures, errors, times.

use lobe::Error;
use rayon::prelude::*;
use serde::Serialize;

use super::method::{Filter, Method, Surface};
use super::reference::Reference;
use super::speed::{Load, times};
use super::stage::{Normals, Seen, Stage};
use crate::camera::Size;
use crate::metric::{Errors, scale};

/// One method's errors and time.
#[derive(Serialize)]
pub(crate) struct Entry {
    pub(crate) name: &'static str,
    pub(crate) filter: Filter,
    pub(crate) normals: Normals,
    pub(crate) samples: u32,
    /// Against a mean of 1.
    pub(crate) errors: Errors,
    /// Nanoseconds per pixel.
    pub(crate) time: f64,
    #[serde(skip)]
    pub(crate) picture: Vec<f64>,
}

/// What a stage showed.
#[derive(Serialize)]
pub(crate) struct Trial {
    pub(crate) size: Size,
    /// Of the facets from afar.
    pub(crate) alpha: f64,
    /// In a pixel that faces the eye.
    pub(crate) facets: f64,
    /// Of the reference, per pixel.
    pub(crate) samples: u32,
    /// Pixels that were judged.
    pub(crate) pixels: usize,
    /// Mean of the reference.
    pub(crate) mean: f64,
    /// Standard error of the reference, root mean square, in means.
    pub(crate) noise: f64,
    pub(crate) entries: Vec<Entry>,
    #[serde(skip)]
    pub(crate) reference: Vec<f64>,
    #[serde(skip)]
    pub(crate) judged: Vec<bool>,
}

/// A material and how well it is looked at.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setting {
    pub(super) alpha: f64,
    pub(super) facets: f64,
    /// Rows and columns of the reference's points in a pixel.
    pub(super) side: u32,
    pub(super) load: Load,
}

impl Trial {
    pub(super) fn of(stage: &Stage, methods: &[Method], setting: &Setting) -> Result<Self, Error> {
        let Setting { alpha, facets, side, load } = *setting;
        let surface = Surface::new(alpha, facets)?;
        let Reference { radiance: reference, judged, noise } = Reference::of(stage, &surface, side);
        let scale = scale(&reference, &judged);
        let times = times(stage, methods, setting, &judged, load)?;
        let entries = methods.iter().zip(times).map(|(method, time)| {
            let picture = picture(stage, &surface, method);
            let single: Vec<_> = picture.iter().map(|&x| x as f32).collect();
            Entry {
                name: method.name,
                filter: method.filter,
                normals: method.normals,
                samples: method.side * method.side,
                errors: Errors::of(&single, &reference, &judged, scale),
                time,
                picture,
            }
        });
        Ok(Self {
            size: stage.size,
            alpha,
            facets,
            samples: side * side,
            pixels: judged.iter().filter(|judged| **judged).count(),
            mean: 1.0 / scale,
            noise: scale * noise,
            entries: entries.collect(),
            reference,
            judged,
        })
    }

    pub(crate) fn entry(&self, name: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.name == name)
    }

    /// Root mean square error of a method, in means.
    pub(crate) fn rmse(&self, name: &str) -> f64 {
        self.entry(name).map_or(f64::NAN, |entry| entry.errors.rmse)
    }

    /// What a filter adds to the time of the same without one, as a share of that.
    pub(crate) fn overhead(&self, entry: &Entry) -> Option<f64> {
        let bare = |other: &&Entry| {
            other.normals == entry.normals && other.filter == Filter::None && other.samples == 1
        };
        let none = self.entries.iter().find(bare)?;
        let filters = entry.filter != Filter::None;
        filters.then(|| entry.time / none.time - 1.0)
    }

    /// How surely one method is nearer to the reference than another: what their squared errors
    /// differ by in the mean over pixels, in its standard errors; negative where it is farther off.
    pub(crate) fn lead(&self, one: &str, other: &str) -> f64 {
        let [Some(one), Some(other)] = [one, other].map(|name| self.entry(name)) else {
            return f64::NAN;
        };
        let judged = (0..self.judged.len()).filter(|&k| self.judged[k]);
        let square = |entry: &Entry, k: usize| (entry.picture[k] - self.reference[k]).powi(2);
        let leads = judged.map(|k| square(other, k) - square(one, k));
        let count = f64::max(self.pixels as f64, 1.0);
        let mean = leads.clone().sum::<f64>() / count;
        let variance = leads.map(|lead| (lead - mean).powi(2)).sum::<f64>() / count;
        mean / (variance / count).sqrt()
    }
}

/// What is no chance: that many standard errors.
pub(crate) const SURE: f64 = 2.0;

/// What a method makes of a pixel: its points under all lights.
pub(super) fn seen(stage: &Stage, method: &Method, index: usize) -> Vec<Seen<f64>> {
    let [x, y] = [index % stage.size.width, index / stage.size.width].map(|k| k as f64);
    let place = |k: u32| (f64::from(k) + 0.5) / f64::from(method.side);
    let places = (0..method.side).flat_map(|r| (0..method.side).map(move |c| (c, r)));
    let all = places.filter_map(|(column, row)| {
        let (x, y) = (x + place(column), y + place(row));
        if method.side == 1 { stage.pixels(x, y, method.normals) } else { stage.points(x, y) }
    });
    all.flatten().collect()
}

/// A whole picture, in all threads.
pub(super) fn picture(stage: &Stage, surface: &Surface<f64>, method: &Method) -> Vec<f64> {
    let share = 1.0 / f64::from(method.side * method.side);
    let pixels = (0..stage.size.pixels()).into_par_iter();
    pixels.map(|k| share * surface.sum(method.filter, &seen(stage, method, k))).collect()
}
