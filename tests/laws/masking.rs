//! Laws of projected area, masking and shadowing.

use crate::common::arbitrary::Source;
use crate::common::reference::{Known, area_by_quadrature, stretch};
use crate::common::{ULP, check, ensure, near};
use lobe::ndf::{BeckmannDistribution, Distribution as _, GgxDistribution};
use lobe::{Footprint, Ggx, LobeShape, Ndf, Real};
use proptest::test_runner::TestCaseResult;

/// A direction of either sign of z.
fn any_direction(source: &mut Source) -> [f64; 3] {
    let [x, y, z] = source.direction();
    if source.pick(4) == 1 { [x, y, -z] } else { [x, y, z] }
}

/// The projected area is the integral of max(0, w.m) D(m) over normals, and G1 times it is c: the
/// weak white furnace. The quadrature errs by 1e-9; densities by 8 blur (a slope's rounding); the
/// mean plane's c by a few roundings of its terms, which enter the area by its derivative, below
/// min(1, 4 (1 + |c/a|) area/a).
fn area_is_the_integral<D: Known>(source: &mut Source, deepest: f64) -> TestCaseResult {
    let input = source.mild_lobe();
    let w = any_direction(source);
    let ndf = Ndf::<D, _>::new(input.lobe::<f64>().shape());
    let c = w[2] - input.mean[0] * w[0] - input.mean[1] * w[1];
    let (a, _) = stretch(&input, w);
    if c < -deepest * a {
        return Ok(());
    }
    let density = |s: [f64; 2]| {
        let z = 1.0 / (1.0 + s[0] * s[0] + s[1] * s[1]).sqrt();
        ndf.d([-s[0] * z, -s[1] * z, z]) * z.powi(4)
    };
    let area = area_by_quadrature(&input, w, &density);
    let terms = w[2].abs() + (input.mean[0] * w[0]).abs() + (input.mean[1] * w[1]).abs();
    let steepness = (4.0 * (1.0 + (c / a).abs()) * area / a).min(1.0);
    let tolerance = (1e-9 + 8.0 * input.blur(0.0)) * area + 4.0 * ULP * terms * steepness;
    let inputs = (D::NAME, input, w);
    near(ndf.projected_area(w), area, tolerance, &inputs)?;
    if c > 4.0 * ULP * terms {
        near(ndf.g1(w) * area, c, tolerance + 4.0 * ULP * terms, &inputs)?;
    }
    Ok(())
}

#[test]
fn the_projected_area_is_the_integral_over_visible_normals() {
    // Down to where the area is small: beyond, nothing is left to integrate.
    check(400, |source| area_is_the_integral::<GgxDistribution>(source, 1e3));
    check(400, |source| area_is_the_integral::<BeckmannDistribution>(source, 5.0));
}

/// sigma = c (1 + Lambda), G1 = 1/(1 + Lambda), sigma(w) - sigma(-w) = c: a few roundings each.
fn one_direction_agrees<D: Known, R: Real>(source: &mut Source) -> TestCaseResult {
    let input = source.lobe();
    let ndf = Ndf::<D, _>::new(input.lobe::<R>().shape());
    let w = any_direction(source).map(R::lit);
    let c = ndf.shape().mean_area(w).to_f64();
    let [area, below, lambda, g1] =
        [ndf.projected_area(w), ndf.projected_area(w.map(|x| -x)), ndf.lambda(w), ndf.g1(w)]
            .map(Real::to_f64);
    let inputs = (D::NAME, input, w);
    let few = 16.0 * R::EPSILON.to_f64();
    near(area - below, c, few * (area + below), &inputs)?;
    ensure(area >= c.max(0.0), "the area is no smaller than the mean plane's", &inputs)?;
    if c > 0.0 {
        near(c * (1.0 + lambda), area, few * area, &inputs)?;
        near(g1, 1.0 / (1.0 + lambda), few * g1, &inputs)?;
        ensure(lambda >= 0.0 && (0.0..=1.0).contains(&g1), "0 <= G1 <= 1", &inputs)
    } else {
        ensure(g1 == 0.0 && lambda == R::MAX.to_f64(), "below the plane all is masked", &inputs)
    }
}

