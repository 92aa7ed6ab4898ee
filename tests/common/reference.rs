//! What the laws hold the library against: formulas of their own, on nalgebra, statrs and
//! quadrature.

use super::arbitrary::{Ellipse, LobeInput};
use super::quadrature::{adaptive, trapezoid};
use core::f64::consts::PI;
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::{Distribution, Psd, Real};
use nalgebra::{Matrix2, Vector2};
use statrs::distribution::{Continuous, Normal, StudentsT};

/// A distribution that the tests know for themselves.
pub(crate) trait Known: Distribution {
    /// For messages.
    const NAME: &'static str;

    /// The slope density of a lobe at whitened coordinates, times the root of A's determinant.
    fn unit_density(w: [f64; 2]) -> f64;

    /// The same at a slope, as a product of a marginal and a conditional density of statrs.
    fn chained_density(lobe: &LobeInput, slope: [f64; 2]) -> f64;
}

/// Mean and factor of y given the whitened x: the linear regression of the second slope on the
/// first.
fn regression(lobe: &LobeInput, slope: [f64; 2]) -> (f64, f64, f64) {
    let Ellipse { x, y, rho } = lobe.ellipse;
    let first = (slope[0] - lobe.mean[0]) / x;
    let second_mean = lobe.mean[1] + rho * y * first;
    (first, second_mean, y * ((1.0 - rho) * (1.0 + rho)).sqrt())
}

impl Known for BeckmannDistribution {
    const NAME: &'static str = "Beckmann";

    fn unit_density([x, y]: [f64; 2]) -> f64 {
        (-(x * x + y * y)).exp() / PI
    }

    /// Normal deviates of variance alpha^2/2.
    fn chained_density(lobe: &LobeInput, slope: [f64; 2]) -> f64 {
        let (first, second_mean, width) = regression(lobe, slope);
        let half = 0.5_f64.sqrt();
        let marginal = Normal::new(0.0, half).expect("a deviation above 0");
        let conditional = Normal::new(second_mean, half * width).expect("a width above 0");
        marginal.pdf(first) / lobe.ellipse.x * conditional.pdf(slope[1])
    }
}

impl Known for GgxDistribution {
    const NAME: &'static str = "GGX";

    fn unit_density([x, y]: [f64; 2]) -> f64 {
        let secant2 = 1.0 + x * x + y * y;
        1.0 / (PI * secant2 * secant2)
    }

    /// Student's t with two degrees of freedom; given the first slope, with three, wider by the
    /// first.
    fn chained_density(lobe: &LobeInput, slope: [f64; 2]) -> f64 {
        let (first, second_mean, width) = regression(lobe, slope);
        let marginal = StudentsT::new(0.0, 0.5_f64.sqrt(), 2.0).expect("a scale above 0");
        let scale = width * ((1.0 + first * first) / 3.0).sqrt();
        let conditional = StudentsT::new(second_mean, scale, 3.0).expect("a scale above 0");
        marginal.pdf(first) / lobe.ellipse.x * conditional.pdf(slope[1])
    }
}

/// `mean + L R w`, R the rotation that takes the first axis to the unit vector `axis`.
pub(crate) fn turned_slope(lobe: &LobeInput, axis: [f64; 2], w: [f64; 2]) -> [f64; 2] {
    lobe.slope_at([axis[0] * w[0] - axis[1] * w[1], axis[1] * w[0] + axis[0] * w[1]])
}

/// The stretch a(w) and the unit vector along L^T w; a = 0 gives the first axis.
pub(crate) fn stretch(lobe: &LobeInput, w: [f64; 3]) -> (f64, [f64; 2]) {
    let Ellipse { x, y, rho } = lobe.ellipse;
    let minor = y * ((1.0 - rho) * (1.0 + rho)).sqrt();
    let along = [x * w[0] + rho * y * w[1], minor * w[1]];
    let length = along[0].hypot(along[1]);
    if length > 0.0 { (length, along.map(|v| v / length)) } else { (0.0, [1.0, 0.0]) }
}

