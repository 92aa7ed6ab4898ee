//! Pixels by tile and fraction have the cells of the exact coordinate, and every tile has equal
//! statistics; plain coordinates of f32 keep their glints as far as the documentation says.
#![cfg(feature = "glint")]
#![allow(clippy::incompatible_msrv, reason = "tests need a newer compiler, for their oracles")]

use crate::common::arbitrary::Source;
use crate::common::facets::{dictionary, surface};
use crate::common::{check, ensure, near};
use lobe::Real;
use lobe::material::cells::{Cell, Patch};
use lobe::material::glint::{Biscale, CoveredCell, Glints, Grid};
use proptest::test_runner::TestCaseResult;
use std::collections::{HashMap, HashSet};

/// The cells of a pixel and their shares, of a size of at least `least`.
fn cells<R: Real>(patch: &Patch<R>, factors: [R; 2], least: f64) -> Vec<CoveredCell<R>> {
    let mut cells = Vec::new();
    Grid::stretched(patch, factors, R::lit(least)).visit(|cell| cells.push(cell));
    cells
}

/// Two pixels have shares of equal cells that differ by less than `tolerance`.
fn alike<R: Real>(
    one: &[CoveredCell<R>],
    other: &[CoveredCell<R>],
    tolerance: f64,
) -> TestCaseResult {
    let shares = |cells: &[CoveredCell<R>]| -> HashMap<_, _> {
        cells.iter().map(|cell| ((cell.index, cell.exponent), cell.share.to_f64())).collect()
    };
    let (one, other) = (shares(one), shares(other));
    for key in one.keys().chain(other.keys()) {
        let share = |of: &HashMap<_, f64>| of.get(key).copied().unwrap_or(0.0);
        near(share(&one), share(&other), tolerance, &(key, &one, &other))?;
    }
    Ok(())
}

/// A tile: near, far, or at the ends.
fn tile(source: &mut Source) -> [i32; 2] {
    [0, 1].map(|_| match source.pick(4) {
        0 => source.pick(9) as i32 - 4,
        1 => (source.pick(1 << 32) as u32).cast_signed() >> source.pick(32),
        2 => i32::MAX - source.pick(3) as i32,
        _ => i32::MIN + source.pick(3) as i32,
    })
}

/// A power of two.
fn two_to(k: i32) -> f64 {
    f64::powi(2.0, k)
}

/// A pixel whose sides are powers of two, square or long, so that no operation on its coordinates
/// rounds.
fn dyadic<R: Real>(source: &mut Source, size: i32, tile: [i32; 2], uv: [f64; 2]) -> Patch<R> {
    let (short, long) = (two_to(size), two_to(size + source.pick(4) as i32));
    let (right, up) = if source.pick(2) == 0 { (short, long) } else { (long, short) };
    let lit = |v: [f64; 2]| v.map(R::lit);
    Patch::in_tile(tile, lit(uv), lit([right, 0.0]), lit([0.0, up]))
}

fn plain_and_tiled_agree<R: Real>() {
    check(20_000, |source| {
        let tile = [0, 1].map(|_| source.pick(1 << 10) as i32 - (1 << 9));
        // From cells that plain coordinates of f32 resolve to cells larger than all of these tiles;
        // eighths of a cell.
        let size = source.pick(24) as i32 - 9;
        let bits = 6.max(3 - size);
        let uv = [0, 1].map(|_| source.pick(1 << bits) as f64 * two_to(-bits));
        let tiled = dyadic::<R>(source, size, tile, uv);
        let whole = [0, 1].map(|k| R::lit(f64::from(tile[k]) + uv[k]));
        let plain = Patch::new(whole, tiled.right, tiled.up);
        let [one, other] = [tiled, plain].map(|patch| cells(&patch, [R::ONE; 2], 1e-12));
        ensure(one == other, "cells differ", &(tiled, &one, &other))?;
        let biscale = Biscale::from_fractions([R::HALF; 2], [R::lit(0.1); 2]).expect("in range");
        let glints = Glints::new(biscale, R::ONE).expect("in range");
        let sparkle = |patch| glints.ndf(patch).sparkle([R::ZERO, R::ZERO, R::ONE], R::ZERO);
        ensure(sparkle(&tiled) == sparkle(&plain), "sparkles differ", &tiled)
    });
}

