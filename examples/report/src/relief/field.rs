//! A periodic random height field of Gaussian slopes: the relief at unit deviation.

use std::f64::consts::TAU;

use rayon::prelude::*;

use crate::pattern::Jitter;

/// Heights at the corners of square cells of side 1, periodic, and a facet pair in every cell.
///
/// A sum of plane waves at random phases with a Gaussian spectrum, so heights and their differences
/// are Gaussian. Two triangles fill a cell, their common edge turned from cell to cell: their
/// slopes are differences of heights, Gaussian as well, and a ray meets them without any search.
/// Both deviations of the slopes are 1.
pub(super) struct Field {
    /// Cells along each side: a power of two.
    side: usize,
    /// Rows of corners.
    heights: Vec<f32>,
    /// Greatest heights of blocks of $2^l \times 2^l$ cells, level by level; one block at the last.
    tops: Vec<Vec<f32>>,
    lowest: f64,
}

/// The plane of a facet: height at a corner of its cell, as seen from there, and slope.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facet {
    pub(super) height: f64,
    pub(super) slope: [f64; 2],
}

/// Cells per wave, at least: facets then bend little from one to the next.
const PER_WAVE: usize = 10;

/// Where the spectrum ends, in deviations of it.
const REACH: f64 = 3.0;

impl Field {
    /// The field of a seed, `side` a power of two.
    pub(super) fn new(side: usize, seed: u64) -> Self {
        let waves = waves(side, seed);
        let scale = 1.0 / deviation(side, &waves);
        let heights: Vec<f32> = waves.into_iter().map(|h| (scale * h) as f32).collect();
        let lowest = heights.iter().copied().fold(f32::INFINITY, f32::min).into();
        let tops = tops(side, &heights);
        Self { side, heights, tops, lowest }
    }

    pub(super) fn side(&self) -> usize {
        self.side
    }

    /// Number of levels of [`Field::top`].
    pub(super) fn levels(&self) -> usize {
        self.tops.len()
    }

    /// No part of the field is higher.
    pub(super) fn highest(&self) -> f64 {
        self.top(self.levels() - 1, [0, 0])
    }

    /// No part of the field is lower.
    pub(super) fn lowest(&self) -> f64 {
        self.lowest
    }

    /// Greatest height of the block of $2^l \times 2^l$ cells that holds a cell.
    #[inline]
    pub(super) fn top(&self, level: usize, cell: [i64; 2]) -> f64 {
        let [x, y] = cell.map(|c| self.wrapped(c) >> level);
        self.tops[level][y * (self.side >> level) + x].into()
    }

    /// Facets of a cell: below and above the edge between them, which falls where [`Field::falls`]
    /// and else rises.
    #[inline]
    pub(super) fn facets(&self, cell: [i64; 2]) -> [Facet; 2] {
        let corner = |x: i64, y: i64| self.corner([cell[0] + x, cell[1] + y]);
        let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)];
        if Self::falls(cell) {
            let upper = [d - c, d - b];
            [
                Facet { height: a, slope: [b - a, c - a] },
                Facet { height: d - upper[0] - upper[1], slope: upper },
            ]
        } else {
            [Facet { height: a, slope: [b - a, d - b] }, Facet { height: a, slope: [d - c, c - a] }]
        }
    }

    /// Whether the facets' common edge runs from a cell's left upper to its right lower corner.
    #[inline]
    pub(super) fn falls(cell: [i64; 2]) -> bool {
        (cell[0] + cell[1]) & 1 == 0
    }

    #[inline]
    fn corner(&self, at: [i64; 2]) -> f64 {
        let [x, y] = at.map(|c| self.wrapped(c));
        self.heights[y * self.side + x].into()
    }

    /// A coordinate within the period.
    #[inline]
    fn wrapped(&self, c: i64) -> usize {
        // The mask leaves no sign.
        #[allow(clippy::cast_sign_loss)]
        let c = c as usize;
        c & (self.side - 1)
    }
}

/// Heights at all corners, at no particular scale.
fn waves(side: usize, seed: u64) -> Vec<f64> {
    let whole = |count: usize| i32::try_from(count).unwrap_or(i32::MAX);
    let (most, period) = (whole(side / PER_WAVE), whole(side));
    let spread = f64::from(most) / REACH;
    let turns: Vec<_> = (0..side).map(|k| (TAU * k as f64 / side as f64).sin_cos()).collect();
    // The point of the unit circle at a multiple of a step, whatever its sign.
    let turn = |multiple: i32, step: usize| {
        let multiple = multiple.rem_euclid(period).unsigned_abs() as usize;
        turns[multiple * step % side]
    };
    // Waves along x for each wave number along y; half of the plane, as the other half is its
    // conjugate.
    let rows: Vec<Vec<[f64; 2]>> = (0..=most)
        .into_par_iter()
        .map(|ky| {
            let mut jitter = Jitter::new(seed << 32 | u64::from(ky.unsigned_abs()));
            let mut row = vec![[0.0; 2]; side];
            for kx in -most..=most {
                let phase = TAU * jitter.next()[0];
                let square = f64::from(kx * kx + ky * ky);
                let kept = square <= f64::from(most * most) && (ky > 0 || kx > 0);
                if !kept {
                    continue;
                }
                let amplitude = (-square / (4.0 * spread * spread)).exp();
                let (re, im) = (amplitude * phase.cos(), amplitude * phase.sin());
                for (x, sum) in row.iter_mut().enumerate() {
                    let (sin, cos) = turn(kx, x);
                    *sum = [sum[0] + re * cos - im * sin, sum[1] + re * sin + im * cos];
                }
            }
            row
        })
        .collect();
    let mut heights = vec![0.0; side * side];
    heights.par_chunks_mut(side).enumerate().for_each(|(y, line)| {
        for (ky, row) in (0..=most).zip(&rows) {
            let (sin, cos) = turn(ky, y);
            for (h, [re, im]) in line.iter_mut().zip(row) {
                *h += cos * re - sin * im;
            }
        }
    });
    heights
}

