//! A pinhole camera: rays through the picture, and how they change from pixel to pixel.

use lobe::slope::direction::normalize;
use serde::Serialize;

use crate::scalar::Scalar;
use crate::vector::{Vector, add, along, cast, cross, dot, scaled, sub, turned};

/// A picture's size in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
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

    /// The same with a margin on all four sides.
    pub(crate) fn grown(self, margin: usize) -> Self {
        Self { width: self.width + 2 * margin, height: self.height + 2 * margin }
    }
}

/// The camera: pixel (x, y) covers x to x + 1 and y to y + 1, rows counted from the top.
#[derive(Clone)]
pub(crate) struct Camera<R> {
    eye: Vector<R>,
    /// Ray through the picture's corner (0, 0), and its change per pixel.
    corner: Vector<R>,
    pub(crate) right: Vector<R>,
    pub(crate) down: Vector<R>,
}

/// A ray from the eye; its direction has no particular length.
#[derive(Clone, Copy)]
pub(crate) struct Ray<R> {
    pub(crate) eye: Vector<R>,
    pub(crate) direction: Vector<R>,
}

impl<R: Scalar> Ray<R> {
    /// The point at a multiple of the direction.
    #[inline]
    pub(crate) fn at(&self, t: R) -> Vector<R> {
        along(self.eye, t, self.direction)
    }
}

impl Camera<f64> {
    /// A camera at height 1 over the plane z = 0, looking along +y and down: its picture spans
    /// these angles below the horizon (degrees), top row to bottom row.
    pub(crate) fn spanning(size: Size, top: f64, bottom: f64) -> Self {
        let (sin, cos) = (0.5 * (top + bottom)).to_radians().sin_cos();
        let focal = 0.5 * size.height as f64 / (0.5 * (bottom - top)).to_radians().tan();
        let eye = [0.0, 0.0, 1.0];
        Self::looking(size, eye, [0.0, cos, 1.0 - sin], focal)
    }

    /// A camera that has `target` at the picture's center and the world's z axis upright; `focal`
    /// is the distance, in pixels, at which a pixel is as wide as on the picture.
    pub(crate) fn looking(size: Size, eye: Vector<f64>, target: Vector<f64>, focal: f64) -> Self {
        let forward = normalize(sub(target, eye));
        let across = normalize(cross(forward, [0.0, 0.0, 1.0]));
        let right = scaled(1.0 / focal, across);
        let down = scaled(1.0 / focal, cross(forward, across));
        let corner = along(forward, -0.5 * size.width as f64, right);
        let corner = along(corner, -0.5 * size.height as f64, down);
        Self { eye, corner, right, down }
    }

    /// The same elsewhere.
    pub(crate) fn moved(&self, step: Vector<f64>) -> Self {
        Self { eye: add(self.eye, step), ..self.clone() }
    }

    /// The same, turned about the world's z axis.
    pub(crate) fn turned(&self, angle: f64) -> Self {
        let [eye, corner, right, down] =
            [self.eye, self.corner, self.right, self.down].map(|v| turned(v, angle));
        Self { eye, corner, right, down }
    }

    /// Where on the picture a point in front of the camera is seen.
    #[cfg(test)]
    pub(crate) fn place(&self, point: Vector<f64>) -> [f64; 2] {
        // Three vectors whose mixture is the ray: `forward` is perpendicular to the other two.
        let (ray, forward) = (sub(point, self.eye), cross(self.down, self.right));
        let ray = scaled(dot(self.corner, forward) / dot(ray, forward), ray);
        let offset = sub(ray, self.corner);
        [self.right, self.down].map(|axis| dot(offset, axis) / dot(axis, axis))
    }

    /// The same in another precision.
    pub(crate) fn cast<R: Scalar>(&self) -> Camera<R> {
        Camera {
            eye: cast(self.eye),
            corner: cast(self.corner),
            right: cast(self.right),
            down: cast(self.down),
        }
    }

    /// Steps on a surface to the pixels at the right and above, by ray differentials (Igehy 1999):
    /// of the point at a multiple of a ray's direction, in its tangent plane.
    pub(crate) fn differentials(
        &self,
        ray: &Ray<f64>,
        distance: f64,
        normal: Vector<f64>,
    ) -> [Vector<f64>; 2] {
        let facing = dot(ray.direction, normal);
        [scaled(distance, self.right), scaled(-distance, self.down)]
            .map(|sideways| along(sideways, -dot(sideways, normal) / facing, ray.direction))
    }

    /// Steps on the plane z = 0 to the pixels at the right and above, as lengths.
    pub(crate) fn steps(&self, x: f64, y: f64) -> [f64; 2] {
        let at = |x, y| {
            let ray = self.ray(x, y);
            ray.at(-ray.eye[2] / ray.direction[2])
        };
        let here = at(x, y);
        [at(x + 1.0, y), at(x, y - 1.0)].map(|p| (p[0] - here[0]).hypot(p[1] - here[1]))
    }
}

impl<R: Scalar> Camera<R> {
    /// The ray through the picture's point (x, y).
    #[inline]
    pub(crate) fn ray(&self, x: R, y: R) -> Ray<R> {
        let direction = along(along(self.corner, x, self.right), y, self.down);
        Ray { eye: self.eye, direction }
    }
}

#[cfg(test)]
mod tests {
    use super::{Camera, Size};
    use crate::vector::{dot, sub};

    #[test]
    fn the_picture_spans_the_angles_asked_for() {
        let size = Size::of_width(64);
        assert_eq!(size, Size { width: 64, height: 36 });
        let camera = Camera::spanning(size, 8.0, 28.0);
        for (row, angle) in [(0.0, 8.0_f64), (36.0, 28.0)] {
            let [x, y, z] = camera.ray(32.0, row).direction;
            assert!(x.abs() < 1e-12 && (-z / y - angle.to_radians().tan()).abs() < 1e-12);
        }
    }

    #[test]
    fn a_camera_sees_its_target_at_the_center_and_pixels_at_their_size() {
        let size = Size::of_width(400);
        let (eye, target) = ([100.0_f64, -900.0, 300.0], [-20.0, 50.0, 10.0]);
        let distance = dot(sub(target, eye), sub(target, eye)).sqrt();
        let camera = Camera::looking(size, eye, target, distance);
        let center = camera.ray(200.0, 112.5);
        let hit = center.at(distance);
        let pixel = camera.ray(201.0, 112.5).at(distance);
        for k in 0..3 {
            assert!((hit[k] - target[k]).abs() < 1e-9);
        }
        let step = sub(pixel, hit);
        assert!((dot(step, step).sqrt() - 1.0).abs() < 1e-9 && step[2].abs() < 1e-12);
        assert!(camera.down[2] < 0.0);
    }
}
