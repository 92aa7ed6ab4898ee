//! f32 agrees with f64 on inputs that are exactly f32, within budgets, over the whole domain.
//!
//! The budgets are requirements: a few roundings for GGX; for Beckmann, roundings times the
//! exponent.

use crate::common::arbitrary::{LobeInput, Source};
use crate::common::reference::Known;
use crate::common::{ULP_SINGLE, check, ensure, near};
use lobe::filter::beckmann_rectangle_mean;
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::slope::{Compensated, Whiten};
use lobe::{Footprint, Ggx, Lobe, LobeShape, Ndf, Psd, Real, Roughness};
use proptest::test_runner::TestCaseResult;

/// P22, D, projected area and BRDF, relative.
const GGX_BUDGET: f64 = 3e-5;
const BECKMANN_BUDGET: f64 = 2e-4;
/// Lambda, relative.
const LAMBDA_BUDGET: f64 = 1e-2;
/// Means over polygons within ten alphas of the lobe's center, and anywhere.
const NEAR_BUDGET: f64 = 1e-5;
const FAR_BUDGET: f64 = 1e-3;

/// Beckmann's exponent where f32 begins to lose its normal numbers, less the factors around it.
const LARGEST_EXPONENT: f64 = 80.0;

fn budget<D: Known>() -> f64 {
    if D::NAME == "GGX" { GGX_BUDGET } else { BECKMANN_BUDGET }
}

/// The same lobe in both precisions, from a factor that is exactly f32.
fn both(input: &LobeInput) -> (Lobe<f32>, Lobe<f64>) {
    let [xx, xy, yy] = input.ellipse.entries_single();
    let mean = input.mean.map(|x| x as f32);
    let single = Psd::new(xx, xy, yy).expect("an ellipse");
    let double = Psd::from_cholesky(single.cholesky().map(f64::from)).expect("a factor");
    (
        Lobe::new(mean, Roughness::from_matrix(single)).expect("a finite mean"),
        Lobe::new(mean.map(f64::from), Roughness::from_matrix(double)).expect("a finite mean"),
    )
}

/// The compensated shape in both precisions, from entries that are exactly f32.
fn exact(input: &LobeInput) -> (Compensated<f32>, Compensated<f64>) {
    let entries = input.ellipse.entries_single();
    let mean = input.mean.map(|x| x as f32);
    (
        Compensated::new(mean, entries).expect("an ellipse and a mean"),
        Compensated::new(mean.map(f64::from), entries.map(f64::from)).expect("the same"),
    )
}

/// Finite, not negative, and right to `relative`, as far as f32 has normal numbers.
fn agrees(got: f32, want: f64, relative: f64, inputs: &dyn core::fmt::Debug) -> TestCaseResult {
    ensure(got.is_finite() && got >= 0.0, "finite and not negative", &(inputs, got))?;
    if want > f64::from(f32::MAX) * (1.0 - relative) {
        return Ok(());
    }
    near(f64::from(got), want, relative * want + f64::from(f32::MIN_POSITIVE), inputs)
}

/// q = (s - mu)^T A^-1 (s - mu) of the direction m, in f64.
fn exponent(shape: &impl LobeShape<Scalar = f64>, m: [f64; 3]) -> f64 {
    shape.form(m) / (shape.extent().unit * m[2] * m[2])
}

/// Whether f32 has normal numbers for exp(-q): always for GGX.
fn has_digits<D: Known>(exponent: f64) -> bool {
    D::NAME == "GGX" || exponent < LARGEST_EXPONENT
}

/// A light in the mirror direction about a normal of the lobe.
fn mirrored(source: &mut Source, input: &LobeInput, wo: [f64; 3]) -> [f64; 3] {
    let slope = source.slope_near(input);
    let m = [-slope[0], -slope[1], 1.0];
    let twice = 2.0 * (wo[0] * m[0] + wo[1] * m[1] + wo[2]) / (m[0] * m[0] + m[1] * m[1] + 1.0);
    [0, 1, 2].map(|k| twice * m[k] - wo[k])
}

