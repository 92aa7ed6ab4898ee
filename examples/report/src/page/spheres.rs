//! Spheres of relief on the page: pictures in the order of Dupuy et al.'s tables, and error over
//! time.

use super::axis::Scale;
use super::chart::{Chart, Line, Range};
use super::escape;
use super::kernels::drawn;
use super::picture::Tone;
use super::relief::{GRIDS, name};
use crate::camera::Size;
use crate::relief::{Family, Relief, Sphere, Way};

/// About how wide a picture is on the screen; whole multiples keep pixels square.
const WIDTH: usize = 112;

/// A picture with its column's title.
type Shown<'a> = (String, &'a [f64]);

/// Reference, normal mapping and the published grids, a row for each sphere.
pub(super) fn skies(relief: &Relief) -> String {
    let note = "Displaced: ray-cast. Each row under one tone curve. Slopes look up their light \
        over their solid angle; \
                what small grids leave of a lamp are its images by single slopes.";
    sheet(relief, note, |sphere| {
        let pictures = &sphere.pictures;
        let grids = pictures.grids.iter().map(|(family, n, picture)| {
            let ours = if *family == Family::Cells { "cells " } else { "" };
            (format!("{ours}{n} \u{d7} {n}"), &picture[..])
        });
        let mut row: Vec<Shown<'_>> = vec![
            ("Normal map".into(), &pictures.normal_mapping),
            ("Displaced".into(), &pictures.reference),
        ];
        row.extend(grids);
        row
    })
}

/// The narrowest lamp alone, with and without shadows.
pub(super) fn lamps(relief: &Relief) -> String {
    let note = "The narrowest lamp alone: ray-cast, and the closed form\u{2019}s mean over the \
        lamp. Grain is the rays\u{2019} noise.";
    sheet(relief, note, |sphere| {
        let [[rays, closed], [dark, dark_closed]] =
            [&sphere.pictures.lamp, &sphere.pictures.lamp_shadowed];
        vec![
            ("Displaced".into(), &rays[..]),
            ("Closed form".into(), closed),
            ("Displaced, shadows".into(), dark),
            ("Closed form, shadows".into(), dark_closed),
        ]
    })
}

/// A table of pictures; the tone of a row is that of its ray-cast picture.
fn sheet<'a>(relief: &'a Relief, note: &str, row: impl Fn(&'a Sphere) -> Vec<Shown<'a>>) -> String {
    let size = Size { width: relief.side, height: relief.side };
    let lines = relief.spheres.iter().map(|sphere| {
        let shown = row(sphere);
        let displaced = shown.iter().find(|(title, _)| title == "Displaced");
        let tone = Tone::of(displaced.map_or(&[], |(_, picture)| picture));
        let cells = shown.iter().map(|(title, picture)| {
            format!(
                "<td><img alt=\"\u{3c3} {0}: {1}\" width=\"{2}\" height=\"{2}\" src=\"{3}\"></td>",
                name(sphere),
                escape(title),
                (WIDTH / relief.side).max(1) * relief.side,
                tone.data_url(size, &relief.square(picture)),
            )
        });
        format!("<tr><td>{}</td>{}</tr>\n", name(sphere), cells.collect::<Vec<_>>().concat())
    });
    let titles = relief.spheres.first().map(&row).unwrap_or_default();
    let heads = titles.iter().map(|(title, _)| format!("<th>{}</th>", escape(title)));
    format!(
        "<div class=\"scroll spheres\"><table>\n<thead><tr><th>\u{3c3}\u{3b8}, \
            \u{3c3}\u{3c6}</th>{}</tr></thead>\n\
         <tbody>\n{}</tbody>\n</table></div>\n<p class=\"note\">{}</p>\n",
        heads.collect::<Vec<_>>().concat(),
        lines.collect::<Vec<_>>().concat(),
        escape(note),
    )
}

/// A line of the charts: a kind of grids looked up one way.
const LINES: [(&str, &str, Family, Way); 6] = [
    ("published", "published", Family::Published, Way::Blurred),
    ("published, paper\u{2019}s LOD", "published second", Family::Published, Way::Widened),
    ("published, one direction", "published third", Family::Published, Way::Point),
    ("cells", "added", Family::Cells, Way::Blurred),
    ("cells, paper\u{2019}s LOD", "added second", Family::Cells, Way::Widened),
    ("Hermite", "peak", Family::Hermite, Way::Blurred),
];

/// Error over time for the spheres whose grids differ: the first and the last isotropic one, and
/// one other.
pub(super) fn charts(relief: &Relief) -> String {
    let rough = |sphere: &&Sphere| sphere.sigma[0].max(sphere.sigma[1]) > 0.3;
    let round = |sphere: &&Sphere| sphere.sigma[0] == sphere.sigma[1];
    let (isotropic, others): (Vec<_>, Vec<_>) =
        relief.spheres.iter().filter(rough).partition(round);
    let mut chosen: Vec<&Sphere> = Vec::new();
    for sphere in [isotropic.first(), isotropic.last(), others.last()].into_iter().flatten() {
        if chosen.iter().all(|other| other.sigma != sphere.sigma) {
            chosen.push(sphere);
        }
    }
    let figures = chosen.into_iter().map(|sphere| {
        let heading = format!("\u{3c3} = {}", name(sphere));
        drawn(&heading, &chart(relief, sphere))
    });
    format!(
        "<h3>Error over time</h3>\n<div class=\"plots\">\n{}</div>\n<p class=\"note\">Each line \
            runs over N; errors that \
         noise hides are drawn at its height, dotted.</p>\n",
        figures.collect::<Vec<_>>().concat(),
    )
}

fn chart(relief: &Relief, sphere: &Sphere) -> Chart {
    let line = |&(title, class, family, way): &(&str, &str, Family, Way)| Line {
        name: title.into(),
        class: class.into(),
        points: GRIDS
            .iter()
            .filter(|grid| grid.0 == family)
            .filter_map(|&(family, count)| {
                let time = relief.speed.grid(family, count)?.time(way);
                let errors = sphere.grid(family, count)?.error(way);
                Some([1e-3 * time, 100.0 * errors.rmse.max(errors.least)])
            })
            .collect(),
    };
    let mut lines: Vec<Line> = LINES.iter().map(line).collect();
    let points = lines.iter().flat_map(|line| line.points.iter().copied());
    let (times, errors): (Vec<f64>, Vec<f64>) = points.map(|[x, y]| (x, y)).unzip();
    let ends = |values: &[f64], others: [f64; 2]| {
        let values = || values.iter().copied().chain(others);
        [values().fold(f64::INFINITY, f64::min) / 1.3, values().fold(0.0, f64::max) * 1.3]
    };
    let normal_map = 100.0 * sphere.normal_mapping.rmse;
    let least = 100.0 * sphere.normal_mapping.least;
    let x = ends(&times, [times[0]; 2]);
    let flat = |height: f64| x.map(|x| [x, height]).to_vec();
    lines.push(Line {
        name: "normal map".into(),
        class: "nothing".into(),
        points: flat(normal_map),
    });
    Chart {
        title: format!("error over time, sigma {}", name(sphere)),
        x: Range::new("\u{b5}s per pixel", Scale::Logarithmic, x),
        y: Range::new(
            "RMSE, % of the mean",
            Scale::Logarithmic,
            ends(&errors, [normal_map, least]),
        ),
        right: Some(least),
        lines,
    }
}
