//! Constructors: what they refuse, what they accept, and that what went in comes out.
#![allow(clippy::incompatible_msrv, reason = "tests need a newer compiler, for their oracles")]

use crate::common::arbitrary::Source;
use crate::common::{ULP, check, near, near_all};
use core::f64::consts::{FRAC_PI_2, PI};
use lobe::filter::tokuyoshi_deferred_alpha;
use lobe::{
    Anisotropic, AxisAligned, Error, Footprint, Ggx, Isotropic, Lobe, LobeShape, NonCentered,
    PixelFilter, Psd, Real, Roughness, SlopeMoments, Value, Vertex,
};
use nalgebra::Matrix2;

const BAD: [f64; 4] = [-1e-30, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

fn values(numbers: [f64; 3]) -> [Value; 3] {
    numbers.map(Value::from)
}

/// Refused with this error, whose message names the parameter.
#[track_caller]
fn refused<T: core::fmt::Debug>(result: Result<T, Error>, error: Error, names: &str) {
    let got = result.expect_err("should be refused");
    assert_eq!(got, error);
    assert!(got.to_string().contains(names), "`{got}` does not name `{names}`");
}

#[test]
fn every_error_is_reached_and_names_its_parameter() {
    let psd = Psd::zero();
    for bad in BAD {
        refused(Roughness::from_alpha(bad), Error::Alpha(bad.into()), "alpha");
        refused(Isotropic::new(bad), Error::Alpha(bad.into()), "alpha");
        refused(Roughness::from_alphas(bad, 0.1, 0.0), Error::AlphaX(bad.into()), "alpha_x");
        refused(Roughness::from_alphas(0.1, bad, 0.0), Error::AlphaY(bad.into()), "alpha_y");
        refused(AxisAligned::new(bad, 0.1), Error::AlphaX(bad.into()), "alpha_x");
        refused(AxisAligned::new(0.1, bad), Error::AlphaY(bad.into()), "alpha_y");
        refused(Roughness::from_perceptual(bad), Error::Perceptual(bad.into()), "perceptual");
        refused(Roughness::from_sigma_rho(bad, 0.1, 0.0), Error::SigmaX(bad.into()), "sigma_x");
        refused(Roughness::from_sigma_rho(0.1, bad, 0.0), Error::SigmaY(bad.into()), "sigma_y");
        refused(PixelFilter::with_variance(bad), Error::Variance(bad.into()), "variance");
        let n = [0.0; 3];
        let deferred =
            |alpha, limit| tokuyoshi_deferred_alpha(alpha, n, n, PixelFilter::KAPLANYAN, limit);
        refused(deferred(bad, 0.18), Error::Alpha(bad.into()), "alpha");
        let one = SlopeMoments::of_slope([0.0; 2]).expect("a slope");
        refused(one.merged(bad, &one, 1.0), Error::Weight(bad.into()), "weight");
        refused(one.merged(1.0, &one, bad), Error::Weight(bad.into()), "weight");
    }
    for bad in [f64::NAN, -1.0, f64::NEG_INFINITY] {
        let n = [0.0; 3];
        let deferred = tokuyoshi_deferred_alpha(0.1, n, n, PixelFilter::KAPLANYAN, bad);
        refused(deferred, Error::Limit(bad.into()), "limit");
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        refused(Roughness::from_alphas(0.1, 0.1, bad), Error::Angle(bad.into()), "angle");
        for k in 0..3 {
            let mut entries = [1.0; 3];
            entries[k] = bad;
            let [xx, xy, yy] = entries;
            refused(Psd::new(xx, xy, yy), Error::MatrixEntry(bad.into()), "matrix");
            refused(
                SlopeMoments::from_raw([0.0; 2], entries),
                Error::MatrixEntry(bad.into()),
                "matrix",
            );
        }
        for mean in [[bad, 0.0], [0.0, bad]] {
            refused(Lobe::new(mean, Roughness::default()), Error::Mean(bad.into()), "mean");
            refused(SlopeMoments::new(mean, psd), Error::Mean(bad.into()), "mean");
            refused(SlopeMoments::from_raw(mean, [0.0; 3]), Error::Mean(bad.into()), "mean");
            let shape = Isotropic::new(0.1).expect("alpha > 0");
            refused(NonCentered::new(shape, mean), Error::Mean(bad.into()), "mean");
        }
        refused(
            Vertex::at([0.0, bad, 1.0]),
            Error::Direction(values([0.0, bad, 1.0])),
            "direction",
        );
        refused(
            Vertex::distant([0.0, 0.0, bad]),
            Error::Direction(values([0.0, 0.0, bad])),
            "direction",
        );
        let up = [0.0, 0.0, 1.0];
        for k in 0..3 {
            let mut three = [up; 3];
            three[k] = [bad, 0.0, 1.0];
            let [here, right, above] = three;
            let got = Footprint::from_half_vectors(here, right, above);
            refused(got, Error::HalfVector(values([bad, 0.0, 1.0])), "half vector");
        }
    }
    let bad = 1.0_f64.next_up();
    refused(Roughness::from_perceptual(bad), Error::Perceptual(bad.into()), "perceptual");
    for bad in [f64::NAN, 1.0_f64.next_up(), -1.0_f64.next_up()] {
        refused(Roughness::from_sigma_rho(0.1, 0.1, bad), Error::Rho(bad.into()), "rho");
    }
    for [xx, xy, yy] in [[-1.0, 0.0, 1.0], [1.0, 0.0, -1.0], [1.0, 1.1, 1.0], [0.0, 0.1, 1.0]] {
        refused(Psd::new(xx, xy, yy), Error::MatrixNotPositive(values([xx, xy, yy])), "matrix");
    }
    refused(Vertex::at([0.0; 3]), Error::Direction(values([0.0; 3])), "direction");
    let one = SlopeMoments::of_slope([0.0; 2]).expect("a slope");
    refused(one.merged(0.0, &one, 0.0), Error::WeightSum(0.0.into()), "weight");
    let up = [0.0, 0.0, 1.0];
    for below in [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0]] {
        refused(
            Footprint::from_half_vectors(below, up, up),
            Error::HalfVector(values(below)),
            "half vector",
        );
        refused(
            Footprint::from_half_vectors(up, below, up),
            Error::HalfVector(values(below)),
            "half vector",
        );
        refused(
            Footprint::from_half_vectors(up, up, below),
            Error::HalfVector(values(below)),
            "half vector",
        );
    }
}

