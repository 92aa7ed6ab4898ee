//! Cost per sample, as ratios within one run.
//!
//! `cargo bench` measures every case with criterion, then each promise of speed that the project
//! makes, and what it costs to ask for more, as ratios of interleaved rounds: a machine that slows
//! down slows both sides. `cargo bench -- --quick` does the same in seconds; any other argument is
//! criterion's filter.

mod cases;
mod glints;
mod hand_written;
mod maps;
mod ratios;
mod samples;

use criterion::{Criterion, Throughput};
use std::time::Duration;

fn main() {
    let mut cases = cases::all();
    let directory = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("speed");
    let mut criterion = Criterion::default()
        .sample_size(30)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .without_plots()
        .output_directory(&directory)
        .configure_from_args();
    for case in &mut cases {
        let mut group = criterion.benchmark_group(case.group);
        group.throughput(Throughput::Elements(samples::COUNT as u64));
        group.bench_function(case.name, |bencher| bencher.iter(|| (case.pass)()));
        group.finish();
    }
    criterion.final_summary();
    // Criterion's modes that time nothing want no table either.
    let silent = ["--profile-time", "--list", "--test"];
    if !std::env::args().any(|argument| silent.contains(&argument.as_str())) {
        ratios::print(&mut cases);
        glints::print_generation();
    }
}
