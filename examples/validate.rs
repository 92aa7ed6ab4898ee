//! Checks the library against tables of exact values, in f32 and in f64.
//!
//! `cargo run --release --example validate -- [DIR] [--json]`. Every CSV in DIR (default: the
//! golden tables) names a quantity by its stem. Each line of the output judges one of the library's
//! two promises: forward accuracy, of compensated shapes, means and Jacobians, or backward
//! accuracy, of default shapes. Exit status: 0 within budget, 1 if a table exceeds its budget
//! (tests/budget.rs), 2 if a table cannot be read. `--help` says what a line is judged by, and what
//! f32 is judged by where inputs are no f32.

#[path = "../tests/budget.rs"]
mod budget;
#[path = "common/mistake.rs"]
mod mistake;
#[path = "../tests/common/roundings.rs"]
mod roundings;
#[path = "common/say.rs"]
mod say;
#[path = "../tests/common/tables/mod.rs"]
mod tables;

use clap::Parser;
use say::say;
use serde::Serialize;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use tables::{Outcome, Promise, Quantity, Table, evaluate, read_directory};

/// Check the library against tables of exact values, in f32 and in f64.
#[derive(Parser)]
#[command(after_help = "Exit status: 0 within budget, 1 over budget, 2 unreadable tables.\n\
    Relative errors are over the largest expected value of a row, or the smallest normal number.\n\
    \n\
    Each line judges one promise of the library.\n\
    forward:  inputs count as exact, and relative errors (max rel, 99 % rel) are judged.\n\
    \u{20}         Matrix entries make `slope::Compensated` shapes.\n\
    backward: densities, projected areas, Lambdas and BRDFs by the default shapes of matrix\n\
    \u{20}         entries, `Anisotropic` and `NonCentered`. Their eps is judged: the least of 1,\n\
    \u{20}         2, 4, ... roundings (2^-23 in f32, 2^-52 in f64) by which each input and the\n\
    \u{20}         result must be moved for the result of the worst row to be exact. At most 16\n\
    \u{20}         are allowed. Relative errors are not judged: they show how far rounded inputs\n\
    \u{20}         move the quantity.\n\
    The exact value at moved inputs is the expected value times f64(moved) / f64(given),\n\
    where f64 is the library in f64 with compensated shapes. Judging f32 searches the moved\n\
    inputs; judging f64 takes the first order of the moves. In JSON, max_eps is null in\n\
    forward lines, and 1.8e308 (in the table inf) where 4096 roundings do not suffice. The\n\
    worst row of a backward line has the largest eps, and among equals the largest relative\n\
    error.\n\
    \n\
    Tables: numbers are decimal or, as in C99, hexadecimal (0x1.8p-3); columns are separated by \
    commas and\n\
    come in any order; blank lines and lines that begin with # are skipped. Files that do not end \
    in .csv\n\
    are named and ignored.\n\
    \n\
    Inputs that no f32 holds, as 0.1: f32 is judged at the nearest f32s, and the expected value \
    is moved\n\
    there by the library in f64, expected + f64(nearest) - f64(given). f64 is judged by the \
    expected value\n\
    as it stands. The output counts these rows (rounded) and names the first. Rows whose nearest \
    f32s the\n\
    library refuses or are 0 for what is none, whose expected value exceeds the range of f32, or \
    whose move\n\
    cancels (its roundings exceed 1e-9 of the moved value), are left out of f32 and counted; a \
    table of\n\
    which no row is left counts as over budget.")]
struct Options {
    /// Directory of CSV tables, one quantity each, named by the file's stem [default: the golden
    /// tables].
    directory: Option<PathBuf>,
    /// Print a JSON array, one object per table, promise and precision.
    #[arg(long)]
    json: bool,
}

/// One line of the result, as `--json` prints it.
#[derive(Serialize)]
struct Line<'a> {
    table: &'a str,
    precision: &'static str,
    /// `forward` or `backward`.
    promise: &'static str,
    rows: usize,
    max_rel: f64,
    p99_rel: f64,
    max_ulp: f64,
    /// The largest backward error in roundings; none where the promise is `forward`.
    max_eps: Option<f64>,
    worst_row: usize,
    bad: usize,
    /// Rows with inputs that the precision does not hold.
    rounded: usize,
    /// The first of them, counted from 1 below the header.
    first_rounded: Option<usize>,
    /// Those among them that the precision cannot be judged by.
    left_out: usize,
    #[serde(skip)]
    over: Option<String>,
    #[serde(skip)]
    note: Option<String>,
}