/// Slopes and normals near the lobe and anywhere, exactly f32.
fn places(source: &mut Source, input: &LobeInput) -> ([[f32; 2]; 2], [[f32; 3]; 2]) {
    let (close, far) = (source.slope_near(input), source.slope());
    let z = 1.0 / (1.0 + close[0] * close[0] + close[1] * close[1]).sqrt();
    let normal = [-close[0] * z, -close[1] * z, z];
    let normals = [normal, source.direction()].map(|m| m.map(|x| x as f32));
    ([close, far].map(|s| s.map(|x| x as f32)), normals)
}

fn densities<D: Known>(source: &mut Source) -> TestCaseResult {
    let input = source.lobe();
    let (single, double) = exact(&input);
    let (narrow, wide) = (Ndf::<D, _>::new(single), Ndf::<D, _>::new(double));
    let (slopes, normals) = places(source, &input);
    for slope in slopes {
        let inputs = (D::NAME, single, slope);
        let m = [-slope[0], -slope[1], 1.0];
        let got = narrow.slope_pdf(slope);
        ensure(got.is_finite() && got >= 0.0, "finite and not negative", &(inputs, got))?;
        if has_digits::<D>(exponent(&double, m.map(f64::from))) {
            agrees(got, wide.slope_pdf(slope.map(f64::from)), budget::<D>(), &inputs)?;
        }
    }
    for m in normals {
        let inputs = (D::NAME, single, m);
        let got = narrow.d(m);
        ensure(got.is_finite() && got >= 0.0, "finite and not negative", &(inputs, got))?;
        let exact = m.map(f64::from);
        if has_digits::<D>(exponent(&double, exact)) {
            agrees(got, wide.d(exact), budget::<D>(), &inputs)?;
        }
    }
    Ok(())
}

#[test]
fn densities_of_exact_entries_agree() {
    check(100_000, densities::<GgxDistribution>);
    check(100_000, densities::<BeckmannDistribution>);
}

fn areas<D: Known>(source: &mut Source) -> TestCaseResult {
    let input = source.lobe();
    let (single, double) = exact(&input);
    let (narrow, wide) = (Ndf::<D, _>::new(single), Ndf::<D, _>::new(double));
    let up = source.direction().map(|x| x as f32);
    for w in [up, up.map(|x| -x)] {
        let exact = w.map(f64::from);
        let inputs = (D::NAME, single, w);
        let (c, a2) = (wide.shape().mean_area(exact), wide.shape().stretch_squared(exact));
        let got = [narrow.projected_area(w), narrow.lambda(w), narrow.g1(w)];
        let whole = got.iter().all(|x| x.is_finite() && *x >= 0.0);
        ensure(whole, "finite and not negative", &(inputs, got))?;
        let deep = c * c / a2;
        if has_digits::<D>(deep) || c > 0.0 {
            agrees(got[0], wide.projected_area(exact), budget::<D>(), &inputs)?;
        }
        if has_digits::<D>(deep) {
            agrees(got[1], wide.lambda(exact), LAMBDA_BUDGET, &inputs)?;
        }
        agrees(got[2], wide.g1(exact), budget::<D>(), &inputs)?;
    }
    Ok(())
}

#[test]
fn areas_and_masking_of_exact_entries_agree() {
    check(100_000, areas::<GgxDistribution>);
    check(100_000, areas::<BeckmannDistribution>);
}

