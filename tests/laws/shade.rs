//! The facade and its Fresnel terms: what they promise, against complex arithmetic and the parts
//! they are made of.

use crate::common::arbitrary::Source;
use crate::common::{check, ensure, near};
use lobe::material::Fresnel;
use lobe::shade::{Material, bake_all, evaluate_all};
use lobe::{Distribution, Error, Ggx, Kernel, Lobe, LobeShape, Psd, Real, Roughness};
use nalgebra::Complex;

/// The Fresnel term by complex refraction, as textbooks have it.
fn complex_reflectance(eta: f64, k: f64, cos: f64) -> f64 {
    let index = Complex::new(eta, k);
    let refracted = (index * index - (1.0 - cos * cos)).sqrt();
    let s = (Complex::from(cos) - refracted) / (Complex::from(cos) + refracted);
    let squared = index * index * cos;
    let p = (squared - refracted) / (squared + refracted);
    0.5 * (s.norm_sqr() + p.norm_sqr())
}

/// An index of refraction and a cosine, dielectrics and grazing angles included.
fn interface(source: &mut Source) -> (f64, f64, f64) {
    let eta = source.log_uniform(0.05, 10.0);
    let k = if source.pick(3) == 0 { 0.0 } else { source.log_uniform(1e-3, 10.0) };
    (eta, k, source.direction()[2])
}

#[test]
fn conductors_agree_with_complex_refraction() {
    check(20_000, |source| {
        let (eta, k, cos) = interface(source);
        let got = Fresnel::conductor([eta; 3], [k; 3]).expect("an index").reflectance(cos)[1];
        near(got, complex_reflectance(eta, k, cos), 1e-12, &(eta, k, cos))?;
        let [eta, k, cos] = [eta, k, cos].map(|x| x as f32);
        let got = Fresnel::conductor([eta; 3], [k; 3]).expect("an index").reflectance(cos)[2];
        ensure((0.0..=1.0).contains(&got), "in [0, 1]", &(eta, k, cos, got))?;
        let want = complex_reflectance(eta.into(), k.into(), cos.into());
        near(got.into(), want, 1e-5, &(eta, k, cos))
    });
}

#[test]
fn interfaces_have_their_known_angles() {
    check(2_000, |source| {
        let (eta, k, _) = interface(source);
        let fresnel = Fresnel::conductor([eta; 3], [k; 3]).expect("an index");
        let normal = ((eta - 1.0).powi(2) + k * k) / ((eta + 1.0).powi(2) + k * k);
        near(fresnel.reflectance(1.0)[0], normal, 1e-14, &(eta, k))?;
        near(fresnel.reflectance(0.0)[0], 1.0, 1e-14, &(eta, k))?;
        // At Brewster's angle a dielectric reflects s alone.
        let glass = Fresnel::conductor([eta; 3], [0.0; 3]).expect("an index");
        let s = ((1.0 - eta * eta) / (1.0 + eta * eta)).powi(2);
        near(glass.reflectance((1.0 / (1.0 + eta * eta)).sqrt())[0], 0.5 * s, 1e-13, &eta)
    });
    // Index 1 is no interface, at any angle but the last.
    let nothing = Fresnel::conductor([1.0_f32; 3], [0.0; 3]).expect("an index");
    assert!(nothing.reflectance(0.3)[0] < 1e-12 && nothing.reflectance(0.0)[0].is_finite());
    // From inside, beyond the critical angle, everything is reflected.
    let inside = Fresnel::conductor([1.0 / 1.5_f64; 3], [0.0; 3]).expect("an index");
    assert!((inside.reflectance(0.5)[0] - 1.0).abs() < 1e-14);
}