/// A place that a float holds has one set of cells, given either way.
#[test]
fn a_place_has_the_same_cells_as_a_plain_coordinate_and_in_a_tile() {
    plain_and_tiled_agree::<f32>();
    plain_and_tiled_agree::<f64>();
}

/// In f64 a pixel of any shape, size and turn has equal cells by plain coordinates and in a tile,
/// to 1e-9 of a share.
#[test]
fn any_pixel_has_the_same_cells_as_a_plain_coordinate_and_in_a_tile() {
    check(20_000, |source| {
        let tile = [0, 1].map(|_| source.pick(1 << 12) as i32 - (1 << 11));
        let uv = [source.uniform(-1.0, 2.0), source.uniform(-1.0, 2.0)];
        let size = source.log_uniform(1e-2, 1e5);
        let (right, up) = (source.vector(0.1 * size, size), source.vector(0.1 * size, size));
        let factors = match source.pick(3) {
            0 => [1.0, source.log_uniform(1e-2, 1.0)],
            1 => [source.uniform(0.0, 1.0), 1.0],
            _ => [1.0; 2],
        };
        let tiled = Patch::in_tile(tile, uv, right, up);
        let plain = Patch::new([0, 1].map(|k| f64::from(tile[k]) + uv[k]), right, up);
        // No smaller than plain coordinates resolve.
        let [one, other] = [tiled, plain].map(|patch| cells(&patch, factors, 0.01));
        alike(&one, &other, 1e-9)
    });
}

/// A tile is the first one moved: indices of cells that divide a tile move by whole tiles, shares
/// are equal to the bit.
fn tiles_are_the_first_one_moved<R: Real>() {
    check(20_000, |source| {
        let tile = tile(source);
        let uv = [0, 1].map(|_| R::lit(source.uniform(0.0, 1.0)));
        let size = source.log_uniform(two_to(-19), 0.5);
        let vector = |source: &mut Source| source.vector(0.3 * size, size).map(R::lit);
        let (right, up) = (vector(source), vector(source));
        // A cell's turn is its own, so shares differ from tile to tile; which cells a pixel covers
        // does not.
        let places = |tile: [i32; 2]| -> HashSet<_> {
            let cells = cells(&Patch::in_tile(tile, uv, right, up), [R::ONE; 2], 1e-12).into_iter();
            let moved = cells.map(|cell| {
                let index =
                    |k: usize| cell.index[k] - (i64::from(tile[k]) << -cell.exponent.min(0));
                ([index(0), index(1)], cell.exponent)
            });
            moved.filter(|(_, exponent)| *exponent <= 0).collect()
        };
        let (here, there) = (places([0; 2]), places(tile));
        ensure(here == there, "other cells", &(tile, uv, right, up, &here, &there))
    });
}

#[test]
fn far_tiles_have_as_sound_cells_as_the_first() {
    tiles_are_the_first_one_moved::<f32>();
    tiles_are_the_first_one_moved::<f64>();
}

