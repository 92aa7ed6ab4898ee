//! Grids of slopes by their size and kind, and what they make of a pixel, in f32.

use lobe::Lobe;
use lobe::material::Fresnel;
use lobe::material::leadr::{
    Leadr, Normalization, Quadrature, Shadowing, cube_lod, dupuy_cube_lod,
};
use serde::Serialize;

use super::ball::Spot;
use super::sky::Sky;

/// Where a grid's places and weights come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub(crate) enum Family {
    Published,
    Cells,
    Hermite,
}

/// How a grid's slope looks up the light, and what the sum over the grid is divided by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub(crate) enum Way {
    /// Over the slope's solid angle; divided by the weights' sum.
    Blurred,
    /// Over a solid angle made larger for small grids, as the paper has it.
    Widened,
    /// In one direction.
    Point,
    /// As [`Way::Blurred`], divided by the projected area in closed form.
    BlurredOverArea,
    /// As [`Way::Point`], divided by the projected area in closed form.
    PointOverArea,
}

impl Way {
    pub(crate) const ALL: [Self; 5] =
        [Self::Blurred, Self::Widened, Self::Point, Self::BlurredOverArea, Self::PointOverArea];

    fn divisor(self) -> Normalization {
        match self {
            Self::Blurred | Self::Widened | Self::Point => Normalization::Sum,
            Self::BlurredOverArea | Self::PointOverArea => Normalization::ProjectedArea,
        }
    }
}

/// A pixel of a rough sphere.
pub(super) struct Pixel {
    pub(super) spot: Spot<f32>,
    pub(super) lobe: Lobe<f32>,
}

/// What one grid gives for a pixel.
#[derive(Clone, Copy)]
pub(super) struct Sums {
    /// Radiance for each of [`Way::ALL`].
    pub(super) radiance: [f64; 5],
    /// Sum of the weights over the projected area, minus 1.
    pub(super) excess: f64,
}

/// A grid behind its size.
pub(super) trait Gathers: Send + Sync {
    /// All ways at once.
    fn sums(&self, pixel: &Pixel, sky: &Sky<f32>) -> Sums;

    /// One way alone, as an engine would have it.
    fn shade(&self, pixel: &Pixel, sky: &Sky<f32>, way: Way, shadowing: Shadowing) -> f32;
}

/// A grid with its name.
pub(super) struct Rule {
    pub(super) family: Family,
    pub(super) count: usize,
    pub(super) grid: Box<dyn Gathers>,
}

impl Rule {
    /// Every grid of the comparison.
    pub(super) fn all() -> Vec<Self> {
        use Family::{Cells, Hermite, Published};
        vec![
            Self::of::<3>(Published),
            Self::of::<5>(Published),
            Self::of::<9>(Published),
            Self::of::<32>(Published),
            Self::of::<128>(Published),
            Self::of::<3>(Cells),
            Self::of::<5>(Cells),
            Self::of::<9>(Cells),
            Self::of::<32>(Cells),
            Self::of::<3>(Hermite),
            Self::of::<5>(Hermite),
            Self::of::<9>(Hermite),
        ]
    }

    fn of<const N: usize>(family: Family) -> Self {
        let grid = match family {
            Family::Published => Quadrature::<f32, N>::dupuy(),
            Family::Cells => Quadrature::cells(),
            Family::Hermite => Quadrature::hermite(),
        };
        Self { family, count: N, grid: Box::new(grid) }
    }
}

/// How many times the solid angle the paper's rule for its levels of detail averages over; not less
/// than all of it.
fn widening(count: usize) -> f32 {
    // The same at any solid angle and size of the map.
    let levels = dupuy_cube_lod(1.0_f64, 1.0, count) - cube_lod(1.0, 1.0);
    4.0_f64.powf(levels.max(0.0)) as f32
}

