//! Minified normal maps on the page: error over texels per pixel, against run time, at grazing
//! angles; pictures.

mod finding;
mod tables;

use super::axis::Scale;
use super::chart::{Chart, Line as Curved, Range, around};
use super::kernels::drawn;
use super::picture::Tone;
use super::table::significant;
use super::{escape, zoom};
use crate::method::Distribution;
use crate::minify::{Minified, Panel, RATIOS, STEEPEST, SWEPT, TURN, name};
use finding::finding;
use tables::{legend, tables};

/// The methods that charts show, with their CSS classes.
pub(super) const DRAWN: [(&str, &str); 10] = [
    (name::POINT, "nothing"),
    (name::SIXTEEN, "nothing second"),
    (name::MIPS, "published"),
    (name::TOKSVIG, "published second"),
    (name::CLEAN, "added second"),
    (name::LEAN, "added"),
    (name::ALONG, "peak"),
    (name::NARROW, "peak second"),
    (name::UNMASKED, "peak third"),
    (name::EXACT, "exact"),
];

/// All maps.
pub(super) fn html(maps: &[Minified]) -> String {
    if maps.is_empty() {
        return String::new();
    }
    let sections = maps.iter().map(|map| {
        let charts = Distribution::ALL.map(|d| drawn(d.name(), &chart(map, d)));
        format!(
            "<h3>{}</h3>\n<p class=\"caption\">{}</p>\n<p>{}</p>\n<div class=\"plots\">\n{}</div>\n\
             {}<details><summary>Tables</summary>\n<div class=\"wide\">{}</div></details>\n{}",
            escape(&map.name),
            escape(&facts(map)),
            escape(&finding(map)),
            charts.concat(),
            pictures(map),
            tables(map)
                .into_iter()
                .map(|(title, table)| format!("<h4>{}</h4>\n{}", escape(&title), table.html()))
                .collect::<Vec<_>>()
                .concat(),
            zoom::html(map),
        )
    });
    format!(
        "{}{}<h3>Methods</h3>\n<div class=\"methods\">{}</div>\n",
        include_str!("minify.html"),
        sections.collect::<Vec<_>>().concat(),
        legend().html(),
    )
}

/// One map for the terminal.
pub(crate) fn text(map: &Minified) -> String {
    let tables = tables(map).into_iter().map(|(title, table)| format!("{title}\n{}", table.text()));
    format!(
        "\nnormal map, minified: {}\n{}\n{}{}\n{}",
        map.name,
        facts(map),
        tables.collect::<Vec<_>>().concat(),
        finding(map),
        zoom::text(map),
    )
}

fn facts(map: &Minified) -> String {
    let [width, height] = map.map;
    let samples = map.panels.iter().map(|panel| panel.reference_samples);
    format!(
        "{width} x {height} texels, slopes of deviation {} and kurtosis {} (a Gaussian has 3), {} \
            of \
         them steeper than {STEEPEST} and shortened. {} x {} pixels, view {SWEPT} degrees high \
         and {TURN} off the texture\u{2019}s axes, {}; reference of {} to {} samples \
         per pixel.",
        significant(map.deviation),
        significant(map.kurtosis),
        percent(map.clipped),
        map.size.width,
        map.size.height,
        map.light.name(),
        samples.clone().min().unwrap_or_default(),
        samples.max().unwrap_or_default(),
    )
}

fn percent(part: f64) -> String {
    format!("{} %", significant(100.0 * part))
}

/// The panels of the sweep at the first alpha.
fn sweep(map: &Minified, distribution: Distribution) -> impl Iterator<Item = &Panel> + Clone {
    swept(map, distribution, map.alpha())
}

fn swept(
    map: &Minified,
    distribution: Distribution,
    alpha: f64,
) -> impl Iterator<Item = &Panel> + Clone {
    map.of(distribution, alpha).filter(|panel| panel.elevation == SWEPT)
}

/// RMSE over texels per pixel.
fn chart(map: &Minified, distribution: Distribution) -> Chart {
    let panels = sweep(map, distribution);
    let curve = |name: &str, class: &str, value: &dyn Fn(&Panel) -> f64| Curved {
        name: name.into(),
        class: class.into(),
        points: panels
            .clone()
            .map(|panel| [panel.ratio, value(panel)])
            .filter(|p| p[1] > 0.0)
            .collect(),
    };
    let mut lines: Vec<_> =
        DRAWN.iter().map(|&(name, class)| curve(name, class, &|panel| panel.rmse(name))).collect();
    lines.push(curve("reference\u{2019}s noise", "truth third", &|panel| panel.noise));
    let ends = around(&lines, None, 1.2);
    Chart {
        title: format!("RMSE over texels per pixel, {}, {}", map.name, distribution.name()),
        x: Range::new("texels per pixel", Scale::Binary, [RATIOS[0], RATIOS[RATIOS.len() - 1]]),
        y: Range::new("RMSE, mean radiance = 1", Scale::Logarithmic, ends),
        right: None,
        lines,
    }
}

/// Width of a column of small pictures, as in style.css.
const COLUMN: usize = 384;

/// Reference and a few methods at some ratios, under one tone curve each.
fn pictures(map: &Minified) -> String {
    let shown = [name::POINT, name::MIPS, name::TOKSVIG, name::LEAN, name::UNMASKED];
    let panels =
        sweep(map, Distribution::Ggx).filter_map(|panel| Some((panel, panel.reference.as_ref()?)));
    // Whole multiples keep pixels square and of one size.
    let zoom = (COLUMN / map.size.width).max(1);
    let rows = panels.map(|(panel, reference)| {
        let tone = Tone::of(reference);
        let pictures = shown.iter().filter_map(|name| {
            let picture = panel.row(name)?.picture.as_ref()?;
            Some((*name, picture.iter().map(|&x| f64::from(x)).collect::<Vec<_>>()))
        });
        let all = [("reference", reference.clone())].into_iter().chain(pictures);
        let figures = all.map(|(name, values)| {
            let caption = format!("{name}, {} texels per pixel", panel.ratio);
            format!(
                "<figure><img alt=\"{}: {caption}\" width=\"{}\" height=\"{}\" \
                    src=\"{}\"><figcaption>{caption}</figcaption></figure>\n",
                escape(&map.name),
                zoom * map.size.width,
                zoom * map.size.height,
                tone.data_url(map.size, &values)
            )
        });
        format!("<div class=\"pictures small\">\n{}</div>\n", figures.collect::<Vec<_>>().concat())
    });
    rows.collect::<Vec<_>>().concat()
}
