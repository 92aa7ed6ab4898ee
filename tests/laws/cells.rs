//! Cells of nested grids: one identity for each place, and random numbers that are (laws Z3, Z12;
//! the hash at every level).
#![cfg(feature = "glint")]
#![allow(clippy::cast_sign_loss, reason = "places of an array are not negative")]
#![allow(clippy::needless_range_loop, reason = "channels are a column of the cells")]

use crate::common::{check, ensure};
use lobe::material::cells::Cell;
use std::collections::HashSet;

/// Levels from far below to far above a texture.
const LEVELS: [i32; 13] = [-100, -24, -16, -12, -8, -5, -3, -2, -1, 0, 1, 7, 100];

#[test]
fn the_same_place_has_the_same_numbers_on_every_level() {
    check(20_000, |source| {
        let index = [0, 1].map(|_| source.pick(1 << 20) as i32 - (1 << 19));
        let (exponent, seed) = (source.pick(200) as i32 - 100, source.pick(1 << 32) as u32);
        let finer = Cell::at(index.map(|i| 2 * i), exponent - 1, seed);
        ensure(finer == Cell::at(index, exponent, seed), "differs", &(index, exponent))
    });
}

/// No two centers of a level share their numbers, nor two of different levels that are different
/// places.
#[test]
fn different_places_have_different_numbers() {
    for exponent in LEVELS {
        let mut seen = HashSet::new();
        for x in -128..128 {
            for y in -128..128 {
                seen.insert(Cell::at([x, y], exponent, 0));
            }
        }
        assert_eq!(seen.len(), 256 * 256, "level {exponent}");
        // Of the next finer level three in four are new.
        let before = seen.len();
        for x in -127..127 {
            for y in -127..127 {
                seen.insert(Cell::at([x, y], exponent - 1, 0));
            }
        }
        let odd = (-127..127).filter(|x| x % 2 != 0).count();
        let new = 254 * 254 - (254 - odd) * (254 - odd);
        assert_eq!(seen.len() - before, new, "below level {exponent}");
    }
}

#[test]
fn the_seed_tells_surfaces_apart() {
    let cells: HashSet<Cell> = (0..10_000).map(|seed| Cell::at([3, 5], 0, seed)).collect();
    assert_eq!(cells.len(), 10_000);
}

#[test]
fn exponents_end_at_300() {
    assert_eq!(Cell::at([3, 5], 400, 0), Cell::at([3, 5], 300, 0));
    assert_eq!(Cell::at([3, i32::MIN], i32::MIN, 7), Cell::at([3, i32::MIN], -300, 7));
}

/// The channels of a cell, and its counts in some bins, as uniform numbers.
fn channels(cell: Cell) -> [f64; CHANNELS] {
    let [a, b] = cell.jitter();
    let [c, d, e, f] = [[0, 0], [1, 0], [0, 1], [-7, 12]].map(|bin| cell.count(bin));
    [a, b, cell.size(), cell.turn(), cell.hue(), c, d, e, f]
}

const CHANNELS: usize = 9;

/// A square of 128 x 128 cells away from the origin and one around it: every channel at each of
/// them.
fn square(level: i32, corner: [i32; 2]) -> Vec<[f64; CHANNELS]> {
    let cells = (0..128)
        .flat_map(|y| (0..128).map(move |x| Cell::at([corner[0] + x, corner[1] + y], level, 0)));
    cells.map(channels).collect()
}

const CORNERS: [[i32; 2]; 3] = [[-64, -64], [1000, 77], [-300_000, 500_001]];

/// Chi-squared over 64 bins: its mean is 63 and its deviation 11.2, so 120 is five deviations.
#[test]
fn every_channel_is_uniform_at_every_level() {
    everywhere(|cells, place| {
        for channel in 0..CHANNELS {
            let mut counts = [0.0; 64];
            for cell in cells {
                assert!((0.0..1.0).contains(&cell[channel]));
                counts[(cell[channel] * 64.0) as usize] += 1.0;
            }
            let expected = cells.len() as f64 / 64.0;
            let chi: f64 = counts.iter().map(|n| (n - expected) * (n - expected) / expected).sum();
            assert!(chi < 120.0, "{place}, channel {channel}: {chi}");
        }
    });
}

/// Of n independent pairs the correlation is within five deviations of 0.
#[track_caller]
fn uncorrelated(pairs: impl Iterator<Item = (f64, f64)>, place: &str) {
    let (mut count, mut sums) = (0.0_f64, [0.0; 5]);
    for (a, b) in pairs {
        count += 1.0;
        for (sum, x) in sums.iter_mut().zip([a, b, a * a, b * b, a * b]) {
            *sum += x;
        }
    }
    let [a, b, aa, bb, ab] = sums.map(|sum| sum / count);
    let r = (ab - a * b) / ((aa - a * a) * (bb - b * b)).sqrt();
    assert!(r.abs() < 5.0 / count.sqrt(), "{place}: {r}");
}

/// Calls `f` with every square on every level, and its name.
fn everywhere(f: impl Fn(&[[f64; CHANNELS]], &str)) {
    for level in LEVELS {
        for corner in CORNERS {
            f(&square(level, corner), &format!("level {level}, {corner:?}"));
        }
    }
}

#[test]
fn channels_are_kept_apart() {
    everywhere(|cells, place| {
        for a in 0..CHANNELS {
            for b in 0..a {
                let pairs = cells.iter().map(|cell| (cell[a], cell[b]));
                uncorrelated(pairs, &format!("{place}, channels {a} and {b}"));
            }
        }
    });
}

#[test]
fn neighbors_are_independent_at_every_level() {
    everywhere(|cells, place| {
        for channel in 0..CHANNELS {
            for [x, y] in [[1, 0], [0, 1], [1, 1], [1, -1], [2, 0], [0, 4], [8, 8]] {
                let at = |x: i32, y: i32| {
                    let inside = (0..128).contains(&x) && (0..128).contains(&y);
                    inside.then(|| cells[(128 * y + x) as usize][channel])
                };
                let places = (0..128).flat_map(|v| (0..128).map(move |u| (u, v)));
                let pairs = places.filter_map(|(u, v)| Some((at(u, v)?, at(u + x, v + y)?)));
                uncorrelated(pairs, &format!("{place}, channel {channel}, step {x} {y}"));
            }
        }
    });
}

/// Bins of one cell: counts of a line of bins are as random as those of a line of cells.
#[test]
fn bins_are_independent() {
    let lines = (0..400).map(|k| {
        let cell = Cell::at([k, 3 * k + 1], -8, 0);
        (0..64).map(|bin| cell.count::<f64>([bin - 32, 5])).collect::<Vec<_>>()
    });
    let lines: Vec<Vec<f64>> = lines.collect();
    for step in [1, 2, 5] {
        let pairs = lines.iter().flat_map(|line| line.iter().zip(&line[step..]));
        uncorrelated(pairs.map(|(a, b)| (*a, *b)), &format!("step {step}"));
    }
}
