//! Footprints from motions are derivatives of slopes over explicit surfaces, by central
//! differences.

use crate::common::arbitrary::Source;
use crate::common::{ULP_SINGLE, check, near};
use core::fmt::Debug;
use lobe::slope::Motion;
use lobe::{Error, Footprint, Path, Real, Vertex};
use nalgebra::{Matrix2, Matrix3, Rotation3, Vector2, Vector3};
use proptest::test_runner::TestCaseResult;

type V3 = Vector3<f64>;

/// Steps of a thousandth of a scene of size 1, and what differences of fourth order leave of it.
const STEP: f64 = 1e-3;
const DIFFERENCES: f64 = 1e-9;

fn derivative<const N: usize>(f: &dyn Fn(f64) -> [f64; N]) -> [f64; N] {
    let [near, far] = [1.0, 2.0].map(|k| {
        let (ahead, behind) = (f(k * STEP), f(-k * STEP));
        core::array::from_fn::<f64, N, _>(|i| (ahead[i] - behind[i]) / (2.0 * k * STEP))
    });
    core::array::from_fn(|i| (4.0 * near[i] - far[i]) / 3.0)
}

/// Tangents and normal as columns: the slope of g in it, and g's components.
fn slope_in(frame: &Matrix3<f64>, g: &V3) -> [f64; 2] {
    let local = frame.transpose() * g;
    [-local.x / local.z, -local.y / local.z]
}

/// The footprint of these motions is what the slope does, relative to the largest derivative and
/// to 1.
fn follows(
    g: V3,
    motions: &[Motion<f64>; 2],
    slopes: &[[f64; 2]; 2],
    inputs: &dyn Debug,
) -> TestCaseResult {
    let [u, v] = motions;
    let footprint = Footprint::from_motion([g.x, g.y, g.z], u, v).expect("above the surface");
    let p = [g.x / g.z, g.y / g.z].map(f64::abs);
    // Of the slope's own curvature, g over height in the fifth power.
    let size = slopes.as_flattened().iter().fold(1.0_f64, |m, x| m.max(x.abs()))
        * (1.0 + p[0] + p[1]).powi(4);
    for (got, want) in [(footprint.u, slopes[0]), (footprint.v, slopes[1])] {
        for k in 0..2 {
            near(got[k], want[k], DIFFERENCES * size, inputs)?;
        }
    }
    Ok(())
}

fn vector(source: &mut Source, size: f64) -> V3 {
    V3::new(source.uniform(-size, size), source.uniform(-size, size), source.uniform(-size, size))
}

/// A point above the surface, near or far.
fn above(source: &mut Source) -> V3 {
    let [x, y, z] = source.direction();
    V3::new(x, y, z.max(0.3)).normalize() * source.log_uniform(0.5, 100.0)
}

/// g(x) of an eye and a light at finite positions.
fn half(ends: &[V3; 2], x: &V3) -> V3 {
    (ends[0] - x).normalize() + (ends[1] - x).normalize()
}

/// The rotation that carries +z to n and turns nothing else: a frame that only follows its normal.
fn following(n: &V3) -> Matrix3<f64> {
    let axis = V3::z().cross(n);
    let angle = axis.norm().atan2(n.z);
    let turn = nalgebra::Unit::try_new(axis, 1e-300);
    turn.map_or(Matrix3::identity(), |axis| Rotation3::from_axis_angle(&axis, angle).into_inner())
}

fn path(ends: &[V3; 2], curvature: [f64; 3]) -> Path<f64> {
    let [eye, light] =
        ends.map(|end| Vertex::at([end.x, end.y, end.z]).expect("not at the origin"));
    Path { eye, light, curvature }
}

#[test]
fn a_sphere_moves_the_slope_as_its_path_says() {
    check(10_000, |source| {
        let radius = source.log_uniform(0.3, 100.0) * source.sign();
        let ends = [above(source), above(source)];
        let directions = [source.angle(), source.angle()];
        let path = path(&ends, [1.0 / radius, 0.0, 1.0 / radius]);
        // Along a great circle; for a negative radius the surface is a bowl.
        let slopes = directions.map(|phi| {
            derivative(&|arc| {
                let (sin, cos) = (arc / radius).sin_cos();
                let n = V3::new(sin * phi.cos(), sin * phi.sin(), cos);
                let x = (n - V3::z()) * radius;
                slope_in(&following(&n), &half(&ends, &x))
            })
        });
        let motions = directions.map(|phi| path.motion([phi.cos(), phi.sin()]));
        follows(half(&ends, &V3::zeros()), &motions, &slopes, &(radius, ends, directions))
    });
}

