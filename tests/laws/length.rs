//! What engines read off a mean of normals, against the distributions they stand for; and the
//! factor of 4 between them.
#![cfg(feature = "published")]

use crate::common::quadrature::adaptive;
use crate::common::{check, near};
use lobe::filter::{
    MEAN_LENGTH_TOLERANCE, VmfWidening, clean_variance, toksvig_exponent, toksvig_variance,
    vmf_sharpness,
};
use lobe::{Beckmann, Error, Isotropic, Roughness, SlopeMoments};

/// Mean of a function of the cosine over a von Mises-Fisher lobe of this sharpness.
fn over_lobe(kappa: f64, f: &dyn Fn(f64) -> f64) -> f64 {
    // In y = kappa (1 - cos): e^-y, so that no density overflows.
    let mut weighted = |y: f64| (-y).exp() * f(1.0 - y / kappa);
    let end = (2.0 * kappa).min(60.0);
    let norm = adaptive(&mut |y: f64| (-y).exp(), 0.0, end, 1e-13);
    adaptive(&mut weighted, 0.0, end, 1e-13) / norm
}

#[test]
fn sharpness_is_the_lobes_to_five_percent() {
    for step in 0..200 {
        let kappa = 0.1 * 1e5_f64.powf(f64::from(step) / 199.0);
        let length = over_lobe(kappa, &|cos| cos);
        let got = vmf_sharpness(length).expect("a length");
        assert!((got / kappa - 1.0).abs() < 0.05, "{got} for {kappa}");
    }
}

#[test]
fn engines_disagree_by_four_and_variance_takes_the_larger() {
    for kappa in [20.0, 50.0, 500.0, 5e4] {
        let length = over_lobe(kappa, &|cos| cos);
        // The variance per axis of what normals tilt, sin^2/2, to first order that of slopes.
        let variance = 0.5 * over_lobe(kappa, &|cos| 1.0 - cos * cos);
        let beckmann = Roughness::from_sigma_rho(variance.sqrt(), variance.sqrt(), 0.0);
        let right = beckmann.expect("deviations").alphas().major;
        let of = |widening: VmfWidening| widening.alpha(0.0, length).expect("a length");
        let (half, whole) = (of(VmfWidening::THE_ORDER), of(VmfWidening::SPECULAR_AA));
        assert!((whole * whole / (half * half) - 4.0).abs() < 1e-12);
        // Within what sin^2 and the fit leave of first order; the other is nowhere near.
        assert!((whole / right - 1.0).abs() < 1.5 / kappa + 1e-3, "{kappa}: {whole} for {right}");
        assert!((half / right - 0.5).abs() < 0.03, "{kappa}: {half} for {right}");
        // Added to alpha^2 it is what four times less variance would be: highlights four times as
        // bright.
        let peak =
            |alpha: f64| Beckmann::new(Isotropic::new(alpha).expect("alpha")).slope_pdf([0.0, 0.0]);
        assert!((peak(half) / peak(whole) - 4.0).abs() < 1e-9);
    }
}

#[test]
fn toksvig_is_a_variance_to_first_order() {
    // The mean normal of Gaussian slopes: |N| = E m_z.
    for sigma in [1e-3, 1e-2, 0.05, 0.1] {
        let variance = sigma * sigma;
        let mut height = |y: f64| (-y).exp() / (1.0 + 2.0 * variance * y).sqrt();
        let length = adaptive(&mut height, 0.0, 60.0, 1e-14);
        let got = toksvig_variance(length).expect("a length");
        assert!((got / variance - 1.0).abs() < 3.0 * variance + 1e-9, "{got} for {variance}");
    }
    check(2_000, |source| {
        let (s, length) = (source.log_uniform(1e-2, 1e6), source.uniform(0.05, 1.0));
        let got = toksvig_exponent(s, length).expect("in range");
        // Precisions add as variances do.
        let want = 1.0 / (1.0 / s + toksvig_variance(length).expect("a length"));
        near(got, want, 1e-12 * want, &(s, length))
    });
}

#[test]
fn clean_is_lean_without_direction() {
    check(2_000, |source| {
        let lobe = source.lobe();
        let covariance = lobe.lobe::<f64>().roughness().covariance();
        let moments = SlopeMoments::new(lobe.mean, covariance).expect("moments");
        let [x, y] = moments.mean();
        let second = covariance.trace() + (x * x + y * y);
        let got = clean_variance([x, y], second).expect("moments");
        // What the sum has rounded off is no longer there.
        near(got, 0.5 * covariance.trace(), 1e-15 * second, &lobe)
    });
    assert_eq!(clean_variance([1.0_f32, 0.0], 0.5), Ok(0.0));
}

