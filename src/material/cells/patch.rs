//! A pixel's place on a surface.
//!
//! Layer 4.

use super::tile::compressed;
use crate::scalar::Real;
use crate::scalar::exact::cross;

/// A pixel's place on a surface: texture coordinates, and how they change to the pixel on the right
/// and above.
///
/// The coordinates are $tile + uv$, whole numbers and floats. Cells are counted from the tile by
/// integers, so a pixel has as sound cells in tile $10^9$ as in tile 0 ([`Patch::in_tile`]).
/// [`Patch::new`] has plain coordinates, tile 0.
///
/// ```
/// use lobe::material::cells::Patch;
/// let patch = Patch::new([0.25_f32, 0.5], [1e-3, 0.0], [0.0, 4e-3]);
/// assert_eq!(patch.extents(), [1e-3, 4e-3]);
/// ```
#[doc(alias = "LobePatch")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Patch<R> {
    /// Whole numbers to be added to `uv`: 0 of plain coordinates.
    pub tile: [i32; 2],
    /// Texture coordinates of the pixel's center, from the tile's corner.
    pub uv: [R; 2],
    /// Their change to the next pixel on the right.
    pub right: [R; 2],
    /// Their change to the next pixel above.
    pub up: [R; 2],
}

impl<R: Real> Patch<R> {
    /// From coordinates and derivatives.
    ///
    /// In f32, coordinates have 24 bits: a pixel of width w (see [`Patch::width`]) has cells of its
    /// own size where $\max(|u|, |v|) \le 2^{20} w$. There at least 8 different coordinates fall
    /// into a cell's width, so shares are right to 1/16 of a cell. Farther away, cells of glints
    /// are as large as $2^{-20} \max(|u|, |v|)$: details in a cell grow like the square of the
    /// distance, and the deviation of the sparkle falls like one over it. A pixel of width 1e-3
    /// loses its glints from |u| = 1000 on. [`Patch::in_tile`] has no such distance.
    #[doc(alias = "lobe_patch_new")]
    #[inline]
    pub fn new(uv: impl Into<[R; 2]>, right: impl Into<[R; 2]>, up: impl Into<[R; 2]>) -> Self {
        Self::in_tile([0; 2], uv, right, up)
    }

    /// From the whole part of the coordinates, what is left of them, and derivatives.
    ///
    /// The coordinates are the exact sum $tile + uv$. Tile t with uv and tile t + 1 with uv - 1 are
    /// one place, and a place that a float holds has the cells that [`Patch::new`] gives it; `uv`
    /// may lie outside of [0, 1), for pixels across a border or triangles over several tiles, and
    /// loses precision by its own size only. Any tile of 32 bits will do. Cells are no smaller than
    /// $2^{-20} \max(|u|, |v|)$ of `uv` alone, and outside of tile 0 no smaller than $2^{-31}$.
    ///
    /// For stretched details ([`Grid::stretched`](crate::material::glint::Grid::stretched))
    /// coordinates are multiplied by a factor. The product is taken exactly; its fraction is right
    /// to $2^{-22}$ in f32, so stretched cells outside of tile 0 are no smaller than $2^{-19}$. In
    /// tile 0 they may be smaller: a pixel below that size on a border of tile 0 has other cells
    /// from there than from the tile beside it. If the factor changes by d, the cells of tile t
    /// move by t d tiles: the factor should be a constant of the surface. Devices whose square
    /// roots round differently have different factors, and so different cells in far tiles.
    ///
    /// ```
    /// use lobe::material::cells::Patch;
    /// use lobe::material::glint::{Biscale, Glints};
    /// let snow = Glints::new(Biscale::from_fractions([0.3_f32, 0.3], [0.1, 0.1])?, 1e6)?;
    /// let (right, up, h) = ([1e-3, 0.0], [0.0, 1e-3], [0.0, 0.0, 1.0]);
    /// let near = snow.ndf(&Patch::new([5.25, 2.5], right, up)).sparkle(h, 0.0);
    /// assert_eq!(near, snow.ndf(&Patch::in_tile([5, 2], [0.25, 0.5], right, up)).sparkle(h, 0.0));
    /// // A coordinate of f64, for f32.
    /// let (u, v) = (1_234_567.890_625_f64, -3.5_f64);
    /// let tile = [u.floor() as i32, v.floor() as i32];
    /// let uv = [(u - u.floor()) as f32, (v - v.floor()) as f32];
    /// assert!(snow.ndf(&Patch::in_tile(tile, uv, right, up)).sparkle(h, 0.0) >= 0.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_patch_in_tile")]
    #[inline]
    pub fn in_tile(
        tile: impl Into<[i32; 2]>,
        uv: impl Into<[R; 2]>,
        right: impl Into<[R; 2]>,
        up: impl Into<[R; 2]>,
    ) -> Self {
        Self { tile: tile.into(), uv: uv.into(), right: right.into(), up: up.into() }
    }

