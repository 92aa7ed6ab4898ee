//! Limits: mirrors, horizons, opposite directions. Nothing is NaN, and what is known is exact.

use crate::common::arbitrary::Source;
use crate::common::reference::Known;
use crate::common::{check, ensure, near};
use core::f64::consts::PI;
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::{
    Anisotropic, AxisAligned, Footprint, Ggx, Isotropic, Lobe, LobeShape, Ndf, Psd, Real, Roughness,
};
use proptest::test_runner::TestCaseResult;

/// The projected area by its closed form, erf by pxfm.
fn area(name: &str, c: f64, a: f64) -> f64 {
    if a == 0.0 {
        return c.max(0.0);
    }
    if name == GgxDistribution::NAME {
        return 0.5 * (c + c.hypot(a));
    }
    let v = c / a;
    0.5 * c * pxfm::f_erfc(-v) + 0.5 * a * (-v * v).exp() / PI.sqrt()
}

/// No density anywhere, masking as of the plane or of the rank-one ridge across it.
fn is_a_mirror<D: Known, S: LobeShape>(
    shape: S,
    ridge: [f64; 2],
    mean: [f64; 2],
    source: &mut Source,
) -> TestCaseResult {
    let ndf = Ndf::<D, _>::new(shape);
    let real = <S::Scalar as Real>::lit;
    let pair = source.pair().map(|w| w.map(real));
    let ([wo, wi], slope) = (pair, source.slope().map(real));
    let inputs = (D::NAME, ridge, mean, wo, wi, slope);
    let here = mean.map(real);
    let m = [-here[0], -here[1], S::Scalar::ONE];
    let densities =
        [ndf.slope_pdf(slope), ndf.slope_pdf(here), ndf.d(wo), ndf.d(m), ndf.brdf(wo, wi)];
    ensure(densities.iter().all(|d| *d == S::Scalar::ZERO), "a mirror has no density", &inputs)?;
    for w in [wo, wi, wo.map(|x| -x)] {
        let exact = w.map(Real::to_f64);
        // Two roundings of each term of c, and of a.
        let terms = [exact[2], mean[0] * exact[0], mean[1] * exact[1]];
        let c = terms[0] - terms[1] - terms[2];
        let a = (ridge[0] * exact[0] + ridge[1] * exact[1]).abs();
        let size = terms.iter().map(|t| t.abs()).sum::<f64>()
            + ridge[0].abs() * exact[0].abs()
            + ridge[1].abs() * exact[1].abs();
        let got = ndf.projected_area(w).to_f64();
        near(got, area(D::NAME, c, a), 8.0 * S::Scalar::EPSILON.to_f64() * size, &inputs)?;
        let finite = [ndf.lambda(w), ndf.g1(w)].iter().all(|x| x.is_finite());
        ensure(finite, "Lambda and G1 are finite", &inputs)?;
    }
    let (g2, visibility) = (ndf.g2(wo, wi), ndf.visibility(wo, wi));
    ensure(g2.is_finite() && visibility.is_finite(), "G2 and V are finite", &inputs)
}

fn every_mirror<D: Known, R: Real>(source: &mut Source) -> TestCaseResult {
    let zero = [0.0; 2];
    let alpha = R::lit(source.alpha());
    let exact = alpha.to_f64();
    let flat = Isotropic::new(R::ZERO).expect("alpha = 0 is a mirror");
    is_a_mirror::<D, _>(flat, zero, zero, source)?;
    let aligned = |x, y| AxisAligned::new(x, y).expect("alphas of 0 are mirrors");
    is_a_mirror::<D, _>(aligned(R::ZERO, R::ZERO), zero, zero, source)?;
    is_a_mirror::<D, _>(aligned(alpha, R::ZERO), [exact, 0.0], zero, source)?;
    is_a_mirror::<D, _>(aligned(R::ZERO, alpha), [0.0, exact], zero, source)?;
    let ridge = source.vector(1e-4, 30.0).map(R::lit);
    let mean = source.mean().map(R::lit);
    for (ridge, mean) in [(ridge, mean), ([R::ZERO; 2], mean), (ridge, [R::ZERO; 2])] {
        let roughness = Roughness::from_matrix(Psd::outer_sum(ridge, [R::ZERO; 2]));
        let lobe = Lobe::new(mean, roughness).expect("a finite mean");
        is_a_mirror::<D, _>(lobe.shape(), ridge.map(R::to_f64), mean.map(R::to_f64), source)?;
    }
    Ok(())
}

