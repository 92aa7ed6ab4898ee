//! Checks the library against tables of exact values, in f32 and in f64.
//!
//! `cargo run --release --example validate -- [DIR] [--json]`. Every CSV in DIR (default: the
//! golden tables) names a quantity by its stem. Exit status: 0 within budget, 1 if a table exceeds
//! its budget (tests/budget.rs), 2 if a table cannot be read.

#[path = "../tests/budget.rs"]
mod budget;
#[path = "../tests/common/tables/mod.rs"]
mod tables;

use clap::Parser;
use serde::Serialize;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use tables::{Outcome, evaluate, read_directory};

/// Check the library against tables of exact values, in f32 and in f64.
#[derive(Parser)]
#[command(after_help = "Exit status: 0 within budget, 1 over budget, 2 unreadable tables.\n\
    Relative errors are over the largest expected value of a row, or the smallest normal number.")]
struct Options {
    /// Directory of CSV tables, one quantity each, named by the file's stem.
    #[arg(default_value = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/golden"))]
    directory: PathBuf,
    /// Print a JSON array, one object per table and precision.
    #[arg(long)]
    json: bool,
}

/// One line of the result, as `--json` prints it.
#[derive(Serialize)]
struct Line<'a> {
    table: &'a str,
    precision: &'static str,
    rows: usize,
    max_rel: f64,
    p99_rel: f64,
    max_ulp: f64,
    worst_row: usize,
    bad: usize,
    #[serde(skip)]
    over: Option<String>,
}

impl<'a> Line<'a> {
    fn new(table: &'a str, single: bool, outcome: &Outcome) -> Self {
        let precision = if single { "f32" } else { "f64" };
        let &Outcome { rows, max_rel, p99_rel, max_ulp, worst_row, bad } = outcome;
        // A quantity without a budget would pass whatever it returns.
        let broken = budget::budget_of(table, single).map_or_else(
            || Some("no budget in tests/budget.rs".to_owned()),
            |budget| budget.broken_by(max_rel, p99_rel, bad),
        );
        let over = broken.map(|reason| format!("{table} {precision}: {reason}"));
        Self { table, precision, rows, max_rel, p99_rel, max_ulp, worst_row, bad, over }
    }
}

fn print_lines(lines: &[Line], out: &mut impl Write) -> std::io::Result<()> {
    writeln!(
        out,
        "{:25} {:>4} {:>6} {:>9} {:>9} {:>9} {:>6} {:>4}",
        "table", "", "rows", "max rel", "99 % rel", "max ulp", "worst", "bad"
    )?;
    for line in lines {
        writeln!(
            out,
            "{:25} {:>4} {:>6} {:>9.1e} {:>9.1e} {:>9.3} {:>6} {:>4}{}",
            line.table,
            line.precision,
            line.rows,
            line.max_rel,
            line.p99_rel,
            line.max_ulp,
            line.worst_row,
            line.bad,
            if line.over.is_some() { "  over budget" } else { "" }
        )?;
    }
    let over: Vec<&str> = lines.iter().filter_map(|line| line.over.as_deref()).collect();
    if over.is_empty() {
        writeln!(out, "all tables within budget")
    } else {
        over.iter().try_for_each(|reason| writeln!(out, "over budget: {reason}"))
    }
}

fn run(options: &Options) -> Result<bool, String> {
    let tables = read_directory(&options.directory)?;
    let mut lines = Vec::new();
    for (table, quantity) in &tables {
        lines.push(Line::new(&table.stem, true, &evaluate::<f32>(table, quantity)?));
        lines.push(Line::new(&table.stem, false, &evaluate::<f64>(table, quantity)?));
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
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => Err(error.to_string()),
        _ => Ok(lines.iter().all(|line| line.over.is_none())),
    }
}

fn main() -> ExitCode {
    match run(&Options::parse()) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1),
        Err(message) => {
            eprintln!("validate: {message}");
            ExitCode::from(2)
        }
    }
}
