//! Directions drawn by many lobes: chi-squared of slopes and of directions, the furnace, and
//! weights of at most 1 (law C13).
#![cfg(feature = "glint")]
#![allow(clippy::cast_sign_loss, reason = "bins are counted from 0")]

use crate::common::arbitrary::Source;
use crate::common::facets::{dictionary, kernels, pixel, roughness};
use crate::common::size::size;
use lobe::material::Fresnel;
use lobe::material::cells::Patch;
use lobe::material::multilobe::MultiLobe;
use lobe::shade::{MultiLobeMaterial, MultiLobeShading};
use lobe::slope::direction::normalize;
use lobe::{Kernel, Psd, SlopeMoments};
use statrs::distribution::{ChiSquared, ContinuousCDF};

/// Seven uniform numbers for the k-th sample.
fn numbers(k: u64) -> [f64; 7] {
    let mut source = Source::from_seed(k);
    [0.0; 7].map(|_| source.uniform(0.0, 1.0))
}

/// Pearson's test at p = 0.01: counts and expectations of all bins, of which small ones are taken
/// together.
#[track_caller]
fn assert_drawn(bins: &[[f64; 2]], what: &str) {
    let (large, small): (Vec<[f64; 2]>, Vec<[f64; 2]>) = bins.iter().partition(|bin| bin[1] > 5.0);
    let rest = small.iter().fold([0.0; 2], |sum, bin| [sum[0] + bin[0], sum[1] + bin[1]]);
    let all = large.into_iter().chain((rest[1] > 5.0).then_some(rest));
    let terms: Vec<f64> = all.map(|[got, want]| (got - want) * (got - want) / want).collect();
    let freedom = terms.len() as f64 - 1.0;
    let chi: f64 = terms.iter().sum();
    let limit = ChiSquared::new(freedom).expect("bins").inverse_cdf(0.99);
    println!("{what}: chi-squared {chi:.1} of {freedom}, limit {limit:.1}");
    assert!(freedom > 10.0 && chi < limit, "{what}: {chi} of {freedom}, limit {limit}");
}

/// Slopes are drawn by the density, whatever widens it: bins of half a deviation, and one for all
/// that is outside.
#[test]
fn slopes_are_drawn_by_the_density() {
    const BINS: usize = 12;
    let relief = Psd::new(0.03, 0.01, 0.02).expect("valid");
    let moments = SlopeMoments::new([0.0; 2], relief).expect("in range");
    let [[a, b], [_, c]] = roughness().chermain_matrix(1.0);
    let kernels = kernels(roughness().covariance());
    for (index, facets) in (0..10).zip([2.0, 50.0, 1e30].into_iter().cycle()) {
        let pixel = match (pixel(facets, index), index) {
            (pixel, 0..3) => pixel,
            (pixel, 3) => pixel.over(&moments),
            // Round ones, long ones, a segment, any.
            (pixel, k) => pixel.widened(&kernels[[0, 2, 4, 6, 9, 11][k as usize - 4]]),
        };
        let (mut bins, count) = ([[0.0; 2]; BINS * BINS + 1], size(20_000, 60_000));
        let bin = |x: f64| (2.0 * x).floor() + 0.5 * BINS as f64;
        for k in 0..count {
            let [x, y] = pixel.sample_slope(numbers(index << 40 | k));
            let (y, side) = (y / c, BINS as f64);
            let (i, j) = (bin((x - b * y) / a), bin(y));
            let inside = (0.0..side).contains(&i) && (0.0..side).contains(&j);
            bins[if inside { (i * side + j) as usize } else { BINS * BINS }][0] += 1.0;
        }
        let nodes = size(16, 40);
        let part = |k: usize, n: usize| {
            0.5 * (k as f64 + (n as f64 + 0.5) / nodes as f64) - 0.25 * BINS as f64
        };
        let mut outside = count as f64;
        for (place, bin) in bins[..BINS * BINS].iter_mut().enumerate() {
            let points = (0..nodes * nodes).map(|n| {
                let (x, y) = (part(place / BINS, n / nodes), part(place % BINS, n % nodes));
                pixel.slope_pdf([a * x + b * y, c * y])
            });
            let area = a * c * 0.25 / (nodes * nodes) as f64;
            bin[1] = points.sum::<f64>() * area * count as f64;
            outside -= bin[1];
        }
        bins[BINS * BINS][1] = outside.max(0.0);
        assert_drawn(&bins, &format!("pixel {index}, {facets} facets"));
    }
}

/// A leaning relief under a kernel, through the facade.
fn leaning(kernel: &Kernel<f64>, facets: f64) -> MultiLobeShading<'static, f64> {
    let facets = MultiLobe::new(roughness(), facets).expect("in range");
    let material = MultiLobeMaterial { facets, fresnel: Fresnel::white() };
    let relief = Psd::new(0.02, -0.01, 0.03).expect("valid");
    let moments = SlopeMoments::new([0.3, -0.2], relief).expect("in range");
    let patch = Patch::new([0.3, 0.7], [1.2, 0.3], [-0.2, 0.9]);
    material.bake(dictionary(), &patch, &moments, kernel)
}

