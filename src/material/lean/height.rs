//! From heights to slopes: central differences in the map's own units.
//!
//! Layer 4.

use super::map::Border;
use super::texel::{ClippedTexels, SlopeCap};
use crate::error::Error;
use crate::scalar::Real;

/// A displacement map: heights, how far apart its texels lie, how high a height of 1 is.
///
/// ```
/// use lobe::material::lean::{Border, HeightField, SlopeCap};
/// // A ramp of 0.1 a texel, texels 0.5 apart, displaced by 2: slope 0.4.
/// let heights = [0.0_f64, 0.1, 0.2, 0.3];
/// let field = HeightField::new([4, 1], &heights, [0.5, 0.5], 2.0, Border::Clamp)?;
/// let mut slopes = [[0.0; 2]; 4];
/// field.slopes(SlopeCap::new(10.0)?, 0, &mut slopes)?;
/// assert!(slopes.iter().all(|s| (s[0] - 0.4).abs() < 1e-15 && s[1] == 0.0));
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct HeightField<'a, R> {
    width: usize,
    height: usize,
    heights: &'a [R],
    /// Displacement over twice the distance of texels, and over the distance, for each axis.
    scale: [R; 2],
    border: Border,
}

impl<'a, R: Real> HeightField<'a, R> {
    /// Heights by rows, `size` as width and height.
    ///
    /// `texel`: the distance of neighboring texels along x and y, in the unit of `displacement`,
    /// which is the height of a stored 1. A negative distance turns an axis: rows that count down
    /// under a y that points up.
    ///
    /// # Errors
    /// [`Error::MapSize`] unless the heights are as many as the size says, and more than none;
    /// [`Error::Texel`] unless the distances lie in $\[10^{-9}, 10^9\]$, of either sign;
    /// [`Error::Displacement`] unless it lies in $\[-10^9, 10^9\]$.
    pub fn new(
        size: [usize; 2],
        heights: &'a [R],
        texel: [R; 2],
        displacement: R,
        border: Border,
    ) -> Result<Self, Error> {
        let [width, height] = size;
        if heights.is_empty() || width.checked_mul(height) != Some(heights.len()) {
            return Err(Error::MapSize { size, texels: heights.len() });
        }
        let known = |d: &&R| d.is_slope() && d.abs() * R::LARGEST >= R::ONE;
        if let Some(&d) = texel.iter().find(|d| !known(d)) {
            return Err(Error::Texel(d.into()));
        }
        if !displacement.is_slope() {
            return Err(Error::Displacement(displacement.into()));
        }
        Ok(Self { width, height, heights, scale: texel.map(|d| displacement / d), border })
    }

    /// Slopes of the rows from `first` on, as many as fit into `out`: central differences, and at a
    /// clamped border those to the one neighbor there is. An axis of one texel is flat.
    ///
    /// A central difference is the mean slope of the two quads beside a texel, which the displaced
    /// mesh has. Details of two texels' period have none.
    ///
    /// # Errors
    /// [`Error::Length`] unless `out` is whole rows of the map, from `first` on.
    pub fn slopes(
        &self,
        cap: SlopeCap<R>,
        first: usize,
        out: &mut [[R; 2]],
    ) -> Result<ClippedTexels, Error> {
        let rows = out.len() / self.width;
        let end = first.saturating_add(rows);
        if out.len() % self.width != 0 || end > self.height {
            let expected = self.width * (self.height - first.min(self.height));
            return Err(Error::Length { expected, found: out.len() });
        }
        let mut touched = 0;
        for (row, out) in (first..end).zip(out.chunks_exact_mut(self.width)) {
            let (above, below, dy) = self.neighbors(row, self.height, self.scale[1]);
            for (column, out) in out.iter_mut().enumerate() {
                let (left, right, dx) = self.neighbors(column, self.width, self.scale[0]);
                let along = (self.at(right, row) - self.at(left, row)) * dx;
                let across = (self.at(column, below) - self.at(column, above)) * dy;
                let (slope, clipped) = cap.limited([along, across]);
                *out = slope;
                touched += usize::from(clipped);
            }
        }
        Ok(ClippedTexels { texels: touched, of: out.len() })
    }

    fn at(&self, column: usize, row: usize) -> R {
        self.heights[row * self.width + column]
    }

    /// The texels before and after, and what their difference is multiplied by.
    fn neighbors(&self, k: usize, count: usize, scale: R) -> (usize, usize, R) {
        let (first, last) = (k == 0, k + 1 == count);
        let half = R::HALF * scale;
        match self.border {
            Border::Wrap => {
                (if first { count - 1 } else { k - 1 }, if last { 0 } else { k + 1 }, half)
            }
            Border::Clamp => (
                if first { 0 } else { k - 1 },
                if last { k } else { k + 1 },
                if first == last { half } else { scale },
            ),
        }
    }
}
