use super::Plan;
use super::lobes::Lobes;
use super::memory::Memory;
use super::method::name;
use super::scenes::{ball, beads, tube};
use super::trial::{SURE, Trial};
use super::zoom::Zoom;

/// Without much timing.
fn plan() -> Plan {
    Plan { timed: 4, rounds: 1, ..Plan::quick() }
}

/// Errors from the smallest on, each below the next by more than the reference's own.
fn assert_rising(trial: &Trial, names: &[&str]) {
    let errors: Vec<_> = names.iter().map(|name| trial.rmse(name)).collect();
    for (pair, names) in errors.windows(2).zip(names.windows(2)) {
        // Independent of both: it adds to either's square.
        let above = pair[1].powi(2) - trial.noise.powi(2);
        assert!(pair[0].powi(2) < above, "{names:?}: {errors:?}, noise {}", trial.noise);
    }
}

#[test]
fn on_a_tube_filters_have_the_published_order_and_the_box_is_the_best() {
    let trial = tube(&plan()).unwrap();
    assert!(trial.pixels > 1000, "{}", trial.pixels);
    assert_rising(&trial, &[name::BOX, name::HALF, name::ONE, name::NONE]);
    assert!(trial.rmse(name::HALF_SLOPE) < trial.rmse(name::ONE_SLOPE));
    // Of large boxes, slopes are the larger ones.
    assert!(trial.rmse(name::ONE) < trial.rmse(name::ONE_SLOPE));
    // More samples come nearer to the reference.
    assert_rising(&trial, &[name::SIXTEEN, name::FOUR, name::NONE]);
    for entry in &trial.entries {
        assert!((entry.errors.energy - 1.0).abs() < 0.1, "{}: {:?}", entry.name, entry.errors);
    }
}

#[test]
fn on_beads_with_a_normal_map_they_have_it_too_with_its_correlation_and_without() {
    let trial = beads(&plan()).unwrap();
    assert!(trial.pixels > 4000, "{}", trial.pixels);
    for names in [
        [name::WHOLE_HALF, name::WHOLE_ONE, name::WHOLE_NONE],
        [name::WHOLE_HALF_SLOPE, name::WHOLE_ONE_SLOPE, name::WHOLE_NONE],
        [name::APART_HALF, name::APART_ONE, name::APART_NONE],
        [name::APART_HALF_SLOPE, name::APART_ONE_SLOPE, name::APART_NONE],
    ] {
        assert_rising(&trial, &names);
    }
    assert_rising(&trial, &[name::WHOLE, name::WHOLE_ONE]);
    assert_rising(&trial, &[name::WHOLE, name::APART, name::MEAN]);
}

#[test]
fn a_normal_map_needs_its_covariance_and_that_its_correlation() {
    let trial = ball(&plan()).unwrap();
    assert_rising(&trial, &[name::WHOLE, name::APART, name::MEAN]);
    assert!(trial.rmse(name::WHOLE) <= trial.rmse(name::WHOLE_NONE));
}

#[test]
fn leads_are_sure_where_errors_are_far_apart_and_change_sign() {
    let trial = tube(&Plan { width: 64, ..plan() }).unwrap();
    assert!(trial.lead(name::BOX, name::NONE) > SURE);
    let [there, back] = [[name::HALF, name::ONE], [name::ONE, name::HALF]];
    assert_eq!(trial.lead(there[0], there[1]), -trial.lead(back[0], back[1]));
}

#[test]
fn lobes_have_the_integral_and_the_correlation_that_was_asked_for() {
    let lobes = Lobes::seen(48).unwrap();
    for shown in &lobes.shown {
        assert!((shown.integral - 1.0).abs() < 0.02, "{}", shown.integral);
        // Few lobes have a correlation of their own.
        let tolerance = if shown.facets > 1e9 { 0.01 } else { 0.3 };
        assert!((shown.found - shown.correlation).abs() < tolerance, "{}", shown.found);
    }
}

#[test]
fn far_away_facets_are_smooth_and_the_filter_is_no_worse_than_none() {
    let zoom = Zoom::seen(32, 4).unwrap();
    let (first, last) = (&zoom.frames[0], &zoom.frames[zoom.frames.len() - 1]);
    // How much neighbors differ, over their sum.
    let grain = |picture: &[f64]| {
        let pairs = picture.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        pairs.sum::<f64>() / picture.iter().sum::<f64>()
    };
    assert!(grain(&first.pictures[1]) > 3.0 * grain(&last.pictures[1]));
    // Over all steps: in a picture as small, single glints decide over a step.
    let whole = |k: usize| zoom.frames.iter().map(|frame| frame.errors[k].powi(2)).sum::<f64>();
    assert!(whole(1) <= whole(0) && last.errors[1] < last.errors[0]);
}

#[test]
fn published_dictionaries_take_384_kib_and_mips_nearly_as_much_again() {
    let Memory { ours, published, mips } = Memory::counted().unwrap();
    assert_eq!((published, mips), (384 << 10, 762 << 10));
    assert_eq!(ours, 192 * 16 * 65 * 8);
}
