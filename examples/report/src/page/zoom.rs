//! A slow zoom on the page: peaks over frames, a table by how far they stray, what it says; the
//! same as text.

use super::axis::Scale;
use super::chart::{Chart, Line as Curved, Range, around};
use super::escape;
use super::kernels::drawn;
use super::minify::DRAWN;
use super::table::{Line, Table, significant};
use crate::minify::{Minified, Track, Zoom, name};

pub(super) fn html(map: &Minified) -> String {
    let zoom = &map.zoom;
    format!(
        "<h4>{}: a slow zoom</h4>\n<p class=\"caption\">{}</p>\n<p>{}</p>\n<div \
            class=\"plots\">\n{}{}</div>\n\
         <details><summary>Table</summary>\n{}</details>\n",
        escape(&map.name),
        escape(&facts(zoom)),
        escape(&finding(zoom)),
        drawn("Largest radiance of each frame", &peaks(map)),
        drawn("The same over the reference\u{2019}s", &ratios(map)),
        table(zoom).html(),
    )
}

pub(super) fn text(map: &Minified) -> String {
    format!(
        "{}: a slow zoom\n{}\n{}{}\n",
        map.name,
        facts(&map.zoom),
        table(&map.zoom).text(),
        finding(&map.zoom)
    )
}

fn facts(zoom: &Zoom) -> String {
    format!(
        "{} frames from {} to {} texels per pixel, view {} degrees high; {} x {} pixels, GGX, \
            alpha {}. Noise of the reference {}.",
        zoom.ratios.len(),
        significant(zoom.ratios.first().copied().unwrap_or(f64::NAN)),
        significant(zoom.ratios.last().copied().unwrap_or(f64::NAN)),
        zoom.elevation,
        zoom.size.width,
        zoom.size.height,
        zoom.alpha,
        significant(zoom.noise),
    )
}

/// Peaks of methods and of the reference.
fn peaks(map: &Minified) -> Chart {
    let zoom = &map.zoom;
    let mut lines: Vec<_> =
        shown(zoom).map(|(track, class)| curve(zoom, track.method, class, &track.peaks)).collect();
    lines.push(curve(zoom, "reference", "truth", &zoom.peaks));
    chart(map, "largest radiance", None, lines)
}

fn ratios(map: &Minified) -> Chart {
    let zoom = &map.zoom;
    let lines = shown(zoom).map(|(track, class)| {
        let ratios: Vec<_> =
            track.peaks.iter().zip(&zoom.peaks).map(|(peak, right)| peak / right).collect();
        curve(zoom, track.method, class, &ratios)
    });
    chart(map, "largest radiance / reference\u{2019}s", Some(1.0), lines.collect())
}

fn shown(zoom: &Zoom) -> impl Iterator<Item = (&Track, &'static str)> {
    DRAWN.iter().filter_map(|&(name, class)| Some((zoom.track(name)?, class)))
}

fn curve(zoom: &Zoom, name: &str, class: &str, values: &[f64]) -> Curved {
    let points = zoom.ratios.iter().zip(values).map(|(&ratio, &value)| [ratio, value]);
    Curved { name: name.into(), class: class.into(), points: points.collect() }
}

fn chart(map: &Minified, title: &'static str, right: Option<f64>, lines: Vec<Curved>) -> Chart {
    let ends = around(&lines, right, 1.15);
    let ratios = &map.zoom.ratios;
    let widest = [ratios[0], ratios[ratios.len() - 1].max(1.01 * ratios[0])];
    Chart {
        title: format!("{title} over texels per pixel, {}", map.name),
        x: Range::new("texels per pixel", Scale::Binary, widest),
        y: Range::new(title, Scale::Logarithmic, ends),
        right,
        lines,
    }
}

/// Every method, in the order of the other tables.
fn table(zoom: &Zoom) -> Table {
    let rows = zoom.tracks.iter().map(|track| Line {
        cells: vec![
            track.method.into(),
            significant(track.peak_ratio),
            significant(track.peak_deviation),
            significant(track.restlessness),
            significant(track.flicker),
        ],
        class: if track.samples > 1 { "plain" } else { "" },
    });
    Table {
        headers: &["Method", "Peak ratio", "Peak deviation", "Restlessness", "Flicker"],
        rows: rows.collect(),
    }
}

/// Whose peaks stay with the reference's.
fn finding(zoom: &Zoom) -> String {
    let each = |value: fn(&Track) -> f64| {
        let named = [
            name::POINT,
            name::MIPS,
            name::TOKSVIG,
            name::LEAN,
            name::ALONG,
            name::NARROW,
            name::SIXTEEN,
        ];
        let tracks = named.iter().filter_map(|name| zoom.track(name));
        let parts = tracks.map(|track| format!("{} {}", track.method, significant(value(track))));
        parts.collect::<Vec<_>>().join("; ")
    };
    let single = zoom.tracks.iter().filter(|track| track.samples == 1);
    let best =
        single.min_by(|a, b| a.flicker.total_cmp(&b.flicker)).map_or("", |track| track.method);
    format!(
        "The peak over the reference\u{2019}s in the mean: {}. Flicker: {}. Of single samples \
            {best} flickers least.",
        each(|track| track.peak_ratio),
        each(|track| track.flicker),
    )
}
