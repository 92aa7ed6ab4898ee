//! Many lobes in one pixel: its integral, its mean, its masking, and how it changes (laws C3 to C10, B1; C13 is in
//! laws_multilobe_sampling.rs).
#![cfg(feature = "glint")]

mod common;
#[path = "common/facets.rs"]
mod facets;

use common::arbitrary::Source;
use common::{check, ensure, near};
use facets::{dictionary, pixel, roughness};
use lobe::material::glint::Patch;
use lobe::material::multilobe::{Dictionary, Means, MultiLobe, Recipe};
use lobe::ndf::{cavity_masking, cavity_masking_shadowing};
use lobe::slope::direction::{half_vector, normal_of, normalize};
use lobe::{Beckmann, Footprint, Full, Kernel, PixelFilter, Psd, Roughness, SlopeMoments};

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Integral over slopes of the plane, in deviations of the roughness, by midpoints.
fn integral(f: impl Fn([f64; 2]) -> f64, reach: f64, nodes: u32) -> f64 {
    let [[a, b], [_, c]] = roughness().chermain_matrix(1.0);
    let step = 2.0 * reach / f64::from(nodes);
    let at = |k: u32| step * (f64::from(k) + 0.5) - reach;
    let places = (0..nodes).flat_map(|i| (0..nodes).map(move |j| [at(i), at(j)]));
    places.map(|[x, y]| f([a * x + b * y, c * y])).sum::<f64>() * step * step * a * c
}

/// Law C3: every pixel's density integrates to 1, filtered or not; C4: it is even.
#[test]
fn every_pixel_s_density_integrates_to_one() {
    let footprint = Footprint::from_slopes([0.1, 0.05], [-0.02, 0.2]);
    for index in 0..12 {
        let pixel = pixel([1.0, 30.0, 1e4][index as usize % 3], index);
        let kernel = Kernel::of(&footprint, PixelFilter::BOX);
        let narrow = Kernel::of(&footprint.scaled(0.3), PixelFilter::BOX);
        for pixel in [
            pixel,
            pixel.widened(&narrow),
            pixel.widened(&kernel),
            pixel.with_mips(&footprint, 0.5),
        ] {
            let whole = integral(|slope| pixel.slope_pdf(slope), 7.0, 360);
            // A sum of midpoints over lines between nodes, turned by anything.
            assert!((whole - 1.0).abs() < 1e-3, "{index}: {whole}");
        }
        let mut source = Source::from_seed(index);
        for _ in 0..50 {
            let slope = [source.uniform(-0.9, 0.9), source.uniform(-0.5, 0.5)];
            let there = pixel.slope_pdf(slope.map(|x| -x));
            assert_eq!(pixel.slope_pdf(slope), there);
        }
    }
}

/// Law C5: V-cavities are exact for every pixel, $\int G_1 (w \cdot m)^+ D\, dm = w_z$.
#[test]
fn masking_is_exact() {
    for (index, angle) in (0..10).map(|k| (k, [0.0_f64, 0.5, 1.0, 1.4, 1.5][k as usize % 5])) {
        let pixel = pixel([3.0, 1e3][index as usize % 2], index);
        let turn = f64::from(index as u32);
        let wo = [angle.sin() * turn.cos(), angle.sin() * turn.sin(), angle.cos()];
        // D dm = P22 ds / m_z.
        let seen = |slope: [f64; 2]| {
            let m = normal_of(slope);
            pixel.slope_pdf(slope) * cavity_masking(wo, m) * dot(wo, m).max(0.0) / m[2]
        };
        let whole = integral(seen, 7.0, 500);
        assert!((whole / wo[2] - 1.0).abs() < 1e-3, "{index} {angle}: {whole} of {}", wo[2]);
    }
}

