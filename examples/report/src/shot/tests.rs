//! Shots are what the report shows.

use lobe::slope::direction::slope_of;
use lobe::{Footprint, Path, Vertex};

use super::{METHODS, Shot, non_overlap};
use crate::camera::Size;
use crate::light::LightKind;
use crate::method;
use crate::reference::Sampling;
use crate::scene::{Subject, carried_maps};
use crate::study::{Effort, QUICK_SAMPLES, Study};

const WIDTH: usize = 48;
const ALPHA: f64 = 0.01;

fn shots() -> [Shot; 2] {
    [Shot::balls(WIDTH, ALPHA).unwrap(), Shot::leather(WIDTH, ALPHA).unwrap()]
}

#[test]
fn errors_pictures_and_masks_are_those_of_the_report_s_panel() {
    let size = Size::of_width(WIDTH);
    let subjects = [Subject::balls(size), Subject::plane(size, &carried_maps(false).unwrap()[0])];
    let effort = Effort {
        width: WIDTH,
        sampling: Sampling::of_still(QUICK_SAMPLES),
        rounds: 1,
        lights: vec![LightKind::Distant],
        alphas: vec![ALPHA],
    };
    for (shot, subject) in shots().iter().zip(subjects) {
        let study = Study::run(subject, &method::all(), &effort, &|_| ()).unwrap();
        let panel = &study.panels[0];
        assert_eq!((&shot.name, &shot.judged), (&study.name, &study.judged));
        assert_eq!(shot.scale, panel.scale);
        let shaded = [&shot.plain, &shot.widened, &shot.exact];
        for (shaded, name) in shaded.into_iter().zip(METHODS) {
            assert_eq!(shaded.name, name);
            let row = panel.rows.iter().find(|row| row.name == name).unwrap();
            assert_eq!(shaded.errors, row.errors, "{}, {name}", shot.name);
            assert_eq!(Some(&shaded.picture), row.picture.as_ref());
            assert_eq!(shaded.noise, panel.noise_of(row));
            assert_eq!(shot.errors(&shaded.picture, shaded), row.errors);
        }
        assert!(shot.exact.errors.rmse < shot.plain.errors.rmse);
    }
}

#[test]
fn footprints_are_differences_of_slopes_in_each_pixel_s_own_frame() {
    for shot in shots() {
        let [width, height] = shot.quad_size();
        assert_eq!((width, height), (48, 28), "27 rows, and one more for the last quads");
        assert_eq!(shot.seen.len(), width * height);
        for (index, footprint) in shot.footprints.iter().enumerate() {
            let (x, y) = (index % shot.width, index / shot.width);
            // The quad's upper left pixel, and what a shader subtracts.
            let slope = |x: usize, y: usize| {
                let half = shot.seen[y * width + x].half;
                (half[2] > 0.0).then(|| slope_of(half))
            };
            let fine = |to: Option<[f32; 2]>, from: Option<[f32; 2]>, odd: bool| {
                let sign = if odd { -1.0 } else { 1.0 };
                let (to, from) = (to?, from?);
                Some([0, 1].map(|k| sign * (to[k] - from[k])))
            };
            let u = fine(slope(x | 1, y), slope(x & !1, y), x % 2 == 1);
            let v = fine(slope(x, y | 1), slope(x, y & !1), y % 2 == 1);
            let expected = match (u, v) {
                (Some(u), Some(v)) => [u, v],
                _ => [[0.0; 2]; 2],
            };
            assert_eq!(*footprint, expected, "{} {x} {y}", shot.name);
        }
    }
}

#[test]
fn the_balls_analytic_footprints_are_those_of_kaplanyan_s_matrix() {
    let shot = &shots()[0];
    let mut judged = 0;
    for index in (0..shot.judged.len()).filter(|&index| shot.judged[index]) {
        // Rows of `traced` are those of whole quads, as wide as the picture's.
        let (trace, seen) = (&shot.traced[index], &shot.seen[index]);
        let (eye, light) = (Vertex::at(trace.eye).unwrap(), Vertex::distant(seen.wi).unwrap());
        let path = Path { eye, light, curvature: trace.curvature };
        let [mut u, mut v] = trace.steps.map(|step| path.motion(step));
        (u.spin, v.spin) = (trace.spins[0], trace.spins[1]);
        let footprint = Footprint::from_motion(path.half_vector(), &u, &v).unwrap_or_default();
        let [u, v] = shot.analytic[index];
        let size = u.iter().chain(&v).fold(0.0_f32, |most, x| most.max(x.abs()));
        for (got, want) in footprint.u.iter().chain(&footprint.v).zip(u.iter().chain(&v)) {
            assert!((got - want).abs() <= 1e-2 * size, "{index}: {footprint:?} for {u:?} {v:?}");
        }
        assert_eq!(shot.disagreement[index], non_overlap(shot.footprints[index], [u, v]));
        judged += 1;
    }
    assert!(judged > 100, "{judged}");
}

#[test]
fn an_alpha_that_is_none_is_refused() {
    assert!(Shot::balls(16, -0.01).is_err() && Shot::leather(16, f64::NAN).is_err());
}
