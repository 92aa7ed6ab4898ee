//! Backward accuracy: whether a result is the exact one for inputs moved by a few roundings.

use core::fmt::Debug;
use proptest::test_runner::{TestCaseError, TestCaseResult};

/// How many units of rounding inputs and result may be moved by: the promise of the default shapes.
pub(crate) const ROUNDINGS: f64 = 16.0;

/// Where in [-1, 1] the search finds `f` largest: at an end, in the middle, by golden sections.
fn summit(f: &dyn Fn(f64) -> f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    let (mut low, mut high) = (-1.0, 1.0);
    let mut best = (f(0.0), 0.0);
    let mut consider = |place: f64| {
        let value = f(place);
        if value > best.0 {
            best = (value, place);
        }
        value
    };
    consider(low);
    consider(high);
    for _ in 0..16 {
        let reach = GOLDEN * (high - low);
        let (right, left) = (low + reach, high - reach);
        if consider(left) > consider(right) { high = right } else { low = left }
    }
    best.1
}

/// The largest value of `sign * f` that the search finds over inputs within `relative` of `inputs`:
/// one input after the other moves to its best place, twice over.
fn extreme(f: &dyn Fn(&[f64]) -> f64, inputs: &[f64], relative: f64, sign: f64) -> f64 {
    let mut moved = inputs.to_vec();
    for k in (0..2 * inputs.len()).map(|k| k % inputs.len()) {
        let at = |place: f64| {
            let mut moved = moved.clone();
            moved[k] = inputs[k] * (1.0 + place * relative);
            moved
        };
        moved = at(summit(&|place| sign * f(&at(place))));
    }
    f(&moved)
}

/// The least of 1, 2, 4, ... units of rounding by which inputs and result must be moved for `got`
/// to be exact; infinite if 4096 do not suffice.
///
/// `f` is the exact function and `unit` the rounding of the precision. Results below `least` have
/// no digits.
pub(crate) fn roundings(
    got: f64,
    f: &dyn Fn(&[f64]) -> f64,
    inputs: &[f64],
    unit: f64,
    least: f64,
) -> f64 {
    let exact = f(inputs);
    let mut count = 1.0;
    while count <= 4096.0 {
        let relative = count * unit;
        let slack = |x: f64| relative * x.abs() + least;
        let above = got <= exact + slack(exact) || {
            let most = extreme(f, inputs, relative, 1.0);
            got <= most + slack(most)
        };
        let below = got >= exact - slack(exact) || {
            let fewest = extreme(f, inputs, relative, -1.0);
            got >= fewest - slack(fewest)
        };
        if above && below {
            return count;
        }
        count *= 2.0;
    }
    f64::INFINITY
}

/// `got`, of a precision with this rounding, is finite, not negative, and exact for inputs and
/// result moved by [`ROUNDINGS`].
pub(crate) fn backward(
    got: f64,
    f: &dyn Fn(&[f64]) -> f64,
    inputs: &[f64],
    [unit, least, most]: [f64; 3],
    context: &dyn Debug,
) -> TestCaseResult {
    let fail = |what: &str, exact: f64| {
        let message = format!("{what}: got {got:e}, exact {exact:e}; {inputs:?}, {context:?}");
        Err(TestCaseError::fail(message))
    };
    if !(got.is_finite() && got >= 0.0) {
        return fail("not finite, or negative", f(inputs));
    }
    let bounded = |x: &[f64]| f(x).min(most);
    let count = roundings(got, &bounded, inputs, unit, least);
    if count <= ROUNDINGS { Ok(()) } else { fail(&format!("{count} roundings"), f(inputs)) }
}
