//! The fuzzers' corpus, replayed: what they have reached or broken once holds on every test run.

use std::fs;
use std::path::Path;

/// Runs a law on every file of its corpus; a violation names the file.
fn replay(target: &str, law: fn(&[u8])) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(target);
    let mut files: Vec<_> = fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .map(|entry| entry.expect("a readable entry").path())
        .collect();
    files.sort();
    assert!(!files.is_empty(), "{} is empty", folder.display());
    for file in files {
        // Captured unless the law panics right after.
        println!("{}", file.display());
        law(&fs::read(&file).expect("a readable file"));
    }
}

#[test]
fn constructors_reject_or_yield_a_valid_value() {
    replay("constructors", crate::fuzz_laws::constructors);
}

#[test]
fn single_precision_agrees_with_double() {
    replay("precision", crate::fuzz_laws::precision);
}

#[test]
fn facets_are_numbers() {
    replay("facets", crate::fuzz_laws::facets);
}

#[test]
fn glints_are_numbers() {
    replay("glints", crate::fuzz_laws::glints);
}

#[test]
fn maps_and_surfaces_stay_valid() {
    replay("maps", crate::fuzz_laws::maps);
}
