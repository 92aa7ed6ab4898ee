//! Texts in the repository that tests compute: compared, or written anew with `LOBE_WRITE=1`.

use std::{env, fs};

/// Holds the file at `path`, below the root of the repository, to `text`.
#[track_caller]
pub(crate) fn written(path: &str, text: &str) {
    let file = format!("{}/{path}", env!("CARGO_MANIFEST_DIR"));
    if env::var_os("LOBE_WRITE").is_some() {
        fs::write(&file, text).unwrap_or_else(|error| panic!("{path}: {error}"));
    }
    let found = fs::read_to_string(&file).unwrap_or_default();
    let differs = |(a, b): &(&str, &str)| a != b;
    let first = found.lines().zip(text.lines()).find(differs);
    assert!(
        found == text,
        "{path} is not what the sources say: {} lines, not {}; first difference, file against \
         sources: {first:?}. If the change is meant: LOBE_WRITE=1 cargo test --test texts",
        found.lines().count(),
        text.lines().count()
    );
}
