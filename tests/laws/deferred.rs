//! Laws of the deferred forms and of what engines ship.
#![cfg(feature = "published")]

use crate::common::arbitrary::Source;
use crate::common::reference::eigenvalues;
use crate::common::{ULP, check, ensure, near};
use lobe::filter::engine::Engine;
use lobe::filter::{
    ShadingFrame, kaplanyan_deferred_alpha, kaplanyan_deferred_alphas, largest_deferred_alpha,
    quad_normal_footprint, tokuyoshi_deferred_alpha, tokuyoshi_kaplanyan_deferred_alpha,
};
use lobe::slope::Motion;
use lobe::{Error, Footprint, PixelFilter};
use nalgebra::{Rotation3, Vector3};
use proptest::test_runner::TestCaseResult;

const FILTER: PixelFilter = PixelFilter::KAPLANYAN;

/// Derivatives of a normal: tangential, of the size of a pixel's.
fn derivatives(source: &mut Source) -> [[f64; 2]; 2] {
    let u = source.vector(1e-6, 1.0);
    match source.pick(4) {
        0 => [u, [0.0; 2]],
        1 => [u, [-u[1], u[0]]],
        _ => [u, source.vector(1e-6, 1.0)],
    }
}

fn in_space([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

/// Mean, largest and sum of the kernel's eigenvalues, by nalgebra from the outer products.
fn forms_are_what_they_say(source: &mut Source) -> TestCaseResult {
    let (alpha, steps) = (source.log_uniform(1e-4, 0.5), derivatives(source));
    let [u, v] = steps;
    let outer = [0, 1, 2].map(|k| {
        let (i, j) = [(0, 0), (0, 1), (1, 1)][k];
        0.25 * (u[i] * u[j] + v[i] * v[j])
    });
    let [major, minor] = eigenvalues(outer);
    // In world space, in any frame: turned about a random axis.
    let axis = Vector3::from([source.uniform(-1.0, 1.0), source.uniform(-1.0, 1.0), 0.5]);
    let turn = Rotation3::new(axis * source.uniform(0.0, 3.0));
    let [dn_u, dn_v] = steps.map(|d| <[f64; 3]>::from(turn * Vector3::from(in_space(d))));
    let inputs = (alpha, steps);
    // No limit: what is added is read off below alpha' = 1.
    let far = 1e9;
    let forms = [
        (tokuyoshi_kaplanyan_deferred_alpha(alpha, dn_u, dn_v, FILTER, far), major + minor),
        (largest_deferred_alpha(alpha, dn_u, dn_v, FILTER, far), 2.0 * major),
        (tokuyoshi_deferred_alpha(alpha, dn_u, dn_v, FILTER, far), 2.0 * (major + minor)),
    ];
    let mut before = alpha;
    for (got, added) in forms {
        let (got, want) = (got.expect("in range"), (alpha * alpha + added).sqrt().min(1.0));
        near(got, want, 1e-13 * want, &inputs)?;
        ensure(got >= before * (1.0 - 8.0 * ULP), "mean, largest, sum: in this order", &inputs)?;
        before = got;
    }
    let limited = tokuyoshi_deferred_alpha(alpha, dn_u, dn_v, FILTER, 0.18).expect("in range");
    let want = (alpha * alpha + (2.0 * (major + minor)).min(0.18)).sqrt();
    near(limited, want, 1e-13 * want, &inputs)
}

#[test]
fn deferred_forms_take_mean_largest_and_sum_of_the_eigenvalues() {
    check(20_000, forms_are_what_they_say);
}

fn rectangles(source: &mut Source) -> TestCaseResult {
    let [u, v] = derivatives(source);
    let (x, y) = (source.log_uniform(1e-4, 0.5), source.log_uniform(1e-4, 0.5));
    let footprint = Footprint::from_slopes(u, v);
    let limit = source.log_uniform(1e-3, 1.0);
    let inputs = (u, v, x, y, limit);
    let alphas = kaplanyan_deferred_alphas([x, y], &footprint, FILTER, limit).expect("in range");
    for k in 0..2 {
        let width = u[k].abs() + v[k].abs();
        let added = (0.5 * width * width).min(limit);
        let want = ([x, y][k].powi(2) + added).sqrt().min(1.0);
        near(alphas[k], want, 1e-14, &inputs)?;
    }
    let same = kaplanyan_deferred_alphas([x, x], &footprint, FILTER, limit).expect("in range");
    let one = kaplanyan_deferred_alpha(x, &footprint, FILTER, limit).expect("in range");
    ensure(one == same[0].max(same[1]), "one channel takes the larger", &inputs)
}

#[test]
fn rectangles_filter_each_axis() {
    check(10_000, rectangles);
}

/// The frame that follows the normal of a sphere, turned by the rotation vector.
fn frame(turn: Vector3<f64>) -> ShadingFrame<f64> {
    let rotation = Rotation3::new(turn);
    [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| <[f64; 3]>::from(rotation * axis))
}

/// To first order the quad's footprint is that of Eq. 17: half vectors stay, normals turn.
fn quads(source: &mut Source) -> TestCaseResult {
    let size = source.log_uniform(1e-5, 1e-2);
    let angles = [source.vector(0.1 * size, size), source.vector(0.1 * size, size)];
    // A turn of (x, y) about (-y, x) tilts the normal by (x, y).
    let turn = |[x, y]: [f64; 2]| Vector3::new(-y, x, 0.0);
    let [u, v] = angles;
    let quad = [[0.0; 2], u, v, [u[0] + v[0], u[1] + v[1]]].map(|tilt| frame(turn(tilt)));
    let got = quad_normal_footprint(&quad).expect("above");
    let motion = |normal| Motion { normal, ..Motion::default() };
    let want = Footprint::from_motion([0.0, 0.0, 1.0], &motion(u), &motion(v)).expect("above");
    for k in 0..2 {
        near(got.u[k], want.u[k], 8.0 * size * size * size, &angles)?;
        near(got.v[k], want.v[k], 8.0 * size * size * size, &angles)?;
    }
    Ok(())
}

#[test]
fn a_quad_s_average_normal_moves_as_its_frames_turn() {
    check(5000, quads);
}

fn engines(source: &mut Source) -> TestCaseResult {
    let (alpha, [u, v]) = (source.log_uniform(1e-4, 1.0), derivatives(source).map(in_space));
    let inputs = (alpha, u, v);
    let of = |engine: Engine| engine.alpha(alpha, u, v).expect("in range");
    let filter = |variance| PixelFilter::with_variance(variance).expect("in range");
    let meant = |variance, limit| {
        tokuyoshi_deferred_alpha(alpha, u, v, filter(variance), limit).expect("in range")
    };
    let same = |a: f64, b: f64| near(a, b, 1e-14, &inputs);
    same(of(Engine::Filament), meant(0.15, 0.04))?;
    same(of(Engine::UnityHdrp), meant(0.1, 0.04))?;
    same(of(Engine::O3de), meant(0.25, 0.18))?;
    let half = tokuyoshi_kaplanyan_deferred_alpha(alpha, u, v, FILTER, 0.18).expect("in range");
    same(of(Engine::BevyProposal), half)?;
    for &engine in Engine::ALL {
        let (got, none) = (of(engine), engine.alpha(alpha, [0.0; 3], [0.0; 3]).expect("in range"));
        ensure(got.is_finite() && got >= none, "change only adds", &(engine, inputs, got, none))?;
        let more = engine.alpha(alpha, u.map(|x| 2.0 * x), v.map(|x| 2.0 * x)).expect("in range");
        ensure(more >= got, "more change adds more", &(engine, inputs))?;
        let single = engine.alpha(alpha as f32, u.map(|x| x as f32), v.map(|x| x as f32));
        near(f64::from(single.expect("in range")), got, 1e-5 * got, &(engine, inputs))?;
    }
    Ok(())
}

#[test]
fn presets_are_the_formulas_that_they_cite_where_they_are() {
    check(10_000, engines);
}

#[test]
fn numbers_out_of_range_are_refused_and_derivatives_without_a_number_add_nothing() {
    let (d, nan) = ([0.1, 0.0, 0.0], [f64::NAN; 3]);
    let footprint = Footprint::rectangle([0.1, 0.1]);
    for alpha in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(
            tokuyoshi_deferred_alpha(alpha, d, d, FILTER, 0.18),
            Err(Error::Alpha(_))
        ));
        assert!(matches!(largest_deferred_alpha(alpha, d, d, FILTER, 0.18), Err(Error::Alpha(_))));
        assert!(matches!(Engine::Godot.alpha(alpha, d, d), Err(Error::Alpha(_))));
        let second = kaplanyan_deferred_alphas([0.1, alpha], &footprint, FILTER, 0.18);
        assert!(matches!(second, Err(Error::AlphaY(_))));
        let first = kaplanyan_deferred_alphas([alpha, 0.1], &footprint, FILTER, 0.18);
        assert!(matches!(first, Err(Error::AlphaX(_))));
    }
    for limit in [-1.0, f64::NAN] {
        let kaplanyan = kaplanyan_deferred_alpha(0.1, &footprint, FILTER, limit);
        assert!(matches!(kaplanyan, Err(Error::Limit(_))));
        let newer = tokuyoshi_kaplanyan_deferred_alpha(0.1, d, d, FILTER, limit);
        assert!(matches!(newer, Err(Error::Limit(_))));
    }
    assert_eq!(tokuyoshi_deferred_alpha(0.1, nan, d, FILTER, 0.18), Ok(0.1));
    let huge = [1e200, 0.0, 0.0];
    assert_eq!(tokuyoshi_deferred_alpha(0.0, huge, d, FILTER, 0.18), Ok(0.18_f64.sqrt()));
    assert_eq!(tokuyoshi_deferred_alpha(3.0, d, d, FILTER, 0.18), Ok(3.0));
    for &engine in Engine::ALL {
        for alpha in [0.0_f32, 1e-9, 0.5, 1.0, 1e9] {
            for x in [0.0_f32, 1e-30, 1e-3, 2.0, f32::MAX, f32::INFINITY, f32::NAN] {
                let got = engine.alpha(alpha, [x, 0.0, 0.0], [0.0, -x, 0.0]).expect("in range");
                assert!(got.is_finite() && got >= 0.0, "{engine:?} {alpha} {x}: {got}");
            }
        }
    }
}
