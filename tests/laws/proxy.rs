//! Laws of proxies: a GGX that is as high at its center as GGX under the pixel, against quadrature.

use crate::common::arbitrary::Ellipse;
use crate::common::quadrature::{adaptive, trapezoid};
use crate::common::{ULP, check, ensure, near};
use core::f64::consts::{FRAC_1_PI, PI};
use lobe::filter::{box_peak_alpha, gaussian_peak_alpha};
use lobe::{Anisotropic, Footprint, Ggx, Kernel, PixelFilter, Psd, Real, Roughness};

/// L^-1 v with L L^T = A.
fn whitened(ellipse: &Ellipse, v: [f64; 2]) -> [f64; 2] {
    let Ellipse { x, y, rho } = *ellipse;
    let first = v[0] / x;
    [first, (v[1] - rho * y * first) / (y * ((1.0 - rho) * (1.0 + rho)).sqrt())]
}

/// Axes of u u^T + v v^T, the larger first: singular values, so that the smaller keeps its digits.
fn axes(u: [f64; 2], v: [f64; 2]) -> [f64; 2] {
    let sides = nalgebra::Matrix2::new(u[0], v[0], u[1], v[1]);
    let long = sides.singular_values().max();
    let area = (u[0] * v[1] - u[1] * v[0]).abs();
    if long > 0.0 { [long * long, (area / long) * (area / long)] } else { [0.0; 2] }
}

/// The peak of the unit GGX under the Gaussian with 2 Sigma = diag(a, b), in units of its own,
/// 1/pi.
///
/// The convolution in polar coordinates, u half the squared radius in deviations; the mean over
/// angles of 1/(p + q cos)^2 is p/(p^2 - q^2)^(3/2). With u = e^y analytic for |Im y| < pi/2.
fn gaussian_peak([a, b]: [f64; 2]) -> f64 {
    let mut over_u = |y: f64| {
        let u = y.exp();
        let product = (1.0 + a * u) * (1.0 + b * u);
        u * (-u).exp() * (1.0 + 0.5 * (a + b) * u) / (product * product.sqrt())
    };
    trapezoid(&mut over_u, 36.0 + (1.0 + a).ln(), 0.2)
}

/// The mean of the unit GGX over +- u/2 +- v/2, in units of its peak: exact along the longer side,
/// adaptive across.
fn polygon_peak(u: [f64; 2], v: [f64; 2]) -> f64 {
    let square = |w: [f64; 2]| w[0] * w[0] + w[1] * w[1];
    let (long, across) = if square(u) >= square(v) { (u, v) } else { (v, u) };
    let length = square(long).sqrt();
    if length < 1e-9 {
        return 1.0;
    }
    let [c, s] = long.map(|x| x / length);
    let (along, height) = (c * across[0] + s * across[1], (c * across[1] - s * across[0]).abs());
    // Integral from 0 to t of 1/(q + t^2)^2.
    let line = |t: f64, q: f64| 0.5 * (t / (q + t * t) + (t / q.sqrt()).atan() / q.sqrt()) / q;
    let mut mean = |y: f64| {
        let (middle, q) = (y * along, 1.0 + (y * height).powi(2));
        (line(middle + 0.5 * length, q) - line(middle - 0.5 * length, q)) / length
    };
    2.0 * adaptive(&mut mean, 0.0, 0.5, 1e-12)
}

/// A kernel's two deviation vectors as a kernel.
fn kernel<R: Real>([u, v]: [[f64; 2]; 2]) -> Kernel<R> {
    Kernel::from_covariance(Psd::outer_sum(u.map(R::lit), v.map(R::lit)))
}

fn peak<R: Real>(roughness: &Roughness<R>) -> f64 {
    Ggx::new(Anisotropic::new(*roughness)).slope_pdf([R::ZERO; 2]).to_f64()
}

/// By how much a rounding of A's entries moves its determinant.
fn conditioning(ellipse: &Ellipse) -> f64 {
    1.0 / ((1.0 - ellipse.rho) * (1.0 + ellipse.rho))
}

