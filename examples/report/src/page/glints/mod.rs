//! Glints on the page: cells, times, means, variances, error against run time; the same as text.

mod charts;
mod costs;
mod finding;
mod hall;
mod tables;

use super::escape;
use super::table::Table;
use crate::glints::Glitter;

/// Pictures, charts, tables and what they say.
pub(super) fn html(glints: &Glitter) -> String {
    let part = |title: &str, finding: String, figures: String, tables: &[Table], note: &str| {
        let tables =
            tables.iter().map(|table| format!("<div class=\"wide\">{}</div>\n", table.html()));
        format!(
            "<h3>{title}</h3>\n<p>{}</p>\n{figures}{}<p class=\"note\">{}</p>\n",
            escape(&finding),
            tables.collect::<Vec<_>>().concat(),
            escape(note),
        )
    };
    [
        include_str!("glints.html").into(),
        part(
            "Cells of a pixel",
            finding::cells(glints),
            hall::pictures(&glints.hall) + &charts::cells(glints),
            &[],
            costs::CELLS_NOTE,
        ),
        part(
            "Time",
            finding::times(glints),
            charts::times(glints),
            &[costs::times(glints)],
            costs::TIMES_NOTE,
        ),
        part(
            "One cell in operations and instructions",
            finding::counts(glints),
            String::new(),
            &[costs::operations(glints), costs::instructions(glints)],
            costs::COUNTS_NOTE,
        ),
        part(
            "The mean",
            finding::means(glints),
            String::new(),
            &[tables::means(glints), tables::gains(glints)],
            tables::MEANS_NOTE,
        ),
        part(
            "The variance",
            finding::variances(glints),
            charts::ripple(glints),
            &[tables::variances(glints)],
            tables::VARIANCES_NOTE,
        ),
        part(
            "Error against run time",
            finding::contests(glints),
            charts::contests(glints),
            &[costs::contests(glints)],
            costs::CONTESTS_NOTE,
        ),
    ]
    .concat()
}

/// Tables and findings for the terminal.
pub(super) fn text(glints: &Glitter) -> String {
    let part = |finding: String, tables: &[Table], note: &str| {
        let tables = tables.iter().map(|table| format!("\n{}", table.text()));
        format!("{}{note}\n{finding}\n", tables.collect::<Vec<_>>().concat())
    };
    [
        "\nGlints\n".into(),
        part(finding::cells(glints), &[costs::cells(glints)], costs::CELLS_NOTE),
        part(finding::times(glints), &[costs::times(glints)], costs::TIMES_NOTE),
        part(
            finding::counts(glints),
            &[costs::operations(glints), costs::instructions(glints)],
            costs::COUNTS_NOTE,
        ),
        part(
            finding::means(glints),
            &[tables::means(glints), tables::gains(glints)],
            tables::MEANS_NOTE,
        ),
        part(finding::variances(glints), &[tables::variances(glints)], tables::VARIANCES_NOTE),
        part(finding::contests(glints), &[costs::contests(glints)], costs::CONTESTS_NOTE),
    ]
    .concat()
}
