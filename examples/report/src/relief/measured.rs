//! One sphere: every grid, the closed forms and normal mapping against its rays.

use lobe::material::leadr::Shadowing;
use lobe::{Error, Lobe, Roughness};
use rayon::prelude::*;
use serde::Serialize;

use super::ball::Ball;
use super::closed::{lit, lit_by_all, normal_mapped};
use super::halves::{Errors, Halves};
use super::reference::{Reference, Sampling};
use super::rule::{Family, Pixel, Rule, Way};
use super::sky::Sky;

/// A sphere of one roughness.
#[derive(Serialize)]
pub(crate) struct Sphere {
    /// Deviations of slopes along the angle from the pole and around the axis.
    pub(crate) sigma: [f64; 2],
    /// Standard errors of the reference's pixels, over its mean: sky and lamps; the lamp alone;
    /// both with shadows.
    pub(crate) noise: Lights<f64>,
    /// Light that reaches the eye with shadows over that without.
    pub(crate) unshadowed: f64,
    pub(crate) grids: Vec<Gathered>,
    pub(crate) normal_mapping: Errors,
    /// Of the lamp alone.
    pub(crate) lamp: LampErrors,
    /// With shadows.
    pub(crate) shadowed: Shadowed,
    #[serde(skip)]
    pub(crate) pictures: Pictures,
}

/// One number or picture for each light.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Lights<T> {
    pub(crate) whole: T,
    pub(crate) lamp: T,
    pub(crate) whole_shadowed: T,
    pub(crate) lamp_shadowed: T,
}

/// What a grid gives.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Gathered {
    pub(crate) family: Family,
    /// Slopes along each side.
    pub(crate) count: usize,
    /// Sum of the weights over the projected area, minus 1: mean of its size over the sphere, and
    /// where it is largest.
    pub(crate) normalization: [f64; 2],
    /// For each of [`Way::ALL`].
    pub(crate) errors: [Errors; 5],
}

/// A narrow lamp without shadows: errors of those that stand for it.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct LampErrors {
    /// The closed form for a point.
    pub(crate) point: Errors,
    /// Its mean over the lamp.
    pub(crate) all: Errors,
    /// The published grid of [`SHOWN`] slopes, blurred.
    pub(crate) grid: Errors,
}

/// With shadows: errors with and without the term for them.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Shadowed {
    pub(crate) lamp: Errors,
    pub(crate) lamp_masking_only: Errors,
    pub(crate) whole: Errors,
    pub(crate) whole_masking_only: Errors,
}

/// The pixels on the sphere.
#[derive(Default)]
pub(crate) struct Pictures {
    pub(crate) reference: Vec<f64>,
    /// The published grids and some of the library's, by size, blurred.
    pub(crate) grids: Vec<(Family, usize, Vec<f64>)>,
    pub(crate) normal_mapping: Vec<f64>,
    /// Reference and the closed form's mean over the lamp.
    pub(crate) lamp: [Vec<f64>; 2],
    pub(crate) lamp_shadowed: [Vec<f64>; 2],
}

/// Sides of the library's grids that have pictures.
const OURS: [usize; 2] = [5, 9];

/// Side of the published grid that stands beside the closed forms.
pub(crate) const SHOWN: usize = 32;

