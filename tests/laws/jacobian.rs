//! Every Jacobian is the derivative of its map, by central differences of the map itself.

use crate::common::arbitrary::Source;
use crate::common::{check, ensure, near};
use core::fmt::Debug;
use lobe::slope::jacobian::{
    apply, disk_to_slope, reflection_per_normal, slope_per_normal, sphere_to_disk, sphere_to_slope,
};
use lobe::{Footprint, Path, Vertex};
use nalgebra::{Matrix2, Vector3};
use proptest::test_runner::TestCaseResult;

/// Central differences of fourth order: truncation (step/scale)^4 / 30 times the fifth derivative,
/// about 1e-12 for a step of a thousandth of the map's scale; rounding 1e-16/1e-3.
const STEP: f64 = 1e-3;
const DIFFERENCES: f64 = 1e-9;

fn derivative<const N: usize>(f: &dyn Fn(f64) -> [f64; N], step: f64) -> [f64; N] {
    let [near, far] = [1.0, 2.0].map(|k| {
        let (ahead, behind) = (f(k * step), f(-k * step));
        core::array::from_fn::<f64, N, _>(|i| (ahead[i] - behind[i]) / (2.0 * k * step))
    });
    core::array::from_fn(|i| (4.0 * near[i] - far[i]) / 3.0)
}

/// Columns of derivatives against a matrix, relative to its largest entry.
fn is_derivative(
    matrix: [[f64; 2]; 2],
    columns: [[f64; 2]; 2],
    inputs: &dyn Debug,
) -> TestCaseResult {
    let size = matrix.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    for (i, row) in matrix.iter().enumerate() {
        for (j, &entry) in row.iter().enumerate() {
            near(entry, columns[j][i], DIFFERENCES * size, &(i, j, inputs))?;
        }
    }
    Ok(())
}

/// A direction off the normal, not below z = 1e-3, and its two great-circle tangents.
fn frame(source: &mut Source) -> [Vector3<f64>; 3] {
    let cos = match source.pick(3) {
        0 => source.log_uniform(1e-3, 1.0),
        1 => 1.0 - source.log_uniform(1e-6, 1e-2),
        _ => source.uniform(0.05, 0.99),
    };
    let sin = ((1.0 - cos) * (1.0 + cos)).sqrt();
    let (s, c) = source.angle().sin_cos();
    [
        Vector3::new(sin * c, sin * s, cos),
        Vector3::new(cos * c, cos * s, -sin),
        Vector3::new(-s, c, 0.0),
    ]
}

fn slope(h: &Vector3<f64>) -> [f64; 2] {
    [-h.x / h.z, -h.y / h.z]
}

#[test]
fn jacobians_of_the_sphere_are_its_derivatives() {
    check(20_000, |source| {
        let [h, out, across] = frame(source);
        let step = STEP * h.z;
        let walk = |tangent: Vector3<f64>, t: f64| h * t.cos() + tangent * t.sin();
        let to_slope = [out, across].map(|e| derivative(&|t| slope(&walk(e, t)), step));
        let to_disk = [out, across].map(|e| {
            derivative(
                &|t| {
                    let p = walk(e, t);
                    [p.x, p.y]
                },
                STEP,
            )
        });
        let unit = [h.x, h.y, h.z];
        is_derivative(sphere_to_slope(unit), to_slope, &("slope", unit))?;
        is_derivative(sphere_to_disk(unit), to_disk, &("disk", unit))?;
        let (det, cube) = (Matrix2::from(to_slope).determinant(), slope_per_normal(unit));
        near(cube, det.abs(), 1e-8 * cube, &("area", unit))
    });
}

#[test]
fn the_jacobian_of_the_disk_is_its_derivative() {
    check(20_000, |source| {
        let [h, ..] = frame(source);
        // The height's square root has its scale: z^2 in radial steps.
        let step = STEP * h.z * h.z;
        let on_disk = |x: f64, y: f64| {
            let z = ((1.0 - x.hypot(y)) * (1.0 + x.hypot(y))).sqrt();
            slope(&Vector3::new(x, y, z))
        };
        let columns = [
            derivative(&|t| on_disk(h.x + t, h.y), step),
            derivative(&|t| on_disk(h.x, h.y + t), step),
        ];
        let unit = [h.x, h.y, h.z];
        let matrix = disk_to_slope(unit);
        let size = matrix.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        // Rounding of the rim: 1 - r^2 has an error of 1e-16 against z^2.
        let rounding = 1e-16 / (h.z * h.z) / STEP;
        for i in 0..2 {
            for j in 0..2 {
                let tolerance = (DIFFERENCES + 4.0 * rounding) * size;
                near(matrix[i][j], columns[j][i], tolerance, &(i, j, unit))?;
            }
        }
        // A footprint is carried by this matrix.
        let (u, v) = (source.vector(1e-3, 1.0), source.vector(1e-3, 1.0));
        let footprint = Footprint::from_disk(unit, u, v);
        let same = footprint == Footprint::from_slopes(apply(matrix, u), apply(matrix, v));
        ensure(same, "a footprint on the disk is carried by the Jacobian", &(unit, u, v))
    });
}

