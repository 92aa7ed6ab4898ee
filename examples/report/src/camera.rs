//! A pinhole camera one unit above the plane z = 0, looking along +y and down.

use lobe::slope::direction::normalize;

use crate::scalar::Scalar;

/// A picture's size in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Size {
    pub(crate) width: usize,
    pub(crate) height: usize,
}

impl Size {
    /// 16 by 9.
    pub(crate) fn of_width(width: usize) -> Self {
        Self { width, height: (width * 9 / 16).max(1) }
    }

    /// Number of pixels.
    pub(crate) fn pixels(self) -> usize {
        self.width * self.height
    }
}

/// The camera: pixel (x, y) covers x to x + 1 and y to y + 1, rows counted from the top.
#[derive(Clone)]
pub(crate) struct Camera<R> {
    /// Ray through the picture's corner (0, 0), and its change per pixel.
    corner: [R; 3],
    right: [R; 3],
    down: [R; 3],
}

/// Height of the eye over the plane: the unit of length.
const EYE: f64 = 1.0;

impl Camera<f64> {
    /// A camera whose picture spans these angles below the horizon (degrees), top row to bottom row.
    pub(crate) fn spanning(size: Size, top: f64, bottom: f64) -> Self {
        let (sin, cos) = (0.5 * (top + bottom)).to_radians().sin_cos();
        let (width, height) = (size.width as f64, size.height as f64);
        let pixel = 2.0 * (0.5 * (bottom - top)).to_radians().tan() / height;
        let right = [pixel, 0.0, 0.0];
        let down = [0.0, -sin * pixel, -cos * pixel];
        let (x, y) = (0.5 * width, 0.5 * height);
        let corner = [-x * right[0], cos - y * down[1], -sin - y * down[2]];
        Self { corner, right, down }
    }

    /// The same in another precision.
    pub(crate) fn cast<R: Scalar>(&self) -> Camera<R> {
        let cast = |v: [f64; 3]| v.map(R::lit);
        Camera { corner: cast(self.corner), right: cast(self.right), down: cast(self.down) }
    }

    /// Steps on the plane to the pixels at the right and above, as lengths.
    pub(crate) fn steps(&self, x: f64, y: f64) -> [f64; 2] {
        let at = |x, y| self.hit(x, y).0;
        let here = at(x, y);
        [at(x + 1.0, y), at(x, y - 1.0)].map(|p| (p[0] - here[0]).hypot(p[1] - here[1]))
    }
}

impl<R: Scalar> Camera<R> {
    /// The point of the plane behind the picture's point (x, y), and the unit direction to the eye.
    #[inline]
    pub(crate) fn hit(&self, x: R, y: R) -> ([R; 2], [R; 3]) {
        let along = |k: usize| self.corner[k] + x * self.right[k] + y * self.down[k];
        let ray = [along(0), along(1), along(2)];
        let distance = R::lit(EYE) / -ray[2];
        let wo = normalize(ray.map(|c| -c));
        ([ray[0] * distance, ray[1] * distance], wo)
    }
}

#[cfg(test)]
mod tests {
    use super::{Camera, Size};

    #[test]
    fn the_picture_spans_the_angles_asked_for() {
        let size = Size::of_width(64);
        assert_eq!(size, Size { width: 64, height: 36 });
        let camera = Camera::spanning(size, 8.0, 28.0);
        for (row, angle) in [(0.0, 8.0_f64), (36.0, 28.0)] {
            let (point, wo) = camera.hit(32.0, row);
            assert!((wo[2] - angle.to_radians().sin()).abs() < 1e-12);
            assert!((point[1] - 1.0 / angle.to_radians().tan()).abs() < 1e-12);
            assert!(point[0].abs() < 1e-12);
        }
    }
}