fn brdfs<D: Known>(source: &mut Source) -> TestCaseResult {
    let input = source.lobe();
    let (single, double) = exact(&input);
    let (narrow, wide) = (Ndf::<D, _>::new(single), Ndf::<D, _>::new(double));
    let [wo, wi] = source.pair();
    let lights = [wi, mirrored(source, &input, wo)];
    let wo = wo.map(|x| x as f32);
    for wi in lights.map(|w| w.map(|x| x as f32)) {
        let inputs = (D::NAME, single, wo, wi);
        let got = narrow.brdf(wo, wi);
        ensure(got.is_finite() && got >= 0.0, "finite and not negative", &(inputs, got))?;
        let [o, i] = [wo, wi].map(|w| w.map(f64::from));
        let half = [0, 1, 2].map(|k| o[k] + i[k]);
        if half[2] <= 0.0 || has_digits::<D>(exponent(&double, half)) {
            agrees(got, wide.brdf(o, i), budget::<D>(), &inputs)?;
        }
    }
    Ok(())
}

#[test]
fn brdfs_of_exact_entries_agree() {
    check(100_000, brdfs::<GgxDistribution>);
    check(100_000, brdfs::<BeckmannDistribution>);
}

/// Distance in alphas of the lobe's center from the footprint laid around `slope`; 0 inside.
fn gap(lobe: &Lobe<f64>, slope: [f64; 2], footprint: &Footprint<f64>) -> f64 {
    let shape = lobe.shape();
    let offset = [slope[0] - lobe.mean()[0], slope[1] - lobe.mean()[1]];
    let [center, u, v] = [offset, footprint.u, footprint.v].map(|w| shape.whiten(w, [0.0; 2]));
    let cross = |a: [f64; 2], b: [f64; 2]| a[0] * b[1] - a[1] * b[0];
    // Center + i u + j v = 0.
    let area = cross(u, v);
    let (i, j) = (-cross(center, v) / area, -cross(u, center) / area);
    if i.abs() <= 0.5 && j.abs() <= 0.5 {
        return 0.0;
    }
    let to_edge = |along: [f64; 2], across: [f64; 2], side: f64| {
        let middle = [center[0] + side * across[0], center[1] + side * across[1]];
        let square = along[0] * along[0] + along[1] * along[1];
        let toward = -(middle[0] * along[0] + middle[1] * along[1]) / square.max(f64::MIN_POSITIVE);
        let t = toward.clamp(-0.5, 0.5);
        (middle[0] + t * along[0]).hypot(middle[1] + t * along[1])
    };
    let edges = [to_edge(u, v, -0.5), to_edge(u, v, 0.5), to_edge(v, u, -0.5), to_edge(v, u, 0.5)];
    edges.into_iter().fold(f64::INFINITY, f64::min)
}

/// The f32 mean over a parallelogram near the lobe, or else anywhere.
fn parallelogram_agrees(source: &mut Source, near_the_lobe: bool) -> TestCaseResult {
    let input = source.lobe();
    let (single, double) = both(&input);
    let footprint = source.footprint();
    let slope = match source.pick(3) {
        0 => source.slope(),
        1 => {
            let f = [source.uniform(-1.0, 1.0), source.uniform(-1.0, 1.0)];
            [0, 1].map(|k| input.mean[k] + f[0] * footprint.u[k] + f[1] * footprint.v[k])
        }
        _ => source.slope_near(&input),
    };
    let slope = slope.map(|x| x as f32);
    let narrow = Footprint { u: footprint.u.map(|x| x as f32), v: footprint.v.map(|x| x as f32) };
    let wide = Footprint { u: narrow.u.map(f64::from), v: narrow.v.map(f64::from) };
    let exact = slope.map(f64::from);
    let relative = match (near_the_lobe, gap(&double, exact, &wide) <= 10.0) {
        (true, true) => NEAR_BUDGET,
        (true, false) => return Ok(()),
        (false, _) => FAR_BUDGET,
    };
    let want = Ggx::new(double.shape()).parallelogram_mean(exact, &wide);
    let got = Ggx::new(single.shape()).parallelogram_mean(slope, &narrow);
    agrees(got, want, relative, &(single, slope, narrow))
}

#[test]
fn means_over_parallelograms_near_the_lobe_agree() {
    check(200_000, |source| parallelogram_agrees(source, true));
}

