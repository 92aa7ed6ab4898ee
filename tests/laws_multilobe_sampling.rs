//! Directions drawn by many lobes: chi-squared of slopes and of directions, and weights of at most 1 (law C13).
#![cfg(feature = "glint")]

mod common;
#[path = "common/facets.rs"]
mod facets;

use common::arbitrary::Source;
use facets::{dictionary, pixel, roughness};
use lobe::material::glint::Patch;
use lobe::material::multilobe::MultiLobe;
use lobe::slope::direction::normalize;
use lobe::{Kernel, Psd, Roughness};

/// Law C13: samples are those of the density: moments of slopes, and the furnace; weights are at most 1.
#[test]
fn samples_are_of_the_density() {
    let kernel = Kernel::from_covariance(Psd::new(0.004, 0.001, 0.003).expect("valid"));
    for index in 0..6 {
        let pixel = pixel([2.0, 50.0, 1e30][index as usize % 3], index);
        let pixel = if index < 3 { pixel } else { pixel.widened(&kernel) };
        let count = 60_000;
        let mut source = Source::from_seed(index);
        let mut draw = |k: u64| {
            if k % 9 == 0 {
                source = Source::from_seed(index << 40 | k);
            }
            core::array::from_fn::<f64, 7, _>(|_| source.uniform(0.0, 1.0))
        };
        // Chi-squared of slopes over an 8 x 8 grid of deviations.
        let [[a, b], [_, c]] = roughness().chermain_matrix(1.0);
        let mut bins = [[0.0; 8]; 8];
        let wo = normalize([1.2, 0.4, 0.5]);
        for k in 0..count {
            let u = draw(k);
            let [x, y] = pixel.sample_slope(u);
            let y = y / c;
            let x = (x - b * y) / a;
            let ends = [-1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5, 2.0];
            let bin = |x: f64| ends.iter().position(|end| x < *end).filter(|_| x >= -2.0);
            if let (Some(i), Some(j)) = (bin(x), bin(y)) {
                bins[i][j] += 1.0;
            }
            let drawn = pixel.sample(wo, u).expect("above");
            assert!((0.0..=1.0 + 1e-12).contains(&drawn.weight) && drawn.pdf >= 0.0);
            if drawn.wi[2] > 1e-6 && drawn.weight > 0.0 {
                let value = pixel.brdf(wo, drawn.wi) * drawn.wi[2];
                assert!(
                    (value - drawn.weight * drawn.pdf).abs() <= 1e-6 * value + 1e-9,
                    "{value} {drawn:?}"
                );
            }
        }
        let mut chi = 0.0;
        for (i, column) in bins.iter().enumerate() {
            for (j, got) in column.iter().enumerate() {
                let nodes = 48;
                let mut expected = 0.0;
                for p in 0..nodes {
                    for q in 0..nodes {
                        let part = |k: usize, n: u32| {
                            0.5 * (k as f64 + (f64::from(n) + 0.5) / f64::from(nodes)) - 2.0
                        };
                        let (x, y) = (part(i, p), part(j, q));
                        expected += pixel.slope_pdf([a * x + b * y, c * y]);
                    }
                }
                expected *= a * c * 0.25 / f64::from(nodes * nodes) * count as f64;
                chi += (got - expected) * (got - expected) / expected.max(5.0);
            }
        }
        // 64 bins: mean 64 at most, deviation 11.3.
        assert!(chi < 120.0, "{index}: {chi}");
    }
}

