//! The promise of default shapes: a result is the exact one for parameters, directions and result
//! moved by at most 16 roundings, over the whole documented domain.

use crate::budget::ROUNDINGS;
use crate::common::arbitrary::Source;
use crate::common::check;
use crate::common::reference::Known;
use crate::roundings::{roundings, roundings_to_first_order};
use core::fmt::Debug;
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::slope::Widened;
use lobe::{
    Anisotropic, AxisAligned, Isotropic, LobeShape, Ndf, NonCentered, Psd, Real, Roughness,
};
use proptest::test_runner::{TestCaseError, TestCaseResult};

/// `got` is finite, not negative, and exact for inputs and result moved by [`ROUNDINGS`].
///
/// `unit`, `least` and `most` are the relative rounding, the smallest normal number and the largest
/// number of the precision that `got` was computed in.
pub(crate) fn backward(
    got: f64,
    f: &dyn Fn(&[f64]) -> f64,
    inputs: &[f64],
    [unit, least, most]: [f64; 3],
    context: &dyn Debug,
) -> TestCaseResult {
    let fail = |what: &str, exact: f64| {
        let message = format!("{what}: got {got:e}, exact {exact:e}; {inputs:?}, {context:?}");
        Err(TestCaseError::fail(message))
    };
    if !(got.is_finite() && got >= 0.0) {
        return fail("not finite, or negative", f(inputs));
    }
    let bounded = |x: &[f64]| f(x).min(most);
    let count = roundings(got, &bounded, inputs, unit, least);
    if count <= ROUNDINGS { Ok(()) } else { fail(&format!("{count} roundings"), f(inputs)) }
}

/// What is asked of a lobe, at numbers of its own.
#[derive(Clone, Copy, Debug)]
enum Query {
    SlopePdf,
    D,
    ProjectedArea,
    G1,
    Visibility,
    Brdf,
}

/// A shape, by the numbers that make it: base, then mean, then columns.
#[derive(Clone, Copy, Debug)]
struct Form {
    base: Base,
    tilted: bool,
    widened: bool,
}

#[derive(Clone, Copy, Debug)]
enum Base {
    Isotropic,
    AxisAligned,
    Full,
}

fn asked<D: Known, S: LobeShape>(shape: S, query: Query, x: &[S::Scalar]) -> S::Scalar {
    let ndf = Ndf::<D, S>::new(shape);
    let vector = |k: usize| [x[k], x[k + 1], x[k + 2]];
    match query {
        Query::SlopePdf => ndf.slope_pdf([x[0], x[1]]),
        Query::D => ndf.d(vector(0)),
        Query::ProjectedArea => ndf.projected_area(vector(0)),
        Query::G1 => ndf.g1(vector(0)),
        Query::Visibility => ndf.visibility(vector(0), vector(3)),
        Query::Brdf => ndf.brdf(vector(0), vector(3)),
    }
}

fn widened<D: Known, S: LobeShape>(
    shape: S,
    form: Form,
    query: Query,
    x: &[S::Scalar],
) -> S::Scalar {
    if form.widened {
        let shape = Widened::new(shape, [x[0], x[1]], [x[2], x[3]]);
        asked::<D, _>(shape, query, &x[4..])
    } else {
        asked::<D, _>(shape, query, x)
    }
}

fn tilted<D: Known, S: LobeShape>(
    shape: S,
    form: Form,
    query: Query,
    x: &[S::Scalar],
) -> S::Scalar {
    if form.tilted {
        widened::<D, _>(NonCentered::saturating(shape, [x[0], x[1]]), form, query, &x[2..])
    } else {
        widened::<D, _>(shape, form, query, x)
    }
}

/// The library at these numbers, in either precision.
fn value<D: Known, R: Real>(form: Form, query: Query, x: &[R]) -> R {
    match form.base {
        Base::Isotropic => tilted::<D, _>(Isotropic::saturating(x[0]), form, query, &x[1..]),
        Base::AxisAligned => {
            tilted::<D, _>(AxisAligned::saturating(x[0], x[1]), form, query, &x[2..])
        }
        Base::Full => {
            let factor = Psd::from_cholesky([x[0], x[1], x[2]]).expect("a factor");
            let shape = Anisotropic::new(Roughness::from_matrix(factor));
            tilted::<D, _>(shape, form, query, &x[3..])
        }
    }
}

/// A light in the mirror direction about a normal of this slope.
fn mirrored(wo: [f64; 3], slope: [f64; 2]) -> [f64; 3] {
    let m = [-slope[0], -slope[1], 1.0];
    let twice = 2.0 * (wo[0] * m[0] + wo[1] * m[1] + wo[2]) / (m[0] * m[0] + m[1] * m[1] + 1.0);
    [0, 1, 2].map(|k| twice * m[k] - wo[k])
}

