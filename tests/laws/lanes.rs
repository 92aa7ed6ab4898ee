//! Laws of means and BRDFs over footprints without a branch: errors as percentiles over seeded
//! draws, since the largest error is not what they promise.

use crate::common::arbitrary::Source;
use crate::common::quadrature::over_square;
use crate::common::{ODD, check, ensure, size};
use core::f64::consts::PI;
use lobe::slope::direction::{normal_of, reflect};
use lobe::{Anisotropic, Footprint, Ggx, Isotropic, Lobe, NonCentered, Psd, Real, Roughness};
use proptest::test_runner::TestCaseResult;

/// Of 100 draws 99 err by less, within this many alphas: in f32, and in f64.
const BUDGETS: [(f64, f64, f64); 2] = [(3.0, 3e-3, 3.4e-4), (30.0, 2e-2, 1.1e-3)];
/// A zero footprint is the density, or the BRDF, in f32.
const POINT: f64 = 2e-5;
/// Order and signs of the sides, near the lobe: f32 and f64.
const ORDER: (f64, f64) = (1e-3, 1e-6);

fn single(v: [f64; 2]) -> [f32; 2] {
    v.map(|x| x as f32)
}

fn double(v: [f32; 2]) -> [f64; 2] {
    v.map(f64::from)
}

/// A turned roughness of alphas up to `1/2`, and its sides: a factor in f32 and in f64 alike.
fn roughness(source: &mut Source) -> (Roughness<f32>, Roughness<f64>) {
    let [x, y] = [0; 2].map(|_| source.log_uniform(0.01, 0.5));
    let psd = Roughness::from_alphas(x as f32, y as f32, source.angle() as f32);
    let narrow = psd.expect("alphas in range");
    let factor = narrow.matrix().cholesky().map(f64::from);
    let wide = Psd::from_cholesky(factor).expect("a factor");
    (narrow, Roughness::from_matrix(wide))
}

/// A center within `reach` alphas and sides of 0.01 to 100 alphas, half of them nearly parallel, as
/// slopes.
fn scene(source: &mut Source, lobe: &Roughness<f64>, reach: f64) -> [[f32; 2]; 3] {
    let [l_xx, l_yx, l_yy] = lobe.matrix().cholesky();
    let slope = |w: [f64; 2]| single([l_xx * w[0], l_yx * w[0] + l_yy * w[1]]);
    let turned = |length: f64, angle: f64| [length * angle.cos(), length * angle.sin()];
    let center = turned(reach * source.unit(), source.uniform(0.0, 2.0 * PI));
    let long = source.log_uniform(1e-2, 1e2);
    let short = source.log_uniform((long * 1e-3).max(1e-2), (long * 1e3).min(1e2));
    let angle = source.uniform(0.0, 2.0 * PI);
    let between = match source.pick(2) {
        0 => source.uniform(0.0, 2.0 * PI),
        _ => source.log_uniform(1e-3, 1.0).asin() * source.sign(),
    };
    [center, turned(long, angle), turned(short, angle + between)].map(slope)
}

#[test]
fn the_mean_errs_as_stated() {
    for (reach, limit_single, limit_double) in BUDGETS {
        let draw = |seed: u64| {
            let mut source = Source::from_seed(0x1a4e5 + seed);
            let (narrow, wide) = roughness(&mut source);
            let [slope, u, v] = scene(&mut source, &wide, reach);
            let over = Footprint { u: double(u), v: double(v) };
            let ggx = Ggx::new(Anisotropic::new(wide));
            let want = ggx.parallelogram_mean(double(slope), &over);
            let inside = ggx.parallelogram_mean_in_lanes(double(slope), &over);
            let ggx = Ggx::new(Anisotropic::new(narrow));
            let got = ggx.parallelogram_mean_in_lanes(slope, &Footprint { u, v });
            [(f64::from(got) / want - 1.0).abs(), (inside / want - 1.0).abs()]
        };
        let errors: Vec<_> = (0..u64::from(size::cases(60_000))).map(draw).collect();
        for (k, limit) in [limit_single, limit_double].into_iter().enumerate() {
            let mut errors: Vec<f64> = errors.iter().map(|both| both[k]).collect();
            errors.sort_by(f64::total_cmp);
            let (high, most) = (errors[99 * (errors.len() - 1) / 100], errors[errors.len() - 1]);
            assert!(high < limit, "{reach} alphas, {k}: {high:e}, largest {most:e}");
        }
    }
}

