//! Tables: one set of cells, as aligned text and as HTML.

use super::escape;

/// Rows of cells under headers; the first column is text, the others are numbers.
pub(super) struct Table {
    pub(super) headers: &'static [&'static str],
    pub(super) rows: Vec<Line>,
}

/// A row, and whether it stands out.
pub(super) struct Line {
    pub(super) cells: Vec<String>,
    /// CSS class of the row; empty for none.
    pub(super) class: &'static str,
}

impl Table {
    /// Aligned with spaces, one line per row.
    pub(super) fn text(&self) -> String {
        let width = |column: usize| {
            let cells = self.rows.iter().map(|row| row.cells[column].chars().count());
            cells.chain([self.headers[column].chars().count()]).max().unwrap_or(0)
        };
        let widths: Vec<_> = (0..self.headers.len()).map(width).collect();
        let line = |cells: &mut dyn Iterator<Item = &str>| {
            let padded = cells.zip(&widths).enumerate().map(|(column, (cell, &width))| {
                if column == 0 { format!("{cell:width$}") } else { format!("  {cell:>width$}") }
            });
            padded.collect::<Vec<_>>().concat().trim_end().to_owned() + "\n"
        };
        let head = line(&mut self.headers.iter().copied());
        let body = self.rows.iter().map(|row| line(&mut row.cells.iter().map(String::as_str)));
        [head].into_iter().chain(body).collect::<Vec<_>>().concat()
    }

    /// As a Markdown table.
    pub(super) fn markdown(&self) -> String {
        let row = |cells: &mut dyn Iterator<Item = &str>| {
            let cells = cells.map(|cell| format!(" {} |", cell.replace('|', "\\|")));
            format!("|{}\n", cells.collect::<Vec<_>>().concat())
        };
        let head = row(&mut self.headers.iter().copied());
        let rule = format!("|{}\n", "---|".repeat(self.headers.len()));
        let body = self.rows.iter().map(|line| row(&mut line.cells.iter().map(String::as_str)));
        [head, rule].into_iter().chain(body).collect::<Vec<_>>().concat()
    }

    /// As a table element.
    pub(super) fn html(&self) -> String {
        let row = |tag: &str, cells: &mut dyn Iterator<Item = &str>| {
            let cells = cells.map(|cell| format!("<{tag}>{}</{tag}>", escape(cell)));
            cells.collect::<Vec<_>>().concat()
        };
        let head = row("th", &mut self.headers.iter().copied());
        let lines = self.rows.iter().map(|line| {
            let cells = row("td", &mut line.cells.iter().map(String::as_str));
            format!("<tr class=\"{}\">{cells}</tr>\n", line.class)
        });
        let body = lines.collect::<Vec<_>>().concat();
        format!(
            "<div class=\"scroll\"><table>\n<thead><tr>{head}</tr></thead>\n\
             <tbody>\n{body}</tbody>\n</table></div>\n"
        )
    }
}

/// A number with three significant digits, in plain notation from 0.0001 to 10 million.
pub(super) fn significant(x: f64) -> String {
    if x == 0.0 {
        return "0".into();
    }
    if !x.is_finite() {
        return "\u{2013}".into();
    }
    let exponent = x.abs().log10().floor() as i32;
    if !(-4..7).contains(&exponent) {
        return format!("{x:.1e}");
    }
    let decimals = (2 - exponent).max(0).unsigned_abs() as usize;
    format!("{x:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::{Line, Table, significant};

    #[test]
    fn three_significant_digits() {
        let cases = [
            (0.0, "0"),
            (0.001_234, "0.00123"),
            (1.5, "1.50"),
            (99.94, "99.9"),
            (12_345.6, "12346"),
            (1e-9, "1.0e-9"),
            (f64::NAN, "\u{2013}"),
        ];
        for (x, text) in cases {
            assert_eq!(significant(x), text);
        }
    }

    #[test]
    fn tables_are_aligned_text_and_escaped_html_and_markdown() {
        let line = |a: &str, b: &str| Line { cells: vec![a.into(), b.into()], class: "" };
        let table =
            Table { headers: &["name", "ns"], rows: vec![line("a<b", "1234"), line("c", "5")] };
        assert_eq!(table.text(), "name    ns\na<b   1234\nc        5\n");
        assert!(table.html().contains("a&lt;b"));
        assert_eq!(table.markdown(), "| name | ns |\n|---|---|\n| a<b | 1234 |\n| c | 5 |\n");
    }
}