/// A pixel on a border is one pixel, from whichever side it is given, and cells larger than tiles
/// know no border.
#[test]
fn a_border_is_seen_alike_from_both_sides() {
    check(20_000, |source| {
        let [s, t] = tile(source).map(|t| t.clamp(i32::MIN + 8, i32::MAX - 8));
        let step = source.pick(15) as i32 - 7;
        let uv = [0, 1].map(|_| source.pick(1 << 8) as f64 * two_to(-8));
        let size = source.pick(38) as i32 - 6;
        let here: Patch<f32> = dyadic(source, size, [s, t], uv);
        let there =
            Patch { tile: [s + step, t], uv: [here.uv[0] - step as f32, here.uv[1]], ..here };
        // A factor of 8 bits leaves products of coordinates exact.
        let factors = [1.0, (1 + source.pick(256)) as f32 / 256.0];
        let [one, other] = [here, there].map(|patch| cells(&patch, factors, 1e-12));
        alike(&one, &other, 1e-6)?;
        let [one, other] = [here, there].map(|patch| cells(&patch, [1.0; 2], 1e-12));
        // In cells larger than 2^16 tiles, f32 rounds where a pixel is to 2^-24 of a cell.
        if size <= 6 {
            ensure(one == other, "cells differ", &(here, there, &one, &other))?;
        }
        alike(&one, &other, 1e-6)?;
        let double = |patch: Patch<f32>| {
            let [uv, right, up] = [patch.uv, patch.right, patch.up].map(|v| v.map(f64::from));
            Patch::in_tile(patch.tile, uv, right, up)
        };
        let facets = surface(f64::max(3.0 * two_to(-2 * size), 1e-18), 7);
        let [one, other] = [here, there]
            .map(|patch| facets.ndf(dictionary(), &double(patch)).slope_pdf([0.1, 0.05]));
        near(one, other, 1e-9 * one, &(here, there))
    });
}

/// Across a border shares move by as little as the pixel, at any tile.
#[test]
fn shares_are_continuous_across_borders() {
    check(20_000, |source| {
        let [s, t] = tile(source).map(|t| t.clamp(i32::MIN + 8, i32::MAX - 8));
        let size = source.log_uniform(1e-3, 1e9);
        let (right, up) = (source.vector(0.5 * size, size), source.vector(0.5 * size, size));
        let v = source.uniform(0.0, 1.0);
        let step = 1e-9 * size.min(1.0);
        let below = Patch::in_tile([s, t], [1.0 - step, v], right, up);
        let above = Patch::in_tile([s + 1, t], [step, v], right, up);
        let [one, other] = [below, above].map(|patch| cells(&patch, [1.0; 2], 1e-12));
        alike(&one, &other, 1e-6)
    });
}

/// Indices of 64 bits: equal on all levels that have the place, different for any two.
#[test]
fn wide_cells_are_places() {
    let mut seen = HashSet::new();
    let mut count = 0;
    for seed in 0..200_000 {
        let mut source = Source::from_seed(seed);
        let mut index = || (source.pick(1 << 63).cast_signed() << 1) >> (2 + source.pick(61));
        let index = [index(), index()];
        let exponent = -(source.pick(31) as i32);
        let cell = Cell::at(index, exponent, 1);
        assert_eq!(cell, Cell::at(index.map(|i| 2 * i), exponent - 1, 1), "{index:?}");
        seen.insert(cell);
        count += usize::from(index.iter().all(|i| i.unsigned_abs() > 1 << 40));
        for k in 0..2 {
            let mut other = index;
            other[k] ^= 1 << source.pick(62);
            assert_ne!(cell, Cell::at(other, exponent, 1), "{index:?} and {other:?}");
        }
    }
    assert!(count > 10_000 && seen.len() > 199_000, "{count} of {}", seen.len());
}

/// Number, mean, deviation and the deviation's error of what `value` gives for places of a tile.
fn statistics(count: u32, value: impl Fn([f64; 2]) -> f64) -> (f64, f64, f64, f64) {
    let place = |seed: u32| {
        let mut source = Source::from_seed(seed.into());
        value([source.uniform(0.0, 1.0), source.uniform(0.0, 1.0)])
    };
    let values: Vec<f64> = (0..count).map(place).collect();
    let count = f64::from(count);
    let mean = values.iter().sum::<f64>() / count;
    let moment = |k| values.iter().map(|x| (x - mean).powi(k)).sum::<f64>() / count;
    let (second, fourth) = (moment(2), moment(4));
    (count, mean, second.sqrt(), 0.5 * ((fourth - second * second) / count / second).sqrt())
}

