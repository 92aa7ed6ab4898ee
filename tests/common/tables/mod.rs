//! Golden tables: read a CSV whose stem names a quantity, evaluate the library, measure the error.
//!
//! Shared by `cargo run --release --example validate` and tests/laws/golden.rs.

mod file;
mod outcome;
mod quantity;

pub(crate) use file::{Table, read_directory};
pub(crate) use outcome::{Deviation, Outcome};
pub(crate) use quantity::Quantity;

use lobe::Real;

/// Evaluates `quantity` on every row of `table` in the precision `R`.
///
/// An error is one line that names the file and the row that was refused.
pub(crate) fn evaluate<R: Real>(table: &Table, quantity: &Quantity) -> Result<Outcome, String> {
    let evaluate = quantity.evaluator::<R>();
    let mut deviations = Vec::with_capacity(table.rows.len());
    for (index, row) in table.rows.iter().enumerate() {
        let (inputs, expected) = row.split_at(quantity.inputs.len());
        let inputs: Vec<R> = inputs.iter().map(|&x| R::lit(x)).collect();
        let got = evaluate(&inputs)
            .map_err(|error| format!("{}: row {}: {error}", table.path.display(), index + 1))?;
        deviations.push(Deviation::of(&got, expected, quantity.signed));
    }
    Outcome::of(&deviations)
        .ok_or_else(|| format!("{}: no rows below the header", table.path.display()))
}
