//! A cell of the nested grids: the same numbers wherever the same place is a center again.
//!
//! Layer 4.
#![allow(
    clippy::cast_sign_loss,
    clippy::cast_possible_wrap,
    reason = "words of a hash have no sign"
)]

use crate::scalar::Real;
use crate::scalar::hash::{hash, tail, uniform};

/// In place of a bin, one that no half vector has (they end at 2^30): the golden ratio's digits.
const COLOR: u32 = 2_654_435_769;

/// What a coordinate's multiple of $2^{32}$ adds to the seed, along u and v: $2^{32}/\rho$ and
/// $2^{32}/\rho^2$ with the plastic ratio, $\rho^3 = \rho + 1$, made odd. The shortest pair of
/// multiples whose sum is 0 is (7843, 47809).
const FAR: [u32; 2] = [3_242_174_889, 2_447_445_413];

/// The random numbers of a cell, one for each purpose.
///
/// Cells of size $2^k$ have their centers at whole multiples of it, so every center of a coarse
/// grid is one of each finer grid. A cell is known by its center alone, $i 2^k$ as an odd number
/// times a power of two: equal on all levels that have it, different for any two centers, and as
/// deep as the range of exponents.
///
/// Zirr & Kaplanyan 2016, section 4.1, shift the index right by its trailing zeros, each axis by
/// its own: of the 65536 indices of a square around the origin a quarter is left
/// (tests/laws/errata_glints.rs).
///
/// ```
/// use lobe::material::cells::Cell;
/// // 6 of size 2 and 3 of size 4 are one place; 3 of size 2 is another.
/// assert_eq!(Cell::at([6, -10], 1, 0), Cell::at([3, -5], 2, 0));
/// assert_ne!(Cell::at([6, -10], 1, 0), Cell::at([3, -5], 1, 0));
/// ```
#[doc(alias = "LobeCell")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Cell {
    words: [u32; 4],
}

impl Cell {
    /// The cell of this index in the grid of cells of size $2^k$, `k` being `exponent`; `seed`
    /// tells surfaces apart.
    ///
    /// Indices have 32 bits or 64, as
    /// [`CoveredCell::index`](crate::material::glint::CoveredCell::index). Odd numbers beyond 32
    /// bits change the seed, by multiples of two odd constants for which no two cells of one size
    /// are equal that lie less than $2^{47}$ cells apart. Exponents beyond -300 to 300 are taken as
    /// those.
    #[doc(alias = "lobe_cell_at")]
    #[doc(alias = "lobe_cell_at_wide")]
    #[inline]
    pub fn at<I: Into<i64>>(index: [I; 2], exponent: i32, seed: u32) -> Self {
        let exponent = exponent.clamp(-300, 300);
        let [u, v] = index.map(|i| Center::of(i.into(), exponent));
        let exponents = (u.exponent as u32 & 0xffff) | ((v.exponent as u32) << 16);
        let far = u.more.wrapping_mul(FAR[0]).wrapping_add(v.more.wrapping_mul(FAR[1]));
        Self { words: hash([u.odd, v.odd, exponents, seed.wrapping_add(far)]) }
    }

    /// All of its words, for another model's purposes.
    #[inline]
    pub(in crate::material) const fn words(&self) -> [u32; 4] {
        self.words
    }

    /// Where the borders of its angular bins lie, in [0, 1) along each axis.
    #[doc(alias = "lobe_cell_jitter")]
    #[inline]
    pub fn jitter<R: Real>(&self) -> [R; 2] {
        [uniform(self.words[0]), uniform(self.words[1])]
    }

    /// How many details it has against the mean: a uniform number in (0, 1).
    #[doc(alias = "lobe_cell_size")]
    #[inline]
    pub fn size<R: Real>(&self) -> R {
        tail(self.words[2])
    }

    /// When it takes over from the cells of the next level, on the way to it: a uniform number in
    /// [0, 1).
    #[doc(alias = "lobe_cell_turn")]
    #[inline]
    pub fn turn<R: Real>(&self) -> R {
        uniform(self.words[3])
    }

    /// Its color: a uniform number in [0, 1).
    #[doc(alias = "lobe_cell_hue")]
    #[inline]
    pub fn hue<R: Real>(&self) -> R {
        let [a, b, ..] = self.words;
        uniform(hash([a, b, COLOR, COLOR])[3])
    }

    /// How many of its details reflect in an angular bin: a uniform number in (0, 1), the
    /// probability of more.
    #[doc(alias = "lobe_cell_count")]
    #[inline]
    pub fn count<R: Real>(&self, bin: [i32; 2]) -> R {
        let [a, b, ..] = self.words;
        // The last word, which all others have been mixed into.
        tail(hash([a, b, bin[0] as u32, bin[1] as u32])[3])
    }
}