/// Law C13, of directions: chi-squared over the disk of `wi`, for an ordinary view and a grazing one.
#[test]
fn directions_are_those_of_the_pdf() {
    const BINS: usize = 10;
    let kernel = Kernel::from_covariance(Psd::new(0.01, 0.004, 0.006).expect("valid"));
    for (index, wo) in [[0.3, 0.2, 1.0], [1.5, -0.8, 0.4]].map(normalize).into_iter().enumerate() {
        let pixel = pixel(40.0, index as u64).widened(&kernel);
        let (mut bins, count) = ([[0.0; BINS]; BINS], 100_000);
        for k in 0..count {
            let mut source = Source::from_seed(k);
            let drawn =
                pixel.sample(wo, [0.0; 7].map(|_| source.uniform(0.0, 1.0))).expect("above");
            let bin =
                |x: f64| (0..BINS).find(|k| x < -1.0 + 0.2 * (*k as f64 + 1.0)).unwrap_or(BINS - 1);
            if drawn.wi[2] > 0.0 {
                bins[bin(drawn.wi[0])][bin(drawn.wi[1])] += 1.0;
            }
        }
        let (mut chi, mut freedom) = (0.0, 0.0);
        for (i, column) in bins.iter().enumerate() {
            for (j, got) in column.iter().enumerate() {
                let nodes = 64;
                let mut expected = 0.0;
                for p in 0..nodes * nodes {
                    let at = |k: usize, n: i32| {
                        -1.0 + 0.2 * (k as f64 + (f64::from(n) + 0.5) / f64::from(nodes))
                    };
                    let (x, y) = (at(i, p % nodes), at(j, p / nodes));
                    let square = 1.0 - x * x - y * y;
                    if square > 0.0 {
                        let z = square.sqrt();
                        expected += pixel.pdf(wo, [x, y, z]) / z;
                    }
                }
                expected *= 0.04 / f64::from(nodes * nodes) * count as f64;
                // At the rim midpoints err by a few per cent.
                let inner = [i, j].iter().all(|k| (1..BINS - 1).contains(k));
                if inner && expected > 5.0 {
                    chi += (got - expected) * (got - expected) / expected;
                    freedom += 1.0;
                }
            }
        }
        println!("{wo:?}: chi-squared {chi} of {freedom}");
        // Mean `freedom`, variance twice that: three deviations are p = 0.001.
        assert!(
            freedom > 12.0 && chi < freedom + 3.0 * (2.0_f64 * freedom).sqrt(),
            "{chi} of {freedom}"
        );
    }
}

/// Under a kernel slopes have the covariance of lobe and kernel together, however long, turned or correlated either is:
/// within the part of a piece that turns may take across, 4.7 % of the lobe's, and chance.
#[test]
fn kernels_widen_what_they_should() {
    let cases = [
        ([0.3, 0.3, 0.0], [0.04, 0.0, 0.04]),
        ([0.5, 0.05, 0.0], [0.01, 0.0, 0.01]),
        ([0.5, 0.005, 0.0], [9e-4, 0.0, 9e-4]),
        ([0.5, 0.005, 0.0], [0.01, 0.0, 0.01]),
        ([0.3, 0.3, 0.99], [0.01, 0.0, 0.01]),
        ([0.3, 0.3, 0.999], [0.001, 0.0, 0.001]),
        ([0.1, 0.1, 0.0], [0.09, 0.0, 0.0]),
        ([0.1, 0.2, -0.5], [0.09, 0.0299, 0.01]),
    ];
    for ([x, y, rho], [kxx, kxy, kyy]) in cases {
        let roughness = Roughness::from_sigma_rho(x, y, rho).expect("in range");
        let kernel = Kernel::from_covariance(Psd::new(kxx, kxy, kyy).expect("valid"));
        let facets = MultiLobe::new(roughness, 100.0).expect("in range");
        let (mut second, count) = ([0.0; 3], 60_000);
        for k in 0..count {
            let mut source = Source::from_seed(k);
            let patch = Patch::new([0.37 * k as f64, 0.2], [1.0, 0.0], [0.0, 1.0]);
            let pixel = facets.lobe(dictionary(), &patch).widened(&kernel);
            let [x, y] = pixel.sample_slope([0.0; 7].map(|_| source.uniform(0.0, 1.0)));
            second = [second[0] + x * x, second[1] + x * y, second[2] + y * y];
        }
        let got = second.map(|sum| sum / count as f64);
        let [xx, xy, yy] = roughness.covariance().entries();
        let want = [xx + kxx, xy + kxy, yy + kyy];
        println!("{got:?}, want {want:?}");
        // In deviations of the sum: a matrix M with M W M^T = 1 makes of the difference what it is in proportion.
        let root = Psd::new(want[0], want[1], want[2]).expect("valid").cholesky();
        let [a, b, c] = root;
        let [p, q, r] = [got[0] - want[0], got[1] - want[1], got[2] - want[2]];
        let u = p / (a * a);
        let v = (q - b * p / a) / (a * c);
        let w = (r - 2.0 * b * q / a + b * b * p / (a * a)) / (c * c);
        for part in [u, v, w] {
            assert!(part.abs() < 0.047 + 0.02, "{got:?}, want {want:?}: {u} {v} {w}");
        }
    }
}
