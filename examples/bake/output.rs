//! A folder that appears, or changes, only when all its files are written.

use std::fs::{self, File};
use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};

/// The file in which a reader finds the others.
pub(crate) const DESCRIPTION: &str = "moments.json";

/// A folder to be: its files wait in a temporary one, which is removed when this is dropped.
pub(crate) struct Folder {
    target: PathBuf,
    temporary: PathBuf,
    exists: bool,
}

impl Folder {
    /// For a folder that does not exist, or for files in one that does.
    pub(crate) fn new(target: &Path) -> Result<Self, String> {
        let refused = |error: Error| refused(target, &error);
        let exists = match fs::metadata(target) {
            Ok(there) if there.is_dir() => true,
            Ok(_) => return Err(format!("--out {}: is no folder", target.display())),
            Err(error) if error.kind() == ErrorKind::NotFound => false,
            Err(error) => return Err(refused(error)),
        };
        // On the target's own disk, as renaming needs it: of a mounted folder that is in it, not beside it.
        let (near, name) = if exists {
            (target.to_path_buf(), "bake".to_owned())
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

    /// A new file with its text.
    pub(crate) fn write(&self, name: &str, text: &str) -> Result<(), String> {
        fs::write(self.temporary.join(name), text).map_err(|error| self.refused(name, &error))
    }

    /// What to say of a file that cannot be written: its later name, not the one it has now.
    pub(crate) fn refused(&self, name: &str, error: &Error) -> String {
        refused(&self.target.join(name), error)
    }

    /// All files to their place; if one cannot go there, every one back. Readers may wait for the last name.
    pub(crate) fn finish(self, names: &[String]) -> Result<(), String> {
        if !self.exists {
            return fs::rename(&self.temporary, &self.target)
                .map_err(|error| refused(&self.target, &error));
        }
        let before = self.temporary.join("before");
        fs::create_dir(&before).map_err(|error| refused(&self.target, &error))?;
        let mut moved: Vec<(PathBuf, PathBuf)> = Vec::new();
        // The last one leaves first: while it is there, it is the truth. Levels of a larger map would be taken for this one's.
        let stale = described(&self.target.join(DESCRIPTION));
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

/// The files of a baked map by its description; none where there is none.
fn described(description: &Path) -> Vec<String> {
    let text = fs::read_to_string(description).unwrap_or_default();
    let known: serde_json::Value = serde_json::from_str(&text).unwrap_or_default();
    let levels = known["levels"].as_array().into_iter().flatten();
    let names = levels.flat_map(|level| ["mean", "second", "raw"].map(|part| level[part].as_str()));
    // Names, not paths: a description that someone else wrote must not reach out of its folder.
    let plain = |name: &&str| Path::new(name).file_name().is_some_and(|file| file == *name);
    names.flatten().filter(plain).map(str::to_owned).collect()
}

/// Whether there is a file to move away; folders stay, and are in the way.
fn is_file(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|there| !there.is_dir())
}

fn refused(path: &Path, error: &Error) -> String {
    format!("--out: cannot write {}: {error}", path.display())
}
