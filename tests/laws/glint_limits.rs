//! Glints at their limits: probabilities, grooves, brightness, lights, masking, and any input at
//! all (laws Z5, Z6, Z11, B1).
#![cfg(feature = "glint")]

use crate::common::arbitrary::Source;
use crate::common::{ODD, check, ensure, near};
use lobe::material::cells::Patch;
use lobe::material::glint::{Biscale, GlintNdf, Glints, light_blur};
use lobe::slope::direction::{half_vector, normal_of, normalize, reflect, slope_of};
use lobe::{Beckmann, Error, Kernel, Psd, Roughness, SlopeMoments};

/// A glittering material of any kind.
fn glints(source: &mut Source) -> Glints<f64> {
    let alphas = [source.log_uniform(1e-3, 2.0), source.log_uniform(1e-3, 2.0)];
    let mut fraction = || if source.pick(4) == 0 { 1.0 } else { source.log_uniform(1e-3, 1.0) };
    let fractions = [fraction(), fraction()];
    let biscale = Biscale::from_fractions(alphas, fractions).expect("in range");
    let variation = if source.pick(2) == 0 { 0.0 } else { source.uniform(0.0, 3.0) };
    let glints = Glints::new(biscale, source.log_uniform(1e-2, 1e8)).expect("in range");
    glints.with_variation(variation).expect("in range").with_seed(source.pick(1 << 32) as u32)
}

fn patch(source: &mut Source) -> Patch<f64> {
    let size = source.log_uniform(1e-4, 10.0);
    let mut any = || size * source.uniform(-1.0, 1.0);
    let (right, up) = ([any(), any()], [any(), any()]);
    Patch::new([source.uniform(-9.0, 9.0), source.uniform(-9.0, 9.0)], right, up)
}

fn psd(source: &mut Source) -> Psd<f64> {
    let size = source.log_uniform(1e-4, 1.0);
    let mut side = || [size * source.uniform(-1.0, 1.0), size * source.uniform(-1.0, 1.0)];
    Psd::outer_sum(side(), side())
}

fn above(source: &mut Source) -> [f64; 3] {
    normalize([source.uniform(-2.0, 2.0), source.uniform(-2.0, 2.0), source.log_uniform(1e-3, 1.0)])
}

/// Law Z6, for every material, half vector, light and kernel.
#[test]
fn probabilities_lie_in_0_to_1() {
    check(50_000, |source| {
        let (glints, h) = (glints(source), above(source));
        let blur = source.pick(2) as f64 * source.log_uniform(1e-8, 1e3);
        let kernel = Kernel::from_covariance(psd(source));
        for pixel in [glints.ndf(&patch(source)), glints.ndf(&patch(source)).widened(&kernel)] {
            let p = pixel.probability(h, blur);
            ensure((0.0..=1.0).contains(&p), "a probability", &(glints, h, blur, p))?;
        }
        Ok(())
    });
}

/// A local roughness is never above the global one: entries, determinant, and along any direction.
#[test]
fn a_biscale_lobe_holds_no_local_roughness_above_the_global_one() {
    check(20_000, |source| {
        let matrix = |source: &mut Source| Roughness::from_matrix(psd(source));
        let biscale = Biscale::new(matrix(source), matrix(source));
        let kernel = Kernel::from_covariance(psd(source));
        let moments = SlopeMoments::new([0.1, 0.2], psd(source)).expect("in range");
        for biscale in [biscale, biscale.widened(&kernel), biscale.over(&moments)] {
            let (local, global) = (biscale.local().matrix(), biscale.global().matrix());
            let w = [source.uniform(-1.0, 1.0), source.uniform(-1.0, 1.0)];
            let (inner, outer) = (local.quadratic(w), global.quadratic(w));
            ensure(inner <= outer * (1.0 + 1e-9), "along a direction", &(biscale, w))?;
            let (inner, outer) = (local.root_det(), global.root_det());
            ensure(inner <= outer * (1.0 + 1e-9), "in all", &biscale)?;
        }
        Ok(())
    });
}

#[test]
fn fractions_make_the_alphas_that_they_say() {
    check(10_000, |source| {
        let (alpha, f) = (source.log_uniform(1e-6, 1e6), source.uniform(1e-6, 1.0));
        let biscale = Biscale::from_fractions([alpha, 0.5 * alpha], [f, 1.0]).expect("in range");
        let [xx, xy, yy] = biscale.global().matrix().entries();
        near(xx, alpha * alpha, 1e-14 * alpha * alpha, &(alpha, f))?;
        near(yy, 0.25 * alpha * alpha, 1e-14 * alpha * alpha, &(alpha, f))?;
        ensure(xy == 0.0, "turned", &biscale)?;
        let [local, ..] = biscale.local().matrix().entries();
        near(local, f * f * alpha * alpha, 1e-14 * f * f * alpha * alpha, &(alpha, f))?;
        let [.., spread] = biscale.spread().matrix().entries();
        ensure(spread == 0.0, "grooves have a spread along them", &biscale)
    });
}