impl<const N: usize> Gathers for Quadrature<f32, N> {
    fn sums(&self, pixel: &Pixel, sky: &Sky<f32>) -> Sums {
        let (spot, leadr) = (&pixel.spot, Leadr::new(&pixel.lobe));
        let (shadowing, white) = (Shadowing::MaskingOnly, Fresnel::white());
        let area = Normalization::ProjectedArea;
        let gathered = |light: &dyn Fn([f32; 3], f32) -> [f32; 3]| {
            leadr.environment(spot.wo, self, shadowing, area, &white, &light).map(f64::from)
        };
        // Under a light of 1 radiance is the sum of the weights over the area.
        let [blurred, point, sum] = gathered(&|wi, solid_angle| {
            let w = spot.world(wi);
            [sky.blurred(w, solid_angle), sky.radiance(w), 1.0]
        });
        let widening = widening(N);
        let widened = if widening > 1.0 {
            let wider = |wi, angle| [sky.blurred(spot.world(wi), widening * angle), 0.0, 0.0];
            gathered(&wider)[0]
        } else {
            blurred
        };
        let radiance = Way::ALL.map(|way| match way {
            Way::Blurred => blurred / sum,
            Way::Widened => widened / sum,
            Way::Point => point / sum,
            Way::BlurredOverArea => blurred,
            Way::PointOverArea => point,
        });
        Sums { radiance, excess: sum - 1.0 }
    }

    fn shade(&self, pixel: &Pixel, sky: &Sky<f32>, way: Way, shadowing: Shadowing) -> f32 {
        let (spot, white) = (&pixel.spot, Fresnel::white());
        let leadr = Leadr::new(&pixel.lobe);
        let divisor = way.divisor();
        let factor = if way == Way::Widened { widening(N) } else { 1.0 };
        let point = |wi, _| [sky.radiance(spot.world(wi)), 0.0, 0.0];
        let blurred = |wi, angle| [sky.blurred(spot.world(wi), factor * angle), 0.0, 0.0];
        let radiance = match way {
            Way::Point | Way::PointOverArea => {
                leadr.environment(spot.wo, self, shadowing, divisor, &white, &point)
            }
            Way::Blurred | Way::Widened | Way::BlurredOverArea => {
                leadr.environment(spot.wo, self, shadowing, divisor, &white, &blurred)
            }
        };
        radiance[0]
    }
}

#[cfg(test)]
mod tests {
    use lobe::material::leadr::Shadowing;
    use lobe::{Lobe, Roughness};

    use super::{Pixel, Rule, Way, widening};
    use crate::relief::ball::Ball;
    use crate::relief::sky::Sky;

    #[test]
    fn all_ways_at_once_are_each_of_them_alone() {
        let sky = Sky::whole().cast();
        let ball = Ball { side: 6 };
        for (sigma_x, sigma_y) in [(0.05, 0.05), (0.2, 1.6)] {
            let lobe = Lobe::centered(Roughness::from_sigma_rho(sigma_x, sigma_y, 0.0).unwrap());
            for place in ball.pixels() {
                let pixel = Pixel { spot: ball.spot(place).unwrap().cast(), lobe };
                for rule in Rule::all() {
                    let sums = rule.grid.sums(&pixel, &sky);
                    for (way, together) in Way::ALL.into_iter().zip(sums.radiance) {
                        let alone = rule.grid.shade(&pixel, &sky, way, Shadowing::MaskingOnly);
                        let ratio = f64::from(alone) / together;
                        assert!((ratio - 1.0).abs() < 1e-5, "{:?} {way:?} {ratio}", rule.family);
                    }
                }
            }
        }
    }

    #[test]
    fn the_paper_widens_small_grids_only() {
        let factors = [3, 5, 9, 32, 128].map(widening);
        assert!(factors.is_sorted_by(|a, b| a >= b), "{factors:?}");
        assert!((factors[1] - 4.2).abs() < 0.05 && factors[4] == 1.0, "{factors:?}");
    }
}