/// A pixel of width 1e-3 over five details, each of which reflects at the top with a probability of
/// 1/400, in f32.
fn sparkle(tile: [i32; 2], uv: [f64; 2]) -> f64 {
    sparkle_of([0.6, 0.6], tile, uv)
}

/// The sparkle of such a pixel with these alphas: details are stretched where they differ.
fn sparkle_of(alphas: [f32; 2], tile: [i32; 2], uv: [f64; 2]) -> f64 {
    let biscale = Biscale::from_fractions(alphas, [0.05; 2]).expect("in range");
    let glints = Glints::new(biscale, 5e6).expect("in range");
    let patch = Patch::in_tile(tile, uv.map(|x| x as f32), [1e-3, 0.0], [0.0, 1e-3]);
    f64::from(glints.ndf(&patch).sparkle([0.0, 0.0, 1.0], 0.0))
}

/// Mean 1 and one deviation, at any tile, of round details and of stretched ones.
#[test]
fn glints_are_as_bright_and_as_varied_in_any_tile() {
    let far = [[1, -1], [10_000, 3], [1_000_000, 1_000_000], [1 << 30, -(1 << 30)]];
    for alphas in [[0.6, 0.6], [0.6, 0.17]] {
        let (_, _, near, near_error) = statistics(30_000, |uv| sparkle_of(alphas, [0; 2], uv));
        for tile in far.into_iter().chain([[i32::MIN, i32::MAX]]) {
            let (count, mean, deviation, error) =
                statistics(30_000, |uv| sparkle_of(alphas, tile, uv));
            let off = (mean - 1.0) / (deviation / count.sqrt());
            assert!(off.abs() < 4.5, "{alphas:?} {tile:?}: mean {mean}, {off} deviations");
            let off = (deviation - near) / near_error.hypot(error);
            assert!(
                off.abs() < 4.5,
                "{alphas:?} {tile:?}: {deviation} for {near}, {off} deviations"
            );
        }
    }
}

/// Stretched details have shares in a far tile that a pixel in f64 has, to what rounding does to a
/// fraction of a cell.
#[test]
fn stretched_tiles_in_single_precision_are_those_in_double() {
    check(20_000, |source| {
        let tile = tile(source);
        // Numbers that both precisions hold, and cells of 2^-13 at least.
        let mut single = |low: f64, high: f64| f64::from(source.uniform(low, high) as f32);
        let (uv, factor) = ([single(0.0, 1.0), single(0.0, 1.0)], single(0.01, 1.0));
        let size = single(two_to(-12), two_to(-2));
        let double = Patch::in_tile(tile, uv, [size, 0.0], [0.0, 1.5 * size]);
        let lit = |v: [f64; 2]| v.map(|x| x as f32);
        let single = Patch::in_tile(tile, lit(uv), lit(double.right), lit(double.up));
        let (mut one, mut other) = (HashMap::new(), HashMap::new());
        Grid::stretched(&double, [factor, 1.0], 1e-12).visit(|cell| {
            one.insert((cell.index, cell.exponent), cell.share);
        });
        Grid::stretched(&single, [factor as f32, 1.0], 1e-12).visit(|cell| {
            other.insert((cell.index, cell.exponent), f64::from(cell.share));
        });
        for key in one.keys().chain(other.keys()) {
            let share = |of: &HashMap<_, f64>| of.get(key).copied().unwrap_or(0.0);
            // 2^-22 of a fraction is 2^-9 of the smallest cell, along each of two axes, of shares
            // up to 1 and their sum.
            near(share(&one), share(&other), two_to(-7), &(double, factor, key))?;
        }
        Ok(())
    });
}

/// Pixels smaller than indices of 64 bits can tell apart have cells of 2^-31 of a tile, but in the
/// first one.
#[test]
fn cells_end_where_indices_do() {
    let grid =
        |tile| Grid::new(&Patch::in_tile(tile, [0.0_f64; 2], [1e-15, 0.0], [0.0, 1e-15]), 0.0);
    assert_eq!(grid([0, 0]).exponent(), -50);
    for tile in [[0, 1], [i32::MIN, i32::MAX], [-1, 0]] {
        assert_eq!((grid(tile).exponent(), grid(tile).coarser()), (-31, 0.0));
        grid(tile).visit(|cell| {
            assert_eq!(cell.index, tile.map(|t| i64::from(t) << 31));
        });
    }
}

