//! Errors of Zirr & Kaplanyan 2016, Listing 1: the printed line fails, ours holds. (Eq. 6 stands in
//! errata.rs, and what only their shader has in zirr_kaplanyan.rs.)
#![cfg(feature = "glint")]

use lobe::material::cells::{Cell, Patch};
use lobe::material::glint::{Binomial, Biscale, Glints, Grid};
use std::collections::HashSet;

/// Line 12 shifts the half vector by m0 = D_l(0) times a random number: a density, where a width is
/// meant. Rough details have a small one, and then the borders of all cells' bins nearly fall
/// together.
#[test]
fn zirr_2016_listing_1_line_12_shifts_bins_by_a_density() {
    let alpha = 1.5;
    let (width, density) = (alpha, 1.0 / (core::f64::consts::PI * alpha * alpha));
    // Of 1000 cells: how many have a border between two half vectors a fifth of a bin apart?
    let crossed = |shift: &dyn Fn(f64) -> f64| {
        let cells = (0..1000).map(|k| Cell::at([k, 7 - k], 0, 0).jitter::<f64>()[0]);
        let bin = |q: f64, random: f64| ((q + shift(random)) / width).floor();
        cells.filter(|random| bin(0.3, *random) != bin(0.3 + 0.2 * width, *random)).count()
    };
    let printed = crossed(&|random| density * random);
    let ours = crossed(&|random| width * random);
    assert_eq!(printed, 0, "{printed} of 1000 cells have a border there");
    assert!((ours as f64 - 200.0).abs() < 60.0, "{ours} of 1000 cells have a border there");
}

/// Lines 16 and 18 take the same random number for a cell's size and for its count: large cells
/// then always have many reflecting details, and the mean is not P: here 8 % below it.
#[test]
fn zirr_2016_listing_1_draws_size_and_count_of_one_number() {
    let (n, p, deviation) = (3.0, 0.05, 0.5);
    let mean = |size: &dyn Fn(f64, f64) -> f64| {
        let (mut sum, count) = (0.0, 200_000);
        for k in 0..count {
            let cell = Cell::at([k, 1], 0, 0);
            let (u, other) = (cell.count::<f64>([0, 0]), cell.size::<f64>());
            let details = (n * size(u, other)).max(1.0);
            sum += Binomial::new(details, p).draw(1.0 - u) / details;
        }
        sum / f64::from(count) / p
    };
    // |1 + V z| with z of a uniform number, by the triangle's quantile: any spread shows it.
    let spread = |u: f64| 1.0 + deviation * (2.0 * u - 1.0) * 3.0_f64.sqrt();
    let printed = mean(&|u, _| spread(u).abs());
    let ours = mean(&|_, other| spread(other).abs());
    assert!((ours - 1.0).abs() < 0.02, "{ours}");
    assert!((printed - 0.92).abs() < 0.02, "{printed}");
}

/// Line 24 adds all cells with weights that sum to the pixel's length in cells; the text divides by
/// them.
#[test]
fn zirr_2016_listing_1_line_24_misses_the_sum_of_weights() {
    for length in [1.0_f64, 4.0, 16.0] {
        let patch = Patch::new([0.3, 0.4], [1.0, 0.0], [0.0, length]);
        let mut ours = 0.0;
        Grid::new(&patch, 1e-9).visit(|cell| ours += cell.share);
        assert!((ours - 1.0).abs() < 1e-12);
        // Bilinear weights of cells of size 1, as printed: of each column 1, but for the overlap at
        // both ends.
        let half = 0.5 * (length - 1.0);
        let (begin, end) = (0.4 - half, 0.4 + half);
        let columns = (-20..=20).map(f64::from);
        let weight =
            |a: f64| (1.0 - (begin - a).max(0.0)).max(0.0) * (1.0 - (a - end).max(0.0)).max(0.0);
        let printed: f64 = columns.map(weight).sum();
        assert!((printed - length).abs() < 1e-12, "{length}: {printed}");
    }
    let biscale = Biscale::from_fractions([0.5, 0.5], [0.2, 0.2]).expect("in range");
    let glints = Glints::new(biscale, 1e9).expect("in range");
    let long = glints.ndf(&Patch::new([0.3, 0.4], [1.0, 0.0], [0.0, 16.0]));
    let whole: f64 = long.sparkle([0.0, 0.0, 1.0], 0.0);
    assert!((whole - 1.0).abs() < 0.01, "{whole}");
}

/// Section 4.1 shifts each index by its own trailing zeros: three of four cells around the origin
/// are copies of others.
#[test]
fn zirr_2016_section_4_1_repeats_cells() {
    let shifted = |i: i32| if i == 0 { 0 } else { i >> i.trailing_zeros() };
    let (mut printed, mut ours) = (HashSet::new(), HashSet::new());
    for x in 0..256 {
        for y in 0..256 {
            printed.insert([shifted(x), shifted(y)]);
            ours.insert(Cell::at([x, y], -3, 0));
        }
    }
    assert_eq!(ours.len(), 65536);
    assert!((printed.len() as f64 / 65536.0 - 0.25).abs() < 0.01, "{}", printed.len());
}
