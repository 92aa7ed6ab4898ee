//! A whitened footprint, and the strip along its longer side.
//!
//! Layer 3. The common case of a thin footprint: its shorter side is short against its distance
//! from the lobe, so that fibers along the longer one change smoothly across.

use super::segment::{near_mean, uniform_mean};
use crate::scalar::Real;
use crate::scalar::exact::{cross, two_sum};
use crate::scalar::quadrature::{GAUSS_EIGHT, GAUSS_FOUR, Rule};
use crate::slope::{Footprint, Whiten};

/// Length in distances up to which whitened coordinates keep five digits in f32.
const LONG: f64 = 32.0;

/// Center and sides in units of the lobe.
#[derive(Clone, Copy)]
pub(super) struct Whitened<R> {
    pub(super) midpoint: [R; 2],
    pub(super) u: [R; 2],
    pub(super) v: [R; 2],
}

#[inline(always)]
pub(super) fn dot<R: Real>(a: [R; 2], b: [R; 2]) -> R {
    a[0] * b[0] + a[1] * b[1]
}

impl<R: Real> Whitened<R> {
    #[inline(always)]
    pub(super) fn new<S: Whiten<Scalar = R>>(
        shape: &S,
        offset: [R; 2],
        low: [R; 2],
        footprint: &Footprint<R>,
    ) -> Self {
        let zero = [R::ZERO; 2];
        Self {
            midpoint: shape.whiten(offset, low),
            u: shape.whiten(footprint.u, zero),
            v: shape.whiten(footprint.v, zero),
        }
    }

    #[inline(always)]
    pub(super) fn midpoint_squared(&self) -> R {
        dot(self.midpoint, self.midpoint)
    }

    #[inline(always)]
    pub(super) fn longer_side_squared(&self) -> R {
        dot(self.u, self.u).max(dot(self.v, self.v))
    }

    /// True if `v` is the longer side.
    #[inline(always)]
    pub(super) fn is_swapped(&self) -> bool {
        dot(self.v, self.v) > dot(self.u, self.u)
    }
}

/// A parallelogram in the frame (t, n) along and across its longer side: that side's ends on the
/// middle line, and the shorter side (lean, rise).
#[derive(Clone, Copy)]
pub(super) struct Strip<R> {
    start: R,
    end: R,
    n: R,
    axis: [R; 2],
    length: R,
    lean: R,
    rise: R,
    /// One plus the squared distance from the lobe's center to the bounding rectangle of this
    /// frame.
    nearness: R,
}

/// One plus the squared distance of the origin from the rectangle with these ends along and across.
#[inline(always)]
pub(super) fn nearness<R: Real>(along: [R; 2], across: [R; 2]) -> R {
    let t = along[0].max(-along[1]).max(R::ZERO);
    let n = across[0].max(-across[1]).max(R::ZERO);
    R::ONE + t * t + n * n
}

impl<R: Real> Strip<R> {
    /// The longer side is not 0.
    #[inline(always)]
    pub(super) fn new(w: &Whitened<R>) -> Self {
        let swap = w.is_swapped();
        let pick = |k: usize| if swap { (w.v[k], w.u[k]) } else { (w.u[k], w.v[k]) };
        let ((ax, bx), (ay, by)) = (pick(0), pick(1));
        let length = dot([ax, ay], [ax, ay]).sqrt();
        let inverse = R::ONE / length;
        let (axis, turned) = ([ax * inverse, ay * inverse], [-ay * inverse, ax * inverse]);
        let half = R::HALF;
        let [x, y] = w.midpoint;
        // Ends as points: one near the lobe has more digits than center and length together.
        let (first, last) = ([x - half * ax, y - half * ay], [x + half * ax, y + half * ay]);
        let (start, end) = (dot(axis, first), dot(axis, last));
        let closer = if start.abs() < end.abs() { first } else { last };
        let n = dot(turned, if start * end < R::ZERO { w.midpoint } else { closer });
        let (lean, rise) = (dot(axis, [bx, by]), dot(turned, [bx, by]));
        let strip = Self { start, end, n, axis, length, lean, rise, nearness: R::ONE };
        strip.placed()
    }

    /// With the nearness that follows from the rest.
    #[inline(always)]
    fn placed(self) -> Self {
        let (slide, climb) = (R::HALF * self.lean.abs(), R::HALF * self.rise.abs());
        let along = [self.start - slide, self.end + slide];
        Self { nearness: nearness(along, [self.n - climb, self.n + climb]), ..self }
    }

    /// Mean of the unit density over a long narrow strip, from ends and distance as exact as if
    /// each were the center; none if that shows that the strip is not narrow.
    ///
    /// See [`Frame::exact`](super::frame::Frame::exact).
    #[inline(never)]
    pub(super) fn sharpened_mean<S: Whiten<Scalar = R>>(
        mut self,
        w: &Whitened<R>,
        shape: &S,
        (offset, offset_low): ([R; 2], [R; 2]),
        footprint: &Footprint<R>,
    ) -> Option<R> {
        let a = if w.is_swapped() { footprint.v } else { footprint.u };
        let end = |half: R| {
            let sum = |k: usize| {
                let (sum, error) = two_sum(offset[k], half * a[k]);
                two_sum(sum, error + offset_low[k])
            };
            let ((x, x_low), (y, y_low)) = (sum(0), sum(1));
            dot(self.axis, shape.whiten([x, y], [x_low, y_low]))
        };
        (self.start, self.end) = (end(-R::HALF), end(R::HALF));
        let low = a[0] * offset_low[1] - a[1] * offset_low[0];
        self.n = (cross(a, offset) + low) / (shape.root_det() * self.length);
        let strip = self.placed();
        strip.is_narrow().then(|| strip.mean())
    }

    /// True if no corner can lie much nearer to the lobe than the strip is long, so that the
    /// rounding of center and sides, which all corners inherit, does not show.
    #[inline(always)]
    pub(super) fn keeps_digits(&self) -> bool {
        self.length * self.length <= R::lit(LONG * LONG) * self.nearness
    }

    /// True if the shorter side is at most half the distance of the nearest pole.
    #[inline(always)]
    pub(super) fn is_narrow(&self) -> bool {
        self.lean * self.lean + self.rise * self.rise <= R::lit(0.5 * 0.5) * self.nearness
    }

    /// Mean of the unit density over a narrow strip.
    #[inline(always)]
    pub(super) fn mean(&self) -> R {
        if R::SINGLE { self.mean_by(&GAUSS_FOUR) } else { self.mean_by(&GAUSS_EIGHT) }
    }

    #[inline(always)]
    fn mean_by<const N: usize>(&self, rule: &Rule<N>) -> R {
        // Within three units; the product of four lengths must stay in range.
        if self.nearness <= R::lit(9.0) && self.length <= R::lit(1e6) {
            self.mean_of(rule, near_mean)
        } else {
            self.mean_of(rule, uniform_mean)
        }
    }

    #[inline(always)]
    fn mean_of<const N: usize>(&self, rule: &Rule<N>, fiber: impl Fn(R, R, R, R) -> R) -> R {
        rule.mean(|y| {
            let slide = y * self.lean;
            fiber(self.n + y * self.rise, self.start + slide, self.end + slide, self.length)
        })
    }
}
