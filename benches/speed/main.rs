//! Cost per sample, as ratios within one run.
//!
//! `cargo bench --bench speed` measures every case with criterion, then each promise of speed that
//! the project makes, and what it costs to ask for more, as ratios of interleaved rounds: a machine
//! that slows down slows both sides. `-- --quick` does the same in seconds, `-- --rows-only`
//! measures the ratios alone, `-- --json FILE` and `-- --ladder FILE` write them; any other
//! argument is criterion's, a name its filter.

mod batch;
mod cases;
mod columns;
mod cpp;
mod evaluations;
mod formulas;
mod glints;
mod hand_written;
mod ladder;
mod limit;
mod machine;
mod maps;
#[path = "../../examples/common/mistake.rs"]
mod mistake;
mod options;
mod output;
mod ratios;
mod samples;
#[path = "../../examples/common/say.rs"]
mod say;

use cases::Case;
use criterion::{Criterion, Throughput};
use options::Options;
use say::say;
use std::path::Path;
use std::process::{Command, ExitCode};
use std::time::Duration;

/// Set for a process that measures for another, which has options that criterion would refuse.
const PART: &str = "LOBE_BENCH_CRITERION_ONLY";

/// What criterion does besides benchmarking, with which no table is wanted.
const SILENT: [&str; 5] = ["--list", "--test", "--help", "-h", "--version"];

fn main() -> ExitCode {
    let (own, other) = options::split(std::env::args().skip(1));
    let options = match options::parse(&own) {
        Ok(options) => options,
        Err(error) => return mistake::told("speed", &error),
    };
    for file in options.files() {
        if let Err(error) = output::check(file) {
            say(&format!("speed: {}: {error}", file.display()));
            return ExitCode::from(2);
        }
    }
    let silent = |argument: &String| {
        SILENT.contains(&argument.as_str()) || argument.starts_with("--profile-time")
    };
    // Without `--bench`, as under `cargo test --benches`, criterion only tries every case.
    let table = other.iter().any(|argument| argument == "--bench") && !other.iter().any(silent);
    if other.iter().any(|argument| argument == "--help" || argument == "-h") {
        let _ = options::help();
    }
    let core = machine::pin();
    let mut cases = cases::all();
    if options.is_empty() {
        measure(&mut cases);
    } else if !options.rows_only
        && let Err(code) = measure_apart(&other)
    {
        return code;
    }
    if !table || std::env::var_os(PART).is_some() {
        return ExitCode::SUCCESS;
    }
    let machine = machine::lines(core);
    println!("\n{}", machine.join("\n"));
    let rows = ratios::print(&mut cases);
    glints::print_generation();
    finish(&options, &mut cases, &rows, &machine)
}

/// Writes the files that were asked for.
fn finish(
    options: &Options,
    cases: &mut [Case],
    rows: &[ratios::Row],
    machine: &[String],
) -> ExitCode {
    let json = || serde_json::to_string_pretty(rows).expect("numbers and names") + "\n";
    let json = options.json.as_ref().map(|file| (file, json()));
    let ladder = options.ladder.as_ref().map(|file| (file, ladder::text(cases, machine)));
    for (file, text) in json.into_iter().chain(ladder) {
        if let Err(error) = output::write(file, &text) {
            say(&format!("speed: {}: {error}", file.display()));
            return ExitCode::from(2);
        }
        println!("Written: {}", file.display());
    }
    ExitCode::SUCCESS
}

/// Criterion's runs, as its own arguments in this process's command line ask.
fn measure(cases: &mut [Case]) {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join("speed");
    let mut criterion = Criterion::default()
        .sample_size(30)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .without_plots()
        .output_directory(&directory)
        .configure_from_args();
    for case in cases {
        let mut group = criterion.benchmark_group(case.group);
        group.throughput(Throughput::Elements(samples::COUNT as u64));
        group.bench_function(case.name, |bencher| bencher.iter(|| (case.pass)()));
        group.finish();
    }
    criterion.final_summary();
}

/// The same in a process of its own, whose command line has criterion's arguments alone: it reads
/// no other.
fn measure_apart(arguments: &[String]) -> Result<(), ExitCode> {
    let program = std::env::current_exe();
    let status =
        program.and_then(|program| Command::new(program).args(arguments).env(PART, "1").status());
    match status {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => {
            let code = status.code().and_then(|code| u8::try_from(code).ok());
            Err(code.map_or(ExitCode::FAILURE, ExitCode::from))
        }
        Err(error) => {
            say(&format!("speed: {error}"));
            Err(ExitCode::FAILURE)
        }
    }
}
