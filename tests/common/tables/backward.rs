//! The backward error of one result, in roundings.

use super::quantity::Evaluator;
use crate::roundings::{roundings, roundings_to_first_order};
use lobe::Real;

/// The least of 1, 2, 4, ... roundings by which `inputs` and result must be moved for `got` to be
/// exact; infinite if 4096 do not suffice, or if `got` is negative or not finite.
///
/// The exact function has the value `expected` at `inputs`; its values at moved inputs are in the
/// ratio of those of `double`, the quantity's forward accurate function in f64. In f32 the moved
/// inputs are searched, since a lobe of alpha 1e-4 at mean 1e3 moves by many alphas within 16
/// roundings. In f64 the error of `double` is as large as what a move of 16 roundings changes, and
/// a search would find that error. Over so short a move `double` is nearly linear, and differences
/// over longer steps give its derivatives.
pub(super) fn roundings_of<R: Real>(
    got: f64,
    expected: f64,
    inputs: &[f64],
    double: Evaluator<f64>,
) -> f64 {
    let (unit, least) = (R::EPSILON.to_f64(), R::MIN_POSITIVE.to_f64());
    if !(got.is_finite() && got >= 0.0) {
        return f64::INFINITY;
    }
    // Inputs that the library refuses are not moved to.
    let value = |x: &[f64]| double(x).map_or(f64::NAN, |results| results[0]);
    let here = value(inputs);
    // A ratio, not a difference: values at moved inputs may be orders of magnitude apart.
    let factor = if here.max(expected) < least { 1.0 } else { expected / here };
    let most = R::MAX.to_f64();
    let exact = |x: &[f64]| {
        let exact = factor * value(x);
        if exact > most { most } else { exact }
    };
    if R::SINGLE {
        roundings(got, &exact, inputs, unit, least)
    } else {
        roundings_to_first_order(got, &exact, inputs, unit, least)
    }
}
