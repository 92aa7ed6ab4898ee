//! The camera: from pixels to rays, and from a ray's point to those of the next pixels.

use glam::DVec3;

/// A pinhole over a picture of pixels, its rows counted from the top.
#[derive(Clone, Copy)]
pub(crate) struct Camera {
    pub(crate) eye: DVec3,
    forward: DVec3,
    /// To the next pixel on the right and above, at distance 1 along `forward`.
    right: DVec3,
    up: DVec3,
    size: [f64; 2],
}

/// A half line; its direction has unit length.
#[derive(Clone, Copy)]
pub(crate) struct Ray {
    pub(crate) origin: DVec3,
    pub(crate) direction: DVec3,
}

/// What a picture shows: from where, of what, and how much of it.
#[derive(Clone, Copy)]
pub(crate) struct View {
    pub(crate) eye: DVec3,
    pub(crate) target: DVec3,
    /// Tangent of half the height of a picture of 16 to 9; of another one, the part in its middle.
    pub(crate) half_height: f64,
}

/// Cosines below this count as this: a ray along the surface has no next point.
const GRAZING: f64 = 1e-6;

impl Camera {
    /// Of a view, for a picture of this size; z is up.
    pub(crate) fn new(view: &View, size: [usize; 2]) -> Self {
        let forward = (view.target - view.eye).normalize();
        let right = forward.cross(DVec3::Z).normalize();
        let size = size.map(|n| n as f64);
        // All of what 16 to 9 show, whatever the picture's shape.
        let pixel = 2.0 * view.half_height / size[1].min(size[0] * 9.0 / 16.0);
        let up = right.cross(forward);
        Self { eye: view.eye, forward, right: pixel * right, up: pixel * up, size }
    }

    /// The ray through a place of the picture: whole numbers are corners of pixels.
    pub(crate) fn ray(&self, [x, y]: [f64; 2]) -> Ray {
        let (x, y) = (x - 0.5 * self.size[0], 0.5 * self.size[1] - y);
        let direction = (self.forward + x * self.right + y * self.up).normalize();
        Ray { origin: self.eye, direction }
    }

    /// How a point of a surface moves to the next pixel on the right and above, along its tangent
    /// plane.
    ///
    /// Derivatives, not differences: near a silhouette the next pixel's ray leaves the surface.
    /// Igehy 1999, Eq. 10.
    pub(crate) fn steps(&self, point: DVec3, normal: DVec3) -> [DVec3; 2] {
        let depth = (point - self.eye).dot(self.forward);
        // At distance 1 along `forward`, where `right` and `up` are.
        let direction = (point - self.eye) / depth;
        let cosine = direction.dot(normal);
        let cosine = cosine.signum() * cosine.abs().max(GRAZING);
        [self.right, self.up].map(|step| depth * (step - direction * (step.dot(normal) / cosine)))
    }
}
