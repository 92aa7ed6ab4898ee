//! Lengths on closed surfaces, as texture coordinates.

use crate::frame::Comb;
use crate::scalar::Scalar;
use crate::vector::{Vector, dot};

/// Where a ray meets a surface that has coordinates.
#[derive(Clone, Copy)]
pub(crate) struct Charted<R> {
    pub(crate) point: Vector<R>,
    /// Unit normal.
    pub(crate) normal: Vector<R>,
    /// What the shading frame's first axis is made of.
    pub(crate) tangent: Vector<R>,
    /// Two lengths along the surface.
    pub(crate) uv: [R; 2],
    /// How they change with the point.
    pub(crate) gradients: [Vector<R>; 2],
}

/// Lambert's equal-area projection of a ball, from the point at the axis of a comb.
#[derive(Clone)]
pub(crate) struct Lambert<R> {
    pub(crate) comb: Comb<R>,
    /// Units of the chart per radius.
    pub(crate) density: R,
}

impl Lambert<f64> {
    /// The same in another precision.
    pub(crate) fn cast<R: Scalar>(&self) -> Lambert<R> {
        Lambert { comb: self.comb.cast(), density: R::lit(self.density) }
    }
}

impl<R: Scalar> Lambert<R> {
    /// Coordinates of a point, by its normal: $\sqrt{2/(1 + n \cdot e)}\,(n \cdot a, n \cdot b)$.
    #[inline]
    pub(crate) fn at(&self, normal: Vector<R>) -> [R; 2] {
        let factor = self.density * self.stretch(normal);
        self.comb.sides.map(|side| factor * dot(normal, side))
    }

    #[inline]
    fn stretch(&self, normal: Vector<R>) -> R {
        (R::TWO / (R::ONE + dot(normal, self.comb.axis))).sqrt()
    }

    /// Change of the coordinates where the normal changes by `turn`.
    #[inline]
    pub(crate) fn change(&self, normal: Vector<R>, turn: Vector<R>) -> [R; 2] {
        let stretch = self.stretch(normal);
        let relative =
            -R::HALF * dot(turn, self.comb.axis) / (R::ONE + dot(normal, self.comb.axis));
        let change = |side: Vector<R>| {
            self.density * stretch * (dot(turn, side) + relative * dot(normal, side))
        };
        self.comb.sides.map(change)
    }
}