/// Masking and shadowing by the smaller of both is the product up to 45 degrees from the pole, and never below it.
#[test]
fn the_smaller_masking_is_no_less_than_the_product() {
    check(20_000, |source| {
        let mut any = || {
            normalize([
                source.uniform(-1.0, 1.0),
                source.uniform(-1.0, 1.0),
                source.uniform(0.0, 1.0),
            ])
        };
        let (wo, wi) = (any(), any());
        let h = half_vector(wo, wi);
        let [o, i] = [wo, wi].map(|w| cavity_masking(w, h));
        let both = cavity_masking_shadowing(wo, wi, h);
        ensure(both >= o * i && both <= 1.0, "a masking", &(wo, wi))?;
        if h[2] * h[2] >= 0.5 {
            near(both, o * i, 1e-12, &(wo, wi))?;
        }
        Ok(())
    });
}

/// Law C6: very many facets are the correlated Beckmann lobe, to the last digit.
#[test]
fn very_many_facets_are_the_smooth_lobe() {
    let smooth = Beckmann::new(Full::new(roughness()));
    for index in 0..20 {
        let pixel = pixel(50.0_f64.exp(), index);
        for slope in [[0.0, 0.0], [0.3, -0.2], [0.9, 0.1]] {
            let want = smooth.slope_pdf(slope);
            assert!((pixel.slope_pdf(slope) / want - 1.0).abs() < 1e-12);
        }
        let (wo, wi) = (normalize([0.3, 0.1, 1.0]), normalize([0.2, -0.5, 1.0]));
        let h = half_vector(wo, wi);
        let want = smooth.d(h) * cavity_masking_shadowing(wo, wi, h) / (4.0 * wo[2] * wi[2]);
        assert!((pixel.brdf(wo, wi) / want - 1.0).abs() < 1e-12);
    }
}

/// Laws C7 and C8: the mean over pixels is the smooth lobe, and its covariance the roughness; as published both are off.
#[test]
fn the_mean_over_pixels_is_the_smooth_lobe() {
    let smooth = Beckmann::new(Full::new(roughness()));
    for facets in [0.5, 100.0] {
        for slope in [[0.05, 0.02], [0.25, 0.1]] {
            let (mut sum, mut squares, count) = (0.0, 0.0, 40_000);
            for index in 0..count {
                let ratio = pixel(facets, index).slope_pdf(slope) / smooth.slope_pdf(slope);
                sum += ratio / count as f64;
                squares += ratio * ratio / count as f64;
            }
            let deviation = ((squares - sum * sum) / count as f64).sqrt();
            println!("{facets} facets, {slope:?}: {sum} +- {deviation}");
            // The dictionary's own bias, tests/laws_dictionary.rs: 6 % of one axis where levels are 0, less elsewhere.
            assert!(
                (sum - 1.0).abs() < 5.0 * deviation + 0.05,
                "{facets} {slope:?}: {sum} +- {deviation}"
            );
        }
    }
}

/// Law C9, with its figures: the relative variance of one cell at 0.79 deviations, by level.
#[test]
fn a_cell_varies_as_stated() {
    let stated = [
        57.6, 17.1, 6.0, 2.0, 0.91, 0.37, 0.18, 0.089, 0.048, 0.022, 0.011, 0.0058, 0.0031, 0.0016,
    ];
    let dictionary =
        Dictionary::<f64>::new(&Recipe { means: Means::Published, ..Recipe::default() })
            .expect("valid");
    let ours = facets::dictionary();
    for (level, stated) in stated.into_iter().enumerate() {
        let variance = |dictionary: &Dictionary<f64>| {
            let (mut sum, mut squares, count) = (0.0, 0.0, 30_000);
            for index in 0..count {
                let mut source = Source::from_seed(index);
                let (sin, cos) = source.uniform(0.0, 1.6).sin_cos();
                let p = [cos, sin].map(|x| {
                    dictionary.marginal(source.pick(192) as u32, level as u32).density(0.79 * x)
                });
                sum += p[0] * p[1];
                squares += p[0] * p[0] * p[1] * p[1];
            }
            let mean = sum / count as f64;
            squares / count as f64 / (mean * mean) - 1.0
        };
        let [published, ours] = [&dictionary, ours].map(variance);
        println!("level {level}: {published} {ours}, stated {stated}");
        assert!(
            (published / stated - 1.0).abs() < 0.3,
            "level {level}: {published}, stated {stated}"
        );
        assert!((ours / stated - 1.0).abs() < 0.5, "level {level}: {ours}, stated {stated}");
    }
}

