//! Pixels at random places of a material, and what models make of them, over the smooth lobe.

use std::f64::consts::TAU;

use lobe::Error;
use lobe::material::cells::Patch;
use lobe::material::glint::{Grid, light_blur};
use lobe::slope::direction::normal_of;
use rayon::prelude::*;
use serde::Serialize;

use super::material::Material;
use super::model::{Made, Model, Seen};
use super::truth::Truth;
use crate::pattern::Jitter;

/// Where half vectors stand, in alphas from the pole, along u.
pub(crate) const HALVES: [f64; 3] = [0.0, 1.0, 2.0];

/// Sides of a pixel's rectangle, the longer over the shorter.
pub(crate) const ASPECTS: [f64; 3] = [1.0, 4.0, 16.0];

/// What light shines: from where the eye is, along the half vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Light {
    Point,
    Sun,
}

impl Light {
    pub(crate) const ALL: [Self; 2] = [Self::Point, Self::Sun];

    /// Radius that it appears with, in radians.
    pub(super) fn radius(self) -> f64 {
        if self == Self::Sun { 0.004_65 } else { 0.0 }
    }
}

/// Widths of pixels from the origin, at most: not so many that f32 could not tell cells apart.
const FARTHEST: f64 = 1e5;

/// A rectangle of a plane, turned by anything, anywhere.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pixel {
    pub(super) patch: Patch<f64>,
    pub(super) area: f64,
    /// Of its longer side, from u.
    pub(super) angle: f64,
    pub(super) seed: u32,
}

impl Pixel {
    /// The `index`th pixel of an aspect, its width relative to cells by `octave` in [0, 1) if that
    /// is given, random else.
    pub(super) fn random(aspect: f64, octave: Option<f64>, index: u64) -> Self {
        let mut jitter = Jitter::new(index);
        let ([x, y], [turn, random]) = (jitter.next(), jitter.next());
        let width = f64::exp2(octave.unwrap_or(random));
        let angle = TAU * turn;
        let (sin, cos) = angle.sin_cos();
        let long = aspect * width;
        let uv = [x, y].map(|x| FARTHEST * (2.0 * x - 1.0));
        let patch = Patch::new(uv, [-width * sin, width * cos], [long * cos, long * sin]);
        // Other seeds would do as well.
        let seed = index as u32;
        Self { patch, area: width * long, angle, seed }
    }
}

/// One kind of pixels under one light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setting<'a> {
    pub(super) material: &'a Material,
    pub(super) aspect: f64,
    /// Of [`HALVES`].
    pub(super) half: f64,
    pub(super) light: Light,
    /// As of [`Pixel::random`].
    pub(super) octave: Option<f64>,
}

impl Setting<'_> {
    fn slope(&self) -> [f64; 2] {
        [self.half * self.material.alpha, 0.0]
    }

    fn h(&self) -> [f64; 3] {
        normal_of(self.slope())
    }

    fn blur(&self) -> f64 {
        light_blur(self.h(), self.h(), self.light.radius())
    }

    fn pixel(&self, index: u64) -> Pixel {
        Pixel::random(self.aspect, self.octave, index)
    }

    /// Every pixel has a surface of its own, so that no two share a cell.
    fn made(&self, pixel: &Pixel) -> Result<Made<f64>, Error> {
        Made::new(self.material, pixel.area, pixel.seed)
    }

    /// What some pixels give over the smooth lobe.
    pub(super) fn ratios(&self, model: Model, count: u64) -> Result<Vec<f64>, Error> {
        let (h, radius) = (self.h(), self.light.radius());
        let one = |index| {
            let pixel = self.pixel(index);
            let seen = Seen { patch: pixel.patch, wo: h, wi: h, radius };
            Ok(self.made(&pixel)?.ratio(model, &seen))
        };
        (0..count).into_par_iter().map(one).collect()
    }

    /// Probability that a detail reflects.
    pub(super) fn probability(&self) -> Result<f64, Error> {
        let pixel = self.pixel(0);
        Ok(self.made(&pixel)?.glints.ndf(&pixel.patch).probability(self.h(), self.blur()))
    }

    /// The relative variance that the default model should have: of every cell that of a binomial
    /// number, summed as if levels drew independently, and as if a cell that both levels have drew
    /// proportional numbers. What it has is between.
    pub(super) fn law(&self, count: u64) -> Result<[f64; 2], Error> {
        let probability = self.probability()?;
        let one = |index| {
            let pixel = self.pixel(index);
            let density = self.material.density(pixel.area);
            let lobe = self.made(&pixel)?.glints.ndf(&pixel.patch);
            Ok(law(lobe.grid(), density, self.material.is_groove(), probability))
        };
        let laws: Vec<_> = (0..count).into_par_iter().map(one).collect::<Result<_, Error>>()?;
        let sum = |k: usize| laws.iter().map(|law| law[k]).sum::<f64>();
        Ok([sum(0), sum(1)].map(|sum| sum / count as f64))
    }

    fn truth(&self) -> Truth {
        Truth::new(self.material, self.blur())
    }

    /// The relative variance of real details.
    pub(super) fn true_variance(&self, count: u64) -> f64 {
        let (truth, slope) = (self.truth(), self.slope());
        let sum: f64 = (0..count).map(|index| truth.variance(slope, &self.pixel(index))).sum();
        sum / count as f64
    }

    /// What pixels of real details give over the smooth lobe; another `seed`, other details.
    pub(super) fn true_ratios(&self, count: u64, seed: u64) -> Vec<f64> {
        let (truth, slope) = (self.truth(), self.slope());
        let one = |index| {
            let mut jitter = Jitter::new(seed << 40 | 1 << 39 | index);
            truth.draw(slope, &self.pixel(index), &mut jitter)
        };
        (0..count).into_par_iter().map(one).collect()
    }
}

/// The relative variance of one pixel, both ways.
fn law(grid: &Grid<f64>, density: f64, groove: bool, probability: f64) -> [f64; 2] {
    let mut apart = 0.0;
    let mut deviations: Vec<([f64; 2], f64)> = Vec::new();
    grid.visit(|cell| {
        let size = f64::exp2(f64::from(cell.exponent));
        let number = if groove { density.sqrt() * size } else { density * size * size };
        let deviation = cell.share / (number.max(1.0) * probability).sqrt();
        apart += deviation * deviation;
        let place = cell.index.map(|i| i as f64 * size);
        match deviations.iter_mut().find(|other| other.0 == place) {
            Some(other) => other.1 += deviation,
            None => deviations.push((place, deviation)),
        }
    });
    let together: f64 = deviations.iter().map(|(_, deviation)| deviation * deviation).sum();
    [apart, together].map(|sum| sum * (1.0 - probability))
}
