//! Laws of covariances: whatever is done to them, they stay positive semi-definite, and the
//! determinant they carry is theirs.

use crate::backward::backward;
use crate::common::arbitrary::Source;
use crate::common::reference::{eigenvalues, matrix};
use crate::common::{ULP, check, check_all, ensure, near, near_all};
use core::fmt::Debug;
use lobe::{Psd, Real, SlopeMoments};
use proptest::test_runner::TestCaseResult;

fn doubles<R: Real>(m: &Psd<R>) -> [f64; 3] {
    m.entries().map(Real::to_f64)
}

/// Finite, with eigenvalues not negative beyond the rounding of the entries.
fn is_covariance<R: Real>(m: &Psd<R>, inputs: &dyn Debug) -> TestCaseResult {
    let entries = doubles(m);
    ensure(entries.iter().all(|x| x.is_finite()), "finite entries", &(inputs, m))?;
    let trace = entries[0] + entries[2];
    let [_, least] = eigenvalues(entries);
    let holds = least >= -4.0 * R::EPSILON.to_f64() * trace;
    ensure(holds, "no negative eigenvalue", &(inputs, m, least))?;
    ensure(m.root_det() >= R::ZERO, "no negative determinant", &(inputs, m))?;
    let eigen = m.eigen();
    let ordered =
        eigen.minor >= R::ZERO && eigen.minor.to_f64() <= 1.000_001 * eigen.major.to_f64();
    ensure(ordered, "0 <= minor <= major", &(inputs, eigen))
}

/// A covariance with a factor exact in `R`, and the entries of it in f64.
fn draw<R: Real>(source: &mut Source) -> (Psd<R>, [f64; 3]) {
    let m: Psd<R> = source.ellipse().roughness().matrix();
    let [l_xx, l_yx, l_yy] = m.cholesky().map(Real::to_f64);
    (m, [l_xx * l_xx, l_xx * l_yx, l_yx * l_yx + l_yy * l_yy])
}

/// The determinant of symmetric f64 entries, to f64's rounding of their products.
fn det(entries: [f64; 3]) -> (f64, f64) {
    (matrix(entries).determinant(), 8.0 * ULP * entries[0] * entries[2])
}

fn sums_and_scalings<R: Real>(source: &mut Source) -> TestCaseResult {
    let ((a, a_entries), (b, b_entries)) = (draw::<R>(source), draw::<R>(source));
    let factor = R::lit(source.log_uniform(1e-3, 1e3));
    let inputs = (a, b, factor);
    let few = 16.0 * R::EPSILON.to_f64();
    for (m, entries) in [(&a, a_entries), (&b, b_entries)] {
        is_covariance(m, &inputs)?;
        let (want, rounding) = det(entries);
        near(m.det().to_f64(), want, few * want.abs() + rounding, &inputs)?;
    }
    let sum = a + b;
    is_covariance(&sum, &inputs)?;
    let (want, rounding) = det([0, 1, 2].map(|k| a_entries[k] + b_entries[k]));
    near(sum.det().to_f64(), want, few * want + rounding, &inputs)?;
    let scaled = a * factor;
    is_covariance(&scaled, &inputs)?;
    let square = factor.to_f64() * factor.to_f64();
    near(scaled.det().to_f64(), a.det().to_f64() * square, few * a.det().to_f64() * square, &inputs)
}

#[test]
fn sums_carry_their_determinant() {
    check(100_000, sums_and_scalings::<f64>);
    check(100_000, sums_and_scalings::<f32>);
}

/// A lobe under a kernel of rank one or two: what the entries of the sum have lost in f32.
fn outer_sums<R: Real>(source: &mut Source) -> TestCaseResult {
    let (a, _) = draw::<R>(source);
    let vectors = source.kernel().map(|v| v.map(R::lit));
    let [u, v] = vectors.map(|v| v.map(R::to_f64));
    let kernel = Psd::outer_sum(vectors[0], vectors[1]);
    let inputs = (a, vectors);
    is_covariance(&kernel, &inputs)?;
    let few = 32.0 * R::EPSILON.to_f64();
    let size = (u[0].hypot(u[1])) * (v[0].hypot(v[1]));
    let cross = nalgebra::Matrix2::from_columns(&[u.into(), v.into()]).determinant().abs();
    // Sides moved by a rounding each.
    let moved = R::EPSILON.to_f64() * ((u[0] * v[1]).abs() + (u[1] * v[0]).abs());
    let least = (R::MIN_POSITIVE.to_f64() / R::EPSILON.to_f64()).sqrt()
        * (u[0].hypot(u[1]) + v[0].hypot(v[1]));
    let rounding = 2.0 * moved + 4.0 * ULP * size + least;
    near(kernel.root_det().to_f64(), cross, few * cross + rounding, &inputs)?;
    let widened = a + kernel;
    is_covariance(&widened, &inputs)?;
    let numbers = [&a.cholesky().map(R::to_f64)[..], &u, &v].concat();
    let got = widened.root_det().to_f64();
    if R::SINGLE {
        let limits = [R::EPSILON.to_f64(), least, f64::INFINITY];
        return backward(got, &root_det_of_sum, &numbers, limits, &inputs);
    }
    // f64 by its own formula: a few roundings of the terms' factors.
    let want = root_det_of_sum(&numbers);
    let [l_xx, l_yx, l_yy] = a.cholesky().map(R::to_f64);
    let length = |w: [f64; 2]| w[0].hypot(w[1]);
    let rows = (l_xx.hypot(u[0]).hypot(v[0])) * (l_yx.hypot(l_yy).hypot(length([u[1], v[1]])));
    near(got, want, few * (want + rows) + least, &inputs)
}

