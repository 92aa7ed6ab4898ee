//! Files that appear whole or not at all.

use std::fs;
use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};

/// The name under which a file is written, beside its own.
fn unfinished(path: &Path) -> Result<PathBuf, Error> {
    let name = path.file_name().ok_or(ErrorKind::IsADirectory)?;
    let mut name = name.to_owned();
    name.push(format!(".{}.tmp", std::process::id()));
    Ok(path.with_file_name(name))
}

/// Fails if `path` cannot be written, and leaves nothing behind.
pub(crate) fn check(path: &Path) -> Result<(), Error> {
    if path.is_dir() {
        return Err(ErrorKind::IsADirectory.into());
    }
    let beside = unfinished(path)?;
    fs::write(&beside, "")?;
    fs::remove_file(&beside)
}

/// Writes the text beside `path`, then renames it: a reader sees the old file or the new one.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), Error> {
    let beside = unfinished(path)?;
    let written = fs::write(&beside, text).and_then(|()| fs::rename(&beside, path));
    if written.is_err() {
        // What is left of it is no news of its own.
        let _ = fs::remove_file(&beside);
    }
    written
}