/// Directions are drawn by the pdf, in the tangent frame, of ordinary views and of a grazing one;
/// their mean weight is what the same light reflects by quadrature; and each is what the facade
/// makes of its direction.
#[test]
fn directions_are_drawn_by_the_pdf() {
    // Bins of equal solid angle over the whole sphere: z, and the azimuth.
    const BINS: [usize; 2] = [16, 24];
    let kernels = kernels(roughness().covariance());
    for (view, wo) in [[0.3, 0.2, 1.0], [1.5, -0.8, 0.9], [-0.5, 1.0, 0.9]].into_iter().enumerate()
    {
        let (wo, shading) =
            (normalize(wo), leaning(&kernels[[4, 2, 12][view]], [40.0, 2.0, 1e3][view]));
        let (mut bins, count) = (vec![[0.0; 2]; BINS[0] * BINS[1] + 1], size(20_000, 60_000));
        let mut sampled = 0.0;
        for k in 0..count {
            let Some(drawn) = shading.sample(wo, numbers(k)) else { continue };
            let [x, y, z] = drawn.wi;
            let turn = y.atan2(x) / std::f64::consts::TAU + 0.5;
            let place = [0.5 * (z + 1.0), turn];
            let [i, j] = [0, 1].map(|k| ((place[k] * BINS[k] as f64) as usize).min(BINS[k] - 1));
            bins[i * BINS[1] + j][0] += 1.0;
            assert!((0.0..=1.0 + 1e-12).contains(&drawn.weight) && drawn.pdf >= 0.0);
            let pdf = shading.pdf(wo, drawn.wi);
            assert!((drawn.pdf - pdf).abs() <= 1e-6 * pdf + 1e-9, "{drawn:?} {pdf}");
            let [value, ..] = shading.evaluate(wo, drawn.wi);
            let want = drawn.weight * drawn.pdf;
            assert!((value - want).abs() <= 1e-6 * value + 1e-9, "{value} {drawn:?}");
            sampled += drawn.weight / count as f64;
        }
        let nodes = size(20, 40);
        let (mut reflected, mut whole) = (0.0, 0.0);
        for (place, bin) in bins[..BINS[0] * BINS[1]].iter_mut().enumerate() {
            let (i, j) = (place / BINS[1], place % BINS[1]);
            for n in 0..nodes * nodes {
                let at = |k: usize, n: usize, of: usize| {
                    (k as f64 + (n as f64 + 0.5) / nodes as f64) / of as f64
                };
                let z = 2.0 * at(i, n / nodes, BINS[0]) - 1.0;
                let (sin, cos) =
                    (std::f64::consts::TAU * (at(j, n % nodes, BINS[1]) - 0.5)).sin_cos();
                let r = (1.0 - z * z).sqrt();
                let wi = [r * cos, r * sin, z];
                let solid = 4.0 * std::f64::consts::PI / (BINS[0] * BINS[1] * nodes * nodes) as f64;
                bin[1] += shading.pdf(wo, wi) * solid * count as f64;
                reflected += shading.evaluate(wo, wi)[0] * solid;
            }
            whole += bin[1] / count as f64;
        }
        println!(
            "view {view}: the pdf's integral {whole}, reflected {reflected}, by samples {sampled}"
        );
        // Midpoints of at most 0.8 degrees, over lobes of two degrees.
        assert!((whole - 1.0).abs() < 2e-3, "view {view}: {whole}");
        // Weights lie in [0, 1]: their deviation is at most 1/2.
        assert!(
            (reflected - sampled).abs() < 5.0 * 0.5 / (count as f64).sqrt(),
            "view {view}: {reflected}, by samples {sampled}"
        );
        assert_drawn(&bins, &format!("view {view}"));
    }
}

/// Numbers at their ends, and views that see nothing.
#[test]
fn any_uniform_numbers_are_answered() {
    let end = 1.0 - f64::EPSILON / 2.0;
    let wo = normalize([0.6, 0.1, 0.8]);
    for kernel in kernels(roughness().covariance()) {
        let shading = leaning(&kernel, 30.0);
        for bits in 0..128_u32 {
            let u = core::array::from_fn(|k| if bits >> k & 1 == 1 { end } else { 0.0 });
            let drawn = shading.sample(wo, u).expect("above");
            assert!(drawn.wi.iter().all(|x| x.is_finite()) && drawn.weight <= 1.0 + 1e-12);
        }
        assert!(shading.sample([0.6, 0.0, -0.8], [0.5; 7]).is_none());
        assert!(shading.sample([f64::NAN; 3], [0.5; 7]).is_none());
        assert_eq!(shading.pdf([0.6, 0.0, -0.8], wo), 0.0);
    }
}