/// $\sqrt{\det (L L^T + u u^T + v v^T)}$ of the factor's three entries, u and v, by Cauchy-Binet.
fn root_det_of_sum(x: &[f64]) -> f64 {
    let columns = [[x[0], x[1]], [0.0, x[2]], [x[3], x[4]], [x[5], x[6]]];
    let mut det = 0.0;
    for (k, a) in columns.iter().enumerate() {
        for b in &columns[..k] {
            det += (a[0] * b[1] - a[1] * b[0]).powi(2);
        }
    }
    det.sqrt()
}

#[test]
fn a_kernel_leaves_the_determinant_of_a_thin_lobe() {
    // Fewer inputs do not find a determinant of the entries alone.
    check_all(100_000, outer_sums::<f64>);
    check_all(100_000, outer_sums::<f32>);
}

fn merges<R: Real>(source: &mut Source) -> TestCaseResult {
    let patches = [(); 2].map(|()| (source.slope().map(R::lit), draw::<R>(source)));
    let weights = match source.pick(4) {
        0 => [0.0, 1.0],
        1 => [1.0, 1e-6],
        _ => [source.uniform(0.01, 1.0), source.uniform(0.01, 1.0)],
    }
    .map(R::lit);
    let [one, two] =
        patches.map(|(mean, (m, _))| SlopeMoments::new(mean, m).expect("a finite mean"));
    let merged = one.merged(weights[0], &two, weights[1]).expect("a weight above 0");
    let inputs = (patches, weights);
    is_covariance(&merged.covariance(), &inputs)?;
    // By raw moments in f64, which cancel: the covariance is known to an ulp of the largest.
    let [p, q] = weights.map(Real::to_f64);
    let (p, q) = (p / (p + q), q / (p + q));
    let means = patches.map(|(mean, _)| mean.map(R::to_f64));
    let mean = [0, 1].map(|k| p * means[0][k] + q * means[1][k]);
    let raw = |k: usize| {
        let (m, [xx, xy, yy]) = (means[k], patches[k].1.1);
        [xx + m[0] * m[0], xy + m[0] * m[1], yy + m[1] * m[1]]
    };
    let (first, second) = (raw(0), raw(1));
    let outer = [mean[0] * mean[0], mean[0] * mean[1], mean[1] * mean[1]];
    let want = [0, 1, 2].map(|k| p * first[k] + q * second[k] - outer[k]);
    let eps = R::EPSILON.to_f64();
    let size = means.iter().flatten().map(|x| x.abs()).fold(0.0, f64::max);
    let trace = want[0] + want[2];
    let tolerance = 16.0 * eps * trace + 16.0 * ULP * size * size;
    near_all(&doubles(&merged.covariance()), &want, tolerance, &inputs)?;
    near_all(&merged.mean().map(Real::to_f64), &mean, 4.0 * eps * size, &inputs)?;
    // Order does not matter; merging with oneself changes nothing.
    let other = two.merged(weights[1], &one, weights[0]).expect("a weight above 0");
    near_all(&doubles(&other.covariance()), &want, tolerance, &inputs)?;
    let itself = one.merged(weights[0], &one, weights[1]).expect("a weight above 0");
    let (got, want) = (doubles(&itself.covariance()), doubles(&one.covariance()));
    near_all(&got, &want, 8.0 * eps * (want[0] + want[2]), &inputs)
}

#[test]
fn the_moments_of_a_union_are_the_mean_of_moments() {
    check(50_000, merges::<f64>);
    check(50_000, merges::<f32>);
}

/// Raw moments, as a LEAN texture holds them, of a patch: its covariance comes back.
#[test]
fn raw_moments_give_the_covariance_back() {
    check(50_000, |source| {
        let (m, [xx, xy, yy]) = draw::<f64>(source);
        let [x, y] = source.slope();
        let raw = [xx + x * x, xy + x * y, yy + y * y];
        let moments = SlopeMoments::from_raw([x, y], raw).expect("finite moments");
        let inputs = (m, x, y);
        is_covariance(&moments.covariance(), &inputs)?;
        // Rounding of the raw moments moves each entry by an ulp of theirs; mending moves it no
        // further than as much again.
        let tolerance = 4.0 * ULP * (raw[0] + raw[2]);
        near_all(&moments.covariance().entries(), &[xx, xy, yy], tolerance, &inputs)
    });
}