/// Root-mean-square difference of neighbors, over both axes: the waves make them alike but for
/// chance.
fn deviation(side: usize, heights: &[f64]) -> f64 {
    let mut sum = 0.0;
    for y in 0..side {
        for x in 0..side {
            let here = heights[y * side + x];
            let right = heights[y * side + (x + 1) % side];
            let above = heights[(y + 1) % side * side + x];
            sum += (right - here).powi(2) + (above - here).powi(2);
        }
    }
    (sum / (2 * side * side) as f64).sqrt()
}

/// Greatest heights, level by level.
fn tops(side: usize, heights: &[f32]) -> Vec<Vec<f32>> {
    let at = |x: usize, y: usize| heights[y % side * side + x % side];
    let greatest = |four: [f32; 4]| four.into_iter().fold(f32::NEG_INFINITY, f32::max);
    let cells = (0..side * side).map(|index| {
        let (x, y) = (index % side, index / side);
        greatest([at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)])
    });
    let mut levels: Vec<Vec<f32>> = vec![cells.collect()];
    let mut width = side;
    while let Some(last) = levels.last().filter(|_| width > 1) {
        let half = width / 2;
        let blocks = (0..half * half).map(|index| {
            let first = index / half * 2 * width + index % half * 2;
            greatest([last[first], last[first + 1], last[first + width], last[first + width + 1]])
        });
        let blocks = blocks.collect();
        levels.push(blocks);
        width = half;
    }
    levels
}

#[cfg(test)]
mod tests {
    use super::Field;

    /// Mean over all facets of a function of their slopes.
    fn mean(field: &Field, of: impl Fn([f64; 2]) -> f64) -> f64 {
        let side = i64::try_from(field.side()).unwrap();
        let cells = (0..side).flat_map(|y| (0..side).map(move |x| [x, y]));
        let sum: f64 = cells.flat_map(|c| field.facets(c)).map(|facet| of(facet.slope)).sum();
        sum / (2 * side * side) as f64
    }

    #[test]
    fn slopes_are_gaussian_of_unit_deviation_on_both_axes() {
        let field = Field::new(512, 1);
        // About 20 correlation lengths squared of independent slopes: (512 / 7)^2, that is 5000 of
        // them.
        let error = 1.0 / 5000.0_f64.sqrt();
        for axis in [0, 1] {
            let moment = |power: i32| mean(&field, |s| s[axis].powi(power));
            assert!(moment(1).abs() < 1e-6, "a period has no slope of its own");
            // Variance, skewness and kurtosis of samples have variances 2/n, 6/n and 24/n.
            assert!((moment(2) - 1.0).abs() < 4.0 * 2.0_f64.sqrt() * error, "{}", moment(2));
            assert!(moment(3).abs() < 4.0 * 6.0_f64.sqrt() * error, "{}", moment(3));
            assert!((moment(4) - 3.0).abs() < 4.0 * 24.0_f64.sqrt() * error, "{}", moment(4));
        }
        assert!((mean(&field, |s| s[0] * s[0] + s[1] * s[1]) - 2.0).abs() < 1e-5);
        assert!(mean(&field, |s| s[0] * s[1]).abs() < 4.0 * error);
        // In four parts of the plane of slopes as many as erf says.
        let within = mean(&field, |s| f64::from(u8::from(s[0].abs() < 1.0)));
        assert!((within - 0.6827).abs() < 4.0 * 0.5 * error, "{within}");
    }

    #[test]
    fn facets_meet_the_corners_and_blocks_cover_their_cells() {
        let field = Field::new(64, 2);
        for cell in [[0, 0], [63, 5], [-1, 130]] {
            let [below, above] = field.facets(cell);
            let at = |f: super::Facet, u: f64, v: f64| f.height + f.slope[0] * u + f.slope[1] * v;
            let shared = if Field::falls(cell) {
                [[1.0, 0.0], [0.0, 1.0]]
            } else {
                [[0.0, 0.0], [1.0, 1.0]]
            };
            for [u, v] in shared {
                assert!((at(below, u, v) - at(above, u, v)).abs() < 1e-12);
            }
            let [x, y] = cell;
            let corner = field.facets([x + 1, y + 1])[0].height;
            let other = if Field::falls([x + 1, y + 1]) { at(above, 1.0, 1.0) } else { corner };
            assert!((corner - other).abs() < 1e-6);
            for level in 1..field.levels() {
                assert!(field.top(level, cell) >= field.top(level - 1, cell));
            }
        }
        assert!(field.highest() > 0.0 && field.lowest() < 0.0);
    }

    #[test]
    fn seeds_give_different_fields_and_one_seed_the_same() {
        let [a, b, c] = [1, 1, 2].map(|seed| Field::new(32, seed).facets([3, 4])[0].slope);
        assert!(a == b && a != c);
    }
}
