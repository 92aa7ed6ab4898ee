//! Limits of proxies and kernels: monotone, total, the same in both precisions, and what no proxy
//! has: the tail.
#![cfg(feature = "published")]

use crate::common::arbitrary::Source;
use crate::common::reference::same_factor;
use crate::common::{ULP_SINGLE, check, ensure, near};
use core::f64::consts::PI;
use core::fmt::Debug;
use lobe::filter::{box_peak_alpha, gaussian_peak_alpha, ggx_gaussian_mean, kaplanyan_proxy_alpha};
use lobe::{Anisotropic, Error, Footprint, Ggx, Kernel, Lobe, PixelFilter, Psd, Real, Roughness};
use proptest::test_runner::TestCaseResult;

#[test]
fn proxies_fall_as_the_kernel_grows() {
    check(4000, |source| {
        let (ellipse, footprint) = (source.ellipse(), source.footprint());
        let base = ellipse.roughness::<f64>();
        let factor = source.uniform(1.0, 2.0);
        let [u, v] = source.kernel();
        let other = Kernel::from_covariance(Psd::outer_sum(u, v));
        let narrow = Kernel::of(&footprint, PixelFilter::BOX);
        let wide = Kernel::of(&(footprint * factor), PixelFilter::BOX);
        let inputs = (ellipse, footprint, factor);
        let falls = |before: Roughness<f64>, after: Roughness<f64>, what: &str| {
            let (before, after) = (before.matrix().root_det(), after.matrix().root_det());
            ensure(after >= before * (1.0 - 1e-10), what, &(inputs, before, after))
        };
        falls(base, base.peak_matched(&narrow), "a kernel blunts")?;
        falls(base.peak_matched(&narrow), base.peak_matched(&wide), "a wider kernel blunts more")?;
        falls(
            base.peak_matched(&narrow),
            base.peak_matched(&(narrow + other)),
            "so does a second",
        )?;
        falls(base.peak_fitted(&narrow), base.peak_fitted(&wide), "so does the fit")?;
        let [narrow, wide] = [footprint, footprint * factor].map(|f| base.peak_matched_over(&f));
        falls(base, narrow, "a footprint blunts")?;
        falls(narrow, wide, "a larger one blunts more")
    });
}

/// How far the roundings of a footprint's sides move its area.
fn moved<R: Real>(footprint: &Footprint<R>) -> f64 {
    let (u, v) = (footprint.u.map(R::to_f64), footprint.v.map(R::to_f64));
    2.0 * R::EPSILON.to_f64() * ((u[0] * v[1]).abs() + (u[1] * v[0]).abs())
}

fn ends<R: Real>(source: &mut Source) -> TestCaseResult {
    let input = source.ellipse();
    let (base, none) = (input.roughness::<R>(), Kernel::<R>::default());
    let point = Footprint::default();
    let left = [base.peak_matched(&none), base.peak_fitted(&none), base.peak_matched_over(&point)];
    let stays = |after: &Roughness<R>| same_factor(&after.matrix(), &base.matrix(), 8.0);
    ensure(left.iter().all(stays), "no kernel leaves A", &(input, left))?;
    // A mirror becomes the kernel.
    let footprint = source.footprint();
    let footprint = Footprint { u: footprint.u.map(R::lit), v: footprint.v.map(R::lit) };
    let kernel = Kernel::of(&footprint, PixelFilter::KAPLANYAN);
    let (mirror, becomes) = (Roughness::default(), Roughness::from_covariance(kernel.covariance()));
    let few = 8.0 * R::EPSILON.to_f64();
    let (want, area) = (becomes.matrix().entries(), footprint.area().to_f64());
    for after in [mirror.peak_matched(&kernel), mirror.peak_fitted(&kernel)] {
        for (got, want) in after.matrix().entries().into_iter().zip(want) {
            near(got.to_f64(), want.to_f64(), few * becomes.matrix().trace().to_f64(), &footprint)?;
        }
    }
    // Over an area, its peak is one over the area.
    let over = mirror.peak_matched_over(&footprint).matrix().root_det().to_f64();
    // A side whose square has no digits counts as 0.
    let least = 4.0 * (R::MIN_POSITIVE.to_f64() / R::EPSILON.to_f64()).sqrt();
    let least = least * (1.0 + footprint.diameter().to_f64());
    near(over * PI, area, few * area + moved(&footprint) + least, &footprint)
}

#[test]
fn no_kernel_leaves_the_lobe_and_a_mirror_becomes_the_kernel() {
    check(10_000, ends::<f64>);
    check(10_000, ends::<f32>);
}

