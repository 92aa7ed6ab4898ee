//! What the figures of facets show, in numbers.

use super::tables::amount;
use crate::facets::{
    ASKEW, BEAD_TEXELS, Frame, Lobes, Memory, RADIUS, SURE, Swept, TEXELS, Trial, Zoom, name,
};
use crate::page::axis::plain;
use crate::page::table::significant;

/// What was looked at.
fn facts(trial: &Trial) -> String {
    format!(
        "\u{3b1} {}, {} facets in a pixel, {} pixels; reference of {} samples, error {} of the \
            mean.",
        trial.alpha,
        plain(trial.facets),
        trial.pixels,
        trial.samples,
        significant(trial.noise),
    )
}

fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share).replace('-', "\u{2212}")
}

/// Filters in the order of their errors.
fn order(trial: &Trial, names: &[&str]) -> String {
    let mut errors: Vec<_> = names.iter().map(|name| (trial.rmse(name), *name)).collect();
    errors.sort_by(|a, b| a.0.total_cmp(&b.0));
    let told = errors.iter().map(|(error, name)| format!("{name} {}", significant(*error)));
    told.collect::<Vec<_>>().join(" < ")
}

/// Which filter is nearest, and what it costs.
pub(super) fn tube(trial: &Trial) -> String {
    let of = |name: &str| {
        let overhead = trial.entry(name).and_then(|entry| trial.overhead(entry));
        overhead.map_or(String::new(), |share| {
            format!("{:+.0} %", 100.0 * share).replace('-', "\u{2212}")
        })
    };
    format!(
        "A tube of {RADIUS} pixels radius, bent to a ring, under two lights; {} RMSE in means: \
            {}; and {}. \
         Derivatives, of which the paper finds those on the disk nearer: with s_K 0.5 {}, with \
         s_K 1 {}, with the box {}. Time over \
         that of none: the box {}, mips in software {}.",
        facts(trial),
        scales(trial, [name::HALF, name::ONE, name::NONE]),
        order(trial, &[name::BOX, name::FOUR, name::SIXTEEN]),
        nearer(trial, [name::HALF, name::HALF_SLOPE], ["disk", "slope"]),
        nearer(trial, [name::ONE, name::ONE_SLOPE], ["disk", "slope"]),
        nearer(trial, [name::BOX, name::BOX_SLOPE], ["disk", "slope"]),
        of(name::BOX),
        of(name::HALF),
    )
}

/// Errors of s_K 0.5, of 1 and of none: their order, whether it is the paper's, and how surely the
/// first two differ.
fn scales(trial: &Trial, names: [&str; 3]) -> String {
    let [half, one, none] = names.map(|name| trial.rmse(name));
    let published = if half < one && one < none { "as published" } else { "not as published" };
    let nearer = nearer(trial, [names[0], names[1]], ["s_K 0.5 before 1", "s_K 1 before 0.5"]);
    format!("{}, {published}, {nearer}", order(trial, &names))
}

/// Which of two methods has the smaller error, by how much, and whether that may be chance; as they
/// are called here.
fn nearer(trial: &Trial, methods: [&str; 2], called: [&str; 2]) -> String {
    let [one, other] = methods;
    let lead = trial.lead(one, other);
    let ratio = trial.rmse(other) / trial.rmse(one);
    let (better, by) = if lead > 0.0 { (called[0], ratio) } else { (called[1], 1.0 / ratio) };
    let sure = if lead.abs() > SURE { "" } else { ", which may be chance" };
    format!("{better} by {:.1} %{sure}", 100.0 * (by - 1.0))
}

/// Where the published order holds.
pub(super) fn sweep(swept: &[Swept]) -> String {
    let told = |ordered: Option<bool>| {
        let cases = swept.iter().filter(|swept| swept.is_ordered() == ordered);
        let cases = cases.map(|s| format!("\u{3b1} {} with {}", s.alpha, amount(s.facets)));
        match cases.collect::<Vec<_>>() {
            cases if cases.is_empty() => "nowhere".into(),
            cases => cases.join(", "),
        }
    };
    let worst = swept.iter().filter(|swept| {
        let [none, others @ ..] = swept.errors;
        others.iter().all(|error| *error < none)
    });
    let best = swept.iter().filter(|swept| {
        let [none, half, one, boxed] = swept.errors;
        boxed < half.min(one).min(none)
    });
    format!(
        "s_K 0.5 is nearer than 1, as published: {}; 1 is nearer: {}; unsure: {}. The unfiltered \
            picture has the largest error in {} cases. The \
         box has the smallest error of the four in {} of {} cases.",
        told(Some(true)),
        told(Some(false)),
        told(None),
        worst.count(),
        best.count(),
        swept.len(),
    )
}