impl<'a> Line<'a> {
    fn new(
        source: &'a Table,
        quantity: &Quantity,
        promise: Promise,
        single: bool,
        outcome: &Outcome,
    ) -> Self {
        let precision = if single { "f32" } else { "f64" };
        let table = source.stem.as_str();
        let &Outcome { rows, max_rel, p99_rel, max_ulp, roundings, worst_row, bad, rounded } =
            outcome;
        // A quantity without a budget would pass whatever it returns, and so would a table without
        // a row to judge by.
        let broken = match budget::budget_of(table, single) {
            None => Some("no budget in tests/budget.rs".to_owned()),
            Some(_) if rows == 0 => Some(format!("no row by which {precision} can be judged")),
            Some(budget) => match promise {
                Promise::Forward => budget.broken_by(max_rel, p99_rel, bad),
                Promise::Backward => budget::broken_by_roundings(roundings, bad),
            },
        };
        let name = promise.name();
        let over = broken.map(|reason| format!("{table} {precision} {name}: {reason}"));
        // One note for both promises: all shapes refuse the same entries (`Psd::new`), so both
        // promises are judged by the same rows.
        let first = rounded.first.filter(|_| promise == Promise::Forward);
        let note = first.map(|[row, column]| {
            let (name, value) = (quantity.inputs[column], source.rows[row][column]);
            let (count, of, line) = (rounded.rows, source.rows.len(), source.lines[row]);
            let left_out = match rounded.refused {
                0 => String::new(),
                refused => format!("; {refused} left out, which {precision} cannot be judged by"),
            };
            format!(
                "{table} {precision}: {count} of {of} rows have inputs that no {precision} holds \
                    and are judged at the \
                 nearest ones, the first in line {line}, `{name}` {value:?}{left_out}"
            )
        });
        Self {
            table,
            precision,
            promise: promise.name(),
            rows,
            max_rel,
            p99_rel,
            max_ulp,
            max_eps: (promise == Promise::Backward).then_some(roundings.min(f64::MAX)),
            worst_row,
            bad,
            rounded: rounded.rows,
            first_rounded: rounded.first.map(|[row, _]| row + 1),
            left_out: rounded.refused,
            over,
            note,
        }
    }
}

/// A backward error in roundings, as the table prints it.
fn eps(count: f64) -> String {
    if count < f64::MAX { format!("{count:.0}") } else { "inf".to_owned() }
}

fn print_lines(lines: &[Line], out: &mut impl Write) -> std::io::Result<()> {
    writeln!(
        out,
        "{:25} {:>4} {:8} {:>6} {:>9} {:>9} {:>9} {:>5} {:>6} {:>4} {:>7}",
        "table",
        "",
        "promise",
        "rows",
        "max rel",
        "99 % rel",
        "max ulp",
        "eps",
        "worst",
        "bad",
        "rounded"
    )?;
    for line in lines {
        let ulp = line.max_ulp;
        let ulp = if ulp < 1e5 { format!("{ulp:.3}") } else { format!("{ulp:.1e}") };
        writeln!(
            out,
            "{:25} {:>4} {:8} {:>6} {:>9.1e} {:>9.1e} {:>9} {:>5} {:>6} {:>4} {:>7}{}",
            line.table,
            line.precision,
            line.promise,
            line.rows,
            line.max_rel,
            line.p99_rel,
            ulp,
            line.max_eps.map_or_else(|| "-".to_owned(), eps),
            line.worst_row,
            line.bad,
            line.rounded,
            if line.over.is_some() { "  over budget" } else { "" }
        )?;
    }
    for note in lines.iter().filter_map(|line| line.note.as_deref()) {
        writeln!(out, "{note}")?;
    }
    let over: Vec<&str> = lines.iter().filter_map(|line| line.over.as_deref()).collect();
    if over.is_empty() {
        writeln!(out, "all tables within budget")
    } else {
        over.iter().try_for_each(|reason| writeln!(out, "over budget: {reason}"))
    }
}

fn run(options: &Options) -> Result<bool, String> {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let directory = options.directory.as_deref();
    let found = read_directory(directory.unwrap_or(&golden))?;
    let mut lines = Vec::new();
    for (table, quantity) in &found.tables {
        for &promise in quantity.promises() {
            let single = evaluate::<f32>(table, quantity, promise)?;
            lines.push(Line::new(table, quantity, promise, true, &single));
            let double = evaluate::<f64>(table, quantity, promise)?;
            lines.push(Line::new(table, quantity, promise, false, &double));
        }
    }
    // The generator of the golden tables lies among them.
    if directory.is_some() && !found.ignored.is_empty() {
        let ignored = found.ignored.join(", ");
        say(&format!("validate: ignored, as their names do not end in .csv: {ignored}"));
    }
    let mut out = std::io::stdout().lock();
    let written = if options.json {
        serde_json::to_writer_pretty(&mut out, &lines)
            .map_err(std::io::Error::from)
            .and_then(|()| writeln!(out))
    } else {
        print_lines(&lines, &mut out)
    };
    match written {
        // A reader that has seen enough (`| head`) is no error.
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => {
            Err(format!("cannot write standard output: {error}"))
        }
        _ => Ok(lines.iter().all(|line| line.over.is_none())),
    }
}

fn main() -> ExitCode {
    let options = match Options::try_parse() {
        Ok(options) => options,
        Err(error) => return mistake::told("validate", &error),
    };
    match run(&options) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(message) => {
            say(&format!("validate: {message}"));
            ExitCode::from(2)
        }
    }
}
