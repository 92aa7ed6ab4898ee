//! A pixel's place on a surface.
//!
//! Floor 4.

use crate::scalar::Real;
use crate::scalar::exact::cross;

/// A pixel's place on a surface: texture coordinates, and how they change to the pixel on the right and above.
///
/// ```
/// use lobe::material::glint::Patch;
/// let patch = Patch::new([0.25_f32, 0.5], [1e-3, 0.0], [0.0, 4e-3]);
/// assert_eq!(patch.extents(), [1e-3, 4e-3]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Patch<R> {
    /// Texture coordinates of the pixel's centre.
    pub uv: [R; 2],
    /// Their change to the next pixel on the right.
    pub right: [R; 2],
    /// Their change to the next pixel above.
    pub up: [R; 2],
}

impl<R: Real> Patch<R> {
    /// From coordinates and derivatives.
    ///
    /// WGSL: none, `LobePatch(uv, right, up)` there.
    pub fn new(uv: impl Into<[R; 2]>, right: impl Into<[R; 2]>, up: impl Into<[R; 2]>) -> Self {
        Self { uv: uv.into(), right: right.into(), up: up.into() }
    }

    /// Sides of the box around the middles of the parallelogram's edges, $\max(|d_x|, |d_y|)$ per axis.
    ///
    /// WGSL: `lobe_patch_extents`.
    #[inline]
    pub fn extents(&self) -> [R; 2] {
        // `max` drops a NaN on its left: here both.
        [0, 1].map(|k| self.right[k].abs().max(self.up[k].abs().max(R::ZERO)))
    }

    /// Area of the parallelogram.
    ///
    /// WGSL: `lobe_patch_area`.
    #[inline]
    pub fn area(&self) -> R {
        cross(self.right, self.up).abs()
    }

    /// The smaller singular value of the derivatives: of a rectangle its shorter side, however it is turned.
    ///
    /// ```
    /// use lobe::material::glint::Patch;
    /// let square = Patch::new([0.0_f64; 2], [0.6, 0.8], [-0.8, 0.6]);
    /// assert!((square.width() - 1.0).abs() < 1e-15);
    /// ```
    ///
    /// WGSL: `lobe_patch_width`.
    #[inline]
    pub fn width(&self) -> R {
        let [a, b] = self.extents();
        let long = a.max(b).max(R::MIN_POSITIVE);
        // In units of the extent, for squares of small derivatives have no digits.
        let [p, q] = [self.right, self.up].map(|d| d.map(|x| (x / long).kept()));
        // The larger singular value without a difference of trace and determinant, which has half the digits of a square.
        let length = |x: R, y: R| (x * x + y * y).sqrt();
        let twice = length(p[0] + q[1], p[1] - q[0]) + length(p[0] - q[1], p[1] + q[0]);
        // A pixel without extent has no sum to divide by.
        long * (R::TWO * cross(p, q).abs() / twice.max(R::MIN_POSITIVE))
    }

    /// The same surface with its coordinates scaled.
    #[inline]
    pub(super) fn stretched(&self, factors: [R; 2]) -> Self {
        let scaled = |v: [R; 2]| [v[0] * factors[0], v[1] * factors[1]];
        Self { uv: scaled(self.uv), right: scaled(self.right), up: scaled(self.up) }
    }
}