/// An index times $2^k$ as an odd number and a power of two; 0 is its own place on every level.
#[derive(Clone, Copy)]
struct Center {
    /// The odd number's lower word, which has its sign.
    odd: u32,
    /// The odd number less `odd` (as a signed number), in units of $2^{32}$: 0 if the number has 32
    /// bits.
    more: u32,
    exponent: i32,
}

impl Center {
    #[inline]
    fn of(index: i64, exponent: i32) -> Self {
        if index == 0 {
            return Self { odd: 0, more: 0, exponent: -0x4000 };
        }
        // Most indices have 32 bits, which cost less.
        let low = index as i32;
        if i64::from(low) == index {
            let few = low.trailing_zeros();
            return Self { odd: (low >> few) as u32, more: 0, exponent: exponent + few as i32 };
        }
        let zeros = index.trailing_zeros();
        let number = index >> zeros;
        let odd = number as u32;
        let more = ((number >> 32) as u32).wrapping_add(odd >> 31);
        Self { odd, more, exponent: exponent + zeros as i32 }
    }
}

#[cfg(test)]
mod tests {
    use super::{Cell, FAR};

    /// Every byte of every word is uniform at every level, in tiles near and far: models cut
    /// channels of them where they like (law C15). Chi-squared of 255 degrees, at most 1.3 per
    /// degree over a square of cells, which chance exceeds once in a thousand times.
    #[test]
    fn every_byte_is_uniform_at_every_level() {
        let (mut worst, mut above, mut count) = (0.0_f64, 0, 0);
        for exponent in [-100, -24, -16, -12, -8, -5, -3, -2, -1, 0, 1, 7, 100] {
            for corner in
                [[-64, -64], [1000, 77], [-300_000, 500_001], [1_i64 << 40, -(3 << 45) - 64]]
            {
                let mut bins = [[0_u32; 256]; 16];
                for k in 0..128 * 128 {
                    let index = [corner[0] + k % 128, corner[1] + k / 128];
                    let words = Cell::at(index, exponent, 0).words();
                    for (byte, bins) in
                        words.iter().flat_map(|word| word.to_le_bytes()).zip(&mut bins)
                    {
                        bins[usize::from(byte)] += 1;
                    }
                }
                for bins in bins {
                    let expected = f64::from(128 * 128) / 256.0;
                    let terms = bins.map(|n| (f64::from(n) - expected).powi(2) / expected);
                    let chi = terms.iter().sum::<f64>() / 255.0;
                    (worst, count) = (worst.max(chi), count + 1);
                    above += u32::from(chi > 1.3);
                }
            }
        }
        // 832 of them: the largest is expected at 3.3 deviations of 0.0886.
        assert!(worst < 1.4 && above <= 4, "{worst}, {above} of {count} above 1.3");
    }

    /// No pair of multiples below 2^15 adds 0 to the seed, but for the pair of zeros: cells of
    /// equal words lie 2^47 cells apart.
    #[test]
    fn no_short_pair_of_multiples_cancels() {
        // An odd number's inverse by Newton's rule, each step of which doubles the right bits,
        // three at first.
        let inverse =
            (0..4).fold(FAR[1], |x, _| x.wrapping_mul(2_u32.wrapping_sub(FAR[1].wrapping_mul(x))));
        assert_eq!(inverse.wrapping_mul(FAR[1]), 1);
        let other = |u: u32| u.wrapping_mul(FAR[0]).wrapping_mul(inverse).wrapping_neg() as i32;
        assert_eq!(other(7843), 47_809);
        for u in 1..=40_000 {
            assert!(other(u).unsigned_abs() > 1 << 15, "{u} and {}", other(u));
        }
    }

    /// Halves of words that make two marginals are no kin, nor are a cell's and its neighbors'.
    #[test]
    fn halves_of_words_are_independent() {
        let half = |x: i64, y: i64, k: usize| {
            let word = Cell::at([x, y], -7, 3).words()[k / 2];
            f64::from(word >> (16 * (k % 2)) & 0xffff) / 65_536.0 - 0.5
        };
        let count = 128 * 128_i64;
        let limit = 5.0 / (count as f64).sqrt();
        for a in 0..8 {
            for b in 0..8 {
                // The last two have equal odd numbers of 32 bits, and differ in their multiples of
                // 2^32.
                for [x, y] in [
                    [0, 0],
                    [1, 0],
                    [0, 1],
                    [1, 1],
                    [2, 0],
                    [0, 4],
                    [64, 64],
                    [1 << 32, 0],
                    [3 << 33, -1 << 32],
                ] {
                    if a == b && x == 0 && y == 0 {
                        continue;
                    }
                    let sum: f64 = (0..count)
                        .map(|k| half(k % 128, k / 128, a) * half(k % 128 + x, k / 128 + y, b))
                        .sum();
                    let r = 12.0 * sum / count as f64;
                    assert!(r.abs() < limit, "halves {a} and {b}, {x} {y}: {r}");
                }
            }
        }
    }
}