#[test]
fn means_over_parallelograms_anywhere_agree() {
    check(200_000, |source| parallelogram_agrees(source, false));
}

#[test]
fn means_over_rectangles_agree() {
    check(200_000, |source| {
        let alphas = [source.alpha(), source.alpha()].map(|x| x as f32);
        let widths =
            [source.log_uniform(1e-5, 1e2), source.log_uniform(1e-5, 1e2)].map(|x| x as f32);
        let w = source.vector(1e-3, 1e3);
        let slope = [0, 1].map(|k| (w[k] * f64::from(alphas[k])) as f32);
        let wide = |x: [f32; 2]| x.map(f64::from);
        let inputs = (alphas, slope, widths);
        let ggx = Ggx::new(lobe::AxisAligned::new(alphas[0], alphas[1]).expect("alphas > 0"));
        let [x, y] = wide(alphas);
        let exact = Ggx::new(lobe::AxisAligned::new(x, y).expect("alphas > 0"));
        let outside = |k: usize| {
            let reach = f64::from(slope[k]).abs() - 0.5 * f64::from(widths[k]);
            reach.max(0.0) / f64::from(alphas[k])
        };
        let close = outside(0).hypot(outside(1)) <= 10.0;
        let relative = if close { NEAR_BUDGET } else { FAR_BUDGET };
        let want = exact.rectangle_mean(wide(slope), wide(widths));
        agrees(ggx.rectangle_mean(slope, widths), want, relative, &inputs)?;
        let got = beckmann_rectangle_mean(alphas, slope, widths);
        ensure(got.is_finite() && got >= 0.0, "finite and not negative", &(inputs, got))?;
        // The nearest point of the rectangle decides the exponent.
        let gap = [0, 1].map(|k| {
            let gap = f64::from(slope[k]).abs() - 0.5 * f64::from(widths[k]);
            gap.max(0.0) / f64::from(alphas[k])
        });
        let exponent = gap[0] * gap[0] + gap[1] * gap[1];
        if exponent < 0.5 * LARGEST_EXPONENT {
            let want = beckmann_rectangle_mean(wide(alphas), wide(slope), wide(widths));
            let relative = if exponent < 9.0 { NEAR_BUDGET } else { FAR_BUDGET };
            agrees(got, want, relative, &inputs)?;
        }
        Ok(())
    });
}

/// The Gaussian mean: documented below 1e-5 in f32.
#[test]
fn means_under_gaussians_agree() {
    check(10_000, |source| {
        let input = source.lobe();
        let (single, double) = both(&input);
        let [u, v] = source.kernel().map(|v| v.map(|x| x as f32));
        let slope = source.slope_near(&input).map(|x| x as f32);
        let narrow = lobe::Kernel::from_covariance(Psd::outer_sum(u, v));
        let wide = Psd::outer_sum(u.map(f64::from), v.map(f64::from));
        let wide = lobe::Kernel::from_covariance(wide);
        let got = lobe::filter::ggx_gaussian_mean(&single, slope, &narrow);
        let want = lobe::filter::ggx_gaussian_mean(&double, slope.map(f64::from), &wide);
        let trace = wide.covariance().trace();
        let parallel = wide.covariance().det() < 1e-12 * trace * trace;
        // A kernel of rank one has rounded entries: they tilt it.
        let relative = if parallel { FAR_BUDGET } else { NEAR_BUDGET };
        agrees(got, want, relative, &(single, slope, u, v))
    });
}

/// Reals of both precisions are the same numbers.
#[test]
fn literals_round_trip() {
    check(4000, |source| {
        let x = source.alpha() as f32;
        ensure(f32::lit(x.to_f64()) == x, "f32 is exact in f64", &x)
    });
}

/// Of the BRDF over a footprint within ten alphas of the lobe: the mean's error, and that of the
/// normals' height.
const OVER_BUDGET: f64 = 1e-4;

