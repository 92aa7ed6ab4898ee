//! Filters in motion on the page: peaks over frames, a table by flicker, what it says; the same as
//! text.

use super::axis::Scale;
use super::chart::{Chart, Line as Curved, Range, around};
use super::escape;
use super::kernels::drawn;
use super::table::{Line, Table, significant};
use crate::scene::Movement;
use crate::sequence::{Sequence, Track};

/// The methods that figures show, with their CSS classes: all would hide each other.
const DRAWN: [(&str, &str); 4] = [
    ("none (1 sample)", "nothing"),
    ("Tokuyoshi 2017", "published"),
    ("rectangle", "added"),
    ("exact parallelogram", "exact"),
];

/// All sequences, below what they have in common.
pub(super) fn html(sequences: &[Sequence]) -> String {
    if sequences.is_empty() {
        return String::new();
    }
    let sections = sequences.iter().map(|sequence| {
        format!(
            "<h3>{}</h3>\n<p class=\"caption\">{}</p>\n<p>{}</p>\n<div \
                class=\"plots\">\n{}{}</div>\n{}\
             <p class=\"note\">{}</p>\n",
            escape(&title(sequence)),
            escape(&facts(sequence)),
            escape(&finding(sequence)),
            drawn("Largest radiance of each frame", &peaks(sequence)),
            drawn("The same over each method\u{2019}s own reference", &ratios(sequence)),
            table(sequence).html(),
            noise(sequence),
        )
    });
    format!("{}{}", include_str!("sequence.html"), sections.collect::<Vec<_>>().concat())
}

/// One sequence for the terminal.
pub(crate) fn text(sequence: &Sequence) -> String {
    format!(
        "\n{}\n{}\n{}{}\n{}\n",
        title(sequence),
        facts(sequence),
        table(sequence).text(),
        noise(sequence),
        finding(sequence),
    )
}

fn title(sequence: &Sequence) -> String {
    let movement = match sequence.movement {
        Movement::Turn => "turning",
        Movement::Pan => "passing by",
    };
    format!("{}, {movement}", sequence.name)
}

/// What is seen, and how it moves.
fn facts(sequence: &Sequence) -> String {
    let Sequence { frames, step, width, height, alpha, light, .. } = sequence;
    let movement = match sequence.movement {
        Movement::Turn => "the object turns about the vertical axis",
        Movement::Pan => "the camera goes to its right",
    };
    format!(
        "{} {frames} frames in which {movement}, {step} pixels a frame at the picture\u{2019}s \
            center; {width} x \
         {height} pixels, {:.0} % of them judged; GGX, {light}, alpha {alpha}.",
        sequence.caption,
        100.0 * sequence.judged_part,
    )
}

/// The tracks that figures show, with their CSS classes.
fn shown(sequence: &Sequence) -> impl Iterator<Item = (&Track, &'static str)> {
    DRAWN.iter().filter_map(|&(name, class)| Some((named(sequence, name)?, class)))
}

fn named<'a>(sequence: &'a Sequence, name: &str) -> Option<&'a Track> {
    sequence.tracks.iter().find(|track| track.method == name)
}

/// Peaks of methods and of the references that these are held against.
fn peaks(sequence: &Sequence) -> Chart {
    let methods = shown(sequence)
        .map(|(track, class)| curve(track.method.clone(), class.into(), track.peaks.iter()));
    let held = |window: &str| shown(sequence).any(|(track, _)| track.window == window);
    let references = sequence.references.iter().filter(|reference| held(reference.window));
    let references = references.enumerate().map(|(index, reference)| {
        let class = ["truth", "truth second", "truth third"][index.min(2)];
        let name = match reference.window.strip_prefix("Gaussian ") {
            Some(variance) => format!("reference, {variance}"),
            None => "reference".into(),
        };
        curve(name, class.into(), reference.peaks.iter())
    });
    chart(sequence, "largest radiance", None, methods.chain(references).collect())
}

/// The same peaks over those of each method's own reference.
fn ratios(sequence: &Sequence) -> Chart {
    let lines = shown(sequence).filter_map(|(track, class)| {
        let reference = sequence.reference_of(track)?;
        let pairs = track.peaks.iter().zip(&reference.peaks);
        let ratios: Vec<_> = pairs.map(|(peak, right)| peak / right).collect();
        Some(curve(track.method.clone(), class.into(), ratios.iter()))
    });
    chart(sequence, "largest radiance / reference\u{2019}s", Some(1.0), lines.collect())
}

fn curve<'a>(name: String, class: String, values: impl Iterator<Item = &'a f64>) -> Curved {
    let points = values.enumerate().map(|(frame, &value)| [(frame + 1) as f64, value]);
    Curved { name, class, points: points.collect() }
}

