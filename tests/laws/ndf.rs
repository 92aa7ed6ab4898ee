//! Laws of slope densities and densities of normals.

use crate::common::arbitrary::{Ellipse, LobeInput, Source};
use crate::common::quadrature::over_plane;
use crate::common::reference::Known;
use crate::common::{ULP, check, ensure, near};
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::{
    Anisotropic, AxisAligned, Footprint, Isotropic, LobeShape, Ndf, NonCentered, Roughness,
};
use proptest::test_runner::TestCaseResult;

/// Mass 1, in the lobe's own polar coordinates. Rounding a slope moves it by `blur` alphas; a
/// density changes by less than a factor of 1 + 8 blur, averaged over the lobe.
fn has_mass_one<D: Known>(source: &mut Source) -> TestCaseResult {
    let input = source.lobe();
    let ndf = Ndf::<D, _>::new(input.lobe::<f64>().shape());
    let mass = over_plane(&mut |w| ndf.slope_pdf(input.slope_at(w))) * input.ellipse.root_det();
    near(mass, 1.0, 1e-13 + 8.0 * input.blur(0.0), &(D::NAME, input))
}

#[test]
fn the_slope_density_integrates_to_one() {
    check(1000, has_mass_one::<GgxDistribution>);
    check(1000, has_mass_one::<BeckmannDistribution>);
}

/// statrs' densities err by some 1e-13 (its gamma function); the slope's rounding, `blur` alphas,
/// enters by the logarithmic derivative: at most 2 |w| (Beckmann) or 2 (GGX).
fn is_the_known_density<D: Known>(source: &mut Source) -> TestCaseResult {
    let input = source.lobe();
    let w = source.vector(1e-3, 8.0);
    let slope = input.slope_at(w);
    let got = Ndf::<D, _>::new(input.lobe::<f64>().shape()).slope_pdf(slope);
    let want = D::chained_density(&input, slope);
    let reach = slope[0].abs() + slope[1].abs();
    let distance = 1.0 + w[0].hypot(w[1]);
    // Rounded entries of A also move the ellipse: by an ulp over the squared sine of its angle.
    let skew = ULP / (1.0 - input.ellipse.rho.abs());
    let relative = 1e-12 + 4.0 * distance * input.blur(reach) + 4.0 * distance * distance * skew;
    near(got, want, relative * want, &(D::NAME, input, slope))
}

#[test]
fn the_slope_density_is_that_of_normal_and_student_deviates() {
    check(20_000, is_the_known_density::<GgxDistribution>);
    check(20_000, is_the_known_density::<BeckmannDistribution>);
}

/// Powers of two scale without rounding: equal to the bit.
fn is_homogeneous<D: Known>(source: &mut Source) -> TestCaseResult {
    let input = source.lobe();
    let ndf = Ndf::<D, _>::new(input.lobe::<f64>().shape());
    let slope = source.slope_near(&input);
    let m = [-slope[0], -slope[1], 1.0];
    let inputs = (D::NAME, input, slope);
    ensure(ndf.d(m) == ndf.slope_pdf(slope), "D of (-s, 1) is P22(s)", &inputs)?;
    let scaled = ndf.d(m.map(|x| 0.25 * x));
    ensure(scaled == 256.0 * ndf.d(m), "D has degree -4", &inputs)?;
    let Ellipse { x, y, rho } = input.ellipse;
    let wide = LobeInput {
        ellipse: Ellipse { x: 8.0 * x, y: 8.0 * y, rho },
        mean: input.mean.map(|m| 8.0 * m),
    };
    let density = Ndf::<D, _>::new(wide.lobe::<f64>().shape()).slope_pdf(slope.map(|s| 8.0 * s));
    ensure(64.0 * density == ndf.slope_pdf(slope), "P22 scales with its plane", &inputs)
}

#[test]
fn densities_scale_exactly_with_powers_of_two() {
    check(10_000, is_homogeneous::<GgxDistribution>);
    check(10_000, is_homogeneous::<BeckmannDistribution>);
}

