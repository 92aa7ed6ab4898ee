//! Three components and what geometry asks of them.

use crate::scalar::Scalar;

pub(crate) type Vector<R> = [R; 3];

#[inline]
pub(crate) fn dot<R: Scalar>(a: Vector<R>, b: Vector<R>) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
pub(crate) fn cross<R: Scalar>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline]
pub(crate) fn add<R: Scalar>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

#[inline]
pub(crate) fn sub<R: Scalar>(a: Vector<R>, b: Vector<R>) -> Vector<R> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// a + t b.
#[inline]
pub(crate) fn along<R: Scalar>(a: Vector<R>, t: R, b: Vector<R>) -> Vector<R> {
    [a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]]
}

#[inline]
pub(crate) fn scaled<R: Scalar>(t: R, a: Vector<R>) -> Vector<R> {
    a.map(|x| t * x)
}

/// What is left of `a` without its part along the unit vector `n`.
#[inline]
pub(crate) fn tangential<R: Scalar>(a: Vector<R>, n: Vector<R>) -> Vector<R> {
    along(a, -dot(a, n), n)
}

/// A vector turned about the z axis by an angle in radians, from x towards y.
pub(crate) fn turned(v: Vector<f64>, angle: f64) -> Vector<f64> {
    let (sin, cos) = angle.sin_cos();
    [cos * v[0] - sin * v[1], sin * v[0] + cos * v[1], v[2]]
}

/// A vector in another precision.
pub(crate) fn cast<R: Scalar>(v: Vector<f64>) -> Vector<R> {
    v.map(R::lit)
}

#[cfg(test)]
mod tests {
    use super::{along, cross, dot, tangential};

    #[test]
    fn cross_products_are_right_handed_and_tangential_parts_perpendicular() {
        assert_eq!(cross([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]), [0.0, 0.0, 1.0]);
        let (a, n) = ([0.3_f64, -0.4, 0.9], [0.6, 0.0, 0.8]);
        let rest = tangential(a, n);
        assert!(dot(rest, n).abs() < 1e-15);
        let back = along(rest, dot(a, n), n);
        assert!(a.iter().zip(back).all(|(a, b): (&f64, f64)| (a - b).abs() < 1e-15));
    }
}
