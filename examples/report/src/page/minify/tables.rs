//! The tables of minified maps: over texels per pixel, against run time, over the view's elevation.

use super::{sweep, swept};
use crate::method::Distribution;
use crate::minify::{ELEVATIONS, GRAZED, Minified, Panel, Row, SHOWN, methods, name};
use crate::page::table::{Line, Table, significant};

/// Headings and tables: over the ratio for every distribution and alpha, against run time, over the
/// elevation.
pub(super) fn tables(map: &Minified) -> Vec<(String, Table)> {
    let mut alphas: Vec<f64> = map.panels.iter().map(|panel| panel.alpha).collect();
    alphas.dedup();
    alphas.sort_by(f64::total_cmp);
    alphas.dedup();
    let mut tables = Vec::new();
    for distribution in Distribution::ALL {
        for &alpha in &alphas {
            let heading =
                format!("{}, alpha {alpha}: RMSE by texels per pixel", distribution.name());
            tables.push((heading, by_ratio(map, distribution, alpha)));
        }
        for panel in sweep(map, distribution).filter(|panel| SHOWN.contains(&panel.ratio)) {
            let heading = format!(
                "{}, alpha {}, {} texels per pixel: error against run time",
                distribution.name(),
                panel.alpha,
                panel.ratio
            );
            tables.push((heading, against_time(panel)));
        }
        let heading = format!(
            "{}, alpha {}, {GRAZED} texels per pixel across the view: RMSE and energy by its \
                elevation",
            distribution.name(),
            map.alpha()
        );
        tables.push((heading, by_elevation(map, distribution)));
    }
    tables
}

/// As [`RATIOS`].
const BY_RATIO: [&str; 8] = ["Method", "1", "2", "4", "8", "16", "32", "64"];

fn by_ratio(map: &Minified, distribution: Distribution, alpha: f64) -> Table {
    let panels: Vec<_> = swept(map, distribution, alpha).collect();
    table(&BY_RATIO, &panels, |panel| vec![panel.noise.into()], |row| vec![row.errors.rmse.into()])
}

/// As [`ELEVATIONS`], RMSE and energy.
const BY_ELEVATION: [&str; 9] = [
    "Method", "90\u{b0}", "energy", "45\u{b0}", "energy", "15\u{b0}", "energy", "5\u{b0}", "energy",
];

fn by_elevation(map: &Minified, distribution: Distribution) -> Table {
    let find = |&elevation: &f64| {
        map.of(distribution, map.alpha()).find(|p| p.elevation == elevation && p.ratio == GRAZED)
    };
    let panels: Vec<_> = ELEVATIONS.iter().filter_map(find).collect();
    table(
        &BY_ELEVATION,
        &panels,
        |panel| vec![Some(panel.noise), None],
        |row| vec![Some(row.errors.rmse), Some(row.errors.energy)],
    )
}

/// A line for every method and one for the noise, cells from every panel.
fn table(
    headers: &'static [&'static str],
    panels: &[&Panel],
    noise: fn(&Panel) -> Vec<Option<f64>>,
    of: fn(&Row) -> Vec<Option<f64>>,
) -> Table {
    let shown = |values: Vec<Option<f64>>| {
        values.into_iter().map(|value| value.map_or(String::new(), significant))
    };
    let names = panels
        .first()
        .into_iter()
        .flat_map(|panel| panel.rows.iter().map(|row| (row.method, row.is_plain())));
    let lines = names.map(|(name, plain)| {
        let cells =
            panels.iter().filter_map(|panel| panel.row(name)).flat_map(|row| shown(of(row)));
        Line {
            cells: [name.to_owned()].into_iter().chain(cells).collect(),
            class: if plain { "plain" } else { "" },
        }
    });
    let noise = panels.iter().flat_map(|panel| shown(noise(panel)));
    let last = Line {
        cells: ["reference\u{2019}s noise".to_owned()].into_iter().chain(noise).collect(),
        class: "plain",
    };
    Table { headers, rows: lines.chain([last]).collect() }
}

fn against_time(panel: &Panel) -> Table {
    let best = panel.best().map(|row| row.method);
    let rows = panel.rows.iter().map(|row| Line {
        cells: vec![
            row.method.into(),
            significant(row.time.unwrap_or(f64::NAN)),
            significant(row.errors.rmse),
            significant(row.errors.smape),
            significant(row.errors.energy),
            row.equal_time.map_or("\u{2013}".into(), |price| format!("{price}\u{d7}")),
        ],
        class: match row {
            row if row.is_plain() || row.method == name::EXACT => "plain",
            row if Some(row.method) == best => "best",
            _ => "",
        },
    });
    Table {
        headers: &["Method", "ns per pixel", "RMSE", "SMAPE", "Energy", "Equal time"],
        rows: rows.collect(),
    }
}

/// What the methods are.
pub(super) fn legend() -> Table {
    let rows = methods()
        .into_iter()
        .map(|method| Line { cells: vec![method.name.into(), method.note.into()], class: "" });
    Table { headers: &["Method", "What it does"], rows: rows.collect() }
}

#[cfg(test)]
mod tests {
    use super::{BY_ELEVATION, BY_RATIO};
    use crate::minify::{ELEVATIONS, RATIOS, methods};
    use crate::page::minify::DRAWN;

    #[test]
    fn headers_are_the_ratios_and_elevations_and_curves_are_methods() {
        assert_eq!(BY_RATIO[1..], RATIOS.map(|ratio| ratio.to_string()));
        let headers = ELEVATIONS.map(|degrees| [format!("{degrees}\u{b0}"), "energy".into()]);
        assert_eq!(BY_ELEVATION[1..], headers.concat());
        let all = methods();
        assert!(DRAWN.iter().all(|(name, _)| all.iter().any(|method| method.name == *name)));
    }
}
