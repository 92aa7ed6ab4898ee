//! Laws of means over polygons: GGX over parallelograms and rectangles, Beckmann over rectangles.
#![cfg(feature = "published")]

use crate::common::arbitrary::{LobeInput, Source};
use crate::common::quadrature::{adaptive, over_square};
use crate::common::reference::Known;
use crate::common::{ULP, check, ensure, near};
use core::f64::consts::PI;
use lobe::filter::{beckmann_rectangle_mean, kaplanyan_rectangle_mean};
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::{AxisAligned, Footprint, Ggx, Lobe};
use proptest::test_runner::TestCaseResult;

/// The documented error of f64.
const DOUBLE: f64 = 1e-9;

/// A lobe, a center up to `far` alphas away, and a footprint.
fn scene(source: &mut Source, far: f64) -> (LobeInput, [f64; 2], Footprint<f64>) {
    let input = source.lobe();
    let w = source.vector(1e-3, far);
    (input, input.slope_at(w), source.footprint())
}

/// Relative error by rounding of slopes: GGX's logarithmic derivative is at most 2 per alpha.
fn slack(input: &LobeInput, slope: [f64; 2], footprint: &Footprint<f64>) -> f64 {
    8.0 * input.blur(slope[0].hypot(slope[1]) + footprint.diameter())
}

fn mean(lobe: &Lobe<f64>, slope: [f64; 2], footprint: &Footprint<f64>) -> f64 {
    Ggx::new(lobe.shape()).parallelogram_mean(slope, footprint)
}

fn shifted(slope: [f64; 2], v: [f64; 2], factor: f64) -> [f64; 2] {
    [slope[0] + factor * v[0], slope[1] + factor * v[1]]
}

#[test]
fn signs_and_order_of_the_sides_do_not_matter() {
    check(100_000, |source| {
        let (input, slope, footprint) = scene(source, 1e3);
        let lobe = input.lobe();
        let Footprint { u, v } = footprint;
        let want = mean(&lobe, slope, &footprint);
        let minus = |v: [f64; 2]| v.map(|x| -x);
        for (u, v) in [(v, u), (minus(u), v), (u, minus(v)), (minus(v), u)] {
            let got = mean(&lobe, slope, &Footprint { u, v });
            near(got, want, 2.0 * DOUBLE * want, &(input, slope, footprint))?;
        }
        Ok(())
    });
}

/// The mean over the whole is the mean of the means over its halves and quarters, which take other
/// ways through the code: sizes and aspect ratios halve.
#[test]
fn a_mean_is_the_mean_over_its_parts() {
    check(100_000, |source| {
        let (input, slope, footprint) = scene(source, 1e3);
        let lobe = input.lobe();
        let Footprint { u, v } = footprint;
        let want = mean(&lobe, slope, &footprint);
        let tolerance = (2.0 * DOUBLE + slack(&input, slope, &footprint)) * want;
        let half = |v: [f64; 2]| v.map(|x| 0.5 * x);
        let inputs = (input, slope, footprint);
        for (axis, part) in [(u, Footprint { u: half(u), v }), (v, Footprint { u, v: half(v) })] {
            let parts = [-0.25, 0.25].map(|f| mean(&lobe, shifted(slope, axis, f), &part));
            near(0.5 * (parts[0] + parts[1]), want, tolerance, &(inputs, part, parts))?;
        }
        let quarter = Footprint { u: half(u), v: half(v) };
        let mut sum = 0.0;
        for (f, g) in [(-0.25, -0.25), (-0.25, 0.25), (0.25, -0.25), (0.25, 0.25)] {
            sum += mean(&lobe, shifted(shifted(slope, u, f), v, g), &quarter);
        }
        near(0.25 * sum, want, tolerance, &(inputs, "quarters"))
    });
}

