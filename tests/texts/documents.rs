//! Tables in the documentation are printed by programs: this holds them to it.
#![cfg(feature = "published")]

#[allow(dead_code)]
#[path = "../../examples/engines.rs"]
mod presets;

#[test]
fn the_table_of_engines_is_what_its_example_prints() {
    let text = include_str!("../../src/filter/engine.md");
    let made = presets::table().expect("constants in range");
    assert_eq!(text, made, "cargo run --example engines > src/filter/engine.md");
}

/// Every erratum in README names a test of tests/laws/errata*.rs, and every such test is named.
#[test]
fn every_erratum_is_listed_with_its_test() {
    let readme = include_str!("../../README.md");
    let files = [
        ("errata.rs", include_str!("../laws/errata.rs")),
        ("errata_leadr.rs", include_str!("../laws/errata_leadr.rs")),
        ("errata_glints.rs", include_str!("../laws/errata_glints.rs")),
        ("errata_multilobe.rs", include_str!("../laws/errata_multilobe.rs")),
    ];
    for (file, text) in files {
        let tests: Vec<&str> =
            text.split("#[test]\nfn ").skip(1).filter_map(|rest| rest.split('(').next()).collect();
        assert!(tests.len() >= 4, "{tests:?}");
        for name in &tests {
            let link = format!("[`{name}`](tests/laws/{file})");
            assert!(readme.contains(&link), "README misses {name}");
        }
        let listed = readme.matches(&format!("](tests/laws/{file})")).count();
        assert_eq!(listed, tests.len(), "README lists a test that is not there");
    }
}
