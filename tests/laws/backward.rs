//! The promise of plain shapes: a result is the exact one for parameters, directions and result
//! moved by at most 16 units of rounding, over the whole documented domain.

use crate::common::arbitrary::Source;
use crate::common::backward::backward;
use crate::common::check;
use crate::common::reference::Known;
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::slope::Widened;
use lobe::{
    Anisotropic, AxisAligned, Isotropic, LobeShape, Ndf, NonCentered, Psd, Real, Roughness,
};
use proptest::test_runner::TestCaseResult;

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
