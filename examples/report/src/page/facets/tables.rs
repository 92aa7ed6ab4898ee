//! The tables of facets, and what their columns mean.

use crate::facets::{Entry, Filter, Lobes, Memory, Swept, Trial, Zoom};
use crate::page::axis::plain;
use crate::page::table::{Line, Table, significant};

pub(super) const FILTERS_NOTE: &str = "RMSE over all pixels on the body: as it is, and in means \
    of the reference; energy: mean over \
    the reference\u{2019}s. Time: the lobe alone, from directions and derivatives that are there, \
    for both lights. Overhead: over \
    that of none. The paper\u{2019}s 0.6 to 4.2 % are of whole frames on a GeForce RTX 2080, \
    where a texture unit does what mips \
    do here in software: of their time nothing follows for a GPU. Dotted: the reference\u{2019}s \
    own error.";

pub(super) const SWEEP_NOTE: &str = "The same tube and lights, references of fewer samples; RMSE \
    in means. Unsure: \
    by less than two standard errors of the pixels\u{2019} squares. A kernel as wide as s_K 1 \
    blurs highlights that are about as wide as a pixel, and \
    evens out facets that s_K 0.5 leaves too lively.";

pub(super) const BEADS_NOTE: &str = "Both kinds of LEAN take the box on the disk. Each pixel in \
    the frame of its mean normal, \
    in which the map\u{2019}s covariance and the half vector\u{2019}s derivatives are taken. \
    Dotted: the reference\u{2019}s own error.";

pub(super) const MAPPINGS_NOTE: &str = "Normals with the box on the disk, in the frame of the \
    mean normal; LEAN by probes \
    along the pixel (Olano & Baker 2010); beside it other filters: where a map spreads the lobe \
    over much more than \
    half vectors move, they change little. Without \u{3c1} the covariance has no entry off its \
    diagonal, as in Chermain et al. \
    2020. Samples have the map\u{2019}s own slope. Energy above 1: a lobe shows facets by their \
    projected area, so steep ones that face \
    the eye larger, where a map\u{2019}s texels all count alike. Dotted: the reference\u{2019}s \
    own error.";

pub(super) const LOBES_NOTE: &str = "Densities of slopes over the plane of slopes, within 4.2 \
    deviations, each under a tone curve of \
    its own (Fig. 10). Found: the correlation of what is drawn; of few lobes it is their own.";

pub(super) const ZOOM_NOTE: &str = "From step to step the camera is twice as far from one ball \
    with one texture, the last time with all \
    of it in the picture, so that facets in a pixel get four times as many and half vectors \
    change twice as fast. RMSE in means of references \
    as above. Both rows under the tone of the filtered picture.";

pub(super) const MEMORY_NOTE: &str = "192 marginals, 16 levels, 64 intervals. Published: \
    half-precision densities; mips take them times \
    127/64. The paper says 512 KiB with mips, a third more, which is the rule for pictures: of \
    rows, mips take as much again but \
    for one texel.";

fn line(cells: Vec<String>) -> Line {
    Line { cells, class: "" }
}

fn percent(share: f64) -> String {
    format!("{:.1} %", 100.0 * share).replace('-', "\u{2212}")
}

/// What all trials have.
fn measured(trial: &Trial, entry: &Entry) -> Vec<String> {
    vec![
        entry.name.into(),
        significant(trial.mean * entry.errors.rmse),
        significant(entry.errors.rmse),
        format!("{:.3}", entry.errors.energy),
        significant(1e-3 * entry.time),
    ]
}

/// Samples and none are what filters stand against.
fn class(entry: &Entry) -> &'static str {
    if entry.filter == Filter::None { "plain" } else { "" }
}

/// All methods on one stage.
pub(super) fn contest(trial: &Trial) -> Table {
    let rows = trial.entries.iter().map(|entry| {
        let overhead = trial.overhead(entry).map_or("\u{2013}".into(), percent);
        Line { cells: [measured(trial, entry), vec![overhead]].concat(), class: class(entry) }
    });
    let paper = ["paper, whole frames", "", "", "", "", "0.6\u{2013}4.2 %"].map(String::from);
    let paper = Line { cells: paper.into(), class: "plain" };
    let headers = &["Method", "RMSE", "in means", "Energy", "\u{b5}s per pixel", "Overhead"];
    Table { headers, rows: rows.chain([paper]).collect() }
}

/// Roughness and facets.
pub(super) fn sweep(swept: &[Swept]) -> Table {
    let rows = swept.iter().map(|swept| {
        let starts = [swept.alpha.to_string(), plain(swept.facets)];
        let ordered = swept.is_ordered().map_or("unsure", |yes| if yes { "yes" } else { "no" });
        let ends = [significant(swept.noise), ordered.into()];
        let errors = swept.errors.map(significant);
        line(starts.into_iter().chain(errors).chain(ends).collect())
    });
    let headers = &[
        "\u{3b1}",
        "Facets in a pixel",
        "None",
        "Mips, s_K 0.5",
        "s_K 1",
        "Box",
        "Noise",
        "0.5 nearer than 1",
    ];
    Table { headers, rows: rows.collect() }
}

/// A number of facets; beyond a dictionary's levels they are as good as all.
pub(super) fn amount(facets: f64) -> String {
    if facets < 1e9 { format!("{} facets", plain(facets)) } else { "smooth".into() }
}

/// Lobes of few facets and of many.
pub(super) fn lobes(lobes: &Lobes) -> Table {
    let rows = lobes.shown.iter().map(|shown| {
        line(vec![
            amount(shown.facets),
            shown.correlation.to_string(),
            format!("{:.3}", shown.integral),
            // Of nothing, a rounding error has a sign.
            format!("{:.3}", shown.found + 0.0).replace("-0.000", "0.000").replace('-', "\u{2212}"),
        ])
    });
    Table { headers: &["Facets", "\u{3c1}", "Integral", "\u{3c1} found"], rows: rows.collect() }
}

/// Steps of the zoom.
pub(super) fn zoom(zoom: &Zoom) -> Table {
    let rows = zoom.frames.iter().map(|frame| {
        let [none, filtered] = frame.errors.map(significant);
        line(vec![plain(frame.facets), format!("{:.0}", frame.radius), none, filtered])
    });
    let headers = &["Facets in a pixel", "Radius, pixels", "RMSE: none", "box"];
    Table { headers, rows: rows.collect() }
}

/// Bytes of dictionaries.
pub(super) fn memory(memory: Memory) -> Table {
    let rows = [
        ("published, no filter", memory.published, "384"),
        ("published, with mips", memory.mips, "512"),
        ("density and cumulative in f32, any filter", memory.ours, "\u{2013}"),
    ];
    let rows = rows.map(|(name, bytes, paper)| {
        line(vec![name.into(), significant(bytes as f64 / 1024.0), paper.into()])
    });
    Table { headers: &["Dictionary", "KiB", "Paper"], rows: rows.into() }
}