fn total<R: Real>(source: &mut Source) -> TestCaseResult {
    let size = |source: &mut Source| match source.pick(4) {
        0 => 0.0,
        1 => [1e-9, 1e9][source.pick(2) as usize],
        _ => source.log_uniform(1e-9, 1e9),
    };
    let sizes: [f64; 6] = core::array::from_fn(|_| size(source));
    let [x, y, ux, uy, vx, vy] = sizes.map(R::lit);
    let angle = R::lit(source.angle());
    let base = Roughness::from_alphas(x, y, angle).expect("in range");
    let footprint = Footprint { u: [ux, -uy], v: [vx, vy] };
    let kernel = Kernel::of(&footprint, PixelFilter::BOX);
    let inputs: &dyn Debug = &(sizes, angle);
    let sane = |a: R| a.is_finite() && a >= R::ZERO;
    for after in
        [base.peak_matched(&kernel), base.peak_fitted(&kernel), base.peak_matched_over(&footprint)]
    {
        let ([xx, xy, yy], root_det) = (after.matrix().entries(), after.matrix().root_det());
        let whole = sane(xx) && sane(yy) && sane(root_det) && xy.is_finite();
        ensure(whole, "finite, not negative", &(inputs, after))?;
        let [a, _, c] = base.matrix().entries().map(|x| x * (R::ONE - R::lit(8.0) * R::EPSILON));
        let grown = xx >= a && yy >= c;
        ensure(grown, "nothing is taken away", &(inputs, after))?;
        ensure(
            sane(Ggx::new(Anisotropic::new(after)).slope_pdf([R::ZERO; 2])),
            "a peak",
            &(inputs, after),
        )?;
    }
    let alphas =
        [box_peak_alpha(x, ux), gaussian_peak_alpha(x, ux)].map(|alpha| alpha.expect("in range"));
    ensure(
        alphas.into_iter().all(|alpha| sane(alpha) && alpha >= x * (R::ONE - R::EPSILON)),
        "an alpha",
        &(inputs, alphas),
    )
}

#[test]
fn proxies_are_total() {
    check(20_000, total::<f64>);
    check(20_000, total::<f32>);
    for bad in [-1.0, 1.1e9, f64::NAN, f64::INFINITY] {
        assert!(matches!(box_peak_alpha(bad, 0.1), Err(Error::Alpha(_))));
        assert!(matches!(box_peak_alpha(0.1, bad), Err(Error::Width(_))));
        assert!(matches!(gaussian_peak_alpha(bad, 0.1), Err(Error::Alpha(_))));
        assert!(matches!(gaussian_peak_alpha(0.1, bad), Err(Error::Sigma(_))));
    }
}

/// The same exact inputs in both precisions.
#[test]
fn single_precision_keeps_the_peak() {
    check(10_000, |source| {
        let (ellipse, footprint) = (source.ellipse(), source.footprint());
        let [xx, xy, yy] = ellipse.entries_single();
        let Ok(single) = Psd::new(xx, xy, yy) else { return Ok(()) };
        let double = Psd::new(f64::from(xx), f64::from(xy), f64::from(yy)).expect("as in f32");
        let (single, double) = (Roughness::from_matrix(single), Roughness::from_matrix(double));
        let narrow = |v: [f64; 2]| v.map(|x| x as f32);
        let small = Footprint { u: narrow(footprint.u), v: narrow(footprint.v) };
        let wide = |v: [f32; 2]| v.map(f64::from);
        let large = Footprint { u: wide(small.u), v: wide(small.v) };
        let kernels = (Kernel::of(&small, PixelFilter::BOX), Kernel::of(&large, PixelFilter::BOX));
        let inputs = (ellipse, small);
        for (got, want, tolerance) in [
            (single.peak_matched(&kernels.0), double.peak_matched(&kernels.1), 1e-5),
            (single.peak_fitted(&kernels.0), double.peak_fitted(&kernels.1), 40.0 * ULP_SINGLE),
            (single.peak_matched_over(&small), double.peak_matched_over(&large), 1e-5),
        ] {
            let want = want.matrix().root_det();
            let tolerance = tolerance * want + moved(&small);
            near(f64::from(got.matrix().root_det()), want, tolerance, &inputs)?;
        }
        Ok(())
    });
}

