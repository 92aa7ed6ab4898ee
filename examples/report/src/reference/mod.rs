//! The converged pictures: jittered strata, f64, the unfiltered BRDF, under every window at once.
//!
//! Within a stratum the half vector's slope changes by a fraction of alpha, so errors fall like 1/n
//! and not like 1/sqrt(n). A few glints hold most of the error: a pilot picture finds them, its
//! differences decide how the samples are dealt out, and it is then thrown away, which keeps the
//! result unbiased.
//!
//! Geometry is sampled once for all alphas and both distributions. A pixel's samples are summed in
//! 16 x 16 cells, and each cell goes to the 5 x 5 pixels around with its share of their windows: a
//! window is constant over a sixteenth of a pixel. Windows that hang over a silhouette are the mean
//! over what they cover of the surface.

mod deal;
mod splat;

use std::collections::VecDeque;

use lobe::{AxisAligned, Beckmann, Error, Ggx};
use rayon::prelude::*;

use crate::camera::Size;
use crate::method::{Distribution, Finish};
use crate::pattern::Jitter;
use crate::scene::{Sample, Scene};
use crate::window::{CELLS, MARGIN, PerWindow, PixelWindow};
use deal::deal;
use splat::{Cell, Splatter, Sums};

/// Most alphas that one reference is made for.
pub(crate) const ALPHAS: usize = 3;

/// Radiances of one sample: alphas, and for each the distributions in the order of
/// [`Distribution::ALL`].
const CHANNELS: usize = ALPHAS * Distribution::ALL.len();

/// A reference picture under every window, with its own noise.
pub(crate) struct Reference {
    /// Radiance, rows from the top.
    pub(crate) radiance: PerWindow<Vec<f64>>,
    /// Root-mean-square difference of two independent halves over the judged pixels, over two: the
    /// standard error of their mean.
    pub(crate) noise: PerWindow<f64>,
}

/// The references of one lit scene from the same samples.
pub(crate) struct References {
    references: Vec<Reference>,
    /// Samples per pixel on average, the pilot's not counted.
    pub(crate) samples: f64,
}

impl References {
    /// Of the alpha of this index in the list that they were rendered for.
    pub(crate) fn of(&self, alpha: usize, distribution: Distribution) -> &Reference {
        &self.references[alpha * Distribution::ALL.len() + distribution as usize]
    }
}

/// How the reference samples a picture.
#[derive(Clone, Copy)]
pub(crate) struct Sampling {
    /// Samples per pixel on average to deal out by need; no pixel gets fewer than a fixed number.
    pub(crate) samples: u32,
    /// Strata along each side of a pixel, in each of two halves: of every pixel of the pilot, and
    /// of the pixels that get the fewest.
    pilot: u32,
    fewest: u32,
}

/// What is rendered: a lit scene, its material at several alphas, and the pixels that count.
pub(crate) struct Target<'a> {
    pub(crate) scene: &'a Scene<f64>,
    pub(crate) size: Size,
    pub(crate) finish: Finish,
    /// At most [`ALPHAS`].
    pub(crate) alphas: &'a [f64],
    pub(crate) judged: &'a [bool],
}

/// Strata along each side of a pixel, at most.
const MOST_STRATA: u32 = 192;

/// Rows rendered between two rounds of adding up.
const WAVE: usize = 16;

/// Two independent means of a pixel.
type Halves = [[f64; CHANNELS]; 2];

impl Sampling {
    /// Of a picture that stands for itself.
    pub(crate) fn of_still(samples: u32) -> Self {
        Self { samples, pilot: 8, fewest: 12 }
    }

    /// Of one frame among many.
    pub(crate) fn of_frame(samples: u32) -> Self {
        Self { samples, pilot: 4, fewest: 4 }
    }