#[test]
fn area_lambda_and_g1_are_one_quantity() {
    check(20_000, one_direction_agrees::<GgxDistribution, f64>);
    check(20_000, one_direction_agrees::<BeckmannDistribution, f64>);
    check(20_000, one_direction_agrees::<GgxDistribution, f32>);
    check(20_000, one_direction_agrees::<BeckmannDistribution, f32>);
}

/// G2 = 1/(1 + Lambda_o + Lambda_i) = 4 c_o c_i V, and 0 <= G2 <= min(G1) <= 1, to a few roundings.
fn pairs_agree<D: Known, R: Real>(source: &mut Source) -> TestCaseResult {
    let input = source.lobe();
    let ndf = Ndf::<D, _>::new(input.lobe::<R>().shape());
    let [wo, wi] = source.pair().map(|w| w.map(R::lit));
    let [g2, v, g1_o, g1_i, lambda_o, lambda_i] = [
        ndf.g2(wo, wi),
        ndf.visibility(wo, wi),
        ndf.g1(wo),
        ndf.g1(wi),
        ndf.lambda(wo),
        ndf.lambda(wi),
    ]
    .map(Real::to_f64);
    let [c_o, c_i] = [wo, wi].map(|w| ndf.shape().mean_area(w).to_f64());
    let inputs = (D::NAME, input, wo, wi);
    let few = 16.0 * R::EPSILON.to_f64();
    ensure(v >= 0.0 && v.is_finite(), "V is finite and not negative", &inputs)?;
    if c_o <= 0.0 || c_i <= 0.0 {
        return ensure(g2 == 0.0 && v == 0.0, "below the plane all is masked", &inputs);
    }
    near(g2, 1.0 / (1.0 + lambda_o + lambda_i), few * g2, &inputs)?;
    near(4.0 * c_o * c_i * v, g2, few * g2, &inputs)?;
    ensure((0.0..=1.0).contains(&g2), "0 <= G2 <= 1", &inputs)?;
    ensure(g2 <= g1_o.min(g1_i) * (1.0 + few), "G2 <= min(G1)", &inputs)
}

#[test]
fn shadowing_follows_from_lambda_and_never_exceeds_masking() {
    check(20_000, pairs_agree::<GgxDistribution, f64>);
    check(20_000, pairs_agree::<BeckmannDistribution, f64>);
    check(20_000, pairs_agree::<GgxDistribution, f32>);
    check(20_000, pairs_agree::<BeckmannDistribution, f32>);
}

/// The even area of a mirror is |c|, at the horizon as well; of a direction along the plane it is
/// a/sqrt(pi). It is never NaN, and no less than |c| unless c^2 underflows.
fn even_areas_at_the_edges<R: Real>() {
    let area = |c: f64, a2: f64| BeckmannDistribution::even_area(R::lit(c), R::lit(a2)).to_f64();
    for c in [0.0, 1e-18, 1e-3, 1.0, 1e9] {
        let c = R::lit(c).to_f64();
        assert_eq!((area(c, 0.0), area(-c, 0.0)), (c, c));
        for a2 in [1e-37, 1e-18, 1.0, 1e18] {
            assert!(area(c, a2) >= c && area(c, a2) == area(-c, a2), "{c:e} {a2:e}");
        }
    }
    let want = core::f64::consts::FRAC_2_SQRT_PI / 2.0;
    assert!((area(0.0, 1.0) - want).abs() < 4.0 * R::EPSILON.to_f64());
}

#[test]
fn even_areas_have_their_values_at_the_edges() {
    even_areas_at_the_edges::<f64>();
    even_areas_at_the_edges::<f32>();
}

