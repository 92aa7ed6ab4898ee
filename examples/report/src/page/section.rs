//! A scene's part of the page, and the same as text for the terminal.

use super::picture::{self, Tone};
use super::table::{Line, Table, significant};
use super::{escape, plot};
use crate::method::Distribution;
use crate::study::{Panel, Row, Study};

/// A reference whose noise exceeds this part of the best filter's error is not called converged.
const CONVERGED: f64 = 0.1;

/// Width of a column of pictures, as in style.css.
const COLUMN: usize = 560;

/// What stands for a number that there is none of.
const NONE: &str = "\u{2013}";

/// Plots, tables, pictures.
pub(super) fn html(study: &Study) -> String {
    let plots = study.panels.iter().map(|panel| {
        format!("<figure><h3>{}</h3>\n{}</figure>\n", panel.distribution.name(), plot::svg(panel))
    });
    let tables = study.panels.iter().map(|panel| {
        let warnings = warnings(panel)
            .into_iter()
            .map(|warning| format!("<p class=\"note warning\">{}</p>\n", escape(&warning)));
        format!(
            "<h3>{}</h3>\n{}<p class=\"note\">{}</p>\n{}",
            panel.distribution.name(),
            table(panel).html(),
            noise(panel),
            warnings.collect::<Vec<_>>().concat(),
        )
    });
    let ggx = study.panels.iter().filter(|panel| panel.distribution == Distribution::Ggx);
    format!(
        "<h2>{}</h2>\n<p class=\"caption\">{} {} x {} pixels; geometry {} ns per sample.</p>\n\
         <div class=\"plots\">\n{}</div>\n{}{}",
        escape(&study.name),
        escape(&study.caption),
        study.size.width,
        study.size.height,
        significant(study.geometry),
        plots.collect::<Vec<_>>().concat(),
        tables.collect::<Vec<_>>().concat(),
        ggx.map(|panel| pictures(study, panel)).collect::<Vec<_>>().concat(),
    )
}

/// The same for the terminal, without plots and pictures.
pub(crate) fn text(study: &Study) -> String {
    let head = format!(
        "\n{}\n{}\nGeometry: {} ns per sample.\n",
        study.name,
        study.caption,
        significant(study.geometry)
    );
    let panels = study.panels.iter().map(|panel| {
        let warnings = warnings(panel).into_iter().map(|warning| format!("Warning: {warning}\n"));
        format!(
            "\n{}\n{}{}\n{}",
            panel.distribution.name(),
            table(panel).text(),
            noise(panel),
            warnings.collect::<Vec<_>>().concat(),
        )
    });
    head + &panels.collect::<Vec<_>>().concat()
}

fn table(panel: &Panel) -> Table {
    let best = panel.best().map(|row| &row.name);
    let rows = panel.rows.iter().map(|row| {
        let errors = row.errors;
        let energy =
            if errors.energy.is_finite() { format!("{:.3}", errors.energy) } else { NONE.into() };
        Line {
            cells: vec![
                row.name.clone(),
                row.samples.to_string(),
                significant(errors.rmse),
                significant(errors.rel_mse),
                energy,
                significant(errors.worst),
                significant(row.shading),
                significant(row.pixel),
                equal_samples(row),
                equal_time(row),
            ],
            class: match row.filters {
                true if Some(&row.name) == best => "best",
                true => "",
                false => "plain",
            },
        }
    });
    Table {
        headers: &[
            "Method",
            "Samples",
            "RMSE",
            "relMSE",
            "Energy",
            "Worst",
            "Shading ns",
            "ns per pixel",
            "Equal samples",
            "Equal time",
        ],
        rows: rows.collect(),
    }
}

/// Samples of supersampling at the row's error.
pub(super) fn equal_samples(row: &Row) -> String {
    row.equal_samples.map_or(NONE.into(), |price| price.to_string())
}

/// Time of supersampling at the row's error, over the row's.
pub(super) fn equal_time(row: &Row) -> String {
    row.speed_up.map_or(NONE.into(), |price| format!("{price}\u{d7}"))
}

fn noise(panel: &Panel) -> String {
    let [of_best, of_least] = panel.noise_ratios().map(|ratio| 100.0 * ratio);
    format!(
        "Noise of the reference: {}, {of_best:.2} % of the best filter\u{2019}s RMSE, {of_least:.1} % of \
         the smallest above.",
        significant(panel.noise),
    )
}

/// What a reader must know before trusting a panel.
fn warnings(panel: &Panel) -> Vec<String> {
    let unsure = (panel.noise_ratios()[0] > CONVERGED).then(|| {
        "The reference is not converged: read the smallest errors as upper bounds.".to_owned()
    });
    let worse = panel
        .worse_than_plain()
        .map(|row| format!("{} has a larger RMSE than no filter here.", row.name));
    unsure.into_iter().chain(worse).collect()
}

/// Unfiltered, best and reference of the first distribution side by side, as a PNG file.
pub(super) fn cover(study: &Study) -> Option<Vec<u8>> {
    let panel = study.panels.first()?;
    let scaled = |picture: &[f32]| -> Vec<f64> {
        picture.iter().map(|&x| f64::from(x) * panel.scale).collect()
    };
    let (plain, best) = (scaled(&panel.plain()?.picture), scaled(&panel.best()?.picture));
    let reference: Vec<_> = panel.reference.iter().map(|r| r * panel.scale).collect();
    Some(Tone::of(&reference).strip(study.size, &[&plain, &best, &reference]))
}

/// Unfiltered, best, reference and the difference of the last two.
fn pictures(study: &Study, panel: &Panel) -> String {
    let (Some(plain), Some(best)) = (panel.plain(), panel.best()) else { return String::new() };
    let scaled = |picture: &[f32]| -> Vec<f64> {
        picture.iter().map(|&x| f64::from(x) * panel.scale).collect()
    };
    let (plain, filtered) = (scaled(&plain.picture), scaled(&best.picture));
    let reference: Vec<_> = panel.reference.iter().map(|r| r * panel.scale).collect();
    let difference: Vec<_> = filtered.iter().zip(&reference).map(|(x, r)| (x - r).abs()).collect();
    let (scene, name) = (escape(&study.name), escape(&best.name));

    let tone = Tone::of(&reference);
    // Whole multiples keep pixels square and of one size.
    let zoom = (COLUMN / study.size.width).max(1);
    let figures = [
        ("No filter, 1 sample per pixel".into(), &plain),
        (format!("Best filter, {name}, 1 sample per pixel"), &filtered),
        ("Reference".into(), &reference),
        (format!("|{name} \u{2212} reference|"), &difference),
    ];
    let figures = figures.map(|(caption, values)| {
        format!(
            "<figure><img alt=\"{scene}: {caption}\" width=\"{}\" height=\"{}\" src=\"{}\">\
             <figcaption>{caption}</figcaption></figure>\n",
            zoom * study.size.width,
            zoom * study.size.height,
            tone.data_url(study.size, values),
        )
    });
    format!(
        "<div class=\"pictures\">\n{}</div>\n<p class=\"note\">{}, all four under the same tone curve, \
         1 \u{2212} exp(\u{2212}kx) in sRGB: the reference\u{2019}s 99th percentile, {} times its mean, \
         is {:.0} % of white.</p>\n",
        figures.concat(),
        panel.distribution.name(),
        significant(tone.bright),
        100.0 * picture::WHITE,
    )
}
