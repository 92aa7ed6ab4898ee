//! The command line of examples/validate.rs: exit status, table, JSON, and mistakes in one line.

use crate::program::ROOT;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

/// The program; built at most once.
fn example() -> &'static Path {
    static EXAMPLE: OnceLock<PathBuf> = OnceLock::new();
    EXAMPLE.get_or_init(|| {
        let sources = [
            "examples/validate.rs",
            "tests/budget.rs",
            "tests/common/roundings.rs",
            "tests/common/tables",
            "src",
        ];
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

/// Tables that are judged by both promises: densities, areas, masking and BRDFs by shapes of matrix
/// entries.
const WITH_SHAPES: [&str; 10] = [
    "beckmann_brdf",
    "beckmann_d",
    "beckmann_lambda",
    "beckmann_p22",
    "beckmann_projected_area",
    "ggx_brdf",
    "ggx_d",
    "ggx_lambda",
    "ggx_p22",
    "ggx_projected_area",
];

/// Table, precision and promise of every line for the golden tables.
fn lines_of_golden_tables() -> BTreeSet<[String; 3]> {
    let mut lines = BTreeSet::new();
    for stem in stems() {
        let both = WITH_SHAPES.contains(&stem.as_str());
        let promises = if both { ["forward", "backward"].as_slice() } else { &["forward"] };
        for promise in promises {
            for precision in ["f32", "f64"] {
                lines.insert([stem.as_str(), precision, promise].map(str::to_owned));
            }
        }
    }
    lines
}

#[test]
fn shipped_tables_have_a_line_for_each_promise_and_precision_and_are_within_budget() {
    let output = validate(&[]);
    let table = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{table}{}", text(&output.stderr));
    assert!(output.stderr.is_empty());
    let wanted = lines_of_golden_tables();
    for line in &wanted {
        let is_line = |other: &&str| other.split_whitespace().take(3).eq(line);
        assert_eq!(table.lines().filter(is_line).count(), 1, "{line:?}:\n{table}");
    }
    // A header, and a verdict.
    assert_eq!(table.lines().count(), wanted.len() + 2, "{table}");
    assert_eq!(table.lines().last(), Some("all tables within budget"));
}

#[test]
fn json_has_one_object_per_table_promise_and_precision() {
    let output = validate(&["--json"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let value: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let mut seen = BTreeSet::new();
    for line in value.as_array().expect("an array") {
        let keys: Vec<&str> =
            line.as_object().expect("an object").keys().map(String::as_str).collect();
        let mut wanted = [
            "table",
            "precision",
            "promise",
            "rows",
            "max_rel",
            "p99_rel",
            "max_ulp",
            "max_eps",
            "worst_row",
            "bad",
            "rounded",
            "first_rounded",
            "left_out",
        ];
        wanted.sort_unstable();
        assert_eq!(BTreeSet::from_iter(keys), BTreeSet::from(wanted), "{line}");
        let rows = line["rows"].as_u64().expect("a count");
        let worst_row = line["worst_row"].as_u64().expect("a row");
        assert!(1 <= worst_row && worst_row <= rows, "{line}");
        for none in ["bad", "rounded", "left_out"] {
            assert_eq!(line[none].as_u64(), Some(0), "{line}");
        }
        assert!(line["first_rounded"].is_null(), "{line}");
        for error in ["max_rel", "p99_rel", "max_ulp"] {
            assert!(line[error].as_f64().is_some_and(|error| error >= 0.0), "{line}");
        }
        let name = |key: &str| line[key].as_str().expect("a string").to_owned();
        let key = ["table", "precision", "promise"].map(name);
        assert!(seen.insert(key.clone()), "twice: {line}");
        let eps = line["max_eps"].as_f64();
        let judged = eps.is_some_and(|eps| (1.0..=16.0).contains(&eps) && eps.log2() % 1.0 == 0.0);
        let forward = key[2] == "forward";
        assert!(if forward { line["max_eps"].is_null() } else { judged }, "{line}");
    }
    assert_eq!(seen, lines_of_golden_tables());
}

#[test]
fn one_value_wrong_by_a_hundredth_is_over_budget() {
    let folder = folder_with_one_wrong_value("wrong");
    let folder = folder.to_str().unwrap();
    let output = validate(&[folder]);
    let table = text(&output.stdout);
    assert_eq!(output.status.code(), Some(1), "{table}");
    for precision in ["f32", "f64"] {
        let reason = format!("over budget: ggx_p22 {precision} forward: max 9.9e-3");
        assert!(table.lines().any(|line| line.starts_with(&reason)), "{table}");
        // The lobe is wide, so moving inputs by roundings does not change the value by a hundredth.
        let reason = format!("over budget: ggx_p22 {precision} backward: inf eps > 16");
        assert!(table.lines().any(|line| line == reason), "{table}");
    }
    assert!(!table.contains("within budget"), "{table}");

    let output = validate(&["--json", folder]);
    assert_eq!(output.status.code(), Some(1));
    let value: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    for line in value.as_array().expect("an array") {
        assert_eq!(line["worst_row"], 1, "{line}");
        let eps = if line["promise"] == "backward" { f64::MAX.into() } else { Value::Null };
        assert_eq!(line["max_eps"], eps, "{line}");
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
    assert_refused(&folder, &[folder.to_str().unwrap(), "no CSV", "empty"]);
    let missing = folder.join("missing");
    assert_refused(&missing, &[missing.to_str().unwrap()]);
    let notes = folder.join("notes.txt");
    fs::write(&notes, "not a table").unwrap();
    assert_refused(&folder, &[folder.to_str().unwrap(), "no CSV", "only notes.txt"]);
    assert_refused(&notes, &[notes.to_str().unwrap(), "a file, not a directory"]);
    fs::create_dir(folder.join("chermain_m.csv")).unwrap();
    assert_refused(&folder, &["no CSV", "2 other files", "chermain_m.csv/"]);
}

const HEADER: &str = "sigma_x,sigma_y,rho,sigma_o,m_11,m_12,m_21,m_22";

#[test]
fn a_table_that_cannot_be_read_is_named_with_its_mistake() {
    let without = HEADER.replace("rho,", "");
    let twice = HEADER.replace("rho", "sigma_x");
    let long = "9".repeat(99) + "x";
    for (stem, text, names) in [
        ("no_such_quantity", HEADER.to_owned(), ["no_such_quantity", "stem"].as_slice()),
        ("chermain_m", String::new(), &["empty"]),
        ("chermain_m", "\n\n# nothing\n".into(), &["empty"]),
        ("chermain_m", format!("{HEADER}\n"), &["no rows"]),
        ("chermain_m", format!("{without}\n1,1,1,1,0,0,1\n"), &["missing", "`rho`"]),
        ("chermain_m", format!("{HEADER},extra\n1,1,0,1,1,0,0,1,9\n"), &["unknown", "`extra`"]),
        ("chermain_m", format!("{twice}\n1,1,0,1,1,0,0,1\n"), &["`sigma_x`", "twice"]),
        (
            "chermain_m",
            format!("{HEADER}\n1,1,zero,1,1,0,0,1\n"),
            &["line 2", "row 1", "`rho`", "`zero`"],
        ),
        (
            "chermain_m",
            format!("{HEADER}\n1,1,0,1,NaN,0,0,1\n"),
            &["row 1", "`m_11`", "`NaN`", "finite"],
        ),
        ("chermain_m", format!("{HEADER}\n1,1,0\n"), &["line 2", "3 fields", "8"]),
        ("chermain_m", format!("{HEADER}\n1,1,2,1,1,0,0,1\n"), &["line 2", "row 1"]),
        // Blank lines and comments count as lines.
        (
            "chermain_m",
            format!("# mine\n\n{HEADER}\n\n  \n# row\n1,1,0,1,1,0,0,inf\n"),
            &["line 7", "row 1", "`m_22`", "`inf`"],
        ),
        (
            "chermain_m",
            format!("{HEADER}\r\n1,1,0,1,1,0,0,1\r\n1,1,0,,1,0,0,1\r\n"),
            &["line 3", "row 2", "`sigma_o`", "``"],
        ),
        (
            "chermain_m",
            format!("\u{feff}{HEADER}\n1,1,0,1,1e400,0,0,1\n"),
            &["`m_11`", "`1e400`", "larger than any f64"],
        ),
        (
            "chermain_m",
            format!("{HEADER}\n1,-1e-400,0,1,1,0,0,1\n"),
            &["`sigma_y`", "`-1e-400`", "smaller than any f64"],
        ),
        (
            "chermain_m",
            format!("{HEADER}\n1,1,0,1,0x1.8,0x,0,1\n"),
            &["`m_12`", "`0x`", "not a number"],
        ),
        ("chermain_m", HEADER.replace(',', ";") + "\n1;1;0;1;1;0;0;1\n", &["semicolons"]),
        ("chermain_m", HEADER.replace(',', "\t") + "\n", &["tabs"]),
        (
            "chermain_m",
            format!("{HEADER}\n1,5,1,5,0,5,1,0,1,0,0,0,0,0,1,0\n"),
            &["line 2", "16 fields", "decimal point"],
        ),
        ("chermain_m", format!("{HEADER}\n\"1,5\",1,0,1,1,0,0,1\n"), &["`sigma_x`", "`1,5`"]),
        ("chermain_m", format!("{HEADER}\n1,1,0,1,1,0,0,\"1\n2\"\n"), &["line 2", "quote"]),
        ("chermain_m", format!("{HEADER}\n{long},1,0,1,1,0,0,1\n"), &["`sigma_x`", "9999...`"]),
        (
            "chermain_m",
            format!("\u{feff}{HEADER}\n1,1,0,1,1,0,0,\u{2212}1\n"),
            &["`m_22`", "`\u{2212}1`"],
        ),
    ] {
        let folder = folder("tables");
        let file = folder.join(format!("{stem}.csv"));
        fs::write(&file, text).unwrap();
        assert_refused(&folder, &[&[file.to_str().unwrap()], names].concat());
    }
    let folder = folder("tables");
    let file = folder.join("chermain_m.csv");
    let wide: Vec<u8> =
        format!("\u{feff}{HEADER}\n").encode_utf16().flat_map(u16::to_le_bytes).collect();
    fs::write(&file, wide).unwrap();
    assert_refused(&folder, &[file.to_str().unwrap(), "not UTF-8"]);
}

/// A table rewritten field by field: its header, and what makes a field of each number.
fn rewritten(stem: &str, number: impl Fn(&str, f64) -> String) -> String {
    let table = golden(stem);
    let (header, rows) = table.split_once('\n').unwrap();
    let names: Vec<&str> = header.split(',').collect();
    let row = |row: &str| {
        let fields = row.split(',').zip(&names);
        fields
            .map(|(field, name)| number(name, field.parse().unwrap()))
            .collect::<Vec<_>>()
            .join(",")
    };
    let rows: Vec<String> = rows.lines().map(row).collect();
    format!("{header}\n{}\n", rows.join("\n"))
}

/// As C's `%a` writes it.
fn hexadecimal(x: f64) -> String {
    let sign = if x.is_sign_negative() { "-" } else { "" };
    let (exponent, fraction) = ((x.to_bits() >> 52) & 0x7ff, x.to_bits() & ((1 << 52) - 1));
    match exponent {
        0 => format!("{sign}0x0.{fraction:013x}p-1022"),
        _ => format!("{sign}0x1.{fraction:013x}p{:+}", i64::try_from(exponent).unwrap() - 1023),
    }
}

#[test]
fn hexadecimal_tables_say_what_decimal_ones_say() {
    let (decimal, hex) = (folder("decimal"), folder("hexadecimal"));
    for stem in ["ggx_p22", "jacobians", "beckmann_lambda"] {
        fs::write(decimal.join(format!("{stem}.csv")), golden(stem)).unwrap();
        fs::write(hex.join(format!("{stem}.csv")), rewritten(stem, |_, x| hexadecimal(x))).unwrap();
    }
    let [decimal, hex] = [decimal, hex].map(|folder| validate(&[folder.to_str().unwrap()]));
    assert_eq!(hex.status.code(), Some(0), "{}{}", text(&hex.stdout), text(&hex.stderr));
    assert_eq!(text(&hex.stdout), text(&decimal.stdout));
}

/// Endings in capitals, line ends of two bytes, a mark at the beginning, blank lines, comments,
/// quotes.
#[test]
fn tables_of_other_tools_are_read() {
    let folder = folder("tools");
    let quoted = rewritten("chermain_m", |_, x| format!("\"{x:e}\""));
    let text_of_lines =
        format!("\u{feff}# from a spreadsheet\n\n{}\n \n", quoted.replace('\n', "\n\n"));
    fs::write(folder.join("CHERMAIN_M.CSV"), text_of_lines.replace('\n', "\r\n")).unwrap();
    fs::write(folder.join("ggx_d.tsv"), "").unwrap();
    fs::write(folder.join("a.txt"), "").unwrap();
    fs::write(folder.join(".hidden"), "").unwrap();
    let output = validate(&[folder.to_str().unwrap()]);
    let table = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{table}{}", text(&output.stderr));
    assert_eq!(table.lines().filter(|line| line.starts_with("chermain_m ")).count(), 2, "{table}");
    let note = text(&output.stderr);
    assert!(note.ends_with(".csv: a.txt, ggx_d.tsv\n") && note.lines().count() == 1, "{note}");
}

/// The density of GGX in a reader's own arithmetic, at inputs of two decimal digits.
fn decimal_rows() -> String {
    let mut table = String::from("slope_x,slope_y,mean_x,mean_y,a_xx,a_xy,a_yy,expected\n");
    for k in 1..200_u32 {
        let (x, y, alpha) = (f64::from(k % 17) / 10.0, f64::from(k % 7) / 10.0, 0.01);
        let (a, q) = (alpha * alpha, (x * x + y * y) / (alpha * alpha));
        let density = 1.0 / (std::f64::consts::PI * a * (1.0 + q) * (1.0 + q));
        writeln!(table, "{x},{y},0,0,{a},0,{a},{density:e}").expect("a string takes any text");
    }
    table
}

#[test]
fn decimal_inputs_are_not_blamed_on_single_precision() {
    let folder = folder("decimals");
    let rows = decimal_rows();
    fs::write(folder.join("ggx_p22.csv"), &rows).unwrap();
    let output = validate(&[folder.to_str().unwrap()]);
    let table = text(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{table}{}", text(&output.stderr));
    let note = "ggx_p22 f32: 199 of 199 rows have inputs that no f32 holds and are judged at the \
        nearest ones, the first in \
                line 2, `slope_x` 0.1";
    assert_eq!(table.lines().filter(|line| *line == note).count(), 1, "{table}");
    let json = validate(&["--json", folder.to_str().unwrap()]);
    let value: Value = serde_json::from_slice(&json.stdout).expect("JSON");
    let [single, double] = [&value[0], &value[1]];
    assert_eq!(
        (&single["rounded"], &single["first_rounded"]),
        (&199.into(), &1.into()),
        "{single}"
    );
    assert_eq!((&double["rounded"], &double["first_rounded"]), (&0.into(), &Value::Null));
    // A wrong value is wrong wherever it is judged.
    let (rest, last) = rows.trim_end().rsplit_once(',').unwrap();
    let wrong = format!("{rest},{:e}\n", 1.01 * last.parse::<f64>().unwrap());
    fs::write(folder.join("ggx_p22.csv"), wrong).unwrap();
    let output = validate(&[folder.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stdout));
    for precision in ["f32", "f64"] {
        let over = format!("over budget: ggx_p22 {precision} forward: max");
        assert!(text(&output.stdout).contains(&over), "{}", text(&output.stdout));
    }
}

/// A slope beyond the range of f32 is none there: f64 is judged by the row, and f32 does without
/// it.
#[test]
fn rows_that_single_precision_cannot_take_are_counted() {
    let folder = folder("refused");
    let file = folder.join("beckmann_p22.csv");
    let header = "slope_x,slope_y,mean_x,mean_y,a_xx,a_xy,a_yy,expected";
    let density = (-0.5_f64).exp() / std::f64::consts::PI;
    let far = "1e60,0.5,0,0,1,0,1,0";
    fs::write(&file, format!("{header}\n{far}\n0.5,0.5,0,0,1,0,1,{density:e}\n")).unwrap();
    let output = validate(&["--json", folder.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let value: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    let of = |line: usize| {
        ["rows", "rounded", "left_out", "worst_row"].map(|key| value[line][key].as_u64())
    };
    assert_eq!(of(0), [Some(1), Some(1), Some(1), Some(2)], "{value}");
    assert_eq!(of(1)[..3], [Some(2), Some(0), Some(0)], "{value}");
    let output = validate(&[folder.to_str().unwrap()]);
    assert!(
        text(&output.stdout).contains("`slope_x` 1e60; 1 left out"),
        "{}",
        text(&output.stdout)
    );
    // A table of which f32 judges no row is over budget in f32; in f64 it is judged, and so are
    // other tables.
    fs::write(&file, format!("{header}\n{far}\n")).unwrap();
    fs::write(folder.join("chermain_m.csv"), golden("chermain_m")).unwrap();
    let output = validate(&[folder.to_str().unwrap()]);
    assert_eq!((output.status.code(), text(&output.stderr)), (Some(1), ""));
    let said = text(&output.stdout);
    for promise in ["forward", "backward"] {
        let reason = format!("over budget: beckmann_p22 f32 {promise}: no row by which f32 can be");
        assert_eq!(said.matches(&reason).count(), 1, "{said}");
    }
    assert_eq!(said.matches("over budget:").count(), 2, "{said}");
    assert!(
        said.lines().any(|line| line.starts_with("chermain_m") && line.contains("f64")),
        "{said}"
    );
}

#[test]
fn mistakes_on_the_command_line_are_one_line() {
    for arguments in [["--foo"].as_slice(), &[""], &["a", "b"]] {
        let output = validate(arguments);
        let message = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{message}");
        assert!(message.starts_with("validate: ") && message.lines().count() == 1, "{message}");
        assert!(output.stdout.is_empty());
    }
}

/// A move that cancels, and a roughness that becomes 0 in f32.
#[test]
fn rows_whose_move_says_nothing_are_left_out_of_single_precision() {
    let header = "slope_x,slope_y,mean_x,mean_y,a_xx,a_xy,a_yy,expected";
    let (small, density) = (1e-50, (-0.5_f64).exp() / std::f64::consts::PI);
    let cancels = "0.700000018,0,0.700000016,0,1e-16,0,1e-16,3058287763569658.0";
    let mirror = format!("0,0,0,0,{small:e},0,{small:e},3.1830988618379067e49");
    let ggx = 1.0 / (std::f64::consts::PI * 1.5 * 1.5);
    for (stem, row, other) in [("beckmann_p22", cancels, density), ("ggx_p22", &mirror, ggx)] {
        let folder = folder("unjudged");
        let table = format!("{header}\n{row}\n0.5,0.5,0,0,1,0,1,{other:e}\n");
        fs::write(folder.join(format!("{stem}.csv")), table).unwrap();
        let output = validate(&["--json", folder.to_str().unwrap()]);
        let value: Value = serde_json::from_slice(&output.stdout).expect("JSON");
        assert_eq!(value[0]["left_out"], 1, "{value}");
        assert_eq!(value[0]["rows"], 1, "{value}");
        assert!(value[0]["max_rel"].as_f64().unwrap() < 1e-5, "{value}");
        assert_eq!(value[1]["rows"], 2, "{value}");
    }
}

/// As macOS and Emacs leave them beside a table.
#[test]
fn hidden_tables_are_none() {
    let folder = folder("hidden");
    fs::write(folder.join("chermain_m.csv"), golden("chermain_m")).unwrap();
    for name in ["._chermain_m.csv", ".#chermain_m.csv", ".csv"] {
        fs::write(folder.join(name), "\0\u{5}").unwrap();
    }
    let output = validate(&[folder.to_str().unwrap()]);
    assert_eq!((output.status.code(), text(&output.stderr)), (Some(0), ""));
}

/// A line of standard error that cannot be written changes no result and no exit code.
#[cfg(target_os = "linux")]
#[test]
fn a_full_standard_error_changes_nothing() {
    let full = || fs::OpenOptions::new().write(true).open("/dev/full").expect("a device");
    let folder = folder("said");
    fs::write(folder.join("chermain_m.csv"), golden("chermain_m")).unwrap();
    fs::write(folder.join("notes.txt"), "").unwrap();
    for (argument, code) in [(folder.to_str().unwrap(), 0), ("no such folder", 2), ("--none", 2)] {
        let mut command = Command::new(example());
        let status =
            command.arg(argument).stderr(full()).output().expect("the example runs").status;
        assert_eq!(status.code(), Some(code), "{argument}");
    }
}

#[test]
fn help_says_what_each_promise_is_judged_by() {
    let output = validate(&["--help"]);
    assert!(output.status.success() && output.stderr.is_empty());
    for said in ["\nforward: ", "\nbackward: ", "max_eps", "At most 16", "2^-23 in f32"] {
        assert!(text(&output.stdout).contains(said), "{said}");
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