/// Integral over the slopes s of max(0, w.m)/m_z times `density(s)`, by quadrature.
///
/// In whitened coordinates turned so that the first runs along L^T w, w.m/m_z is c - a x: the
/// integral over x ends at its zero, and is smooth. x = sinh, y = sinh: tails become exponential.
/// Relative error 1e-10; GGX's tail beyond x = -4e13 is 5e-14 of an area with |c/a| = 1, and grows
/// like |c/a|.
pub(crate) fn area_by_quadrature(
    lobe: &LobeInput,
    w: [f64; 3],
    density: &dyn Fn([f64; 2]) -> f64,
) -> f64 {
    let c = w[2] - lobe.mean[0] * w[0] - lobe.mean[1] * w[1];
    let (a, axis) = stretch(lobe, w);
    let root_det = lobe.ellipse.root_det();
    let mut outer = |xi: f64| {
        let x = xi.sinh();
        // Poles of the GGX integrand at Im = pi/2: a step of 0.2 errs by e^(-pi^2/0.2) = 4e-22.
        // Beckmann's is bounded for |Im| < pi/4: e^(-pi^2/0.4) = 2e-11. GGX leaves e^(-27) beyond
        // its reach.
        let reach = (2.0 + x.abs()).ln() + 9.0;
        let mut inner = |eta: f64| {
            let y = eta.sinh();
            density(turned_slope(lobe, axis, [x, y])) * eta.cosh()
        };
        (c - a * x) * xi.cosh() * trapezoid(&mut inner, reach, 0.2)
    };
    let end = if a > 0.0 { (c / a).asinh().min(32.0) } else { 32.0 };
    let middle = end.min(0.0);
    let low = adaptive(&mut outer, -32.0, middle, 1e-10);
    let high = if end > middle { adaptive(&mut outer, middle, end, 1e-10) } else { 0.0 };
    (low + high) * root_det
}

/// Entries of a symmetric matrix as nalgebra has it.
pub(crate) fn matrix([xx, xy, yy]: [f64; 3]) -> Matrix2<f64> {
    Matrix2::new(xx, xy, xy, yy)
}

/// Eigenvalues, larger first.
pub(crate) fn eigenvalues(entries: [f64; 3]) -> [f64; 2] {
    let values = matrix(entries).symmetric_eigenvalues();
    [values.max(), values.min()]
}

/// True if two factors agree to some roundings: `l_xx` and the determinant by themselves, `l_yx` by
/// the length of its row.
pub(crate) fn same_factor<R: Real>(a: &Psd<R>, b: &Psd<R>, roundings: f64) -> bool {
    let few = roundings * R::EPSILON.to_f64();
    let ([a_xx, a_yx, a_yy], [b_xx, b_yx, b_yy]) =
        (a.cholesky().map(R::to_f64), b.cholesky().map(R::to_f64));
    let row = b_yx.hypot(b_yy);
    let near = |x: f64, y: f64, scale: f64| (x - y).abs() <= few * scale;
    near(a_xx, b_xx, b_xx) && near(a_yx, b_yx, row) && near(a_yy, b_yy, b_yy)
}

/// Counter-clockwise by `angle`.
pub(crate) fn rotate(v: [f64; 2], angle: f64) -> [f64; 2] {
    let turned = nalgebra::Rotation2::new(angle) * Vector2::from(v);
    [turned.x, turned.y]
}

/// R M R^T as entries xx, xy, yy.
pub(crate) fn rotate_matrix(entries: [f64; 3], angle: f64) -> [f64; 3] {
    let rotation = nalgebra::Rotation2::new(angle).into_inner();
    let turned = rotation * matrix(entries) * rotation.transpose();
    [turned[(0, 0)], turned[(0, 1)], turned[(1, 1)]]
}
