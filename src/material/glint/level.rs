//! One grid under a pixel: its columns of cells.
//!
//! Layer 4.
#![allow(
    clippy::cast_sign_loss,
    clippy::cast_possible_wrap,
    reason = "counts of at most 34, from 0 on"
)]

use crate::material::cells::{Patch, corner, place};
use crate::scalar::Real;

/// Longest pixel against its width, in cells: longer ones get coarser cells. Zirr & Kaplanyan 2016,
/// section 4.2.
pub const ANISOTROPY_LIMIT: u32 = 16;

/// Columns of cells that one level may need: 32 cells of a pixel between two sizes, one at each
/// end.
pub(super) const COLUMNS: u32 = 2 * ANISOTROPY_LIMIT + 2;

/// Cells from the tile's corner, 2^20, beyond which f32 has no fraction of a cell left that is
/// worth a weight.
pub(super) const FARTHEST: i32 = 20;

/// A cell that a pixel covers.
#[doc(alias = "LobeCoveredCell")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct CoveredCell<R> {
    /// The cell's center, in cells from the origin of the coordinates.
    pub index: [i64; 2],
    /// The cell's size is $2^k$, k being this.
    pub exponent: i32,
    /// The cell's share of the pixel. All shares sum to 1.
    pub share: R,
}

/// One of the two grids: its columns of cells, along the pixel's longer extent.
#[derive(Clone, Copy, Debug)]
pub(super) struct Level<R> {
    pub(super) exponent: i32,
    /// Indices that columns and cells count from, along u and v.
    corner: [i64; 2],
    /// 1 if columns stand along v.
    pub(super) along_v: bool,
    pub(super) first: i32,
    pub(super) count: u32,
    begin: R,
    end: R,
    pub(super) midpoint: [R; 2],
    skew: R,
    /// One over the sum of its columns' weights.
    share: R,
}

/// Two cells of a column.
#[derive(Clone, Copy, Debug)]
pub(super) struct Column<R> {
    pub(super) first: i32,
    pub(super) shares: [R; 2],
}

impl<R: Real> Level<R> {
    #[inline]
    pub(super) fn new(patch: &Patch<R>, width: R, exponent: i32) -> Self {
        let [a, b] = patch.extents();
        let along_v = b > a;
        let inverse = R::power_of_two(-exponent);
        let limit = R::power_of_two(FARTHEST + 1);
        let [x, y] =
            [0, 1].map(|k| place(patch.tile[k], patch.uv[k], exponent).max(-limit).min(limit));
        let midpoint = if along_v { [y, x] } else { [x, y] };
        let of = |d: [R; 2]| if along_v { [d[1], d[0]] } else { d };
        let (right, up) = (of(patch.right), of(patch.up));
        // The line through the parallelogram by least squares, between the two medians. A pixel too
        // small for squares has no use for it.
        let [p, q] = [right[0], up[0]].map(|x| x * inverse);
        let across = [right[1], up[1]].map(|x| x * inverse);
        let skew = (p * across[0] + q * across[1]) / (p * p + q * q).max(R::MIN_POSITIVE);
        let skew = skew.max(-R::ONE).min(R::ONE);
        // By what the pixel is longer than wide, and no less than a cell.
        let most = R::lit(f64::from(2 * ANISOTROPY_LIMIT));
        let long = p.abs().max(q.abs().max(R::ZERO)).min(most);
        let half = R::HALF * (long - (width * inverse).max(R::ONE)).max(R::ZERO);
        let (begin, end) = (midpoint[0] - half, midpoint[0] + half);
        let first = begin.floor();
        let count = (end.floor() - first) as u32 + 2;
        let share = R::ONE / (R::ONE + (end - begin));
        let count = count.min(COLUMNS);
        let corner = patch.tile.map(|tile| corner(tile, exponent));
        Self { exponent, corner, along_v, first, count, begin, end, midpoint, skew, share }
    }

    /// The `n`th column.
    #[inline]
    pub(super) fn column(&self, n: u32) -> Column<R> {
        // Columns beyond an end see the pixel's end: of a pixel within a cell, its center.
        let place = self.place(n).max(self.begin).min(self.end);
        self.column_at(n, self.midpoint[1] + self.skew * (place - self.midpoint[0]))
    }

    /// Where the `n`th column stands, in cells.
    #[inline]
    pub(super) fn place(&self, n: u32) -> R {
        R::lit(f64::from(self.first + n as i32))
    }

    /// The `n`th column with the pixel's line at `y`.
    #[inline]
    pub(super) fn column_at(&self, n: u32, y: R) -> Column<R> {
        let (zero, one) = (R::ZERO, R::ONE);
        let at = self.place(n);
        let left = (one - (self.begin - at).max(zero)).max(zero);
        let right = (one - (at - self.end).max(zero)).max(zero);
        let first = y.floor();
        let part = y - R::lit(f64::from(first));
        let share = self.share * left * right;
        Column { first, shares: [share * (one - part), share * part] }
    }

    /// The index of a cell by its column and its place there.
    #[inline]
    pub(super) fn index(&self, n: u32, row: i32) -> [i64; 2] {
        let column = self.first + n as i32;
        let [u, v] = if self.along_v { [row, column] } else { [column, row] };
        [self.corner[0] + i64::from(u), self.corner[1] + i64::from(v)]
    }
}