/// The nearest: negative eigenvalues become 0, positive ones and the axes stay.
fn mends<R: Real>(source: &mut Source) -> TestCaseResult {
    let eigen = [source.uniform(-1.0, 1.0), source.uniform(-1.0, 1.0)]
        .map(|x| x * 10.0_f64.powi(2 - source.pick(8) as i32));
    let (sin, cos) = source.angle().sin_cos();
    let turned = |[a, b]: [f64; 2]| {
        [a * cos * cos + b * sin * sin, (a - b) * sin * cos, a * sin * sin + b * cos * cos]
    };
    let [xx, xy, yy] = turned(eigen).map(R::lit);
    let mended = Psd::nearest(xx, xy, yy);
    let inputs = (eigen, sin, cos);
    is_covariance(&mended, &inputs)?;
    let want = turned(eigen.map(|x| x.max(0.0)));
    let size = eigen[0].abs().max(eigen[1].abs());
    near_all(&doubles(&mended), &want, 16.0 * R::EPSILON.to_f64() * size, &inputs)
}

#[test]
fn the_nearest_covariance_drops_negative_eigenvalues_alone() {
    check(50_000, mends::<f64>);
    check(50_000, mends::<f32>);
}

/// Eigenvalues, factor and quadratic form are nalgebra's.
fn decomposes<R: Real>(source: &mut Source) -> TestCaseResult {
    let (m, entries) = draw::<R>(source);
    let w = source.vector(1e-3, 1e3).map(R::lit);
    let inputs = (m, w);
    let few = 16.0 * R::EPSILON.to_f64();
    let trace = entries[0] + entries[2];
    let eigen = m.eigen();
    let got = [eigen.major, eigen.minor].map(Real::to_f64);
    near_all(&got, &eigenvalues(entries), few * trace, &inputs)?;
    // det/major is right to more digits than nalgebra's difference.
    let (product, rounding) = det(entries);
    near(got[0] * got[1], product, few * product + rounding, &inputs)?;
    let axis = nalgebra::Vector2::from(eigen.axis.map(Real::to_f64));
    near(axis.norm(), 1.0, few, &inputs)?;
    let residual = matrix(entries) * axis - got[0] * axis;
    near(residual.norm(), 0.0, few * trace, &inputs)?;
    let [l11, l21, l22] = m.cholesky().map(Real::to_f64);
    let factor = nalgebra::Matrix2::new(l11, 0.0, l21, l22);
    let back = factor * factor.transpose() - matrix(entries);
    near(back.abs().max(), 0.0, few * trace, &inputs)?;
    let exact = nalgebra::Vector2::from(w.map(R::to_f64));
    let want = (exact.transpose() * matrix(entries) * exact).x;
    let rounding = 8.0 * ULP * trace * exact.norm_squared();
    // The factor's first column moved by a rounding each.
    let moved = few * ((l11 * exact.x).abs() + (l21 * exact.y).abs());
    let rounding = rounding + moved * (2.0 * want.sqrt() + moved);
    near(m.quadratic(w).to_f64(), want, few * want + rounding, &inputs)?;
    let limit = R::lit(source.log_uniform(1e-8, 1e3));
    let capped = m.capped(limit);
    is_covariance(&capped, &inputs)?;
    let want = got.map(|x| x.min(limit.to_f64()));
    let trace = want[0] + want[1];
    near_all(&eigenvalues(doubles(&capped)), &want, few * trace, &(inputs, limit))?;
    near(capped.det().to_f64(), want[0] * want[1], 2.0 * few * want[0] * want[1], &(inputs, limit))
}

#[test]
fn decompositions_are_those_of_nalgebra() {
    check(50_000, decomposes::<f64>);
    check(50_000, decomposes::<f32>);
}

/// A right angle's cosine is 6e-17, and its square at the end of f32.
#[test]
fn an_axis_that_is_a_rounding_of_zero_does_not_count() {
    let lobe = Psd::new(9.2386e-6_f32, 0.0, 1e-8).expect("positive");
    let along_y = |x: f32| Psd::outer_sum([x, 4e-3], [-0.37 * x, -4e-3]);
    let want = (lobe + along_y(0.0)).root_det();
    for x in [1e-17_f32, 1e-18, 2.7e-19, 1e-19, 1e-22] {
        for half in [along_y(x), along_y(x) * 0.16] {
            let whole = (half + half) * 0.5;
            let scale = half.entries()[2] / along_y(0.0).entries()[2];
            let got = (lobe + whole * (1.0 / scale)).root_det();
            assert!((got / want - 1.0).abs() < 1e-6, "{x:e}: {got:e}, not {want:e}");
        }
    }
}
