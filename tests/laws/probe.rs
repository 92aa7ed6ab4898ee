//! Laws of the precisions that measure: bits, bounds, contraction and counts.
#![cfg(feature = "probe")]

use crate::common::arbitrary::Source;
use crate::common::{check, ensure, near};
use lobe::filter::{DiskKernel, beckmann_rectangle_mean};
use lobe::probe::{Counted, Fused, Operations, Rounded, operations_of};
use lobe::slope::Compensated;
use lobe::{Beckmann, Footprint, Ggx, Kernel, Lobe, PixelFilter, Psd, Real, Roughness};
use proptest::test_runner::TestCaseResult;

/// Results of a scene: their names, and how far f64 lies from the formula of f32 without rounding:
/// its own budget, and the error of fewer nodes.
const RESULTS: [(&str, f64); 8] = [
    ("ggx", 1e-9),
    ("beckmann", 1e-9),
    ("on the disk, xx", 1e-9),
    ("on the disk, root of det", 1e-9),
    ("peak fitted", 1e-9),
    ("widened", 1e-9),
    ("parallelogram", 1e-6),
    ("rectangle", 1e-9),
];

/// A lobe, where to look at it, and what a pixel does to it; every number is exactly f32.
#[derive(Debug)]
struct Scene {
    matrix: [f32; 3],
    mean: [f32; 2],
    alphas: [f32; 2],
    slope: [f32; 2],
    wo: [f32; 3],
    wi: [f32; 3],
    u: [f32; 2],
    v: [f32; 2],
}

/// The same numbers in any precision: exact in all of them.
fn all<R: Real, const N: usize>(x: [f32; N]) -> [R; N] {
    x.map(|x| R::lit(f64::from(x)))
}

impl Scene {
    fn of(source: &mut Source) -> Self {
        let lobe = source.lobe();
        let close = source.slope_near(&lobe);
        let slope = if source.pick(2) == 0 { source.slope() } else { close };
        let [wo, wi] = source.pair().map(|w| w.map(|x| x as f32));
        let over = source.footprint();
        let [mean, slope, u, v] = [lobe.mean, slope, over.u, over.v].map(|s| s.map(|x| x as f32));
        let alphas = [lobe.ellipse.x, lobe.ellipse.y].map(|x| x as f32);
        Self { matrix: lobe.ellipse.entries_single(), mean, alphas, slope, wo, wi, u, v }
    }

    /// One formula each from every corner of the library.
    fn results<R: Real>(&self) -> [R; 8] {
        let [xx, xy, yy] = all(self.matrix);
        let roughness = Roughness::from_matrix(Psd::new(xx, xy, yy).expect("|rho| < 1"));
        let shape = Lobe::new(all::<R, 2>(self.mean), roughness).expect("a finite mean").shape();
        let (wo, wi) = (all::<R, 3>(self.wo), all::<R, 3>(self.wi));
        let (slope, u, v) = (all::<R, 2>(self.slope), all::<R, 2>(self.u), all::<R, 2>(self.v));
        let kernel = DiskKernel::of(u, v, PixelFilter::TOKUYOSHI_KAPLANYAN);
        let on_disk = roughness.widened_on_disk(&kernel).matrix();
        let over = Footprint { u, v };
        let kernel = Kernel::of(&over, PixelFilter::BOX);
        [
            Ggx::new(shape).brdf(wo, wi),
            Beckmann::new(shape).brdf(wo, wi),
            on_disk.entries()[0],
            on_disk.root_det(),
            roughness.peak_fitted(&kernel).matrix().root_det(),
            roughness.widened(&kernel).matrix().root_det(),
            Ggx::new(shape).parallelogram_mean(slope, &over),
            beckmann_rectangle_mean(all::<R, 2>(self.alphas), slope, [u[0], v[1]]),
        ]
    }

    /// An axis at the pole of the disk, alpha = 1: there a rounding decides on which side.
    fn is_at_the_pole(&self) -> bool {
        let [xx, xy, yy] = self.matrix.map(f64::from);
        let axes = crate::common::reference::eigenvalues([xx, xy, yy]);
        axes.iter().any(|a| (a - 1.0).abs() < 1e-5 * axes[0])
    }
}

fn bits_of_single(source: &mut Source) -> TestCaseResult {
    let scene = Scene::of(source);
    let single = scene.results::<f32>().map(f32::to_bits);
    let rounded = scene.results::<Rounded>().map(|x| x.value().to_bits());
    let counted = scene.results::<Counted>().map(|x| (x.to_f64() as f32).to_bits());
    ensure(rounded == single, "rounded is f32", &scene)?;
    ensure(counted == single, "counted is f32", &scene)
}

#[test]
fn measuring_changes_no_bit() {
    check(20_000, bits_of_single);
}

