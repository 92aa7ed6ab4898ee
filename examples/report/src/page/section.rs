//! A scene's part of the page, and the same as text for the terminal.

use super::gallery::pictures;
use super::table::{Line, Table, significant};
use super::{escape, plot};
use crate::method::Distribution;
use crate::metric::Errors;
use crate::study::{Panel, Row, Study};
use crate::window::PixelWindow;

/// A reference whose noise exceeds this part of the best filter's error is not called converged.
const CONVERGED: f64 = 0.1;

/// What stands for a number that there is none of.
const NONE: &str = "\u{2013}";

/// The panels that are shown in full: the first light at the smallest alpha.
pub(super) fn leading(study: &Study) -> &[Panel] {
    &study.panels[..Distribution::ALL.len().min(study.panels.len())]
}

/// Plots, tables, pictures.
pub(super) fn html(study: &Study) -> String {
    let plots = leading(study).iter().map(|panel| {
        format!("<figure><h3>{}</h3>\n{}</figure>\n", panel.distribution.name(), plot::svg(panel))
    });
    let tables = leading(study).iter().map(|panel| {
        let warnings = warnings(panel)
            .into_iter()
            .map(|warning| format!("<p class=\"note warning\">{}</p>\n", escape(&warning)));
        format!(
            "<h3>{}</h3>\n<div class=\"wide\">{}</div>\n<p class=\"note\">{}</p>\n{}\
             <details><summary>Every method against the box pixel</summary>\n{}</details>\n",
            heading(panel),
            table(panel).html(),
            noise(panel),
            warnings.collect::<Vec<_>>().concat(),
            box_table(panel).html(),
        )
    });
    let rest = study.panels[leading(study).len()..].iter().map(|panel| {
        format!(
            "<h4>{}</h4>\n{}<p class=\"note\">{}</p>\n",
            heading(panel),
            compact_table(panel).html(),
            noise(panel),
        )
    });
    let rest = rest.collect::<Vec<_>>().concat();
    let rest = if rest.is_empty() {
        rest
    } else {
        format!("<details><summary>Other lights and alphas</summary>\n{rest}</details>\n")
    };
    format!(
        "<h2>{}</h2>\n<p class=\"caption\">{} {}</p>\n\
         <div class=\"plots\">\n{}</div>\n{}{}{rest}",
        escape(&study.name),
        escape(&study.caption),
        escape(&facts(study)),
        plots.collect::<Vec<_>>().concat(),
        leading(study).iter().map(|panel| pictures(study, panel)).collect::<Vec<_>>().concat(),
        tables.collect::<Vec<_>>().concat(),
    )
}

/// Light, alpha and distribution.
fn heading(panel: &Panel) -> String {
    format!("{}, {}, alpha {}", panel.distribution.name(), panel.light.name(), panel.alpha)
}

/// Size, what is judged, times and footprints of a scene.
fn facts(study: &Study) -> String {
    let footprints = study.disagreement.as_ref().map_or(String::new(), |footprints| {
        format!(
            " Footprints from quads differ from analytic ones by {:.0} % in the mean, {:.0} % in \
                the median.",
            100.0 * footprints.mean,
            100.0 * footprints.median,
        )
    });
    format!(
        "{} x {} pixels, {:.0} % of them judged; {:.0} samples per pixel in the reference; \
            geometry {} ns per sample, {} ns more with motions.{footprints}",
        study.size.width,
        study.size.height,
        100.0 * study.judged_part(),
        study.reference_samples,
        significant(study.geometry),
        significant(study.motion),
    )
}

/// The same for the terminal, without plots and pictures.
pub(crate) fn text(study: &Study) -> String {
    let head = format!("\n{}\n{}\n{}\n", study.name, study.caption, facts(study));
    let leading_panels = leading(study).iter().map(|panel| {
        let warnings = warnings(panel).into_iter().map(|warning| format!("Warning: {warning}\n"));
        format!(
            "\n{}\n{}{}\n{}",
            heading(panel),
            table(panel).text(),
            noise(panel),
            warnings.collect::<Vec<_>>().concat(),
        )
    });
    let rest = study.panels[leading(study).len()..].iter().map(|panel| {
        format!("\n{}\n{}{}\n", heading(panel), compact_table(panel).text(), noise(panel))
    });
    head + &leading_panels.chain(rest).collect::<Vec<_>>().concat()
}

/// Errors against the methods' own pixel filters, and times.
fn table(panel: &Panel) -> Table {
    let best = panel.best().map(|row| &row.name);
    let rows = panel.rows.iter().map(|row| {
        let errors = row.errors;
        Line {
            cells: vec![
                row.name.clone(),
                row.window.name().into(),
                significant(errors.rmse),
                significant(panel.noise_of(row)),
                significant(errors.rel_mse),
                significant(errors.smape),
                energy(&errors),
                significant(errors.worst),
                significant(row.shading),
                significant(row.pixel),
                if row.pareto { "yes" } else { "" }.into(),
                equal_samples(row),
                equal_time(row),
            ],
            class: class(row, best),
        }
    });
    Table {
        headers: &[
            "Method",
            "Pixel filter",
            "RMSE",
            "Noise",
            "relMSE",
            "SMAPE",
            "Energy",
            "Worst",
            "Shading ns",
            "ns per pixel",
            "Front",
            "Equal samples",
            "Equal time",
        ],
        rows: rows.collect(),
    }
}

/// Errors of every method against the box, noise beside them.
fn box_table(panel: &Panel) -> Table {
    let noise = panel.noise[PixelWindow::Box as usize];
    let rows = panel.rows.iter().map(|row| {
        let errors = row.box_errors;
        Line {
            cells: vec![
                row.name.clone(),
                significant(errors.rmse),
                significant(noise),
                significant(errors.rel_mse),
                significant(errors.smape),
                energy(&errors),
                significant(errors.worst),
            ],
            class: class(row, None),
        }
    });
    let headers = &["Method", "RMSE", "Noise", "relMSE", "SMAPE", "Energy", "Worst"];
    Table { headers, rows: rows.collect() }
}

/// One line per method for the other lights and alphas.
fn compact_table(panel: &Panel) -> Table {
    let best = panel.best().map(|row| &row.name);
    let rows = panel.rows.iter().map(|row| Line {
        cells: vec![
            row.name.clone(),
            significant(row.errors.rmse),
            significant(row.errors.smape),
            significant(row.box_errors.rmse),
            significant(row.box_errors.smape),
            equal_samples(row),
            equal_time(row),
        ],
        class: class(row, best),
    });
    let headers =
        &["Method", "RMSE", "SMAPE", "RMSE, box", "SMAPE, box", "Equal samples", "Equal time"];
    Table { headers, rows: rows.collect() }
}

/// CSS class of a row.
fn class(row: &Row, best: Option<&String>) -> &'static str {
    match row.filters {
        true if Some(&row.name) == best => "best",
        true => "",
        false => "plain",
    }
}

/// The energy ratio, with three decimals.
fn energy(errors: &Errors) -> String {
    if errors.energy.is_finite() { format!("{:.3}", errors.energy) } else { NONE.into() }
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
    let [of_best, of_most] = panel.noise_ratios().map(|ratio| 100.0 * ratio);
    format!(
        "Noise of the box reference: {}. Noise of each method\u{2019}s reference: {of_best:.2} % \
            of the best \
         filter\u{2019}s RMSE, at most {of_most:.1} % of any.",
        significant(panel.noise[PixelWindow::Box as usize]),
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
