//! The errors that the comments on the arctangents of `halves` state, found by a scan.
//!
//! Layer 3, and tests alone. The coefficients are evaluated in f64, by Horner's scheme, against an
//! arctangent that is right to the last digit or two: what is measured is the polynomial, not the
//! rounding of the precision that it is for.

use super::halves::{DOUBLE, SINGLE};
use alloc::format;
use core::f64::consts::FRAC_PI_2;

/// Places of the scan in s, from the first to 1.
const PLACES: u32 = 1_000_000;

/// $1 + s\,p(s)$: the arctangent of t over t, with $s = t^2$.
fn over_argument(coefficients: &[f64], s: f64) -> f64 {
    1.0 + s * coefficients.iter().rev().fold(0.0, |sum, c| sum * s + c)
}

/// The largest relative error over 0 < s <= 1, and where.
fn worst(coefficients: &[f64]) -> (f64, f64) {
    let errors = (1..=PLACES).map(|k| {
        let s = f64::from(k) / f64::from(PLACES);
        let t = s.sqrt();
        ((t * over_argument(coefficients, s) / pxfm::f_atan(t) - 1.0).abs(), s)
    });
    errors.fold((0.0, 0.0), |most, next| if next.0 > most.0 { next } else { most })
}

/// What joins both ranges of an angle, at t = 1: the arctangent twice, less a right angle.
fn step(coefficients: &[f64]) -> f64 {
    (2.0 * over_argument(coefficients, 1.0) - FRAC_PI_2).abs()
}

/// Holds a measured number to a stated one, in as many digits as that has.
#[track_caller]
fn states(stated: &str, found: f64) {
    let digits = stated.split('e').next().unwrap_or_default().len().saturating_sub(2);
    assert_eq!(format!("{found:.digits$e}"), stated);
}

#[test]
fn the_arctangent_of_f32_errs_as_stated() {
    let rounded = SINGLE.map(|c| f64::from(c as f32));
    let (error, s) = worst(&rounded);
    states("7.87e-7", error);
    assert!((s - 0.8125).abs() < 1e-3, "at {s}");
    states("2.9e-9", step(&rounded));
}

#[test]
fn the_arctangent_of_f64_errs_as_stated() {
    let (error, s) = worst(&DOUBLE);
    states("2.02e-12", error);
    assert!((s - 0.8887).abs() < 1e-3, "at {s}");
    // The stated 1.4e-17 is below what f64 resolves at a right angle.
    assert!(step(&DOUBLE) <= 2.0 * f64::EPSILON, "{:e}", step(&DOUBLE));
}