/// By adaptive quadrature of the density in whitened coordinates: no rounding of slopes.
#[test]
fn the_mean_over_a_parallelogram_is_its_integral() {
    check(4000, |source| {
        let input = source.mild_lobe();
        // Center and sides in alphas of the lobe: pixels up to 30 alphas wide.
        let (center, u) = (source.vector(1e-2, 30.0), source.vector(1e-2, 30.0));
        let v = match source.pick(4) {
            0 => [0.0; 2],
            1 => u.map(|x| 0.5 * x),
            _ => source.vector(1e-2, 30.0),
        };
        let mut density = |x: f64, y: f64| {
            GgxDistribution::unit_density([0, 1].map(|k| center[k] + x * u[k] + y * v[k]))
        };
        let want = over_square(&mut density, 1e-10) / input.ellipse.root_det();
        let side = |w: [f64; 2]| {
            let s = input.slope_at(w);
            [s[0] - input.mean[0], s[1] - input.mean[1]]
        };
        // Sides without the mean's rounding.
        let centered = LobeInput { mean: [0.0; 2], ..input };
        let footprint = Footprint { u: centered.slope_at(u), v: centered.slope_at(v) };
        let slope = shifted(input.mean, side(center), 1.0);
        let got = mean(&input.lobe(), slope, &footprint);
        let tolerance = (2.0 * DOUBLE + 4.0 * slack(&input, slope, &footprint)) * want;
        near(got, want, tolerance, &(input, center, u, v))
    });
}

#[test]
fn a_parallelogram_along_the_axes_is_a_rectangle() {
    check(50_000, |source| {
        let (input, slope, footprint) = scene(source, 100.0);
        let ggx = Ggx::new(input.lobe::<f64>().shape());
        let widths = footprint.extents();
        let along = Footprint::from_slopes([widths[0], 0.0], [0.0, widths[1]]);
        let want = ggx.parallelogram_mean(slope, &along);
        let got = ggx.rectangle_mean(slope, widths);
        near(got, want, 2.0 * DOUBLE * want, &(input, slope, widths))
    });
}

/// Eight terms of at most pi/2, each with a few roundings and with corners rounded, over 2 pi w_x
/// w_y: an absolute error, small against the mean unless the rectangle is small or far.
#[test]
fn a_rectangle_agrees_with_kaplanyans_appendix() {
    check(50_000, |source| {
        let (x, y) = (source.alpha(), source.alpha());
        let widths = [source.log_uniform(1e-2, 1e3) * x, source.log_uniform(1e-2, 1e3) * y];
        let far = [source.uniform(-10.0, 10.0), source.uniform(-10.0, 10.0)];
        let slope = [far[0] * x, far[1] * y];
        let want = kaplanyan_rectangle_mean([x, y], slope, widths);
        let ndf = Ggx::new(AxisAligned::new(x, y).expect("alphas > 0"));
        let got = ndf.rectangle_mean(slope, widths);
        let corner = 1.0 + far[0].abs() + far[1].abs() + widths[0] / x + widths[1] / y;
        let appendix = 8.0 * PI * 4.0 * ULP * corner.min(64.0) / (2.0 * PI * widths[0] * widths[1]);
        near(got, want, DOUBLE * want + appendix, &(x, y, slope, widths))
    });
}

#[test]
fn a_mean_lies_below_the_peak_and_falls_as_its_footprint_grows() {
    check(50_000, |source| {
        let (input, slope, footprint) = scene(source, 100.0);
        let lobe = input.lobe();
        let peak = Ggx::new(lobe.shape()).slope_pdf(input.mean);
        let grown = source.uniform(1.0, 4.0);
        let inputs = (input, slope, footprint, grown);
        let somewhere = mean(&lobe, slope, &footprint);
        ensure(somewhere <= peak * (1.0 + DOUBLE), "mean <= peak", &(inputs, somewhere, peak))?;
        let larger =
            Footprint { u: footprint.u.map(|x| grown * x), v: footprint.v.map(|x| grown * x) };
        let near_mean = mean(&lobe, input.mean, &footprint);
        let far_mean = mean(&lobe, input.mean, &larger);
        let falls = far_mean <= near_mean * (1.0 + 2.0 * DOUBLE);
        ensure(falls, "the mean falls", &(inputs, near_mean, far_mean))
    });
}

