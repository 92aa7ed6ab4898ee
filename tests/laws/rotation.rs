//! Filters and densities know no axes: turn lobe, footprint and slope together, and nothing
//! changes.
//!
//! The law that finds a transposed kernel, a Gram matrix, and a clamp along the frame's axes.

use crate::common::arbitrary::{LobeInput, Source};
use crate::common::reference::{Known, rotate, rotate_matrix};
use crate::common::{ULP, check, ensure, near, near_all};
use core::fmt::Debug;
use lobe::filter::ggx_gaussian_mean;
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::{Footprint, Ggx, Kernel, Lobe, Ndf, PixelFilter, Psd, Roughness, SlopeMoments};
use proptest::test_runner::TestCaseResult;

fn turn(footprint: &Footprint<f64>, angle: f64) -> Footprint<f64> {
    Footprint { u: rotate(footprint.u, angle), v: rotate(footprint.v, angle) }
}

fn outer(vectors: [[f64; 2]; 2]) -> Psd<f64> {
    Psd::outer_sum(vectors[0], vectors[1])
}

/// A lobe by alphas along its axes and their angle, so that its determinant is the same at every
/// angle.
#[derive(Clone, Copy, Debug)]
struct Turnable {
    alphas: [f64; 2],
    angle: f64,
    mean: [f64; 2],
}

impl Turnable {
    fn draw(source: &mut Source) -> Self {
        let LobeInput { ellipse, mean } = source.lobe();
        Self { alphas: [ellipse.x, ellipse.y], angle: source.angle(), mean }
    }

    fn turned(&self, angle: f64) -> Lobe<f64> {
        let [x, y] = self.alphas;
        let roughness = Roughness::from_alphas(x, y, self.angle + angle).expect("alphas > 0");
        Lobe::new(rotate(self.mean, angle), roughness).expect("a finite mean")
    }

    /// The slope at `w` alphas along the axes.
    fn slope_at(&self, w: [f64; 2]) -> [f64; 2] {
        let offset = rotate([self.alphas[0] * w[0], self.alphas[1] * w[1]], self.angle);
        [self.mean[0] + offset[0], self.mean[1] + offset[1]]
    }

    /// Relative error of a density whose slope, of size `reach`, and whose axes are rounded: a
    /// shift of so many smaller alphas, times the logarithmic derivative, at most 2 (1 +
    /// `distance`).
    fn slack(&self, reach: f64, distance: f64) -> f64 {
        let [x, y] = self.alphas;
        let length = |v: [f64; 2]| v[0].hypot(v[1]);
        16.0 * (1.0 + distance) * ULP * (1.0 + (reach + length(self.mean)) / x.min(y))
    }
}

/// The matrices agree, entries and determinants within the tolerances given.
fn same_matrix(
    got: &Psd<f64>,
    unturned: &Psd<f64>,
    angle: f64,
    [entries, det]: [f64; 2],
    inputs: &dyn Debug,
) -> TestCaseResult {
    let want = rotate_matrix(unturned.entries(), angle);
    near_all(&got.entries(), &want, entries, inputs)?;
    near(got.det(), unturned.det(), det, inputs)
}

fn density_turns<D: Known>(source: &mut Source) -> TestCaseResult {
    let (lobe, angle) = (Turnable::draw(source), source.angle());
    let w = source.vector(1e-3, 8.0);
    let slope = lobe.slope_at(w);
    let density =
        |angle| Ndf::<D, _>::new(lobe.turned(angle).shape()).slope_pdf(rotate(slope, angle));
    let distance = w[0].hypot(w[1]);
    let slack = lobe.slack(slope[0].hypot(slope[1]), distance);
    near(density(angle), density(0.0), slack * density(0.0), &(D::NAME, lobe, w, angle))
}

#[test]
fn slope_densities_turn_with_their_lobe() {
    check(20_000, density_turns::<GgxDistribution>);
    check(20_000, density_turns::<BeckmannDistribution>);
}