/// The BRDF over a footprint, which takes its slope from the directions: a tilted narrow lobe shows
/// whether their sum and its quotient keep their digits.
fn brdf_over_agrees(source: &mut Source) -> TestCaseResult {
    let input = source.lobe();
    let (single, double) = both(&input);
    let footprint = source.footprint();
    let narrow = Footprint { u: footprint.u.map(|x| x as f32), v: footprint.v.map(|x| x as f32) };
    let wide = Footprint { u: narrow.u.map(f64::from), v: narrow.v.map(f64::from) };
    let slope = source.slope_near(&input);
    let m = [-slope[0], -slope[1], 1.0];
    let [wo, _] = source.pair();
    let twice = 2.0 * (wo[0] * m[0] + wo[1] * m[1] + wo[2]) / (m[0] * m[0] + m[1] * m[1] + 1.0);
    let wi = [0, 1, 2].map(|k| (twice * m[k] - wo[k]) as f32);
    let wo = wo.map(|x| x as f32);
    let inputs = (single, wo, wi, narrow);
    let (ggx, exact) = (Ggx::new(single.shape()), Ggx::new(double.shape()));
    let (o, i) = (wo.map(f64::from), wi.map(f64::from));
    let got = ggx.brdf_over(wo, wi, &narrow);
    let half = [o[0] + i[0], o[1] + i[1], o[2] + i[2]];
    let close =
        half[2] > 1e-3 && gap(&double, [-half[0] / half[2], -half[1] / half[2]], &wide) <= 10.0;
    let relative = if close { OVER_BUDGET } else { FAR_BUDGET };
    // The height of the normals comes from 1 - sqrt(M), to 32 roundings, twice, which rough lobes
    // multiply by alpha^2.
    let rough = 64.0 * ULP_SINGLE * double.roughness().matrix().trace();
    agrees(got, exact.brdf_over(o, i, &wide), relative + rough, &inputs)?;
    // A footprint without extent is no footprint.
    let point = Footprint::rectangle([0.0, 0.0]);
    agrees(ggx.brdf_over(wo, wi, &point), exact.brdf(o, i), GGX_BUDGET + rough, &inputs)
}

#[test]
fn brdfs_over_footprints_agree() {
    check(100_000, brdf_over_agrees);
}

/// What a breaker found: grazing half vectors and numbers that are none never make a firefly.
#[test]
fn brdfs_over_footprints_make_no_fireflies() {
    let ggx = Ggx::new(lobe::Isotropic::new(0.01_f32).expect("an alpha"));
    let point = Footprint::rectangle([0.0, 0.0]);
    for e in [1e-12, 1e-10, 3e-10, 1e-9, 1e-8, 1e-3] {
        let (wo, wi) = ([1.0, 0.0, e], [0.0, 1.0, e]);
        let (got, want) = (ggx.brdf_over(wo, wi, &point), ggx.brdf(wo, wi));
        assert!((got / want - 1.0).abs() < 1e-5, "{got} for {want} at {e}");
    }
    let bad = Footprint::from_slopes([f32::NAN, 0.0], [0.0, 0.0]);
    assert_eq!(ggx.brdf_over([0.0, 0.0, 1.0], [0.6, 0.0, 0.8], &bad), 0.0);
}

/// Footprints of grazing half vectors have no bound: the mean stays one over the area, to 1e9 per
/// side.
#[test]
fn means_over_huge_footprints_are_one_over_their_area() {
    let ggx = Ggx::new(lobe::Isotropic::new(0.1_f32).expect("an alpha"));
    for (width, area) in
        [(1e6, 1e12), (3e8, 9e16), (1e9, 1e18), (1e19, 1e18), (f32::INFINITY, 1e18)]
    {
        let got = ggx.rectangle_mean([0.0, 0.0], [width, width]);
        assert!((got * area - 1.0).abs() < 1e-5, "{got} for one over {area}, width {width}");
    }
}
