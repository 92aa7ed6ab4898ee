//! Many lobes across scales: what a cell keeps of its finer one, how a pixel calms down, and that
//! no axis is special (laws C11, C14 and B2; C15, of the cells' numbers, is in tests/laws/cells.rs
//! and src/material/cells/cell.rs).
#![cfg(feature = "glint")]

use crate::common::arbitrary::Source;
use crate::common::facets::dictionary;
use lobe::Roughness;
use lobe::material::cells::{Cell, Patch};
use lobe::material::multilobe::{Dictionary, LobeMeans, MultiLobe, Recipe};
use std::f64::consts::TAU;

/// Mean and variance over the mean's square.
fn moments(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (mut count, mut sum, mut squares) = (0.0, 0.0, 0.0);
    for value in values {
        count += 1.0;
        sum += value;
        squares += value * value;
    }
    let mean = sum / count;
    (mean, squares / count / (mean * mean) - 1.0)
}

/// Law C11, with its figures: a coarse cell has the numbers of the finer one at its corner, and the
/// correlation of their densities falls as the coarse one gets four times the lobes from level to
/// level.
#[test]
fn a_coarse_cell_is_the_heir_of_a_finer_one() {
    for (s, t) in [(0, 0), (5, -3), (-7, 11), (1 << 19, 3)] {
        for k in 1..5 {
            assert_eq!(Cell::at([s, t], 3 + k, 9), Cell::at([s << k, t << k], 3, 9));
            assert_ne!(Cell::at([s, t], 3 + k, 9), Cell::at([(s << k) + 1, t << k], 3, 9));
        }
    }
    let recipe = Recipe { means: LobeMeans::Chermain, ..Recipe::default() };
    let dictionary = Dictionary::<f64>::new(&recipe).expect("valid");
    let density = |turn: f64, pair: [u32; 2], level: u32| {
        let (sin, cos) = turn.sin_cos();
        let at = |index: u32, x: f64| dictionary.marginal(index, level).density(0.79 * x);
        at(pair[0], cos) * at(pair[1], sin)
    };
    let correlation = |step: u32, same: bool| {
        let (mut x, mut y, mut xx, mut xy, mut yy, count) = (0.0, 0.0, 0.0, 0.0, 0.0, 60_000);
        for seed in 0..count {
            let mut source = Source::from_seed(seed);
            let mut cell = || {
                let turn = source.uniform(0.0, 0.25 * TAU);
                let pair = [0; 2].map(|_| source.pick(192) as u32);
                (turn, pair)
            };
            let fine = cell();
            let coarse = if same { fine } else { cell() };
            let a = density(fine.0, fine.1, 2);
            let b = density(coarse.0, coarse.1, 2 + step);
            (x, y) = (x + a, y + b);
            (xx, xy, yy) = (xx + a * a, xy + a * b, yy + b * b);
        }
        let n = count as f64;
        (n * xy - x * y) / ((n * xx - x * x) * (n * yy - y * y)).sqrt()
    };
    for (step, stated) in (1..).zip([0.65, 0.41, 0.27, 0.17]) {
        let (kin, strangers) = (correlation(step, true), correlation(step, false));
        println!("{step} levels up: {kin}, of strangers {strangers}, stated {stated}");
        assert!((kin - stated).abs() < 0.05, "{step}: {kin}, stated {stated}");
        // Five deviations of a correlation of 60,000 pairs with heavy tails.
        assert!(strangers.abs() < 0.02, "{step}: {strangers}");
    }
}

/// Law C14: a pixel a quarter turn around on the texture has the same mean and as much variance.
#[test]
fn a_quarter_turn_of_the_pixel_changes_no_statistics() {
    let roughness = Roughness::from_alpha(0.4).expect("in range");
    let facets =
        MultiLobe::new(roughness, 300.0).expect("in range").with_variation(0.0).expect("in range");
    let seen = |turned: bool| {
        moments((0..40_000).map(|k| {
            let mut source = Source::from_seed(k);
            let uv = [source.uniform(0.0, 500.0), source.uniform(0.0, 500.0)];
            let (long, short) = ([3.0, 1.0], [-0.3, 0.9]);
            let quarter = |[x, y]: [f64; 2]| if turned { [-y, x] } else { [x, y] };
            let patch = Patch::new(uv, quarter(long), quarter(short));
            facets.ndf(dictionary(), &patch).slope_pdf([0.2, 0.1])
        }))
    };
    let ((mean, variance), (turned_mean, turned)) = (seen(false), seen(true));
    println!("{mean} {variance}, turned {turned_mean} {turned}");
    // Deviations of a mean of 40,000 and of a variance, with tails as heavy as a few times it.
    let error = (variance / 40_000.0).sqrt();
    assert!((turned_mean / mean - 1.0).abs() < 6.0 * error, "{mean} {turned_mean}");
    assert!((turned / variance - 1.0).abs() < 0.08, "{variance} {turned}");
}