fn truth_is_within(source: &mut Source) -> TestCaseResult {
    let scene = Scene::of(source);
    let (rounded, exact) = (scene.results::<Rounded>(), scene.results::<f64>());
    for (k, (name, budget)) in RESULTS.into_iter().enumerate() {
        if name.starts_with("on the disk") && scene.is_at_the_pole() {
            continue;
        }
        // What f32 has no numbers for is chosen to be 0 before it underflows.
        let allowed = rounded[k].bound() + budget * exact[k].abs() + f64::from(f32::MIN_POSITIVE);
        near(rounded[k].to_f64(), exact[k], allowed, &(name, &scene))?;
    }
    Ok(())
}

#[test]
fn the_truth_lies_within_the_bound() {
    check(50_000, truth_is_within);
}

/// What the bounds are worth: of `N` scenes the bounds over the values, increasing, and the largest
/// error of another f32 over its bound.
fn tightness(other: impl Fn(&Scene) -> [f64; 8]) -> [(Vec<f64>, f64); 8] {
    let mut found = [(); 8].map(|()| (Vec::new(), 0.0_f64));
    for seed in 0..20_000 {
        let scene = Scene::of(&mut Source::from_seed(seed));
        let (rounded, other) = (scene.results::<Rounded>(), other(&scene));
        for k in 0..8 {
            let (value, bound) = (rounded[k].to_f64(), rounded[k].bound());
            // Below this subnormal numbers are a part of the bound.
            if value > 1e-30 {
                found[k].0.push(bound / value);
                let error = (other[k] - value).abs();
                let part = if error > 0.0 { error / bound } else { 0.0 };
                found[k].1 = found[k].1.max(part);
            }
        }
    }
    for (relative, _) in &mut found {
        relative.sort_by(f64::total_cmp);
    }
    found
}

#[test]
fn fused_numbers_differ_and_stay_within_the_bound() {
    let found = tightness(|scene| scene.results::<Fused>().map(Real::to_f64));
    for ((name, _), (relative, part)) in RESULTS.iter().zip(&found) {
        // A rounding is 6e-8.
        let at = |percent: usize| relative[relative.len() * percent / 100];
        assert!(at(50) > 6e-8 && at(50) < 1e-5, "{name}: {:e}", at(50));
        assert!(at(90) < 5e-5 && at(97) < 1e-3, "{name}: {:e}, {:e}", at(90), at(97));
        // Neither is the bound so wide that contraction never shows in it.
        assert!(*part > 0.05 && *part < 1.0, "{name}: {part}");
    }
}

#[test]
fn a_lost_compensation_leaves_the_bound() {
    // The mean less its rounding error, as a compiler leaves it that folds (a + b) - a to b.
    let (mean, slope) = (0.7_f32, 0.700_01_f32);
    let offset = Rounded::exact(slope) - Rounded::exact(mean);
    assert!(offset.bound() <= f64::from(offset.value()) * 6e-8);
    // In the library the square of a difference keeps its digits, and the bound knows.
    let sharp = |mean: f32| {
        let square = Rounded::exact(1e-8);
        let entries = [square, Rounded::ZERO, square];
        let shape = Compensated::new([Rounded::exact(mean), Rounded::ZERO], entries);
        Ggx::new(shape.expect("finite")).slope_pdf([Rounded::exact(slope), Rounded::ZERO])
    };
    let (here, beside) = (sharp(mean), sharp(mean.next_up()));
    assert!(here.bound() < 2e-6 * here.to_f64(), "{here:?}");
    assert!((here.to_f64() - beside.to_f64()).abs() > 10.0 * here.bound(), "{here:?} {beside:?}");
}

