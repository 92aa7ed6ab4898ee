//! Dictionaries of marginals: their integrals, nesting, bias and variance, and how they are made
//! (laws C1, C2, and the figures of the specification).
#![cfg(feature = "glint")]

use crate::common::marginals::{all, integral, small};
use lobe::material::multilobe::{Dictionary, LobeMeans, Recipe};

/// Law C1: every density integrates to 1, is even and not negative; in f32 to 1e-6.
#[test]
fn every_marginal_is_a_density() {
    for means in [LobeMeans::Stratified, LobeMeans::Chermain] {
        for (i, level, marginal) in all(&small(means)) {
            let whole = integral(|x| marginal.density(x), 64);
            assert!((whole - 1.0).abs() < 1e-12, "{i} {level}: {whole}");
            for k in 0..=500 {
                let x = 0.01 * f64::from(k);
                let p = marginal.density(x);
                assert!(p >= 0.0 && p == marginal.density(-x) && (x <= 4.0 || p == 0.0));
            }
        }
    }
    let single = Dictionary::<f32>::new(&Recipe::default()).expect("valid");
    for table in single.nodes().chunks_exact(65) {
        let inner: f64 = table.iter().map(|node| f64::from(node[0])).sum();
        let ends = 0.5 * (f64::from(table[0][0]) + f64::from(table[64][0]));
        let half = (inner - ends) / 16.0;
        assert!((2.0 * half - 1.0).abs() < 1e-6, "{half}");
        assert!(table.is_sorted_by(|a, b| a[1] <= b[1]) && table[64][1] == 0.5);
    }
}

/// Law C2: level L has the first lobes of all that come after it: the same table, whatever the last
/// level is.
#[test]
fn levels_are_nested() {
    let dictionary = small(LobeMeans::Stratified);
    for levels in [1, 4, 8] {
        let fewer = Recipe { levels, ..*dictionary.recipe() };
        let fewer = Dictionary::<f64>::new(&fewer).expect("valid");
        for (i, level, marginal) in all(&fewer) {
            assert_eq!(marginal, dictionary.marginal(i, level), "{i} {level} of {levels}");
        }
    }
    for (i, level, marginal) in all(&dictionary) {
        if level + 1 < dictionary.recipe().levels {
            let next = dictionary.marginal(i, level + 1);
            for k in 0..=64 {
                let x = f64::from(k) / 16.0;
                // Half of it is never more than the next; but tables are normalized each by itself:
                // a lobe that reaches past the end, or is cut by nodes, has another mass.
                assert!(2.0 * next.density(x) >= 0.97 * marginal.density(x), "{i} {level} {x}");
            }
        }
    }
}

/// The first level is one lobe and its mirror, of the width that was asked for; the second level
/// less half of that is another.
#[test]
fn levels_are_sums_of_lobes() {
    let dictionary = small(LobeMeans::Stratified);
    let width = dictionary.recipe().width;
    let pair = |x: f64, mean: f64| {
        let lobe = |d: f64| (-0.5 * d * d / (width * width)).exp();
        (lobe(x - mean) + lobe(x + mean)) / (2.0 * width * std::f64::consts::TAU.sqrt())
    };
    let mut means = Vec::new();
    for i in 0..24 {
        let [first, second] = [0, 1].map(|level| dictionary.marginal(i, level));
        let new = |x: f64| 2.0 * second.density(x) - first.density(x);
        let old = |x: f64| first.density(x);
        let both: [&dyn Fn(f64) -> f64; 2] = [&old, &new];
        for of in both {
            // Away from 0 and the end a lobe's own moment is its mean.
            let step = 1.0 / 16.0;
            let sum = |power: i32| -> f64 {
                (0..=64)
                    .map(|k| step * f64::from(k))
                    .map(|x| 2.0 * step * of(x) * x.powi(power))
                    .sum()
            };
            let (mass, mean) = (sum(0), sum(1));
            if mean > 0.3 && mean < 3.6 {
                assert!((mass - 1.0).abs() < 0.02, "{i}: {mass}");
                let mean = mean / mass;
                for k in 0..=64 {
                    let x = step * f64::from(k);
                    // Of lobes of 0.9 of an interval sums over nodes err by 2 %, of which means
                    // take their part.
                    let want = pair(x, mean);
                    assert!(
                        (of(x) - want).abs() < 0.05 * pair(mean, mean),
                        "{i} at {x}: {}, want {want}",
                        of(x)
                    );
                }
                means.push(mean);
            }
        }
    }
    // Of 48 lobes some are too near to the ends.
    assert!(means.len() > 24, "{}", means.len());
    means.sort_by(f64::total_cmp);
    assert!(means.windows(2).all(|pair| pair[0] < pair[1]), "two lobes in one place");
}