/// Every quantity of two shapes that should be the same.
fn agree<D: Known>(
    a: impl LobeShape<Scalar = f64>,
    b: impl LobeShape<Scalar = f64>,
    source: &mut Source,
    inputs: &dyn core::fmt::Debug,
) -> TestCaseResult {
    let slope = source.vector(1e-3, 3.0);
    let [wo, wi] = source.pair();
    let inputs = (D::NAME, inputs, slope, wo, wi);
    let (a, b) = (Ndf::<D, _>::new(a), Ndf::<D, _>::new(b));
    // A dozen roundings; the exponent of Beckmann, up to 740, multiplies them.
    let unit = a.shape().extent().unit;
    let exponent = a.shape().form([-slope[0], -slope[1], 1.0]) / unit;
    let h = [wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]];
    let steep = a.shape().form(h) / unit / (h[2] * h[2]);
    let few = 32.0 * ULP;
    let same = |x: f64, y: f64, factor: f64| {
        // Below the normal numbers there are no digits to compare.
        near(x, y, few * factor.clamp(1.0, 750.0) * y + 1e-290, &inputs)
    };
    same(a.slope_pdf(slope), b.slope_pdf(slope), exponent)?;
    same(a.brdf(wo, wi), b.brdf(wo, wi), steep)?;
    for w in [wo, wi] {
        let (c, a2) = (a.shape().mean_area(w), a.shape().stretch_squared(w));
        same(a.projected_area(w), b.projected_area(w), c * c / a2)?;
        same(a.lambda(w), b.lambda(w), c * c / a2)?;
        same(a.g1(w), b.g1(w), 1.0)?;
    }
    same(a.visibility(wo, wi), b.visibility(wo, wi), 1.0)
}

fn shapes_agree<D: Known>(source: &mut Source) -> TestCaseResult {
    let (alpha, other) = (source.alpha(), source.alpha());
    let inputs = (alpha, other);
    let round = Isotropic::new(alpha).expect("alpha > 0");
    let square = AxisAligned::new(alpha, alpha).expect("alphas > 0");
    let anisotropic = Anisotropic::new(Roughness::from_alpha(alpha).expect("alpha > 0"));
    let non_centered = NonCentered::new(round, [0.0; 2]).expect("a finite mean");
    agree::<D>(round, square, source, &inputs)?;
    agree::<D>(round, anisotropic, source, &inputs)?;
    agree::<D>(round, non_centered, source, &inputs)?;
    let oblong = AxisAligned::new(alpha, other).expect("alphas > 0");
    let anisotropic =
        Anisotropic::new(Roughness::from_alphas(alpha, other, 0.0).expect("alphas > 0"));
    agree::<D>(oblong, anisotropic, source, &inputs)?;
    let mean = source.mean();
    let (one, two) = (NonCentered::new(oblong, mean), NonCentered::new(anisotropic, mean));
    agree::<D>(one.expect("finite"), two.expect("finite"), source, &(inputs, mean))
}

#[test]
fn shapes_that_say_the_same_lobe_agree() {
    check(10_000, shapes_agree::<GgxDistribution>);
    check(10_000, shapes_agree::<BeckmannDistribution>);
}

#[test]
fn shapes_agree_on_means_over_footprints() {
    check(10_000, |source| {
        let (x, y) = (source.alpha(), source.alpha());
        let (slope, footprint) = (source.slope(), source.footprint());
        let aligned = lobe::Ggx::new(AxisAligned::new(x, y).expect("alphas > 0"));
        let anisotropic = Roughness::from_alphas(x, y, 0.0).expect("alphas > 0");
        let anisotropic = lobe::Ggx::new(Anisotropic::new(anisotropic));
        let (a, b) = (
            aligned.parallelogram_mean(slope, &footprint),
            anisotropic.parallelogram_mean(slope, &footprint),
        );
        // Each errs by less than 1e-9, as documented.
        near(a, b, 2e-9 * b, &(x, y, slope, footprint))?;
        let round = lobe::Ggx::new(Isotropic::new(x).expect("alpha > 0"));
        let square = lobe::Ggx::new(AxisAligned::new(x, x).expect("alpha > 0"));
        let widths = footprint.extents();
        let rectangle = Footprint::rectangle(widths);
        let want = square.parallelogram_mean(slope, &rectangle);
        near(round.rectangle_mean(slope, widths), want, 2e-9 * want, &(x, slope, widths))
    });
}
