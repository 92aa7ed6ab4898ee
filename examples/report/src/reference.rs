//! The converged picture: box pixel, jittered strata, f64, the unfiltered BRDF.
//!
//! Within a stratum the half vector's slope changes by a fraction of alpha, so errors fall like 1/n and
//! not like 1/sqrt(n). A few glints hold most of the error: a pilot picture finds them, its differences
//! decide how the samples are dealt out, and it is then thrown away, which keeps the result unbiased.

use lobe::{Beckmann, Error, Ggx, Isotropic};
use rayon::prelude::*;

use crate::camera::Size;
use crate::method::Distribution;
use crate::metric;
use crate::pattern::Jitter;
use crate::scene::Scene;

/// A reference picture with its own noise.
pub(crate) struct Reference {
    /// Radiance under a light of unit irradiance, rows from the top.
    pub(crate) radiance: Vec<f64>,
    /// Root-mean-square difference of two independent halves, over two: the standard error of their
    /// mean.
    pub(crate) noise: f64,
}

/// The references of one scene, one per distribution, from the same samples.
pub(crate) struct References([Reference; Distribution::ALL.len()]);

impl References {
    pub(crate) fn of(&self, distribution: Distribution) -> &Reference {
        &self.0[distribution as usize]
    }
}

/// How the reference samples a picture.
#[derive(Clone, Copy)]
pub(crate) struct Sampling {
    /// Samples per pixel on average, about.
    pub(crate) samples: u32,
}

/// Strata along each side of a pixel, one sample each, in each of two independent halves.
mod strata {
    pub(super) const PILOT: u32 = 8;
    pub(super) const FEWEST: u32 = 12;
    pub(super) const MOST: u32 = 192;
}

/// Two independent means of a pixel, each in the order of [`Distribution::ALL`].
type Halves = [[f64; Distribution::ALL.len()]; 2];

impl Sampling {
    /// Renders the references of a scene; `row_done` is called once per row.
    pub(crate) fn render(
        self,
        scene: &Scene<f64>,
        size: Size,
        alpha: f64,
        row_done: &(impl Fn() + Sync),
    ) -> Result<References, Error> {
        let shape = Isotropic::new(alpha)?;
        let pass =
            |strata: &(dyn Fn(usize) -> u32 + Sync), stream: u64, row_done: &(dyn Fn() + Sync)| {
                let mut picture: Vec<Halves> = vec![Default::default(); size.pixels()];
                picture.par_chunks_mut(size.width).enumerate().for_each(|(y, row)| {
                    for (x, halves) in row.iter_mut().enumerate() {
                        let (index, corner) = (y * size.width + x, [x as f64, y as f64]);
                        for (half, means) in halves.iter_mut().enumerate() {
                            let seed = 4 * index as u64 + 2 * stream + half as u64;
                            *means = mean(scene, corner, shape, strata(index), Jitter::new(seed));
                        }
                    }
                    row_done();
                });
                picture
            };
        let pilot = pass(&|_| strata::PILOT, 0, &|| ());
        let strata = self.deal(&pilot, size);
        let picture = pass(&|index| strata[index], 1, row_done);

        Ok(References([0, 1].map(|k| {
            let squares = picture.iter().map(|h| (h[0][k] - h[1][k]).powi(2)).sum::<f64>();
            Reference {
                radiance: picture.iter().map(|h| 0.5 * (h[0][k] + h[1][k])).collect(),
                noise: 0.5 * (squares / picture.len() as f64).sqrt(),
            }
        })))
    }

    /// Strata of every pixel.
    ///
    /// With errors c/n, the sum of squares is smallest for n like c^(2/3). A pixel's c is the pilot's
    /// difference around it: a glint that the pilot missed has neighbours that it did not. Absolute and
    /// relative errors have an equal say, as have the distributions.
    fn deal(self, pilot: &[Halves], size: Size) -> Vec<u32> {
        let mut shares = vec![0.0; pilot.len()];
        for k in 0..Distribution::ALL.len() {
            let mean =
                pilot.iter().map(|h| 0.5 * (h[0][k] + h[1][k])).sum::<f64>() / shares.len() as f64;
            let square = |h: &Halves| (h[0][k] - h[1][k]).powi(2);
            let relative = |h: &Halves| {
                let radiance = 0.5 * (h[0][k] + h[1][k]);
                square(h) / (radiance * radiance + metric::SOFTENING * mean * mean)
            };
            add_shares(&mut shares, pilot.iter().map(square));
            add_shares(&mut shares, pilot.iter().map(relative));
        }
        let wishes: Vec<f64> = around(&shares, size).into_iter().map(f64::cbrt).collect();
        let sum: f64 = wishes.iter().sum();
        let samples = f64::from(self.samples) * pilot.len() as f64;
        let strata = |wish: &f64| {
            let per_half = if sum > 0.0 { 0.5 * samples * wish / sum } else { 0.0 };
            // Between the two bounds: the cast only rounds.
            #[allow(clippy::cast_sign_loss)]
            let strata = per_half.sqrt().min(f64::from(strata::MOST)).round() as u32;
            strata.max(strata::FEWEST)
        };
        wishes.iter().map(strata).collect()
    }
}

