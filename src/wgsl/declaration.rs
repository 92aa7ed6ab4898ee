//! The declarations of a text of the WGSL port.
//!
//! Layer 0. The files keep to a shape that needs no parser: a declaration begins at the start of a
//! line, under its comment, and ends with a line `}` or, for a constant or a buffer, with a
//! semicolon.

use alloc::vec::Vec;

/// A function, constant, structure or buffer.
#[derive(Clone, Copy, Debug)]
pub(super) struct Declaration {
    pub(super) name: &'static str,
    /// Comment and code.
    pub(super) whole: &'static str,
    /// The code alone.
    pub(super) code: &'static str,
}

/// What a file declares, in its order.
pub(super) fn declarations(body: &'static str) -> Vec<Declaration> {
    let mut found = Vec::new();
    // Where the comment above the next declaration begins, and that declaration's code.
    let (mut comment, mut code, mut at) = (None, None, 0);
    for line in body.split_inclusive('\n') {
        let (start, end) = (at, at + line.len());
        at = end;
        let text = line.trim_end();
        if code.is_none() {
            if ["fn ", "const ", "struct ", "@"].iter().any(|word| text.starts_with(word)) {
                code = Some(start);
            } else if text.starts_with("//") {
                comment = comment.or(Some(start));
            } else {
                comment = None;
            }
        }
        let Some(begin) = code else { continue };
        let stated = ["const ", "@"].iter().any(|word| body[begin..].starts_with(word));
        if (stated && text.ends_with(';')) || (!stated && text == "}") {
            let (whole, code_text) = (&body[comment.unwrap_or(begin)..end], &body[begin..end]);
            let name = uses(code_text).next().unwrap_or_default();
            found.push(Declaration { name, whole, code: code_text });
            (comment, code) = (None, None);
        }
    }
    found
}

/// The names with this crate's prefix in a piece of code, as they come, its own first.
pub(super) fn uses(code: &'static str) -> impl Iterator<Item = &'static str> {
    let lines = code.lines().map(|line| line.split("//").next().unwrap_or_default());
    let words =
        lines.flat_map(|line| line.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')));
    words.filter(|word| {
        word.starts_with("lobe_") || word.starts_with("Lobe") || word.starts_with("LOBE_")
    })
}