#[test]
fn a_quadric_under_near_lights_moves_the_slope_as_its_path_says() {
    check(10_000, |source| {
        let [b11, b12, b22] = [(); 3].map(|()| source.uniform(-1.5, 1.5));
        let ends = [above(source), above(source)];
        let steps = [source.vector(0.1, 1.0), source.vector(0.1, 1.0)];
        let path = path(&ends, [b11, b12, b22]);
        let shape = Matrix2::new(b11, b12, b12, b22);
        let slopes = steps.map(|step| {
            derivative(&|t| {
                let v = Vector2::from(step) * t;
                let turned = shape * v;
                let x = V3::new(v.x, v.y, -0.5 * v.dot(&turned));
                let n = V3::new(turned.x, turned.y, 1.0).normalize();
                slope_in(&following(&n), &half(&ends, &x))
            })
        });
        let motions = steps.map(|step| path.motion(step));
        let inputs = (b11, b12, b22, ends, steps);
        follows(half(&ends, &V3::zeros()), &motions, &slopes, &inputs)?;
        // The same by the matrix M, whose plane has the other sign.
        let [u, v] = motions;
        let moved = Footprint::from_motion(path.half_vector(), &u, &v).expect("above the surface");
        let placed = Footprint::from_positions(path.slope_jacobian(), steps[0], steps[1]);
        let size = path.slope_jacobian().as_flattened().iter().fold(1.0_f64, |m, x| m.max(x.abs()));
        for k in 0..2 {
            near(moved.u[k], -placed.u[k], 1e-13 * size, &inputs)?;
            near(moved.v[k], -placed.v[k], 1e-13 * size, &inputs)?;
        }
        Ok(())
    });
}

/// A bumpy plane: the shading normal is not the surface's, and the tangent is a brushed metal's
/// that turns.
#[test]
fn shading_normals_and_brushed_tangents_move_the_slope_as_their_motions_say() {
    check(10_000, |source| {
        let ends = [above(source) + V3::z(), above(source) + V3::z()];
        let (tilt, bump) = (vector(source, 0.2), [vector(source, 0.5), vector(source, 0.5)]);
        let (brush, turning) =
            (source.angle(), [source.uniform(-2.0, 2.0), source.uniform(-2.0, 2.0)]);
        let frame_at = |x: &V3| {
            let n = (V3::z() + tilt + bump[0] * x.x + bump[1] * x.y).normalize();
            let angle = brush + turning[0] * x.x + turning[1] * x.y;
            let along = V3::new(angle.cos(), angle.sin(), 0.0);
            let tangent = (along - n * n.dot(&along)).normalize();
            Matrix3::from_columns(&[tangent, n.cross(&tangent), n])
        };
        let steps =
            [source.vector(0.1, 1.0), source.vector(0.1, 1.0)].map(|[x, y]| V3::new(x, y, 0.0));
        let here = frame_at(&V3::zeros());
        let g = half(&ends, &V3::zeros());
        let local = here.transpose() * g;
        if local.z < 0.3 {
            return Ok(());
        }
        let slopes = steps.map(|step| {
            derivative(&|t| slope_in(&frame_at(&(step * t)), &half(&ends, &(step * t))))
        });
        let motions = steps.map(|step| {
            let in_frame = |w: V3| -> [f64; 3] { (here.transpose() * w).into() };
            let [x, y, _] = derivative(&|t| in_frame(frame_at(&(step * t)).column(2).into()));
            let [_, spin, _] = derivative(&|t| in_frame(frame_at(&(step * t)).column(0).into()));
            let half = derivative(&|t| in_frame(half(&ends, &(step * t))));
            Motion { half_vector: half, normal: [x, y], spin }
        });
        follows(local, &motions, &slopes, &(ends, tilt, bump, brush, turning, steps))
    });
}

/// Any half vector that moves on a line in any frame that turns about any axis: dn = omega x n,
/// spin = omega_z.
#[test]
fn a_turning_frame_moves_the_slope() {
    check(20_000, |source| {
        let g =
            V3::new(source.uniform(-1.0, 1.0), source.uniform(-1.0, 1.0), source.uniform(0.4, 2.0));
        let (moves, turns) =
            ([(); 2].map(|()| vector(source, 1.0)), [(); 2].map(|()| vector(source, 1.0)));
        let slopes = [0, 1].map(|k| {
            derivative(&|t| {
                slope_in(&Rotation3::new(turns[k] * t).into_inner(), &(g + moves[k] * t))
            })
        });
        let motions = [0, 1].map(|k| Motion {
            half_vector: moves[k].into(),
            normal: [turns[k].y, -turns[k].x],
            spin: turns[k].z,
        });
        follows(g, &motions, &slopes, &(g, moves, turns))?;
        // The length of g means nothing where it is the same for its change.
        let long = source.log_uniform(1e-3, 1e3);
        let [u, v] = motions;
        let [same, other] = [1.0, long].map(|length| {
            let stretched =
                [u, v].map(|m| Motion { half_vector: m.half_vector.map(|x| x * length), ..m });
            Footprint::from_motion((g * length).data.0[0], &stretched[0], &stretched[1])
                .expect("above")
        });
        for (a, b) in same.u.iter().chain(&same.v).zip(other.u.iter().chain(&other.v)) {
            near(*b, *a, 1e-12, &(g, moves, turns, long))?;
        }
        Ok(())
    });
}