fn holds<D: Known>(source: &mut Source) -> TestCaseResult {
    let base = [Base::Full, Base::Isotropic, Base::AxisAligned][source.pick(3) as usize];
    let form = Form { base, tilted: source.pick(2) == 1, widened: source.pick(2) == 1 };
    let lobe = source.lobe();
    let mean = if form.tilted { lobe.mean } else { [0.0; 2] };
    let (x, y, rho) = (lobe.ellipse.x, lobe.ellipse.y, lobe.ellipse.rho);
    let mut inputs = match base {
        Base::Isotropic => vec![x],
        Base::AxisAligned => vec![x, y],
        Base::Full => vec![x, rho * y, y * ((1.0 - rho) * (1.0 + rho)).sqrt()],
    };
    if form.tilted {
        inputs.extend(mean);
    }
    let columns = source.kernel();
    if form.widened {
        inputs.extend(columns.concat());
    }
    let parameters = inputs.clone();
    // Near the lobe, near what the kernel makes of it, or anywhere.
    let steps = [source.uniform(-2.0, 2.0), source.uniform(-2.0, 2.0)];
    let slope = match source.pick(3) {
        0 => source.slope(),
        1 => [0, 1].map(|k| mean[k] + steps[0] * columns[0][k] + steps[1] * columns[1][k]),
        _ => source.slope_near(&lobe),
    };
    let [wo, wi] = source.pair();
    let wi = if source.pick(2) == 0 { wi } else { mirrored(wo, slope) };
    let z = 1.0 / (1.0 + slope[0] * slope[0] + slope[1] * slope[1]).sqrt();
    let queries = [
        (Query::SlopePdf, slope.to_vec()),
        (Query::D, vec![-slope[0] * z, -slope[1] * z, z]),
        (Query::D, wo.to_vec()),
        (Query::ProjectedArea, wi.to_vec()),
        (Query::G1, wo.to_vec()),
        (Query::Visibility, [wo, wi].concat()),
        (Query::Brdf, [wo, wi].concat()),
    ];
    for (query, place) in queries {
        let inputs: Vec<f64> = [&parameters[..], &place[..]].concat();
        let single: Vec<f32> = inputs.iter().map(|&x| x as f32).collect();
        let double: Vec<f64> = single.iter().map(|&x| f64::from(x)).collect();
        let got = f64::from(value::<D, f32>(form, query, &single));
        let exact = |x: &[f64]| value::<D, f64>(form, query, x);
        let limits = [f64::from(f32::EPSILON), f64::from(f32::MIN_POSITIVE), f64::from(f32::MAX)];
        backward(got, &exact, &double, limits, &(D::NAME, form, query))?;
    }
    Ok(())
}

#[test]
fn results_are_exact_for_inputs_moved_by_sixteen_roundings() {
    check(100_000, holds::<GgxDistribution>);
    check(100_000, holds::<BeckmannDistribution>);
}

/// The difference x - y moves by x + y + (x - y) roundings where x, y and the difference move by
/// one rounding each.
#[test]
fn roundings_are_counted_in_powers_of_two() {
    const UNIT: f64 = 1e-7;
    let (x, y) = (1.0, 0.999);
    let difference = |x: &[f64]| x[0] - x[1];
    let one = UNIT * (x + y + (x - y));
    for (share, count) in [
        (0.0, 1.0),
        (0.9, 1.0),
        (-0.9, 1.0),
        (1.1, 2.0),
        (-3.9, 4.0),
        (4.1, 8.0),
        (-4000.0, 4096.0),
        (4200.0, f64::INFINITY),
        (f64::NAN, f64::INFINITY),
    ] {
        let got = x - y + share * one;
        for method in [roundings, roundings_to_first_order] {
            assert_eq!(method(got, &difference, &[x, y], UNIT, 0.0), count, "{share}");
        }
    }
}

/// A function without a value above x = 1, which rises as x falls: no move of x makes it smaller,
/// so a smaller result is explained by roundings of the result alone.
#[test]
fn inputs_without_a_value_are_not_moved_to() {
    let falling = |x: &[f64]| if x[0] > 1.0 { f64::NAN } else { 2.0 - x[0].powi(100) };
    for method in [roundings, roundings_to_first_order] {
        assert_eq!(method(1.001, &falling, &[1.0], 1e-5, 0.0), 1.0);
        assert_eq!(method(1.0, &|_| f64::NAN, &[1.0], 1e-5, 0.0), f64::INFINITY);
    }
    assert_eq!(roundings(0.999, &falling, &[1.0], 1e-5, 0.0), 128.0);
}

/// The largest value lies next to inputs without one, where the search must not lose it.
#[test]
fn the_search_turns_away_from_inputs_without_a_value() {
    const UNIT: f64 = 1e-5;
    let rising = |x: &[f64]| {
        let moved = (x[0] - 1.0) / UNIT;
        if moved > 0.3 { f64::NAN } else { 1.0 + 1000.0 * UNIT * moved }
    };
    assert_eq!(roundings(1.0 + 290.0 * UNIT, &rising, &[1.0], UNIT, 0.0), 1.0);
}
