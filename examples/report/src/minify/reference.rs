//! The supersampled normal map: what every method should have given, in f64.
//!
//! At each of many jittered places in the pixel the finest level's bilinear slope is the mean of a
//! lobe of the base roughness, which is shaded with the directions of that place. Nothing is
//! weighted by projected area: this is a map, no displaced surface.

use lobe::{Beckmann, Error, Ggx, Isotropic, LobeShape, NonCentered};
use rayon::prelude::*;

use super::texels::Texels;
use super::view::{Spot, Station, View};
use crate::method::Distribution;
use crate::pattern::Jitter;

/// Most alphas that one reference is made for.
const ALPHAS: usize = 2;
const CHANNELS: usize = ALPHAS * Distribution::ALL.len();

/// Where $e^{-q}$ is 0 in f64.
const UNDERFLOW: f64 = 746.0;

/// A converged picture.
pub(super) struct Reference {
    pub(super) radiance: Vec<f64>,
    /// Standard error: half the root-mean-square difference of two independent halves.
    pub(super) noise: f64,
}

/// The references of one view from the same samples.
pub(super) struct References {
    references: Vec<Reference>,
    /// Per pixel.
    pub(super) samples: u32,
}

impl References {
    /// Of the alpha of this index in the list that they were made for.
    pub(super) fn of(&self, alpha: usize, distribution: Distribution) -> &Reference {
        &self.references[alpha * Distribution::ALL.len() + distribution as usize]
    }
}

/// Strata on the two axes of a pixel, in each of two halves.
#[derive(Clone, Copy)]
pub(super) struct Strata([u32; 2]);

impl Strata {
    /// At least `fewest`, and one for every texel that a pixel's side is long: a texel that nothing
    /// falls into is a glint that is missed.
    pub(super) fn of(station: &Station, fewest: u32) -> Self {
        let along = station.ratio / station.elevation.to_radians().sin();
        // Ratios are positive, and a few hundred at most: the cast only rounds.
        #[allow(clippy::cast_sign_loss)]
        let strata = |texels: f64| (texels.ceil() as u32).clamp(fewest, fewest.max(MOST));
        Self([station.ratio, along].map(strata))
    }
}

/// Strata on an axis, at most.
const MOST: u32 = 128;

/// Renders the references of a view for some alphas, two at most; `row_done` is called after every
/// row.
pub(super) fn render(
    texels: &Texels,
    station: &Station,
    alphas: &[f64],
    strata: Strata,
    row_done: &(impl Fn() + Sync),
) -> Result<References, Error> {
    let shapes: Vec<_> =
        alphas.iter().take(ALPHAS).map(|&a| Isotropic::new(a)).collect::<Result<_, _>>()?;
    let view = View::from(station);
    let size = station.size;
    let rows: Vec<Vec<[[f64; CHANNELS]; 2]>> = (0..size.height)
        .into_par_iter()
        .map(|y| {
            let pixel = |x: usize| {
                [0, 1].map(|half| {
                    let jitter = Jitter::new(2 * (y * size.width + x) as u64 + half);
                    mean(texels, &view, &shapes, [x, y], strata, jitter)
                })
            };
            let row = (0..size.width).map(pixel).collect();
            row_done();
            row
        })
        .collect();
    let pixels = size.pixels() as f64;
    let references = (0..shapes.len() * Distribution::ALL.len()).map(|channel| {
        let halves = rows.iter().flatten().map(|halves| halves.map(|half| half[channel]));
        let squares: f64 = halves.clone().map(|[a, b]| (a - b) * (a - b)).sum();
        Reference {
            radiance: halves.map(|[a, b]| 0.5 * (a + b)).collect(),
            noise: 0.5 * (squares / pixels).sqrt(),
        }
    });
    Ok(References { references: references.collect(), samples: 2 * strata.0[0] * strata.0[1] })
}

/// Means of a pixel over its strata.
fn mean(
    texels: &Texels,
    view: &View<f64>,
    shapes: &[Isotropic<f64>],
    pixel: [usize; 2],
    Strata([columns, rows]): Strata,
    mut jitter: Jitter,
) -> [f64; CHANNELS] {
    let mut sums = [0.0; CHANNELS];
    for row in 0..rows {
        for column in 0..columns {
            let [right, down] = jitter.next();
            let x = pixel[0] as f64 + (f64::from(column) + right) / f64::from(columns);
            let y = pixel[1] as f64 + (f64::from(row) + down) / f64::from(rows);
            let spot = view.spot([x, y]);
            let slope = texels.slopes.bilinear(spot.uv);
            for (sums, &shape) in sums.chunks_exact_mut(2).zip(shapes) {
                // Slopes of a map are below its cap.
                if let Ok(shape) = NonCentered::new(shape, slope) {
                    add(sums, shape, &spot);
                }
            }
        }
    }
    sums.map(|sum| sum / f64::from(columns * rows))
}

/// Adds the radiances of both distributions.
#[inline]
fn add(sums: &mut [f64], shape: NonCentered<Isotropic<f64>>, spot: &Spot<f64>) {
    let cosine = shape.mean_area(spot.wi);
    if cosine <= 0.0 {
        return;
    }
    let factor = cosine * spot.strength;
    sums[Distribution::Ggx as usize] += Ggx::new(shape).brdf(spot.wo, spot.wi) * factor;
    // Most of most pictures: not worth Beckmann's masking.
    let g = [0, 1, 2].map(|k| spot.wo[k] + spot.wi[k]);
    if shape.form(g) < UNDERFLOW * g[2] * g[2] * shape.root_det() {
        sums[Distribution::Beckmann as usize] +=
            Beckmann::new(shape).brdf(spot.wo, spot.wi) * factor;
    }
}
