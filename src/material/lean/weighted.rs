//! Maps of which some texels count more than others, and lookups that know it.
//!
//! Layer 4. Textures are islands in a void whose texels mean nothing.

use super::level::Stored;
use super::map::{Border, MomentMap, Rows};
use super::weight::weighed;
use crate::error::{Error, same_length};
use crate::scalar::Real;
use alloc::vec::Vec;

/// The smallest weight beside the largest one: smaller ones count as 0, so that no level's weights
/// leave f32.
const LEAST: f64 = 1e-9;

impl<R: Real> MomentMap<R> {
    /// The chain over a map of slopes of which some count more than others, by rows: weights are
    /// coverage from an alpha channel, or areas.
    ///
    /// Every level merges the means and covariances of the level before by the weights of its
    /// texels, and a texel's weight is the mean of theirs. A slope of weight 0 may be any number,
    /// NaN too: nothing depends on it. A texel that covers weights of 0 only takes the moments of
    /// the coarser texel that covers it, on level 0 that one's mean slope, so hardware that
    /// interpolates across an island's edge meets slopes of that island. Lookups
    /// ([`MomentMap::bilinear`] and its kin) weigh their texels, too, and give such a texel's
    /// moments where no other counts. Weights matter by their ratios; one below $10^{-9}$ of the
    /// largest counts as 0.
    ///
    /// # Errors
    /// [`Error::Length`] unless there are as many weights as slopes; [`Error::Weight`] if a weight
    /// is negative, infinite or NaN, [`Error::WeightSum`] if all are 0; for the rest as
    /// [`MomentMap::from_slopes`], [`Error::Mean`] of slopes that count.
    ///
    /// ```
    /// use lobe::material::lean::{Border, MomentMap};
    /// // Two texels are covered by an island; the painting tool left arbitrary colors in the other
    /// // texels.
    /// let slopes = vec![[0.1_f64, 0.0], [0.3, 0.0], [-99.0, 7.0], [f64::NAN, 0.0]];
    /// let map = MomentMap::from_weighted_slopes(
    ///     [2, 2],
    ///     slopes,
    ///     vec![1.0, 1.0, 0.0, 0.0],
    ///     Border::Wrap,
    /// )?;
    /// let whole = map.texel(1, 0, 0);
    /// assert!(
    ///     (whole.mean()[0] - 0.2).abs() < 1e-15
    ///         && (whole.covariance().entries()[0] - 0.01).abs() < 1e-15
    /// );
    /// assert_eq!((map.weight(0, 0, 1), map.weight(1, 0, 0)), (0.0, 0.5));
    /// assert_eq!(map.slopes()[3], whole.mean());
    /// # Ok::<(), lobe::Error>(())
    /// ```
    ///
    /// Source: Olano & Baker 2010 for the moments; Gortler et al. 1996 (pull and push) for texels
    /// without weight.
    pub fn from_weighted_slopes(
        size: [usize; 2],
        slopes: Vec<[R; 2]>,
        weights: Vec<R>,
        border: Border,
    ) -> Result<Self, Error> {
        Self::weighted(size, slopes, weights, border, |_, out, rows| rows(0, out))
    }

    /// [`MomentMap::from_weighted_slopes`] with the rows of each level dealt to `workers` threads
    /// (feature `std`); the number of threads changes no bit of the result, 0 counts as 1.
    ///
    /// # Errors
    /// As [`MomentMap::from_weighted_slopes`].
    ///
    /// ```
    /// use lobe::material::lean::{Border, MomentMap};
    /// let slopes: Vec<[f32; 2]> = (0..64).map(|k| [(k % 7) as f32, (k % 5) as f32]).collect();
    /// let weights: Vec<f32> = (0..64).map(|k| (k % 3) as f32).collect();
    /// let one =
    ///     MomentMap::from_weighted_slopes([8, 8], slopes.clone(), weights.clone(), Border::Wrap)?;
    /// let two = MomentMap::from_weighted_slopes_by([8, 8], slopes, weights, Border::Wrap, 2)?;
    /// assert_eq!(one, two);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[cfg(feature = "std")]
    pub fn from_weighted_slopes_by(
        size: [usize; 2],
        slopes: Vec<[R; 2]>,
        weights: Vec<R>,
        border: Border,
        workers: usize,
    ) -> Result<Self, Error> {
        Self::weighted(size, slopes, weights, border, |size, out, rows| {
            super::map::deal(size, workers, out, rows);
        })
    }

    /// A texel's weight, of the map's largest, in \[0, 1\]: the mean of the weights that it covers;
    /// 1 of a map without.
    ///
    /// Level, column and row beyond the last count as the last.
    pub fn weight(&self, level: usize, column: usize, row: usize) -> R {
        let level = level.min(self.levels() - 1);
        self.weights.get(level).map_or(R::ONE, |weights| weights[self.place(level, column, row)])
    }

    /// The shares of a lookup's texels multiplied by the texels' weights and divided by their sum,
    /// and that sum.
    ///
    /// The shares are returned unchanged if no texel counts (the sum is then 0) and for a map
    /// without weights (the sum is 1).
    pub(super) fn by_weight<const N: usize>(
        &self,
        shares: [R; N],
        weights: impl Fn(usize) -> R,
    ) -> ([R; N], R) {
        if self.weights.is_empty() {
            return (shares, R::ONE);
        }
        weighed(&shares, &core::array::from_fn(weights)).unwrap_or((shares, R::ZERO))
    }

    fn weighted(
        size: [usize; 2],
        mut slopes: Vec<[R; 2]>,
        mut weights: Vec<R>,
        border: Border,
        deal: impl Fn([usize; 2], &mut [Stored<R>], Rows<'_, R>),
    ) -> Result<Self, Error> {
        same_length(slopes.len(), weights.len())?;
        let bad =
            weights.iter().find(|weight| !(**weight >= R::ZERO && weight.is_finite())).copied();
        let largest = weights.iter().fold(R::ZERO, |most, weight| weight.max(most));
        let heaviest = weights.iter().position(|weight| *weight == largest);
        let Some(heaviest) = heaviest.filter(|_| bad.is_none() && largest > R::ZERO) else {
            return Err(match bad {
                _ if slopes.is_empty() => Error::MapSize { size, texels: 0 },
                Some(weight) => Error::Weight(weight.into()),
                None => Error::WeightSum(R::ZERO.into()),
            });
        };
        let known = slopes[heaviest];
        for (slope, weight) in slopes.iter_mut().zip(&mut weights) {
            let relative = *weight / largest;
            *weight = if relative < R::lit(LEAST) { R::ZERO } else { relative };
            // `fill` replaces it after the chain is built. Until then any valid slope near the
            // others will do.
            if *weight == R::ZERO {
                *slope = known;
            }
        }
        let mut map = Self::built(size, slopes, Some(weights), border, deal)?;
        map.fill();
        Ok(map)
    }

    /// Gives texels without weight the moments of the coarser texel that covers them.
    fn fill(&mut self) {
        // The last level has weight: it covers all.
        for level in (0..self.levels.len()).rev() {
            let [width, height] = self.size(level);
            let [columns, rows] = self.size(level + 1);
            for place in (0..width * height).filter(|place| self.weights[level][*place] == R::ZERO)
            {
                // An odd side's last texel lies in the last one's box.
                let column = (place % width / 2).min(columns - 1);
                let row = (place / width / 2).min(rows - 1);
                let coarse = row * columns + column;
                if level == 0 {
                    self.slopes[place] = self.texel(1, column, row).mean();
                } else {
                    self.levels[level - 1][place] = self.levels[level][coarse];
                }
            }
        }
    }
}