type Function = (&'static str, fn(f32) -> f32, fn(Rounded) -> Rounded, fn(f64) -> f64);

macro_rules! function {
    ($name:ident) => {{
        // Through `Real` as a bound, which also has what no caller can name.
        fn by<R: Real>(x: R) -> R {
            x.$name()
        }
        (stringify!($name), by, by, by)
    }};
}

/// Functions of a product that was rounded: its error passes through them. f64 is the reference,
/// which tests/laws/scalar.rs holds.
#[test]
fn functions_pass_errors_on() {
    let functions: [Function; 10] = [
        function!(sqrt),
        function!(exp),
        function!(ln),
        function!(atan),
        function!(erfc),
        function!(erfcx),
        function!(ierfcx),
        function!(ierfc_excess),
        function!(atan_excess),
        function!(exp2_of_negative),
    ];
    for (name, single, rounded, exact) in functions {
        let (mut largest, mut beyond_own) = (0.0_f64, 0.0_f64);
        for seed in 0..40_000 {
            let mut source = Source::from_seed(seed);
            let sign = if ["exp", "atan", "erfc"].contains(&name) { source.sign() } else { 1.0 };
            let sign = if name == "exp2_of_negative" { -1.0 } else { sign };
            let most = if name == "atan_excess" { 0.99 } else { 9.0 };
            let a = (sign * source.log_uniform(0.01, 10.0)) as f32;
            let b = (source.log_uniform(1e-3, most) / f64::from(a.abs())) as f32;
            let x = Rounded::exact(a) * Rounded::exact(b);
            let got = rounded(x);
            assert_eq!(got.value().to_bits(), single(a * b).to_bits(), "{name}({a} {b})");
            let error = (got.to_f64() - exact(f64::from(a) * f64::from(b))).abs();
            assert!(error <= got.bound(), "{name}({a} {b}): {error:e}, {got:?}");
            largest = largest.max(error / got.bound());
            let own = rounded(Rounded::exact(a * b)).bound();
            beyond_own = beyond_own.max(error / own);
        }
        assert!(largest > 0.3, "{name}: {largest}");
        // Of some the slope is nowhere steep.
        assert!(beyond_own > 1.0 || !["exp", "ln", "erfc"].contains(&name), "{name}: {beyond_own}");
    }
}

/// [`Real`] as a bound reaches methods of a trait that callers cannot name.
fn upper_angle<R: Real>(y: R, x: R) -> R {
    y.upper_angle(x)
}

/// As [`upper_angle`].
fn kept<R: Real>(x: R) -> R {
    x.kept()
}

#[test]
fn angles_and_choices_pass_errors_on() {
    for seed in 0..40_000 {
        let mut source = Source::from_seed(seed);
        let [a, b, c, d] =
            [(); 4].map(|()| (source.sign() * source.log_uniform(1e-2, 10.0)) as f32);
        let [x, y] = [[a, b], [c, d]].map(|[a, b]| Rounded::exact(a) * Rounded::exact(b));
        let (exact_x, exact_y) = (f64::from(a) * f64::from(b), f64::from(c) * f64::from(d));
        let rows = [
            ("atan2", y.atan2(x), exact_y.atan2(exact_x)),
            ("upper_angle", upper_angle(y.abs(), x), exact_y.abs().atan2(exact_x)),
            ("min", x.min(y), exact_x.min(exact_y)),
            ("max", x.max(y), exact_x.max(exact_y)),
            ("quotient", x / y, exact_x / exact_y),
            ("sine", x.sin_cos().0, exact_x.sin()),
        ];
        for (name, got, want) in rows {
            let error = (got.to_f64() - want).abs();
            assert!(error <= got.bound(), "{name} of {x:?}, {y:?}: {error:e}, {got:?}");
            let size = 1.0 + want.abs() + exact_x.abs();
            assert!(got.bound() < 1e-6 * size, "{name} of {x:?}, {y:?}: {got:?}");
        }
    }
    // Where a rounding decides: the other number, the other side of the cut, a divisor of 0.
    // Rounded twice: its neighbors are within the bound.
    let third = Rounded::lit(1.0 / 3.0) * Rounded::ONE;
    let (low, high) = (Rounded::exact(third.value().next_down()), third.value().next_up());
    assert_eq!(low.max(third).bound(), third.bound());
    assert_eq!(Rounded::exact(high).max(third).bound(), third.bound());
    assert_eq!(Rounded::ONE.max(third).bound(), 0.0);
    let zero = third - Rounded::exact(third.value());
    assert!(zero.bound() > 0.0 && zero.atan2(-Rounded::ONE).bound() > 6.2);
    assert!(zero.atan2(Rounded::ONE).bound() < 1e-7);
    assert_eq!((Rounded::ONE / zero).bound(), f64::INFINITY);
    // |sqrt(x + e) - sqrt(x)| <= sqrt(e).
    assert!((zero.sqrt().bound() / zero.bound().sqrt() - 1.0).abs() < 1e-12);
}

#[test]
fn a_product_in_a_sum_is_fused_unless_it_is_kept() {
    // (1 + eps)^2 = 1 + 2 eps + eps^2, of which f32 keeps 1 + 2 eps.
    let x = Fused::ONE + Fused::EPSILON;
    let rounded = Fused::ONE + Fused::TWO * Fused::EPSILON;
    let square = x * x;
    assert_eq!(square.value(), rounded.value());
    assert_eq!((square - rounded).value(), f32::EPSILON * f32::EPSILON);
    assert_eq!((rounded - square).value(), -f32::EPSILON * f32::EPSILON);
    assert_eq!((kept(square) - rounded).value(), 0.0);
    // A bound that is right for both.
    let [x, rounded] = [x, rounded].map(|x| Rounded::exact(x.value()));
    let difference = x * x - rounded;
    assert_eq!(difference.value(), 0.0);
    assert!(difference.bound() >= f64::from(f32::EPSILON).powi(2));
}

#[test]
fn operations_are_counted_one_by_one() {
    let [a, b, c] = [2.0, 3.0, 4.0].map(Counted::lit);
    let (value, outer) = operations_of(|| {
        let (inner, operations) = operations_of(|| (a * b - c).sqrt() / c);
        let one = Operations {
            additions: 1,
            multiplications: 1,
            divisions: 1,
            roots: 1,
            ..Operations::default()
        };
        assert_eq!(operations, one);
        inner.exp().max(a)
    });
    assert_eq!(value.to_f64(), 2.0);
    // What was counted inside is not counted again.
    let rest = Operations { transcendental: 1, comparisons: 1, ..Operations::default() };
    assert_eq!(outer, rest);
}
