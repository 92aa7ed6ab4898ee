//! A folder that appears, or changes, only when all its files are written.

use std::fs::{self, File};
use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};

/// A folder to be: its files wait in a temporary one, which is removed when this is dropped.
pub(crate) struct Folder {
    target: PathBuf,
    temporary: PathBuf,
    exists: bool,
}

impl Folder {
    /// For a folder that does not exist, or for files in one that does, where `program` names the
    /// temporary one.
    pub(crate) fn new(target: &Path, program: &str) -> Result<Self, String> {
        let refused = |error: Error| refused(target, &error);
        let exists = match fs::metadata(target) {
            Ok(there) if there.is_dir() => true,
            Ok(_) => return Err(format!("--out {}: is no folder", target.display())),
            Err(error) if error.kind() == ErrorKind::NotFound => false,
            Err(error) => return Err(refused(error)),
        };
        // On the target's own disk, as renaming needs it: of a mounted folder that is in it, not
        // beside it.
        let (near, name) = if exists {
            (target.to_path_buf(), program.to_owned())
        } else {
            let name = target.file_name().ok_or_else(|| refused(ErrorKind::InvalidInput.into()))?;
            (target.with_file_name(""), name.to_string_lossy().into_owned())
        };
        let process = std::process::id();
        // Numbers of processes come again, and so may the folder of one that was killed.
        for k in 0..1000 {
            let temporary = near.join(format!(".{name}.{process}.{k}"));
            match fs::create_dir(&temporary) {
                Ok(()) => return Ok(Self { target: target.to_path_buf(), temporary, exists }),
                Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
                Err(error) => return Err(refused(error)),
            }
        }
        Err(refused(ErrorKind::AlreadyExists.into()))
    }

    /// A new file.
    pub(crate) fn create(&self, name: &str) -> Result<File, String> {
        File::create(self.temporary.join(name)).map_err(|error| self.refused(name, &error))
    }

    /// What to say of a file that cannot be written: its later name, not the one it has now.
    pub(crate) fn refused(&self, name: &str, error: &Error) -> String {
        refused(&self.target.join(name), error)
    }

    /// All files to their place; if one cannot go there, every one back. Readers may wait for the
    /// last name.
    ///
    /// Files of `stale` names go away, unless they are among the new ones: they would be taken for
    /// these files' company.
    pub(crate) fn finish(self, names: &[String], stale: Vec<String>) -> Result<(), String> {
        if !self.exists {
            return fs::rename(&self.temporary, &self.target)
                .map_err(|error| refused(&self.target, &error));
        }
        let before = self.temporary.join("before");
        fs::create_dir(&before).map_err(|error| refused(&self.target, &error))?;
        let mut moved: Vec<(PathBuf, PathBuf)> = Vec::new();
        // The last one leaves first: while it is there, it is the truth.
        let stale = stale.into_iter().filter(|name| !names.contains(name));
        let gone: Vec<String> = names.iter().rev().cloned().chain(stale).collect();
        let away = gone.iter().filter(|name| is_file(&self.target.join(name)));
        let moves = away
            .map(|name| (name, self.target.join(name), before.join(name)))
            .chain(names.iter().map(|n| (n, self.temporary.join(n), self.target.join(n))));
        for (name, from, to) in moves {
            if let Err(error) = fs::rename(&from, &to) {
                for (from, to) in moved.iter().rev() {
                    // Where that fails, too, there is nothing left to try.
                    let _ = fs::rename(to, from);
                }
                return Err(self.refused(name, &error));
            }
            moved.push((from, to));
        }
        Ok(())
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // After a rename it is not there; that it cannot be removed is no news of its own.
        let _ = fs::remove_dir_all(&self.temporary);
    }
}

/// Whether there is a file to move away; folders stay, and are in the way.
fn is_file(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|there| !there.is_dir())
}

fn refused(path: &Path, error: &Error) -> String {
    format!("--out: cannot write {}: {error}", path.display())
}
