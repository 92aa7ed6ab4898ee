//! Shading frames: right-handed, normal along z, built from one world tangent.

use lobe::slope::direction::normalize;

use crate::scalar::Scalar;

/// An orthonormal frame around a normal.
pub(crate) struct Frame<R> {
    tangent: [R; 3],
    bitangent: [R; 3],
    normal: [R; 3],
}

impl<R: Scalar> Frame<R> {
    /// The frame around a unit normal whose tangent is the world's x axis, made perpendicular.
    ///
    /// Smooth wherever the normal is: neighbouring pixels' half vectors, each in its own frame, then
    /// differ by what the surface does and not by a jump of the frame. A normal along x has no such
    /// frame; its directions come out as zero and shade to black.
    #[inline]
    pub(crate) fn around(normal: [R; 3]) -> Self {
        let [x, y, z] = normal;
        let tangent = normalize([R::ONE - x * x, -(x * y), -(x * z)]);
        Self { tangent, bitangent: cross(normal, tangent), normal }
    }

    /// A world direction in this frame.
    #[inline]
    pub(crate) fn to_local(&self, w: [R; 3]) -> [R; 3] {
        [dot(self.tangent, w), dot(self.bitangent, w), dot(self.normal, w)]
    }
}

#[inline]
fn dot<R: Scalar>(a: [R; 3], b: [R; 3]) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline]
fn cross<R: Scalar>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::{Frame, dot};
    use lobe::slope::direction::normalize;

    #[test]
    fn frames_are_orthonormal_and_the_plane_s_own_is_the_world() {
        let flat = Frame::around([0.0_f64, 0.0, 1.0]);
        assert_eq!(flat.to_local([0.3, 0.4, 0.5]), [0.3, 0.4, 0.5]);
        let frame = Frame::around(normalize([0.3_f64, -0.5, 0.7]));
        let w = frame.to_local([0.36, 0.48, 0.8]);
        assert!((dot(w, w) - 1.0).abs() < 1e-14);
        assert!(dot(frame.tangent, frame.normal).abs() < 1e-15);
        let degenerate = Frame::around([1.0_f64, 0.0, 0.0]).to_local([0.0, 0.6, 0.8]);
        assert_eq!(degenerate, [0.0; 3]);
    }
}