/// Law Z11: along a groove nothing changes, neither place nor random numbers; across it, they do.
#[test]
fn a_groove_is_the_same_along_its_length() {
    for along in [0, 1] {
        let pair =
            |across: f64, here: f64| if along == 1 { [across, here] } else { [here, across] };
        let biscale = Biscale::from_fractions([0.4, 0.4], pair(0.05, 1.0)).expect("in range");
        let glints = Glints::new(biscale, 1e8).expect("in range");
        let mut changes = 0;
        for k in 0..2000 {
            let mut source = Source::from_seed(k);
            let (across, size) = (source.uniform(-3.0, 3.0), source.log_uniform(1e-3, 0.05));
            let at = |here: f64, across: f64| {
                let (right, up) = (pair(size, 0.0), pair(0.0, 3.0 * size));
                glints.ndf(&Patch::new(pair(across, here), right, up))
            };
            let h = normal_of(pair(source.uniform(-0.3, 0.3), source.uniform(-0.3, 0.3)));
            let here = at(source.uniform(-3.0, 3.0), across).sparkle(h, 0.0);
            let there = at(source.uniform(-3.0, 3.0), across).sparkle(h, 0.0);
            assert!((here - there).abs() <= 1e-9 * here, "{here}, {there}");
            // Nor does the half vector's slope along it matter to the count.
            let [x, y] = slope_of(h);
            let turned = normal_of(if along == 1 { [x, y + 0.1] } else { [x + 0.1, y] });
            let there = at(0.0, across).sparkle(turned, 0.0);
            assert!((here - there).abs() <= 1e-9 * here, "{here}, {there}");
            changes += u32::from(at(0.0, across + 5.0 * size).sparkle(h, 0.0) != here);
        }
        assert!(changes > 1500, "{changes} of 2000 change across");
    }
}

/// A pixel is never brighter than two details seen along their normals, whatever their number:
/// whole numbers no more than one, and real ones are as many trials as the next whole number.
#[test]
fn no_pixel_is_brighter_than_two_details() {
    check(30_000, |source| {
        let (glints, patch, h) = (glints(source), patch(source), above(source));
        let pixel: GlintNdf<f64> = glints.ndf(&patch);
        let (sparkle, p) = (pixel.sparkle(h, 0.0), pixel.probability(h, 0.0));
        ensure(sparkle >= 0.0 && sparkle.is_finite(), "not a number", &(glints, patch, h))?;
        ensure(
            sparkle * p <= 2.0 + 1e-12 || p < 1e-30,
            "too bright",
            &(glints, patch, h, sparkle, p),
        )
    });
}

/// Law Z5: within one angular bin of every cell, light changes as little as the pixel moves.
#[test]
fn nothing_jumps_as_the_pixel_moves() {
    check(20_000, |source| {
        let (glints, patch) = (glints(source), patch(source));
        // Along the surface's normal: no motion changes the bin.
        let h = [0.0, 0.0, 1.0];
        let pixel = glints.ndf(&patch);
        let size = f64::powi(2.0, pixel.grid().exponent());
        let step = 1e-9;
        let uv = patch.uv.map(|x| x + step * size);
        let moved = glints.ndf(&Patch { uv, ..patch });
        let p = pixel.probability(h, 0.0);
        // Shares change by a few steps; what they are shares of is at most 2/P.
        let allowed = 100.0 * step / p.max(1e-30);
        near(moved.sparkle(h, 0.0), pixel.sparkle(h, 0.0), allowed, &(glints, patch))
    });
}

#[test]
fn masking_is_that_of_the_smooth_lobe() {
    check(10_000, |source| {
        let (glints, patch) = (glints(source), patch(source));
        let moments =
            SlopeMoments::new([source.uniform(-0.5, 0.5), 0.1], psd(source)).expect("in range");
        let pixel = glints.ndf(&patch).over(&moments);
        let (wo, wi) = (above(source), above(source));
        let radius = source.log_uniform(1e-4, 0.1);
        let smooth = Beckmann::new(pixel.smooth_lobe().shape()).brdf(wo, wi);
        let h = half_vector(wo, wi);
        let want = smooth * pixel.sparkle(h, light_blur(wo, wi, radius));
        near(pixel.brdf(wo, wi, radius), want, 1e-12 * want, &(glints, wo, wi))?;
        let pdf = Beckmann::new(pixel.smooth_lobe().shape()).slope_pdf(slope_of(h))
            * pixel.sparkle(h, 0.0);
        near(pixel.slope_pdf(h, 0.0), pdf, 1e-12 * pdf, &(glints, h))?;
        ensure(pixel.slope_pdf([0.6, 0.0, -0.8], 0.0) == 0.0, "below the horizon", &glints)?;
        ensure(pixel.brdf([0.6, 0.0, -0.8], wi, 0.0) == 0.0, "from below", &glints)
    });
}

