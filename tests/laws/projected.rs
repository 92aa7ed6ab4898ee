//! Laws of filtering on the projected disk.

use crate::common::arbitrary::Source;
use crate::common::reference::{eigenvalues, matrix, rotate, rotate_matrix};
use crate::common::{ULP, ULP_SINGLE, check, ensure, near, near_all};
use lobe::filter::{DiskKernel, projected_alpha};
use lobe::{Anisotropic, Ggx, Kernel, PixelFilter, Psd, Real, Roughness};
use nalgebra::Matrix2;
use proptest::test_runner::TestCaseResult;

/// A roughness with eigenvalues of A below 1, as alphas and a correlation.
fn smooth(source: &mut Source) -> [f64; 3] {
    let alpha = |source: &mut Source| match source.pick(4) {
        0 => 0.999,
        1 => source.log_uniform(1e-4, 1e-2),
        _ => source.log_uniform(1e-3, 0.95),
    };
    let (x, y) = (alpha(source), alpha(source));
    // The largest eigenvalue is below the sum of squares: correlated ones are scaled under 1.
    let rho = if source.pick(3) == 0 { 0.0 } else { source.rho() };
    let scale = if rho == 0.0 { 1.0 } else { 0.999 / x.hypot(y).max(0.999) };
    [x * scale, y * scale, rho]
}

fn entries([x, y, rho]: [f64; 3]) -> [f64; 3] {
    [x * x, rho * x * y, y * y]
}

fn roughness<R: Real>(input: [f64; 3]) -> Roughness<R> {
    let scale = 0.5_f64.sqrt();
    let [x, y, rho] = [input[0] * scale, input[1] * scale, input[2]].map(R::lit);
    Roughness::from_sigma_rho(x, y, rho).expect("in range")
}

/// Two derivative vectors on the disk: no longer than its diameter.
fn steps(source: &mut Source) -> [[f64; 2]; 2] {
    let u = source.vector(1e-5, 1.5);
    match source.pick(5) {
        0 => [u, [0.0; 2]],
        1 => [u, u.map(|x| x * source.uniform(-1.0, 1.0))],
        _ => [u, source.vector(1e-5, 1.5)],
    }
}

fn kernel<R: Real>([u, v]: [[f64; 2]; 2]) -> DiskKernel<R> {
    DiskKernel::of(u.map(R::lit), v.map(R::lit), PixelFilter::TOKUYOSHI_KAPLANYAN)
}

/// 2 sigma^2 J J^T.
fn added([u, v]: [[f64; 2]; 2]) -> Matrix2<f64> {
    let entry = |i: usize, j: usize| (u[i] * u[j] + v[i] * v[j]) / core::f64::consts::PI;
    Matrix2::new(entry(0, 0), entry(0, 1), entry(1, 0), entry(1, 1))
}

/// ((A^-1 - I)^-1 + K)^-1 + I, inverted, by nalgebra: the paper's three equations as they stand.
fn by_inverses(a: [f64; 3], k: Matrix2<f64>) -> Option<Matrix2<f64>> {
    let identity = Matrix2::identity();
    let projected = (matrix(a).try_inverse()? - identity).try_inverse()?;
    ((projected + k).try_inverse()? + identity).try_inverse()
}

fn papers_equations(source: &mut Source) -> TestCaseResult {
    let (input, steps) = (smooth(source), steps(source));
    let got = roughness::<f64>(input).widened_on_disk(&kernel(steps)).matrix();
    let a = entries(input);
    let k = added(steps);
    let Some(want) = by_inverses(a, k) else { return Ok(()) };
    // Inverses amplify rounding by the condition of what they invert, and once more where 1 - a
    // cancels.
    let [major, minor] = eigenvalues(a);
    let [largest, _] = eigenvalues([k[(0, 0)], k[(0, 1)], k[(1, 1)]]);
    let condition = (largest + major / (1.0 - major)) / minor;
    let tolerance = 64.0 * ULP * condition / (1.0 - major);
    let want = [want[(0, 0)], want[(0, 1)], want[(1, 1)]];
    near_all(&got.entries(), &want, tolerance, &(input, steps))
}

#[test]
fn the_matrix_is_that_of_the_papers_equations() {
    check(20_000, papers_equations);
}