#[test]
fn schlick_runs_from_its_normal_reflectance_to_one() {
    check(2_000, |source| {
        let normal = [source.unit(), source.unit(), source.unit()];
        let fresnel = Fresnel::schlick(normal).expect("reflectances");
        let (a, b) = (source.unit(), source.unit());
        let (low, high) = (a.min(b), a.max(b));
        let (grazing, steep) = (fresnel.reflectance(low), fresnel.reflectance(high));
        let falls = (0..3).all(|n| grazing[n] >= steep[n] - 1e-15 && steep[n] >= normal[n]);
        ensure(falls, "falls with the cosine", &(normal, low, high))?;
        ensure(fresnel.reflectance(1.0) == normal, "normal incidence", &normal)?;
        ensure(fresnel.reflectance(-2.0) == [1.0; 3], "beyond grazing", &normal)
    });
}

#[test]
fn bad_reflectances_and_indices_are_refused() {
    for bad in [f64::NAN, -0.1, 1.1, f64::INFINITY] {
        assert!(matches!(Fresnel::schlick([0.5, bad, 0.5]), Err(Error::Reflectance(_))));
    }
    for bad in [f64::NAN, -0.1, f64::INFINITY, 2e9] {
        assert!(matches!(Fresnel::conductor([1.5, 1.5, bad], [0.0; 3]), Err(Error::Eta(_))));
        assert!(matches!(Fresnel::conductor([1.5; 3], [bad, 0.0, 0.0]), Err(Error::K(_))));
    }
    let none = Fresnel::conductor([0.0_f32; 3], [1.0; 3]);
    assert_eq!(none, Err(Error::Eta(0.0.into())));
}

/// A baked material is the widened lobe's BRDF times Fresnel and the mean plane's cosine.
fn is_its_parts<D: Distribution, R: Real>(
    material: &Material<D, R>,
    source: &mut Source,
) -> proptest::test_runner::TestCaseResult {
    let [u, v] = source.kernel().map(|v| v.map(R::lit));
    let kernel = Kernel::from_covariance(Psd::outer_sum(u, v));
    let [wo, wi] = source.pair().map(|w| w.map(R::lit));
    let widened = lobe::Ndf::<D, _>::new(material.lobe.widened(&kernel).shape());
    let got = material.bake(&kernel).evaluate(wo, wi);
    let h = lobe::slope::direction::half_vector(wo, wi);
    let cos = wo[0] * h[0] + wo[1] * h[1] + wo[2] * h[2];
    let fresnel = material.fresnel.reflectance(cos);
    let scale = widened.brdf(wo, wi).to_f64() * widened.shape().mean_area(wi).to_f64().max(0.0);
    for n in 0..3 {
        let want = fresnel[n].to_f64() * scale;
        if want < 0.5 * R::MAX.to_f64() {
            let tolerance = 8.0 * R::EPSILON.to_f64() * want + R::MIN_POSITIVE.to_f64();
            near(got[n].to_f64(), want, tolerance, &(wo, wi, n))?;
        }
        ensure(got[n] >= R::ZERO && got[n].is_finite(), "finite", &(wo, wi, got[n]))?;
    }
    Ok(())
}

#[test]
fn a_baked_material_is_the_sum_of_its_parts() {
    let gold = |source: &mut Source| {
        let k = [source.uniform(0.0, 4.0), 2.35, 1.77];
        Fresnel::conductor([0.18, 0.42, 1.37], k).expect("an index")
    };
    check(20_000, |source| {
        let fresnel = gold(source);
        is_its_parts(&Material::ggx(source.lobe().lobe::<f64>(), fresnel), source)?;
        is_its_parts(&Material::beckmann(source.lobe().lobe::<f64>(), fresnel), source)?;
        let fresnel = Fresnel::schlick([0.9_f32, 0.5, 0.1]).expect("reflectances");
        is_its_parts(&Material::ggx(source.lobe().lobe::<f32>(), fresnel), source)?;
        is_its_parts(&Material::beckmann(source.lobe().lobe::<f32>(), fresnel), source)
    });
}

