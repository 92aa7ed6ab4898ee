//! The algebra of reliefs against sets of slopes that are added, scaled, leaned, stretched and
//! turned one by one; and what a pixel adds to a map.

use crate::common::arbitrary::Source;
use crate::common::{check, near, near_all};
use lobe::{Beckmann, Error, Footprint, Kernel, PixelFilter, Psd, Roughness, SlopeMoments};
use proptest::test_runner::TestCaseResult;

/// Some slopes, equally likely.
fn slopes(source: &mut Source, count: usize) -> Vec<[f64; 2]> {
    let ([x, y], size) = (source.vector(1e-2, 3.0), source.log_uniform(1e-2, 2.0));
    (0..count)
        .map(|_| [x + size * source.uniform(-1.0, 1.0), y + size * source.uniform(-1.0, 1.0)])
        .collect()
}

/// Their moments, by the textbook.
fn moments(slopes: &[[f64; 2]]) -> SlopeMoments<f64> {
    let n = slopes.len() as f64;
    let mean = [0, 1].map(|k| slopes.iter().map(|s| s[k]).sum::<f64>() / n);
    let entry = |i: usize, k: usize| {
        slopes.iter().map(|s| (s[i] - mean[i]) * (s[k] - mean[k])).sum::<f64>() / n
    };
    let covariance = Psd::nearest(entry(0, 0), entry(0, 1), entry(1, 1));
    SlopeMoments::new(mean, covariance).expect("moderate slopes")
}

fn same(
    got: &SlopeMoments<f64>,
    want: &SlopeMoments<f64>,
    inputs: &dyn core::fmt::Debug,
) -> TestCaseResult {
    let size = 1.0 + want.mean()[0].abs() + want.mean()[1].abs() + want.covariance().trace();
    near_all(&got.mean(), &want.mean(), 1e-13 * size, inputs)?;
    near_all(&got.covariance().entries(), &want.covariance().entries(), 1e-13 * size, inputs)?;
    // The root of a determinant has half of its digits where that is small.
    near(got.covariance().root_det(), want.covariance().root_det(), 1e-6 * size, inputs)
}

#[test]
fn independent_layers_are_every_pair_of_slopes() {
    check(2_000, |source| {
        let (a, b) = (slopes(source, 5), slopes(source, 4));
        let all: Vec<[f64; 2]> =
            a.iter().flat_map(|s| b.iter().map(move |t| [s[0] + t[0], s[1] + t[1]])).collect();
        same(&(moments(&a) + moments(&b)), &moments(&all), &(a, b))
    });
}

#[test]
fn correlated_layers_are_their_slopes_one_by_one() {
    check(2_000, |source| {
        let (a, b) = (slopes(source, 6), slopes(source, 6));
        let n = a.len() as f64;
        let raw = [0, 1]
            .map(|i| [0, 1].map(|k| a.iter().zip(&b).map(|(s, t)| s[i] * t[k]).sum::<f64>() / n));
        let sums: Vec<[f64; 2]> =
            a.iter().zip(&b).map(|(s, t)| [s[0] + t[0], s[1] + t[1]]).collect();
        let (one, other) = (moments(&a), moments(&b));
        let cross = one.cross_covariance(&other, raw);
        same(&one.plus_correlated(&other, cross), &moments(&sums), &(&a, &b))?;
        // Independent reliefs have no cross moment but that of their means.
        same(&one.plus_correlated(&other, [[0.0; 2]; 2]), &(one + other), &(a, b))
    });
}

#[test]
fn scaling_leaning_stretching_and_turning_act_on_every_slope() {
    check(2_000, |source| {
        let set = slopes(source, 6);
        let patch = moments(&set);
        let each = |f: &dyn Fn([f64; 2]) -> [f64; 2]| {
            moments(&set.iter().map(|&s| f(s)).collect::<Vec<_>>())
        };
        let t = source.uniform(-3.0, 3.0);
        same(&(patch * t), &each(&|s| s.map(|x| t * x)), &(t, &set))?;
        let lean = source.vector(1e-2, 3.0);
        let leaned = patch.tilted(lean).expect("a slope");
        same(&leaned, &each(&|[x, y]| [x + lean[0], y + lean[1]]), &(lean, &set))?;
        let m = [source.vector(1e-2, 3.0), source.vector(1e-2, 3.0)];
        let apply = |s: [f64; 2]| m.map(|row| row[0] * s[0] + row[1] * s[1]);
        same(&patch.transformed(m), &each(&apply), &(m, &set))?;
        let angle = source.angle();
        let turned = patch.rotated(angle).expect("an angle");
        same(&turned, &each(&|s| crate::common::reference::rotate(s, angle)), &(angle, &set))
    });
}