fn stays_a_lobe<R: Real>(source: &mut Source) -> TestCaseResult {
    let (input, steps) = (smooth(source), steps(source));
    let before = roughness::<R>(input);
    let after = before.widened_on_disk(&kernel(steps));
    let inputs = (input, steps, after);
    let few = 16.0 * R::EPSILON.to_f64();
    let [a, b] = [before, after].map(|r| r.matrix().entries().map(Real::to_f64));
    let [major, minor] = eigenvalues(b);
    ensure(major <= 1.0 + few && minor >= -few, "eigenvalues in [0, 1]", &inputs)?;
    let [_, least] = eigenvalues([b[0] - a[0], b[1] - a[1], b[2] - a[2]]);
    ensure(least >= -few * (b[0] + b[2]), "A' - A is positive semi-definite", &inputs)?;
    let root_det = after.matrix().root_det().to_f64();
    ensure(root_det >= before.matrix().root_det().to_f64() * (1.0 - few), "area grows", &inputs)?;
    // Twice the kernel by halves: a semigroup.
    let [u, v] = steps.map(|s| s.map(|x| R::lit(x * 0.5_f64.sqrt())));
    let half = DiskKernel::of(u, v, PixelFilter::TOKUYOSHI_KAPLANYAN);
    let halves = before.widened_on_disk(&half).widened_on_disk(&half);
    let at_once = before.widened_on_disk(&(half + half));
    let (once, twice) = (at_once.matrix(), halves.matrix());
    // A rounding of the matrix between is one of 1 - a.
    let tolerance = few * once.trace().to_f64() / (1.0 - major).max(few);
    let (once, twice) = (once.entries().map(Real::to_f64), twice.entries().map(Real::to_f64));
    near_all(&twice, &once, tolerance, &inputs)
}

#[test]
fn the_widened_lobe_is_wider_stays_below_one_and_kernels_follow_each_other() {
    check(20_000, stays_a_lobe::<f64>);
    check(20_000, stays_a_lobe::<f32>);
}

fn single_is_double(source: &mut Source) -> TestCaseResult {
    let (input, steps) = (smooth(source), steps(source));
    // The same numbers in both precisions.
    let input = input.map(|x| f64::from(x as f32));
    let steps = steps.map(|s| s.map(|x| f64::from(x as f32)));
    let double = roughness::<f64>(input).widened_on_disk(&kernel(steps)).matrix();
    let single = roughness::<f32>(input).widened_on_disk(&kernel(steps)).matrix();
    let inputs = (input, steps);
    // Constructing A at rho = 0.9999 costs f32 1e-3 of its determinant: here nothing more may be
    // lost.
    let condition = 1.0 / ((1.0 - input[2].abs()).sqrt()).max(1e-2);
    let tolerance = 32.0 * ULP_SINGLE * condition;
    let root = double.root_det();
    near(f64::from(single.root_det()), root, tolerance * root, &inputs)?;
    let scale = double.trace();
    near_all(&single.entries().map(f64::from), &double.entries(), tolerance * scale, &inputs)
}

#[test]
fn single_precision_follows_double() {
    check(20_000, single_is_double);
}

/// GGX on the disk is a GGX of roughness A_perp: 1/(pi sqrt(det A) (1 + m^T A_perp^-1 m)^2).
fn identity_on_the_disk(source: &mut Source) -> TestCaseResult {
    let input = smooth(source);
    let a = entries(input);
    let m = {
        let [x, y] = source.vector(1e-4, 0.999);
        [x, y, (1.0 - x * x - y * y).sqrt()]
    };
    let Some(precision) = matrix(a).try_inverse() else { return Ok(()) };
    let precision = precision - Matrix2::identity();
    let point = nalgebra::Vector2::new(m[0], m[1]);
    let q = (point.transpose() * precision * point)[(0, 0)];
    let root = roughness::<f64>(input).matrix().root_det();
    let want = 1.0 / (core::f64::consts::PI * root * (1.0 + q) * (1.0 + q));
    let got = Ggx::new(Anisotropic::new(roughness::<f64>(input))).d(m);
    let [major, minor] = eigenvalues(a);
    near(got, want, 1e3 * ULP * (major / minor) / (1.0 - major) * want, &(input, m))
}

#[test]
fn ggx_is_ggx_on_the_disk() {
    check(20_000, identity_on_the_disk);
}

fn scalar_is_matrix(source: &mut Source) -> TestCaseResult {
    let [x, y, _] = smooth(source);
    let widths = [source.log_uniform(1e-5, 1.5), source.log_uniform(1e-5, 1.5)];
    let filter = PixelFilter::TOKUYOSHI_KAPLANYAN;
    let kernel = DiskKernel::of([widths[0], 0.0], [0.0, widths[1]], filter);
    let lobe = Roughness::from_alphas(x, y, 0.0).expect("in range");
    let [xx, xy, yy] = lobe.widened_on_disk(&kernel).matrix().entries();
    ensure(xy == 0.0, "axes stay", &(x, y, widths))?;
    for (alpha, width, entry) in [(x, widths[0], xx), (y, widths[1], yy)] {
        let axis = projected_alpha(alpha, 2.0 * filter.variance() * width * width);
        let square = axis.expect("in range").powi(2);
        near(entry, square, 64.0 * ULP * square / (1.0 - alpha * alpha), &(x, y, widths))?;
    }
    Ok(())
}

#[test]
fn along_the_axes_the_matrix_is_two_scalars() {
    check(20_000, scalar_is_matrix);
}

