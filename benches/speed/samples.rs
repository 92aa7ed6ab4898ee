//! Inputs of the benchmarks: seeded, near the lobe, footprints by regime.

use lobe::slope::direction::{normal_of, reflect};
use lobe::{Footprint, Psd, Roughness};

/// How large footprints are against the lobe, which decides the path of the exact mean.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Regime {
    /// Footprints of every size from a hundredth to a hundred alphas, log-uniform.
    Mixed,
    /// Up to a few tenths of alpha: quadrature.
    Small,
    /// Long and thin: a grazing view.
    Thin,
    /// Several alphas both ways: edges.
    Large,
}

impl Regime {
    /// Every regime.
    pub(crate) const ALL: [Self; 4] = [Self::Mixed, Self::Small, Self::Thin, Self::Large];

    /// The group's name.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Mixed => "mixed",
            Self::Small => "small",
            Self::Thin => "thin",
            Self::Large => "large",
        }
    }

    /// Ranges of both sides in alphas, as powers of ten.
    fn powers(self) -> [(f32, f32); 2] {
        match self {
            Self::Mixed => [(-2.0, 2.0), (-2.0, 2.0)],
            Self::Small => [(-2.0, -0.5), (-2.0, -0.5)],
            Self::Thin => [(0.5, 2.0), (-2.0, -0.5)],
            Self::Large => [(0.3, 1.5), (0.3, 1.5)],
        }
    }
}

/// One shading sample.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    pub(crate) wo: [f32; 3],
    pub(crate) wi: [f32; 3],
    pub(crate) alphas: [f32; 2],
    /// How far the axis of the first alpha is turned in `matrix`.
    pub(crate) angle: f32,
    pub(crate) matrix: Psd<f32>,
    pub(crate) mean: [f32; 2],
    pub(crate) slope: [f32; 2],
    pub(crate) footprint: Footprint<f32>,
}

/// SplitMix64 (Steele et al. 2014), as numbers in [0, 1).
struct Random(u64);

impl Random {
    fn unit(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 40) as f32 / 16_777_216.0
    }

    fn between(&mut self, (low, high): (f32, f32)) -> f32 {
        low + (high - low) * self.unit()
    }

    fn turn(&mut self) -> [f32; 2] {
        let (sin, cos) = (std::f32::consts::TAU * self.unit()).sin_cos();
        [cos, sin]
    }
}

/// Samples in a pass: they fit the second-level cache.
pub(crate) const COUNT: usize = 4096;

/// The samples of a regime, the same in every run.
pub(crate) fn samples(regime: Regime) -> Vec<Sample> {
    let mut random = Random(0x10BE);
    (0..COUNT)
        .map(|_| {
            let alphas = [0; 2].map(|_| 10.0_f32.powf(random.between((-2.0, -0.3))));
            let angle = std::f32::consts::PI * random.unit();
            let matrix =
                Roughness::from_alphas(alphas[0], alphas[1], angle).expect("valid").matrix();
            let reach = 3.0 * random.unit();
            let slope: [f32; 2] = {
                let [x, y] = random.turn();
                [reach * alphas[0] * x, reach * alphas[1] * y]
            };
            let wm = normal_of(slope);
            let [x, y] = random.turn();
            let z = random.between((0.3, 1.0));
            let r = (1.0 - z * z).sqrt();
            let wo = [r * x, r * y, z];
            let [u_range, v_range] = regime.powers();
            let size = (alphas[0] * alphas[1]).sqrt();
            let mut side = |range| {
                let length = size * 10.0_f32.powf(random.between(range));
                random.turn().map(|c| length * c)
            };
            let footprint = Footprint::from_slopes(side(u_range), side(v_range));
            let mean = random.turn().map(|c| 0.3 * c);
            Sample { wo, wi: reflect(wo, wm), alphas, angle, matrix, mean, slope, footprint }
        })
        .collect()
}
