//! Which cells of a level an elliptic pixel covers, and how much of each.
//!
//! Layer 4.

use crate::material::cells::{Patch, corner, place};
use crate::scalar::{Psd, Real};

/// The largest aspect ratio of a pixel: longer ones are widened to it.
pub const ELLIPSE_LIMIT: u32 = 8;

/// Rows that one level may need: a half height of 16 cells, grown by one cell's own.
pub(super) const ROWS: i32 = 34;

/// A pixel's ellipse on texture coordinates: center, and square of its axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ellipse<R> {
    pub(super) tile: [i32; 2],
    pub(super) uv: [R; 2],
    square: Psd<R>,
    /// Its smaller radius, at least.
    pub(super) width: R,
}

/// An ellipse on one level, in cells: radii grown by a cell, so that there is always one inside.
#[derive(Clone, Copy, Debug)]
pub(super) struct Rows<R> {
    /// Indices that cells and rows count from, along u and v.
    corner: [i64; 2],
    midpoint: [R; 2],
    square: Psd<R>,
    pub(super) first: i32,
    pub(super) last: i32,
}

/// A row's cells.
#[derive(Clone, Copy, Debug)]
pub(super) struct Row<R> {
    pub(super) first: i32,
    pub(super) last: i32,
    /// Where the ellipse's middle is in it, one over the square of its half width there, and what
    /// is left of the squared radius.
    middle: R,
    scale: R,
    rest: R,
}

impl<R: Real> Ellipse<R> {
    /// Of a patch: half axes as long as the derivatives' singular values, the smaller one at least
    /// an eighth.
    #[inline]
    pub(super) fn of(patch: &Patch<R>) -> Self {
        // NaN counts as 0, as in a grid of glints.
        let number = |x: R| if x >= R::ZERO || x < R::ZERO { x } else { R::ZERO };
        let finite = |v: [R; 2]| v.map(|x| number(x).max(-R::LARGEST).min(R::LARGEST));
        let (right, up) = (finite(patch.right), finite(patch.up));
        // Rows of [right up]: sums of outer products of the columns.
        let square = Psd::outer_sum(right, up);
        let eigen = square.eigen();
        let limit = R::lit(f64::from(ELLIPSE_LIMIT * ELLIPSE_LIMIT));
        let least = eigen.major / limit;
        let square = if eigen.minor < least {
            let missing = (least - eigen.minor).sqrt();
            let [x, y] = eigen.axis.map(|c| c * missing);
            let [xx, xy, yy] = square.entries();
            // The determinant's root by the ratio, not by a sum that small pixels have no digits
            // for.
            let root_det = eigen.major / R::lit(f64::from(ELLIPSE_LIMIT));
            Psd::with_root_det([xx + y * y, xy - x * y, yy + x * x], root_det)
        } else {
            square
        };
        let width = eigen.minor.max(least).sqrt();
        Self { tile: patch.tile, uv: finite(patch.uv), square, width }
    }

    /// On the level of cells of size $2^k$.
    #[inline]
    pub(super) fn rows(&self, exponent: i32) -> Rows<R> {
        let inverse = R::power_of_two(-exponent);
        // Beyond what cells are made for, and below what indices hold.
        let limit = R::power_of_two(if R::SINGLE { 21 } else { 29 });
        let midpoint = [0, 1]
            .map(|k| place(self.tile[k], self.uv[k], exponent).max(-limit).min(limit) - R::HALF);
        let cell = Psd::with_root_det([R::ONE, R::ZERO, R::ONE], R::ONE);
        let square = (self.square * (inverse * inverse)) + cell;
        let [_, _, yy] = square.entries();
        let [first, last] = between(midpoint[1], yy.sqrt());
        let corner = self.tile.map(|tile| corner(tile, exponent));
        Rows { corner, midpoint, square, first, last }
    }
}

/// The whole numbers within a distance.
#[inline]
fn between<R: Real>(midpoint: R, reach: R) -> [i32; 2] {
    let first = -((reach - midpoint).floor());
    [first, (midpoint + reach).floor().min(first + ROWS - 1)]
}

impl<R: Real> Rows<R> {
    /// Row `t`: the ellipse's chord.
    #[inline]
    pub(super) fn row(&self, t: i32) -> Row<R> {
        let [_, xy, yy] = self.square.entries();
        let offset = R::lit(f64::from(t)) - self.midpoint[1];
        let rest = (R::ONE - offset * offset / yy).max(R::ZERO);
        let middle = self.midpoint[0] + xy / yy * offset;
        let square = self.square.root_det() * (self.square.root_det() / yy);
        let [first, last] = between(middle, (square * rest).sqrt());
        Row { first, last, middle, scale: R::ONE / square, rest }
    }

    /// The index of cell `s` of row `t`.
    #[inline]
    pub(super) fn index(&self, s: i32, t: i32) -> [i64; 2] {
        [self.corner[0] + i64::from(s), self.corner[1] + i64::from(t)]
    }
}

impl<R: Real> Row<R> {
    /// The weight of cell `s` of the row: a Gaussian of the distance, which ends with 0 at the
    /// ellipse.
    #[inline]
    pub(super) fn weight(&self, s: i32) -> R {
        let offset = R::lit(f64::from(s)) - self.middle;
        // 1 - r^2, which has more digits than r^2 at the rim.
        let inside = self.rest - offset * offset * self.scale;
        let rim = R::lit(RIM);
        (rim * ((R::TWO * inside).exp() - R::ONE)).max(R::ZERO)
    }
}

/// $e^{-2}$, where the Gaussian is cut.
const RIM: f64 = 0.135_335_283_236_612_7;