#[test]
fn a_footprint_around_all_of_the_lobe_has_mass_one() {
    check(10_000, |source| {
        let LobeInput { ellipse, mean: center } = source.lobe();
        let size = ellipse.x.max(ellipse.y) * 1e7;
        let (sin, cos) = source.angle().sin_cos();
        let shear = source.uniform(-1.0, 1.0);
        let u = [size * cos, size * sin];
        let footprint = Footprint { u, v: [-u[1] + shear * u[0], u[0] + shear * u[1]] };
        let lobe = LobeInput { ellipse, mean: center }.lobe();
        let mass = mean(&lobe, center, &footprint) * footprint.area();
        // Outside: less than the tail beyond the inscribed circle, 1/(1 + r^2), r > 1e6.
        near(mass, 1.0, 2.0 * DOUBLE, &(ellipse, center, footprint))
    });
}

/// A zero-area footprint is a limit, not a special case: continuous there. Over a sliver of
/// relative thickness e the mean differs from the segment's by less than 2 e (length in alphas).
#[test]
fn a_sliver_tends_to_its_segment() {
    check(50_000, |source| {
        let (input, slope, footprint) = scene(source, 100.0);
        let lobe = input.lobe();
        let u = footprint.u;
        let thickness = source.log_uniform(1e-16, 1e-6);
        let across = [-u[1] * thickness, u[0] * thickness];
        let segment = mean(&lobe, slope, &Footprint { u, v: [0.0; 2] });
        let sliver = mean(&lobe, slope, &Footprint { u, v: across });
        let [minor, _] = input.ellipse.widths();
        let wide = across[0].hypot(across[1]) / minor;
        let tolerance = 2.0 * DOUBLE + 2.0 * wide + slack(&input, slope, &footprint);
        near(sliver, segment, tolerance * segment, &(input, slope, u, thickness))
    });
}

/// The product of two one-dimensional integrals of statrs-free formulas: e^{-t^2}/sqrt(pi),
/// adaptive.
#[test]
fn beckmann_over_a_rectangle_is_its_integral() {
    check(20_000, |source| {
        let alphas = [source.alpha(), source.alpha()];
        let far = [source.uniform(-5.0, 5.0), source.uniform(-5.0, 5.0)];
        let sides = [source.log_uniform(1e-6, 1e2), source.log_uniform(1e-6, 1e2)];
        let along = |k: usize| {
            let mut f = |x: f64| BeckmannDistribution::unit_density([far[k] + x * sides[k], 0.0]);
            adaptive(&mut f, -0.5, 0.5, 1e-12) * PI.sqrt() / alphas[k]
        };
        let want = along(0) * along(1);
        let slope = [far[0] * alphas[0], far[1] * alphas[1]];
        let widths = [sides[0] * alphas[0], sides[1] * alphas[1]];
        let got = beckmann_rectangle_mean(alphas, slope, widths);
        near(got, want, 1e-11 * want, &(alphas, slope, widths))
    });
}

fn means_are_total<R: lobe::Real>(source: &mut Source) -> TestCaseResult {
    let (input, slope, footprint) = scene(source, 1e6);
    let footprint = Footprint { u: footprint.u.map(R::lit), v: footprint.v.map(R::lit) };
    let ggx = Ggx::new(input.lobe::<R>().shape());
    let got = ggx.parallelogram_mean(slope.map(R::lit), &footprint);
    let [wo, wi] = source.pair().map(|w| w.map(R::lit));
    let shaded = ggx.brdf_over(wo, wi, &footprint);
    let whole = |x: R| x.is_finite() && x >= R::ZERO;
    let inputs = (input, slope, footprint, wo, wi, got, shaded);
    ensure(whole(got) && whole(shaded), "finite and not negative", &inputs)
}

#[test]
fn means_are_finite_and_never_negative() {
    check(100_000, means_are_total::<f64>);
    check(100_000, means_are_total::<f32>);
}