/// Law C10: nothing jumps, across levels, borders of cells or the smallest cell.
#[test]
fn pixels_change_as_little_as_they_move() {
    check(4000, |source| {
        let size = source.log_uniform(1e-3, 30.0);
        let uv = [source.uniform(-9.0, 9.0), source.uniform(-9.0, 9.0)];
        let mut side = || [size * source.uniform(-1.0, 1.0), size * source.uniform(-1.0, 1.0)];
        let (right, up) = (side(), side());
        let material = MultiLobe::new(roughness(), 1.0)
            .expect("in range")
            .with_seed(source.pick(1 << 30) as u32);
        let step = 1e-8;
        let at = |k: f64| {
            let grown = |d: [f64; 2]| d.map(|x| x * (1.0 + k * step));
            let patch = Patch::new(uv.map(|x| x + k * step * size), grown(right), grown(up));
            material.lobe(dictionary(), &patch).slope_pdf([0.1, 0.05])
        };
        let (a, b) = (at(0.0), at(1.0));
        // Densities of one cell lie below 50 / (2 pi sigma sigma).
        near(a, b, 1e-3, &(uv, right, up))
    });
}

/// Normal maps enter through the covariance, and M with its correlation carries it.
#[test]
fn moments_enter_through_the_covariance() {
    let moments = SlopeMoments::new([0.0, 0.0], Psd::new(0.02, -0.01, 0.03).expect("valid"))
        .expect("in range");
    let pixel = pixel(50.0_f64.exp(), 3).over(&moments);
    let sum = Roughness::from_covariance(roughness().covariance().plus(&moments.covariance()));
    let want = Beckmann::new(Full::new(sum)).slope_pdf([0.2, 0.1]);
    assert!((pixel.slope_pdf([0.2, 0.1]) / want - 1.0).abs() < 1e-12);
}

/// Law B1: no input is answered by no number.
#[test]
fn any_input_gives_a_number() {
    let dictionary =
        Dictionary::<f32>::new(&Recipe { levels: 6, ..Recipe::default() }).expect("valid");
    let odd = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        0.0,
        1e-45,
        1e-30,
        -1.0,
        0.3,
        1e9,
        1e30,
        f32::MAX,
    ];
    for seed in 0..20_000 {
        let mut source = Source::from_seed(seed);
        let mut any = || odd[source.pick(odd.len() as u64) as usize];
        let patch = Patch::new([any(), any()], [any(), any()], [any(), any()]);
        let (slope, wo, wi) = ([any(), any()], [any(), any(), any()], [any(), any(), any()]);
        let kernel =
            Kernel::of(&Footprint::from_slopes([any(), any()], [any(), any()]), PixelFilter::BOX);
        let alpha = [0.0, 1e-20, 0.1, 1e9][source.pick(4) as usize];
        let roughness = Roughness::from_alphas(alpha, 0.3, 0.2).expect("in range");
        let density = [1e-18, 1.0, 1e18][source.pick(3) as usize];
        let pixel = MultiLobe::new(roughness, density).expect("in range").lobe(&dictionary, &patch);
        for pixel in [pixel, pixel.widened(&kernel)] {
            for got in [pixel.slope_pdf(slope), pixel.brdf(wo, wi), pixel.pdf(wo, wi), pixel.d(wo)]
            {
                assert!(
                    got >= 0.0 && got.is_finite(),
                    "{seed}: {patch:?} {slope:?} {wo:?} {wi:?} {alpha} {got}"
                );
            }
        }
    }
}
