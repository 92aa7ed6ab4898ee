//! Many lobes at their limits: nothing jumps, nothing is no number, and what is out of range is
//! refused (laws C10, B1).
#![cfg(feature = "glint")]

use crate::common::ODD;
use crate::common::arbitrary::Source;
use crate::common::facets::{dictionary, kernels, roughness, surface};
use lobe::material::cells::Patch;
use lobe::material::multilobe::{Dictionary, MultiLobe, PatchNdf, Recipe};
use lobe::{Error, Footprint, Kernel, PixelFilter, Psd, Real, Roughness, SlopeMoments};
use std::f64::consts::SQRT_2;

/// How far from a border either side of it is.
const STEP: f64 = 1e-9;

/// The densities on both sides of a border, at some slopes: what a jump changes, rounding does not.
#[track_caller]
fn assert_continuous(what: &str, pixel: impl Fn(f64) -> PatchNdf<'static, f64>) {
    let [[a, b], [_, c]] = roughness().chermain_matrix(1.0);
    let [before, after] = [-STEP, STEP].map(pixel);
    for [x, y] in [[0.0, 0.0], [0.4, 0.3], [-0.9, 1.1], [1.6, -0.2]] {
        let slope = [a * x + b * y, c * y];
        let (p, q) = (before.slope_pdf(slope), after.slope_pdf(slope));
        // A lobe's density changes by up to 1e3 times its peak from one of its deviations to the
        // next: steps are no more than that. Of one cell that comes or goes at once 1e-2 is seen.
        assert!((p - q).abs() < 1e-5 * (1.0 + p), "{what}, at {x} {y}: {p} and {q}");
    }
}

/// Law C10: across levels, the smallest cell, the longest pixel, rims of the ellipse that meet a
/// cell's middle, and borders of cells.
#[test]
fn pixels_change_as_little_as_they_move() {
    for seed in 0..40 {
        let mut source = Source::from_seed(seed.into());
        let uv = [source.uniform(-9.0, 9.0), source.uniform(-9.0, 9.0)];
        let turn = source.uniform(0.0, 7.0);
        let turned = |long: f64, short: f64| {
            let (sin, cos) = turn.sin_cos();
            ([long * cos, long * sin], [-short * sin, short * cos])
        };
        for power in [-3, 0, 4] {
            let width = 2.0_f64.powi(power);
            assert_continuous("a level", |step| {
                let (right, up) = turned(1.7 * width, width * (1.0 + step));
                surface(30.0 / (width * width), seed).ndf(dictionary(), &Patch::new(uv, right, up))
            });
        }
        // A facet's square of 2^-2, also where its own level ends.
        for density in [16.0, 11.0] {
            let size = 1.0 / f64::sqrt(density);
            assert_continuous("the smallest cell", |step| {
                let (right, up) = turned(1.2 * size, size * (1.0 + step));
                surface(density, seed).ndf(dictionary(), &Patch::new(uv, right, up))
            });
        }
        assert_continuous("the longest pixel", |step| {
            let (right, up) = turned(8.0 * (1.0 + step), 1.0);
            surface(3.0, seed).ndf(dictionary(), &Patch::new(uv, right, up))
        });
        // Around a cell's middle a radius of sqrt(2) cells reaches those of the four that meet its
        // corners.
        assert_continuous("a rim", |step| {
            let side = 1.0 + step * SQRT_2;
            let patch = Patch::new([0.5, 0.5], [side, 0.0], [0.0, side]);
            surface(30.0, seed).ndf(dictionary(), &patch)
        });
        assert_continuous("a border of cells", |step| {
            let patch = Patch::new([3.0 + step, -2.0 - step], [1.0, 0.2], [0.1, 1.4]);
            surface(30.0, seed).ndf(dictionary(), &patch)
        });
    }
}

/// The same of kernels: round ones that get long, a piece that gets one more beside it, or meets a
/// table no more.
#[test]
fn kernels_change_as_little_as_they_grow() {
    let [l, m, n] = roughness().covariance().cholesky();
    let kernel = |x: f64, y: f64| {
        let columns = Psd::outer_sum([x * l, x * m], [0.0, y * n]);
        Kernel::from_covariance(columns)
    };
    // A side of 1.5 deviations, in deviations of a box.
    let longest = 1.5 / 12.0_f64.sqrt();
    for seed in 0..40 {
        let patch = Patch::new([0.37 * f64::from(seed), 0.2], [1.0, 0.3], [0.1, 1.1]);
        let pixel = surface(30.0, seed).ndf(dictionary(), &patch);
        for pieces in [1.0, 3.0, 5.0, 7.0] {
            assert_continuous("a piece more", |step| {
                pixel.widened(&kernel(pieces * longest * (1.0 + step), 0.1))
            });
        }
        for side in [0.2, longest, 0.7] {
            assert_continuous("round", |step| pixel.widened(&kernel(side * (1.0 + step), side)));
            assert_continuous("of no more than a width", |step| {
                pixel.widened(&kernel(side, side * (1.0 + step)))
            });
        }
        assert_continuous("no kernel", |step| pixel.widened(&kernel(step.max(0.0), step.max(0.0))));
    }
}

