//! The command line of examples/validate.rs: exit status, table, JSON, and mistakes in one line.

use crate::program::ROOT;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// The program; built at most once.
fn example() -> &'static Path {
    static EXAMPLE: OnceLock<PathBuf> = OnceLock::new();
    EXAMPLE.get_or_init(|| {
        let sources = ["examples/validate.rs", "tests/budget.rs", "tests/common/tables", "src"];
        crate::program::example("validate", &sources)
    })
}

fn validate(arguments: &[&str]) -> Output {
    Command::new(example()).args(arguments).output().expect("the example runs")
}

fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).expect("UTF-8")
}

/// A folder of the test's own, empty.
fn folder(name: &str) -> PathBuf {
    crate::program::folder("validate", name)
}

fn golden(stem: &str) -> String {
    fs::read_to_string(Path::new(ROOT).join("tests/golden").join(format!("{stem}.csv"))).unwrap()
}

fn stems() -> BTreeSet<String> {
    fs::read_dir(Path::new(ROOT).join("tests/golden"))
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|extension| extension == "csv"))
        .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
        .collect()
}

/// A folder with ggx_p22.csv whose first expected value is 1 % too large.
fn folder_with_one_wrong_value(name: &str) -> PathBuf {
    let table = golden("ggx_p22");
    let mut lines: Vec<String> = table.lines().map(str::to_owned).collect();
    let (inputs, expected) = lines[1].rsplit_once(',').unwrap();
    lines[1] = format!("{inputs},{:e}", expected.parse::<f64>().unwrap() * 1.01);
    let folder = folder(name);
    fs::write(folder.join("ggx_p22.csv"), lines.join("\n")).unwrap();
    folder
}

#[test]
fn shipped_tables_are_listed_twice_each_and_within_budget() {
    let output = validate(&[]);
    let table = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{table}{}", text(&output.stderr));
    assert!(output.stderr.is_empty());
    for stem in stems() {
        for precision in ["f32", "f64"] {
            let is_line =
                |line: &&str| line.split_whitespace().take(2).eq([stem.as_str(), precision]);
            assert_eq!(table.lines().filter(is_line).count(), 1, "{stem} {precision}:\n{table}");
        }
    }
    assert_eq!(table.lines().last(), Some("all tables within budget"));
}