#[test]
fn the_proxy_under_a_gaussian_has_the_exact_peak() {
    check(4000, |source| {
        let (ellipse, vectors) = (source.ellipse(), source.kernel());
        let root = 2.0_f64.sqrt();
        let [u, v] = vectors.map(|d| whitened(&ellipse, d.map(|x| root * x)));
        let want = gaussian_peak(axes(u, v)) * FRAC_1_PI / ellipse.root_det();
        let got = peak(&ellipse.roughness::<f64>().peak_matched(&kernel(vectors)));
        let tolerance = 4e-12 + 8.0 * ULP * conditioning(&ellipse);
        near(got, want, tolerance * want, &(ellipse, vectors))
    });
}

#[test]
fn the_proxy_over_a_footprint_has_the_exact_peak() {
    check(4000, |source| {
        let (ellipse, footprint) = (source.ellipse(), source.footprint());
        let [u, v] = [footprint.u, footprint.v].map(|d| whitened(&ellipse, d));
        let want = polygon_peak(u, v) * FRAC_1_PI / ellipse.root_det();
        let got = peak(&ellipse.roughness::<f64>().peak_matched_over(&footprint));
        let tolerance = 1e-10 + 8.0 * ULP * conditioning(&ellipse);
        near(got, want, tolerance * want, &(ellipse, footprint))
    });
}

#[test]
fn isotropic_proxies_are_the_closed_forms() {
    check(4000, |source| {
        let (alpha, size) = (source.log_uniform(1e-4, 30.0), source.log_uniform(1e-5, 1e3));
        let base = Roughness::from_alpha(alpha).expect("in range");
        let square = Footprint::rectangle([size, size]);
        let over = base.peak_matched_over(&square).alphas().major;
        let want = box_peak_alpha(alpha, size).expect("in range");
        near(over, want, 1e-10 * want, &("box", alpha, size))?;
        let under = base.peak_matched(&kernel([[size, 0.0], [0.0, size]])).alphas().major;
        let want = gaussian_peak_alpha(alpha, size).expect("in range");
        near(under, want, 4e-12 * want, &("Gaussian", alpha, size))
    });
}

/// A mirror along one axis only: the kernel gives it a width, and the peak is exact there too.
#[test]
fn the_proxy_of_half_a_mirror_has_the_exact_peak() {
    for alpha in [1e-3, 0.1, 5.0] {
        let base = Roughness::from_alphas(alpha, 0.0, 0.0).expect("in range");
        for (x, y) in [(0.0, 0.1), (0.1, 0.1), (1.0, 0.01), (0.001, 0.3)] {
            // A limit: along y the whitened kernel has no end. Its peak falls like 1/sqrt(b).
            let small = 1e-10;
            let (a, b) = (2.0 * (x / alpha) * (x / alpha), 2.0 * (y / small) * (y / small));
            let want = gaussian_peak([b.max(a), b.min(a)]) * FRAC_1_PI / (alpha * small);
            let kernel = kernel([[x, 0.0], [0.0, y]]);
            let matched = peak(&base.peak_matched(&kernel)) / want - 1.0;
            assert!(matched.abs() < 1e-8, "{matched:e} at {alpha}, {x}, {y}");
            let fitted = peak(&base.peak_fitted(&kernel)) / want - 1.0;
            assert!(fitted.abs() < FIT, "{fitted:e} at {alpha}, {x}, {y}");
        }
    }
}

/// As peak_fitted states: of the peak, for any kernel; of alpha'^2, for isotropic ones.
const FIT: f64 = 0.0132;
const ROUND_FIT: f64 = 4e-4;