/// Relative variance over pixels of this width on a surface of 64 facets per unit of area, all
/// cells alike.
fn variance(size: f64, count: u64) -> f64 {
    let roughness = Roughness::from_alpha(0.4).expect("in range");
    let facets =
        MultiLobe::new(roughness, 64.0).expect("in range").with_variation(0.0).expect("in range");
    let pixels = (0..count).map(|k| {
        let mut source = Source::from_seed(k);
        let uv = [0; 2].map(|_| source.uniform(0.0, 500.0 * size));
        let patch = Patch::new(uv, [size, 0.0], [0.0, size]);
        facets.ndf(dictionary(), &patch).slope_pdf([0.2, 0.1])
    });
    let (mean, variance) = moments(pixels);
    println!("width {size:.2}: mean {mean}, variance {variance}");
    variance
}

/// Law B2: from octave to octave of a pixel's width its variance falls, and where there are many
/// facets to a half: products of marginals vary as $2^{-L}$, not as $4^{-L}$.
#[test]
fn growing_pixels_calm_down() {
    let variances: Vec<f64> =
        (0..9).map(|octave| variance(f64::from(1 << octave), 12_000)).collect();
    for pair in variances.windows(2) {
        assert!(pair[1] / pair[0] < 0.8, "{variances:?}");
    }
    for pair in variances[3..].windows(2) {
        assert!((0.4..0.62).contains(&(pair[1] / pair[0])), "{variances:?}");
    }
}

/// Within an octave it falls below its end, by 19 % of that, and rises again: a blend of two levels
/// varies less than either.
#[test]
fn between_levels_pixels_are_calmer() {
    for octave in [3, 5] {
        let widths = (0..9).map(|k| 2.0_f64.powf(f64::from(octave) + 0.125 * f64::from(k)));
        let variances: Vec<f64> = widths.map(|width| variance(width, 30_000)).collect();
        let lowest = variances.iter().copied().fold(f64::INFINITY, f64::min);
        let (first, last) = (variances[0], variances[8]);
        assert!(lowest < last && last < first, "{variances:?}");
        // Blends of two independent halves have half the variance; these are kin.
        assert!((0.75..0.87).contains(&(lowest / last)), "{variances:?}");
    }
}

/// Numbers between powers of 4, which levels have, are drawn of both sides: variance falls with
/// every one of them.
#[test]
fn any_number_of_facets_counts() {
    let roughness = Roughness::from_alpha(0.4).expect("in range");
    let variance = |density: f64| {
        let facets = MultiLobe::new(roughness, density).expect("in range");
        let facets = facets.with_variation(0.0).expect("in range");
        moments((0..20_000).map(|k| {
            let mut source = Source::from_seed(k);
            let uv = [0; 2].map(|_| source.uniform(0.0, 5000.0));
            let patch = Patch::new(uv, [8.0, 0.0], [0.0, 8.0]);
            facets.ndf(dictionary(), &patch).slope_pdf([0.2, 0.1])
        }))
        .1
    };
    let variances: Vec<_> =
        (0..9).map(|k| variance(64.0 * 2.0_f64.powf(0.25 * f64::from(k)))).collect();
    println!("{variances:?}");
    for pair in variances.windows(2) {
        // By the root of the number, in the mean over a power of 4.
        assert!((0.84..1.0).contains(&(pair[1] / pair[0])), "{variances:?}");
    }
}

/// Below the smallest cell nothing changes any more: all pixels within one facet's square see the
/// same lobes.
#[test]
fn close_up_there_are_no_more_facets() {
    let roughness = Roughness::from_alpha(0.4).expect("in range");
    let facets = MultiLobe::new(roughness, 1e4).expect("in range");
    assert_eq!(facets.facet_size(), 0.01);
    let at = |size: f64| {
        let patch = Patch::new([0.3, 0.4], [size, 0.0], [0.0, size]);
        facets.ndf(dictionary(), &patch)
    };
    let (limit, exponent) = (at(0.0), at(0.0).exponent());
    for k in 0..20 {
        let size = 0.01 * 0.7_f64.powi(k);
        assert_eq!(at(size).exponent(), exponent, "{size}");
        // Only the ellipse shrinks, to that of a cell.
        let near = at(1e-9 * size).slope_pdf([0.1, 0.2]);
        assert!((near - limit.slope_pdf([0.1, 0.2])).abs() <= 1e-6 * near);
    }
}