#[test]
fn reflection_stretches_solid_angles_by_four_cosines() {
    check(20_000, |source| {
        let [m, out, across] = frame(source);
        let [wo, ..] = frame(source);
        let columns = [out, across].map(|e| {
            let walk = |t: f64| {
                let m = m * t.cos() + e * t.sin();
                let wi = m * (2.0 * m.dot(&wo)) - wo;
                [wi.x, wi.y, wi.z]
            };
            Vector3::from(derivative(&walk, STEP))
        });
        let area = columns[0].cross(&columns[1]).norm();
        let got = reflection_per_normal([m.x, m.y, m.z], [wo.x, wo.y, wo.z]);
        near(got, area, 1e-9, &(m, wo))
    });
}

/// The half vector of a path whose surface point moves: positions, normal and tangents move with
/// it.
fn moved_plane_point(
    ends: &[(Vector3<f64>, bool); 2],
    curvature: [f64; 3],
    step: [f64; 2],
) -> [f64; 2] {
    let x = Vector3::new(step[0], step[1], 0.0);
    let [b11, b12, b22] = curvature;
    let dn = [b11 * step[0] + b12 * step[1], b12 * step[0] + b22 * step[1]];
    // The normal turns by B dx; the tangents turn with it, without spinning: first order in dx.
    let normal = Vector3::new(dn[0], dn[1], 1.0);
    let tangents = [Vector3::new(1.0, 0.0, -dn[0]), Vector3::new(0.0, 1.0, -dn[1])];
    let towards = |(end, distant): &(Vector3<f64>, bool)| {
        if *distant { end.normalize() } else { (end - x).normalize() }
    };
    let g = towards(&ends[0]) + towards(&ends[1]);
    tangents.map(|t| g.dot(&t) / g.dot(&normal))
}

#[test]
fn the_jacobian_of_a_path_is_the_derivative_of_its_half_vector() {
    check(20_000, |source| {
        let ends = [(); 2].map(|()| {
            let [x, y, z] = source.direction();
            let distance = source.log_uniform(0.3, 100.0);
            let above = Vector3::new(x, y, z.max(0.05)).normalize();
            (above * distance, source.pick(3) == 1)
        });
        let curvature =
            [source.uniform(-2.0, 2.0), source.uniform(-1.0, 1.0), source.uniform(-2.0, 2.0)];
        let vertex = |(end, distant): &(Vector3<f64>, bool)| {
            let position = [end.x, end.y, end.z];
            if *distant { Vertex::distant(position) } else { Vertex::at(position) }
        };
        let path = Path {
            eye: vertex(&ends[0]).expect("not at the origin"),
            light: vertex(&ends[1]).expect("not at the origin"),
            curvature,
        };
        let inputs = (ends, curvature);
        let point = moved_plane_point(&ends, curvature, [0.0; 2]);
        let got = path.plane_point();
        for k in 0..2 {
            near(got[k], point[k], 1e-14 * (1.0 + point[k].abs()), &inputs)?;
        }
        // Scales: the nearer end, and the height of the half vector.
        let step = 0.01 * STEP;
        let columns = [
            derivative(&|t| moved_plane_point(&ends, curvature, [t, 0.0]), step),
            derivative(&|t| moved_plane_point(&ends, curvature, [0.0, t]), step),
        ];
        let matrix = path.slope_jacobian();
        let size = 1.0 + matrix.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        let rounding = 8.0 * f64::EPSILON * (1.0 + point[0].abs() + point[1].abs()) / step;
        for i in 0..2 {
            for j in 0..2 {
                near(matrix[i][j], columns[j][i], DIFFERENCES * size + rounding, &(i, j, inputs))?;
            }
        }
        let (u, v) = (source.vector(1e-3, 1.0), source.vector(1e-3, 1.0));
        let footprint = Footprint::from_positions(matrix, u, v);
        let carried = matrix[0][0] * u[0] + matrix[0][1] * u[1];
        near(footprint.u[0], carried, 1e-12 * size, &(inputs, u, v))
    });
}

/// Differences of half vectors are the footprint's finite form: exact for a plane of slopes.
#[test]
fn half_vectors_of_a_quad_give_their_slope_differences() {
    check(10_000, |source| {
        let (here, right, up) = (source.slope(), source.slope(), source.slope());
        let length = source.log_uniform(0.1, 10.0);
        let vector = |s: [f64; 2]| [-s[0] * length, -s[1] * length, length];
        let footprint = Footprint::from_half_vectors(vector(here), vector(right), vector(up))
            .expect("above the surface");
        for (got, end) in [(footprint.u, right), (footprint.v, up)] {
            for k in 0..2 {
                let tolerance = 4.0 * f64::EPSILON * (end[k].abs() + here[k].abs());
                near(got[k], end[k] - here[k], tolerance, &(here, right, up))?;
            }
        }
        Ok(())
    });
}
