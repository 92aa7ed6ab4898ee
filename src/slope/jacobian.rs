//! Jacobians between the sphere, the projected disk and the slope plane.
//!
//! Layer 1. Matrices are `[[m_11, m_12], [m_21, m_22]]`, rows first: entry `m[i][j]` is the
//! derivative of output `i` with respect to input `j`. On the sphere, the two inputs are angles on
//! great circles through `h`: the first through the normal (increasing away from it), the second
//! across. At `h = n` that frame is undefined; the limit along +x is used.

use crate::scalar::Real;

/// A 2x2 matrix, rows first.
pub type Matrix<R> = [[R; 2]; 2];

/// `h_x` and `h_y` over their length: the azimuth's cosine and sine; (1, 0) at the normal.
fn azimuth<R: Real>(h: [R; 3]) -> (R, R) {
    let length = (h[0] * h[0] + h[1] * h[1]).sqrt();
    if length > R::ZERO { (h[0] / length, h[1] / length) } else { (R::ONE, R::ZERO) }
}

/// Derivative of the slope of `h` by the two great-circle angles.
///
/// $J = -\frac{1}{h_z^2 S} \begin{pmatrix} h_x & -h_y h_z \\\\ h_y & h_x h_z \end{pmatrix}$,
/// $S = \sqrt{h_x^2 + h_y^2}$, $\det J = 1/h_z^3$: errors on the sphere grow without bound in slope
/// space as `h` nears the horizon. `h`: unit, `h_z > 0`.
///
/// Source: Tokuyoshi 2017, Eq. 5 and 26 (his `sqrt(1 - h_z^2)` is our `S`, which does not cancel).
///
/// ```
/// let j = lobe::slope::jacobian::sphere_to_slope([0.6_f64, 0.0, 0.8]);
/// let det = j[0][0] * j[1][1] - j[0][1] * j[1][0];
/// assert!((det - 0.8_f64.powi(-3)).abs() < 1e-12);
/// ```
#[doc(alias = "lobe_sphere_to_slope")]
pub fn sphere_to_slope<R: Real>(h: impl Into<[R; 3]>) -> Matrix<R> {
    let h = h.into();
    let (cos, sin) = azimuth(h);
    let z = h[2];
    [[-cos / (z * z), sin / z], [-sin / (z * z), -cos / z]]
}

/// Derivative of $(h_x, h_y)$ by the two great-circle angles.
///
/// $J = \frac{1}{S} \begin{pmatrix} h_x h_z & -h_y \\\\ h_y h_z & h_x \end{pmatrix}$,
/// $\det J = h_z$: the projection shrinks errors near the horizon.
///
/// Source: Tokuyoshi 2017, Eq. 8.
///
/// ```
/// let j = lobe::slope::jacobian::sphere_to_disk([0.6_f64, 0.0, 0.8]);
/// assert_eq!(j, [[0.8, -0.0], [0.0, 1.0]]);
/// ```
#[doc(alias = "lobe_sphere_to_disk")]
pub fn sphere_to_disk<R: Real>(h: impl Into<[R; 3]>) -> Matrix<R> {
    let h = h.into();
    let (cos, sin) = azimuth(h);
    let z = h[2];
    [[cos * z, -sin], [sin * z, cos]]
}

/// Derivative of the slope of `h` by $(h_x, h_y)$.
///
/// $J = -\frac{1}{h_z^3} \begin{pmatrix} 1 - h_y^2 & h_x h_y \\\\ h_x h_y & 1 - h_x^2
/// \end{pmatrix}$, $\det J = 1/h_z^4$. The diagonal is computed as $h_z^2 + h_x^2$ and $h_z^2 +
/// h_y^2$.
///
/// Source: Tokuyoshi 2017, Eq. 25.
///
/// ```
/// let j = lobe::slope::jacobian::disk_to_slope([0.0_f64, 0.0, 1.0]);
/// assert_eq!(j, [[-1.0, -0.0], [-0.0, -1.0]]);
/// ```
#[doc(alias = "lobe_disk_to_slope")]
pub fn disk_to_slope<R: Real>(h: impl Into<[R; 3]>) -> Matrix<R> {
    let [x, y, z] = h.into();
    let inverse_cube = R::ONE / (z * z * z);
    let mixed = -inverse_cube * x * y;
    [[-inverse_cube * (z * z + x * x), mixed], [mixed, -inverse_cube * (z * z + y * y)]]
}

/// $|ds/dm| = 1/m_z^3$: slope area per solid angle of normals.
///
/// Source: LEADR (Dupuy et al. 2013), supplement Eq. 1.
///
/// ```
/// assert_eq!(lobe::slope::jacobian::slope_per_normal([0.0_f32, 0.0, 1.0]), 1.0);
/// ```
#[doc(alias = "lobe_slope_per_normal")]
pub fn slope_per_normal<R: Real>(m: impl Into<[R; 3]>) -> R {
    let m = m.into();
    R::ONE / (m[2] * m[2] * m[2])
}

/// $|dw_i/dw_m| = 4 |w_m \cdot w_o|$: solid angle of reflected directions per solid angle of
/// normals.
///
/// Source: LEADR supplement Eq. 3 (its derivation has a slip in $dw_i/d\theta$; the result is
/// right).
///
/// ```
/// let n = [0.0_f32, 0.0, 1.0];
/// assert_eq!(lobe::slope::jacobian::reflection_per_normal(n, n), 4.0);
/// ```
#[doc(alias = "lobe_reflection_per_normal")]
pub fn reflection_per_normal<R: Real>(wm: impl Into<[R; 3]>, wo: impl Into<[R; 3]>) -> R {
    R::lit(4.0) * super::direction::dot(wm.into(), wo.into()).abs()
}

/// The matrix times the vector.
///
/// ```
/// let m = [[1.0_f32, 2.0], [3.0, 4.0]];
/// assert_eq!(lobe::slope::jacobian::apply(m, [1.0, 1.0]), [3.0, 7.0]);
/// ```
#[doc(alias = "lobe_jacobian_apply")]
pub fn apply<R: Real>(m: Matrix<R>, v: impl Into<[R; 2]>) -> [R; 2] {
    let v = v.into();
    [m[0][0] * v[0] + m[0][1] * v[1], m[1][0] * v[0] + m[1][1] * v[1]]
}
