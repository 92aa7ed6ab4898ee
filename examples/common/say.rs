//! Lines on standard error.

use std::io::Write;

/// Says one line on standard error; whether that is closed or full changes nothing.
///
/// Control characters, as in names of files, are written as escapes: a line stays one line.
pub(crate) fn say(line: &str) {
    let mut shown = String::with_capacity(line.len() + 1);
    for c in line.trim_end().chars() {
        if c.is_control() { shown.extend(c.escape_default()) } else { shown.push(c) }
    }
    shown.push('\n');
    let _ = std::io::stderr().lock().write_all(shown.as_bytes());
}