fn masking_turns<D: Known>(source: &mut Source) -> TestCaseResult {
    let (lobe, angle) = (Turnable::draw(source), source.angle());
    let pair = source.pair();
    let at = |angle| {
        let [wo, wi] = pair.map(|w| {
            let [x, y] = rotate([w[0], w[1]], angle);
            [x, y, w[2]]
        });
        let ndf = Ndf::<D, _>::new(lobe.turned(angle).shape());
        [ndf.projected_area(wo), ndf.projected_area(wi)]
    };
    // c and a err by a few roundings of their terms, and the area's derivatives are below 1. Across
    // a ridge, a has the rounding of the axes times the larger alpha.
    let [x, y] = lobe.alphas;
    let size = 1.0 + x.max(y) + lobe.mean[0].hypot(lobe.mean[1]);
    near_all(&at(angle), &at(0.0), 16.0 * ULP * size, &(D::NAME, lobe, pair, angle))
}

#[test]
fn projected_areas_turn_with_their_lobe() {
    check(20_000, masking_turns::<GgxDistribution>);
    check(20_000, masking_turns::<BeckmannDistribution>);
}

/// The law for any way to make a kernel of a footprint.
fn kernel_turns(
    kernel: impl Fn(&Footprint<f64>) -> Psd<f64>,
    source: &mut Source,
) -> TestCaseResult {
    let (footprint, angle) = (source.footprint(), source.angle());
    let (still, turned) = (kernel(&footprint), kernel(&turn(&footprint, angle)));
    // Entries are sums of products, the determinant's root a difference: roundings of the trace.
    let trace = still.trace();
    let tolerances = [32.0 * ULP * trace, 64.0 * ULP * trace * trace];
    same_matrix(&turned, &still, angle, tolerances, &(footprint, angle))
}

#[test]
fn kernels_turn_with_their_footprint() {
    check(20_000, |source| {
        kernel_turns(|f| Kernel::of(f, PixelFilter::KAPLANYAN).covariance(), source)
    });
}

/// The Gram matrix of the pixel axes, what Kaplanyan's Eq. 13 gives when read with row vectors.
fn gram(footprint: &Footprint<f64>) -> Psd<f64> {
    let Footprint { u, v } = *footprint;
    outer([[u[0], v[0]], [u[1], v[1]]])
}

#[test]
fn the_law_of_rotation_finds_a_gram_matrix() {
    let caught = (0..100).filter(|&seed| {
        let footprint = |source: &mut Source| kernel_turns(gram, source);
        footprint(&mut Source::from_seed(seed)).is_err()
    });
    let caught = caught.count();
    assert!(caught > 50, "the law of rotation caught a Gram matrix {caught} times in 100");
    // Trace and determinant agree: a test on round lobes sees nothing.
    let footprint = Footprint::from_slopes([0.3, 0.1], [-0.2, 0.5]);
    let right = Kernel::of(&footprint, PixelFilter::KAPLANYAN).covariance();
    let wrong = gram(&footprint) * 0.25;
    assert!((right.trace() - wrong.trace()).abs() < 1e-15);
    assert!((right.det() - wrong.det()).abs() < 1e-15);
}

#[test]
fn widened_and_capped_lobes_turn_with_their_kernel() {
    check(20_000, |source| {
        let (lobe, angle) = (Turnable::draw(source), source.angle());
        let (vectors, limit) = (source.kernel(), source.log_uniform(1e-6, 10.0));
        let at = |angle| {
            let kernel = Kernel::from_covariance(outer(vectors.map(|v| rotate(v, angle))));
            let widened = lobe.turned(angle).widened(&kernel).roughness().matrix();
            (widened, kernel.capped(limit).covariance(), kernel.covariance())
        };
        let ((still, still_cap, kernel), (turned, turned_cap, _)) = (at(0.0), at(angle));
        let inputs = (lobe, vectors, limit, angle);
        let [x, y] = lobe.alphas;
        let (base, added) = (x * x + y * y, 2.0 * kernel.trace());
        // The determinant of the sum is a sum of terms, each below a product of two traces.
        let products = still.det() + (base + added) * added;
        let tolerances = [32.0 * ULP * (base + added), 64.0 * ULP * products];
        same_matrix(&turned, &still, angle, tolerances, &inputs)?;
        // The smaller eigenvalue, det/major, has the error of the determinant's root, some ulp of
        // the trace, times twice that root over the trace.
        let error = 32.0 * ULP * (still_cap.trace() + kernel.root_det());
        let tolerances = [error, 2.0 * error * still_cap.trace()];
        same_matrix(&turned_cap, &still_cap, angle, tolerances, &inputs)
    });
}

