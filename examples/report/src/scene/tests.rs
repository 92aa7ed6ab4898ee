//! Laws of every scene: what a sample claims to change is how it changes, in both precisions.

use super::surface::{Shape, on_shape};
use super::{Scene, Subject, carried_maps};
use crate::camera::Size;
use crate::coverage;
use crate::light::LightKind;
use crate::method::{MovingPixel, Pixel, QuadPixel};

/// Every scene at a small size.
fn subjects(size: Size) -> Vec<Subject> {
    let maps = carried_maps(false).unwrap();
    vec![
        Subject::water(size),
        Subject::balls(size),
        Subject::torus(size),
        Subject::plane(size, &maps[0]),
        Subject::mapped_ball(size, &maps[0]),
        Subject::strips(size),
        Subject::disk(size),
    ]
}

/// Some judged points of a scene, off the pixels' centers.
fn points(scene: &Scene<f64>, size: Size) -> Vec<[f64; 2]> {
    let judged = coverage::judged(scene, size);
    let inside = judged.iter().enumerate().filter(|(_, judged)| **judged).map(|(index, _)| index);
    let places: Vec<_> = inside
        .map(|index| {
            let offset = |k: usize| 0.1 + 0.8 * ((index * k) % 97) as f64 / 97.0;
            let (x, y) = (index % size.width, index / size.width);
            [x as f64 + offset(31), y as f64 + offset(57)]
        })
        .collect();
    let step = places.len().div_ceil(150).max(1);
    places.into_iter().step_by(step).collect()
}

/// The largest difference between derivatives of the half vector on the projected disk: of a quad
/// whose pixels are `h` apart, and analytic; and the size of the latter. On the slope plane the two
/// grow without bound where half vectors near the horizon.
fn quad_error(scene: &Scene<f64>, [x, y]: [f64; 2], h: f64) -> [f64; 2] {
    let (here, motions) = scene.sample_in_motion(x, y);
    let (beside, below) = (scene.sample(x + h, y), scene.sample(x, y + h));
    let (here, beside, below) = (&here, &beside, &below);
    let quad = QuadPixel { here, beside, below, across: below }.narrowed_footprint();
    let analytic = MovingPixel { here, motions: &motions }.narrowed_footprint();
    let pairs = [(quad.u, analytic.u), (quad.v, analytic.v)];
    let error = pairs.map(|(q, a)| (q[0] / h - a[0]).abs().max((q[1] / h - a[1]).abs()));
    let [across, down] = analytic.extents();
    [error[0].max(error[1]), across.max(down)]
}

#[test]
fn quads_tend_to_motions_as_pixels_shrink() {
    let size = Size::of_width(96);
    for subject in subjects(size) {
        for light in LightKind::ALL {
            let scene = subject.lit(light).exact;
            let points = points(&scene, size);
            assert!(points.len() > 30, "{}: {}", subject.name, points.len());
            let mut kinks = 0;
            for &point in &points {
                let [wide, largest] = quad_error(&scene, point, 1e-3);
                let [narrow, _] = quad_error(&scene, point, 1e-4);
                // One-sided differences are off by as much as their step.
                let tends = narrow < 0.15 * wide + 1e-6 * largest && narrow < 0.01 * largest;
                // A bilinear map's derivative jumps at texel borders: a few points lie on one.
                kinks += usize::from(!tends);
                let name = &subject.name;
                assert!(tends || name.contains(':'), "{name} {point:?}: {wide} {narrow} {largest}");
            }
            assert!(kinks * 50 <= points.len(), "{}: {kinks} of {}", subject.name, points.len());
        }
    }
}

#[test]
fn normals_and_frames_turn_as_they_claim() {
    let size = Size::of_width(96);
    for subject in subjects(size) {
        let scene = subject.lit(LightKind::Distant).exact;
        let mut kinks = 0;
        let points = points(&scene, size);
        for &[x, y] in &points {
            let (_, motions) = scene.sample_in_motion(x, y);
            let h = 1e-4;
            for (motion, [dx, dy]) in motions.into_iter().zip([[h, 0.0], [0.0, h]]) {
                let frame = |k: f64| {
                    let ray = scene.camera.ray(x + k * dx, y + k * dy);
                    let hit = on_shape!(&scene.surface, shape => shape.hit(&ray)).unwrap();
                    super::Frame::around(hit.normal, hit.tangent)
                };
                let (here, before, after) = (frame(0.0), frame(-1.0), frame(1.0));
                let axis = |k: usize| {
                    let of = |frame: &super::Frame<f64>| frame.axes()[k];
                    let change = super::sub(of(&after), of(&before)).map(|c| c / (2.0 * h));
                    here.to_local(change)
                };
                let (normal, spin) = (axis(2), axis(0)[1]);
                let errors = [
                    normal[0] - motion.normal[0],
                    normal[1] - motion.normal[1],
                    spin - motion.spin,
                ];
                let size =
                    1e-6 + motion.normal[0].abs() + motion.normal[1].abs() + motion.spin.abs();
                if errors.iter().any(|error| error.abs() > 1e-4 * size) {
                    kinks += 1;
                    assert!(subject.name.contains(':'), "{} {x} {y}: {errors:?}", subject.name);
                }
            }
        }
        assert!(kinks * 50 <= points.len(), "{}: {kinks}", subject.name);
    }
}

#[test]
fn single_precision_sees_the_same_half_vectors() {
    let size = Size::of_width(96);
    for subject in subjects(size) {
        for light in LightKind::ALL {
            let lit = subject.lit(light);
            for [x, y] in points(&lit.exact, size) {
                // The same point in both precisions.
                let (x, y) = (x as f32, y as f32);
                let exact = lit.exact.sample(f64::from(x), f64::from(y));
                let single = lit.engine.sample(x, y);
                assert!(single.hit, "{} {x} {y}", subject.name);
                for k in 0..3 {
                    let error = (f64::from(single.half[k]) - exact.half[k]).abs();
                    assert!(error < 1e-3, "{} {x} {y}: {error}", subject.name);
                }
                let strength = f64::from(single.strength) / exact.strength - 1.0;
                assert!(strength.abs() < 1e-4);
            }
        }
    }
}

#[test]
fn lights_reach_every_scene_and_point_lights_turn_across_the_picture() {
    let size = Size::of_width(96);
    for subject in subjects(size) {
        let (lit, distant) = (subject.lit(LightKind::Point), subject.lit(LightKind::Distant));
        let points = points(&lit.exact, size);
        let bright = points.iter().filter(|p| distant.exact.sample(p[0], p[1]).wi[2] > 0.0).count();
        assert!(3 * bright > points.len(), "{}: {bright}", subject.name);
        let strengths = points.iter().map(|p| lit.exact.sample(p[0], p[1]).strength);
        let low = strengths.clone().fold(f64::INFINITY, f64::min);
        let high = strengths.fold(0.0, f64::max);
        assert!(high > 1.01 * low && high < 20.0 * low, "{}: {low} {high}", subject.name);
    }
}
