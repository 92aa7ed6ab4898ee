//! The tables of what glints cost, and what their columns mean.

use crate::glints::{Contest, Glitter, Visited};
use crate::page::axis::plain;
use crate::page::table::{Line, Table, significant};

pub(super) const CELLS_NOTE: &str = "The paper tells of 8 cells steep to 64 at most. The default \
    asks no more than 104, dotted, \
    and leaves nothing out: beyond an aspect of 16 the cells themselves grow. The published \
    shader stops after 18 columns of a \
    level and 60 cells.";

pub(super) const TIMES_NOTE: &str = "One evaluation of the BRDF in f32; smooth lobe: isotropic \
    Beckmann. Steep: 85 degrees; \
    limit: pixels 16 times as long as wide. 1000 details in a pixel, half vectors spread as the \
    lobe. Added: what glints take more \
    than the smooth lobe, over what they take more when steep. The paper, on a GeForce GTX 980 in \
    1080p, adds 0.9 ms steep and 2.9 \
    ms grazing, 3.2 times as much. What varies does by 1.";

pub(super) const COUNTS_NOTE: &str = "Operations: additions, multiplications, divisions, roots, \
    logarithms and comparisons of \
    floats, from pixels of aspect 1 and 16 at the pole; integers, so the hashes, are not counted. \
    Instructions: static SPIR-V by \
    naga before any driver has optimized it, calls written out, loops counted once; arithmetic: \
    without moves, loads, stores and \
    branches, most of which an optimizer takes away. The paper counts what NVIDIA\u{2019}s \
    compiler made of GLSL for a GTX 980: \
    another instruction set, so orders compare, not numbers.";

pub(super) const CONTESTS_NOTE: &str = "Distance: mean difference of the sorted values of as many \
    pixels of each (1-Wasserstein), \
    in means; below the noise, the distance of two samples of real details, nothing can be seen, \
    and charts show the noise, dotted. \
    Points: details one by one, in f64; fewer than there are, each brighter, are the line to \
    beat. Snow at the pole under a \
    point light.";

fn line(cells: Vec<String>) -> Line {
    Line { cells, class: "" }
}

/// Cells and what is left out, at powers of 2.
pub(super) fn cells(glints: &Glitter) -> Table {
    let whole = |visited: &&Visited| visited.aspect.log2().fract() == 0.0;
    let rows = glints.visited.iter().filter(whole).map(|visited| {
        let [mean, most] = visited.default;
        let [published, published_most] = visited.published;
        let lost = visited.lost.map(|share| format!("{:.1} %", 100.0 * share));
        let cells = [
            plain(visited.aspect),
            significant(mean),
            plain(most),
            significant(published),
            plain(published_most),
        ];
        line(cells.into_iter().chain(lost).collect())
    });
    let headers =
        &["Aspect", "Default: cells", "most", "Published: cells", "most", "Left out", "at most"];
    Table { headers, rows: rows.collect() }
}

/// By model and view.
pub(super) fn times(glints: &Glitter) -> Table {
    let speed = &glints.speed;
    let rows = speed.views.iter().map(|timed| {
        let views = [0, 1, 2].map(|k| {
            let over = timed.times[k] / speed.smooth()[k];
            [significant(timed.times[k]), significant(over)]
        });
        let growth =
            speed.growth(timed.model).map(|growth| growth.map_or(String::new(), significant));
        line([vec![timed.model.name().into()], views.concat(), growth.into()].concat())
    });
    let headers = &[
        "Model",
        "Steep: ns",
        "\u{d7} smooth",
        "10\u{b0}: ns",
        "\u{d7} smooth",
        "Limit: ns",
        "\u{d7} smooth",
        "Added: 10\u{b0} / steep",
        "limit / steep",
    ];
    let cells =
        speed.cells.iter().zip(["cells, default", "cells, published"]).map(|(cells, name)| {
            let [a, b, c] = cells.map(significant);
            let gap = String::new;
            let growth = [1, 2].map(|k| significant(cells[k] / cells[0]));
            let [ten, limit] = growth;
            Line {
                cells: vec![name.into(), a, gap(), b, gap(), c, gap(), ten, limit],
                class: "plain",
            }
        });
    Table { headers, rows: rows.chain(cells).collect() }
}

/// Operations of a cell.
pub(super) fn operations(glints: &Glitter) -> Table {
    let rows = glints.operations.iter().map(|counted| {
        // Differences of means: what is nothing may be a rounding error.
        let whole = |x: f64| format!("{:.1}", x.max(0.0));
        let cell = &counted.cell;
        let rare = cell.divisions + cell.roots + cell.transcendental;
        let parts = [cell.total(), cell.additions + cell.multiplications, rare, cell.comparisons];
        let cells = parts.into_iter().chain([counted.pixel.total()]).map(whole);
        line([plain(counted.details)].into_iter().chain(cells).collect())
    });
    let headers = &[
        "Details in a pixel",
        "Operations per cell",
        "+ \u{2212} \u{d7}",
        "/ \u{221a} ln",
        "< >",
        "per pixel beside them",
    ];
    Table { headers, rows: rows.collect() }
}

/// Instructions of the shader beside the paper's.
pub(super) fn instructions(glints: &Glitter) -> Table {
    let counted = &glints.instructions;
    let rows = [
        ("one cell, the innermost loop", counted.cell, "204"),
        ("of which for numbers that vary", counted.varied, "\u{2013}"),
        ("all of an evaluation", counted.whole, "412"),
    ];
    let rows = rows.map(|(name, [all, arithmetic], paper)| {
        line(vec![name.into(), all.to_string(), arithmetic.to_string(), paper.into()])
    });
    let headers = &["Instructions", "SPIR-V", "Arithmetic", "Paper, GTX 980"];
    Table { headers, rows: rows.into() }
}

/// What a contest is about.
pub(super) fn contest_name(contest: &Contest) -> String {
    format!("{} details in a pixel of aspect {}", contest.details, contest.aspect)
}

/// All contests, one below the other.
pub(super) fn contests(glints: &Glitter) -> Table {
    let rows = glints.contests.iter().flat_map(|contest| {
        let head = Line {
            cells: [contest_name(contest), String::new(), significant(contest.noise)]
                .into_iter()
                .chain(["1".into(), "1".into()])
                .collect(),
            class: "plain",
        };
        let entries = contest.models.iter().chain(&contest.points).map(|entry| {
            let name = match (entry.model, entry.details) {
                (Some(model), _) => model.name().into(),
                (None, 1.0) => "1 point".into(),
                (None, details) => format!("{details} points"),
            };
            let hidden = if entry.distance < contest.noise { "<" } else { "" };
            line(vec![
                name,
                significant(1e-3 * entry.time),
                format!("{hidden}{}", significant(entry.distance.max(contest.noise))),
                significant(entry.mean),
                significant(entry.variance),
            ])
        });
        [head].into_iter().chain(entries)
    });
    let headers = &["Model", "\u{b5}s per pixel", "Distance", "Mean", "Variance / true"];
    Table { headers, rows: rows.collect() }
}
