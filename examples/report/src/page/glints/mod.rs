//! Glints on the page: cells, times, means, variances, error against run time; the same as text.

mod charts;
mod costs;
mod finding;
mod hall;
mod tables;

use super::part::Part;
use crate::glints::Glitter;

fn parts(glints: &Glitter) -> [Part<Glitter>; 6] {
    [
        Part {
            title: "Cells of a pixel",
            finding: finding::cells(glints),
            figures: |glints| hall::pictures(&glints.hall) + &charts::cells(glints),
            tables: vec![costs::cells(glints)],
            drawn: true,
            note: costs::CELLS_NOTE,
        },
        Part {
            title: "Time",
            finding: finding::times(glints),
            figures: charts::times,
            tables: vec![costs::times(glints)],
            drawn: false,
            note: costs::TIMES_NOTE,
        },
        Part {
            title: "One cell in operations and instructions",
            finding: finding::counts(glints),
            figures: |_| String::new(),
            tables: vec![costs::operations(glints), costs::instructions(glints)],
            drawn: false,
            note: costs::COUNTS_NOTE,
        },
        Part {
            title: "The mean",
            finding: finding::means(glints),
            figures: |_| String::new(),
            tables: vec![tables::means(glints), tables::gains(glints)],
            drawn: false,
            note: tables::MEANS_NOTE,
        },
        Part {
            title: "The variance",
            finding: finding::variances(glints),
            figures: charts::ripple,
            tables: vec![tables::variances(glints)],
            drawn: false,
            note: tables::VARIANCES_NOTE,
        },
        Part {
            title: "Error against run time",
            finding: finding::contests(glints),
            figures: charts::contests,
            tables: vec![costs::contests(glints)],
            drawn: false,
            note: costs::CONTESTS_NOTE,
        },
    ]
}

/// Pictures, charts, tables and what they say.
pub(super) fn html(glints: &Glitter) -> String {
    let parts = parts(glints).map(|part| part.html(glints));
    format!("{}{}", include_str!("glints.html"), parts.concat())
}

/// Tables and findings for the terminal.
pub(super) fn text(glints: &Glitter) -> String {
    format!("\nGlints\n{}", parts(glints).map(|part| part.text()).concat())
}