    /// Sides of the box around the middles of the parallelogram's edges, $\max(|d_x|, |d_y|)$ per
    /// axis.
    #[doc(alias = "lobe_patch_extents")]
    #[inline]
    pub fn extents(&self) -> [R; 2] {
        // `max` drops a NaN on its left: here both.
        [0, 1].map(|k| self.right[k].abs().max(self.up[k].abs().max(R::ZERO)))
    }

    /// Area of the parallelogram.
    #[doc(alias = "lobe_patch_area")]
    #[inline]
    pub fn area(&self) -> R {
        cross(self.right, self.up).abs()
    }

    /// The smaller singular value of the derivatives: of a rectangle its shorter side, however it
    /// is turned.
    ///
    /// ```
    /// use lobe::material::cells::Patch;
    /// let square = Patch::new([0.0_f64; 2], [0.6, 0.8], [-0.8, 0.6]);
    /// assert!((square.width() - 1.0).abs() < 1e-15);
    /// ```
    #[doc(alias = "lobe_patch_width")]
    #[inline]
    pub fn width(&self) -> R {
        let [a, b] = self.extents();
        let long = a.max(b).max(R::MIN_POSITIVE);
        // In units of the extent, for squares of small derivatives have no digits.
        let [p, q] = [self.right, self.up].map(|d| d.map(|x| (x / long).kept()));
        // The larger singular value without a difference of trace and determinant, which has half
        // the digits of a square.
        let length = |x: R, y: R| (x * x + y * y).sqrt();
        let twice = length(p[0] + q[1], p[1] - q[0]) + length(p[0] - q[1], p[1] + q[0]);
        // A pixel without extent has no sum to divide by.
        let width = long * (R::TWO * cross(p, q).abs() / twice.max(R::MIN_POSITIVE));
        // `max` drops the NaN of infinite derivatives.
        width.max(R::ZERO)
    }

    /// The patch after both surface coordinates are multiplied by factors in [0, 1].
    #[inline]
    pub(in crate::material) fn stretched(&self, factors: [R; 2]) -> Self {
        let scaled = |v: [R; 2]| [v[0] * factors[0], v[1] * factors[1]];
        let (mut tile, mut uv) = ([0; 2], scaled(self.uv));
        if self.tile != [0; 2] {
            let axes = [0, 1].map(|k| compressed(self.tile[k], self.uv[k], factors[k]));
            (tile, uv) = (axes.map(|(tile, _)| tile), axes.map(|(_, uv)| uv));
        }
        Self { tile, uv, right: scaled(self.right), up: scaled(self.up) }
    }

    /// How far `uv` lies from the tile's corner, along the axis that is farther.
    #[inline]
    pub(in crate::material) fn distance(&self) -> R {
        self.uv[0].abs().max(self.uv[1].abs().max(R::ZERO))
    }
}