#[test]
fn the_fit_of_the_peak_errs_as_stated() {
    let alpha = 0.3_f64;
    let base = Roughness::from_alpha(alpha).expect("in range");
    let fitted = |a: f64, b: f64| {
        let [x, y] = [a, b].map(|k| alpha * (0.5 * k).sqrt());
        base.peak_fitted(&kernel([[x, 0.0], [0.0, y]])).matrix().root_det() / (alpha * alpha)
    };
    let mut worst = (0.0, 0.0, 0.0);
    for major in (-60..=160).map(|k| 10.0_f64.powf(0.05 * f64::from(k))) {
        let aspects = (0..=120).map(|k| 10.0_f64.powf(-0.1 * f64::from(k)));
        for minor in aspects.map(|aspect| major * aspect).chain([0.0]) {
            let error = (1.0 / (fitted(major, minor) * gaussian_peak([major, minor])) - 1.0).abs();
            if error > worst.0 {
                worst = (error, major, minor);
            }
        }
    }
    assert!(worst.0 <= FIT && worst.0 >= 0.85 * FIT, "{worst:?}, stated: {FIT}");
    let mut worst = (0.0, 0.0);
    for kappa in (-800..=800).map(|k| 10.0_f64.powf(0.01 * f64::from(k))) {
        let error = (fitted(kappa, kappa) * gaussian_peak([kappa, kappa]) - 1.0).abs();
        if error > worst.0 {
            worst = (error, kappa);
        }
    }
    let holds = worst.0 <= ROUND_FIT && worst.0 >= 0.85 * ROUND_FIT;
    assert!(holds, "{worst:?}, stated: {ROUND_FIT}");
}

/// Turned and stretched with the lobe, the fit is the same: it knows the whitened kernel only.
#[test]
fn the_fit_of_the_peak_holds_for_any_roughness() {
    check(10_000, |source| {
        let (ellipse, vectors) = (source.ellipse(), source.kernel());
        let root = 2.0_f64.sqrt();
        let [u, v] = vectors.map(|d| whitened(&ellipse, d.map(|x| root * x)));
        let want = gaussian_peak(axes(u, v)) * FRAC_1_PI / ellipse.root_det();
        let got = peak(&ellipse.roughness::<f64>().peak_fitted(&kernel(vectors)));
        near(got, want, FIT * want, &(ellipse, vectors))
    });
}

/// t of A + t K lies where it is said to, where K is large enough to tell, and has its limits.
#[test]
fn the_factor_lies_in_its_range() {
    let factor = |base: &Roughness<f64>, after: &Roughness<f64>, added: f64| {
        (after.matrix().trace() - base.matrix().trace()) / added
    };
    check(10_000, |source| {
        let (ellipse, footprint) = (source.ellipse(), source.footprint());
        let (base, added) = (ellipse.roughness(), Psd::outer_sum(footprint.u, footprint.v).trace());
        if added < 1e-6 * base.matrix().trace() {
            return Ok(());
        }
        let kernel = Kernel::of(&footprint, PixelFilter::BOX);
        let double = 2.0 * kernel.covariance().trace();
        let few = 1e-9;
        let inputs = (ellipse, footprint);
        for after in [base.peak_matched(&kernel), base.peak_fitted(&kernel)] {
            let t = factor(&base, &after, double);
            ensure((1.0 - few..=2.0 + few).contains(&t), "t within [1, 2]", &(inputs, t))?;
        }
        let t = factor(&base, &base.peak_matched_over(&footprint), added);
        let range = 2.0 / PI / PI - few..=4.0 / PI / PI + few;
        ensure(range.contains(&t), "t within [2/pi^2, 4/pi^2]", &(inputs, t))
    });
    let base = Roughness::from_alpha(1.0).expect("in range");
    for (size, line, want) in [
        (1e-3, false, 1.0 / 3.0),
        (1e-3, true, 1.0 / 3.0),
        (1e5, false, FRAC_1_PI),
        (1e5, true, 4.0 / PI / PI),
    ] {
        let footprint = Footprint::rectangle([size, if line { 0.0 } else { size }]);
        let added = Psd::outer_sum(footprint.u, footprint.v).trace();
        let t = factor(&base, &base.peak_matched_over(&footprint), added);
        assert!((t / want - 1.0).abs() < 1e-4, "{t} {want} at {size}, line {line}");
    }
}