/// Lambda depends on w_xy/w_z alone, so w need not have unit length. Monotone to rounding.
fn grows_towards_grazing<D: Known, R: Real>(source: &mut Source) -> TestCaseResult {
    let ellipse = source.ellipse();
    let ndf = Ndf::<D, _>::new(lobe::Anisotropic::new(ellipse.roughness::<R>()));
    let [x, y] = source.vector(1e-3, 1e3).map(R::lit);
    let nearer = match source.pick(3) {
        0 => 1.0 - R::EPSILON.to_f64(),
        1 => source.uniform(0.9, 1.0),
        _ => source.uniform(0.0, 1.0),
    };
    let (high, low) = ([x, y, R::ONE], [x, y, R::lit(nearer)]);
    let (at_high, at_low) = (ndf.lambda(high).to_f64(), ndf.lambda(low).to_f64());
    // A few roundings, which Beckmann's exponent (below 88 or 709, else 0) multiplies.
    let exponent = 1.0 / ndf.shape().stretch_squared(high).to_f64();
    let slack = 1.0 + 8.0 * R::EPSILON.to_f64() * (1.0 + exponent.min(750.0));
    let tiny = 16.0 * R::MIN_POSITIVE.to_f64();
    ensure(
        at_high <= at_low * slack + tiny,
        "Lambda grows towards grazing",
        &(D::NAME, ellipse, high, low, at_high, at_low),
    )
}

#[test]
fn lambda_grows_towards_grazing() {
    check(20_000, grows_towards_grazing::<GgxDistribution, f64>);
    check(20_000, grows_towards_grazing::<BeckmannDistribution, f64>);
    check(20_000, grows_towards_grazing::<GgxDistribution, f32>);
    check(20_000, grows_towards_grazing::<BeckmannDistribution, f32>);
}

/// Equal to the bit: sums and products commute.
fn is_reciprocal<D: Known, R: Real>(source: &mut Source) -> TestCaseResult {
    let input = source.lobe();
    let ndf = Ndf::<D, _>::new(input.lobe::<R>().shape());
    let [wo, wi] = source.pair().map(|w| w.map(R::lit));
    let inputs = (D::NAME, input, wo, wi);
    ensure(ndf.brdf(wo, wi) == ndf.brdf(wi, wo), "brdf is reciprocal", &inputs)?;
    let (there, back) = (ndf.visibility(wo, wi), ndf.visibility(wi, wo));
    ensure(there == back, "visibility is reciprocal", &inputs)?;
    ensure(ndf.g2(wo, wi) == ndf.g2(wi, wo), "G2 is reciprocal", &inputs)?;
    let ggx = Ggx::new(input.lobe::<R>().shape());
    let Footprint { u, v } = source.footprint();
    let footprint = Footprint { u: u.map(R::lit), v: v.map(R::lit) };
    let (there, back) = (ggx.brdf_over(wo, wi, &footprint), ggx.brdf_over(wi, wo, &footprint));
    ensure(there == back, "brdf_over is reciprocal", &(inputs, footprint))
}

#[test]
fn reciprocity_is_exact() {
    check(20_000, is_reciprocal::<GgxDistribution, f64>);
    check(20_000, is_reciprocal::<BeckmannDistribution, f64>);
    check(20_000, is_reciprocal::<GgxDistribution, f32>);
    check(20_000, is_reciprocal::<BeckmannDistribution, f32>);
}

/// Walter's fit: |error of G1| up to 3.11e-3, as documented.
#[test]
fn walters_fit_keeps_its_stated_error() {
    check(20_000, |source| {
        let ellipse = source.ellipse();
        let ndf = lobe::Beckmann::new(lobe::Anisotropic::new(ellipse.roughness::<f64>()));
        let w = source.direction();
        let fit = 1.0 / (1.0 + ndf.lambda_walter(w));
        near(fit, ndf.g1(w), 3.11e-3, &(ellipse, w))
    });
}
