//! Texts, words and folders: printed, or written all at once.

use super::print::print;
use super::translate::Translation;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// What the program was asked for.
pub(crate) enum Output {
    Text(String),
    /// SPIR-V.
    Words(Vec<u32>),
    /// Paths and texts, in the order in which a linker takes them.
    Files(Vec<(String, String)>),
}

impl Output {
    /// To standard output, or to a path.
    pub(crate) fn put(self, path: Option<&Path>) -> Result<(), String> {
        match path {
            None => print(&self.printed()),
            Some(path) => self
                .write(path)
                .map_err(|error| format!("cannot write {}: {error}", path.display())),
        }
    }

    fn printed(self) -> String {
        match self {
            Self::Text(text) => text,
            Self::Words(words) => Translation::Words(words).text(),
            Self::Files(files) => {
                let texts: Vec<String> =
                    files.iter().map(|(path, text)| format!("// {path}\n{text}")).collect();
                texts.join("\n")
            }
        }
    }

    /// Everything under a temporary name, which is then changed: no reader ever sees a part.
    ///
    /// What is no plain file (a device, a pipe, a link) stays what it is, and is written to.
    fn write(&self, path: &Path) -> std::io::Result<()> {
        let special =
            fs::symlink_metadata(path).is_ok_and(|there| !there.is_file() && !there.is_dir());
        let temporary = if special { path.to_path_buf() } else { beside(path)? };
        let written = match self {
            Self::Text(text) => fs::write(&temporary, text),
            Self::Words(words) => {
                let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
                fs::write(&temporary, bytes)
            }
            // Files of the folder that it had before would be imported too.
            Self::Files(_) if path.exists() => Err(std::io::Error::new(
                ErrorKind::AlreadyExists,
                "several files need a folder that does not exist",
            )),
            Self::Files(files) => files.iter().try_for_each(|(name, text)| {
                let file = temporary.join(name);
                fs::create_dir_all(file.parent().unwrap_or(&temporary))?;
                fs::write(file, text)
            }),
        };
        if special {
            return written;
        }
        let done = written.and_then(|()| fs::rename(&temporary, path));
        if done.is_err() {
            // What remains is not the caller's; that it cannot be removed is no news of its own.
            let _ = fs::remove_file(&temporary).or_else(|_| fs::remove_dir_all(&temporary));
        }
        done
    }
}

/// A name beside a path, on the same disk.
fn beside(path: &Path) -> std::io::Result<PathBuf> {
    let name = path.file_name().ok_or_else(|| {
        std::io::Error::new(ErrorKind::InvalidInput, "the path does not end in a name")
    })?;
    let temporary = format!(".{}.{}", name.to_string_lossy(), std::process::id());
    Ok(path.with_file_name(temporary))
}
