//! The sphere as its rays see it: what displaced geometry gives where it is fine against a pixel.

use lobe::slope::direction::{normal_of, reflect};
use rayon::prelude::*;

use super::ball::{Ball, Spot};
use super::field::Field;
use super::halves::Halves;
use super::sky::Sky;
use crate::pattern::Jitter;

/// Lights that are reflected, and whether relief that stands in their way is seen.
pub(super) const LIGHTS: usize = 4;

/// How many rays, through which fields.
pub(super) struct Sampling {
    /// An even number: the first half of them gives the first estimate, the others the second.
    pub(super) fields: Vec<Field>,
    /// Rays per pixel, over all fields.
    pub(super) rays: usize,
}

/// Pixels of the ball under one roughness.
pub(super) struct Reference {
    pub(super) whole: Halves,
    pub(super) lamp: Halves,
    pub(super) whole_shadowed: Halves,
    pub(super) lamp_shadowed: Halves,
}

/// Mirror images of a quarter of the picture.
const FLIPS: [[bool; 2]; 4] = [[false, false], [true, false], [false, true], [true, true]];

impl Sampling {
    /// Fields of different seeds and their rays.
    pub(super) fn new(side: usize, fields: u64, rays: usize) -> Self {
        Self { fields: (0..fields).map(|seed| Field::new(side, seed)).collect(), rays }
    }

    /// Casts rays at all pixels. Every pixel has the tangent frame of its center, so that nothing
    /// but the relief varies within it; lights are seen in whatever direction they are reflected.
    ///
    /// Mirrored fields are as random as they were: one ray serves four pixels.
    pub(super) fn render(
        &self,
        ball: Ball,
        sigma: [f64; 2],
        row_done: &(impl Fn() + Sync),
    ) -> Reference {
        let lights = [Sky::whole(), Sky::lamp()];
        let half = ball.side / 2;
        let rows: Vec<Vec<_>> = (0..half)
            .into_par_iter()
            .map(|y| {
                let pixels = (0..half).filter_map(|x| {
                    let seed = (y * half + x) as u64;
                    Some(([x, y], self.quartet(ball, [x, y], sigma, &lights, seed)?))
                });
                let pixels = pixels.collect();
                row_done();
                pixels
            })
            .collect();
        let mut estimates = vec![[[0.0; 2]; LIGHTS]; ball.side * ball.side];
        for (pixel, quartet) in rows.into_iter().flatten() {
            for (flips, values) in FLIPS.into_iter().zip(quartet) {
                let [x, y] = ball.mirrored(pixel, flips);
                estimates[y * ball.side + x] = values;
            }
        }
        let of = |light: usize| Halves {
            estimates: ball.pixels().map(|[x, y]| estimates[y * ball.side + x][light]).collect(),
        };
        Reference { whole: of(0), lamp: of(1), whole_shadowed: of(2), lamp_shadowed: of(3) }
    }

    /// A pixel and its mirror images, in the order of [`FLIPS`]: both estimates of every light.
    fn quartet(
        &self,
        ball: Ball,
        pixel: [usize; 2],
        sigma: [f64; 2],
        lights: &[Sky<f64>; 2],
        seed: u64,
    ) -> Option<[[[f64; 2]; LIGHTS]; 4]> {
        let wo = ball.spot(pixel)?.wo;
        let mut spots: Vec<Spot<f64>> = Vec::with_capacity(4);
        for flips in FLIPS {
            spots.push(ball.spot(ball.mirrored(pixel, flips))?);
        }
        // A field of unit slopes squeezed along its axes has these deviations; rays are stretched
        // instead.
        let stretched = |w: [f64; 3]| [sigma[0] * w[0], sigma[1] * w[1], w[2]];
        let towards = stretched(wo);
        let mut jitter = Jitter::new(seed);
        let mut sums = [[[0.0; 2]; LIGHTS]; 4];
        let per_field = self.rays / self.fields.len();
        for (index, field) in self.fields.iter().enumerate() {
            let estimate = index * 2 / self.fields.len();
            for _ in 0..per_field {
                let place = jitter.next().map(|x| x * field.side() as f64);
                let hit = field.seen(towards, place)?;
                let normal = normal_of([sigma[0] * hit.slope[0], sigma[1] * hit.slope[1]]);
                let wi = reflect(wo, normal);
                let open = !field.blocked(hit.point, stretched(wi));
                for ((spot, flips), sums) in spots.iter().zip(FLIPS).zip(&mut sums) {
                    // Columns are mirrored around the axis, rows along the angle from the pole.
                    let [over, under] = flips.map(|flip| if flip { -1.0 } else { 1.0 });
                    let world = spot.world([under * wi[0], over * wi[1], wi[2]]);
                    for (light, sky) in lights.iter().enumerate() {
                        let radiance = sky.radiance(world);
                        sums[light][estimate] += radiance;
                        sums[light + 2][estimate] += if open { radiance } else { 0.0 };
                    }
                }
            }
        }
        let count = (per_field * self.fields.len() / 2) as f64;
        Some(sums.map(|lights| lights.map(|halves| halves.map(|sum| sum / count))))
    }
}

#[cfg(test)]
mod tests {
    use super::{Ball, Sampling, Sky};
    use lobe::slope::direction::reflect;

    #[test]
    fn without_deviation_the_sphere_is_a_mirror_with_and_without_shadows() {
        let ball = Ball { side: 8 };
        let sampling = Sampling::new(64, 2, 8);
        let reference = sampling.render(ball, [0.0; 2], &|| ());
        let sky = Sky::whole();
        for (pixel, halves) in ball.pixels().zip(&reference.whole.estimates) {
            let spot = ball.spot(pixel).unwrap();
            let mirrored = sky.radiance(spot.world(reflect(spot.wo, [0.0, 0.0, 1.0])));
            assert!(halves.iter().all(|x| (x - mirrored).abs() < 1e-9 * mirrored));
        }
        assert_eq!(reference.whole.estimates, reference.whole_shadowed.estimates);
        assert!(reference.whole.noise() < 1e-12);
    }

    #[test]
    fn shadows_only_darken_and_rougher_relief_casts_more() {
        let ball = Ball { side: 8 };
        let sampling = Sampling::new(256, 2, 200);
        let kept = [0.1, 0.5, 1.5].map(|sigma| {
            let reference = sampling.render(ball, [sigma; 2], &|| ());
            let pairs = reference.whole.estimates.iter().zip(&reference.whole_shadowed.estimates);
            assert!(pairs.clone().all(|(open, dark)| dark[0] <= open[0] && dark[1] <= open[1]));
            reference.whole_shadowed.mean() / reference.whole.mean()
        });
        assert!(kept[0] > kept[1] && kept[1] > kept[2], "{kept:?}");
    }
}