/// Both published shortcuts, as far off as their documentation says.
#[test]
fn square_roots_of_sums_err_as_stated() {
    let (mut darkest, mut farthest) = (0.0_f64, 0.0_f64);
    for ratio in (-500..=500).map(|k| 10.0_f64.powf(0.01 * f64::from(k))) {
        let alpha = 0.01_f64;
        let exact = box_peak_alpha(alpha, ratio * alpha).expect("in range");
        let published = kaplanyan_proxy_alpha(alpha, ratio * alpha).expect("in range");
        let square = Footprint::rectangle([ratio * alpha, ratio * alpha]);
        let base = Roughness::from_alpha(alpha).expect("in range");
        let widened = |filter| base.widened(&Kernel::of(&square, filter)).alphas().major;
        let same = widened(PixelFilter::KAPLANYAN_PROXY);
        assert!((published / same - 1.0).abs() < 1e-14, "{published} {same}");
        // The peak falls like 1/alpha^2.
        darkest = darkest.max((published / exact).powi(2));
        farthest = farthest.max((widened(PixelFilter::TOKUYOSHI_KAPLANYAN) / exact - 1.0).abs());
    }
    assert!((3.05..3.15).contains(&darkest), "{darkest}, stated: 3.1");
    assert!((0.85 * 0.0055..=0.0055).contains(&farthest), "{farthest}, stated: 0.55 %");
}

/// Far out GGX under a Gaussian is GGX, alpha^2/(pi s^4); a proxy there is as bright as its own
/// alpha.
#[test]
fn proxies_lack_the_tail() {
    let (alpha, sigma) = (0.05_f64, 0.1);
    let base = Roughness::from_alpha(alpha).expect("in range");
    let kernel = Kernel::from_covariance(Psd::outer_sum([sigma, 0.0], [0.0, sigma]));
    for far in [100.0_f64, 1000.0] {
        let tail = |alpha: f64| alpha * alpha / (PI * far.powi(4));
        // The next terms of both tails are of the order of (sigma/s)^2.
        let few = 40.0 * (sigma / far).powi(2);
        let filtered = ggx_gaussian_mean(&Lobe::centered(base), [far, 0.0], &kernel);
        assert!((filtered / tail(alpha) - 1.0).abs() < few, "{filtered} at {far}");
        for proxy in [base.widened(&kernel), base.peak_matched(&kernel), base.peak_fitted(&kernel)]
        {
            let density = Ggx::new(Anisotropic::new(proxy)).slope_pdf([far, 0.0]);
            assert!((density / tail(proxy.alphas().major) - 1.0).abs() < few, "{density} at {far}");
            assert!(density > 8.0 * filtered, "{density} {filtered}");
        }
    }
}

fn returns<R: Real>(source: &mut Source) -> TestCaseResult {
    let filter = [
        PixelFilter::BOX,
        PixelFilter::KAPLANYAN,
        PixelFilter::TOKUYOSHI_KAPLANYAN,
        PixelFilter::KAPLANYAN_PROXY,
    ][source.pick(4) as usize];
    let size = match source.pick(3) {
        0 => 1.0,
        1 => source.log_uniform(1e-12, 1.0),
        _ => source.log_uniform(1.0, 1e6),
    };
    let [u, v] = source.kernel().map(|d| d.map(|x| R::lit(size * x)));
    let before = Psd::outer_sum(u, v);
    let footprint = Kernel::from_covariance(before).footprint(filter);
    let after = Kernel::of(&footprint, filter).covariance();
    let few = 16.0 * R::EPSILON.to_f64();
    let size = few * before.trace().to_f64() + 4.0 * R::MIN_POSITIVE.to_f64();
    let inputs = (u, v, filter);
    for (got, want) in after.entries().into_iter().zip(before.entries()) {
        near(got.to_f64(), want.to_f64(), size, &inputs)?;
    }
    // The area keeps its own digits, down to where its square has none.
    let want = before.root_det().to_f64();
    let tolerance =
        few * want + 4.0 * (R::MIN_POSITIVE.to_f64() * (1.0 + before.trace().to_f64())).sqrt();
    near(after.root_det().to_f64(), want, tolerance, &inputs)?;
    let along = footprint.u[0] * footprint.v[0] + footprint.u[1] * footprint.v[1];
    let lengths = footprint.diameter().to_f64().powi(2);
    near(
        along.to_f64(),
        0.0,
        few * lengths + R::MIN_POSITIVE.to_f64(),
        &("axes are square", inputs),
    )
}

#[test]
fn a_kernel_gives_its_footprint_back() {
    check(20_000, returns::<f64>);
    check(20_000, returns::<f32>);
    let none = PixelFilter::with_variance(0.0).expect("in range");
    let kernel = Kernel::from_covariance(Psd::outer_sum([1.0, 0.5], [0.0, 2.0]));
    assert_eq!(kernel.footprint(none), Footprint::default());
    assert_eq!(Kernel::<f64>::default().footprint(PixelFilter::BOX), Footprint::default());
}
