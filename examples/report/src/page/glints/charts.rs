//! The charts of glints.

use crate::glints::{Contest, Entry, Glitter, Model, Ripple};
use crate::page::axis::Scale;
use crate::page::chart::{Chart, Line, Range, around};
use crate::page::kernels::drawn;

/// CSS class of a model's lines.
fn class(model: Model) -> &'static str {
    match model {
        Model::Smooth => "nothing",
        Model::Default | Model::Varied => "added",
        Model::Four => "peak",
        Model::Published | Model::PublishedVaried => "published",
    }
}

fn line(name: &str, class: &str, points: Vec<[f64; 2]>) -> Line {
    Line { name: name.into(), class: class.into(), points }
}

fn plots(figures: &[(String, Chart)]) -> String {
    let figures = figures.iter().map(|(heading, chart)| drawn(heading, chart));
    format!("<div class=\"plots\">\n{}</div>\n", figures.collect::<Vec<_>>().concat())
}

/// Cells over the aspect, and what published loops leave out.
pub(super) fn cells(glints: &Glitter) -> String {
    let over = |value: &dyn Fn(&crate::glints::Visited) -> f64| -> Vec<[f64; 2]> {
        glints.visited.iter().map(|v| [v.aspect, value(v)]).collect()
    };
    let aspect = Range::new("length of the pixel over its width", Scale::Binary, [1.0, 64.0]);
    let percent = |k: usize| over(&|v| 100.0 * v.lost[k]);
    plots(&[
        (
            "Cells per pixel".into(),
            Chart {
                title: "cells per pixel over its aspect".into(),
                x: aspect,
                y: Range::new("cells", Scale::Linear, [0.0, 110.0]),
                right: Some(104.0),
                lines: vec![
                    line("default, most", "added second", over(&|v| v.default[1])),
                    line("default, mean", "added", over(&|v| v.default[0])),
                    line("published, most", "published second", over(&|v| v.published[1])),
                    line("published, mean", "published", over(&|v| v.published[0])),
                ],
            },
        ),
        (
            "Share of the pixel that the published loops leave out".into(),
            Chart {
                title: "share of the pixel that the published loops leave out over its aspect"
                    .into(),
                x: aspect,
                y: Range::new("left out", Scale::Linear, [0.0, 40.0]).with_unit(" %"),
                right: None,
                lines: vec![
                    line("most", "published second", percent(1)),
                    line("mean", "published", percent(0)),
                ],
            },
        ),
    ])
}

/// Time over cells and over details.
pub(super) fn times(glints: &Glitter) -> String {
    let speed = &glints.speed;
    let micro =
        |points: &[[f64; 2]]| points.iter().map(|p| [p[0], 1e-3 * p[1]]).collect::<Vec<_>>();
    let by_cells: Vec<_> = speed
        .by_cells
        .iter()
        .map(|curve| line(curve.model.name(), class(curve.model), micro(&curve.points)))
        .collect();
    let most = by_cells.iter().flat_map(|l| &l.points).map(|p| p[1]).fold(0.0, f64::max);
    let mut by_details: Vec<_> = speed
        .by_details
        .iter()
        .map(|curve| {
            let steep = curve.aspect < 2.0;
            let (view, dashes) = if steep { ("steep", "") } else { ("limit", " second") };
            let name = format!("{}, {view}", curve.model.name());
            line(&name, &format!("{}{dashes}", class(curve.model)), micro(&curve.points))
        })
        .collect();
    by_details.push(line("points, steep", "truth", micro(&speed.points)));
    for [details, _] in by_details.iter_mut().flat_map(|line| &mut line.points) {
        *details = details.log10();
    }
    plots(&[
        (
            "Over the cells".into(),
            Chart {
                title: "time per pixel over its cells".into(),
                x: Range::new("cells in the mean", Scale::Linear, [0.0, 64.0]),
                y: Range::new("\u{b5}s per pixel", Scale::Linear, [0.0, 1.1 * most]),
                right: None,
                lines: by_cells,
            },
        ),
        (
            "Over the details".into(),
            Chart {
                title: "time per pixel over the details in it".into(),
                x: Range::new("details in a pixel, power of ten", Scale::Linear, [0.0, 10.0]),
                y: Range::new("\u{b5}s per pixel", Scale::Logarithmic, [0.2, 2000.0]),
                right: None,
                lines: by_details,
            },
        ),
    ])
}

/// Variance over the width between two sizes of cells.
pub(super) fn ripple(glints: &Glitter) -> String {
    let of = |ripple: &Ripple| {
        let dashes = match ripple.aspect {
            a if a < 2.0 => "",
            a if a < 8.0 => " second",
            _ => " third",
        };
        line(
            &format!("{}, aspect {}", ripple.model.name(), ripple.aspect),
            &format!("{}{dashes}", class(ripple.model)),
            ripple.points.iter().map(|p| [p[0], p[1]]).collect(),
        )
    };
    let mut lines: Vec<_> = glints.ripples.iter().map(of).collect();
    lines.push(line("flat details", "truth second", vec![[1.0, 2.0], [2.0, 2.0]]));
    plots(&[(
        "Over the pixel\u{2019}s width".into(),
        Chart {
            title: "variance over that of real details, over the pixel's width".into(),
            x: Range::new("width of the pixel over a size of cells", Scale::Linear, [1.0, 2.0]),
            y: Range::new("variance / that of real details", Scale::Logarithmic, [0.2, 2.5]),
            right: Some(1.0),
            lines,
        },
    )])
}

/// Distance from real details over time.
pub(super) fn contests(glints: &Glitter) -> String {
    let figures = glints.contests.iter().map(|contest| {
        let heading = super::costs::contest_name(contest);
        let chart = against_time(contest);
        (heading, chart)
    });
    plots(&figures.collect::<Vec<_>>())
}

fn against_time(contest: &Contest) -> Chart {
    // What noise hides is drawn at its height.
    let point = |entry: &Entry| [1e-3 * entry.time, entry.distance.max(contest.noise)];
    let mut lines: Vec<_> = contest
        .models
        .iter()
        .map(|entry| {
            line(
                entry.model.map_or("", Model::name),
                entry.model.map_or("", class),
                vec![point(entry)],
            )
        })
        .collect();
    lines.push(line("points", "truth", contest.points.iter().map(point).collect()));
    let times = || lines.iter().flat_map(|line| line.points.iter().map(|p| p[0]));
    let ends = [times().fold(f64::INFINITY, f64::min) / 2.0, times().fold(0.0, f64::max) * 2.0];
    let heights = around(&lines, Some(contest.noise), 1.4);
    Chart {
        title: format!("distance from real details over time, {} details", contest.details),
        x: Range::new("\u{b5}s per pixel", Scale::Logarithmic, ends),
        y: Range::new("distance of distributions, means", Scale::Logarithmic, heights),
        right: Some(contest.noise),
        lines,
    }
}