#[test]
fn an_exact_mean_over_a_footprint_keeps_fresnel_and_cosine() {
    check(5_000, |source| {
        let lobe = source.lobe().lobe::<f64>();
        let fresnel = Fresnel::schlick([0.9, 0.5, 0.1]).expect("reflectances");
        let shading = Material::ggx(lobe, fresnel).unfiltered();
        let ([wo, wi], footprint) = (source.pair(), source.footprint());
        let got = shading.evaluate_over(wo, wi, &footprint);
        let ndf = Ggx::new(lobe.shape());
        let h = lobe::slope::direction::half_vector(wo, wi);
        let cos = wo[0] * h[0] + wo[1] * h[1] + wo[2] * h[2];
        let scale = ndf.brdf_over(wo, wi, &footprint) * ndf.shape().mean_area(wi).max(0.0);
        let want = fresnel.reflectance(cos)[1] * scale;
        near(got[1], want, 1e-14 * want, &(wo, wi, footprint))
    });
}

#[test]
fn slices_are_evaluated_one_by_one_or_not_at_all() {
    let mut source = Source::from_seed(7);
    let fresnel = Fresnel::white();
    let pick = |source: &mut Source| Material::ggx(source.lobe().lobe::<f32>(), fresnel);
    let materials: Vec<_> = (0..5).map(|_| pick(&mut source)).collect();
    let kernels = vec![Kernel::from_covariance(Psd::outer_sum([0.1, 0.0], [0.02, 0.05])); 5];
    let mut baked = vec![materials[0].unfiltered(); 5];
    bake_all(&materials, &kernels, &mut baked).expect("five of each");
    let pairs: Vec<_> = (0..5).map(|_| source.pair().map(|w| w.map(|x| x as f32))).collect();
    let (wo, wi): (Vec<_>, Vec<_>) = pairs.iter().map(|&[wo, wi]| (wo, wi)).unzip();
    let mut out = vec![[-1.0; 3]; 5];
    evaluate_all(&baked, &wo, &wi, &mut out).expect("five of each");
    for n in 0..5 {
        assert_eq!(baked[n], materials[n].bake(&kernels[n]));
        assert_eq!(out[n], baked[n].evaluate(wo[n], wi[n]));
    }
    let before = (baked.clone(), out.clone());
    assert!(matches!(bake_all(&materials[1..], &kernels, &mut baked), Err(Error::Length { .. })));
    assert!(matches!(bake_all(&materials, &kernels[1..], &mut baked), Err(Error::Length { .. })));
    assert!(matches!(evaluate_all(&baked[1..], &wo, &wi, &mut out), Err(Error::Length { .. })));
    assert!(matches!(evaluate_all(&baked, &wo[1..], &wi, &mut out), Err(Error::Length { .. })));
    assert!(matches!(evaluate_all(&baked, &wo, &wi[1..], &mut out), Err(Error::Length { .. })));
    assert_eq!((baked, out), before);
}

/// Single scattering loses energy and never gains it; the rougher, the more it loses.
#[test]
fn a_white_material_reflects_no_more_than_it_receives() {
    let mut smoother = 1.0;
    for alpha in [0.1, 0.3, 1.0, 3.0] {
        let lobe = Lobe::centered(Roughness::from_alpha(alpha).expect("an alpha"));
        let shading = Material::ggx(lobe, Fresnel::<f64>::white()).unfiltered();
        let wo = [0.6, 0.0, 0.8];
        // Midpoints in the height and the azimuth.
        let (rows, columns) = (800, 800);
        let mut sum = 0.0;
        for i in 0..rows {
            let z = (f64::from(i) + 0.5) / f64::from(rows);
            let r = (1.0 - z * z).sqrt();
            for j in 0..columns {
                let (sin, cos) =
                    (core::f64::consts::TAU * (f64::from(j) + 0.5) / f64::from(columns)).sin_cos();
                sum += shading.evaluate(wo, [r * cos, r * sin, z])[0];
            }
        }
        let albedo = sum * core::f64::consts::TAU / f64::from(rows * columns);
        assert!(0.0 < albedo && albedo < smoother, "alpha {alpha}: albedo {albedo}");
        smoother = albedo;
    }
}