#[test]
fn json_has_one_object_of_eight_keys_per_table_and_precision() {
    let output = validate(&["--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let value: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let mut seen = BTreeSet::new();
    for line in value.as_array().expect("an array") {
        let keys: Vec<&str> =
            line.as_object().expect("an object").keys().map(String::as_str).collect();
        let mut wanted =
            ["table", "precision", "rows", "max_rel", "p99_rel", "max_ulp", "worst_row", "bad"];
        wanted.sort_unstable();
        assert_eq!(BTreeSet::from_iter(keys), BTreeSet::from(wanted), "{line}");
        let rows = line["rows"].as_u64().expect("a count");
        let worst_row = line["worst_row"].as_u64().expect("a row");
        assert!(1 <= worst_row && worst_row <= rows, "{line}");
        assert_eq!(line["bad"].as_u64(), Some(0), "{line}");
        for error in ["max_rel", "p99_rel", "max_ulp"] {
            assert!(line[error].as_f64().is_some_and(|error| error >= 0.0), "{line}");
        }
        let name = |key: &str| line[key].as_str().expect("a string").to_owned();
        assert!(seen.insert((name("table"), name("precision"))), "twice: {line}");
    }
    let wanted = stems()
        .into_iter()
        .flat_map(|stem| ["f32", "f64"].map(|precision| (stem.clone(), precision.to_owned())));
    assert_eq!(seen, wanted.collect());
}

#[test]
fn one_value_wrong_by_a_hundredth_is_over_budget() {
    let folder = folder_with_one_wrong_value("wrong");
    let folder = folder.to_str().unwrap();
    let output = validate(&[folder]);
    let table = text(&output.stdout);
    assert_eq!(output.status.code(), Some(1), "{table}");
    for precision in ["f32", "f64"] {
        let reason = format!("over budget: ggx_p22 {precision}: max 9.9e-3");
        assert!(table.lines().any(|line| line.starts_with(&reason)), "{table}");
    }
    assert!(!table.contains("within budget"), "{table}");

    let output = validate(&["--json", folder]);
    assert_eq!(output.status.code(), Some(1));
    let value: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    for line in value.as_array().expect("an array") {
        assert_eq!(line["worst_row"], 1, "{line}");
    }
}

/// Exit status 2, nothing on stdout, and one line on stderr, which has every one of `names`.
fn assert_refused(folder: &Path, names: &[&str]) {
    let folder = folder.to_str().unwrap();
    for arguments in [[folder].as_slice(), &["--json", folder]] {
        let output = validate(arguments);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{names:?}: {message}");
        assert!(output.stdout.is_empty(), "{names:?}");
        assert!(message.ends_with('\n') && message.lines().count() == 1, "{message:?}");
        for name in names {
            assert!(message.contains(name), "`{name}` is not in {message:?}");
        }
    }
}

#[test]
fn a_missing_or_empty_folder_is_named() {
    let folder = folder("folders");
    assert_refused(&folder, &[folder.to_str().unwrap(), "no CSV"]);
    let missing = folder.join("missing");
    assert_refused(&missing, &[missing.to_str().unwrap()]);
    fs::write(folder.join("notes.txt"), "not a table").unwrap();
    assert_refused(&folder, &[folder.to_str().unwrap(), "no CSV"]);
}

#[test]
fn a_table_that_cannot_be_read_is_named_with_its_mistake() {
    const HEADER: &str = "sigma_x,sigma_y,rho,sigma_o,m_11,m_12,m_21,m_22";
    let without = HEADER.replace("rho,", "");
    let twice = HEADER.replace("rho", "sigma_x");
    for (stem, text, names) in [
        ("no_such_quantity", HEADER.to_owned(), ["no_such_quantity", "stem"].as_slice()),
        ("chermain_m", String::new(), &["empty"]),
        ("chermain_m", format!("{HEADER}\n"), &["no rows"]),
        ("chermain_m", format!("{without}\n1,1,1,1,0,0,1\n"), &["missing", "`rho`"]),
        ("chermain_m", format!("{HEADER},extra\n1,1,0,1,1,0,0,1,9\n"), &["unknown", "`extra`"]),
        ("chermain_m", format!("{twice}\n1,1,0,1,1,0,0,1\n"), &["`sigma_x`", "twice"]),
        ("chermain_m", format!("{HEADER}\n1,1,zero,1,1,0,0,1\n"), &["row 1", "`rho`", "`zero`"]),
        ("chermain_m", format!("{HEADER}\n1,1,0,1,NaN,0,0,1\n"), &["row 1", "`m_11`", "`NaN`"]),
        ("chermain_m", format!("{HEADER}\n1,1,0\n"), &["3 fields"]),
        ("chermain_m", format!("{HEADER}\n1,1,2,1,1,0,0,1\n"), &["row 1"]),
    ] {
        let folder = folder("tables");
        let file = folder.join(format!("{stem}.csv"));
        fs::write(&file, text).unwrap();
        assert_refused(&folder, &[&[file.to_str().unwrap()], names].concat());
    }
}

#[test]
fn columns_may_come_in_any_order() {
    let folder = folder("order");
    let reversed: Vec<String> = golden("chermain_m")
        .lines()
        .map(|line| line.split(',').rev().collect::<Vec<_>>().join(","))
        .collect();
    fs::write(folder.join("chermain_m.csv"), reversed.join("\n")).unwrap();
    assert_eq!(validate(&[folder.to_str().unwrap()]).status.code(), Some(0));
}
