//! The frame along a footprint's longer side, with its corners: for what is neither small, narrow
//! nor around the lobe.
//!
//! Layer 3.

use super::strip::{Whitened, dot, nearness};
use crate::scalar::Real;
use crate::scalar::exact::{cross, difference_of_products, two_sum};
use crate::slope::{Footprint, Isotropic, Whiten};

/// A parallelogram in the frame (t, n) of its longer side: sides (length, 0) and (shear, height),
/// with `0 <= shear <= length` and `height >= 0`; and its corners.
#[derive(Clone, Copy)]
pub(super) struct Frame<R> {
    pub(super) length: R,
    pub(super) shear: R,
    pub(super) height: R,
    /// `length - shear`, not negative: how far the parallelogram goes on unsheared.
    pub(super) square: R,
    /// Length of the shorter side.
    pub(super) side: R,
    /// n of the center.
    pub(super) n: R,
    /// t of the lower corners, left and right, and of the upper ones.
    pub(super) low: [R; 2],
    pub(super) high: [R; 2],
    /// n of the lower and of the upper side.
    pub(super) low_n: R,
    pub(super) high_n: R,
    /// Signed distance of the lobe's center from the left and the right side, positive within.
    pub(super) within_left: R,
    pub(super) within_right: R,
    /// One plus the squared distance from the lobe's center to the bounding rectangle of this
    /// frame.
    pub(super) nearness: R,
}

impl<R: Real> Frame<R> {
    /// From the whitened footprint, for what is not long against its distance.
    #[inline(never)]
    pub(super) fn plain(w: &Whitened<R>) -> Self {
        let footprint = Footprint { u: w.u, v: w.v };
        Self::new::<_, false>(w, &Isotropic::unit(), w.midpoint, [R::ZERO; 2], &footprint)
    }

    /// From slope space, with every corner as exact as if it were the center.
    ///
    /// Corners are summed in slope space with their errors, then whitened. Cross products survive
    /// whitening up to the determinant, and in slope space their cancellation is compensated: a
    /// footprint of a thousand lobes by a thousandth has its height and its distances in all
    /// digits.
    #[inline(never)]
    pub(super) fn exact<S: Whiten<Scalar = R>>(
        w: &Whitened<R>,
        shape: &S,
        offset: [R; 2],
        offset_low: [R; 2],
        footprint: &Footprint<R>,
    ) -> Self {
        Self::new::<S, true>(w, shape, offset, offset_low, footprint)
    }

    #[inline(always)]
    fn new<S: Whiten<Scalar = R>, const EXACT: bool>(
        w: &Whitened<R>,
        shape: &S,
        offset: [R; 2],
        offset_low: [R; 2],
        footprint: &Footprint<R>,
    ) -> Self {
        let (zero, half) = (R::ZERO, R::HALF);
        // Sides that nearly agree are compared by their difference: rounded lengths may tell the
        // wrong one.
        let swap = if EXACT {
            let (u, v) = (footprint.u, footprint.v);
            let white = |w: [R; 2]| shape.whiten(w, [zero; 2]);
            dot(white([u[0] + v[0], u[1] + v[1]]), white([v[0] - u[0], v[1] - u[1]])) > zero
        } else {
            w.is_swapped()
        };
        let (a, b) = if swap { (footprint.v, footprint.u) } else { (footprint.u, footprint.v) };
        let (a_white, b_white) = if swap { (w.v, w.u) } else { (w.u, w.v) };
        let length = dot(a_white, a_white).sqrt();
        let inverse_length = R::ONE / length;
        let axis = a_white.map(|x| x * inverse_length);
        // b turned to lie left of a; a turned, as a mirror image of all, so that b leans forward.
        let (turn, lean) = (cross(a, b), dot(axis, b_white));
        let left = if turn < zero { -R::ONE } else { R::ONE };
        let mirror = if left * lean < zero { -R::ONE } else { R::ONE };
        let (forward, back) = ([mirror * a[0], mirror * a[1]], [left * b[0], left * b[1]]);

        // Corners in slope space, low left, low right, high right, high left, with their errors.
        let corners = |k: usize| {
            let (along, across) = (half * forward[k], half * back[k]);
            let (along, across) =
                ([-along, along, along, -along], [-across, -across, across, across]);
            let (mut high, mut low) = ([zero; 4], [zero; 4]);
            for n in 0..4 {
                if EXACT {
                    let (sum, first) = two_sum(offset[k], along[n]);
                    let (sum, second) = two_sum(sum, across[n]);
                    // Summed once more: where a and b cancel, the errors are the answer.
                    (high[n], low[n]) = two_sum(sum, first + second + offset_low[k]);
                } else {
                    high[n] = offset[k] + along[n] + across[n];
                }
            }
            (high, low)
        };
        let ((x, x_low), (y, y_low)) = (corners(0), corners(1));
        let mut t = [zero; 4];
        for n in 0..4 {
            let white = shape.whiten([x[n], y[n]], [x_low[n], y_low[n]]);
            t[n] = mirror * (axis[0] * white[0] + axis[1] * white[1]);
        }
        // Sides below, right, above and left, each from the corner it starts or ends in.
        let side_x = [a[0], back[0], a[0], back[0]];
        let side_y = [a[1], back[1], a[1], back[1]];
        let mut apart = [zero; 4];
        for n in 0..4 {
            apart[n] = if EXACT {
                let low = side_x[n] * y_low[n] - side_y[n] * x_low[n];
                difference_of_products(side_x[n], y[n], side_y[n], x[n]) + low
            } else {
                side_x[n] * y[n] - side_y[n] * x[n]
            };
        }
        let inverse = R::ONE / shape.root_det();
        let (shear, height) = (lean.abs(), turn.abs() * inverse * inverse_length);
        let side = (shear * shear + height * height).sqrt();
        let across = inverse * mirror / side.max(R::MIN_POSITIVE);
        let along = inverse * inverse_length;
        // Sides that nearly agree are subtracted where that is exact.
        let rest = [forward[0] - back[0], forward[1] - back[1]];
        let square = mirror * dot(axis, shape.whiten(rest, [zero; 2]));
        let (low_n, high_n) = (apart[0] * along, apart[2] * along);
        let n = half * (low_n + high_n);
        Self {
            length,
            shear,
            height,
            square: square.max(zero),
            side,
            n,
            low: [t[0], t[1]],
            high: [t[3], t[2]],
            low_n,
            high_n,
            within_left: apart[3] * across,
            within_right: -apart[1] * across,
            nearness: nearness([t[0], t[2]], [low_n, high_n]),
        }
    }
}
