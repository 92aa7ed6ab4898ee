//! Pixel steps of rays: neighboring rays that meet the plane, and the ellipse of a cone.

use crate::common::arbitrary::Source;
use crate::common::{ULP_SINGLE, check, near, near_all};
use lobe::slope::ray;
use lobe::{Psd, Real};
use nalgebra::{Vector2, Vector3};
use proptest::test_runner::TestCaseResult;

type V3 = Vector3<f64>;

fn vector(source: &mut Source, size: f64) -> V3 {
    V3::new(source.uniform(-size, size), source.uniform(-size, size), source.uniform(-size, size))
}

/// A view direction, not below z = 0.02.
fn view(source: &mut Source) -> V3 {
    let [x, y, z] = source.direction();
    V3::new(x, y, z.max(0.02)).normalize()
}

#[test]
fn a_step_is_where_the_neighboring_ray_meets_the_plane() {
    check(20_000, |source| {
        let (wo, distance) = (view(source), source.log_uniform(0.1, 100.0));
        let (origin, direction) = (vector(source, 1.0), vector(source, 1.0));
        // The neighbor's unit direction turns; only what is across the ray changes it.
        let direction = direction - wo * wo.dot(&direction);
        let hit = |e: f64| {
            let start = wo * distance + origin * e;
            let along = (-wo + direction * e).normalize();
            let p = start - along * (start.z / along.z);
            Vector2::new(p.x, p.y)
        };
        // Fourth order; the scale is the height of wo.
        let e = 1e-3 * wo.z;
        let [near_by, far] = [1.0, 2.0].map(|k| (hit(k * e) - hit(-k * e)) / (2.0 * k * e));
        let want = (near_by * 4.0 - far) / 3.0;
        let got = ray::step(wo.data.0[0], origin.data.0[0], direction.data.0[0], distance);
        let size = 1e-8 * (1.0 + want.norm()) / wo.z;
        near_all(&got, want.as_slice(), size, &(wo, distance, origin, direction))
    });
}

/// The disk of the cone's width across the ray, carried along the ray onto the plane, by any two of
/// its radii.
#[test]
fn steps_of_a_cone_span_its_ellipse() {
    check(20_000, |source| {
        let (wo, width, turn) = (view(source), source.log_uniform(1e-4, 10.0), source.angle());
        let first = wo.cross(&V3::new(0.36, 0.48, 0.8)).normalize();
        if !first.norm().is_finite() {
            return Ok(());
        }
        let second = wo.cross(&first);
        let (sin, cos) = turn.sin_cos();
        let [u, v] = [first * cos + second * sin, second * cos - first * sin].map(|e| {
            let along = e.z / wo.z;
            [width * (e.x - along * wo.x), width * (e.y - along * wo.y)]
        });
        let [along, across] = ray::cone_steps(wo.data.0[0], width);
        let (got, want) = (Psd::outer_sum(along, across), Psd::outer_sum(u, v));
        let size = 1e-12 * want.trace();
        near_all(&got.entries(), &want.entries(), size, &(wo, width, turn))?;
        near(got.root_det(), width * width / wo.z, 1e-12 * width * width / wo.z, &(wo, width))?;
        // The same two by the differential of a ray whose origin moves across.
        let steps =
            [first, second].map(|e| ray::step(wo.data.0[0], (e * width).data.0[0], [0.0; 3], 1.0));
        near_all(&Psd::outer_sum(steps[0], steps[1]).entries(), &want.entries(), size, &(wo, width))
    });
}

fn widths<R: Real>(source: &mut Source) -> TestCaseResult {
    let (width, spread) =
        (R::lit(source.log_uniform(1e-4, 10.0)), R::lit(source.log_uniform(1e-5, 1.0)));
    let distance = R::lit(source.log_uniform(1e-3, 1e3));
    let want = width.to_f64() + 2.0 * distance.to_f64() * (0.5 * spread.to_f64()).tan();
    let got = ray::cone_width(width, spread, distance).to_f64();
    near(got, want, 4.0 * R::EPSILON.to_f64() * want, &(width, spread, distance))
}

#[test]
fn a_cone_widens_by_twice_the_tangent_of_half_its_angle() {
    check(10_000, widths::<f64>);
    check(10_000, widths::<f32>);
}

#[test]
fn single_precision_agrees_with_double() {
    check(10_000, |source| {
        let narrow = |v: V3| -> [f32; 3] { [v.x as f32, v.y as f32, v.z as f32] };
        let [wo, origin, direction] =
            [view(source), vector(source, 1.0), vector(source, 1.0)].map(narrow);
        let (distance, wide) =
            (source.log_uniform(0.1, 100.0) as f32, |v: [f32; 3]| v.map(f64::from));
        let got = ray::step(wo, origin, direction, distance).map(f64::from);
        let want = ray::step(wide(wo), wide(origin), wide(direction), f64::from(distance));
        let size = 8.0 * ULP_SINGLE * (1.0 + 2.0 * f64::from(distance)) / f64::from(wo[2]);
        near_all(&got, &want, size, &(wo, origin, direction, distance))?;
        let (got, want) =
            (ray::cone_steps(wo, distance), ray::cone_steps(wide(wo), f64::from(distance)));
        let size = 8.0 * ULP_SINGLE * f64::from(distance) / f64::from(wo[2]);
        for (got, want) in got.into_iter().zip(want) {
            near_all(&got.map(f64::from), &want, size, &(wo, distance))?;
        }
        Ok(())
    });
}

/// At and below the horizon a step ends at a height of 1e-9, and straight from above any azimuth
/// will do.
#[test]
fn steps_at_the_ends_are_numbers() {
    for z in [0.0_f32, -0.5, 1e-20] {
        let step = ray::step([1.0, 0.0, z], [0.0, 0.0, 0.5], [0.0; 3], 1.0);
        assert!((step[0] + 0.5e9).abs() < 100.0 && step[1] == 0.0, "{step:?} at {z}");
        let [along, across] = ray::cone_steps([1.0, 0.0, z], 0.5);
        assert!((along[0] - 0.5e9).abs() < 100.0 && across == [-0.0, 0.5], "{along:?} {across:?}");
    }
    assert_eq!(ray::cone_steps([0.0_f64, 0.0, 1.0], 0.1), [[0.1, 0.0], [-0.0, 0.1]]);
}