/// Messages are one line: the parameter, the value in its shortest form, and the range.
#[test]
fn messages_show_the_value_and_the_range() {
    let cases: [(Error, &str); 8] = [
        (Roughness::from_alpha(-1.0_f32).unwrap_err(), "alpha = -1 is not in [0, 1e9]"),
        (Roughness::from_alpha(-0.1_f32).unwrap_err(), "alpha = -0.1 is not in [0, 1e9]"),
        (Roughness::from_alpha(0.1_f64 - 1.0).unwrap_err(), "alpha = -0.9 is not in [0, 1e9]"),
        (Isotropic::new(3e38_f32).unwrap_err(), "alpha = 3e38 is not in [0, 1e9]"),
        (Isotropic::new(-1e-300).unwrap_err(), "alpha = -1e-300 is not in [0, 1e9]"),
        (Roughness::from_perceptual(f32::NAN).unwrap_err(), "perceptual = NaN is not in [0, 1]"),
        (
            Psd::new(1.0, 2.0, 1.0_f32).unwrap_err(),
            "matrix [[1, 2], [2, 1]] is not positive semi-definite",
        ),
        (
            Vertex::at([0.0_f32, f32::INFINITY, 1.0]).unwrap_err(),
            "direction or position (0, inf, 1) is not finite, or has no length",
        ),
    ];
    for (error, message) in cases {
        assert_eq!(error.to_string(), message);
    }
}

