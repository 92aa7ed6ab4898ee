//! The pictures of facets.

use super::tables::amount;
use crate::camera::Size;
use crate::facets::{Lobes, Trial, Zoom, name};
use crate::page::axis::{Scale, plain};
use crate::page::colors::Colored;
use crate::page::escape;
use crate::page::picture::{Tone, WHITE};
use crate::page::table::significant;

/// Width of a column of small pictures, as in style.css.
const COLUMN: usize = 384;

/// Of pictures in a table.
const CELL: usize = 128;

/// A picture whose pixels are whole multiples of the screen's.
fn image(tone: Tone, size: Size, values: &[f64], caption: &str, column: usize) -> String {
    let zoom = (column / size.width).max(1);
    format!(
        "<img alt=\"{}\" width=\"{}\" height=\"{}\" src=\"{}\">",
        escape(caption),
        zoom * size.width,
        zoom * size.height,
        tone.data_url(size, values),
    )
}

fn grid(figures: impl Iterator<Item = String>) -> String {
    format!("<div class=\"pictures small\">\n{}</div>\n", figures.collect::<String>())
}

/// Some methods' pictures and the reference, all under its tone curve.
fn shown(trial: &Trial, names: &[&str]) -> String {
    // What is dark says nothing of highlights' brightness.
    let bright = trial.reference.iter().copied().filter(|&x| x > trial.mean);
    let tone = Tone::of(&bright.collect::<Vec<_>>());
    let entries = names.iter().filter_map(|name| trial.entry(name));
    let pictures = entries.map(|entry| (entry.name, &entry.picture[..]));
    let all = pictures.chain([("reference", &trial.reference[..])]);
    let figures = all.map(|(name, values)| {
        let image = image(tone, trial.size, values, name, COLUMN);
        format!("<figure>{image}<figcaption>{}</figcaption></figure>\n", escape(name))
    });
    let note = format!(
        "<p class=\"note\">All under one tone curve, 1 \u{2212} exp(\u{2212}kx) in sRGB: of what \
            is brighter than the mean in the reference, the \
         99th percentile, {} means, is {:.0} % of white.</p>\n",
        significant(tone.bright / trial.mean),
        100.0 * WHITE,
    );
    grid(figures) + &note
}

/// How far some methods are off, in means of the reference.
fn differences(trial: &Trial, names: &[&str]) -> String {
    let entries = names.iter().filter_map(|name| trial.entry(name));
    grid(entries.map(|entry| {
        let pairs = entry.picture.iter().zip(&trial.reference);
        let values: Vec<_> = pairs.map(|(x, r)| (x - r).abs() / trial.mean).collect();
        let shown = Colored {
            size: trial.size,
            column: COLUMN,
            on: &trial.judged,
            caption: format!("|{} \u{2212} reference| in means", entry.name),
            values: &values,
            scale: Scale::Logarithmic,
            ends: [0.01, 10.0],
            ticks: &[0.01, 0.1, 1.0, 10.0],
            unit: "",
        };
        shown.figure()
    }))
}

/// The tube.
pub(super) fn tube(trial: &Trial) -> String {
    let drawn = [name::NONE, name::HALF, name::ONE, name::HALF_SLOPE, name::BOX];
    shown(trial, &drawn)
        + &differences(
            trial,
            &[name::NONE, name::HALF, name::ONE, name::HALF_SLOPE, name::ONE_SLOPE, name::BOX],
        )
}

/// The beads.
pub(super) fn beads(trial: &Trial) -> String {
    let names = [name::WHOLE_NONE, name::WHOLE_HALF, name::WHOLE_ONE, name::WHOLE, name::APART];
    shown(trial, &names) + &differences(trial, &names)
}

/// The ball.
pub(super) fn ball(trial: &Trial) -> String {
    let names = [name::MEAN, name::APART, name::WHOLE];
    shown(trial, &names) + &differences(trial, &names)
}

/// A table of pictures with titles above the columns and before the rows.
fn sheet(columns: &[String], rows: &[(String, Vec<String>)]) -> String {
    let heads = columns.iter().map(|title| format!("<th>{}</th>", escape(title)));
    let lines = rows.iter().map(|(title, images)| {
        let cells = images.iter().map(|image| format!("<td>{image}</td>"));
        format!("<tr><th>{}</th>{}</tr>\n", escape(title), cells.collect::<String>())
    });
    format!(
        "<div class=\"scroll \
            spheres\"><table>\n<thead><tr><th></th>{}</tr></thead>\n<tbody>\n{}</tbody>\n\
             </table></div>\n",
        heads.collect::<String>(),
        lines.collect::<String>(),
    )
}

/// Lobes by correlation and number of facets.
pub(super) fn lobes(lobes: &Lobes) -> String {
    let columns = crate::facets::CORRELATIONS.map(|rho| format!("\u{3c1} = {rho}"));
    let rows = crate::facets::COUNTS.map(|count| {
        let shown = lobes.shown.iter().filter(|shown| shown.facets == count);
        let images = shown.map(|shown| {
            let caption = format!("{}, \u{3c1} {}", amount(count), shown.correlation);
            image(Tone::of(&shown.picture), lobes.size, &shown.picture, &caption, CELL)
        });
        (amount(count), images.collect())
    });
    sheet(&columns, &rows)
}

/// All steps, without a filter and with the box, each under the tone of its filtered picture.
pub(super) fn zoom(zoom: &Zoom) -> String {
    let columns: Vec<_> =
        zoom.frames.iter().map(|frame| format!("{} facets", plain(frame.facets))).collect();
    let rows = [0, 1].map(|k| {
        let title = [name::NONE, name::BOX][k];
        let images = zoom.frames.iter().map(|frame| {
            let tone = Tone::of(&frame.pictures[1]);
            let caption = format!("{title}, {} facets in a pixel", plain(frame.facets));
            image(tone, zoom.size, &frame.pictures[k], &caption, CELL)
        });
        (title.into(), images.collect())
    });
    sheet(&columns, &rows)
}
