//! What a ray tracer knows of a pixel of a smooth surface: Kaplanyan's matrix M is made of it.

use super::surface::{Shape, on_shape};
use super::{Scene, step};
use crate::frame::Frame;
use crate::scalar::Scalar;
use crate::vector::sub;

/// Position, curvature and pixel steps at a pixel's center, in its shading frame; zeros without a
/// surface.
///
/// For surfaces that are shaded with their own normal.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Traced<R> {
    /// The eye, from the shaded point.
    pub eye: [R; 3],
    /// The shape operator $b_{11}, b_{12}, b_{22}$, as of [`lobe::Path`].
    pub curvature: [R; 3],
    /// Steps on the tangent plane to the pixel at the right and to the one below.
    pub steps: [[R; 2]; 2],
    /// How far the frame turns about its normal along each: [`lobe::slope::Motion`]'s spin.
    pub spins: [R; 2],
}

impl<R: Scalar> Scene<R> {
    /// At the picture's point (x, y).
    pub(crate) fn traced(&self, x: R, y: R) -> Traced<R> {
        on_shape!(&self.surface, shape => self.traced_on(shape, x, y))
    }

    fn traced_on(&self, shape: &impl Shape<R>, x: R, y: R) -> Traced<R> {
        let ray = self.camera.ray(x, y);
        let Some(hit) = shape.hit(&ray) else { return Traced::default() };
        let frame = Frame::around(hit.normal, hit.tangent);
        let [first, second, _] = frame.axes();
        let [along, across] =
            [first, second].map(|axis| frame.to_local(shape.turn(&hit, axis).normal));
        let steps = [self.camera.right, self.camera.down].map(|change| step(&ray, change, &hit));
        Traced {
            eye: frame.to_local(sub(ray.eye, hit.point)),
            curvature: [along[0], across[0], across[1]],
            steps: steps.map(|step| {
                let [first, second, _] = frame.to_local(step);
                [first, second]
            }),
            spins: steps.map(|step| frame.spin(&shape.turn(&hit, step))),
        }
    }
}
