//! Laws of the BRDF over a footprint: its D is the pixel's mean of D, not the slope density's mean
//! over h_z^4.

use crate::common::arbitrary::Source;
use crate::common::quadrature::over_square;
use crate::common::{check, ensure};
use core::f64::consts::PI;
use lobe::slope::Whiten;
use lobe::slope::direction::{normal_of, reflect};
use lobe::{Anisotropic, AxisAligned, Footprint, Ggx, Isotropic, Psd, Roughness};
use proptest::test_runner::TestCaseResult;

/// D as [`lobe::Ndf::brdf_over`] has it: both directions mirrored at the half vector's normal,
/// visibility divided out.
fn shaded<S: Whiten<Scalar = f64>>(ggx: &Ggx<S>, slope: [f64; 2], over: &Footprint<f64>) -> f64 {
    let m = normal_of(slope);
    // Both along the half vector: always above the surface.
    let wo = m;
    let wi = reflect(wo, m);
    ggx.brdf_over(wo, wi, over) / ggx.visibility(wo, wi)
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
    over_square(&mut d, 1e-6)
}

/// Isotropic: from the mean itself to twice as much, never above the peak.
fn bounds_the_mean(source: &mut Source) -> TestCaseResult {
    let alpha = source.log_uniform(0.02, 0.9);
    let slope = source.vector(1e-2, 30.0);
    let over = Footprint { u: source.vector(1e-3, 30.0), v: source.vector(1e-3, 30.0) };
    let ggx = Ggx::new(Isotropic::new(alpha).expect("in range"));
    let (got, a) = (shaded(&ggx, slope, &over), alpha * alpha);
    let want = mean_of_d([a, 0.0, a], slope, &over);
    let inputs = (alpha, slope, over, got, want);
    ensure(got >= want * 0.999_99, "no less than the mean", &inputs)?;
    ensure(got <= want * 2.0, "no more than twice the mean", &inputs)?;
    ensure(got <= ggx.d([0.0, 0.0, 1.0]) * (1.0 + 1e-12), "no more than the peak", &inputs)
}

#[test]
fn an_isotropic_lobe_s_density_over_a_footprint_bounds_its_mean() {
    check(400, bounds_the_mean);
}

/// Got over mean for random centered lobes, slopes and footprints up to a limit, in increasing
/// order.
fn ratios(limit: f64, count: u64) -> Vec<f64> {
    let mut ratios: Vec<f64> = (0..count)
        .map(|seed| {
            let mut source = Source::from_seed(0x5ec0 + seed);
            let (x, y) = (source.log_uniform(0.05, 0.9), source.log_uniform(0.05, 0.9));
            let rho = if source.pick(2) == 0 { 0.0 } else { source.uniform(-0.8, 0.8) };
            let a = [x * x, rho * x * y, y * y];
            let slope = source.vector(1e-2, limit);
            let sides = [0; 2].map(|_| source.vector(1e-3, limit));
            let over = Footprint { u: sides[0], v: sides[1] };
            let matrix = Psd::new(a[0], a[1], a[2]).expect("positive");
            let ggx = Ggx::new(Anisotropic::new(Roughness::from_matrix(matrix)));
            shaded(&ggx, slope, &over) / mean_of_d(a, slope, &over)
        })
        .collect();
    ratios.sort_by(f64::total_cmp);
    ratios
}

/// Any lobe: an estimate with the errors that the documentation states.
#[test]
fn any_lobe_s_density_over_a_footprint_is_near_its_mean() {
    for (limit, near, part, range) in [(2.0, 1.1, 98, 0.5..2.0), (30.0, 1.5, 96, 0.03..4.0)] {
        let ratios = ratios(limit, 15_000);
        let within =
            |factor: f64| ratios.iter().filter(|r| (1.0 / factor..=factor).contains(*r)).count();
        let ends = [ratios[0], ratios[ratios.len() - 1]];
        assert!(100 * within(near) >= part * ratios.len(), "{limit}: {} {ends:?}", within(near));
        assert!(ends.iter().all(|end| range.contains(end)), "{limit}: {ends:?}");
    }
}

/// A brushed lobe's streak: the mean comes from beside the half vector, not from the lobe's center.
#[test]
fn a_streak_keeps_its_brightness_along_itself() {
    let ggx = Ggx::new(AxisAligned::new(0.01, 0.5).expect("in range"));
    let over = Footprint { u: [0.22, 0.0], v: [0.0, 0.05] };
    for y in [0.25, 0.5, 1.0, 2.0, 4.0] {
        let slope = [0.1, y];
        let ratio = shaded(&ggx, slope, &over) / mean_of_d([1e-4, 0.0, 0.25], slope, &over);
        assert!((ratio - 1.0).abs() < 0.02, "{y}: {ratio}");
    }
}

/// A pixel near the silhouette: the half vector at the horizon, its footprint over the whole lobe.
/// Kaplanyan's factor makes a firefly of it.
#[test]
fn a_half_vector_near_the_horizon_is_no_firefly() {
    let ggx = Ggx::new(Isotropic::new(0.01_f32).expect("in range"));
    for steep in [10.0_f32, 1e2, 1e4, 1e6] {
        let over = Footprint { u: [2.5 * steep, 0.0], v: [0.3, 1.0] };
        let normal = normal_of([steep, 0.1]);
        let visible = ggx.visibility(normal, normal);
        let got = ggx.brdf_over(normal, normal, &over) / visible;
        let mean = ggx.parallelogram_mean([steep, 0.1], &over);
        let kaplanyan = mean / normal[2].powi(4);
        // The lobe's mass and the tail, whose D is alpha^2/pi.
        let seen = mean + 1e-4 / core::f32::consts::PI;
        assert!(got <= 2.0 * seen && got > 0.9 * seen, "{steep}: {got:e}, not {seen:e}");
        assert!(kaplanyan > 5e3 * seen, "{steep}: {kaplanyan:e}");
    }
}