/// What the ball has with all that is known of its map.
const FILTERED: [&str; 6] = [
    name::WHOLE,
    name::WHOLE_NONE,
    name::WHOLE_HALF,
    name::WHOLE_ONE,
    name::WHOLE_HALF_SLOPE,
    name::WHOLE_ONE_SLOPE,
];

/// The same without its correlation.
const UNCORRELATED: [&str; 6] = [
    name::APART,
    name::APART_NONE,
    name::APART_HALF,
    name::APART_ONE,
    name::APART_HALF_SLOPE,
    name::APART_ONE_SLOPE,
];

/// Filters on a curved surface with a map.
pub(super) fn beads(trial: &Trial) -> String {
    format!(
        "Balls of {RADIUS} pixels radius with wood fiber, {BEAD_TEXELS} texel a pixel in the \
            middle, {ASKEW} degrees askew; {} RMSE \
         in means, with \u{3c1}: {}; without: {}. The box comes to {} and {}. Derivatives, with \
         \u{3c1} and s_K 0.5: {}, s_K 1: {}.",
        facts(trial),
        scales(trial, [name::WHOLE_HALF, name::WHOLE_ONE, name::WHOLE_NONE]),
        scales(trial, [name::APART_HALF, name::APART_ONE, name::APART_NONE]),
        significant(trial.rmse(name::WHOLE)),
        significant(trial.rmse(name::APART)),
        nearer(trial, [name::WHOLE_HALF, name::WHOLE_HALF_SLOPE], ["disk", "slope"]),
        nearer(trial, [name::WHOLE_ONE, name::WHOLE_ONE_SLOPE], ["disk", "slope"]),
    )
}

/// What correlation is worth.
pub(super) fn ball(trial: &Trial) -> String {
    let [apart, whole] = [name::APART, name::WHOLE].map(|name| trial.rmse(name));
    let worth = if whole < apart { "less" } else { "more" };
    format!(
        "A ball with wood fiber, {TEXELS} texels a pixel in the middle, laid on {ASKEW} degrees \
            askew, as along its own axes \
         fibers have no correlation; {} RMSE in means: {}. With \u{3c1} the error is {} {worth} \
         than without. Filters of half \
         vectors: {}; and {}; with \u{3c1}, between s_K 0.5 and 1 the nearer is {}, between the \
         box and none {}. 4 samples come to {}, \
         16 to {}.",
        facts(trial),
        order(trial, &[name::MEAN, name::APART, name::WHOLE]),
        percent((1.0 - whole / apart).abs()),
        order(trial, &FILTERED),
        order(trial, &UNCORRELATED),
        nearer(trial, [name::WHOLE_HALF, name::WHOLE_ONE], ["0.5", "1"]),
        nearer(trial, [name::WHOLE, name::WHOLE_NONE], ["the box", "none"]),
        significant(trial.rmse(name::FOUR)),
        significant(trial.rmse(name::SIXTEEN)),
    )
}

/// Whether lobes are what was asked for.
pub(super) fn lobes(lobes: &Lobes) -> String {
    let off = |of: fn(&crate::facets::Shown) -> f64, many: bool| {
        let shown = lobes.shown.iter().filter(|shown| !many || shown.facets > 1e9);
        shown.map(of).fold(0.0, f64::max)
    };
    format!(
        "Integrals are within {} of 1, of few facets as of many. Of many the correlation is that \
            which was asked for within {}.",
        significant(off(|shown| (shown.integral - 1.0).abs(), false)),
        significant(off(|shown| (shown.found - shown.correlation).abs(), true)),
    )
}

/// What the filter mends from near to far.
pub(super) fn zoom(zoom: &Zoom) -> String {
    let gain = |frame: &Frame| frame.errors[0] / frame.errors[1];
    let [Some(first), Some(last)] = [zoom.frames.first(), zoom.frames.last()] else {
        return String::new();
    };
    let most = zoom.frames.iter().map(gain).fold(0.0, f64::max);
    format!(
        "From {} facets in a pixel to {}. Near, where half vectors hardly change, the error \
            without a filter is {} times the \
         box\u{2019}s; far away {} times, and {} times at most.",
        plain(first.facets),
        plain(last.facets),
        significant(gain(first)),
        significant(gain(last)),
        significant(most),
    )
}

/// What filters take.
pub(super) fn memory(memory: Memory) -> String {
    let kib = |bytes: usize| significant(bytes as f64 / 1024.0);
    format!(
        "The published filter takes its dictionary from {} to {} KiB. The library\u{2019}s box \
            needs nothing beyond the cumulative, which \
         sampling has anyway: {} KiB in f32.",
        kib(memory.published),
        kib(memory.mips),
        kib(memory.ours),
    )
}