/// Fourth powers of what is accepted are still f32; beyond, nothing is promised and nothing
/// accepted.
#[test]
fn magnitudes_end_at_a_billion() {
    fn ends<R: Real>() {
        let (largest, beyond) = (R::lit(1e9), R::lit(1.1e9));
        let rho = R::HALF;
        assert!(Roughness::from_alphas(largest, largest, R::ONE).is_ok());
        assert!(Roughness::from_sigma_rho(largest, largest, rho).is_ok());
        let slope = [largest, -largest];
        let moments = SlopeMoments::of_slope(slope).expect("a slope");
        let roughness = Roughness::from_alpha(largest).expect("an alpha");
        let lobe = Lobe::new(slope, roughness).expect("a lobe");
        let opposite = SlopeMoments::of_slope([-largest, largest]).expect("a slope");
        let merged = moments.merged(R::ONE, &opposite, R::ONE).expect("weights");
        let [up, down] = [[R::ZERO, R::ZERO, R::ONE], [R::HALF, R::HALF, -R::HALF]];
        for shape in [lobe.shape(), merged.lobe(roughness).shape()] {
            let ggx = Ggx::new(shape);
            let all = [ggx.brdf(up, up), ggx.d(up), ggx.projected_area(down), ggx.slope_pdf(slope)];
            assert!(all.iter().all(|x| *x >= R::ZERO && x.is_finite()), "{all:?}");
        }
        assert!(matches!(Roughness::from_alpha(beyond), Err(Error::Alpha(_))));
        assert!(matches!(Isotropic::new(beyond), Err(Error::Alpha(_))));
        assert!(matches!(AxisAligned::new(beyond, R::ONE), Err(Error::AlphaX(_))));
        assert!(matches!(AxisAligned::new(R::ONE, beyond), Err(Error::AlphaY(_))));
        assert!(matches!(Roughness::from_sigma_rho(beyond, R::ONE, rho), Err(Error::SigmaX(_))));
        assert!(matches!(Roughness::from_sigma_rho(R::ONE, beyond, rho), Err(Error::SigmaY(_))));
        assert!(matches!(Lobe::new([beyond, R::ZERO], roughness), Err(Error::Mean(_))));
        assert!(matches!(SlopeMoments::of_slope([R::ZERO, -beyond]), Err(Error::Mean(_))));
        let entry = beyond * beyond;
        assert!(matches!(Psd::new(entry, R::ZERO, entry), Err(Error::MatrixEntry(_))));
        let raw = SlopeMoments::from_raw([R::ZERO; 2], [entry, R::ZERO, entry]);
        assert!(matches!(raw, Err(Error::MatrixEntry(_))));
    }
    ends::<f32>();
    ends::<f64>();
    assert!(matches!(PixelFilter::with_variance(2e9), Err(Error::Variance(_))));
}

#[test]
fn boundary_values_are_accepted() {
    assert!(Roughness::from_alpha(0.0_f64).is_ok());
    assert!(Roughness::from_alphas(0.0_f64, 0.0, 1e9).is_ok());
    assert!(
        Roughness::from_perceptual(0.0_f64).is_ok() && Roughness::from_perceptual(1.0_f32).is_ok()
    );
    for rho in [-1.0, 1.0_f64] {
        let ridge = Roughness::from_sigma_rho(0.1, 0.2, rho).expect("|rho| = 1 is a ridge");
        assert_eq!(ridge.matrix().root_det(), 0.0, "rho = {rho}");
    }
    assert!(Psd::new(0.0_f64, 0.0, 0.0).is_ok() && Psd::new(1.0_f32, 1.0, 1.0).is_ok());
    // The outer product of a rounded vector, as documented.
    check(10_000, |source| {
        let [x, y] = source.vector(1e-4, 1e3);
        let (a, b) = (x as f32, y as f32);
        let accepted =
            Psd::new(x * x, x * y, y * y).is_ok() && Psd::new(a * a, a * b, b * b).is_ok();
        crate::common::ensure(accepted, "an outer product is accepted", &(x, y))
    });
    assert!(PixelFilter::with_variance(0.0).is_ok());
    let one = SlopeMoments::of_slope([0.0_f64; 2]).expect("a slope");
    assert!(one.merged(0.0, &one, 1.0).is_ok() && one.merged(1e300, &one, 1e300).is_ok());
    let n = [0.0_f64; 3];
    assert!(tokuyoshi_deferred_alpha(0.0, n, n, PixelFilter::BOX, 0.0).is_ok());
    assert!(Vertex::at([0.0_f32, 0.0, 1e38]).is_ok() && Vertex::at([1e-38_f32, 0.0, 0.0]).is_ok());
}

