//! The table of ratios at the end of a run.

use super::cases::Case;
use super::limit::Operations;
use super::samples::{COUNT, Regime};
use super::{glints, maps};
use serde::Serialize;
use std::time::Instant;

/// What most evaluations are held against.
pub(crate) const BASE: &str = "ggx_isotropic";

/// Evaluations that are held against others, in the order of preference: the first that there is.
const EVALUATIONS: [(&str, &[&str]); 8] = [
    (BASE, &["cpp_ggx_isotropic", "by_hand_ggx_isotropic"]),
    ("ggx_axis_aligned", &["cpp_ggx_axis_aligned", "by_hand_ggx_axis_aligned"]),
    ("ggx_axis_aligned_aos", &["cpp_ggx_axis_aligned_aos", "ggx_axis_aligned"]),
    ("cpp_ggx_axis_aligned_aos", &["cpp_ggx_axis_aligned"]),
    ("ggx_isotropic_baked", &["by_hand_ggx_isotropic"]),
    ("ggx_axis_aligned_baked", &["by_hand_ggx_axis_aligned"]),
    ("by_hand_ggx_axis_aligned", &["by_hand_ggx_isotropic"]),
    ("beckmann_axis_aligned", &["ggx_axis_aligned"]),
];

/// Rows of which it is promised that they take no longer than their rival.
const PROMISED: [&str; 6] = [
    "ggx_isotropic_baked",
    "ggx_axis_aligned_baked",
    "mixed/axis_aligned",
    "small/axis_aligned",
    "thin/axis_aligned",
    "large/axis_aligned",
];

/// Steps from a normal map's texels to radiance, and what each is held against.
const MAPS: [(&str, &str); 8] = [
    ("copy", BASE),
    ("texels_to_slopes", "maps/copy"),
    ("mip_chain", "maps/copy"),
    ("bilinear", "maps/copy"),
    ("trilinear", "maps/bilinear"),
    ("along_eight_probes", "maps/trilinear"),
    ("raw_moments_shaded", "maps/bilinear"),
    ("facets_five_by_five", "maps/raw_moments_shaded"),
];

/// Glints by the pixel's aspect, by the number of details, and by mode; many lobes by aspect,
/// number and filter.
const GLINTS: [(&str, &str); 16] = [
    ("smooth_lobe", BASE),
    ("steep", "glints/smooth_lobe"),
    ("grazing", "glints/steep"),
    ("longest", "glints/steep"),
    ("few_details", "glints/steep"),
    ("many_details", "glints/steep"),
    ("varied", "glints/steep"),
    ("published", "glints/steep"),
    ("light_blur", "glints/smooth_lobe"),
    ("many_lobes", "glints/smooth_lobe"),
    ("many_lobes_longest", "glints/many_lobes"),
    ("many_lobes_smooth", "glints/smooth_lobe"),
    ("many_lobes_box", "glints/many_lobes"),
    ("many_lobes_long_box", "glints/many_lobes"),
    ("many_lobes_mips", "glints/many_lobes"),
    ("many_lobes_sample", "glints/many_lobes"),
];

/// Means over footprints, in every regime; rivals are of the same one.
const MEANS: [(&str, &str); 5] = [
    ("appendix_a_by_hand", "appendix_a"),
    ("isotropic", "appendix_a"),
    ("axis_aligned", "appendix_a_by_hand"),
    ("anisotropic", "appendix_a"),
    ("appendix_a", BASE),
];

/// The row that a case is held against.
fn rival(cases: &[Case], case: &Case) -> String {
    let listed = |list: &[(&str, &str)]| {
        let found = list.iter().find(|(name, _)| *name == case.name);
        found.unwrap_or_else(|| panic!("no rival of {}", case.row_name())).1.to_owned()
    };
    if Regime::ALL.iter().any(|regime| regime.name() == case.group) {
        let name = listed(&MEANS);
        return if name == BASE { name } else { format!("{}/{name}", case.group) };
    }
    match case.group {
        maps::GROUP => listed(&MAPS),
        glints::GROUP => listed(&GLINTS),
        _ => {
            let found = EVALUATIONS.iter().find(|(name, _)| *name == case.name);
            let there = |name: &&&str| cases.iter().any(|case| case.name == **name);
            let first = found.and_then(|(_, rivals)| rivals.iter().find(there));
            (*first.unwrap_or(&BASE)).to_owned()
        }
    }
}

/// Rounds of a comparison, and passes over all samples in each turn of a round.
const ROUNDS: usize = 101;
const PASSES: u32 = 4;

