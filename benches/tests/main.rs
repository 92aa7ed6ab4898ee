//! The bench's own options, and the files that it writes.

#[path = "../speed/options.rs"]
#[allow(dead_code, reason = "shared with the bench")]
mod options;
#[path = "../speed/output.rs"]
mod output;

use std::fs;
use std::path::{Path, PathBuf};

fn split(line: &str) -> (Vec<String>, Vec<String>) {
    options::split(line.split_whitespace().map(str::to_owned))
}

/// A folder of this test's own, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

#[test]
fn options_are_told_apart_in_any_order() {
    let lines = [
        "--quick --json a.json ggx_full --rows-only --bench",
        "--rows-only --quick --json=a.json ggx_full --bench",
    ];
    for line in lines {
        let (own, other) = split(line);
        assert_eq!(other, ["--quick", "ggx_full", "--bench"], "{line}");
        let parsed = options::parse(&own).expect("valid options");
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("a workspace");
        assert_eq!(parsed.json.as_deref(), Some(root.join("a.json").as_path()), "{line}");
        assert!(parsed.rows_only && parsed.ladder.is_none(), "{line}");
    }
}

#[test]
fn an_option_without_its_file_is_refused() {
    for line in ["--json", "--json --quick", "--ladder --bench", "--json a --json b"] {
        let (own, _) = split(line);
        assert!(options::parse(&own).is_err(), "{line}");
    }
    assert!(options::parse(&split("--quick --bench").0).expect("none").is_empty());
}

#[test]
fn files_appear_whole_or_not_at_all() {
    let folder = folder("whole");
    let file = folder.join("rows.json");
    output::check(&file).expect("a folder that can be written to");
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 0);
    for text in ["first", "second"] {
        output::write(&file, text).expect("written");
        assert_eq!(fs::read_to_string(&file).expect("a file"), text);
    }
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 1);
    for refused in [folder.clone(), folder.join("none").join("rows.json"), PathBuf::from("/")] {
        assert!(output::check(&refused).is_err(), "{}", refused.display());
    }
}
