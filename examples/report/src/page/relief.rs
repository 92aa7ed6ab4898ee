//! LEADR against ray-cast relief on the page: tables and what they say, as HTML and as text.

use super::escape;
use super::spheres;
use super::table::{Line, Table, significant};
use crate::relief::{Errors, Family, Relief, SHOWN, Sphere, Way};

/// The grids in the order of the tables' columns.
pub(super) const GRIDS: [(Family, usize); 12] = [
    (Family::Published, 3),
    (Family::Published, 5),
    (Family::Published, 9),
    (Family::Published, 32),
    (Family::Published, 128),
    (Family::Cells, 3),
    (Family::Cells, 5),
    (Family::Cells, 9),
    (Family::Cells, 32),
    (Family::Hermite, 3),
    (Family::Hermite, 5),
    (Family::Hermite, 9),
];

/// Their headers.
const SIZES: [&str; 12] =
    ["N = 3", "5", "9", "32", "128", "Cells 3", "5", "9", "32", "Hermite 3", "5", "9"];

const DEVIATIONS: &str = "\u{3c3}\u{3b8}, \u{3c3}\u{3c6}";
const HEADERS: [&str; 15] = beside_sizes([DEVIATIONS, "Noise"], ["Normal map"]);
const AREA_HEADERS: [&str; 13] = beside_sizes([DEVIATIONS], []);