/// Rows that are slower than this, in seconds for a pass of both sides, have one pass in a turn:
/// other programs on the core interrupt long turns more often than short ones.
const SLOW: f64 = 2e-4;

/// Seconds for a row, which has fewer rounds where these do not suffice, but as many as a median
/// needs.
const SECONDS: f64 = 0.25;
const FEWEST: usize = 7;

/// Nanoseconds per sample of a few passes.
fn turn(pass: &mut dyn FnMut(), passes: u32) -> f64 {
    let start = Instant::now();
    for _ in 0..passes {
        pass();
    }
    start.elapsed().as_nanos() as f64 / f64::from(passes) / COUNT as f64
}

fn median(values: impl IntoIterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.into_iter().collect();
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// A row of the table: medians over rounds in which all sides take turns.
#[derive(Serialize)]
pub(crate) struct Row {
    pub(crate) name: String,
    /// Nanoseconds per sample.
    pub(crate) ns: f64,
    /// The row that it is held against.
    pub(crate) over: String,
    /// Time over that row's, turn by turn.
    pub(crate) ratio: f64,
    #[serde(flatten)]
    pub(crate) least: Option<Least>,
}

/// What the machine needs at least for a row's divisions, roots, loads and store.
#[derive(Serialize)]
pub(crate) struct Least {
    pub(crate) limit_ns: f64,
    /// Of the row's time, turn by turn.
    pub(crate) fraction: f64,
    #[serde(skip)]
    pub(crate) operations: Operations,
}

/// Measures one case against another.
pub(crate) fn compare(cases: &mut [Case], name: &str, over: &str) -> Row {
    let place = |name: &str| {
        let found = cases.iter().position(|case| case.row_name() == name);
        found.unwrap_or_else(|| panic!("no row {name}"))
    };
    let (own, other) = (place(name), place(over));
    // The first pass brings code and data into the caches.
    let first = turn(&mut cases[own].pass, 1) + turn(&mut cases[other].pass, 1);
    let passes = if first * 1e-9 * COUNT as f64 > SLOW { 1 } else { PASSES };
    let start = Instant::now();
    let mut rounds: Vec<[f64; 3]> = Vec::new();
    while rounds.len() < FEWEST || rounds.len() < ROUNDS && start.elapsed().as_secs_f64() < SECONDS
    {
        let time = turn(&mut cases[own].pass, passes);
        let rival = turn(&mut cases[other].pass, passes);
        let limit = cases[own].limit.as_mut().map_or(0.0, |limit| turn(&mut limit.pass, passes));
        rounds.push([time, rival, limit]);
    }
    let least = cases[own].limit.as_ref().map(|limit| Least {
        limit_ns: median(rounds.iter().map(|[_, _, limit]| *limit)),
        fraction: median(rounds.iter().map(|[time, _, limit]| limit / time)),
        operations: limit.operations,
    });
    Row {
        name: name.to_owned(),
        ns: median(rounds.iter().map(|[time, ..]| *time)),
        over: over.to_owned(),
        ratio: median(rounds.iter().map(|[time, rival, _]| time / rival)),
        least,
    }
}

/// A row as the table shows it.
fn line(row: &Row) -> String {
    let Row { name, ns, over, ratio, least } = row;
    let mark = if PROMISED.contains(&name.as_str()) { " *" } else { "" };
    let limit = least.as_ref().map_or_else(String::new, |least| {
        let Operations { divisions, roots, loads } = least.operations;
        let counts = format!("{divisions:3} / {roots:2} sqrt {loads:2} loads");
        format!("{counts} {:6.2} ns  {:.2}", least.limit_ns, least.fraction)
    });
    let rival = format!("{over}{mark}");
    format!("{name:36} {ns:8.2} ns {ratio:7.2} x {rival:28} {limit}").trim_end().to_owned()
}

/// Measures and prints every row.
pub(crate) fn print(cases: &mut [Case]) -> Vec<Row> {
    println!(
        "\nper sample, and as the median ratio of interleaved rounds (* promised: at most 1); what \
         is counted of an evaluation,\nthe time of a loop that does nothing else, and its \
         fraction of the row's time"
    );
    let pairs: Vec<(String, String)> =
        cases.iter().map(|case| (case.row_name(), rival(cases, case))).collect();
    let measured = pairs.iter().map(|(name, over)| {
        let row = compare(cases, name, over);
        println!("{}", line(&row));
        row
    });
    measured.collect()
}