#[test]
fn stretched_layers_keep_a_determinant_that_entries_lose() {
    // Deviations 1 and 1e-6, turned by 45 degrees: f32 entries know nothing of the smaller.
    let thin = Roughness::from_alphas(1.0_f32, 1e-6, 0.0).expect("alphas").covariance();
    let patch = SlopeMoments::new([0.0_f32; 2], thin).expect("moments");
    let (sin, cos) = core::f32::consts::FRAC_PI_4.sin_cos();
    let turned = patch.transformed([[cos, -sin], [sin, cos]]).covariance();
    assert!((turned.root_det() / thin.root_det() - 1.0).abs() < 1e-5);
    assert!((turned.eigen().minor / thin.eigen().minor - 1.0).abs() < 1e-4);
}

#[test]
fn a_union_is_the_weighted_mean() {
    check(2_000, |source| {
        let (a, b) = (slopes(source, 3), slopes(source, 7));
        let whole = moments(&[a.clone(), b.clone()].concat());
        let merged = moments(&a).merged(3.0, &moments(&b), 7.0).expect("weights");
        same(&merged, &whole, &(a, b))
    });
}

#[test]
fn ends_of_the_ranges_stay_finite() {
    let far = Psd::new(1e18_f32, 0.0, 1e18).expect("entries");
    let patch = SlopeMoments::new([1e9_f32, -1e9], far).expect("moments");
    let all = [
        patch + patch,
        patch * -1e9,
        patch * f32::NAN,
        patch.tilted([1e9, 1e9]).expect("a slope"),
        patch.transformed([[1e9, -1e9], [1e9, 1e9]]),
        patch.plus_correlated(&patch, [[f32::MAX, f32::NAN], [-1e30, 1e18]]),
    ];
    for moments in all {
        let [xx, xy, yy] = moments.covariance().entries();
        let covariance = Psd::new(xx, xy, yy).expect("a covariance");
        assert!(SlopeMoments::new(moments.mean(), covariance).is_ok(), "{moments:?}");
        assert!(moments.covariance().root_det().is_finite(), "{moments:?}");
    }
    assert!(matches!(patch.rotated(f32::INFINITY).map(|_| ()), Err(Error::Angle(_))));
    assert!(matches!(patch.tilted([f32::NAN, 0.0]).map(|_| ()), Err(Error::Mean(_))));
}

#[test]
fn a_pixel_and_a_map_nest_as_kernels_and_count_detail_once() {
    check(500, |source| {
        // A map whose slope is linear over the pixel, and a half vector's slope that moves as well.
        let ([du, dv], h) =
            ([source.vector(1e-2, 0.3), source.vector(1e-2, 0.3)], source.footprint());
        let base = Roughness::from_alpha(source.log_uniform(0.05, 0.5)).expect("alpha");
        let scale = 0.2 / h.diameter().max(1e-9);
        let h = h * scale.min(1.0);
        // The map's moments over the pixel: a box.
        let resolved = Kernel::of(&Footprint::from_slopes(du, dv), PixelFilter::BOX).covariance();
        let patch = SlopeMoments::new([0.1, 0.2], resolved).expect("moments");
        let pixel = Kernel::of(&h, PixelFilter::BOX);
        let once = patch.lobe(base).widened(&pixel).roughness().matrix().entries();
        // Eq. 21 of Kaplanyan: the sum of three matrices.
        let parts = [base.matrix(), resolved * 2.0, pixel.covariance() * 2.0];
        let sum = [0, 1, 2].map(|k| parts.iter().map(|p| p.entries()[k]).sum::<f64>());
        near_all(&once, &sum, 1e-14, &(du, dv, h))?;
        // The other way to count once, the finest level against the moving mean, agrees where the
        // two motions are independent; against each other they know of each other.
        let against = Kernel::of(&(h - Footprint::from_slopes(du, dv)), PixelFilter::BOX)
            .covariance()
            .entries();
        let cross = [0, 1, 2].map(|k| {
            let (i, j) = [(0, 0), (0, 1), (1, 1)][k];
            (h.u[i] * du[j] + h.v[i] * dv[j] + h.u[j] * du[i] + h.v[j] * dv[i]) / 12.0
        });
        let both =
            [0, 1, 2].map(|k| resolved.entries()[k] + pixel.covariance().entries()[k] - cross[k]);
        near_all(&against, &both, 1e-14, &(du, dv, h))?;
        // The lobe peaks lower if detail is counted twice.
        let peak = |roughness: &Roughness<f64>| {
            Beckmann::new(lobe::Anisotropic::new(*roughness)).slope_pdf([0.0, 0.0])
        };
        let right = patch.lobe(base).widened(&pixel).roughness();
        let twice = right.widened(&Kernel::from_covariance(resolved));
        crate::common::ensure(peak(&twice) < peak(&right), "counted twice is darker", &(du, dv, h))
    });
}