/// The longest that a unit vector becomes when its components are stored: over every stored vector
/// near the sphere whose cell of rounding reaches the sphere. Components as whole half steps of
/// `1/scale`, odd ones in unorm.
fn longest_stored(scale: i32, is_unorm: bool) -> f64 {
    let scale_double = f64::from(scale);
    let half = if is_unorm { 1.0 } else { 0.5 } / scale_double;
    let (first, step) = if is_unorm { (1, 2) } else { (0, 1) };
    let mut longest = 0.0_f64;
    let components = || (first..=scale).step_by(step);
    for x in components() {
        for y in components().filter(|y| *y >= x) {
            let [x, y] = [x, y].map(|n| f64::from(n) / scale_double);
            let rest = (1.0 - x * x - y * y).max(0.0).sqrt() * scale_double;
            for z in components().filter(|z| (f64::from(*z) - rest).abs() < 6.0) {
                let v = [x, y, f64::from(z) / scale_double];
                let nearest = v.map(|c| (c - half).max(0.0));
                let length = |v: [f64; 3]| v.iter().map(|c| c * c).sum::<f64>().sqrt();
                if length(nearest) <= 1.0 {
                    longest = longest.max(length(v));
                }
            }
        }
    }
    longest
}

/// Unorm: (2 b - 255)/255; snorm: b/127. The bound covers both, and by little.
#[test]
fn eight_bits_make_no_normal_longer_than_the_tolerance() {
    let (unorm, snorm) = (longest_stored(255, true) - 1.0, longest_stored(127, false) - 1.0);
    assert!(unorm <= 3.0_f64.sqrt() / 255.0 && unorm > 0.98 * MEAN_LENGTH_TOLERANCE, "{unorm}");
    assert!(snorm <= MEAN_LENGTH_TOLERANCE && snorm > 0.98 * MEAN_LENGTH_TOLERANCE, "{snorm}");
    assert!((MEAN_LENGTH_TOLERANCE * 254.0 - 3.0_f64.sqrt()).abs() < 1e-15);
}

/// Every texel that a unit normal is stored as: none is refused, and none longer than 1 has
/// variance.
#[test]
fn texels_longer_than_one_have_no_variance() {
    let decode = |b: u8| 2.0 * f32::from(b) / 255.0 - 1.0;
    let mut longer = 0;
    for x in (0..=255).step_by(3) {
        for y in (0..=255).step_by(5) {
            // The third component as the byte next to it.
            let rest = 1.0 - decode(x) * decode(x) - decode(y) * decode(y);
            if rest < 0.0 {
                continue;
            }
            let error = |b: u8| (decode(b) - rest.sqrt()).abs();
            let z = (128..=255).min_by(|a, b| error(*a).total_cmp(&error(*b))).expect("bytes");
            let normal = [x, y, z].map(decode);
            let length = normal.iter().map(|c| c * c).sum::<f32>().sqrt();
            let variance = toksvig_variance(length).expect("a stored unit normal");
            let alpha = VmfWidening::SPECULAR_AA.alpha(0.3_f32, length).expect("a stored normal");
            if length > 1.0 {
                longer += 1;
                assert!(variance == 0.0 && (alpha - 0.3).abs() < 1e-6, "{normal:?}");
                assert_eq!(toksvig_exponent(100.0, length), Ok(100.0));
            }
        }
    }
    assert!(longer > 500, "{longer}");
    let flat = [128, 128, 255].map(decode);
    let length = flat.iter().map(|c| c * c).sum::<f32>().sqrt();
    assert!(length > 1.0 && toksvig_variance(length) == Ok(0.0), "{length}");
    assert_eq!(vmf_sharpness(length), vmf_sharpness(1.0));
    let most = 1.0 + MEAN_LENGTH_TOLERANCE;
    assert_eq!(toksvig_variance(most), Ok(0.0));
    assert!(matches!(toksvig_variance(most.next_up().next_up()), Err(Error::MeanLength(_))));
}

#[test]
fn lengths_outside_their_range_are_refused() {
    for bad in [0.0, -0.5, 1.01, 1.0069, f32::NAN, f32::INFINITY] {
        assert!(matches!(toksvig_variance(bad), Err(Error::MeanLength(_))));
        assert!(matches!(vmf_sharpness(bad), Err(Error::MeanLength(_))));
        assert!(matches!(VmfWidening::SPECULAR_AA.alpha(0.1, bad), Err(Error::MeanLength(_))));
    }
    assert!(matches!(toksvig_exponent(-1.0, 0.5), Err(Error::Exponent(_))));
    assert!(matches!(VmfWidening::THE_ORDER.alpha(-1.0, 0.5), Err(Error::Alpha(_))));
    assert!(matches!(clean_variance([f32::NAN, 0.0], 0.5), Err(Error::Mean(_))));
    assert!(matches!(clean_variance([0.0, 0.0], f32::INFINITY), Err(Error::MatrixEntry(_))));
}