/// A spin alone turns the footprint's pattern and nothing that an isotropic lobe would see: |s|
/// stays.
#[test]
fn a_spin_moves_the_slope_around_the_normal() {
    let spin = Motion { spin: 0.25, ..Motion::default() };
    let footprint =
        Footprint::from_motion([-0.5_f64, -1.0, 1.0], &spin, &Motion::default()).expect("above");
    // Seen from a frame that turns left, the slope (0.5, 1) turns right.
    assert_eq!((footprint.u, footprint.v), ([0.25, -0.125], [0.0, 0.0]));
}

/// The sum of what is added, as its rounding is relative to that.
fn terms(g: [f64; 3], m: &Motion<f64>) -> f64 {
    let p = (g[0] / g[2]).abs() + (g[1] / g[2]).abs();
    let dg = m.half_vector.map(|x| (x / g[2]).abs());
    let turn = m.normal[0].abs() + m.normal[1].abs();
    dg[0] + dg[1] + turn + p * (dg[2] + p * turn + m.spin.abs())
}

#[test]
fn single_precision_agrees_with_double() {
    check(20_000, |source| {
        let [x, y, z] = source.direction().map(|x| f64::from(x as f32));
        let g = [x, y, z.max(1e-5)].map(|x| f64::from(x as f32));
        let motions = [(); 2].map(|()| {
            let size = source.log_uniform(1e-6, 10.0);
            let [a, b] = [vector(source, size), vector(source, size)]
                .map(|v| v.map(|x| f64::from(x as f32)));
            Motion { half_vector: a.into(), normal: [b.x, b.y], spin: b.z }
        });
        let single = motions.map(|m| Motion {
            half_vector: m.half_vector.map(|x| x as f32),
            normal: m.normal.map(|x| x as f32),
            spin: m.spin as f32,
        });
        let want = Footprint::from_motion(g, &motions[0], &motions[1]).expect("above");
        let got =
            Footprint::from_motion(g.map(|x| x as f32), &single[0], &single[1]).expect("above");
        for (got, want, motion) in [(got.u, want.u, motions[0]), (got.v, want.v, motions[1])] {
            for k in 0..2 {
                let tolerance = 8.0 * ULP_SINGLE * terms(g, &motion);
                near(f64::from(got[k]), want[k], tolerance, &(g, motion))?;
            }
        }
        Ok(())
    });
}

fn refuses<R: Real>() {
    let still = Motion::<R>::default();
    let number = R::lit;
    let refused = |g: [f64; 3], u: &Motion<R>, v: &Motion<R>| {
        let got = Footprint::from_motion(g.map(number), u, v);
        let above = g[2] > 0.0 && g.iter().all(|x| x.is_finite());
        let by_derivative = matches!(got, Err(Error::Derivative(_)));
        let by_half_vector = matches!(got, Err(Error::HalfVector(_)));
        assert!(if above { by_derivative } else { by_half_vector }, "{got:?}: {g:?} {u:?} {v:?}");
    };
    for g in [
        [0.0, 0.0, 0.0],
        [0.3, 0.0, -0.1],
        [1.0, 0.0, 0.0],
        [0.0, 0.0, f64::NAN],
        [f64::NAN, 0.0, 1.0],
        [0.0, f64::INFINITY, 1.0],
        [0.0, 0.0, f64::INFINITY],
    ] {
        refused(g, &still, &still);
    }
    let endless = number(f64::INFINITY);
    for wrong in [
        Motion { half_vector: [endless, R::ZERO, R::ZERO], ..still },
        Motion { normal: [R::ZERO, number(f64::NAN)], ..still },
        Motion { spin: endless, ..still },
        // Finite, but its derivative has no number.
        Motion { half_vector: [R::MAX; 3], ..still },
    ] {
        refused([0.5, 0.0, 0.1], &wrong, &still);
        refused([0.5, 0.0, 0.1], &still, &wrong);
    }
    let fine = Footprint::from_motion([R::ZERO, R::ZERO, R::ONE], &still, &still);
    assert_eq!(fine, Ok(Footprint::default()));
}

#[test]
fn half_vectors_below_the_horizon_are_refused() {
    refuses::<f64>();
    refuses::<f32>();
    let below = Vertex::distant([1.0_f64, 0.0, -0.2]).expect("a direction");
    let path = Path { eye: below, light: below, curvature: [1.0, 0.0, 1.0] };
    let motion = path.motion([1.0, 0.0]);
    assert!(matches!(
        Footprint::from_motion(path.half_vector(), &motion, &motion),
        Err(Error::HalfVector(_))
    ));
    assert_eq!((path.slope_jacobian(), path.plane_point()), ([[0.0; 2]; 2], [0.0; 2]));
}
