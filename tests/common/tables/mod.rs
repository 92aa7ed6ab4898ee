//! Golden tables: read a CSV whose stem names a quantity, evaluate the library, measure the error.
//!
//! Shared by `cargo run --release --example validate` and tests/laws/golden.rs.

mod backward;
mod file;
mod number;
mod outcome;
mod quantity;
mod shapes;

pub(crate) use file::{Table, read_directory};
pub(crate) use outcome::{Deviation, Outcome, Rounded};
pub(crate) use quantity::Quantity;
pub(crate) use shapes::Promise;

use backward::roundings_of;
use lobe::{Error, Real};

/// Evaluates `quantity` on every row of `table` in the precision `R`, by the function that
/// `promise` judges.
///
/// Inputs that `R` does not hold are rounded to it, and the row's expected values are moved to the
/// rounded inputs by the library itself in f64, $expected + f_{64}(rounded) - f_{64}(given)$. The
/// difference is small and its error that of f64, which is judged apart, against the expected
/// values as they stand; so what is judged in `R` is neither the user's rounding nor the library's
/// in f64. Rows are left out and counted whose rounded inputs the library refuses, have a zero for
/// what is none, or have an expected value beyond the range of `R`; and rows of which the move says
/// nothing, because its roundings, four epsilons of f64 times $|expected| + |f_{64}(given)|$,
/// exceed 1e-9 of the largest moved value.
///
/// An error is one line that names the file, and line and row that were refused.
pub(crate) fn evaluate<R: Real>(
    table: &Table,
    quantity: &Quantity,
    promise: Promise,
) -> Result<Outcome, String> {
    let (evaluated, double) =
        (quantity.evaluator::<R>(promise), quantity.evaluator::<f64>(Promise::Forward));
    let deviation = |got: &[R], expected: &[f64], held: &[f64]| {
        let mut deviation = Deviation::of(got, expected, quantity.signed);
        if promise == Promise::Backward {
            deviation.roundings = roundings_of::<R>(got[0].to_f64(), expected[0], held, double);
        }
        deviation
    };
    let mut deviations = Vec::with_capacity(table.rows.len());
    let mut rounded = Rounded::default();
    for (index, row) in table.rows.iter().enumerate() {
        let (given, expected) = row.split_at(quantity.inputs.len());
        let inputs: Vec<R> = given.iter().map(|&x| R::lit(x)).collect();
        let held: Vec<f64> = inputs.iter().map(|x| x.to_f64()).collect();
        let refused = |error: Error| {
            let (path, line) = (table.path.display(), table.lines[index]);
            format!("{path}: line {line} (row {}): {error}", index + 1)
        };
        let Some(column) = (0..given.len()).find(|&k| held[k] != given[k]) else {
            let got = evaluated(&inputs).map_err(refused)?;
            deviations.push((index, deviation(&got, expected, &held)));
            continue;
        };
        let here = double(given).map_err(refused)?;
        rounded.add(index, column);
        let there = if held.iter().all(|x| x.is_finite()) { double(&held).ok() } else { None };
        let vanished = (0..given.len()).any(|k| held[k] == 0.0 && given[k] != 0.0);
        let moved = there.filter(|_| !vanished).and_then(|there| {
            let moved = |k: usize| expected[k] + (there[k] - here[k]);
            let moved: Vec<f64> = (0..expected.len()).map(moved).collect();
            is_trusted::<R>(&moved, expected, &here).then_some(moved)
        });
        match (moved, evaluated(&inputs)) {
            (Some(moved), Ok(got)) => {
                deviations.push((index, deviation(&got, &moved, &held)));
            }
            _ => rounded.refused += 1,
        }
    }
    if table.rows.is_empty() {
        return Err(format!("{}: no rows below the header", table.path.display()));
    }
    Ok(Outcome::of(&deviations, rounded))
}

/// Whether moved values are within the range of `R`, and the roundings of the move below 1e-9 of
/// the largest.
fn is_trusted<R: Real>(moved: &[f64], expected: &[f64], here: &[f64]) -> bool {
    let largest = |values: &[f64]| values.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let scale = largest(moved).max(R::MIN_POSITIVE.to_f64());
    let rounding = 4.0 * f64::EPSILON * (largest(expected) + largest(here));
    moved.iter().all(|x| x.is_finite() && R::lit(*x).to_f64().is_finite())
        && rounding <= 1e-9 * scale
}
