//! An example's program, as a user runs it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::SystemTime;

/// The package's root.
pub(crate) const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// The latest change of a file, or of any below a folder.
fn changed(path: &Path) -> SystemTime {
    let modified = fs::metadata(path).and_then(|data| data.modified()).expect("a readable path");
    if !path.is_dir() {
        return modified;
    }
    let entries = fs::read_dir(path).expect("a readable folder");
    entries.map(|entry| changed(&entry.expect("an entry").path())).max().unwrap_or(modified)
}

/// The program, made of these files and folders.
///
/// `cargo test` builds examples beside the tests, `cargo test --test NAME` does not: then an absent
/// or outdated one is built here, in the same profile.
pub(crate) fn example(name: &str, sources: &[&str]) -> PathBuf {
    let test = std::env::current_exe().expect("the path of this test");
    let profile = test.ancestors().nth(2).expect("target/PROFILE/deps/TEST");
    let example = profile.join("examples").join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    let newest = sources.iter().map(|source| changed(&Path::new(ROOT).join(source))).max();
    let built = fs::metadata(&example).and_then(|data| data.modified()).ok();
    if built < newest {
        build(name, profile);
    }
    assert!(example.is_file(), "{} was not built", example.display());
    example
}

/// A folder of a test's own, empty, below one of its program's.
pub(crate) fn folder(program: &str, name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(program).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn build(example: &str, profile: &Path) {
    // The folder of `cargo test` is `debug`, its profile `test`.
    let name = profile.file_name().and_then(|name| name.to_str()).expect("a profile's folder");
    let name = if name == "debug" { "test" } else { name };
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .current_dir(ROOT)
        .args(["build", "--example", example, "--profile", name, "--target-dir"])
        .arg(profile.parent().expect("a target folder"))
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
