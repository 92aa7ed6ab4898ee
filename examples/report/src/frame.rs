//! Shading frames: right-handed, normal along z, their first axis as near to a given tangent as it
//! gets.

use lobe::slope::direction::normalize;

use crate::scalar::Scalar;
use crate::vector::{Vector, add, along, cast, cross, dot, scaled, tangential};

/// An orthonormal frame around a normal.
pub(crate) struct Frame<R> {
    first: Vector<R>,
    second: Vector<R>,
    normal: Vector<R>,
    /// The tangent it was made of, not yet perpendicular.
    tangent: Vector<R>,
}

/// Changes of a normal and of the tangent that a frame is made of.
#[derive(Clone, Copy)]
pub(crate) struct Turn<R> {
    pub(crate) normal: Vector<R>,
    pub(crate) tangent: Vector<R>,
}

impl<R: Scalar> Frame<R> {
    /// The frame around a unit normal whose first axis is `tangent` made perpendicular and of
    /// length 1.
    ///
    /// Smooth wherever both are: neighboring pixels' half vectors, each in its own frame, then
    /// differ by what the surface does and not by a jump of the frame. A normal along the tangent
    /// has no such frame; its directions come out as zero and shade to black.
    #[inline]
    pub(crate) fn around(normal: Vector<R>, tangent: Vector<R>) -> Self {
        let first = normalize(tangential(tangent, normal));
        Self { first, second: cross(normal, first), normal, tangent }
    }

    /// A world direction in this frame.
    #[inline]
    pub(crate) fn to_local(&self, w: Vector<R>) -> Vector<R> {
        [dot(self.first, w), dot(self.second, w), dot(self.normal, w)]
    }

    /// The axes, the normal last.
    #[inline]
    pub(crate) fn axes(&self) -> [Vector<R>; 3] {
        [self.first, self.second, self.normal]
    }

    /// How far the frame turns about its normal, counter-clockwise, in radians.
    ///
    /// The first axis is $(t - n (n \cdot t))/l$ with $l = |t - n (n \cdot t)|$; of its change only
    /// $(dt - n' (n \cdot t))/l$ has a part along the second axis.
    #[inline]
    pub(crate) fn spin(&self, turn: &Turn<R>) -> R {
        let moved = along(turn.tangent, -dot(self.normal, self.tangent), turn.normal);
        dot(moved, self.second) / dot(self.first, self.tangent)
    }
}

/// Tangents for closed surfaces: the frame at the normal towards the eye, carried to every other
/// normal by the smallest rotation. Smooth on all that the eye can see.
#[derive(Clone)]
pub(crate) struct Comb<R> {
    /// The normal where it starts.
    pub(crate) axis: Vector<R>,
    /// Two axes perpendicular to it, right-handed.
    pub(crate) sides: [Vector<R>; 2],
}

impl Comb<f64> {
    /// Around a unit axis, the first side as near as can be to the world's x axis.
    pub(crate) fn around(axis: Vector<f64>) -> Self {
        let first = normalize(tangential([1.0, 0.0, 0.0], axis));
        Self { axis, sides: [first, cross(axis, first)] }
    }

    /// The same in another precision.
    pub(crate) fn cast<R: Scalar>(&self) -> Comb<R> {
        Comb { axis: cast(self.axis), sides: self.sides.map(cast) }
    }
}

impl<R: Scalar> Comb<R> {
    /// A side carried from the axis $e$ to the unit normal $n$: $a - \frac{a \cdot n}{1 + e \cdot
    /// n} (n + e)$.
    #[inline]
    pub(crate) fn tangent(&self, side: usize, normal: Vector<R>) -> Vector<R> {
        let a = self.sides[side];
        let factor = -dot(a, normal) / (R::ONE + dot(self.axis, normal));
        along(a, factor, add(normal, self.axis))
    }

    /// Its change where the normal changes by `turn`.
    #[inline]
    pub(crate) fn turn(&self, side: usize, normal: Vector<R>, turn: Vector<R>) -> Vector<R> {
        let a = self.sides[side];
        let inverse = R::ONE / (R::ONE + dot(self.axis, normal));
        let factor = -dot(a, normal) * inverse;
        let change = -(dot(a, turn) + factor * dot(self.axis, turn)) * inverse;
        add(scaled(change, add(normal, self.axis)), scaled(factor, turn))
    }
}

#[cfg(test)]
mod tests {
    use super::{Comb, Frame, Turn};
    use crate::vector::{along, dot, sub};
    use lobe::slope::direction::normalize;

    const X: [f64; 3] = [1.0, 0.0, 0.0];

    #[test]
    fn frames_are_orthonormal_and_the_plane_s_own_is_the_world() {
        let flat = Frame::around([0.0_f64, 0.0, 1.0], X);
        assert_eq!(flat.to_local([0.3, 0.4, 0.5]), [0.3, 0.4, 0.5]);
        let frame = Frame::around(normalize([0.3_f64, -0.5, 0.7]), X);
        let w = frame.to_local([0.36, 0.48, 0.8]);
        assert!((dot(w, w) - 1.0).abs() < 1e-14);
        assert!(dot(frame.first, frame.normal).abs() < 1e-15);
        let degenerate = Frame::around(X, X).to_local([0.0, 0.6, 0.8]);
        assert_eq!(degenerate, [0.0; 3]);
    }

    #[test]
    fn combed_tangents_are_unit_and_perpendicular_and_their_turn_is_their_difference() {
        let comb = Comb::around(normalize([0.2, -0.9, 0.3]));
        for k in 0..40 {
            let angle = 0.4 * f64::from(k);
            let n = normalize([angle.sin(), -1.0, (1.7 * angle).cos()]);
            let step = normalize([0.3, angle.cos(), 0.8]);
            let dn = along(step, -dot(step, n), n);
            let nearby = |t: f64| normalize(along(n, t, dn));
            for side in 0..2 {
                let tangent = comb.tangent(side, n);
                assert!((dot(tangent, tangent) - 1.0).abs() < 1e-14);
                assert!(dot(tangent, n).abs() < 1e-14);
                let h = 1e-5;
                let [after, before] = [h, -h].map(|t| comb.tangent(side, nearby(t)));
                let difference = sub(after, before).map(|x| x / (2.0 * h));
                let turn = comb.turn(side, n, dn);
                assert!(sub(turn, difference).iter().all(|x| x.abs() < 1e-8));
            }
            // The spin is the first axis' turn towards the second.
            let at = |t: f64| {
                let n = nearby(t);
                Frame::around(n, along(comb.tangent(0, n), 0.3, X))
            };
            let (here, h) = (at(0.0), 1e-5);
            let difference = sub(at(h).first, at(-h).first).map(|x| x / (2.0 * h));
            let turn = Turn { normal: dn, tangent: comb.turn(0, n, dn) };
            assert!((here.spin(&turn) - dot(difference, here.second)).abs() < 1e-8);
        }
    }
}
