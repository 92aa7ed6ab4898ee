//! Parts of a section: one thing that is measured, what it shows and what that says; on the page
//! and as text.

use super::escape;
use super::table::Table;

/// One thing that is measured, of what `T` holds.
pub(super) struct Part<T> {
    pub(super) title: &'static str,
    pub(super) finding: String,
    /// On the page alone: pictures and charts.
    pub(super) figures: fn(&T) -> String,
    pub(super) tables: Vec<Table>,
    /// Whether the figures show all that the tables have: then they are for the terminal.
    pub(super) drawn: bool,
    pub(super) note: &'static str,
}

impl<T> Part<T> {
    /// Pictures, charts, tables and what they say.
    pub(super) fn html(&self, measured: &T) -> String {
        let tables = self.tables.iter().filter(|_| !self.drawn);
        let tables = tables.map(|table| format!("<div class=\"wide\">{}</div>\n", table.html()));
        format!(
            "<h3>{}</h3>\n<p>{}</p>\n{}{}<p class=\"note\">{}</p>\n",
            self.title,
            escape(&self.finding),
            (self.figures)(measured),
            tables.collect::<String>(),
            escape(self.note),
        )
    }

    /// Tables and the finding for the terminal.
    pub(super) fn text(&self) -> String {
        let tables = self.tables.iter().map(|table| format!("\n{}", table.text()));
        format!("{}{}\n{}\n", tables.collect::<String>(), self.note, self.finding)
    }
}