#[test]
fn rescaled_footprints_turn() {
    check(20_000, |source| {
        let (footprint, angle) = (source.footprint(), source.angle());
        let limit = source.log_uniform(1e-6, 10.0);
        let still = turn(&footprint.capped(limit), angle);
        let turned = turn(&footprint, angle).capped(limit);
        let tolerance = 16.0 * ULP * footprint.diameter();
        let inputs = (footprint, angle, limit);
        near_all(&turned.u, &still.u, tolerance, &inputs)?;
        near_all(&turned.v, &still.v, tolerance, &inputs)?;
        near(turned.area(), still.area(), tolerance * footprint.diameter(), &inputs)
    });
}

#[test]
fn means_over_parallelograms_turn() {
    check(20_000, |source| {
        let (lobe, angle) = (Turnable::draw(source), source.angle());
        let (w, footprint) = (source.vector(1e-3, 30.0), source.footprint());
        let slope = lobe.slope_at(w);
        let at = |angle| {
            Ggx::new(lobe.turned(angle).shape())
                .parallelogram_mean(rotate(slope, angle), &turn(&footprint, angle))
        };
        let reach = slope[0].hypot(slope[1]) + footprint.diameter();
        // GGX's logarithmic derivative is at most 2 alphas^-1; 1e-9 is the documented error.
        let relative = 2e-9 + lobe.slack(reach, 1.0);
        near(at(angle), at(0.0), relative * at(0.0), &(lobe, slope, footprint, angle))
    });
}

#[test]
fn means_under_gaussians_turn() {
    check(4000, |source| {
        let (lobe, angle) = (Turnable::draw(source), source.angle());
        let (w, vectors) = (source.vector(1e-3, 30.0), source.kernel());
        let slope = lobe.slope_at(w);
        let at = |angle| {
            let kernel = Kernel::from_covariance(outer(vectors.map(|v| rotate(v, angle))));
            ggx_gaussian_mean(&lobe.turned(angle), rotate(slope, angle), &kernel)
        };
        // The documented error; rounded entries move the lobe like a slope of the kernel's size.
        let size = vectors.iter().map(|v| v[0].hypot(v[1])).sum::<f64>();
        let relative = 2e-12 + lobe.slack(slope[0].hypot(slope[1]) + size, 30.0);
        near(at(angle), at(0.0), relative * at(0.0), &(lobe, slope, vectors, angle))
    });
}

#[test]
fn slope_moments_turn() {
    check(20_000, |source| {
        let angle = source.angle();
        let patches = [(source.slope(), source.kernel()), (source.slope(), source.kernel())];
        let weights = [source.uniform(0.01, 1.0), source.unit()];
        let at = |angle| {
            let [one, two] = patches.map(|(mean, vectors)| {
                let covariance = outer(vectors.map(|v| rotate(v, angle)));
                SlopeMoments::new(rotate(mean, angle), covariance).expect("a finite mean")
            });
            one.merged(weights[0], &two, weights[1]).expect("weights that sum to more than 0")
        };
        let (still, turned) = (at(0.0), at(angle));
        let inputs = (patches, weights, angle);
        let size = patches.iter().map(|(mean, _)| mean[0].hypot(mean[1])).sum::<f64>();
        near_all(&turned.mean(), &rotate(still.mean(), angle), 16.0 * ULP * size, &inputs)?;
        let trace = still.covariance().trace() + size * size;
        let want = rotate_matrix(still.covariance().entries(), angle);
        near_all(&turned.covariance().entries(), &want, 32.0 * ULP * trace, &inputs)?;
        let dets = [turned, still].map(|m| m.covariance().det());
        near(dets[0], dets[1], 64.0 * ULP * trace * trace, &inputs)?;
        ensure(dets.iter().all(|det| *det >= 0.0), "determinants are not negative", &inputs)
    });
}
