//! Facets on the page: filters on a tube, on beads and a ball with a normal map, correlation, a
//! zoom, memory; the same as text.

mod charts;
mod finding;
mod pictures;
mod tables;

use super::part::Part;
use crate::facets::Facets;

fn parts(facets: &Facets) -> [Part<Facets>; 7] {
    [
        Part {
            title: "Half vectors that differ over a pixel",
            finding: finding::tube(&facets.tube),
            figures: |facets| pictures::tube(&facets.tube) + &charts::contest(&facets.tube),
            tables: vec![tables::contest(&facets.tube)],
            drawn: false,
            note: tables::FILTERS_NOTE,
        },
        Part {
            title: "Where a narrow kernel is right",
            finding: finding::sweep(&facets.sweep),
            figures: |facets| charts::sweep(&facets.sweep),
            tables: vec![tables::sweep(&facets.sweep)],
            drawn: false,
            note: tables::SWEEP_NOTE,
        },
        Part {
            title: "Half vectors and a normal map at once",
            finding: finding::beads(&facets.beads),
            figures: |facets| pictures::beads(&facets.beads) + &charts::contest(&facets.beads),
            tables: vec![tables::contest(&facets.beads)],
            drawn: false,
            note: tables::BEADS_NOTE,
        },
        Part {
            title: "Normal maps, with and without correlation",
            finding: finding::ball(&facets.ball),
            figures: |facets| pictures::ball(&facets.ball) + &charts::contest(&facets.ball),
            tables: vec![tables::contest(&facets.ball)],
            drawn: false,
            note: tables::MAPPINGS_NOTE,
        },
        Part {
            title: "Lobes by their correlation",
            finding: finding::lobes(&facets.lobes),
            figures: |facets| pictures::lobes(&facets.lobes),
            tables: vec![tables::lobes(&facets.lobes)],
            drawn: false,
            note: tables::LOBES_NOTE,
        },
        Part {
            title: "A zoom",
            finding: finding::zoom(&facets.zoom),
            figures: |facets| pictures::zoom(&facets.zoom),
            tables: vec![tables::zoom(&facets.zoom)],
            drawn: false,
            note: tables::ZOOM_NOTE,
        },
        Part {
            title: "Memory of the dictionary",
            finding: finding::memory(facets.memory),
            figures: |_| String::new(),
            tables: vec![tables::memory(facets.memory)],
            drawn: false,
            note: tables::MEMORY_NOTE,
        },
    ]
}

/// Pictures, charts, tables and what they say.
pub(super) fn html(facets: &Facets) -> String {
    let parts = parts(facets).map(|part| part.html(facets));
    format!("{}{}", include_str!("facets.html"), parts.concat())
}

/// Tables and findings for the terminal.
pub(super) fn text(facets: &Facets) -> String {
    format!("\nFacets\n{}", parts(facets).map(|part| part.text()).concat())
}