/// The grids' headers between others.
const fn beside_sizes<const BEFORE: usize, const AFTER: usize, const ALL: usize>(
    before: [&'static str; BEFORE],
    after: [&'static str; AFTER],
) -> [&'static str; ALL] {
    assert!(ALL == BEFORE + SIZES.len() + AFTER);
    let mut all = [""; ALL];
    let mut k = 0;
    while k < ALL {
        all[k] = if k < BEFORE {
            before[k]
        } else if k < BEFORE + SIZES.len() {
            SIZES[k - BEFORE]
        } else {
            after[k - BEFORE - SIZES.len()]
        };
        k += 1;
    }
    all
}

/// A way to look up and to divide, with the table's title.
const TITLES: [(Way, &str); 5] = [
    (Way::Blurred, "Light averaged over each slope's solid angle, over the sum of weights"),
    (
        Way::Widened,
        "The same over the solid angle that the paper's levels of detail give small grids",
    ),
    (Way::Point, "Light from one direction for each slope, over the sum of weights"),
    (Way::BlurredOverArea, "Averaged light, over the projected area in closed form"),
    (Way::PointOverArea, "Light from one direction, over the projected area in closed form"),
];

const ERROR_NOTE: &str = "RMSE in % of the mean radiance, without the reference's noise, which \
    stands beside it as a \
    pixel's standard error; \u{201c}<\u{201d}: no more than the noise could make up. Cells: the \
    library's own grids. \
    Hermite: Gauss and Hermite's nodes. Normal map: all slopes alike, whatever of them is seen.";

const AREA_NOTE: &str = "Sum of the weights over the projected area in closed form, minus 1, in \
    %: mean of its size over \
    the sphere / largest. Divided by the sum a grid never shows it under even light; divided by \
    the area it does.";

const CLOSED_NOTE: &str = "RMSE in % of the mean, as above. The lamp is the narrowest of the \
    three, alone. Light: what \
    shadows leave of the whole sky's. G2/G1: the same sum with each light weakened by masking and \
    shadowing over masking; \
    masking only: without, against rays that see the shadows. G2 knows of heights, not of \
    azimuths: where eye and light \
    lean the same way over grooves, what the one sees the other reaches, and G2 is too dark.";

/// Tables, pictures, charts, findings.
pub(super) fn html(relief: &Relief) -> String {
    let table = |way: Way| format!("<div class=\"wide\">{}</div>\n", errors(relief, way).html());
    let rest = TITLES[1..]
        .iter()
        .map(|(way, title)| format!("<h4>{}</h4>\n{}", escape(title), table(*way)));
    format!(
        "{}<p class=\"note\">{}</p>\n<p>{}</p>\n{}<h3>{}</h3>\n{}<p class=\"note\">{}</p>\n\
         <details><summary>Other lookups and divisors, and brightness</summary>\n{}<h4>Mean \
         radiance over the \
         reference\u{2019}s, minus 1, in %: averaged light, over the sum</h4>\n<div \
         class=\"wide\">{}</div></details>\n{}\
         <h3>Normalization error</h3>\n<div class=\"wide\">{}</div>\n<p class=\"note\">{}</p>\n\
         <h3>One narrow lamp, and shadows</h3>\n<div class=\"wide\">{}</div>\n<p \
         class=\"note\">{}</p>\n{}",
        include_str!("relief.html"),
        facts(relief),
        escape(&finding(relief)),
        spheres::skies(relief),
        escape(TITLES[0].1),
        table(Way::Blurred),
        escape(ERROR_NOTE),
        rest.collect::<Vec<_>>().concat(),
        biases(relief).html(),
        spheres::charts(relief),
        areas(relief).html(),
        escape(AREA_NOTE),
        closed(relief).html(),
        escape(CLOSED_NOTE),
        spheres::lamps(relief),
    )
}

/// Tables and findings for the terminal.
pub(super) fn text(relief: &Relief) -> String {
    let tables =
        TITLES.iter().map(|(way, title)| format!("\n{title}\n{}", errors(relief, *way).text()));
    format!(
        "\nLEADR against ray-cast relief\n{}\n{}{ERROR_NOTE}\n\nMean radiance over the \
            reference's, minus 1, in %: averaged \
         light, over the sum\n{}\nNormalization error\n{}{AREA_NOTE}\n\nOne narrow lamp, and \
         shadows\n{}{CLOSED_NOTE}\n{}\n",
        facts(relief),
        tables.collect::<Vec<_>>().concat(),
        biases(relief).text(),
        areas(relief).text(),
        closed(relief).text(),
        finding(relief),
    )
}

/// Size of the experiment.
fn facts(relief: &Relief) -> String {
    format!(
        "{0} x {0} pixels, {1} rays per pixel through {2} random fields, half of them for each of \
            two estimates; times at \
         \u{3c3} = 0.5, in f32.",
        relief.side, relief.rays, relief.fields,
    )
}

/// A sphere's deviations.
pub(super) fn name(sphere: &Sphere) -> String {
    let [theta, phi] = sphere.sigma;
    if theta == phi { theta.to_string() } else { format!("{theta}, {phi}") }
}

/// An error that may hide in the noise.
fn percent(errors: &Errors) -> String {
    let floor = errors.rmse.max(errors.least);
    format!("{}{}", if errors.rmse < errors.least { "<" } else { "" }, number(floor))
}

/// In %, two digits behind the point at most.
fn number(x: f64) -> String {
    let x = 100.0 * x;
    let decimals = if x.abs() < 0.995 { 2 } else { usize::from(x.abs() < 99.5) };
    // A true minus, and none before nothing.
    let text = format!("{x:.decimals$}");
    match text.strip_prefix('-') {
        Some(digits) if digits.contains(|c: char| ('1'..='9').contains(&c)) => {
            format!("\u{2212}{digits}")
        }
        Some(digits) => digits.into(),
        None => text,
    }
}

/// RMSE of one way; times in the last row.
fn errors(relief: &Relief, way: Way) -> Table {
    let spheres = relief.spheres.iter().map(|sphere| {
        let grids = GRIDS.map(|(family, count)| {
            sphere.grid(family, count).map_or(String::new(), |grid| percent(grid.error(way)))
        });
        let ends = [percent(&sphere.normal_mapping)];
        let starts = [name(sphere), number(sphere.noise.whole)];
        Line { cells: starts.into_iter().chain(grids).chain(ends).collect(), class: "" }
    });
    let times = GRIDS.map(|(family, count)| {
        relief.speed.grid(family, count).map_or(String::new(), |grid| significant(grid.time(way)))
    });
    let starts = ["ns per pixel".into(), String::new()];
    let cells = starts.into_iter().chain(times).chain([String::new()]).collect();
    Table { headers: &HEADERS, rows: spheres.chain([Line { cells, class: "plain" }]).collect() }
}

/// Mean radiance over the reference's.
fn biases(relief: &Relief) -> Table {
    let rows = relief.spheres.iter().map(|sphere| {
        let grids = GRIDS.map(|(family, count)| {
            let grid = sphere.grid(family, count);
            grid.map_or(String::new(), |grid| number(grid.error(Way::Blurred).bias))
        });
        let starts = [name(sphere), String::new()];
        let ends = [number(sphere.normal_mapping.bias)];
        Line { cells: starts.into_iter().chain(grids).chain(ends).collect(), class: "" }
    });
    Table { headers: &HEADERS, rows: rows.collect() }
}

/// What the grids miss of the projected area.
fn areas(relief: &Relief) -> Table {
    let rows = relief.spheres.iter().map(|sphere| {
        let grids = GRIDS.map(|(family, count)| {
            let errors = sphere.grid(family, count).map(|grid| grid.normalization.map(number));
            errors.map_or(String::new(), |[mean, largest]| format!("{mean} / {largest}"))
        });
        Line { cells: [name(sphere)].into_iter().chain(grids).collect(), class: "" }
    });
    Table { headers: &AREA_HEADERS, rows: rows.collect() }
}

/// The lamp alone, and all lights with shadows.
fn closed(relief: &Relief) -> Table {
    let rows = relief.spheres.iter().map(|sphere| {
        let (lamp, dark) = (&sphere.lamp, &sphere.shadowed);
        let cells = vec![
            name(sphere),
            number(sphere.noise.lamp),
            percent(&lamp.point),
            percent(&lamp.all),
            percent(&lamp.grid),
            number(sphere.noise.lamp_shadowed),
            percent(&dark.lamp),
            percent(&dark.lamp_masking_only),
            number(sphere.unshadowed),
            percent(&dark.whole),
            number(dark.whole.bias),
            percent(&dark.whole_masking_only),
        ];
        Line { cells, class: "" }
    });
    let headers = &[
        DEVIATIONS,
        "Lamp: noise",
        "closed form, a point",
        "all of the lamp",
        "32 x 32",
        "Shadows: noise",
        "closed form",
        "masking only",
        "Sky: light",
        "32 x 32, G2/G1",
        "brightness",
        "masking only",
    ];
    debug_assert_eq!(SHOWN, 32);
    let mut rows: Vec<_> = rows.collect();
    let mut times = vec![String::new(); headers.len()];
    (times[0], times[2]) = ("ns per pixel".into(), significant(relief.speed.closed));
    rows.push(Line { cells: times, class: "plain" });
    Table { headers, rows }
}

/// One paragraph: how near the grids come, what they cost, what holds without a grid.
fn finding(relief: &Relief) -> String {
    let worst = |of: &dyn Fn(&Sphere) -> Option<Errors>| {
        let all = relief.spheres.iter().filter_map(|sphere| Some((of(sphere)?, sphere)));
        let largest = all.max_by(|a, b| a.0.rmse.total_cmp(&b.0.rmse));
        largest.map_or(String::new(), |(errors, sphere)| {
            format!("{} % (\u{3c3} = {})", number(errors.rmse.max(errors.least)), name(sphere))
        })
    };
    let grid = |family: Family, count: usize, way: Way| {
        worst(&move |sphere| Some(*sphere.grid(family, count)?.error(way)))
    };
    let area = |family: Family, count: usize| {
        let grids = relief.spheres.iter().filter_map(|sphere| sphere.grid(family, count));
        number(grids.map(|grid| grid.normalization[1]).fold(0.0, f64::max))
    };
    let published = Family::Published;
    format!(
        "At worst over the spheres, 128 x 128 slopes err by {} against the rays, 32 x 32 by {}, 5 \
            x 5 by {}, or {} if each slope \
         takes its light from one direction only; normal mapping errs by {}. The library\u{2019}s \
         cells err by {} with 9 x 9 slopes, \
         where the published grid errs by {}. Of the area the published 5 x 5 slopes miss up to \
         {} %, the cells {} %; 128 x 128 still \
         {} %, as they end at 3 deviations. With shadows 32 x 32 slopes and G2/G1 err by {}, \
         masking alone by {}.",
        grid(published, 128, Way::Blurred),
        grid(published, 32, Way::Blurred),
        grid(published, 5, Way::Blurred),
        grid(published, 5, Way::Point),
        worst(&|sphere| Some(sphere.normal_mapping)),
        grid(Family::Cells, 9, Way::Blurred),
        grid(published, 9, Way::Blurred),
        area(published, 5),
        area(Family::Cells, 5),
        area(published, 128),
        worst(&|sphere| Some(sphere.shadowed.whole)),
        worst(&|sphere| Some(sphere.shadowed.whole_masking_only)),
    )
}

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn percents_are_short_and_nothing_has_no_sign() {
        let cases = [
            (0.123, "12.3"),
            (-0.0031, "\u{2212}0.31"),
            (-1e-9, "0.00"),
            (0.001_234, "0.12"),
            (4.05, "405"),
        ];
        for (x, text) in cases {
            assert_eq!(number(x), text);
        }
    }
}
