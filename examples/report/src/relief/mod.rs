//! LEADR against ray-cast relief: what its grids and closed forms give for a sphere of Gaussian
//! slopes, and what rays see of such a sphere.
//!
//! The relief is fine against a pixel and a pixel against the sphere: each pixel has one tangent
//! plane, covered by a random `field` of its own at random places, and the lobe's Gaussian of
//! slopes is exact. What is left is how a grid sums it, and what LEADR takes for granted: that
//! slopes know nothing of their height.

mod ball;
mod cast;
mod closed;
mod field;
mod halves;
mod measured;
mod reference;
mod rule;
mod sky;
mod speed;

use lobe::Error;
use serde::Serialize;

pub(crate) use halves::Errors;
pub(crate) use measured::{SHOWN, Sphere};
pub(crate) use rule::{Family, Way};
pub(crate) use speed::Speed;

use ball::Ball;
use reference::Sampling;
use rule::Rule;

/// How much work.
#[derive(Clone, Debug)]
pub(crate) struct Plan {
    /// Pixels along the sphere's diameter, even.
    pub(crate) side: usize,
    /// Rays per pixel.
    pub(crate) rays: usize,
    /// Random fields that they are cast at, an even number, and cells along each side of one.
    pub(crate) fields: u64,
    pub(crate) cells: usize,
    /// Rounds of timing.
    pub(crate) rounds: usize,
    /// Deviations of slopes along the angle from the pole and around the axis.
    pub(crate) sigmas: Vec<[f64; 2]>,
}

/// Dupuy et al. 2013, supplement: Table 8 and the strongest of each kind in Table 9, both ways
/// round.
const SIGMAS: [[f64; 2]; 13] = [
    [0.01, 0.01],
    [0.05, 0.05],
    [0.25, 0.25],
    [0.5, 0.5],
    [1.0, 1.0],
    [1.5, 1.5],
    [2.0, 2.0],
    [0.01, 0.08],
    [0.05, 0.4],
    [0.2, 1.6],
    [0.08, 0.01],
    [0.4, 0.05],
    [1.6, 0.2],
];

/// Those of a quick run.
const QUICK: [usize; 4] = [1, 3, 6, 9];

impl Plan {
    /// Of a full run.
    pub(crate) fn full() -> Self {
        Self { side: 56, rays: 8192, fields: 8, cells: 1024, rounds: 31, sigmas: SIGMAS.into() }
    }

    /// Of a quick one.
    pub(crate) fn quick() -> Self {
        let sigmas = QUICK.map(|index| SIGMAS[index]).into();
        Self { side: 28, rays: 4096, fields: 4, cells: 512, rounds: 11, sigmas }
    }

    /// What `row_done` counts to.
    pub(crate) fn steps(&self) -> u64 {
        (self.side / 2 * self.sigmas.len()) as u64
    }
}

/// All that was measured.
#[derive(Serialize)]
pub(crate) struct Relief {
    /// Pixels along the diameter, rays per pixel, fields.
    pub(crate) side: usize,
    pub(crate) rays: usize,
    pub(crate) fields: u64,
    pub(crate) spheres: Vec<Sphere>,
    pub(crate) speed: Speed,
}

impl Relief {
    pub(crate) fn measured(plan: &Plan, row_done: &(impl Fn() + Sync)) -> Result<Self, Error> {
        let rules = Rule::all();
        let ball = Ball { side: plan.side };
        let sampling = Sampling::new(plan.cells, plan.fields, plan.rays);
        let sphere = |&sigma: &[f64; 2]| Sphere::of(sigma, ball, &sampling, &rules, row_done);
        let spheres = plan.sigmas.iter().map(sphere).collect::<Result<_, _>>()?;
        let speed = Speed::measured(&rules, plan.rounds)?;
        Ok(Self { side: plan.side, rays: plan.rays, fields: plan.fields, spheres, speed })
    }

    /// Values of the pixels on the sphere as a square picture, black around them.
    pub(crate) fn square(&self, values: &[f64]) -> Vec<f64> {
        let mut picture = vec![0.0; self.side * self.side];
        for ([x, y], value) in (Ball { side: self.side }).pixels().zip(values) {
            picture[y * self.side + x] = *value;
        }
        picture
    }
}

#[cfg(test)]
mod tests {
    use super::{Family, Plan, Relief, Sphere, Way};

    fn measured(sigmas: Vec<[f64; 2]>) -> Relief {
        let plan = Plan { side: 16, rounds: 1, sigmas, ..Plan::quick() };
        Relief::measured(&plan, &|| ()).unwrap()
    }

    fn error(sphere: &Sphere, family: Family, count: usize) -> f64 {
        let errors = sphere.grid(family, count).unwrap().error(Way::Blurred);
        errors.rmse.max(errors.least)
    }

    #[test]
    fn many_slopes_are_what_rays_see_and_a_normal_map_is_not() {
        let relief = measured(vec![[0.5, 0.5], [1.6, 0.2]]);
        for sphere in &relief.spheres {
            let all = error(sphere, Family::Published, 128);
            // Where relief hides light, and where it is bright, depends on heights as well: a few
            // hundredths.
            assert!(all < 0.08, "{:?}: {all}", sphere.sigma);
            assert!(sphere.normal_mapping.rmse > 3.0 * all, "{:?}", sphere.normal_mapping);
            assert!(sphere.normal_mapping.bias < -0.05);
            let few = error(sphere, Family::Published, 3);
            assert!(few > 2.0 * all, "{few} {all}");
        }
    }

    #[test]
    fn shadows_need_their_term_and_smooth_spheres_have_none() {
        let relief = measured(vec![[0.01, 0.01], [1.0, 1.0]]);
        let [smooth, rough] = &relief.spheres[..] else { panic!("two spheres") };
        assert!(smooth.unshadowed > 0.99 && rough.unshadowed < 0.8);
        assert!(rough.shadowed.whole.rmse < 0.5 * rough.shadowed.whole_masking_only.rmse);
        assert!(rough.shadowed.whole.bias.abs() < 0.1);
    }

    #[test]
    fn every_count_has_an_entry_with_a_finite_time() {
        let speed = measured(Vec::new()).speed;
        for count in [3, 9, 32, 128] {
            let time = speed.grid(Family::Published, count).unwrap().time(Way::Point);
            assert!(time.is_finite(), "{count}: {time}");
        }
        assert!(speed.closed.is_finite());
    }
}