/// Finite and not negative, for numbers of both precisions that are odd.
fn total<R: Real>(source: &mut Source) -> TestCaseResult {
    let mut number = |far: f64| match source.pick(6) {
        0 => ODD[source.pick(ODD.len() as u64) as usize],
        1 => 0.0,
        _ => source.log_uniform(1e-12, far) * source.sign(),
    };
    let [slope, u, v] = [0; 3].map(|_| [R::lit(number(1e6)), R::lit(number(1e6))]);
    let parallel = source.pick(4) == 0;
    let v = if parallel { u.map(|x| x * R::lit(source.unit())) } else { v };
    let alphas = [0; 2].map(|_| match source.pick(6) {
        0 => 0.0,
        1 => 1e-9,
        2 => 1e9,
        _ => source.log_uniform(1e-4, 30.0),
    });
    let roughness = Roughness::from_alphas(R::lit(alphas[0]), R::lit(alphas[1]), R::lit(0.3));
    let mean = source.mean().map(R::lit);
    let [wo, wi] = source.pair().map(|w| w.map(R::lit));
    let wi = if source.pick(4) == 0 { [-wo[0], -wo[1], R::lit(source.unit() * 1e-6)] } else { wi };
    let over = Footprint { u, v };
    let shape = Anisotropic::new(roughness.expect("in range"));
    let moved = Ggx::new(NonCentered::new(shape, mean).expect("in range"));
    let round = Ggx::new(Isotropic::saturating(R::lit(alphas[0])));
    let values = [
        moved.parallelogram_mean_in_lanes(slope, &over),
        round.parallelogram_mean_in_lanes(slope, &over),
        moved.brdf_over_in_lanes(wo, wi, &over),
        round.brdf_over_in_lanes(wo, wi, &over),
        round.brdf_over_in_lanes([slope[0], slope[1], u[0]], wi, &over),
    ];
    let inputs = (alphas, mean, slope, over, wo, wi, values);
    ensure(values.iter().all(|x| x.is_finite() && *x >= R::ZERO), "finite, not negative", &inputs)
}

#[test]
fn no_number_gives_none() {
    check(100_000, total::<f32>);
    check(100_000, total::<f64>);
}

#[test]
fn a_mirror_and_a_groove_have_no_mean() {
    let over = Footprint::rectangle([0.1_f32, 0.1]);
    let up = [0.0, 0.0, 1.0];
    for alphas in [[0.0, 0.0], [0.0, 0.3], [0.3, 0.0]] {
        let ggx = Ggx::new(lobe::AxisAligned::new(alphas[0], alphas[1]).expect("in range"));
        for over in [over, Footprint::default()] {
            assert_eq!(ggx.parallelogram_mean_in_lanes([0.0, 0.0], &over), 0.0);
            assert_eq!(ggx.brdf_over_in_lanes(up, up, &over), 0.0);
        }
    }
}

#[test]
fn a_zero_footprint_is_none() {
    check(50_000, |source| {
        let (narrow, wide) = roughness(source);
        let [slope, ..] = scene(source, &wide, 30.0);
        let mean = single(source.vector(1e-2, 1.0));
        let zero = Footprint::default();
        let lobe = Lobe::new([0.0; 2], narrow).expect("centered");
        let ggx = Ggx::new(lobe.shape());
        let (got, want) = (ggx.parallelogram_mean_in_lanes(slope, &zero), ggx.slope_pdf(slope));
        let near = |got: f32, want: f32| (f64::from(got) / f64::from(want) - 1.0).abs() < POINT;
        ensure(near(got, want), "the density", &(narrow, slope, got, want))?;
        let ggx = Ggx::new(Lobe::new(mean, narrow).expect("in range").shape());
        let [wo, wi] = source.pair().map(|w| w.map(|x| x as f32));
        let got = ggx.brdf_over_in_lanes(wo, wi, &zero);
        let want = ggx.brdf(wo, wi);
        let known = got == want || near(got, want) || want < 1e-30;
        // At the very horizon the half vector's height has no digits.
        let inputs = (narrow, mean, wo, wi, got, want);
        ensure(known || wo[2] + wi[2] < 1e-6, "the BRDF", &inputs)
    });
}

#[test]
fn signs_and_order_of_the_sides_do_not_matter() {
    check(50_000, |source| {
        let (narrow, wide) = roughness(source);
        let [slope, u, v] = scene(source, &wide, 3.0);
        let minus = |v: [f32; 2]| v.map(|x| -x);
        let (ggx, exact) = (Ggx::new(Anisotropic::new(narrow)), Ggx::new(Anisotropic::new(wide)));
        let of = |u, v| {
            let over = Footprint { u: double(u), v: double(v) };
            let mean = ggx.parallelogram_mean_in_lanes(slope, &Footprint { u, v });
            [f64::from(mean), exact.parallelogram_mean_in_lanes(double(slope), &over)]
        };
        let want = of(u, v);
        for (u, v) in [(v, u), (minus(u), v), (u, minus(v)), (minus(v), u)] {
            let got = of(u, v);
            let inputs = (narrow, slope, u, v, got, want);
            let near = |k: usize, by: f64| (got[k] / want[k] - 1.0).abs() < by;
            ensure(near(0, ORDER.0) && near(1, ORDER.1), "the same mean", &inputs)?;
        }
        Ok(())
    });
}

