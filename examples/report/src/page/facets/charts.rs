//! The charts of facets.

use crate::facets::{Entry, SWEPT, Swept, Trial, name};
use crate::page::axis::Scale;
use crate::page::chart::{Chart, Line, Range, around};
use crate::page::kernels::drawn;

/// CSS class of a method's marks.
fn class(method: &str) -> &'static str {
    match method {
        name::BOX | name::BOX_SLOPE | name::WHOLE => "added",
        name::APART => "peak",
        name::NONE | name::WHOLE_NONE | name::APART_NONE | name::FOUR | name::SIXTEEN => "nothing",
        _ => "published",
    }
}

fn plots(figures: &[String]) -> String {
    format!("<div class=\"plots\">\n{}</div>\n", figures.concat())
}

/// Error over run time.
pub(super) fn contest(trial: &Trial) -> String {
    let point = |entry: &Entry| [1e-3 * entry.time, entry.errors.rmse];
    // The chart leaves out filters without a map's correlation and filters with the correlation of
    // slopes: their points would hide the others, and the table lists them.
    let hides = |name: &str| {
        name.starts_with("without") || (name.starts_with("with ") && name.ends_with("slope"))
    };
    let entries = || trial.entries.iter().filter(|entry| !hides(entry.name));
    let lines: Vec<_> = entries()
        .map(|entry| Line {
            name: entry.name.into(),
            class: class(entry.name).into(),
            points: vec![point(entry)],
        })
        .collect();
    let times = || entries().map(|entry| 1e-3 * entry.time);
    let ends = [times().fold(f64::INFINITY, f64::min) / 1.6, times().fold(0.0, f64::max) * 1.6];
    let heights = around(&lines, Some(trial.noise), 1.4);
    let chart = Chart {
        title: "root mean square error over time".into(),
        x: Range::new("\u{b5}s per pixel", Scale::Logarithmic, ends),
        y: Range::new("RMSE, means", Scale::Logarithmic, heights),
        right: Some(trial.noise),
        lines,
    };
    plots(&[drawn("Error against run time", &chart)])
}

/// Error over facets, one chart for each roughness.
pub(super) fn sweep(swept: &[Swept]) -> String {
    let mut alphas: Vec<_> = swept.iter().map(|swept| swept.alpha).collect();
    alphas.dedup();
    let figures = alphas.iter().map(|&alpha| {
        let swept: Vec<_> = swept.iter().filter(|swept| swept.alpha == alpha).collect();
        let lines: Vec<_> = (0..SWEPT.len())
            .map(|k| Line {
                name: SWEPT[k].into(),
                class: ["nothing", "published", "published second", "added"][k].into(),
                points: swept.iter().map(|s| [s.facets.log10(), s.errors[k]]).collect(),
            })
            .collect();
        let heights = around(&lines, None, 1.4);
        let powers = || swept.iter().map(|swept| swept.facets.log10());
        let ends = [powers().fold(f64::INFINITY, f64::min), powers().fold(0.0, f64::max)];
        let chart = Chart {
            title: format!("root mean square error over facets in a pixel, alpha {alpha}"),
            x: Range::new("facets in a pixel, power of ten", Scale::Linear, ends),
            y: Range::new("RMSE, means", Scale::Logarithmic, heights),
            right: None,
            lines,
        };
        drawn(&format!("\u{3b1} {alpha}"), &chart)
    });
    plots(&figures.collect::<Vec<_>>())
}