/// Curves over the frames, the vertical axis as long as they need.
fn chart(
    sequence: &Sequence,
    title: &'static str,
    right: Option<f64>,
    lines: Vec<Curved>,
) -> Chart {
    let [low, high] = around(&lines, right, ROOM);
    let scale = if high > LONG * low { Scale::Logarithmic } else { Scale::Linear };
    Chart {
        title: format!("{title} over frames, {}", sequence.name),
        x: Range::new("frame", Scale::Linear, [1.0, (sequence.frames as f64).max(2.0)]),
        y: Range::new(title, scale, [low, high]),
        right,
        lines,
    }
}

/// The ratio of an axis' ends above which it is logarithmic: on shorter ones 1, 2 and 5 are too few
/// ticks.
const LONG: f64 = 8.0;

/// Factor between the outermost values and the frame.
const ROOM: f64 = 1.15;

/// How high the half vector stands where a method is worst.
fn degrees(track: &Track) -> String {
    format!("{:.1}\u{b0}", track.worst.elevation)
}

/// Every method, the steadiest first.
fn table(sequence: &Sequence) -> Table {
    let best = sequence.best().map(|track| &track.method);
    let mut tracks: Vec<_> = sequence.tracks.iter().collect();
    tracks.sort_by(|a, b| a.flicker.total_cmp(&b.flicker));
    let rows = tracks.into_iter().map(|track| Line {
        cells: vec![
            track.method.clone(),
            track.samples.to_string(),
            track.window.into(),
            significant(track.flicker),
            significant(track.deviation),
            significant(track.noise),
            significant(track.peak_ratio),
            significant(track.jump_ratio),
            significant(track.worst.error),
            degrees(track),
        ],
        class: match track.filters {
            true if Some(&track.method) == best => "best",
            true => "",
            false => "plain",
        },
    });
    let headers = &[
        "Method",
        "Samples",
        "Pixel filter",
        "Flicker",
        "Deviation",
        "Noise",
        "Peak ratio",
        "Jump ratio",
        "Worst",
        "Half vector",
    ];
    Table { headers, rows: rows.collect() }
}

fn noise(sequence: &Sequence) -> String {
    let part = |track: &Track| 100.0 * track.noise / track.flicker;
    let largest = sequence.tracks.iter().map(part).fold(0.0, f64::max);
    format!(
        "Deviation: standard deviation of x \u{2212} r over all frames and pixels. Peak ratio: \
            mean over frames of the \
         largest radiance over the reference\u{2019}s. Jump ratio: the largest change of that \
         peak from one frame to the \
         next over the reference\u{2019}s largest. Worst: largest |x \u{2212} r|, and how high \
         the half vector stands over \
         the surface there. Noise: the reference\u{2019}s own standard error, {} % of the best \
         filter\u{2019}s flicker and at most {} % of any method\u{2019}s.",
        significant(sequence.best().map_or(f64::NAN, part)),
        significant(largest),
    )
}

/// What flickers, what does least, and how many samples do as well.
fn finding(sequence: &Sequence) -> String {
    let (Some(plain), Some(best)) = (sequence.plain(), sequence.best()) else {
        return String::new();
    };
    let many = sequence.tracks.iter().filter(|track| !track.filters && track.samples > 1);
    let many = many.map(|t| format!(", {} with {} samples", significant(t.flicker), t.samples));
    let unfiltered = format!(
        "Without a filter the peak is {} times the reference\u{2019}s in the mean and jumps {} \
            times as far.",
        significant(plain.peak_ratio),
        significant(plain.jump_ratio),
    );
    let filtered = format!(
        "Of the filters {} flickers least: {}, against {} without one{}; its peak is {} times the \
         reference\u{2019}s and jumps {} times as far.",
        best.method,
        significant(best.flicker),
        significant(plain.flicker),
        many.collect::<Vec<_>>().concat(),
        significant(best.peak_ratio),
        significant(best.jump_ratio),
    );
    format!("{unfiltered} {filtered}{}", restless(sequence, plain))
}

/// Degrees below which a half vector is near the horizon: its slope is above 3.
const LOW: f64 = 18.0;

/// The filters that flicker more than one plain sample, and where; empty if there is none.
fn restless(sequence: &Sequence, plain: &Track) -> String {
    let restless: Vec<_> = sequence
        .tracks
        .iter()
        .filter(|track| track.filters && track.flicker > plain.flicker)
        .collect();
    if restless.is_empty() {
        return String::new();
    }
    let names =
        restless.iter().map(|track| format!("{} (worst at {})", track.method, degrees(track)));
    let cause = if restless.iter().all(|track| track.worst.elevation < LOW) {
        " So near the horizon slopes grow without bound, and an error of their density weighs as \
            much as the \
         slope\u{2019}s fourth power."
    } else {
        ""
    };
    format!(
        " More than without a filter flickers, with the half vector\u{2019}s height above the \
            surface: {}.{cause}",
        names.collect::<Vec<_>>().join("; "),
    )
}
