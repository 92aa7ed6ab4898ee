//! Laws of area lights as kernels, against quadrature over the light.

use crate::common::arbitrary::Source;
use crate::common::{check, ensure, near};
use core::f64::consts::TAU;
use lobe::filter::SphericalGaussian;
use lobe::slope::direction::{half_vector, slope_of};
use lobe::{Beckmann, Error, Footprint, Ggx, Kernel, Lobe, PixelFilter, Real, Roughness};
use proptest::test_runner::TestCaseResult;

type V3 = [f64; 3];

fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn unit(v: V3) -> V3 {
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

/// Two directions across `w`, not the library's.
fn across(w: V3) -> [V3; 2] {
    let t = unit(cross(w, if w[0].abs() < 0.5 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] }));
    [t, cross(w, t)]
}

/// The light's integral with a function of direction: midpoints in angle and in the Gaussian's own
/// measure.
fn over_light(wi: V3, sharpness: f64, f: &dyn Fn(V3) -> f64) -> f64 {
    const RINGS: usize = 400;
    const ANGLES: usize = 64;
    let [t, b] = across(wi);
    let total = 1.0 - (-2.0 * sharpness).exp();
    let mut sum = 0.0;
    for ring in 0..RINGS {
        // cos = 1 + ln(1 - u total)/lambda: every ring holds the same light.
        let u = (ring as f64 + 0.5) / RINGS as f64;
        let fall = (-u * total).ln_1p() / sharpness;
        let (cos, sin) = (1.0 + fall, (-fall * (2.0 + fall)).sqrt());
        for k in 0..ANGLES {
            let (s, c) = (TAU * (k as f64 + 0.5) / ANGLES as f64).sin_cos();
            sum += f([0, 1, 2].map(|i| wi[i] * cos + sin * (c * t[i] + s * b[i])));
        }
    }
    sum / (RINGS * ANGLES) as f64 * TAU / sharpness * total
}

#[test]
fn the_integral_is_that_of_the_light() {
    for sharpness in [1e-3, 0.5, 3.0, 100.0] {
        let wi = unit([0.3, -0.2, 0.9]);
        let light = SphericalGaussian::new(wi, sharpness).unwrap();
        let constant = over_light(wi, sharpness, &|_| 1.0);
        assert!((light.integral() / constant - 1.0).abs() < 1e-12);
    }
}

/// Derivatives of the slope and of the disk's point by differences, summed as outer products over
/// lambda.
fn kernels<R: Real>(source: &mut Source, tolerance: f64) -> TestCaseResult {
    let pair = source.pair();
    let [wo, wi] = pair.map(|w| unit([w[0], w[1], w[2].max(0.1)]));
    let sharpness = source.log_uniform(1.0, 1e6);
    let light = SphericalGaussian::new(wi.map(R::lit), R::lit(sharpness)).expect("in range");
    let step = 1e-5;
    let covariance = |point: &dyn Fn(V3) -> [f64; 2]| {
        let columns = across(wi).map(|t| {
            let at = |sign: f64| point(unit([0, 1, 2].map(|k| wi[k] + sign * step * t[k])));
            let (a, b) = (at(1.0), at(-1.0));
            [0, 1].map(|k| (a[k] - b[k]) / (2.0 * step))
        });
        [(0, 0), (0, 1), (1, 1)].map(|(i, j)| {
            (columns[0][i] * columns[0][j] + columns[1][i] * columns[1][j]) / sharpness
        })
    };
    let slopes = covariance(&|w| slope_of(half_vector(wo, w)));
    let disk = covariance(&|w| {
        let h = half_vector(wo, w);
        [h[0], h[1]]
    });
    let inputs = (wo, wi, sharpness);
    let got = light.kernel(wo.map(R::lit)).covariance().entries().map(Real::to_f64);
    let got_disk = light.disk_kernel(wo.map(R::lit)).covariance().entries().map(Real::to_f64);
    for k in 0..3 {
        near(got[k], slopes[k], tolerance * (slopes[0] + slopes[2]), &inputs)?;
        near(got_disk[k], disk[k], tolerance * (disk[0] + disk[2]), &inputs)?;
    }
    Ok(())
}

#[test]
fn kernels_are_the_half_vector_s_derivatives_by_the_light() {
    check(5000, |source| kernels::<f64>(source, 1e-7));
    check(5000, |source| kernels::<f32>(source, 1e-5));
}

/// The light's reflection against the widened lobe's: off by the order of 1/lambda.
fn reflection(wo: V3, wi: V3, alpha: f64, sharpness: f64) -> [f64; 2] {
    let light = SphericalGaussian::new(wi, sharpness).unwrap();
    let lobe = Lobe::centered(Roughness::from_alpha(alpha).unwrap());
    let widened = lobe.widened(&light.kernel(wo));
    let (sharp, wide) = (lobe.shape(), widened.shape());
    let lit = |brdf: f64| light.integral() * brdf * wi[2];
    let exact = |brdf: &dyn Fn(V3) -> f64| over_light(wi, sharpness, &|w| brdf(w) * w[2].max(0.0));
    let beckmann = exact(&|w| Beckmann::new(sharp).brdf(wo, w));
    let ggx = exact(&|w| Ggx::new(sharp).brdf(wo, w));
    [
        lit(Beckmann::new(wide).brdf(wo, wi)) / beckmann - 1.0,
        lit(Ggx::new(wide).brdf(wo, wi)) / ggx - 1.0,
    ]
}