#[test]
fn alphas_and_angle_come_back() {
    check(20_000, |source| {
        let (x, y, angle) = (source.alpha(), source.alpha(), source.angle());
        let back = Roughness::from_alphas(x, y, angle).expect("alphas > 0").alphas();
        let inputs = (x, y, angle, back);
        let (major, minor) = (x.max(y), x.min(y));
        near(back.major, major, 8.0 * ULP * major, &inputs)?;
        near(back.minor, minor, 16.0 * ULP * minor, &inputs)?;
        crate::common::ensure(
            back.angle > -FRAC_PI_2 && back.angle <= FRAC_PI_2,
            "a half turn",
            &inputs,
        )?;
        // The angle of an almost round lobe is as uncertain as rounding over the difference of
        // squares.
        let contrast = (major - minor) * (major + minor) / (major * major);
        let axis = if x >= y { angle } else { angle + FRAC_PI_2 };
        let off = (back.angle - axis).sin().abs();
        crate::common::ensure(off * contrast <= 16.0 * ULP, "the angle comes back", &(inputs, off))
    });
}

#[test]
fn units_of_roughness_are_one_matrix() {
    check(20_000, |source| {
        let perceptual = source.unit();
        let alpha = perceptual * perceptual;
        let sigma = alpha * 0.5_f64.sqrt();
        let want = [alpha * alpha, 0.0, alpha * alpha];
        let ways = [
            Roughness::from_perceptual(perceptual),
            Roughness::from_alpha(alpha),
            Roughness::from_alphas(alpha, alpha, source.angle()),
            Roughness::from_sigma_rho(sigma, sigma, 0.0),
        ];
        for way in ways {
            let matrix = way.expect("in range").matrix();
            let tolerance = 8.0 * ULP * want[0];
            near_all(&matrix.entries(), &want, tolerance, &(perceptual, matrix))?;
            near(matrix.root_det(), want[0], tolerance, &(perceptual, matrix))?;
        }
        Ok(())
    });
}

#[test]
fn deviations_and_correlation_come_back() {
    check(20_000, |source| {
        let (x, y, rho) = (source.alpha(), source.alpha(), source.rho());
        let roughness = Roughness::from_sigma_rho(x, y, rho).expect("in range");
        let covariance = roughness.covariance();
        let inputs = (x, y, rho);
        let want = [x * x, rho * x * y, y * y];
        let [xx, xy, yy] = covariance.entries();
        near(xx, want[0], 4.0 * ULP * want[0], &inputs)?;
        near(xy, want[1], 8.0 * ULP * want[1].abs(), &inputs)?;
        near(yy, want[2], 8.0 * ULP * want[2], &inputs)?;
        let det = x * y * ((1.0 - rho) * (1.0 + rho)).sqrt();
        near(covariance.root_det(), det, 8.0 * ULP * det, &inputs)?;
        let back = Roughness::from_covariance(covariance);
        let (back, whole) = (back.matrix().cholesky(), roughness.matrix().cholesky());
        near_all(&back, &whole, 2.0 * ULP * whole[1].abs().max(whole[0]).max(whole[2]), &inputs)
    });
}

