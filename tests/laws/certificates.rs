//! The measured errors that the comments in src/scalar state, in f32, against correctly rounded
//! f64.
//!
//! One float in 31, from end to end: a prime, so that no pattern of bits is left out.

use lobe::Real;

/// Error in units of the last place of the exact value.
fn ulp(got: f32, want: f64) -> f64 {
    let size = (want as f32).abs().max(f32::MIN_POSITIVE);
    let unit = f32::from_bits(size.to_bits() & 0x7F80_0000) * f32::EPSILON;
    (f64::from(got) - want).abs() / f64::from(unit)
}

/// The largest error over the floats from `low` to `high`, and where.
fn worst(low: f32, high: f32, sign: f32, f: fn(f32) -> f32, exact: fn(f64) -> f64) -> (f64, f32) {
    let mut worst = (0.0, low);
    for bits in (low.to_bits()..=high.to_bits()).step_by(31) {
        let x = sign * f32::from_bits(bits);
        let error = ulp(f(x), exact(f64::from(x)));
        if error > worst.0 {
            worst = (error, x);
        }
    }
    worst
}

#[track_caller]
fn holds(limit: f64, (error, x): (f64, f32)) {
    assert!(error <= limit, "{error:.3} ulp at {x:e}, stated: {limit}");
    // A certificate describes: it is not much larger than what a scan of one in 31 finds.
    assert!(error >= 0.85 * limit, "only {error:.3} ulp at {x:e}, stated: {limit}");
}

#[test]
fn exp_errs_as_stated() {
    let (up, down) = (
        worst(1e-8, 88.7, 1.0, Real::exp, pxfm::f_exp),
        worst(1e-8, 87.3, -1.0, Real::exp, pxfm::f_exp),
    );
    holds(0.9, if up.0 > down.0 { up } else { down });
}

#[test]
fn exp2_of_negative_numbers_errs_as_stated() {
    /// The trait that has it can be named in no bound but that of `Real`.
    fn by<R: Real>(x: R) -> R {
        x.exp2_of_negative()
    }
    holds(2.59, worst(1e-8, 126.0, -1.0, by, pxfm::f_exp2));
}

#[test]
fn ln_errs_as_stated() {
    // From the smallest subnormal number.
    holds(0.84, worst(f32::from_bits(1), f32::MAX, 1.0, Real::ln, pxfm::f_log));
}

#[test]
fn atan_errs_as_stated() {
    holds(1.86, worst(1e-9, 1e9, 1.0, Real::atan, pxfm::f_atan));
}

/// By its series where the difference cancels in f64: the next term is below 1e-17 of the first.
fn atan_excess(x: f64) -> f64 {
    if x > 0.02 {
        return pxfm::f_atan(x) - x / (1.0 + x * x);
    }
    let s = x * x;
    let terms = (1..12).map(|n: i32| {
        let odd = f64::from(2 * n + 1);
        let sign = if n % 2 == 0 { -1.0 } else { 1.0 };
        sign * (1.0 - 1.0 / odd) * s.powi(n)
    });
    x * terms.sum::<f64>()
}

#[test]
fn the_tail_of_atan_errs_as_stated() {
    /// The trait that has it can be named in no bound but that of `Real`.
    fn by<R: Real>(x: R) -> R {
        x.atan_excess()
    }
    holds(5.4, worst(1e-4, 1.0, 1.0, by, atan_excess));
}

#[test]
fn erfc_and_its_scaled_form_err_as_stated() {
    let (right, left) = (
        worst(1e-8, 9.0, 1.0, Real::erfc, pxfm::f_erfc),
        worst(1e-8, 9.0, -1.0, Real::erfc, pxfm::f_erfc),
    );
    holds(4.5, if right.0 > left.0 { right } else { left });
    holds(3.2, worst(1e-8, 1e6, 1.0, Real::erfcx, pxfm::f_erfcx));
}

/// The definition with scaled terms: up to 30 the difference costs a thousandfold at most, and the
/// factor before it is far smaller where it does.
fn ierfc(v: f64) -> f64 {
    let root = core::f64::consts::FRAC_2_SQRT_PI / 2.0;
    pxfm::f_exp(-v * v) * (root - v * pxfm::f_erfcx(v))
}

#[test]
fn ierfc_excess_errs_as_stated() {
    let mut worst = (0.0, 0.0);
    for bits in (1e-6_f32.to_bits()..=900_f32.to_bits()).step_by(31) {
        let w = f32::from_bits(bits);
        let v = f64::from(w).sqrt();
        let excess = ierfc(v) * (2.0 * v + ierfc(v));
        // Half of the error of a square is that of its root.
        let error = (f64::from(w.ierfc_excess()) - excess).abs() / (2.0 * (v + ierfc(v)).powi(2));
        if error > worst.0 {
            worst = (error, f64::from(w));
        }
    }
    let (error, x) = worst;
    assert!((0.85 * 3.03e-7..=3.03e-7).contains(&error), "{error:e} at {x:e}, stated: 3.03e-7");
}