/// Law B1: no input is answered by no number, in one precision.
fn any_input_gives_a_number<R: Real>() {
    let recipe = Recipe { levels: 6, ..Recipe::default() };
    let dictionary = Dictionary::<R>::new(&recipe).expect("valid");
    for seed in 0..20_000 {
        let mut source = Source::from_seed(seed);
        let mut any = || R::lit(ODD[source.pick(ODD.len() as u64) as usize]);
        let mut pair = || [any(), any()];
        let patch = Patch::new(pair(), pair(), pair());
        let (slope, mean) = (pair(), pair());
        let footprint = Footprint::from_slopes(pair(), pair());
        let ([a, b], [c, d], [e, f]) = (pair(), pair(), pair());
        let (wo, wi) = ([a, b, c], [d, e, f]);
        let mut pick = |from: &[f64]| R::lit(from[source.pick(from.len() as u64) as usize]);
        let alpha = pick(&[0.0, 1e-9, 0.1, 1e9]);
        let roughness = Roughness::from_alphas(alpha, R::lit(0.3), R::lit(0.2)).expect("in range");
        let facets = MultiLobe::new(roughness, pick(&[1e-18, 1.0, 1e18])).expect("in range");
        let facets = facets.with_share(pick(&[0.0, 0.5, 1.0])).expect("in range");
        let facets = facets.with_variation(pick(&[0.0, 2.0, 4.0])).expect("in range");
        let side = pick(&[0.0, 1e-9, 0.02, 1e9]);
        let round = Psd::new(side, R::ZERO, side).expect("valid");
        let pixel = facets.ndf(&dictionary, &patch);
        let over = SlopeMoments::new(mean, round).map_or(pixel, |moments| pixel.over(&moments));
        let kernels = [Kernel::of(&footprint, PixelFilter::BOX), Kernel::from_covariance(round)];
        let [any, round] = kernels.map(|kernel| over.widened(&kernel));
        for pixel in [pixel, over, any, round, pixel.with_mips(&footprint, R::HALF)] {
            for got in [pixel.slope_pdf(slope), pixel.brdf(wo, wi), pixel.pdf(wo, wi), pixel.d(wo)]
            {
                assert!(
                    got >= R::ZERO && got.is_finite(),
                    "{seed}: {patch:?} {slope:?} {wo:?} {wi:?} {alpha} {got}"
                );
            }
            let drawn = pixel.sample(wo, [R::HALF; 7]);
            assert!(drawn.is_none_or(|drawn| drawn.wi.iter().all(|x| x.is_finite())));
        }
    }
}

#[test]
fn any_input_gives_a_number_in_single_precision() {
    any_input_gives_a_number::<f32>();
}

#[test]
fn any_input_gives_a_number_in_double_precision() {
    any_input_gives_a_number::<f64>();
}

#[test]
fn surfaces_out_of_range_are_refused() {
    let roughness = roughness();
    for density in [0.0, -1.0, 9e-19, 1.1e30, f64::INFINITY, f64::NAN] {
        assert!(matches!(MultiLobe::new(roughness, density), Err(Error::Facets(_))), "{density}");
    }
    let good = MultiLobe::new(roughness, 1.0).expect("in range");
    for variation in [-1e-9, 4.1, f64::NAN] {
        assert!(matches!(good.with_variation(variation), Err(Error::Variation(_))), "{variation}");
    }
    for share in [-1e-9, 1.0 + 1e-9, f64::NAN] {
        assert!(matches!(good.with_share(share), Err(Error::Share(_))), "{share}");
    }
}

/// In f32 a pixel is that of f64, wherever its cells draw alike.
#[test]
fn single_precision_agrees_with_double() {
    let single = Dictionary::<f32>::new(&Recipe::default()).expect("valid");
    let mut far = 0;
    let mut count = 0;
    for kernel in kernels(roughness().covariance()) {
        let [xx, xy, yy] = kernel.covariance().entries().map(|x| x as f32);
        let narrow = Kernel::from_covariance(Psd::nearest(xx, xy, yy));
        for k in 0..200_u16 {
            let uv = [0.37 * f64::from(k), 0.2];
            let patch = Patch::new(uv, [1.0, 0.25], [-0.5, 1.5]);
            let wide = surface(30.0, 5).ndf(dictionary(), &patch).widened(&kernel);
            let [xx, xy, yy] = roughness().covariance().entries().map(|x| x as f32);
            let same = Roughness::from_covariance(Psd::nearest(xx, xy, yy));
            let same = MultiLobe::new(same, 30.0).expect("in range").with_seed(5);
            let patch = Patch::new(uv.map(|x| x as f32), [1.0, 0.25], [-0.5, 1.5]);
            let narrow = same.ndf(&single, &patch).widened(&narrow);
            for slope in [[0.0, 0.0], [0.2, 0.1], [-0.3, 0.05]] {
                let want = wide.slope_pdf(slope);
                let got = f64::from(narrow.slope_pdf(slope.map(|x| x as f32)));
                count += 1;
                // Steep sides of lobes take a rounding of a slope for a thousand of their own.
                far += u32::from((got - want).abs() > 1e-3 * (want + 0.1));
            }
        }
    }
    println!("{far} of {count} differ");
    // Of 25 cells each flips one in 30,000 its level: see tests/gpu/src/twins/facets.rs.
    assert!(f64::from(far) < 5e-3 * f64::from(count), "{far} of {count}");
}
