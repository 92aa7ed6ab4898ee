//! The page's file: checked before the work, written whole or not at all.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::options::Mistake;

/// Where the page goes.
pub(crate) struct Output {
    folder: PathBuf,
}

/// Name of the page.
const PAGE: &str = "index.html";

impl Output {
    /// Makes the folder and proves that a file can be written there.
    pub(crate) fn prepare(folder: &Path) -> Result<Self, Mistake> {
        let output = Self { folder: folder.into() };
        let refused = |error: &dyn std::fmt::Display| {
            Mistake(format!("--out '{}': cannot be written to ({error})", folder.display()))
        };
        fs::create_dir_all(folder).map_err(|error| refused(&error))?;
        if output.page().is_dir() {
            return Err(refused(&format!("{PAGE} is a folder there")));
        }
        let trial = output.unfinished();
        fs::write(&trial, "").and_then(|()| fs::remove_file(&trial)).map_err(|e| refused(&e))?;
        Ok(output)
    }

    /// Writes the page under another name, then renames it: a reader sees the old page or the new one.
    pub(crate) fn write(&self, html: &str) -> Result<PathBuf, Mistake> {
        let unfinished = self.unfinished();
        let written: io::Result<()> =
            fs::write(&unfinished, html).and_then(|()| fs::rename(&unfinished, self.page()));
        match written {
            Ok(()) => Ok(self.page()),
            Err(error) => {
                // Whether or not this succeeds, the first error is the one to report.
                let _ = fs::remove_file(&unfinished);
                Err(Mistake(format!("--out '{}': {error}", self.folder.display())))
            }
        }
    }

    fn page(&self) -> PathBuf {
        self.folder.join(PAGE)
    }

    /// A name that no other run uses at the same time.
    fn unfinished(&self) -> PathBuf {
        self.folder.join(format!(".{PAGE}.{}", std::process::id()))
    }
}
