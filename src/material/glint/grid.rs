//! Which cells a pixel covers, on two nested grids, and how much of each.
//!
//! Layer 4.

use super::level::{ANISOTROPY_LIMIT, CoveredCell, FARTHEST, Level};
use crate::material::cells::{Cell, Patch, finest};
use crate::scalar::Real;

/// How much of the way between two levels a cell takes to come or go, and its share of an even
/// blend meanwhile: without that, pixels whose cells have all gone would have none.
const RAMP: f64 = 0.5;
const EVEN: f64 = 0.03;

/// The two grids of a pixel.
///
/// The cell size is the pixel's width ([`Patch::width`]), or for longer pixels a sixteenth
/// ([`ANISOTROPY_LIMIT`]) of its longer extent ([`Patch::extents`]): the power of two below it, and
/// the one above. On the way from one to the other, by the size's logarithm, cells come and go one
/// by one, each at its own time ([`Cell::turn`]). Columns of cells stand along the pixel's longer
/// extent, over as much of it as it is longer than wide; each has two cells, weighted by their
/// distances from the pixel's middle line, and at the ends columns by their overlap: at most 104
/// cells. Continuous in coordinates and derivatives, but where a pixel at least 1.4 times as long
/// as wide turns through a diagonal, from columns to rows; square ones have no columns to turn.
///
/// Source: Zirr & Kaplanyan 2016, section 4.2. There the width is the chord along the other axis,
/// $|d_x \times d_y| / \max E$, which is 1.4 times as large for a square that stands on its corner;
/// all cells of both levels are blended by one weight, and where it leaves 0 dim, large glints
/// appear everywhere at once; columns stand over all of the longer extent but a cell, so that
/// squares jump where rounding turns them from columns to rows; and they lie along the longer of
/// the two medians, which jumps where the other becomes longer, and beyond the pixel's ends.
///
/// ```
/// use lobe::material::cells::Patch;
/// use lobe::material::glint::Grid;
/// let pixel = Patch::new([0.25_f64, 0.5], [1e-3, 0.0], [0.0, 4e-3]);
/// let (mut count, mut sum) = (0, 0.0);
/// Grid::new(&pixel, 1e-9).visit(|cell| {
///     count += 1;
///     sum += cell.share;
/// });
/// assert!((8..=24).contains(&count) && (sum - 1.0).abs() < 1e-12);
/// ```
#[doc(alias = "LobeGrid")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid<R> {
    patch: Patch<R>,
    /// What of the patch's length is no length: cells along it stand for the rest.
    width: R,
    /// Of the finer grid.
    exponent: i32,
    /// How far the coarser grid has come.
    coarser: R,
    seed: u32,
}

impl<R: Real> Grid<R> {
    /// The grids of a pixel, with cells no smaller than `least`.
    ///
    /// Nor smaller than $2^{-20}$ of the distance of `uv` from the tile's corner, for the sake of
    /// f32: of plain coordinates, from the origin ([`Patch::new`]). Coordinates of large surfaces
    /// belong into [`Patch::in_tile`]. NaN counts as 0 (of coordinates, as far away).
    #[doc(alias = "lobe_grid_new")]
    #[inline]
    pub fn new(patch: &Patch<R>, least: R) -> Self {
        Self::stretched(patch, [R::ONE; 2], least)
    }

    /// The grids of a pixel whose coordinates are compressed by factors in [0, 1], with the cell
    /// size that it has without.
    #[doc(alias = "lobe_grid_stretched")]
    #[inline]
    pub fn stretched(patch: &Patch<R>, factors: [R; 2], least: R) -> Self {
        let [a, b] = patch.extents();
        let anisotropic = a.max(b) / R::lit(f64::from(ANISOTROPY_LIMIT));
        // The fraction of a tile times a factor lies in [-2, 2], and is rounded as numbers of that
        // size are.
        let is_rounded = R::SINGLE && patch.tile != [0; 2] && factors != [R::ONE; 2];
        let distance = patch.distance().max(if is_rounded { R::TWO } else { R::ZERO });
        // `max` drops the NaN of a caller's.
        let size =
            patch.width().max(anisotropic).max(least).max(distance * R::power_of_two(-FARTHEST));
        let stretched = patch.stretched(factors);
        Self::of_size(stretched, stretched.width(), size)
    }

    /// The grids of a pixel of this width with cells of this size.
    #[inline]
    pub(super) fn of_size(patch: Patch<R>, width: R, size: R) -> Self {
        let size = size.max(finest(patch.tile));
        let size = size.max(R::power_of_two(-100)).min(R::power_of_two(100));
        let exponent = size.exponent();
        let mantissa = size * R::power_of_two(-exponent);
        let coarser = (mantissa.ln() / R::TWO.ln()).max(R::ZERO).min(R::ONE);
        Self { patch, width, exponent, coarser, seed: 0 }
    }

    /// The same grids with other random numbers.
    #[must_use]
    #[inline]
    pub const fn with_seed(self, seed: u32) -> Self {
        Self { seed, ..self }
    }

    /// The finer grid's cells are of size $2^k$, k being this.
    #[inline]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }

    /// How far the coarser grid has come, from 0, where there is only the finer one, to 1.
    #[inline]
    pub const fn coarser(&self) -> R {
        self.coarser
    }

    /// Calls `f` with every cell that the pixel covers.
    #[inline]
    pub fn visit(&self, mut f: impl FnMut(CoveredCell<R>)) {
        let sum = self.walk(|_, _| ());
        self.walk(|covered, _| f(CoveredCell { share: covered.share / sum, ..covered }));
    }

    /// The same with shares that sum to what is returned.
    #[inline]
    pub(super) fn walk(&self, mut f: impl FnMut(CoveredCell<R>, Cell)) -> R {
        let mut sum = R::ZERO;
        for (coarser, level) in [false, true].into_iter().zip(self.levels()) {
            for n in 0..level.count {
                let column = level.column(n);
                for (step, share) in (0..).zip(column.shares) {
                    if !(share > R::ZERO) {
                        continue;
                    }
                    let (index, exponent) = (level.index(n, column.first + step), level.exponent);
                    let cell = Cell::at(index, exponent, self.seed);
                    let share = share * self.presence(cell, coarser);
                    if share > R::ZERO {
                        sum = sum + share;
                        f(CoveredCell { index, exponent, share }, cell);
                    }
                }
            }
        }
        sum
    }

    /// How much of a cell is there, of the finer level or the coarser one.
    #[inline]
    fn presence(&self, cell: Cell, coarser: bool) -> R {
        let (zero, one, even) = (R::ZERO, R::ONE, R::lit(EVEN));
        let passed = (self.coarser * R::lit(1.0 + RAMP) - cell.turn()) * R::lit(1.0 / RAMP);
        let come = even * self.coarser + (one - even) * passed.max(zero).min(one);
        if coarser { come } else { one - come }
    }

    /// The finer level and the coarser one.
    #[inline]
    pub(super) fn levels(&self) -> [Level<R>; 2] {
        [0, 1].map(|k| Level::new(&self.patch, self.width, self.exponent + k))
    }
}