#[test]
fn a_mirror_has_no_density_and_the_area_of_its_plane_or_ridge() {
    check(10_000, every_mirror::<GgxDistribution, f64>);
    check(10_000, every_mirror::<BeckmannDistribution, f64>);
    check(10_000, every_mirror::<GgxDistribution, f32>);
    check(10_000, every_mirror::<BeckmannDistribution, f32>);
}

/// A direction from `w` down through the surface: exactly opposite, or near it on either side.
fn opposite(w: [f64; 3], source: &mut Source) -> [f64; 3] {
    let z = match source.pick(4) {
        0 => -w[2],
        1 => -w[2] + source.log_uniform(1e-12, 1e-3),
        2 => -w[2] - source.log_uniform(1e-12, 1e-3),
        _ => source.nudged(-w[2]),
    };
    let [x, y] = if source.pick(2) == 0 { [0.0; 2] } else { source.vector(1e-9, 1e-2) };
    [x - w[0], y - w[1], z]
}

fn nothing_comes_from_below<D: Known, R: Real>(source: &mut Source) -> TestCaseResult {
    let ellipse = source.ellipse();
    let ndf = Ndf::<D, _>::new(Anisotropic::new(ellipse.roughness::<R>()));
    let wo = source.direction();
    let below = opposite(wo, source).map(R::lit);
    let wo = wo.map(R::lit);
    let up = source.direction().map(R::lit);
    let down = [up[0], up[1], -up[2]];
    let flat = [up[0], up[1], R::ZERO];
    let Footprint { u, v } = source.footprint();
    let footprint = Footprint { u: u.map(R::lit), v: v.map(R::lit) };
    let ggx = Ggx::new(Anisotropic::new(ellipse.roughness::<R>()));
    for wi in [below, down, flat, wo.map(|x| -x)] {
        let inputs = (D::NAME, ellipse, wo, wi, footprint);
        if wi[2] > R::ZERO {
            continue;
        }
        let all = [
            ndf.d(wi),
            ndf.brdf(wo, wi),
            ndf.brdf(wi, wo),
            ndf.brdf(wi, wi),
            ndf.g1(wi),
            ndf.g2(wo, wi),
            ndf.visibility(wo, wi),
            ggx.brdf_over(wo, wi, &footprint),
            ggx.brdf_over(wi, wo, &footprint),
        ];
        ensure(all.iter().all(|x| *x == R::ZERO), "0 below the horizon", &(inputs, all))?;
    }
    Ok(())
}

#[test]
fn nothing_is_reflected_below_the_horizon() {
    check(20_000, nothing_comes_from_below::<GgxDistribution, f64>);
    check(20_000, nothing_comes_from_below::<BeckmannDistribution, f64>);
    check(20_000, nothing_comes_from_below::<GgxDistribution, f32>);
    check(20_000, nothing_comes_from_below::<BeckmannDistribution, f32>);
}

/// Also for a tilted lobe, whose mean plane has another horizon than the surface.
fn opposites_reflect_nothing<D: Known, R: Real>(source: &mut Source) -> TestCaseResult {
    let input = source.lobe();
    let ndf = Ndf::<D, _>::new(input.lobe::<R>().shape());
    let wo = source.direction().map(R::lit);
    let wi = wo.map(|x| -x);
    let got = [ndf.brdf(wo, wi), ndf.brdf(wi, wo), ndf.visibility(wo, wi), ndf.g2(wo, wi)];
    let zero = got.iter().all(|x| *x == R::ZERO);
    ensure(zero, "opposite directions reflect nothing", &(D::NAME, input, wo, got))?;
    // Below the mean plane, wherever the surface's own horizon is.
    let other = source.direction().map(R::lit);
    let inputs = (D::NAME, input, wo, other);
    if ndf.shape().mean_area(other) <= R::ZERO {
        let masked = ndf.brdf(wo, other) == R::ZERO && ndf.brdf(other, wo) == R::ZERO;
        ensure(masked, "0 below the mean plane", &inputs)?;
    }
    Ok(())
}

#[test]
fn opposite_directions_reflect_nothing() {
    check(20_000, opposites_reflect_nothing::<GgxDistribution, f64>);
    check(20_000, opposites_reflect_nothing::<BeckmannDistribution, f64>);
    check(20_000, opposites_reflect_nothing::<GgxDistribution, f32>);
    check(20_000, opposites_reflect_nothing::<BeckmannDistribution, f32>);
}