    /// Renders the references; `row_done` is called once per row of the picture and of its margin.
    pub(crate) fn render(
        self,
        target: &Target<'_>,
        row_done: &(impl Fn() + Sync),
    ) -> Result<References, Error> {
        let sampler = Sampler::new(target)?;
        let whole = target.size.grown(MARGIN);
        let pilot = sampler.pilot(whole, self.pilot);
        let strata = deal(self, &pilot, &needed(target), whole);

        let splatter = Splatter::new();
        let mut collected = Collected::new(target);
        // Rows of the picture that rows still to come may add to.
        let mut open: VecDeque<Vec<Sums>> = VecDeque::new();
        let rows: Vec<usize> = (0..whole.height).collect();
        for wave in rows.chunks(WAVE) {
            let spread: Vec<_> = wave
                .par_iter()
                .map(|&y| {
                    let row = sampler.row(y, whole.width, &strata[y * whole.width..]);
                    row_done();
                    splatter.spread(&row, target.size.width)
                })
                .collect();
            for (&y, spread) in wave.iter().zip(spread) {
                open.resize_with(spread.len(), || vec![Sums::default(); target.size.width]);
                for (sums, added) in open.iter_mut().zip(&spread) {
                    sums.iter_mut().zip(added).for_each(|(sum, added)| sum.add(added));
                }
                // Row y of the whole reaches from y - 2 MARGIN to y of the picture; the first is
                // complete.
                if let Some(complete) = open.pop_front()
                    && y >= 2 * MARGIN
                {
                    collected.push_row(&complete);
                }
            }
        }
        let samples: f64 = strata.iter().map(|&n| 2.0 * f64::from(n * n)).sum();
        Ok(References { references: collected.finish(), samples: samples / strata.len() as f64 })
    }
}

/// Pixels of the picture and its margin that a judged pixel's windows reach.
fn needed(target: &Target<'_>) -> Vec<bool> {
    let (size, whole) = (target.size, target.size.grown(MARGIN));
    let mut needed = vec![false; whole.pixels()];
    for index in (0..size.pixels()).filter(|&index| target.judged[index]) {
        let (x, y) = (index % size.width, index / size.width);
        for row in y..=y + 2 * MARGIN {
            needed[row * whole.width + x..][..=2 * MARGIN].fill(true);
        }
    }
    needed
}

/// A material of one alpha.
struct Material {
    shape: AxisAligned<f64>,
    /// One over the squared alphas.
    inverse_squares: [f64; 2],
}

/// Where $e^{-q}$ is 0 in f64.
const UNDERFLOW: f64 = 746.0;

/// Takes samples of pixels.
struct Sampler<'a> {
    scene: &'a Scene<f64>,
    materials: Vec<Material>,
    /// Corner of the first pixel of the margin.
    corner: f64,
}

impl<'a> Sampler<'a> {
    fn new(target: &Target<'a>) -> Result<Self, Error> {
        let materials = target.alphas.iter().take(ALPHAS).map(|&alpha| {
            let alphas = target.finish.alphas(alpha);
            let inverse_squares = alphas.map(|alpha| 1.0 / (alpha * alpha));
            Ok(Material { shape: AxisAligned::new(alphas[0], alphas[1])?, inverse_squares })
        });
        let materials = materials.collect::<Result<_, _>>()?;
        Ok(Self { scene: target.scene, materials, corner: -(MARGIN as f64) })
    }

    /// A quick picture of means.
    fn pilot(&self, whole: Size, strata: u32) -> Vec<Halves> {
        let pixel = |index: usize| {
            let mut halves = Halves::default();
            for (half, means) in halves.iter_mut().enumerate() {
                let jitter = Jitter::new(4 * index as u64 + half as u64);
                let place = [index % whole.width, index / whole.width];
                self.samples(place, strata, jitter, |_, values| {
                    means.iter_mut().zip(values).for_each(|(mean, value)| *mean += value);
                });
            }
            halves
        };
        (0..whole.pixels()).into_par_iter().map(pixel).collect()
    }