/// At alpha = 1 and beyond an axis stays, and the other axis sees the kernel as in the limit from
/// below.
fn rough_axes(source: &mut Source) -> TestCaseResult {
    let steps = steps(source);
    let angle = source.angle();
    let (minor, kernel) = (source.log_uniform(1e-3, 0.9), kernel::<f64>(steps));
    let lobe = |major: f64| Roughness::from_alphas(major, minor, angle).expect("in range");
    let at = |major: f64| lobe(major).widened_on_disk(&kernel).matrix().entries();
    let inputs = (steps, angle, minor);
    near_all(&at(1.0), &at(1.0 - 1e-9), 1e-7, &inputs)?;
    for major in [1.0, 1.0 + 1e-9, 2.0, 1e3] {
        let got = lobe(major).widened_on_disk(&kernel).alphas();
        near(got.major, major, 1e-9 * major, &(inputs, major))?;
        ensure(
            got.minor >= minor * 0.999_999 && got.minor < 1.0,
            "the other axis",
            &(inputs, got),
        )?;
    }
    let both = Roughness::from_alphas(3.0, 1.5, angle).expect("in range");
    ensure(both.widened_on_disk(&kernel) == both, "two rough axes stay", &inputs)
}

#[test]
fn axes_of_alpha_one_and_more_stay_and_the_limit_is_continuous() {
    check(5000, rough_axes);
}

fn turns_with_the_frame(source: &mut Source) -> TestCaseResult {
    let (input, steps, angle) = (smooth(source), steps(source), source.angle());
    let a = rotate_matrix(entries(input), angle);
    let Ok(turned) = Psd::new(a[0], a[1], a[2]) else { return Ok(()) };
    let got = Roughness::from_matrix(turned)
        .widened_on_disk(&kernel(steps.map(|s| rotate(s, angle))))
        .matrix()
        .entries();
    let plain = roughness::<f64>(input).widened_on_disk(&kernel(steps)).matrix().entries();
    // A nearly singular A, turned, has lost digits of its minor axis.
    near_all(&got, &rotate_matrix(plain, angle), 1e-9, &(input, steps, angle))
}

#[test]
fn a_turned_frame_turns_the_result() {
    check(10_000, turns_with_the_frame);
}

#[test]
fn extreme_kernels_and_lobes_stay_lobes() {
    for alpha in [0.0_f32, 1e-9, 1e-4, 0.5, 0.999_999_94, 1.0, 30.0, 1e9] {
        for step in [0.0_f32, 1e-20, 1e-3, 2.0, 1e9, 1e30, f32::MAX] {
            for (u, v) in [([step, 0.0], [0.0, step]), ([step, step], [step, step])] {
                let kernel = DiskKernel::of(u, v, PixelFilter::KAPLANYAN);
                let lobe = Roughness::from_alpha(alpha).expect("in range").widened_on_disk(&kernel);
                let [xx, xy, yy] = lobe.matrix().entries();
                let sound = xx.is_finite() && xy.is_finite() && yy.is_finite();
                let root = lobe.matrix().root_det();
                assert!(sound && root.is_finite() && root >= 0.0, "{alpha} {step} {lobe:?}");
                assert!(xx >= alpha * alpha * 0.999_99, "{alpha} {step} {lobe:?}");
                assert!(xx <= 1.000_001 || alpha >= 1.0, "{alpha} {step} {lobe:?}");
            }
        }
    }
}

#[test]
fn a_mirror_becomes_the_kernel_seen_from_the_disk() {
    let (u, v) = ([0.2_f64, 0.1], [-0.1, 0.3]);
    let kernel = DiskKernel::of(u, v, PixelFilter::TOKUYOSHI_KAPLANYAN);
    let lobe = Roughness::from_alpha(0.0).expect("a mirror").widened_on_disk(&kernel);
    let k = added([u, v]);
    let want = k * (Matrix2::identity() + k).try_inverse().expect("regular");
    let got = lobe.matrix().entries();
    for (got, want) in got.iter().zip([want[(0, 0)], want[(0, 1)], want[(1, 1)]]) {
        assert!((got - want).abs() < 1e-14);
    }
}

#[test]
fn the_practical_approximation_is_the_limit_of_small_lobes() {
    let (u, v) = ([2e-3_f64, 1e-3], [-1e-3, 3e-3]);
    let kernel = DiskKernel::of(u, v, PixelFilter::TOKUYOSHI_KAPLANYAN);
    let base = Roughness::from_alpha(0.005_f64).expect("in range");
    let (full, plain) = (base.widened_on_disk(&kernel), base.widened(&kernel.as_slopes()));
    for (a, b) in full.matrix().entries().iter().zip(plain.matrix().entries()) {
        // They differ by A A'.
        assert!((a - b).abs() < 1e-4 * plain.matrix().trace());
    }
    let slopes: Kernel<f64> = kernel.as_slopes();
    assert_eq!(slopes.covariance(), kernel.covariance());
}