/// A light's blur is the area of the slopes of its half vectors over pi: by rays to its rim.
#[test]
fn a_light_s_blur_is_the_area_of_its_half_vectors() {
    check(5_000, |source| {
        let (wo, h) = (above(source), above(source));
        let wi = reflect(wo, h);
        if wi[2] < 0.05 || wo[2] < 0.05 || h[2] < 0.3 {
            return Ok(());
        }
        let radius = 1e-4;
        let side = if wi[0].abs() < 0.6 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        let x = normalize(cross(wi, side));
        let y = cross(wi, x);
        let rim: Vec<[f64; 2]> = (0..720)
            .map(|k| {
                let (sin, cos) = (f64::from(k) * core::f64::consts::TAU / 720.0).sin_cos();
                let light = [0, 1, 2].map(|k| wi[k] + radius * (cos * x[k] + sin * y[k]));
                slope_of(half_vector(wo, normalize(light)))
            })
            .collect();
        let center = slope_of(half_vector(wo, wi));
        let spokes: Vec<[f64; 2]> =
            rim.iter().map(|s| [s[0] - center[0], s[1] - center[1]]).collect();
        let turns = spokes.iter().zip(spokes.iter().cycle().skip(1));
        let area: f64 = turns.map(|(a, b)| 0.5 * (a[0] * b[1] - a[1] * b[0])).sum();
        let want = area.abs() / core::f64::consts::PI;
        near(light_blur(wo, wi, radius), want, 1e-3 * want, &(wo, wi))
    });
}

/// Law B1: no finite or infinite number, nor NaN, makes one that is not a number.
#[test]
fn any_input_gives_a_number() {
    let odd = ODD.map(|x| x as f32);
    for seed in 0..100_000 {
        let mut source = Source::from_seed(seed);
        let mut any = || odd[source.pick(odd.len() as u64) as usize];
        let clean = |x: f32, range: [f32; 2]| {
            if x.is_nan() { range[0] } else { x.clamp(range[0], range[1]) }
        };
        let alphas = [any(), any()].map(|x| clean(x, [0.0, 1e9]));
        let fractions = [any(), any()].map(|x| clean(x, [1e-30, 1.0]));
        let biscale = Biscale::from_fractions(alphas, fractions).expect("in range");
        let patch = Patch::new([any(), any()], [any(), any()], [any(), any()]);
        let (density, variation) = (clean(any(), [1e-18, 1e18]), clean(any(), [0.0, 4.0]));
        let glints = Glints::new(biscale, density).expect("in range");
        let glints = glints.with_variation(variation).expect("in range");
        let wide = Psd::outer_sum([1e5, 0.0], [0.0, clean(any(), [0.0, 1e9])]);
        let moments = SlopeMoments::new([clean(any(), [-1e9, 1e9]), 0.0], wide).expect("in range");
        let (h, blur) = ([any(), any(), any()], any());
        for pixel in [glints.ndf(&patch), glints.ndf(&patch).over(&moments)] {
            let unit = normalize(h);
            let results = [
                pixel.sparkle(unit, blur),
                pixel.slope_pdf(unit, blur),
                pixel.brdf(unit, normalize([h[1], h[2], h[0]]), blur),
                pixel.probability(unit, blur),
            ];
            let valid = results.iter().all(|x| *x >= 0.0 && x.is_finite());
            let whole = unit.iter().all(|x| x.is_finite()) && !blur.is_nan();
            // Of a half vector of NaN nothing is promised but that it is no negative number.
            assert!(valid || !whole, "{glints:?}, {patch:?}, {h:?}, {blur}: {results:?}");
        }
    }
}

#[test]
fn constructors_refuse_what_has_no_meaning() {
    for bad in [0.0, -0.1, 1.1, f64::NAN] {
        assert!(matches!(Biscale::from_fractions([0.5, 0.5], [bad, 0.5]), Err(Error::Fraction(_))));
    }
    assert!(matches!(Biscale::from_fractions([-0.5, 0.5], [0.5, 0.5]), Err(Error::AlphaX(_))));
    assert!(matches!(Biscale::from_fractions([0.5, f64::NAN], [0.5, 0.5]), Err(Error::AlphaY(_))));
    let biscale = Biscale::from_fractions([0.5, 0.5], [0.1, 0.1]).expect("in range");
    for bad in [0.0, -1.0, 1e19, f64::NAN, f64::INFINITY] {
        assert!(matches!(Glints::new(biscale, bad), Err(Error::Density(_))));
    }
    let glints = Glints::new(biscale, 1.0).expect("in range");
    for bad in [-0.1, 4.1, f64::NAN] {
        assert!(matches!(glints.with_variation(bad), Err(Error::Variation(_))));
    }
    for bad in [-0.1, 1.1, f64::NAN] {
        assert!(matches!(glints.with_share(bad), Err(Error::Share(_))));
    }
}
