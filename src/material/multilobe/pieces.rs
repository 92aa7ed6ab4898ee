//! A kernel in pieces, so short that two boxes along any axes are a fair stand-in for each.
//!
//! Layer 4.

use crate::scalar::{Psd, Real};

/// Longest piece, in deviations of the lobe, or the kernel's width where that is more.
///
/// Two boxes with a long box's variances along axes at 45 degrees to it make a square: in the mean
/// over turns a quarter of its elongation goes across. Of a piece as long as this that is 4.7 % of
/// the lobe's own variance at most.
const LONGEST: f64 = 1.5;

/// How far from the middle a piece's center may be to meet a table, turned by anything: half its
/// diagonal, $4 \sqrt 2$, and that of a piece.
const REACH: f64 = 5.657;
const HALF_DIAGONAL: f64 = 0.7072;

/// Bound of the loop over pieces: ten of them meet a table at most, by the two numbers above.
const MOST: i32 = 12;

/// A kernel in deviations: a rectangle of its covariance, cut along its long side, the middle piece
/// around the middle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pieces<R> {
    /// Of the long side.
    axis: [R; 2],
    /// Sides of the rectangle along and across it, and the longest piece.
    along: R,
    across: R,
    longest: R,
    /// The pieces that may meet a table.
    pub(super) first: i32,
    pub(super) last: i32,
}

/// One of them.
#[derive(Clone, Copy, Debug)]
pub(super) struct Piece<R> {
    /// From the rectangle's middle.
    pub(super) offset: [R; 2],
    /// Of the whole.
    pub(super) share: R,
    /// The square of its side across the axis, and by how much that along it is more.
    square: R,
    more: R,
    axis: [R; 2],
}

impl<R: Real> Pieces<R> {
    /// Of a kernel's covariance, around the middle.
    #[inline]
    pub(super) fn of(kernel: &Psd<R>) -> Self {
        let eigen = kernel.eigen();
        let side = |variance: R| (R::lit(12.0) * variance).sqrt();
        let (along, across) = (side(eigen.major), side(eigen.minor));
        let longest = across.max(R::lit(LONGEST));
        // The last one begins before the end. A kernel no longer than a piece is one, and has none
        // beside it.
        let last = if along > longest { (R::HALF * along / longest + R::HALF).floor() } else { 0 };
        Self { axis: eigen.axis, along, across, longest, first: -last, last }
    }

    /// The same one of two opposite points, whichever is given: their densities are equal, but sums
    /// over pieces, in order, would round differently.
    #[inline]
    pub(super) fn folded(&self, [x, y]: [R; 2]) -> [R; 2] {
        let along = self.axis[0] * x + self.axis[1] * y;
        let across = self.axis[0] * y - self.axis[1] * x;
        if along < R::ZERO || (along == R::ZERO && across < R::ZERO) { [-x, -y] } else { [x, y] }
    }

    /// Around a point: the pieces near enough to the tables.
    #[inline]
    pub(super) fn around(&self, [x, y]: [R; 2]) -> Self {
        let along = self.axis[0] * x + self.axis[1] * y;
        let reach = (R::lit(REACH) + R::lit(HALF_DIAGONAL) * self.longest) / self.longest + R::HALF;
        let middle = along / self.longest;
        let first = -((reach + middle).floor());
        let last = (reach - middle).floor();
        let first = first.max(self.first);
        Self { first, last: last.min(self.last).min(first + MOST - 1), ..*self }
    }

    /// A piece by its number, 0 in the middle.
    #[inline]
    pub(super) fn piece(&self, k: i32) -> Piece<R> {
        let (midpoint, long) = if k == 0 {
            (R::ZERO, self.longest.min(self.along))
        } else {
            // On one side of the middle, then on the other.
            let number = R::lit(f64::from(k.abs()));
            let low = (number - R::HALF) * self.longest;
            let high = ((number + R::HALF) * self.longest).min(R::HALF * self.along);
            let midpoint = R::HALF * (low + high);
            (if k < 0 { -midpoint } else { midpoint }, (high - low).max(R::ZERO))
        };
        let square = self.across * self.across;
        let share = if self.along > self.longest { long / self.along } else { R::ONE };
        Piece {
            offset: self.axis.map(|c| c * midpoint),
            share,
            square,
            more: long * long - square,
            axis: self.axis,
        }
    }

    /// The piece at a place of the long side, from 0 to 1.
    pub(super) fn piece_at(&self, u: R) -> Piece<R> {
        let place = (u - R::HALF) * self.along / self.longest + R::HALF;
        self.piece(place.floor().max(self.first).min(self.last))
    }
}

impl<R: Real> Piece<R> {
    /// Sides of the box along axes with this cosine and sine: their variances are the piece's.
    #[inline]
    pub(super) fn widths(&self, [cos, sin]: [R; 2]) -> [R; 2] {
        // Cosine and sine between the axes.
        let c = self.axis[0] * cos + self.axis[1] * sin;
        let s = self.axis[1] * cos - self.axis[0] * sin;
        // What both sides share needs no axis, which nearly square pieces hardly have.
        [c, s].map(|c| (self.square + c * c * self.more).max(R::ZERO).sqrt())
    }
}