/// The mean over marginals against the smooth lobe, with the figures stated: root mean square
/// within two deviations.
#[test]
fn the_mean_of_all_marginals_is_smooth() {
    let made = |means: LobeMeans| {
        Dictionary::<f64>::new(&Recipe { means, ..Recipe::default() }).expect("valid")
    };
    let error = |dictionary: &Dictionary<f64>, level: u32| {
        let squares = (0..200).map(|k| {
            let x = -2.0 + 0.02 * f64::from(k);
            let sum: f64 = (0..192).map(|i| dictionary.marginal(i, level).density(x)).sum();
            let smooth = (-0.5 * x * x).exp() / std::f64::consts::TAU.sqrt();
            (sum / 192.0 / smooth - 1.0).powi(2)
        });
        (squares.sum::<f64>() / 200.0).sqrt()
    };
    let levels = [0, 1, 2, 5, 8, 10];
    let [independent, stratified] = [LobeMeans::Chermain, LobeMeans::Stratified].map(|means| {
        let dictionary = made(means);
        levels.map(|level| error(&dictionary, level))
    });
    println!("independent {independent:?}\nstratified {stratified:?}");
    for (got, stated) in independent.iter().zip([0.21, 0.17, 0.09, 0.032, 0.014, 0.009]) {
        assert!(*got < 1.7 * stated && *got > stated / 1.7, "{got}, stated {stated}");
    }
    for (got, stated) in stratified.iter().zip([0.03, 0.018, 0.017, 0.007, 0.002, 0.001]) {
        assert!(*got < 1.1 * stated, "{got}, stated {stated}");
    }
}

/// Variance over all marginals: 1, and as published wider by the lobes' own.
#[test]
fn the_variance_is_that_of_the_whole() {
    for (means, excess) in [(LobeMeans::Stratified, 0.0), (LobeMeans::Chermain, 0.0032 + 0.00065)] {
        let recipe = Recipe { means, ..Recipe::default() };
        let dictionary = Dictionary::<f64>::new(&recipe).expect("valid");
        let level = recipe.levels - 1;
        let sum: f64 = (0..192)
            .map(|i| integral(|x| x * x * dictionary.marginal(i, level).density(x), 64))
            .sum();
        // Nodes alone lack what the lines between them have.
        let variance = sum / 192.0 + 1.0 / (16.0 * 16.0 * 6.0);
        // Cut at 4 deviations: 8 times the normal density there less. Independent lobes vary: six
        // million of them, in pairs.
        let want = 1.0 + excess - 8.0 * 1.3383e-4;
        println!("{means:?}: {variance}");
        let spread = if means == LobeMeans::Stratified { 2e-4 } else { 3.0 * 5.7e-4 };
        assert!((variance - want).abs() < spread, "{means:?}: {variance}");
    }
}

/// A recipe gives equal bits every time, and another seed gives others. `cargo bench` prints how
/// long a dictionary takes.
#[test]
fn generation_is_deterministic() {
    let one = Dictionary::<f32>::new(&Recipe::default()).expect("valid");
    assert_eq!(one.bytes(), 192 * 16 * 65 * 8);
    assert_eq!(one, Dictionary::new(&Recipe::default()).expect("valid"));
    let other = Dictionary::<f32>::new(&Recipe { seed: 1, ..Recipe::default() }).expect("valid");
    assert_ne!(one, other);
}

#[test]
fn recipes_out_of_range_are_refused() {
    let good = Recipe { marginals: 2, levels: 2, ..Recipe::default() };
    assert!(Dictionary::<f32>::new(&good).is_ok());
    for bad in [
        (Recipe { marginals: 0, ..good }, "marginals = 0 is not in [1, 65536]"),
        (Recipe { marginals: 65_537, ..good }, "marginals = 65537 is not in [1, 65536]"),
        (Recipe { levels: 0, ..good }, "levels = 0 is not in [1, 20]"),
        (Recipe { levels: 21, ..good }, "levels = 21 is not in [1, 20]"),
        (Recipe { intervals: 4, ..good }, "intervals = 4 is not a power of two in [8, 4096]"),
        (Recipe { intervals: 65, ..good }, "intervals = 65 is not a power of two in [8, 4096]"),
        (Recipe { width: f64::NAN, ..good }, "width = NaN is not in [2/64, 0.5]"),
        (Recipe { width: 0.03, ..good }, "width = 0.03 is not in [2/64, 0.5]"),
        (Recipe { width: 0.6, ..good }, "width = 0.6 is not in [2/64, 0.5]"),
    ] {
        let error = Dictionary::<f32>::new(&bad.0).expect_err("out of range");
        assert_eq!(error.to_string(), bad.1, "{bad:?}");
    }
}
