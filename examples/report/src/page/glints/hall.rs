//! The hall in false colors, each picture with the numbers of its colors.

use crate::glints::Hall;
use crate::page::axis::Scale;
use crate::page::colors::Colored;

/// Width of a column of pictures, as in style.css.
const COLUMN: usize = 560;

/// Cells at the ends of the colors: as few and as many as a pixel has.
const CELLS: [f64; 2] = [4.0, 104.0];

/// Both pictures; black is where there is no surface.
pub(super) fn pictures(hall: &Hall) -> String {
    let lost: Vec<_> = hall.lost.iter().map(|share| 100.0 * share).collect();
    let on: Vec<_> = hall.cells.iter().map(|&cells| cells > 0.0).collect();
    let figures = [
        Colored {
            size: hall.size,
            column: COLUMN,
            on: &on,
            caption: "Cells visited per pixel, default (Zirr & Kaplanyan 2016, Fig. 9)".into(),
            values: &hall.cells,
            scale: Scale::Binary,
            ends: CELLS,
            ticks: &[4.0, 8.0, 16.0, 32.0, 64.0, 104.0],
            unit: "",
        },
        Colored {
            size: hall.size,
            column: COLUMN,
            on: &on,
            caption: "Share of the pixel that the published loops leave out".into(),
            values: &lost,
            scale: Scale::Linear,
            ends: [0.0, 40.0],
            ticks: &[0.0, 10.0, 20.0, 30.0, 40.0],
            unit: " %",
        },
    ];
    let figures = figures.iter().map(Colored::figure);
    format!("<div class=\"pictures\">\n{}</div>\n", figures.collect::<Vec<_>>().concat())
}