#[test]
fn a_small_light_s_reflection_is_that_of_the_widened_lobe() {
    let wo = unit([0.5, 0.1, 0.8]);
    for alpha in [0.02, 0.05, 0.1] {
        for sharpness in [400.0, 1600.0, 6400.0] {
            let [beckmann, ggx] = reflection(wo, unit([-0.5, -0.1, 0.8]), alpha, sharpness);
            // At the mirror direction all that is wrong with Beckmann is of the second order.
            assert!(beckmann.abs() < 5e-3, "{alpha} {sharpness}: {beckmann}");
            // GGX: variance addition, at most a quarter too bright at the peak.
            assert!((0.0..0.25).contains(&ggx), "{alpha} {sharpness}: {ggx}");
        }
        // Beside the highlight the curvature of the map counts, less and less as the light shrinks.
        for (x, y) in [(-0.4, 0.0), (-0.55, -0.2)] {
            let wi = unit([x, y, 0.8]);
            let [wide, small] =
                [1600.0, 25_600.0].map(|sharpness| reflection(wo, wi, alpha, sharpness)[0].abs());
            assert!(
                small < 0.015 && small < 0.5 * wide.max(5e-3),
                "{alpha} ({x}, {y}): {wide} {small}"
            );
        }
    }
}

/// Light and pixel are one kernel; the light's own footprint is the same, seen as derivatives.
#[test]
fn lights_and_pixels_add_and_footprints_agree() {
    let (wo, wi) = (unit([0.3_f64, 0.2, 0.8]), unit([-0.4, 0.1, 0.9]));
    let light = SphericalGaussian::from_angular_radius(wi, 0.1).unwrap();
    assert!((light.sharpness() - 400.0).abs() < 1e-10);
    let by_footprint =
        Kernel::of(&light.footprint(wo), PixelFilter::with_variance(1.0 / 400.0).unwrap());
    let kernel = light.kernel(wo);
    let pixel = Kernel::of(&Footprint::rectangle([0.1, 0.1]), PixelFilter::BOX);
    let both = (kernel + pixel).covariance().entries();
    for k in 0..3 {
        let [a, b] = [kernel, by_footprint].map(|k| k.covariance().entries());
        assert!((a[k] - b[k]).abs() < 1e-15);
        assert!((both[k] - a[k] - pixel.covariance().entries()[k]).abs() < 1e-15);
    }
}

fn total(source: &mut Source) -> TestCaseResult {
    let [wo, wi] = source.pair();
    let (wo, wi) = (wo.map(|x| x as f32), wi.map(|x| x as f32));
    let sharpness = source.log_uniform(1e-9, 1e18) as f32;
    let Ok(light) = SphericalGaussian::new(wi, sharpness) else { return Ok(()) };
    let lobe = Roughness::from_alpha(source.log_uniform(1e-4, 1.0) as f32).expect("in range");
    let inputs = (wo, wi, sharpness);
    let slope = lobe.widened(&light.kernel(wo)).matrix();
    let disk = lobe.widened_on_disk(&light.disk_kernel(wo)).matrix();
    let sound = |m: lobe::Psd<f32>| m.entries().iter().all(|x| x.is_finite()) && m.root_det() > 0.0;
    ensure(sound(slope) && sound(disk), "lobes of numbers", &inputs)?;
    ensure(light.integral() > 0.0 && light.integral() <= 12.567, "at most 4 pi", &inputs)
}

#[test]
fn every_light_gives_a_lobe() {
    check(20_000, total);
}

#[test]
fn lights_out_of_range_are_refused() {
    let up = [0.0_f64, 0.0, 1.0];
    for bad in [[0.0_f64; 3], [f64::NAN, 0.0, 1.0], [f64::INFINITY, 0.0, 1.0]] {
        assert!(matches!(SphericalGaussian::new(bad, 1.0), Err(Error::Direction(_))));
    }
    // The least sharpness that f32 has is a wide light like its neighbors.
    let wide = |sharpness: f32| {
        let light = SphericalGaussian::new([0.0, 0.0, 1.0], sharpness).unwrap();
        light.kernel([0.0, 0.0, 1.0]).covariance().entries()[0]
    };
    assert!((wide(1e-9) / wide(1.0001e-9) - 1.0).abs() < 1e-3);
    for sharpness in [0.0, -1.0, 1e19, f64::NAN, f64::INFINITY] {
        assert!(matches!(SphericalGaussian::new(up, sharpness), Err(Error::Sharpness(_))));
    }
    for radius in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            SphericalGaussian::from_angular_radius(up, radius),
            Err(Error::Radius(_))
        ));
    }
    // Light from straight ahead of the viewer, from below: no half vector, no kernel.
    let below = SphericalGaussian::new([0.0_f64, 0.0, -1.0], 10.0).unwrap();
    assert_eq!(below.disk_kernel(up).covariance().entries(), [0.0; 3]);
    assert_eq!(below.kernel(up).covariance().entries(), [0.0; 3]);
}
