//! Laws of mirrors and grooves over footprints: indicators, chords, and what narrow lobes tend to.

use crate::common::arbitrary::Source;
use crate::common::quadrature::adaptive;
use crate::common::{check, ensure, near};
use core::f64::consts::{FRAC_1_PI, PI};
use lobe::filter::beckmann_rectangle_mean;
use lobe::slope::Whiten;
use lobe::{
    Anisotropic, AxisAligned, Footprint, Ggx, Isotropic, NonCentered, Psd, Real, Roughness,
};
use proptest::test_runner::TestCaseResult;

/// Alphas from one that a pixel resolves to 0, through those whose squares f32 does not have.
const DECADES: [f64; 16] = [
    1e-3, 1e-5, 1e-7, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15, 1e-17, 1e-19, 1e-20, 1e-30,
    1e-38, 0.0,
];

/// The stated error of means, as a part of one over the area.
fn stated<R: Real>() -> f64 {
    if R::SINGLE { 1e-4 } else { 1e-9 }
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn single<R: Real>(v: [f64; 2]) -> ([R; 2], [f64; 2]) {
    let v = v.map(R::lit);
    (v, v.map(R::to_f64))
}

/// A footprint that is no sliver, rounded to a precision, and the rounded numbers.
fn pixel<R: Real>(source: &mut Source) -> (Footprint<R>, Footprint<f64>) {
    let u = source.vector(1e-3, 3.0);
    let (lean, rise) = (source.uniform(-1.0, 1.0), source.log_uniform(0.1, 10.0) * source.sign());
    let v = [lean * u[0] - rise * u[1], lean * u[1] + rise * u[0]];
    let ((u, exact_u), (v, exact_v)) = (single(u), single(v));
    (Footprint { u, v }, Footprint { u: exact_u, v: exact_v })
}

/// A center from which the lobe's mean lies at these parts of the sides.
fn center_at<R: Real>(
    mean: [f64; 2],
    over: &Footprint<f64>,
    [i, j]: [f64; 2],
) -> ([R; 2], [f64; 2]) {
    single([0, 1].map(|k| mean[k] - i * over.u[k] - j * over.v[k]))
}

/// Distance from a point to the footprint's border, and whether the point lies within.
fn border(point: [f64; 2], center: [f64; 2], over: &Footprint<f64>) -> (f64, bool) {
    let at = |i: f64, j: f64| [0, 1].map(|k| center[k] + i * over.u[k] + j * over.v[k] - point[k]);
    let corners = [at(-0.5, -0.5), at(0.5, -0.5), at(0.5, 0.5), at(-0.5, 0.5)];
    let turn = cross(over.u, over.v).signum();
    let (mut nearest, mut inside) = (f64::INFINITY, true);
    for k in 0..4 {
        let (p, q) = (corners[k], corners[(k + 1) % 4]);
        let e = [q[0] - p[0], q[1] - p[1]];
        let t = (-dot(p, e) / dot(e, e)).clamp(0.0, 1.0);
        nearest = nearest.min((p[0] + t * e[0]).hypot(p[1] + t * e[1]));
        inside &= turn * cross(p, e) > 0.0;
    }
    (nearest, inside)
}

#[test]
fn a_mirror_seen_in_a_pixel_is_as_bright_as_its_area_is_small() {
    let (wo, wi) = ([0.6_f32, 0.0, 0.8], [-0.6_f32, 0.0, 0.8]);
    let over = Footprint::from_slopes([0.01_f32, 0.0], [0.0, 0.01]);
    // 1/area, over 4 times both cosines.
    for alpha in DECADES.map(|alpha| alpha as f32).into_iter().filter(|alpha| *alpha <= 1e-7) {
        let lobe = Roughness::from_alpha(alpha).expect("in range");
        let round = Ggx::new(Isotropic::new(alpha).expect("in range")).brdf_over(wo, wi, &over);
        let anisotropic = Ggx::new(Anisotropic::new(lobe)).brdf_over(wo, wi, &over);
        for got in [round, anisotropic] {
            assert!((got / 3906.25 - 1.0).abs() < 1e-6, "{got} at alpha {alpha:e}");
        }
    }
    let mirror = Ggx::new(Isotropic::new(0.0_f32).expect("a mirror"));
    assert_eq!(mirror.brdf_over(wo, [-0.6, 0.01, 0.8], &over), 0.0);
    // No area, no mean.
    assert_eq!(mirror.brdf_over(wo, wi, &Footprint::rectangle([0.0, 0.0])), 0.0);
    assert_eq!(mirror.parallelogram_mean([0.0, 0.0], &Footprint::rectangle([0.1, 0.0])), 0.0);
}

/// The mass of a round GGX beyond a distance d is alpha^2/(alpha^2 + d^2): so far is the mean from
/// the mirror's.
fn tends_to_the_mirror<R: Real>(source: &mut Source) -> TestCaseResult {
    let (footprint, over) = pixel::<R>(source);
    let (mean, exact_mean) = single::<R>(source.vector(1e-3, 3.0));
    let at = match source.pick(3) {
        0 => [source.uniform(-0.5, 0.5), source.uniform(-0.5, 0.5)],
        1 => [source.uniform(-1.5, 1.5), source.uniform(-1.5, 1.5)],
        _ => [0.5 + source.log_uniform(1e-5, 0.1) * source.sign(), source.uniform(-0.6, 0.6)],
    };
    let (center, exact) = center_at::<R>(exact_mean, &over, at);
    let (distance, inside) = border(exact_mean, exact, &over);
    let area = over.area();
    let want = if inside { 1.0 } else { 0.0 };
    for alpha in DECADES {
        let alpha = R::lit(alpha);
        let round =
            NonCentered::new(Isotropic::new(alpha).expect("in range"), mean).expect("finite");
        let anisotropic = Anisotropic::new(Roughness::from_alpha(alpha).expect("in range"));
        let anisotropic = NonCentered::new(anisotropic, mean).expect("finite");
        let got = [
            Ggx::new(round).parallelogram_mean(center, &footprint),
            Ggx::new(anisotropic).parallelogram_mean(center, &footprint),
        ];
        let exact_alpha = alpha.to_f64();
        let beyond = exact_alpha * exact_alpha;
        let beyond = beyond / (beyond + distance * distance);
        for got in got {
            let inputs = (alpha, mean, center, footprint, got);
            near(got.to_f64() * area, want, beyond + stated::<R>(), &inputs)?;
            let exactly = alpha > R::ZERO || inside || got == R::ZERO;
            ensure(exactly, "a mirror outside is not seen", &inputs)?;
        }
    }
    Ok(())
}

#[test]
fn a_narrow_lobe_s_mean_tends_to_the_mirror_s() {
    check(5_000, tends_to_the_mirror::<f32>);
    check(5_000, tends_to_the_mirror::<f64>);
}

/// A border counts by half, a corner by a quarter, so the parts of a footprint add up to the whole.
#[test]
fn a_mirror_on_the_border_is_half_seen() {
    let mirror = Ggx::new(Isotropic::new(0.0_f32).expect("a mirror"));
    let over = Footprint::from_slopes([0.01_f32, 0.003], [-0.002, 0.02]);
    let (u, v) = (over.u, over.v);
    let mean_at = |i: f32, j: f32, over: &Footprint<f32>| {
        mirror.parallelogram_mean([0, 1].map(|k| i * u[k] + j * v[k]), over) * over.area()
    };
    for (i, j, want) in [(0.5, 0.0, 0.5), (0.0, -0.5, 0.5), (-0.5, 0.0, 0.5), (0.0, 0.0, 1.0)] {
        assert!((mean_at(i, j, &over) - want).abs() < 1e-6, "{i} {j}");
    }
    let square = Footprint::from_slopes([0.25_f32, 0.0], [0.0, 0.5]);
    let corner = mirror.parallelogram_mean([0.125, -0.25], &square) * square.area();
    assert_eq!(corner, 0.25);
    let halves = Footprint { u: u.map(|x| 0.5 * x), v };
    let sum = mean_at(0.25, 0.0, &halves) + mean_at(-0.25, 0.0, &halves);
    assert!((sum - mean_at(0.0, 0.0, &over)).abs() < 1e-6, "{sum}");
    for swapped in [Footprint { u: v, v: u }, Footprint { u: u.map(|x| -x), v }] {
        assert_eq!(mean_at(0.5, 0.0, &over), mean_at(0.5, 0.0, &swapped));
    }
}

/// The chord of a line through the mean along `axis` within the footprint: both ends as distances
/// from the mean, by clipping in the footprint's own coordinates; none if the line misses it.
fn chord(axis: [f64; 2], offset: [f64; 2], over: &Footprint<f64>) -> Option<[f64; 2]> {
    let area = cross(over.u, over.v);
    let parts = |w: [f64; 2]| [cross(w, over.v) / area, cross(over.u, w) / area];
    // The mean lies at -offset from the center.
    let (start, step) = (parts(offset.map(|x| -x)), parts(axis));
    let (mut from, mut to) = (f64::NEG_INFINITY, f64::INFINITY);
    for k in 0..2 {
        if step[k] == 0.0 {
            if start[k].abs() > 0.5 {
                return None;
            }
            continue;
        }
        let ends = [(-0.5 - start[k]) / step[k], (0.5 - start[k]) / step[k]];
        from = from.max(ends[0].min(ends[1]));
        to = to.min(ends[0].max(ends[1]));
    }
    (from < to).then_some([from, to])
}

/// GGX's marginal: the integral of $1/(\pi (1 + x^2 + y^2)^2)$ over y.
fn marginal(alpha: f64, x: f64) -> f64 {
    0.5 * alpha * alpha / (alpha * alpha + x * x).powf(1.5)
}

#[test]
fn the_marginal_is_the_integral_across() {
    for x in [0.0, 0.3, 1.0, 4.0] {
        // y = sqrt(1 + x^2) tan t makes the integrand a polynomial of the cosine.
        let mut f = |t: f64| {
            let y = (1.0_f64 + x * x).sqrt() * t.tan();
            let q = 1.0 + x * x + y * y;
            FRAC_1_PI / (q * q) * (1.0 + x * x).sqrt() / (t.cos() * t.cos())
        };
        let across = adaptive(&mut f, -0.5 * PI, 0.5 * PI, 1e-12);
        assert!((across / marginal(1.0, x) - 1.0).abs() < 1e-10, "{x}");
    }
}

/// The mean of a groove by quadrature of the marginal along the chord.
fn groove_mean(alpha: f64, axis: [f64; 2], offset: [f64; 2], over: &Footprint<f64>) -> f64 {
    let Some([from, to]) = chord(axis, offset, over) else { return 0.0 };
    // In pieces between powers of two of alpha: one rule does not see a narrow peak on a long
    // chord.
    let mut ends = vec![from, to, 0.0];
    let longest = from.abs().max(to.abs());
    let mut reach = alpha;
    while reach < longest {
        ends.extend([-reach, reach]);
        reach *= 4.0;
    }
    ends.retain(|x| (from..=to).contains(x));
    ends.sort_by(f64::total_cmp);
    let piece = |w: &[f64]| adaptive(&mut |x| marginal(alpha, x), w[0], w[1], 1e-12);
    ends.windows(2).map(piece).sum::<f64>() / over.area()
}

/// Along the axes, in any direction, centered and tilted; the line passes the footprint anywhere.
fn a_groove_is_its_chord<R: Real>(source: &mut Source) -> TestCaseResult {
    let (footprint, over) = pixel::<R>(source);
    let (mean, exact_mean) = single::<R>(source.vector(1e-3, 3.0));
    let at = [source.uniform(-1.5, 1.5), source.uniform(-1.5, 1.5)];
    let (center, exact) = center_at::<R>(exact_mean, &over, at);
    let offset = [exact[0] - exact_mean[0], exact[1] - exact_mean[1]];
    let alpha = R::lit(source.log_uniform(1e-6, 10.0));
    let ridge = source.vector(1e-6, 10.0).map(R::lit);
    let aligned = |x, y| {
        NonCentered::new(AxisAligned::new(x, y).expect("in range"), mean).expect("a finite mean")
    };
    let along_x = Ggx::new(aligned(alpha, R::ZERO)).parallelogram_mean(center, &footprint);
    let along_y = Ggx::new(aligned(R::ZERO, alpha)).parallelogram_mean(center, &footprint);
    let matrix = Psd::outer_sum(ridge, [R::ZERO; 2]);
    let turned = Anisotropic::new(Roughness::from_matrix(matrix));
    // The axis that the rounded entries have.
    let [xx, xy, yy] = matrix.entries().map(R::to_f64);
    let row = if xx >= yy { [xx, xy] } else { [xy, yy] };
    let length = row[0].hypot(row[1]);
    let turned_axis = row.map(|x| x / length);
    let turned_alpha = length / xx.max(yy).sqrt();
    let turned = NonCentered::new(turned, mean).expect("a finite mean");
    let turned = Ggx::new(turned).parallelogram_mean(center, &footprint);
    let exact_alpha = alpha.to_f64();
    let cases = [
        (along_x, [1.0, 0.0], exact_alpha),
        (along_y, [0.0, 1.0], exact_alpha),
        (turned, turned_axis, turned_alpha),
    ];
    for (got, axis, alpha) in cases {
        let want = groove_mean(alpha, axis, offset, &over);
        // The axis and its length have a few roundings: the line moves by them times its distance
        // from the mean, and the chord by that over the angle to the sides.
        let extent = offset[0].hypot(offset[1]) + over.diameter();
        let shift = 16.0 * R::EPSILON.to_f64() * extent;
        let angle = cross(axis, over.u).abs().max(cross(axis, over.v).abs());
        let short = cross(axis, over.u).abs().min(cross(axis, over.v).abs());
        let nearest = chord(axis, offset, &over)
            .map_or(0.0, |[from, to]| if from * to < 0.0 { 0.0 } else { from.abs().min(to.abs()) });
        // By the change of the chord's part where the line passes a corner, and of the density
        // along it.
        let peak = marginal(alpha, (nearest - shift).max(0.0)) / angle;
        let slack = peak * (shift / short.max(shift)).min(1.0)
            + want * 4.0 * shift / (alpha.hypot(nearest));
        let inputs = (axis, alpha, mean, center, footprint);
        near(got.to_f64(), want, (0.1 * stated::<R>()) * want + slack, &inputs)?;
    }
    Ok(())
}

#[test]
fn a_groove_s_mean_is_the_mass_of_its_chord_over_the_area() {
    check(5_000, a_groove_is_its_chord::<f64>);
    check(5_000, a_groove_is_its_chord::<f32>);
}

/// A footprint without area that crosses a groove has a mean: the line's density over the segment's
/// extent across.
#[test]
fn a_segment_across_a_groove_has_a_mean() {
    let groove = Ggx::new(AxisAligned::new(0.3_f64, 0.0).expect("a groove"));
    for (x, v) in [(0.0, [0.0, 0.1]), (0.2, [0.05, 0.1]), (-2.0, [0.1, -0.02])] {
        let segment = Footprint { u: [0.0; 2], v };
        let got = groove.parallelogram_mean([x, 0.0], &segment);
        let want = marginal(0.3, x) / v[1].abs();
        assert!((got / want - 1.0).abs() < 1e-12, "{got} for {want}");
        // Without extent across it, none.
        assert_eq!(
            groove.parallelogram_mean([x, 0.0], &Footprint { u: [0.1, 0.0], v: [0.0; 2] }),
            0.0
        );
    }
}

/// A lobe that narrows across: its mass differs from the groove's by no more than lies beyond the
/// corners, at most (h/d)^2/4 on either side, and by what its width adds to alpha across the edges
/// that the line crosses.
fn tends_to_the_groove<R: Real>(source: &mut Source) -> TestCaseResult {
    let (footprint, over) = pixel::<R>(source);
    let (center, exact) =
        center_at::<R>([0.0; 2], &over, [source.uniform(-1.0, 1.0), source.uniform(-1.0, 1.0)]);
    let alpha = R::lit(source.log_uniform(1e-2, 3.0));
    let exact_alpha = alpha.to_f64();
    let across_x = source.pick(2) == 0;
    let axis = if across_x { [0.0, 1.0] } else { [1.0, 0.0] };
    let want = groove_mean(exact_alpha, axis, exact, &over) * over.area();
    let corners = [(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]
        .map(|(i, j)| [0, 1].map(|k| exact[k] + i * over.u[k] + j * over.v[k]));
    let clear = corners.iter().map(|c| cross(axis, *c).abs()).fold(f64::INFINITY, f64::min);
    for narrow in DECADES {
        let narrow = R::lit(narrow);
        let (x, y) = if across_x { (narrow, alpha) } else { (alpha, narrow) };
        let shape = AxisAligned::new(x, y).expect("in range");
        let got = Ggx::new(shape).parallelogram_mean(center, &footprint).to_f64() * over.area();
        let h = narrow.to_f64();
        let edges: f64 = [over.u, over.v]
            .iter()
            .map(|e| {
                let part = (h * dot(axis, *e) / (exact_alpha * cross(axis, *e))).abs();
                // d F(C/sigma) with sigma = sqrt(1 + part^2): at most 0.2 part^2, and no more than
                // the mass.
                2.0 * (0.2 * part * part).min(1.0)
            })
            .sum();
        let beyond = (h / clear) * (h / clear);
        let tolerance = beyond + edges + stated::<R>() * want.max(0.1);
        near(got, want, tolerance, &(narrow, alpha, axis, center, footprint))?;
    }
    Ok(())
}

#[test]
fn a_narrowing_lobe_s_mean_tends_to_the_groove_s() {
    check(5_000, tends_to_the_groove::<f64>);
    check(5_000, tends_to_the_groove::<f32>);
}

/// Slivers longer than twice the precision resolves, but as thick as the lobe: they are no
/// mirror's. f64 resolves them.
#[test]
fn slivers_as_thick_as_the_lobe_are_resolved() {
    check(20_000, |source| {
        let alpha = source.log_uniform(1e-9, 1.0) as f32;
        let (length, angle) = (source.log_uniform(1e3, 1e9), source.angle());
        let thick = f64::from(alpha) * source.log_uniform(1e-2, 1e3);
        let (sin, cos) = angle.sin_cos();
        let u = [length * cos, length * sin].map(|x| x as f32);
        // Across its rounded side, so that the sliver is as thick as meant.
        let scale = (thick / length) as f32;
        let v = [-scale * u[1], scale * u[0]];
        let footprint = Footprint { u, v };
        let wide = Footprint { u: u.map(f64::from), v: v.map(f64::from) };
        let ggx = Ggx::new(Isotropic::new(alpha).expect("in range"));
        let exact = Ggx::new(Isotropic::new(f64::from(alpha)).expect("in range"));
        let got = ggx.parallelogram_mean([0.0, 0.0], &footprint);
        let want = exact.parallelogram_mean([0.0, 0.0], &wide);
        near(f64::from(got), want, 1e-3 * want, &(alpha, footprint))
    });
}

/// The BRDF of a tilted mirror: one over the area, at the height of the mirror's own normal, times
/// the visibility.
fn a_mirror_s_brdf_is_its_normal_s<R: Real>(source: &mut Source) -> TestCaseResult {
    let (footprint, over) = pixel::<R>(source);
    let pair = source.pair().map(|w| w.map(R::lit));
    let [wo, wi] = pair.map(|w| w.map(R::to_f64));
    let z = wo[2] + wi[2];
    let slope = [-(wo[0] + wi[0]) / z, -(wo[1] + wi[1]) / z];
    if slope[0].hypot(slope[1]) > 10.0 {
        return Ok(());
    }
    let at = [source.uniform(-0.6, 0.6), source.uniform(-0.6, 0.6)];
    let mean = [0, 1].map(|k| slope[k] + at[0] * over.u[k] + at[1] * over.v[k]);
    let (mean, exact_mean) = single::<R>(mean);
    let (distance, inside) = border(exact_mean, slope, &over);
    for alpha in DECADES.into_iter().filter(|alpha| *alpha <= 1e-9) {
        let round = Isotropic::new(R::lit(alpha)).expect("in range");
        let ggx = Ggx::new(NonCentered::new(round, mean).expect("a finite mean"));
        let secant2 = 1.0 + dot(exact_mean, exact_mean);
        let visible = ggx.visibility(pair[0], pair[1]).to_f64();
        let whole = visible * secant2 * secant2 / over.area();
        let want = if inside { whole } else { 0.0 };
        let got = ggx.brdf_over(pair[0], pair[1], &footprint).to_f64();
        // A mean a few roundings of the slope from the border lies on either side of it.
        let rounding = 1e3 * R::EPSILON.to_f64() * (1.0 + slope[0].hypot(slope[1]));
        if distance > rounding {
            let beyond = 10.0 * alpha / distance;
            let tolerance = (stated::<R>() + beyond) * whole;
            near(got, want, tolerance, &(alpha, mean, pair, footprint))?;
        }
    }
    Ok(())
}

#[test]
fn a_mirror_s_brdf_over_a_footprint_is_that_of_its_own_normal() {
    check(5_000, a_mirror_s_brdf_is_its_normal_s::<f64>);
    check(5_000, a_mirror_s_brdf_is_its_normal_s::<f32>);
}

/// Brushed lobes that narrow to a groove in f32: the BRDF over a footprint has no step on the way.
#[test]
fn the_brdf_of_a_narrowing_brushed_lobe_has_no_step() {
    let (wo, wi) = ([0.6_f32, 0.4, 0.7], [-0.6_f32, 0.0, 0.8]);
    let footprints = [
        Footprint::from_slopes([0.5_f32, 0.1], [0.0, 0.8]),
        Footprint::from_slopes([0.8_f32, 0.0], [0.0, 1.0]),
        Footprint::from_slopes([0.3_f32, -0.9], [0.7, 0.2]),
    ];
    for over in footprints {
        for angle in [0.0_f32, 0.7, 1.3, 2.5] {
            let brdf = |alpha: f32| {
                let roughness = Roughness::from_alphas(0.3, alpha, angle).expect("in range");
                Ggx::new(Anisotropic::new(roughness)).brdf_over(wo, wi, &over)
            };
            let groove = brdf(0.0);
            for alpha in DECADES.into_iter().filter(|alpha| *alpha <= 1e-5) {
                let got = brdf(alpha as f32);
                let error = (got - groove).abs();
                assert!(error <= 2e-4 * groove, "{got} for {groove}, {alpha:e}, {angle}, {over:?}");
            }
        }
    }
}

/// Along each axis the difference of two error functions, in its limit a step; the oracle is pxfm's
/// erf.
fn beckmann_tends_to_the_mirror<R: Real>(source: &mut Source) -> TestCaseResult {
    let size = |source: &mut Source| match source.pick(3) {
        0 => 0.0,
        1 => source.log_uniform(1e-30, 1e-9),
        _ => source.log_uniform(1e-9, 1.0),
    };
    let alphas = [size(source), size(source)].map(R::lit);
    let widths = [source.log_uniform(1e-3, 3.0), source.log_uniform(1e-3, 3.0)].map(R::lit);
    let parts = [source.uniform(-1.0, 1.0), source.uniform(-1.0, 1.0)];
    let slope = [0, 1].map(|k| R::lit(parts[k] * widths[k].to_f64()));
    let along = |k: usize| {
        let [alpha, slope, width] = [alphas[k], slope[k], widths[k]].map(R::to_f64);
        let [low, high] = [-0.5, 0.5].map(|half| slope + half * width);
        let step = |x: f64| if alpha > 0.0 { pxfm::f_erf(x / alpha) } else { x.signum() };
        ((step(high) - step(low)) / (2.0 * width), (step(high) - step(low)) / 2.0)
    };
    let ((x, mass_x), (y, mass_y)) = (along(0), along(1));
    let got = beckmann_rectangle_mean(alphas, slope, widths).to_f64();
    let inputs = (alphas, slope, widths);
    // The oracle's own difference cancels where little of the mass is seen.
    let oracle = 1e-15 / (widths[0].to_f64() * widths[1].to_f64());
    let seen = mass_x.min(mass_y) > 1e-6;
    let tolerance = if seen {
        10.0 * stated::<R>() * x * y
    } else {
        1e-6 * x.max(y) / widths[0].to_f64().min(widths[1].to_f64())
    };
    near(got, x * y, tolerance + oracle, &inputs)
}

#[test]
fn beckmann_s_mean_tends_to_the_mirror_s() {
    check(20_000, beckmann_tends_to_the_mirror::<f64>);
    check(20_000, beckmann_tends_to_the_mirror::<f32>);
    for alpha in DECADES.into_iter().filter(|alpha| *alpha <= 1e-5) {
        let alpha = alpha as f32;
        let mean = |x: f32| beckmann_rectangle_mean([alpha, alpha], [x, 0.0], [0.01, 0.01]);
        assert!((mean(0.004) / 1e4 - 1.0).abs() < 1e-6 && mean(0.006) == 0.0, "{alpha:e}");
        assert!((mean(0.005) / 5e3 - 1.0).abs() < 1e-6, "{alpha:e}");
    }
    assert_eq!(beckmann_rectangle_mean([0.0_f32, 0.1], [0.0, 0.0], [0.0, 0.1]), 0.0);
}

/// A footprint thinner than a groove is wide sees a part of the groove's marginal, however long the
/// footprint is.
#[test]
fn a_thin_footprint_along_a_mirror_s_axis_resolves_the_groove() {
    for (alpha, long, thin) in [(1e-6, 1e9, 1e-7), (1e-12, 300.0, 1e-13), (1e-3, 1e9, 0.01)] {
        // Mass of the marginal x/(2 sqrt(1 + x^2)) between both ends, over the area.
        let end = 0.5 * thin / alpha;
        let want = end / (1.0_f64 + end * end).sqrt() / (long * thin);
        let got = |turned: bool| {
            let (alphas, u, v) = if turned {
                ([alpha, 0.0], [0.0, long], [thin, 0.0])
            } else {
                ([0.0, alpha], [long, 0.0], [0.0, thin])
            };
            let [alphas, u, v] = [alphas, u, v].map(|pair| pair.map(|x| x as f32));
            let lobe = AxisAligned::new(alphas[0], alphas[1]).expect("in range");
            let mean = Ggx::new(lobe).parallelogram_mean([0.0; 2], &Footprint { u, v });
            f64::from(mean)
        };
        for turned in [false, true] {
            let got = got(turned);
            assert!((got / want - 1.0).abs() < 1e-5, "{alpha:e} {turned}: {got:e} for {want:e}");
        }
    }
}

/// Round lobes have no axis: a quarter turn of the view and the footprint changes nothing, down to
/// half vectors whose density is no normal number.
#[test]
fn a_quarter_turn_changes_no_round_lobe_at_low_half_vectors() {
    for slope in [1e7_f32, 1e8, 4e8, 9e8] {
        let mean = |turned: bool| {
            let turn = |[x, y]: [f32; 2]| if turned { [-y, x] } else { [x, y] };
            let [x, y] = turn([slope, 0.02]);
            let length = (x * x + y * y + 1.0).sqrt();
            let h = [-x / length, -y / length, 1.0 / length];
            let footprint = Footprint { u: turn([1e9, 0.0]), v: turn([0.0, 0.02]) };
            Ggx::new(Isotropic::new(0.01_f32).expect("in range")).brdf_over(h, h, &footprint)
        };
        let (straight, turned) = (mean(false), mean(true));
        assert!((straight - turned).abs() <= 1e-4 * straight, "{slope:e}: {straight:e} {turned:e}");
    }
}

/// Brushed lobes whose density at the half vector is a tiny normal number: the BRDF over a pixel is
/// continuous in the narrower alpha down to 0 there, too.
#[test]
fn brushed_lobes_keep_their_brdf_at_any_width() {
    let (wo, wi) = ([0.6_f32, 0.0, 0.8], [-0.6, 0.008, 0.8]);
    for (wide, pixel) in [(0.1, 0.02), (1.0, 0.02), (0.13, 0.3)] {
        let over = |narrow: f32| {
            let lobe = AxisAligned::new(wide, narrow).expect("in range");
            Ggx::new(lobe).brdf_over(wo, wi, &Footprint::rectangle([pixel, pixel]))
        };
        let want = over(0.0);
        for exponent in 60..200 {
            let narrow = 10.0_f32.powf(-0.1 * exponent as f32);
            let got = over(narrow);
            assert!((got / want - 1.0).abs() < 1e-4, "{wide} {narrow:e}: {got} for {want}");
        }
    }
}

/// The proxy over a footprint has the groove's peak, as it has any lobe's.
#[test]
fn the_proxy_of_a_groove_has_its_peak() {
    let over = Footprint::from_slopes([0.2_f64, 0.1], [-0.1, 0.3]);
    for angle in [0.0, 0.7, 2.0] {
        let groove = Roughness::from_alphas(0.3, 0.0, angle).expect("a groove");
        let mean = Ggx::new(Anisotropic::new(groove)).parallelogram_mean([0.0, 0.0], &over);
        let proxy = Anisotropic::new(groove.peak_matched_over(&over));
        let peak = Ggx::new(proxy).slope_pdf([0.0, 0.0]);
        assert!((peak / mean - 1.0).abs() < 1e-9, "{peak} for {mean}");
    }
}

/// Slopes that are fully correlated are a groove along their deviations.
#[test]
fn a_correlation_of_one_is_a_groove() {
    let over = Footprint::from_slopes([0.2_f64, 0.05], [-0.1, 0.3]);
    for (x, y, rho) in [(0.1, 0.3, 1.0), (0.2, 0.2, -1.0), (1e-6, 0.4, 1.0)] {
        let roughness = Roughness::from_sigma_rho(x, y, rho).expect("in range");
        let got = Ggx::new(Anisotropic::new(roughness)).parallelogram_mean([0.01, -0.02], &over);
        let length = f64::hypot(x, y);
        let axis = [x / length, rho * y / length];
        // A = 2 Sigma.
        let want = groove_mean(length * 2.0_f64.sqrt(), axis, [0.01, -0.02], &over);
        assert!((got / want - 1.0).abs() < 1e-9, "{got} for {want}");
    }
}

fn odd_numbers_have_a_mean<R: Real>(source: &mut Source) -> TestCaseResult {
    let odd = |source: &mut Source| {
        let x = crate::common::ODD[source.pick(17) as usize];
        R::lit(if source.pick(3) == 0 { source.uniform(-1.0, 1.0) } else { x })
    };
    let mut alpha = || {
        let all = [0.0, 1e-45, 1e-38, 1e-30, 1e-20, 1e-19, 1e-15, 1e-9, 0.3, 1e9];
        R::lit(all[source.pick(10) as usize])
    };
    let (x, y) = (alpha(), alpha());
    let numbers: [R; 6] = core::array::from_fn(|_| odd(source));
    let [s, t, a, b, c, d] = numbers;
    // Slopes end at 1e9; those that are no number are the caller's mistake.
    let slope = |x: R| if x.abs() <= R::LARGEST { x } else { R::LARGEST };
    let (s, t) = (slope(s), slope(t));
    // Sides of NaN are none of a mean's; the BRDF counts them as huge.
    let any = Footprint { u: [a, b], v: [c, d] };
    let [a, b, c, d] = [a, b, c, d].map(|x| if x.abs() <= R::MAX { x } else { R::MAX });
    let footprint = Footprint { u: [a, b], v: [c, d] };
    let pair = source.pair().map(|w| w.map(R::lit));
    let angle = R::lit(source.angle());
    let mean = source.mean().map(R::lit);
    let anisotropic = Anisotropic::new(Roughness::from_alphas(x, y, angle).expect("in range"));
    let anisotropic = NonCentered::new(anisotropic, mean).expect("a finite mean");
    let aligned = AxisAligned::new(x, y).expect("in range");
    let got = [
        Ggx::new(anisotropic).parallelogram_mean([s, t], &footprint),
        Ggx::new(aligned).parallelogram_mean([s, t], &footprint),
        Ggx::new(aligned).rectangle_mean([s, t], [a, d]),
        Ggx::new(anisotropic).brdf_over(pair[0], pair[1], &any),
        Ggx::new(aligned).brdf_over(pair[0], pair[1], &any),
        beckmann_rectangle_mean([x, y], [s, t], [a, d]),
    ];
    let whole = got.iter().all(|x| x.is_finite() && *x >= R::ZERO);
    ensure(whole, "finite and not negative", &(x, y, numbers, angle, mean, pair, got))
}

/// Numbers at the ends of ranges, none among them, never make a mean that is none.
#[test]
fn means_of_mirrors_are_numbers() {
    check(100_000, odd_numbers_have_a_mean::<f32>);
    check(100_000, odd_numbers_have_a_mean::<f64>);
}

/// Shapes say which way they are longest.
#[test]
fn the_major_axis_is_that_of_the_matrix() {
    check(10_000, |source| {
        let ellipse = source.ellipse();
        let roughness = ellipse.roughness::<f64>();
        let eigen = roughness.matrix().eigen();
        let (axis, alpha) = Anisotropic::new(roughness).major();
        // One row of A is the axis up to the minor eigenvalue.
        let aspect = (eigen.minor / eigen.major).sqrt();
        let turn = cross(axis, eigen.axis).abs();
        let inputs = (ellipse, axis, alpha);
        ensure(turn <= 2.0 * aspect + 1e-12, "near the major axis", &inputs)?;
        near(alpha, eigen.major.sqrt(), 2.0 * aspect * eigen.major.sqrt() + 1e-12, &inputs)?;
        near(axis[0].hypot(axis[1]), 1.0, 1e-15, &inputs)
    });
}
