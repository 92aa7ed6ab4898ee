//! The table of ratios at the end of a run.

use super::cases::Case;
use super::samples::{COUNT, Regime};
use super::{glints, maps};
use std::time::Instant;

/// A promise: `subject` takes no longer than `rival` in the same group.
const PROMISES: [(&str, &str, &str); 6] = [
    ("shading", "isotropic", "isotropic_by_hand"),
    ("shading", "axis_aligned", "axis_aligned_by_hand"),
    ("mixed", "axis_aligned", "appendix_a_by_hand"),
    ("small", "axis_aligned", "appendix_a_by_hand"),
    ("thin", "axis_aligned", "appendix_a_by_hand"),
    ("large", "axis_aligned", "appendix_a_by_hand"),
];

/// What more roughness, or a check per sample, costs.
const COSTS: [&str; 7] = [
    "isotropic_per_sample",
    "anisotropic",
    "non_centered",
    "beckmann_isotropic",
    "variance_addition",
    "peak_fitted",
    "projected_space",
];

/// Steps from a normal map's texels to radiance, and what each is held against.
const MAPS: [(&str, &str); 7] = [
    ("texels_to_slopes", "copy"),
    ("mip_chain", "copy"),
    ("bilinear", "copy"),
    ("trilinear", "bilinear"),
    ("along_eight_probes", "trilinear"),
    ("raw_moments_shaded", "bilinear"),
    ("facets_five_by_five", "raw_moments_shaded"),
];

/// Glints by the pixel's aspect, by the number of details, and by mode; many lobes by aspect,
/// number and filter.
const GLINTS: [(&str, &str); 15] = [
    ("steep", "smooth_lobe"),
    ("grazing", "steep"),
    ("longest", "steep"),
    ("few_details", "steep"),
    ("many_details", "steep"),
    ("varied", "steep"),
    ("published", "steep"),
    ("light_blur", "smooth_lobe"),
    ("many_lobes", "smooth_lobe"),
    ("many_lobes_longest", "many_lobes"),
    ("many_lobes_smooth", "smooth_lobe"),
    ("many_lobes_box", "many_lobes"),
    ("many_lobes_long_box", "many_lobes"),
    ("many_lobes_mips", "many_lobes"),
    ("many_lobes_sample", "many_lobes"),
];

/// Rounds of a comparison, and passes over all samples in each turn of a round.
const ROUNDS: usize = 101;
const PASSES: u32 = 4;

/// Nanoseconds per sample of a few passes.
fn turn(pass: &mut dyn FnMut()) -> f64 {
    let start = Instant::now();
    for _ in 0..PASSES {
        pass();
    }
    start.elapsed().as_nanos() as f64 / f64::from(PASSES) / COUNT as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Median time of the subject and median ratio to the rival, turn by turn.
fn compare(cases: &mut [Case], group: &str, subject: &str, rival: &str) -> (f64, f64) {
    let mut time = |name: &str| {
        let case = cases.iter_mut().find(|case| case.group == group && case.name == name);
        turn(&mut case.unwrap_or_else(|| panic!("no case {group}/{name}")).pass)
    };
    let rounds: Vec<(f64, f64)> = (0..ROUNDS)
        .map(|_| {
            let (own, other) = (time(subject), time(rival));
            (own, own / other)
        })
        .collect();
    let (times, ratios): (Vec<f64>, Vec<f64>) = rounds.into_iter().unzip();
    (median(times), median(ratios))
}

fn print_ratio(cases: &mut [Case], group: &str, subject: &str, rival: &str, mark: &str) {
    let (time, ratio) = compare(cases, group, subject, rival);
    println!("{group:8} {subject:22} {time:7.2} ns  {ratio:5.2} x {rival} {mark}");
}

/// Measures and prints every ratio.
pub(crate) fn print(cases: &mut [Case]) {
    println!("\nper sample, and as the median ratio of interleaved rounds (* promised: at most 1)");
    for (group, subject, rival) in PROMISES {
        print_ratio(cases, group, subject, rival, "*");
    }
    for subject in COSTS {
        print_ratio(cases, "shading", subject, "isotropic", "");
    }
    for (subject, rival) in MAPS {
        print_ratio(cases, maps::GROUP, subject, rival, "");
    }
    for (subject, rival) in GLINTS {
        print_ratio(cases, glints::GROUP, subject, rival, "");
    }
    for regime in Regime::ALL {
        print_ratio(cases, regime.name(), "appendix_a_by_hand", "appendix_a", "");
        for subject in ["isotropic", "axis_aligned", "anisotropic"] {
            print_ratio(cases, regime.name(), subject, "appendix_a", "");
        }
    }
}
