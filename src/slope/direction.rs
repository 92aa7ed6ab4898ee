//! Directions, normals and slopes in the tangent frame: right-handed, normal along +z.
//!
//! Layer 1. A slope is $s = (-m_x/m_z, -m_y/m_z)$, the sign of Heitz, LEADR and Chermain. Kaplanyan
//! and Tokuyoshi write $+m_{xy}/m_z$: their point is $-s$.

use crate::error::Error;
use crate::scalar::Real;
use crate::scalar::exact::add_products;

/// Unit half vector of two unit directions, $h = (w_i + w_o) / |w_i + w_o|$.
///
/// Opposite directions have none: the result is then the zero vector, whose density is 0.
///
/// ```
/// let h = lobe::slope::direction::half_vector([0.6_f32, 0.0, 0.8], [-0.6, 0.0, 0.8]);
/// assert_eq!(h, [0.0, 0.0, 1.0]);
/// ```
#[doc(alias = "h")]
#[doc(alias = "lobe_half_vector")]
pub fn half_vector<R: Real>(wo: impl Into<[R; 3]>, wi: impl Into<[R; 3]>) -> [R; 3] {
    let (wo, wi) = (wo.into(), wi.into());
    normalize([wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]])
}

/// `v` at unit length; a vector of length 0, of infinite length or of NaN gives the zero vector.
///
/// ```
/// assert_eq!(lobe::slope::direction::normalize([0.0_f64, 3.0, 4.0]), [0.0, 0.6, 0.8]);
/// ```
#[doc(alias = "lobe_normalize")]
pub fn normalize<R: Real>(v: impl Into<[R; 3]>) -> [R; 3] {
    let v = v.into();
    // Scaled by the largest component, as squares leave the range of f32 beyond 1e19 and 1e-19.
    let largest = v[0].abs().max(v[1].abs()).max(v[2].abs());
    if !(largest >= R::MIN_POSITIVE && largest <= R::MAX) {
        return [R::ZERO; 3];
    }
    let v = v.map(|x| (x / largest).kept());
    // The exact length is at least 1. On GPUs that flush the quotient by a huge `largest` to 0,
    // `max` restores that.
    let length = dot(v, v).sqrt().max(R::ONE);
    v.map(|x| x / length)
}

/// Dot product.
#[inline(always)]
pub(crate) fn dot<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Slope of a normal, $s = (-m_x/m_z, -m_y/m_z)$; `m` need not have unit length.
///
/// At the horizon ($m_z = 0$) the slope is infinite; use directions there.
///
/// ```
/// assert_eq!(lobe::slope::direction::slope_of([0.3_f64, 0.0, 0.6]), [-0.5, 0.0]);
/// ```
#[doc(alias = "lobe_slope_of")]
#[inline(always)]
pub fn slope_of<R: Real>(m: impl Into<[R; 3]>) -> [R; 2] {
    let m = m.into();
    [-m[0] / m[2], -m[1] / m[2]]
}

/// Unit normal of a slope, $m = (-s_x, -s_y, 1) / \sqrt{1 + |s|^2}$.
///
/// ```
/// let m = lobe::slope::direction::normal_of([-0.75_f64, 0.0]);
/// assert!((m[0] - 0.6).abs() < 1e-15 && m[1] == 0.0 && (m[2] - 0.8).abs() < 1e-15);
/// ```
#[doc(alias = "lobe_normal_of")]
pub fn normal_of<R: Real>(slope: impl Into<[R; 2]>) -> [R; 3] {
    let s = slope.into();
    let inverse = R::ONE / (R::ONE + s[0] * s[0] + s[1] * s[1]).sqrt();
    [-s[0] * inverse, -s[1] * inverse, inverse]
}

/// The upward unit vector over a point of the projected disk, $(h_x, h_y, \sqrt{1 - h_x^2 -
/// h_y^2})$.
///
/// The height is computed with compensated products: near the rim `1 - x*x - y*y` has no digits
/// left in f32. Points outside the disk get height 0.
///
/// ```
/// assert_eq!(lobe::slope::direction::from_disk([0.6_f64, 0.0]), [0.6, 0.0, 0.8]);
/// ```
#[doc(alias = "lobe_from_disk")]
pub fn from_disk<R: Real>(point: impl Into<[R; 2]>) -> [R; 3] {
    let [x, y] = point.into();
    [x, y, add_products(R::ONE, -x, x, -y, y).max(R::ZERO).sqrt()]
}

/// Mirror direction of `w` about the unit normal `m`, $2 (w \cdot m) m - w$.
///
/// ```
/// let wi = lobe::slope::direction::reflect([0.6_f32, 0.0, 0.8], [0.0, 0.0, 1.0]);
/// assert_eq!(wi, [-0.6, 0.0, 0.8]);
/// ```
#[doc(alias = "lobe_reflect")]
pub fn reflect<R: Real>(w: impl Into<[R; 3]>, m: impl Into<[R; 3]>) -> [R; 3] {
    let (w, m) = (w.into(), m.into());
    let twice = R::TWO * dot(w, m);
    [twice * m[0] - w[0], twice * m[1] - w[1], twice * m[2] - w[2]]
}

/// A slope whose components are in range.
#[inline]
pub(crate) fn checked_slope<R: Real>(slope: impl Into<[R; 2]>) -> Result<[R; 2], Error> {
    let slope = slope.into();
    match slope.iter().find(|x| !x.is_slope()) {
        Some(&x) => Err(Error::Mean(x.into())),
        None => Ok(slope),
    }
}
