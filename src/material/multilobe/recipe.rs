//! What a dictionary of marginals is made by.
//!
//! Layer 4.

use crate::error::Error;

/// Where the lobes of a dictionary's marginals stand.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum LobeMeans {
    /// One in each of as many equal parts of the normal distribution as there are marginals, with
    /// what variance the lobes leave of 1: the dictionary's mean is the smooth lobe, as nearly as
    /// its number of marginals allows.
    #[default]
    Stratified,
    /// Independent draws of variance 1, as published (Chermain et al. 2020): the dictionary is
    /// wider than its smooth lobe by the variance of one lobe, and its mean differs from it by
    /// sampling noise.
    Chermain,
}

/// How a [`Dictionary`](super::Dictionary) is made: sizes, lobes, seed.
///
/// Time grows with the pairs of lobes, marginals times $2^{levels - 1}$, and with the nodes that
/// one covers, 3 + 3 width intervals: half a second on one core for the default's six million pairs
/// of 14 nodes, days at the ends of all ranges. While it is made, a node takes 16 bytes beside its
/// own 8 or 16; if that cannot be allocated, the process aborts.
///
/// ```
/// use lobe::material::multilobe::{Dictionary, Recipe};
/// let small = Recipe { marginals: 32, levels: 8, ..Recipe::default() };
/// assert_eq!(Dictionary::<f32>::new(&small)?.bytes(), 32 * 8 * 65 * 8);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Recipe {
    /// How many marginals there are to pick from: 1 to 65536.
    pub marginals: u32,
    /// Levels, each with twice the lobes of the one before, from one pair on: 1 to 20.
    pub levels: u32,
    /// Intervals of a marginal's table, from 0 to 4 deviations: a power of two from 8 to 4096.
    pub intervals: u32,
    /// Deviation of one lobe over that of the whole: from half an interval, $2/$ `intervals`, to
    /// 0.5.
    pub width: f64,
    /// Where lobes stand.
    pub means: LobeMeans,
    /// For other random numbers.
    pub seed: u32,
}

impl Default for Recipe {
    /// Of the paper: 192 marginals, 16 levels, 64 intervals; lobes of deviation 0.02 where the
    /// whole has $0.5/\sqrt 2$.
    fn default() -> Self {
        Self {
            marginals: 192,
            levels: 16,
            intervals: 64,
            width: 0.04 * core::f64::consts::SQRT_2,
            means: LobeMeans::Stratified,
            seed: 0,
        }
    }
}

impl Recipe {
    /// The number of nodes that all tables have.
    pub(super) fn nodes(&self) -> usize {
        let product = u64::from(self.marginals) * u64::from(self.levels);
        // At most 65536 * 20 * 4097, below 2^33: no more than memory has on any machine that could
        // hold it.
        usize::try_from(product * (u64::from(self.intervals) + 1)).unwrap_or(usize::MAX)
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        let Self { marginals, levels, intervals, width, .. } = *self;
        if !(1..=65_536).contains(&marginals) {
            return Err(Error::Marginals(marginals));
        }
        if !(1..=20).contains(&levels) {
            return Err(Error::Levels(levels));
        }
        if !((8..=4096).contains(&intervals) && intervals.is_power_of_two()) {
            return Err(Error::Intervals(intervals));
        }
        // NaN is in no range.
        if width >= 2.0 / f64::from(intervals) && width <= 0.5 {
            Ok(())
        } else {
            Err(Error::LobeWidth { width: width.into(), intervals })
        }
    }
}
