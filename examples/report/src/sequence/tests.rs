//! Sequences at rest and in motion.

use super::{Plan, Sequence, Track};
use crate::camera::Size;
use crate::light::LightKind;
use crate::method;
use crate::reference::Sampling;
use crate::scene::{Movement, Subject, restless_map};

fn plan(step: f64, frames: usize) -> Plan {
    let (sampling, light) = (Sampling::of_frame(128), LightKind::Distant);
    Plan { width: 64, frames, step, sampling, light, alpha: 0.01 }
}

/// The ball that turns and the water that passes by.
fn both(plan: &Plan) -> [Sequence; 2] {
    let size = Size::of_width(plan.width);
    let subjects = [
        (Subject::mapped_ball(size, &restless_map().unwrap()), Movement::Turn),
        (Subject::water(size), Movement::Pan),
    ];
    let methods = Plan::methods(method::all());
    subjects.map(|(subject, movement)| {
        Sequence::run(&subject, movement, &methods, plan, &|_| ()).unwrap()
    })
}

#[test]
fn what_stands_still_has_no_flicker_and_a_constant_peak() {
    for sequence in both(&plan(0.0, 3)) {
        for track in &sequence.tracks {
            assert_eq!(track.flicker, 0.0, "{}", track.method);
            assert!(track.deviation > 0.0);
            assert_eq!(track.peaks, vec![track.peaks[0]; 3]);
        }
        for reference in &sequence.references {
            assert_eq!(reference.peaks, vec![reference.peaks[0]; 3]);
        }
    }
}

#[test]
fn the_exact_parallelogram_flickers_less_than_no_filter_and_its_peak_is_nearer_to_the_reference() {
    for sequence in both(&plan(0.23, 16)) {
        let find = |name: &str| sequence.tracks.iter().find(|t| t.method == name).unwrap();
        let [none, exact] = ["none (1 sample)", "exact parallelogram"].map(find);
        assert!(exact.flicker < none.flicker, "{}", sequence.name);
        let stray = |track: &Track| {
            let right = &sequence.reference_of(track).unwrap().peaks;
            let pairs = track.peaks.iter().zip(right);
            pairs.map(|(peak, right)| (peak - right).powi(2)).sum::<f64>()
        };
        assert!(stray(exact) < stray(none), "{}", sequence.name);
    }
}
