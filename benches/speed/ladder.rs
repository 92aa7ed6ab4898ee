//! The ladder: what each step from a round lobe to any lobe costs, over the round one.

use super::cases::Case;
use super::ratios::{BASE, compare};
use std::fmt::Write;

/// Shapes, with the rows of each: centered, widened, tilted, tilted and widened.
const STEPS: [(&str, [&str; 4]); 3] = [
    (
        "isotropic",
        ["isotropic", "widened_isotropic", "tilted_isotropic", "widened_tilted_isotropic"],
    ),
    (
        "axis-aligned",
        [
            "axis_aligned",
            "widened_axis_aligned",
            "tilted_axis_aligned",
            "widened_tilted_axis_aligned",
        ],
    ),
    ("any A", ["full", "widened_full", "tilted", "widened_tilted"]),
];

/// Other rows that stand below, and what they are.
const OTHERS: [(&str, &str); 13] = [
    ("ggx_widened_on_disk", "GGX, isotropic, widened on the projected disk"),
    ("ggx_peak_fitted", "GGX, isotropic, widened to the right peak"),
    ("ggx_peak_fitted_full", "GGX, any A, widened to the right peak"),
    ("ggx_parallelogram_f32", "GGX, any A: the mean over a parallelogram in lanes"),
    ("ggx_parallelogram_f64", "GGX, any A: that mean in lanes of f64"),
    ("batch_ggx_parallelogram_double", "GGX, any A: that mean, exact, by f64 where it serves"),
    ("ggx_parallelogram_tree", "GGX, any A: that mean by the tree"),
    ("ggx_brdf_over_f32", "GGX, any A: the BRDF over a parallelogram in lanes"),
    ("ggx_brdf_over_tree", "GGX, any A: that BRDF by the tree"),
    ("ggx_axis_aligned_aos", "GGX, axis-aligned, over records"),
    ("cpp_ggx_isotropic", "C++: GGX, isotropic"),
    ("cpp_ggx_axis_aligned", "C++: GGX, axis-aligned"),
    ("cpp_ggx_axis_aligned_aos", "C++: GGX, axis-aligned, over records"),
];

/// Measures the ladder's rows and writes them as Markdown.
pub(crate) fn text(cases: &mut [Case], machine: &[String]) -> String {
    let base = compare(cases, BASE, BASE).ns;
    let mut ratio = |name: &str| {
        let there = cases.iter().any(|case| case.row_name() == name);
        there.then(|| format!("{:.1}", compare(cases, name, BASE).ratio))
    };
    let mut text = format!(
        "Time of one evaluation over that of `{BASE}`, {base:.2} ns: loops over 4096 f32 samples \
         on one core.\nShapes are built from each sample's numbers, those of any A from their \
         factors.\n\n"
    );
    for line in machine {
        let _ = writeln!(text, "- {line}");
    }
    text += "\n| | centered | widened | tilted | tilted, widened |\n|---|---|---|---|---|\n";
    for (distribution, prefix) in [("GGX", "ggx"), ("Beckmann", "beckmann")] {
        for (shape, names) in &STEPS {
            let cells = names.map(|name| ratio(&format!("{prefix}_{name}")).unwrap_or_default());
            let _ = writeln!(text, "| {distribution}, {shape} | {} |", cells.join(" | "));
        }
    }
    text += "\n| | |\n|---|---|\n";
    for (name, title) in OTHERS {
        if let Some(ratio) = ratio(name) {
            let _ = writeln!(text, "| {title} | {ratio} |");
        }
    }
    text
}