/// No tile repeats the first one: neither its neighbors nor tiles whose indices differ by multiples
/// of 2^32.
#[test]
fn tiles_are_independent() {
    // Cells of width 1e-3 are 2^-10 and 2^-9, so 2^22 tiles are 2^32 of the finer cells.
    let pairs = [
        [1, 0],
        [0, 1],
        [1 << 10, 0],
        [1 << 22, 0],
        [1 << 23, 0],
        [3 << 22, -(1 << 24)],
        [0, i32::MIN],
    ];
    for [s, t] in pairs {
        let (_, mean, deviation, _) = statistics(20_000, |uv| sparkle([0; 2], uv));
        let (count, product, ..) =
            statistics(20_000, |uv| (sparkle([0; 2], uv) - mean) * (sparkle([s, t], uv) - mean));
        let correlation = product / (deviation * deviation);
        assert!(correlation.abs() < 5.0 / count.sqrt(), "tile {s} {t}: {correlation}");
    }
}

/// Many lobes have one mean density and one deviation in any tile, and tiles are independent.
#[test]
fn facets_are_as_bright_and_as_varied_in_any_tile() {
    let facets = surface(4e6, 3);
    let density = |tile: [i32; 2], uv: [f64; 2]| {
        let patch = Patch::in_tile(tile, uv, [1e-3, 0.0], [0.0, 1e-3]);
        facets.ndf(dictionary(), &patch).slope_pdf([0.1, 0.05])
    };
    let (count, mean, near, near_error) = statistics(20_000, |uv| density([0; 2], uv));
    for tile in [[1, -1], [1_000_000, 1_000_000], [1 << 30, -(1 << 30)], [1 << 22, 0]] {
        let (_, there, deviation, error) = statistics(20_000, |uv| density(tile, uv));
        let off = (there - mean) / (near.hypot(deviation) / count.sqrt());
        assert!(off.abs() < 4.5, "{tile:?}: mean {there} for {mean}");
        let off = (deviation - near) / near_error.hypot(error);
        assert!(off.abs() < 4.5, "{tile:?}: deviation {deviation} for {near}");
        let (_, product, ..) =
            statistics(20_000, |uv| (density([0; 2], uv) - mean) * (density(tile, uv) - mean));
        let correlation = product / (near * near);
        assert!(correlation.abs() < 5.0 / count.sqrt(), "{tile:?}: {correlation}");
    }
}

/// The limit that [`Patch::new`] states: up to 2^20 widths from the origin plain coordinates have
/// their glints; farther, cells grow with the distance, and the deviation falls like one over it.
#[test]
fn plain_coordinates_keep_their_glints_for_a_million_widths() {
    let plain = |distance: f64, uv: [f64; 2]| sparkle([0; 2], uv.map(|x| x + distance));
    let (_, _, near, near_error) = statistics(40_000, |uv| plain(0.0, uv));
    let limit = two_to(20) * 1e-3;
    for (distance, times) in [(0.9 * limit, 1.0), (4.0 * limit, 4.0), (10_000.0, 10_000.0 / limit)]
    {
        let (_, _, deviation, error) = statistics(40_000, |uv| plain(distance, uv));
        // Between two sizes a square pixel has 0.36 to 0.51 of its details' variance
        // (tests/laws/glints.rs), so deviations at two distances differ by a factor of up to 1.19.
        let ratio = deviation * times / near;
        let slack = 4.5 * (error * times).hypot(near_error) / near;
        assert!(
            (ratio - 1.0).abs() < 0.19 + slack,
            "at {distance}: {deviation} for {near} over {times}"
        );
    }
}
