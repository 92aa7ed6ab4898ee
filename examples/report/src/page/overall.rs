//! The front of the page: advice, all methods over all scenes, and what they cost in operations.

use super::escape;
use super::table::{Line, Table, significant};
use crate::method::{Family, Tally};
use crate::standing::{Advice, Standing};

/// What to use when, as a table.
pub(super) fn advice_table(advice: &[Advice]) -> Table {
    let rows = advice.iter().map(|line| {
        let Advice { situation, alpha, standing, cost } = line;
        Line {
            cells: vec![
                (*situation).into(),
                standing.name.clone(),
                alpha.to_string(),
                significant(standing.ratio),
                significant(standing.smape_ratio),
                format!("{} ({})", significant(standing.worst), standing.worst_scene),
                format!("{cost:+.0} ns"),
            ],
            class: "",
        }
    });
    let headers = &["You have", "Use", "Alpha", "Error", "SMAPE", "Worst scene", "Cost"];
    Table { headers, rows: rows.collect() }
}

/// What the numbers of the advice mean.
pub(super) const ADVICE_NOTE: &str = "Derived from this run. Error: RMSE over that of one \
    unfiltered sample, geometric mean over all scenes and \
     lights, each method against a reference of its own pixel filter; worst scene: the largest \
     such ratio. SMAPE: the same \
     of the mean relative error, where dark pixels count as much as bright ones: no wider GGX has \
     the filtered lobe's tail, and \
     all of them glow around a highlight; the exact mean does not. Cost: nanoseconds of shading \
     per sample over no filter.";

/// Every method over all scenes.
pub(super) fn standings_table(standings: &[Standing]) -> Table {
    let rows = standings.iter().map(|s| Line {
        cells: vec![
            s.name.clone(),
            family(s.family).into(),
            significant(s.ratio),
            significant(s.box_ratio),
            significant(s.smape_ratio),
            significant(s.worst),
            s.worst_scene.clone(),
            significant(s.pixel),
            if s.pareto { "yes" } else { "" }.into(),
        ],
        class: if s.family == Family::Supersampling { "plain" } else { "" },
    });
    let headers = &[
        "Method",
        "Kind",
        "Error",
        "Error, box",
        "SMAPE",
        "Worst",
        "Worst scene",
        "ns per pixel",
        "Front",
    ];
    Table { headers, rows: rows.collect() }
}

fn family(family: Family) -> &'static str {
    match family {
        Family::Supersampling => "samples",
        Family::Widened => "wider lobe",
        Family::Area => "mean over an area",
        Family::Deferred => "deferred",
        Family::Engine => "engine",
    }
}

/// What each filter does for a sample, beyond no filter at all.
pub(super) fn operations_table(standings: &[Standing]) -> Table {
    let plain = standings.first();
    let one_sample = |s: &&Standing| {
        s.family != Family::Supersampling || plain.is_some_and(|plain| plain.name == s.name)
    };
    let rows = standings.iter().filter(one_sample).map(|s| {
        let o = &s.operations;
        let more = |part: fn(&Standing) -> f64| {
            plain.map_or(String::new(), |plain| format!("{:+.0}", part(s) - part(plain)))
        };
        let counts =
            [o.additions, o.multiplications, o.divisions, o.roots, o.transcendental, o.comparisons];
        let mut cells = vec![s.name.clone()];
        cells.extend(counts.map(|count| format!("{count:.0}")));
        cells.extend([
            format!("{:.0}", o.total()),
            more(|s| Tally::total(&s.operations)),
            significant(s.shading),
        ]);
        Line { cells, class: if s.family == Family::Supersampling { "plain" } else { "" } }
    });
    let headers = &[
        "Method",
        "+ \u{2212}",
        "\u{d7}",
        "\u{f7}",
        "\u{221a}",
        "Transcendental",
        "Compare",
        "All",
        "Over none",
        "Shading ns",
    ];
    Table { headers, rows: rows.collect() }
}

/// Advice, summary table and operations as one section of the page.
pub(super) fn html(advice: &[Advice], standings: &[Standing], alpha: f64) -> [String; 2] {
    let front = format!(
        "<h2>What to use when</h2>\n<div class=\"advice\">{}</div>\n<p class=\"note\">{}</p>\n",
        advice_table(advice).html(),
        escape(ADVICE_NOTE),
    );
    let back = format!(
        "<h2>All methods over all scenes</h2>\n<p class=\"caption\">GGX, alpha {alpha}, all \
            lights. Error and worst as \
         above; against the box, a wide pixel filter pays for its width. Front: no other method \
         has both a \
         smaller error and a smaller time.</p>\n{}\
         <h2>Operations</h2>\n<p class=\"caption\">Of shading one sample, footprint included, GGX \
         at alpha {alpha}: counted on \
         the pixels of the scenes by a number that notes what is done with it, the mean where \
         branches differ. A \
         transcendental function counts as one. The counterpart of Kaplanyan et al. 2016, Table 3, \
         where forward shading grew by 19 instructions (Beckmann), 272 (GGX, rectangle) and 22 \
         (GGX \
         proxy).</p>\n{}",
        standings_table(standings).html(),
        operations_table(standings).html(),
    );
    [front, back]
}
