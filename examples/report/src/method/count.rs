//! What a method costs in operations, whatever the machine: its shading run on numbers that count.

use lobe::probe::{Counted, Operations, operations_of};
use lobe::slope::Motion;
use lobe::{Error, Isotropic, Real, Roughness};
use serde::Serialize;

use super::material::Material;
use super::shading::Shade;
use super::{Derivatives, MovingPixel, QuadPixel};
use crate::scene::{Motions, Sample};

/// Operations per pixel, in the mean over some pixels: branches differ.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub(crate) struct Tally {
    pub(crate) additions: f64,
    pub(crate) multiplications: f64,
    pub(crate) divisions: f64,
    pub(crate) roots: f64,
    pub(crate) transcendental: f64,
    pub(crate) comparisons: f64,
}

impl Tally {
    /// The mean over some pixels of all their operations.
    pub(crate) fn of(operations: Operations, pixels: usize) -> Self {
        let mean = |count: u64| count as f64 / pixels.max(1) as f64;
        Self {
            additions: mean(operations.additions),
            multiplications: mean(operations.multiplications),
            divisions: mean(operations.divisions),
            roots: mean(operations.roots),
            transcendental: mean(operations.transcendental),
            comparisons: mean(operations.comparisons),
        }
    }

    /// The sum with a multiple of another.
    pub(crate) fn plus(&self, other: &Self, weight: f64) -> Self {
        let add = |a: f64, b: f64| a + weight * b;
        Self {
            additions: add(self.additions, other.additions),
            multiplications: add(self.multiplications, other.multiplications),
            divisions: add(self.divisions, other.divisions),
            roots: add(self.roots, other.roots),
            transcendental: add(self.transcendental, other.transcendental),
            comparisons: add(self.comparisons, other.comparisons),
        }
    }

    /// All of them.
    pub(crate) fn total(&self) -> f64 {
        let arithmetic = self.additions + self.multiplications + self.divisions;
        arithmetic + self.roots + self.transcendental + self.comparisons
    }
}

/// Pixels with the others of their quads and with motions, and a material, in counting numbers.
pub(crate) struct CountedPixels {
    material: Material<Isotropic<Counted>>,
    /// This one, the one beside it, the one below and the one across.
    quads: Vec<[Sample<Counted>; 4]>,
    motions: Vec<Motions<Counted>>,
}

impl CountedPixels {
    /// The material is isotropic, of this alpha.
    pub(crate) fn new(
        alpha: f64,
        quads: impl Iterator<Item = ([Sample<f32>; 4], Motions<f32>)>,
    ) -> Result<Self, Error> {
        let alpha = Counted::lit(alpha);
        let material = Material {
            alphas: [alpha; 2],
            shape: Isotropic::new(alpha)?,
            roughness: Roughness::from_alpha(alpha)?,
        };
        let (quads, motions) = quads
            .map(|(quad, motions)| (quad.map(counted_sample), motions.map(counted_motion)))
            .unzip();
        Ok(Self { material, quads, motions })
    }
}

fn counted<const N: usize>(v: [f32; N]) -> [Counted; N] {
    v.map(|x| Counted::lit(f64::from(x)))
}

fn counted_sample(sample: Sample<f32>) -> Sample<Counted> {
    Sample {
        wo: counted(sample.wo),
        wi: counted(sample.wi),
        half: counted(sample.half),
        tangent: counted(sample.tangent),
        normal: counted(sample.normal),
        strength: Counted::lit(f64::from(sample.strength)),
        hit: sample.hit,
    }
}

fn counted_motion(motion: Motion<f32>) -> Motion<Counted> {
    let [spin] = counted([motion.spin]);
    Motion { half_vector: counted(motion.half_vector), normal: counted(motion.normal), spin }
}

/// Counts the operations of a method's shading.
pub(super) type Counting = Box<dyn Fn(&CountedPixels) -> Tally + Send + Sync>;

/// The counting twin of a shading function: footprints included, geometry excluded.
pub(super) fn counting<F: Shade + Send + Sync + 'static>(
    shade: F,
    derivatives: Derivatives,
) -> Counting {
    Box::new(move |pixels| {
        let material = &pixels.material;
        let ((), operations) = operations_of(|| {
            for ([here, beside, below, across], motions) in pixels.quads.iter().zip(&pixels.motions)
            {
                // What comes out was judged elsewhere.
                let _ = if derivatives == Derivatives::Analytic {
                    shade.shade(material, &MovingPixel { here, motions })
                } else {
                    shade.shade(material, &QuadPixel { here, beside, below, across })
                };
            }
        });
        Tally::of(operations, pixels.quads.len())
    })
}

#[cfg(test)]
mod tests {
    use super::{CountedPixels, Tally};
    use crate::method::all;
    use crate::scene::Sample;

    fn pixels() -> CountedPixels {
        let up = |x: f32| {
            let half = lobe::slope::direction::normalize([x, 0.0, 1.0]);
            Sample {
                wo: half,
                wi: half,
                half,
                normal: [0.0, 0.0, 1.0],
                strength: 1.0,
                ..Sample::default()
            }
        };
        let quad = [up(0.0), up(0.01), up(0.02), up(0.03)];
        CountedPixels::new(0.01, [(quad, Default::default())].into_iter()).unwrap()
    }

    #[test]
    fn every_method_costs_operations_and_filters_cost_more_than_none() {
        let (pixels, methods) = (pixels(), all());
        let of = |name: &str| -> Tally {
            methods.iter().find(|m| m.name == name).unwrap().count(&pixels)
        };
        let plain = of("none (1 sample)");
        assert!(plain.total() > 20.0 && plain.transcendental == 0.0);
        for method in methods.iter().filter(|m| m.filters()) {
            let tally = method.count(&pixels);
            assert!(tally.total() > plain.total(), "{}", method.name);
        }
        // Appendix A: eight arctangents and as many roots.
        let rectangle = of("rectangle");
        assert_eq!(rectangle.transcendental, 8.0);
        assert!(rectangle.roots >= 8.0);
        assert_eq!(of("variance addition, 1/12").transcendental, 0.0);
    }
}
