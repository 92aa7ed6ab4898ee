//! Glints on the page: cells, times, means, variances, error against run time; the same as text.

mod charts;
mod costs;
mod finding;
mod hall;
mod tables;

use super::escape;
use super::table::Table;
use crate::glints::Glitter;

/// One thing that is measured: what it shows and what that says.
struct Part {
    title: &'static str,
    finding: String,
    /// On the page alone: pictures and charts.
    figures: fn(&Glitter) -> String,
    tables: Vec<Table>,
    /// Whether the figures show all that the tables have: then they are for the terminal.
    drawn: bool,
    note: &'static str,
}

fn parts(glints: &Glitter) -> [Part; 6] {
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
    let parts = parts(glints).map(|Part { title, finding, figures, tables, drawn, note }| {
        let tables = tables.iter().filter(|_| !drawn);
        let tables = tables.map(|table| format!("<div class=\"wide\">{}</div>\n", table.html()));
        format!(
            "<h3>{title}</h3>\n<p>{}</p>\n{}{}<p class=\"note\">{}</p>\n",
            escape(&finding),
            figures(glints),
            tables.collect::<String>(),
            escape(note),
        )
    });
    format!("{}{}", include_str!("glints.html"), parts.concat())
}

/// Tables and findings for the terminal.
pub(super) fn text(glints: &Glitter) -> String {
    let parts = parts(glints).map(|Part { finding, tables, note, .. }| {
        let tables = tables.iter().map(|table| format!("\n{}", table.text()));
        format!("{}{note}\n{finding}\n", tables.collect::<String>())
    });
    format!("\nGlints\n{}", parts.concat())
}
