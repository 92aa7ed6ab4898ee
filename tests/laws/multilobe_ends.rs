//! Many lobes at the ends of what numbers hold: mirrors under kernels, the horizon, small texels,
//! and no numbers.
#![cfg(feature = "glint")]

use crate::common::arbitrary::Source;
use crate::common::facets::{dictionary, surface};
use crate::common::quadrature::midpoints;
use lobe::material::cells::Patch;
use lobe::material::multilobe::{Dictionary, MultiLobe, Recipe};
use lobe::{Kernel, Psd, Real, Roughness};

/// Lobes without width along one axis or any, under kernels of all sizes, in f32 as in f64: a mass
/// of 1, and the kernel's own covariance where the lobe is nothing against it.
fn mirrors_are_what_kernels_make_of_them<R: Real>() {
    let recipe = Recipe { levels: 6, width: 0.3, ..Recipe::default() };
    let dictionary = Dictionary::<R>::new(&recipe).expect("valid");
    for [x, y, rho] in [[0.1, 0.0, 0.0], [0.1, 0.1, 1.0], [0.0, 0.0, 0.0], [1e-7, 0.1, 0.3]] {
        let [a, b, c] = [x, y, rho].map(R::lit);
        let mirror = Roughness::from_sigma_rho(a, b, c).expect("in range");
        for deviation in [0.1, 5.0, 1000.0] {
            let variance = R::lit(deviation * deviation);
            let kernel =
                Kernel::from_covariance(Psd::new(variance, R::ZERO, variance).expect("valid"));
            let facets = MultiLobe::new(mirror, R::ONE).expect("in range");
            let facets = facets.with_variation(R::ZERO).expect("in range");
            let pixel = facets.ndf(&dictionary, &Patch::default()).widened(&kernel);
            // Midpoints of a parallelogram, whose corners are up to sqrt(6) deviations out, and
            // some of the lobe beside it.
            let (reach, nodes) = (2.5 * deviation + 0.6, 300);
            let mass = midpoints(reach, nodes, |slope| pixel.slope_pdf(slope.map(R::lit)).to_f64());
            // Sharp sides of a box of 3.5 deviations, of which midpoints miss half a step each.
            let edge = 2.0 * (2.0 * reach / f64::from(nodes)) / (3.4 * deviation);
            assert!((mass - 1.0).abs() < edge, "{x} {y} {rho}, kernel {deviation}: {mass}");
            let (mut second, count) = ([0.0; 2], 4000);
            for k in 0..count {
                let mut source = Source::from_seed(k);
                let place = [R::lit(0.37 * k as f64), R::ZERO];
                let patch = Patch::new(place, [R::ONE, R::ZERO], [R::ZERO, R::ONE]);
                let pixel = facets.ndf(&dictionary, &patch).widened(&kernel);
                let drawn = pixel.sample_slope([0.0; 7].map(|_| R::lit(source.uniform(0.0, 1.0))));
                for (sum, slope) in second.iter_mut().zip(drawn) {
                    *sum += slope.to_f64().powi(2) / count as f64;
                }
                // What is drawn has a density.
                assert!(
                    pixel.slope_pdf(drawn) > R::ZERO,
                    "{x} {y} {rho}, kernel {deviation}: {drawn:?}"
                );
            }
            for (got, own) in second.into_iter().zip([x, y]) {
                let want = deviation * deviation + own * own;
                assert!((got / want - 1.0).abs() < 0.1, "{x} {y} {rho}, kernel {deviation}: {got}");
            }
        }
    }
}

#[test]
fn mirrors_under_kernels_in_single_precision() {
    mirrors_are_what_kernels_make_of_them::<f32>();
}

#[test]
fn mirrors_under_kernels_in_double_precision() {
    mirrors_are_what_kernels_make_of_them::<f64>();
}

/// At the horizon, where half vectors have no slope that f32 holds, there is nothing.
#[test]
fn the_horizon_is_dark() {
    let dictionary =
        Dictionary::<f32>::new(&Recipe { levels: 6, ..Recipe::default() }).expect("valid");
    for alpha in [0.0, 0.3] {
        let roughness = Roughness::from_alpha(alpha).expect("in range");
        let facets = MultiLobe::new(roughness, 100.0).expect("in range");
        let pixel = facets.ndf(&dictionary, &Patch::default());
        for height in [1e-6_f32, 1e-11, 1e-12, 6.1e-17, 1e-20, 1e-38] {
            assert_eq!(pixel.d([1.0, 0.0, height]), 0.0, "{alpha} {height}");
            for (wo, wi) in [
                ([1.0, 0.0, height], [0.0, 1.0, height]),
                ([0.0, 1.0, height], [0.0, -1.0, height]),
            ] {
                let value = pixel.brdf(wo, wi);
                // Opposite views have a half vector at the pole.
                let pole = wo[1] == 1.0 && alpha > 0.0;
                assert!(value == 0.0 || pole && value.is_finite(), "{alpha} {height}: {value}");
                assert!(pixel.pdf(wo, wi) < f32::MAX, "{alpha} {height}");
            }
        }
    }
}

/// Small texels are texels: in f32 a pixel is that of f64 at any scale of its texture, as long as
/// it may be.
#[test]
fn the_scale_of_a_texture_is_no_matter() {
    let single = Dictionary::<f32>::new(&Recipe::default()).expect("valid");
    for power in [-47, -43, -20, 20] {
        let size = 2.0_f64.powi(power);
        let facets = surface(30.0 / (size * size), 5);
        let alike = facets.roughness().covariance().entries().map(|x| x as f32);
        let alike = Roughness::from_covariance(Psd::nearest(alike[0], alike[1], alike[2]));
        let alike = MultiLobe::new(alike, (30.0 / (size * size)) as f32).expect("in range");
        let mut far = 0;
        for k in 0..400_u16 {
            // All of them whole eighths of a cell.
            let uv = [0.375 * size * f64::from(k), 0.25 * size];
            let long = if k % 2 == 0 { 1.25 } else { 20.0 };
            let (right, up) = ([long * size, 0.125 * size], [0.0, size]);
            let want = facets.ndf(dictionary(), &Patch::new(uv, right, up)).slope_pdf([0.1, 0.05]);
            let [uv, right, up] = [uv, right, up].map(|v| v.map(|x| x as f32));
            let pixel = alike.with_seed(5).ndf(&single, &Patch::new(uv, right, up));
            let got = f64::from(pixel.slope_pdf([0.1, 0.05]));
            far += u32::from((got - want).abs() > 1e-3 * (want + 0.1));
        }
        println!("size 2^{power}: {far} of 400 differ");
        // Of up to 200 cells each one in 30,000 draws another level.
        assert!(far <= 8, "size 2^{power}: {far} of 400 differ");
    }
}

/// NaN counts as 0, in coordinates as in derivatives.
#[test]
fn no_number_counts_as_0() {
    let nan = f64::NAN;
    let at = |uv, right, up| {
        surface(3.0, 1).ndf(dictionary(), &Patch::new(uv, right, up)).slope_pdf([0.1, 0.05])
    };
    let want = at([0.0, 0.4], [1.0, 0.0], [0.0, 2.0]);
    assert_eq!(at([nan, 0.4], [1.0, 0.0], [0.0, 2.0]), want);
    assert_eq!(at([0.0, 0.4], [1.0, nan], [nan, 2.0]), want);
}
