//! Details one by one: the brute force that a pixel's model replaces.

use std::f64::consts::{PI, TAU};

use lobe::material::cells::Patch;

use super::material::Material;
use super::truth::arrivals;
use crate::pattern::Jitter;

/// Details in the mean that a square has, of those that the surface is divided into.
const PER_SQUARE: f64 = 4.0;

/// A surface of points that is the same for all pixels: a Poisson process, square by square from a
/// hash of its place.
///
/// Not of grooves.
#[derive(Clone, Copy, Debug)]
pub(super) struct Points {
    /// alpha of the details' own slopes along u and v.
    spread: [f64; 2],
    /// alpha^2 of one detail.
    local: [f64; 2],
    density: f64,
    seed: u64,
}

impl Points {
    /// With this many details per unit area.
    pub(super) fn new(material: &Material, density: f64, seed: u64) -> Self {
        let alpha = material.alpha;
        Self {
            spread: material.fractions.map(|f| alpha * (1.0 - f * f).sqrt()),
            local: material.fractions.map(|f| f * f * alpha * alpha),
            density,
            seed,
        }
    }

    /// Slope density that a pixel has: the mean over its parallelogram of what its details have.
    pub(super) fn slope_pdf(&self, patch: &Patch<f64>, slope: [f64; 2]) -> f64 {
        let Patch { uv, right, up, .. } = *patch;
        let size = (PER_SQUARE / self.density).sqrt();
        let reach = 0.5 * (right[1].abs() + up[1].abs());
        let [bottom, top] = [-reach, reach].map(|y| ((uv[1] + y) / size).floor() as i64);
        let det = right[0] * up[1] - right[1] * up[0];
        let mut sum = 0.0;
        for j in bottom..=top {
            let row = [0, 1].map(|k| (j + k) as f64 * size - uv[1]);
            let [first, last] =
                columns(patch, det, row).map(|x| ((uv[0] + x) / size).floor() as i64);
            for i in first..=last {
                self.square([i, j], |[x, y], at| {
                    let (x, y) = ((i as f64 + x) * size - uv[0], (j as f64 + y) * size - uv[1]);
                    let a = (x * up[1] - y * up[0]) / det;
                    let b = (y * right[0] - x * right[1]) / det;
                    if a.abs() < 0.5 && b.abs() < 0.5 {
                        let at = at();
                        let form = [0, 1].map(|k| (slope[k] - at[k]).powi(2) / self.local[k]);
                        sum += (-form[0] - form[1]).exp();
                    }
                });
            }
        }
        sum / (PI * (self.local[0] * self.local[1]).sqrt() * self.density * det.abs())
    }

    /// Calls `f` with the details of a square: where each lies in it, and what gives its slope.
    fn square(&self, index: [i64; 2], mut f: impl FnMut([f64; 2], &dyn Fn() -> [f64; 2])) {
        // Any bits will do.
        #[allow(clippy::cast_sign_loss)]
        let [i, j] = index.map(|i| i as u64);
        let key = i.wrapping_mul(0xD6E8_FEB8_6659_FD93) ^ j.rotate_left(32).wrapping_add(self.seed);
        let mut jitter = Jitter::new(key);
        arrivals(PER_SQUARE, &mut jitter, |turn, jitter| {
            let (place, [tail, _]) = (jitter.next(), jitter.next());
            f(place, &|| {
                // Box and Muller's pair, whose squares have a mean of half of alpha^2.
                let radius = (-tail.ln()).sqrt();
                let (sin, cos) = (TAU * turn).sin_cos();
                [self.spread[0] * radius * cos, self.spread[1] * radius * sin]
            });
        });
    }
}

/// No part of a parallelogram within some heights lies left or right of these; all from its center.
fn columns(patch: &Patch<f64>, det: f64, heights: [f64; 2]) -> [f64; 2] {
    let Patch { right, up, .. } = *patch;
    let reach = 0.5 * (right[0].abs() + up[0].abs());
    // Between two sides: |x d_y - y d_x| < |det|/2, for the line's direction d.
    [right, up].iter().fold([-reach, reach], |[begin, end], d| {
        let at = heights.map(|y| y * d[0] / d[1]);
        let half = 0.5 * (det / d[1]).abs();
        // Of a side along x, no bound: `max` and `min` drop what is no number.
        [begin.max(at[0].min(at[1]) - half), end.min(at[0].max(at[1]) + half)]
    })
}
