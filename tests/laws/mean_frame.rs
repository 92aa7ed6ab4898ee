//! The frame about a mean slope: a rotation, with the derivative it says. What the facade draws in
//! it is in tests/laws/multilobe_sampling.rs.

use crate::common::{check, near, near_all};
use lobe::slope::direction::{normal_of, slope_of};
use lobe::slope::{MeanFrame, jacobian::apply};
use lobe::{Psd, SlopeMoments};

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Lengths and angles stay, handedness too, and the mean's normal becomes +z.
#[test]
fn it_is_a_rotation_that_rights_the_mean() {
    check(20_000, |source| {
        let mean = source.mean();
        let frame = MeanFrame::of(mean);
        let (a, b) = (source.direction(), source.direction());
        let (p, q) = (frame.to_local(a), frame.to_local(b));
        near(dot(p, q), dot(a, b), 1e-14, &(mean, a, b))?;
        let cross = |a: [f64; 3], b: [f64; 3]| {
            [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        };
        near_all(&frame.to_local(cross(a, b)), &cross(p, q), 1e-14, &(mean, a, b))?;
        near_all(&frame.to_local(normal_of(mean)), &[0.0, 0.0, 1.0], 1e-14, &mean)
    });
}

/// The derivative at the mean, by differences of slopes.
#[test]
fn its_jacobian_is_that_of_slopes() {
    check(5000, |source| {
        let mean = source.vector(1e-3, 5.0);
        let frame = MeanFrame::of(mean);
        let step = 1e-5;
        let turn = source.uniform(0.0, 7.0);
        let (sin, cos) = turn.sin_cos();
        let at =
            |k: f64| slope_of(frame.to_local(normal_of([mean[0] + k * cos, mean[1] + k * sin])));
        let (ahead, behind) = (at(step), at(-step));
        let change = [0, 1].map(|k| (ahead[k] - behind[k]) / (2.0 * step));
        near_all(&change, &apply(frame.jacobian(), [cos, sin]), 1e-8, &(mean, turn))
    });
}

/// A narrow relief keeps its density: moments by the derivative against those of samples, each
/// turned by itself.
#[test]
fn moments_are_those_of_turned_samples() {
    let mean = [0.8, -0.5];
    let covariance = Psd::new(4e-4, 1e-4, 2e-4).expect("valid");
    let relief = SlopeMoments::new(mean, covariance).expect("in range");
    let frame = MeanFrame::of(mean);
    let turned = frame.moments(&relief);
    assert_eq!(turned.mean(), [0.0; 2]);
    // Four nodes that have these moments: mean +- sqrt(2) times the columns of a root.
    let [a, b, c] = covariance.cholesky();
    let columns = [[a, b], [0.0, c]].map(|column| column.map(|x| x * std::f64::consts::SQRT_2));
    let mut second = [0.0; 3];
    for column in columns {
        for sign in [-1.0, 1.0] {
            let slope = [mean[0] + sign * column[0], mean[1] + sign * column[1]];
            let [x, y] = slope_of(frame.to_local(normal_of(slope)));
            second = [second[0] + 0.25 * x * x, second[1] + 0.25 * x * y, second[2] + 0.25 * y * y];
        }
    }
    for (got, want) in turned.covariance().entries().iter().zip(second) {
        // What is left is of second order in deviations of 0.02.
        assert!((got / want - 1.0).abs() < 0.01, "{got} {want}");
    }
}
