//! Tests by folder: a file that its folder's `main.rs` does not name is never compiled, and its
//! tests never run.

use std::fs;
use std::path::Path;

/// Folders of one binary each, from the root of the repository.
const FOLDERS: [&str; 4] = ["tests/laws", "tests/texts", "tests/tools", "tests/gpu/tests"];

#[test]
fn every_file_has_its_line_in_main() {
    for name in FOLDERS {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
        let main = fs::read_to_string(folder.join("main.rs")).expect("a readable file");
        let mut count = 0;
        for entry in fs::read_dir(&folder).expect("a readable folder") {
            let path = entry.expect("a readable entry").path();
            let stem = path.file_stem().and_then(|stem| stem.to_str()).expect("a name in UTF-8");
            if path.extension().is_none_or(|extension| extension != "rs") || stem == "main" {
                continue;
            }
            let line = format!("mod {stem};");
            assert!(main.lines().any(|other| other == line), "{name}/main.rs has no `{line}`");
            count += 1;
        }
        assert!(count > 3, "{name}: only {count} files");
    }
}
