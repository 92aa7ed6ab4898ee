//! The page's files: checked before the work, each written whole or not at all.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::options::Mistake;

/// Where the page goes.
pub(crate) struct Output {
    folder: PathBuf,
}

/// Name of the page.
pub(crate) const PAGE: &str = "index.html";

/// Name of the results for programs.
pub(crate) const DATA: &str = "report.json";

/// Name of the advice as a Markdown table.
pub(crate) const ADVICE: &str = "advice.md";

/// Name of the picture: one scene unfiltered, filtered, and as it should be.
pub(crate) const COVER: &str = "cover.png";

impl Output {
    /// Makes the folder and proves that a file can be written there.
    pub(crate) fn prepare(folder: &Path) -> Result<Self, Mistake> {
        let output = Self { folder: folder.into() };
        let refused = |error: &dyn std::fmt::Display| {
            Mistake(format!("--out '{}': cannot be written to ({error})", folder.display()))
        };
        fs::create_dir_all(folder).map_err(|error| refused(&error))?;
        for name in [PAGE, COVER, DATA, ADVICE] {
            if folder.join(name).is_dir() {
                return Err(refused(&format!("{name} is a folder there")));
            }
        }
        let trial = output.unfinished(PAGE);
        fs::write(&trial, "").and_then(|()| fs::remove_file(&trial)).map_err(|e| refused(&e))?;
        Ok(output)
    }

    /// Writes a file under another name, then renames it: a reader sees the old one or the new one.
    pub(crate) fn write(&self, name: &str, content: &[u8]) -> Result<PathBuf, Mistake> {
        let (unfinished, finished) = (self.unfinished(name), self.folder.join(name));
        let written: io::Result<()> =
            fs::write(&unfinished, content).and_then(|()| fs::rename(&unfinished, &finished));
        match written {
            Ok(()) => Ok(finished),
            Err(error) => {
                // Whether or not this succeeds, the first error is the one to report.
                let _ = fs::remove_file(&unfinished);
                Err(Mistake(format!("--out '{}': {error}", self.folder.display())))
            }
        }
    }

    /// A name that no other run uses at the same time.
    fn unfinished(&self, name: &str) -> PathBuf {
        self.folder.join(format!(".{name}.{}", std::process::id()))
    }
}
