//! Tables in the documentation are printed by programs: this holds them to it.

#[allow(dead_code)]
#[path = "../examples/presets.rs"]
mod presets;

#[test]
fn the_table_of_engines_is_what_its_example_prints() {
    let text = include_str!("../src/filter/preset.md");
    let made = presets::table().expect("constants in range");
    assert_eq!(text, made, "cargo run --example presets > src/filter/preset.md");
}