/// M M^T sigma_o^2 = Sigma, M upper triangular.
#[test]
fn chermains_matrix_is_a_root_of_the_covariance() {
    check(20_000, |source| {
        let (x, y, rho) = (source.alpha(), source.alpha(), source.rho());
        let sigma_o = source.log_uniform(1e-3, 1.0);
        let roughness = Roughness::from_sigma_rho(x, y, rho).expect("in range");
        let rows = roughness.chermain_matrix(sigma_o);
        let m = Matrix2::new(rows[0][0], rows[0][1], rows[1][0], rows[1][1]);
        let back = m * m.transpose() * (sigma_o * sigma_o);
        let inputs = (x, y, rho, sigma_o);
        crate::common::ensure(rows[1][0] == 0.0, "upper triangular", &inputs)?;
        near(back[(0, 0)], x * x, 16.0 * ULP * x * x, &inputs)?;
        near(back[(0, 1)], rho * x * y, 16.0 * ULP * x * y, &inputs)?;
        near(back[(1, 1)], y * y, 16.0 * ULP * y * y, &inputs)?;
        // As printed, entry by entry.
        let complement = ((1.0 - rho) * (1.0 + rho)).sqrt();
        let want = [x * complement / sigma_o, rho * x / sigma_o, y / sigma_o];
        near(rows[0][0], want[0], 16.0 * ULP * want[0], &inputs)?;
        near(rows[0][1], want[1], 16.0 * ULP * want[1].abs(), &inputs)?;
        near(rows[1][1], want[2], 16.0 * ULP * want[2], &inputs)
    });
}

#[test]
fn chermains_matrix_of_a_ridge_is_finite() {
    for (x, y, rho) in
        [(0.1, 0.0, 0.0), (0.0, 0.1, 0.0), (0.0, 0.0, 0.0), (0.1, 0.2, 1.0), (0.1, 0.2, -1.0)]
    {
        let m = Roughness::from_sigma_rho(x, y, rho).expect("in range").chermain_matrix(0.5);
        let want =
            [[0.0_f64.max(2.0 * x * (1.0_f64 - rho * rho).sqrt()), 2.0 * rho * x], [0.0, 2.0 * y]];
        for k in 0..4 {
            let (got, want) = (m[k / 2][k % 2], want[k / 2][k % 2]);
            assert!((got - want).abs() <= 1e-15, "{m:?} for {x} {y} {rho}");
        }
    }
}

#[test]
fn a_lobe_keeps_what_it_was_made_of() {
    check(10_000, |source: &mut Source| {
        let input = source.lobe();
        let lobe = input.lobe::<f64>();
        let other = Roughness::from_alpha(source.alpha()).expect("alpha > 0");
        let kept = lobe.mean() == input.mean
            && lobe.roughness() == input.ellipse.roughness()
            && lobe.with_roughness(other).roughness() == other
            && lobe.with_roughness(other).mean() == input.mean
            && Lobe::centered(other).mean() == [0.0; 2];
        crate::common::ensure(kept, "mean and roughness are kept", &input)?;
        let anisotropic = Anisotropic::from(lobe.roughness());
        let want = input.ellipse.root_det();
        // Rounded entries: an ulp over 1 - rho^2.
        let skew = 8.0 * ULP / (1.0 - input.ellipse.rho.abs());
        near(anisotropic.root_det(), want, skew * want, &input)
    });
}

#[test]
fn deferred_alphas_add_and_stop_at_their_limits() {
    check(20_000, |source| {
        let alpha = source.alpha();
        let [[ux, uy], [vx, vy]] = source.kernel();
        let (u, v) = ([ux, uy, 0.5 * ux], [vx, 0.3 * vy, vy]);
        let limit = source.log_uniform(1e-3, 1.0);
        let got = tokuyoshi_deferred_alpha(alpha, u, v, PixelFilter::KAPLANYAN, limit);
        let got = got.expect("in range");
        let norm = |d: [f64; 3]| d.iter().map(|x| x * x).sum::<f64>();
        let want = (alpha * alpha + (0.5 * (norm(u) + norm(v))).min(limit)).sqrt();
        let want = want.min(alpha.max(1.0));
        near(got, want, 8.0 * ULP * want, &(alpha, u, v, limit))
    });
}

#[test]
fn named_filters_have_their_variances() {
    assert_eq!(PixelFilter::BOX.variance(), 1.0 / 12.0);
    assert_eq!(PixelFilter::KAPLANYAN.variance(), 0.25);
    let tokuyoshi = PixelFilter::TOKUYOSHI_KAPLANYAN.variance();
    assert!((tokuyoshi - 1.0 / (2.0 * PI)).abs() < 1e-16);
}
