//! The page's files: checked before the work, written all or none.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use crate::options::Mistake;

/// Where the page goes.
pub(crate) struct Output {
    folder: PathBuf,
    /// Whether it was not there before.
    made: bool,
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
        let output = Self { folder: folder.into(), made: !folder.exists() };
        let refused = |error: &dyn std::fmt::Display| {
            Mistake(format!("--out '{}': cannot be written to ({error})", folder.display()))
        };
        if folder.exists() && !folder.is_dir() {
            return Err(Mistake(format!("--out '{}': is no folder", folder.display())));
        }
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

    /// Writes files under other names, then renames them: a reader sees the old ones or the new
    /// ones.
    pub(crate) fn write(&self, files: &[(&str, Vec<u8>)]) -> Result<(), Mistake> {
        let each = |f: &dyn Fn(&str, &[u8]) -> io::Result<()>| {
            files.iter().try_for_each(|(name, content)| f(name, content))
        };
        let written = each(&|name, content| fs::write(self.unfinished(name), content));
        let placed = written
            .and_then(|()| each(&|name, _| fs::rename(self.unfinished(name), self.path(name))));
        placed.map_err(|error| {
            // Whether or not the rest succeeds, the first error is the one to report.
            for (name, _) in files {
                let _ = fs::remove_file(self.unfinished(name));
            }
            if self.made {
                let _ = fs::remove_dir(&self.folder);
            }
            Mistake(format!("--out '{}': {error}", self.folder.display()))
        })
    }

    /// Where a file goes.
    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.folder.join(name)
    }

    /// A name that no other run uses at the same time.
    fn unfinished(&self, name: &str) -> PathBuf {
        self.folder.join(format!(".{name}.{}", std::process::id()))
    }
}