/// Adds to each share the value's part of the sum of all values, if there is one.
fn add_shares(shares: &mut [f64], values: impl Iterator<Item = f64> + Clone) {
    let sum: f64 = values.clone().sum();
    if sum > 0.0 && sum.is_finite() {
        shares.iter_mut().zip(values).for_each(|(share, value)| *share += value / sum);
    }
}

/// Means over the 5 x 5 pixels around each, fewer at the borders.
fn around(values: &[f64], size: Size) -> Vec<f64> {
    const REACH: usize = 2;
    let near = |at: usize, end: usize| at.saturating_sub(REACH)..(at + REACH + 1).min(end);
    let mean = |index: usize| {
        let (x, y) = (index % size.width, index / size.width);
        let (columns, rows) = (near(x, size.width), near(y, size.height));
        let count = (columns.len() * rows.len()) as f64;
        rows.flat_map(|y| &values[y * size.width..][columns.clone()]).sum::<f64>() / count
    };
    (0..values.len()).map(mean).collect()
}

/// Means over a pixel, in the order of [`Distribution::ALL`].
fn mean(
    scene: &Scene<f64>,
    corner: [f64; 2],
    shape: Isotropic<f64>,
    strata: u32,
    mut jitter: Jitter,
) -> [f64; 2] {
    let (ggx, beckmann) = (Ggx::new(shape), Beckmann::new(shape));
    let step = 1.0 / f64::from(strata);
    let mut sums = [0.0; 2];
    for row in 0..strata {
        for column in 0..strata {
            let [u, v] = jitter.next();
            let x = corner[0] + (f64::from(column) + u) * step;
            let y = corner[1] + (f64::from(row) + v) * step;
            let s = scene.sample(x, y);
            sums[0] += ggx.brdf(s.wo, s.wi) * s.wi[2];
            sums[1] += beckmann.brdf(s.wo, s.wi) * s.wi[2];
        }
    }
    sums.map(|sum| sum * step * step)
}

#[cfg(test)]
mod tests {
    use super::{Distribution, Sampling, around, strata};
    use crate::camera::Size;
    use crate::scene::Subject;

    #[test]
    fn samples_go_where_the_pilot_s_halves_differ() {
        let size = Size { width: 20, height: 10 };
        let mut pilot = vec![[[1.0; 2]; 2]; size.pixels()];
        pilot[5 * 20 + 10] = [[9.0, 1.0], [1.0, 1.0]];
        let strata = Sampling { samples: 200 }.deal(&pilot, size);
        assert!(strata[5 * 20 + 10] > 20 && strata[4 * 20 + 11] > 20);
        assert_eq!(strata[0], strata::FEWEST);
        let even = vec![[[1.0; 2]; 2]; size.pixels()];
        assert!(Sampling { samples: 200 }.deal(&even, size).iter().all(|&n| n == strata::FEWEST));
    }

    #[test]
    fn means_around_a_pixel_stay_inside_the_picture() {
        let size = Size { width: 4, height: 3 };
        let ones = around(&[1.0; 12], size);
        assert!(ones.iter().all(|&x| (x - 1.0).abs() < 1e-15));
    }

    #[test]
    fn more_samples_agree_within_the_noise_they_state() {
        let size = Size::of_width(16);
        let scene = Subject::water(size).exact;
        let [few, many] = [256, 4096]
            .map(|samples| Sampling { samples }.render(&scene, size, 0.05, &|| ()).unwrap());
        for distribution in Distribution::ALL {
            let (few, many) = (few.of(distribution), many.of(distribution));
            assert!(many.noise < 0.5 * few.noise);
            let pairs = few.radiance.iter().zip(&many.radiance);
            let squares = pairs.map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
            let rms = (squares / few.radiance.len() as f64).sqrt();
            assert!(rms < 3.0 * few.noise, "{rms} {}", few.noise);
        }
    }
}