impl Sphere {
    pub(super) fn of(
        sigma: [f64; 2],
        ball: Ball,
        sampling: &Sampling,
        rules: &[Rule],
        row_done: &(impl Fn() + Sync),
    ) -> Result<Self, Error> {
        let reference = sampling.render(ball, sigma, row_done);
        let lobe =
            Lobe::centered(Roughness::from_sigma_rho(sigma[0] as f32, sigma[1] as f32, 0.0)?);
        let spots: Vec<_> = ball.pixels().filter_map(|pixel| ball.spot(pixel)).collect();
        let pixels: Vec<_> = spots.iter().map(|spot| Pixel { spot: spot.cast(), lobe }).collect();
        let (whole, lamp) = (Sky::whole(), Sky::lamp());
        let (whole32, lamp32) = (whole.cast::<f32>(), lamp.cast::<f32>());

        let mut pictures = Pictures::default();
        let mut grids = Vec::new();
        for rule in rules {
            let sums: Vec<_> =
                pixels.par_iter().map(|pixel| rule.grid.sums(pixel, &whole32)).collect();
            let picture = |way: usize| sums.iter().map(|sum| sum.radiance[way]).collect::<Vec<_>>();
            let excesses = || sums.iter().map(|sum| sum.excess.abs());
            grids.push(Gathered {
                family: rule.family,
                count: rule.count,
                normalization: [
                    excesses().sum::<f64>() / sums.len() as f64,
                    excesses().fold(0.0, f64::max),
                ],
                errors: std::array::from_fn(|way| reference.whole.judge(&picture(way))),
            });
            let ours = rule.family == Family::Cells && OURS.contains(&rule.count);
            if rule.family == Family::Published || ours {
                pictures.grids.push((rule.family, rule.count, picture(Way::Blurred as usize)));
            }
        }
        pictures.normal_mapping =
            spots.par_iter().map(|spot| normal_mapped(spot, sigma, &whole)).collect();
        let shown = rules.iter().find(|r| r.family == Family::Published && r.count == SHOWN);
        let gathered = |sky: &Sky<f32>, shadowing: Shadowing| -> Vec<f64> {
            let shade = |pixel| {
                shown.map_or(f32::NAN, |rule| rule.grid.shade(pixel, sky, Way::Blurred, shadowing))
            };
            pixels.par_iter().map(|pixel| shade(pixel).into()).collect()
        };
        let exact = Lobe::centered(Roughness::from_sigma_rho(sigma[0], sigma[1], 0.0)?);
        let closed = |shadowing| -> Vec<f64> {
            spots.par_iter().map(|spot| lit_by_all(spot, &exact, &lamp, shadowing)).collect()
        };
        let (masked, shadowed) = (closed(Shadowing::MaskingOnly), closed(Shadowing::Both));
        let point: Vec<_> =
            pixels.iter().map(|p| lit(p, &lamp32, Shadowing::MaskingOnly).into()).collect();
        let dark = &reference.whole_shadowed;
        let sphere = Self {
            sigma,
            noise: noises(&reference),
            unshadowed: dark.mean() / reference.whole.mean(),
            grids,
            normal_mapping: reference.whole.judge(&pictures.normal_mapping),
            lamp: LampErrors {
                point: reference.lamp.judge(&point),
                all: reference.lamp.judge(&masked),
                grid: reference.lamp.judge(&gathered(&lamp32, Shadowing::MaskingOnly)),
            },
            shadowed: Shadowed {
                lamp: reference.lamp_shadowed.judge(&shadowed),
                lamp_masking_only: reference.lamp_shadowed.judge(&masked),
                whole: dark.judge(&gathered(&whole32, Shadowing::Both)),
                whole_masking_only: dark.judge(&gathered(&whole32, Shadowing::MaskingOnly)),
            },
            pictures: Pictures {
                reference: reference.whole.picture(),
                lamp: [reference.lamp.picture(), masked],
                lamp_shadowed: [reference.lamp_shadowed.picture(), shadowed],
                ..pictures
            },
        };
        Ok(sphere)
    }

    /// A grid's numbers.
    pub(crate) fn grid(&self, family: Family, count: usize) -> Option<&Gathered> {
        self.grids.iter().find(|grid| grid.family == family && grid.count == count)
    }
}

fn noises(reference: &Reference) -> Lights<f64> {
    let [whole, lamp, whole_shadowed, lamp_shadowed] =
        [&reference.whole, &reference.lamp, &reference.whole_shadowed, &reference.lamp_shadowed]
            .map(Halves::noise);
    Lights { whole, lamp, whole_shadowed, lamp_shadowed }
}

impl Gathered {
    pub(crate) fn error(&self, way: Way) -> &Errors {
        &self.errors[way as usize]
    }
}