    /// The cells of a row of pixels, one pixel after the other, each pixel's in rows.
    fn row(&self, y: usize, width: usize, strata: &[u32]) -> Vec<Cell> {
        let mut row = vec![Cell::default(); width * CELLS * CELLS];
        for (x, cells) in row.chunks_exact_mut(CELLS * CELLS).enumerate() {
            let index = y * width + x;
            for half in 0..2 {
                let jitter = Jitter::new(4 * index as u64 + 2 + half as u64);
                let area = 1.0 / f64::from(strata[x] * strata[x]);
                self.samples([x, y], strata[x], jitter, |offset, values| {
                    // Offsets lie in the unit square: the cast rounds down.
                    #[allow(clippy::cast_sign_loss)]
                    let [column, row] = offset.map(|t| (t * CELLS as f64) as usize);
                    let index = row.min(CELLS - 1) * CELLS + column.min(CELLS - 1);
                    cells[index].add(half, area, values);
                });
            }
        }
        row
    }

    /// Calls `take` for every hit of a pixel with its place in the pixel and its radiances over the
    /// number of samples.
    fn samples(
        &self,
        place: [usize; 2],
        strata: u32,
        mut jitter: Jitter,
        mut take: impl FnMut([f64; 2], [f64; CHANNELS]),
    ) {
        let step = 1.0 / f64::from(strata);
        let corner = place.map(|k| k as f64 + self.corner);
        for row in 0..strata {
            for column in 0..strata {
                let [u, v] = jitter.next();
                let offset = [(f64::from(column) + u) * step, (f64::from(row) + v) * step];
                let s = self.scene.sample(corner[0] + offset[0], corner[1] + offset[1]);
                if !s.hit {
                    continue;
                }
                take(offset, self.radiances(&s, step * step));
            }
        }
    }
    /// Radiances of a sample under every alpha and distribution, times an area.
    fn radiances(&self, s: &Sample<f64>, area: f64) -> [f64; CHANNELS] {
        let factor = s.wi[2] * s.strength * area;
        let squares = s.half.map(|x| x * x);
        let mut values = [0.0; CHANNELS];
        for (values, material) in values.chunks_exact_mut(2).zip(&self.materials) {
            values[0] = Ggx::new(material.shape).brdf(s.wo, s.wi) * factor;
            // Most of most pictures: not worth Beckmann's masking.
            let [x, y] = material.inverse_squares;
            if squares[0] * x + squares[1] * y < UNDERFLOW * squares[2] {
                values[1] = Beckmann::new(material.shape).brdf(s.wo, s.wi) * factor;
            }
        }
        values
    }
}

/// Finished rows on their way to pictures.
struct Collected<'a> {
    judged: &'a [bool],
    pictures: Vec<PerWindow<Vec<f64>>>,
    /// Squared differences of the halves, and the number of pixels in them.
    squares: Vec<PerWindow<f64>>,
    count: f64,
    pixels: usize,
}

impl<'a> Collected<'a> {
    fn new(target: &Target<'a>) -> Self {
        let channels = target.alphas.len().min(ALPHAS) * Distribution::ALL.len();
        Self {
            judged: target.judged,
            pictures: vec![Default::default(); channels],
            squares: vec![Default::default(); channels],
            count: 0.0,
            pixels: 0,
        }
    }

    fn push_row(&mut self, row: &[Sums]) {
        for sums in row {
            let judged = self.judged[self.pixels];
            self.pixels += 1;
            self.count += f64::from(u8::from(judged));
            for (channel, pictures) in self.pictures.iter_mut().enumerate() {
                for window in PixelWindow::ALL {
                    let [a, b] = sums.means(window, channel);
                    pictures[window as usize].push(0.5 * (a + b));
                    if judged {
                        self.squares[channel][window as usize] += (a - b) * (a - b);
                    }
                }
            }
        }
    }

    fn finish(self) -> Vec<Reference> {
        let count = self.count.max(1.0);
        let references = self.pictures.into_iter().zip(self.squares).map(|(radiance, squares)| {
            Reference { radiance, noise: squares.map(|sum| 0.5 * (sum / count).sqrt()) }
        });
        references.collect()
    }
}

#[cfg(test)]
mod tests;