/// The mean of P22/m_z^4 over the footprint, by quadrature, with P22 as the tests know it.
fn mean_of_d(a: [f64; 3], slope: [f64; 2], over: &Footprint<f64>) -> f64 {
    let det = a[0] * a[2] - a[1] * a[1];
    let mut d = |i: f64, j: f64| {
        let s = [0, 1].map(|k| slope[k] + i * over.u[k] + j * over.v[k]);
        let q = (a[2] * s[0] * s[0] - 2.0 * a[1] * s[0] * s[1] + a[0] * s[1] * s[1]) / det;
        let secant2 = 1.0 + s[0] * s[0] + s[1] * s[1];
        secant2 * secant2 / (PI * det.sqrt() * (1.0 + q) * (1.0 + q))
    };
    over_square(&mut d, 1e-4)
}

/// The draws of over.rs: alphas from 0.05 to 0.9, slopes and footprints up to 2.
#[test]
fn the_density_over_a_footprint_is_near_its_mean() {
    let draw = |seed: u64| {
        let mut source = Source::from_seed(0x5ec0 + seed);
        let (x, y) = (source.log_uniform(0.05, 0.9), source.log_uniform(0.05, 0.9));
        let rho = if source.pick(2) == 0 { 0.0 } else { source.uniform(-0.8, 0.8) };
        let a = [x * x, rho * x * y, y * y];
        let slope = source.vector(1e-2, 2.0);
        let over = Footprint { u: source.vector(1e-3, 2.0), v: source.vector(1e-3, 2.0) };
        let [xx, xy, yy] = a.map(|x| x as f32);
        let matrix = Psd::new(xx, xy, yy).expect("positive");
        let ggx = Ggx::new(Anisotropic::new(Roughness::from_matrix(matrix)));
        let m = normal_of(single(slope));
        // Both along the half vector: always above the surface.
        let wi = reflect(m, m);
        let narrow = Footprint { u: single(over.u), v: single(over.v) };
        let got = ggx.brdf_over_in_lanes(m, wi, &narrow) / ggx.visibility(m, wi);
        // Wider lobes have their peak beside the normal.
        let narrow = (1.0 - a[0]) * (1.0 - a[2]) >= a[1] * a[1];
        let peak = ggx.d([0.0, 0.0, 1.0]) * (1.0 + 1e-5);
        assert!(!narrow || got <= peak, "above the peak: {seed}, {got}, {peak}");
        f64::from(got) / mean_of_d(a, slope, &over)
    };
    let mut ratios: Vec<f64> = (0..u64::from(size::cases(12_000))).map(draw).collect();
    ratios.sort_by(f64::total_cmp);
    let within = ratios.iter().filter(|r| (1.0 / 1.1..=1.1).contains(*r)).count();
    let ends = [ratios[0], ratios[ratios.len() - 1]];
    assert!(100 * within >= 98 * ratios.len(), "{within} of {}, {ends:?}", ratios.len());
    assert!(ends[0] > 0.5 && ends[1] < 2.0, "{ends:?}");
}

/// Of a tilted lobe the height at the mean slope counts.
#[test]
fn a_tilted_lobe_is_near_its_mean() {
    let ggx = Ggx::new(
        NonCentered::new(Isotropic::new(0.1_f32).expect("in range"), [0.5, -0.2])
            .expect("in range"),
    );
    for (slope, width) in [([0.5, -0.2], 0.1), ([0.6, 0.0], 0.3), ([0.3, -0.1], 1.0)] {
        let m = normal_of(slope);
        let over = Footprint::from_slopes([width, 0.0], [0.3 * width, width]);
        let got = ggx.brdf_over_in_lanes(m, m, &over);
        let mut d = |i: f64, j: f64| {
            let s = [0, 1]
                .map(|k| f64::from(slope[k]) + i * f64::from(over.u[k]) + j * f64::from(over.v[k]));
            let q = ((s[0] - 0.5).powi(2) + (s[1] + 0.2).powi(2)) / 0.01;
            (1.0 + s[0] * s[0] + s[1] * s[1]).powi(2) / (PI * 0.01 * (1.0 + q).powi(2))
        };
        let mean = over_square(&mut d, 1e-6) * f64::from(ggx.visibility(m, m));
        assert!((f64::from(got) / mean - 1.0).abs() < 0.1, "{got} for {mean}");
    }
}
