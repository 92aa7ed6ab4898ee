//! Dictionaries of marginals: their integrals, nesting, bias, filters, cumulatives and bytes (laws C1, C2, C12 and the figures of
//! the specification).
#![cfg(feature = "glint")]

mod common;

use common::{check, ensure, near};
use lobe::Error;
use lobe::material::multilobe::{Dictionary, Marginal, Means, Recipe};
use std::time::Instant;

/// A small one with all that a large one has.
fn small(means: Means) -> Dictionary<f64> {
    Dictionary::new(&Recipe { marginals: 24, levels: 9, means, ..Recipe::default() })
        .expect("valid")
}

/// Integral by the trapezoid rule over the nodes, exact for what is linear between them.
fn integral(f: impl Fn(f64) -> f64, intervals: i32) -> f64 {
    let step = 4.0 / f64::from(intervals);
    let nodes = -intervals..=intervals;
    let inner: f64 = nodes.map(|k| f(f64::from(k) * step)).sum();
    step * (inner - 0.5 * (f(-4.0) + f(4.0)))
}

fn all(dictionary: &Dictionary<f64>) -> impl Iterator<Item = (u32, u32, Marginal<'_, f64>)> {
    let Recipe { marginals, levels, .. } = *dictionary.recipe();
    let pairs = (0..marginals).flat_map(move |i| (0..levels).map(move |level| (i, level)));
    pairs.map(|(i, level)| (i, level, dictionary.marginal(i, level)))
}

/// Law C1: every density integrates to 1, is even and not negative; in f32 to 1e-6.
#[test]
fn every_marginal_is_a_density() {
    for means in [Means::Stratified, Means::Published] {
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

/// Law C2: level L is the mean of level L - 1 and of as many new lobes, so half of it is never more than the next.
#[test]
fn levels_are_nested() {
    let dictionary = small(Means::Stratified);
    for (i, level, marginal) in all(&dictionary) {
        if level + 1 < dictionary.recipe().levels {
            let next = dictionary.marginal(i, level + 1);
            for k in 0..=64 {
                let x = f64::from(k) / 16.0;
                // Tables are normalised each by itself: a lobe that reaches past the end, or is cut by nodes, has another mass.
                assert!(2.0 * next.density(x) >= 0.97 * marginal.density(x), "{i} {level} {x}");
            }
        }
    }
}

/// The mean over marginals against the smooth lobe, with the figures stated: root mean square within two deviations.
#[test]
fn the_mean_of_all_marginals_is_smooth() {
    let error = |means: Means, level: u32| {
        let dictionary =
            Dictionary::<f64>::new(&Recipe { means, ..Recipe::default() }).expect("valid");
        let squares = (0..200).map(|k| {
            let x = -2.0 + 0.02 * f64::from(k);
            let sum: f64 = (0..192).map(|i| dictionary.marginal(i, level).density(x)).sum();
            let smooth = (-0.5 * x * x).exp() / std::f64::consts::TAU.sqrt();
            (sum / 192.0 / smooth - 1.0).powi(2)
        });
        (squares.sum::<f64>() / 200.0).sqrt()
    };
    let levels = [0, 1, 2, 5, 8, 10];
    let independent = levels.map(|level| error(Means::Published, level));
    let stratified = levels.map(|level| error(Means::Stratified, level));
    println!("independent {independent:?}\nstratified {stratified:?}");
    for (got, stated) in independent.iter().zip([0.21, 0.17, 0.09, 0.032, 0.014, 0.009]) {
        assert!(*got < 1.7 * stated && *got > stated / 1.7, "{got}, stated {stated}");
    }
    for (got, stated) in stratified.iter().zip([0.058, 0.018, 0.017, 0.007, 0.002, 0.001]) {
        assert!(*got < 1.7 * stated, "{got}, stated {stated}");
    }
}

/// Variance over all marginals: 1, and as published wider by the lobes' own.
#[test]
fn the_variance_is_that_of_the_whole() {
    for (means, excess) in [(Means::Stratified, 0.0), (Means::Published, 0.0032 + 0.00065)] {
        let recipe = Recipe { means, ..Recipe::default() };
        let dictionary = Dictionary::<f64>::new(&recipe).expect("valid");
        let level = recipe.levels - 1;
        let sum: f64 = (0..192)
            .map(|i| integral(|x| x * x * dictionary.marginal(i, level).density(x), 64))
            .sum();
        // Nodes alone lack what the lines between them have.
        let variance = sum / 192.0 + 1.0 / (16.0 * 16.0 * 6.0);
        // Cut at 4 deviations: 8 times the normal density there less. Independent lobes vary: six million of them, in pairs.
        let want = 1.0 + excess - 8.0 * 1.3383e-4;
        println!("{means:?}: {variance}");
        let spread = if means == Means::Stratified { 2e-4 } else { 3.0 * 5.7e-4 };
        assert!((variance - want).abs() < spread, "{means:?}: {variance}");
    }
}

/// Mean over a box, by pieces between all nodes and ends: an oracle that sums.
fn box_mean(marginal: &Marginal<'_, f64>, x: f64, width: f64) -> f64 {
    let (a, b) = (x - 0.5 * width, x + 0.5 * width);
    let mut ends = vec![a, b];
    ends.extend((-64..=64).map(|k| f64::from(k) / 16.0).filter(|node| *node > a && *node < b));
    ends.sort_by(f64::total_cmp);
    let piece = |w: &[f64]| (w[1] - w[0]) * marginal.density(0.5 * (w[0] + w[1]));
    ends.windows(2).map(piece).sum::<f64>() / width
}

/// Law C12: a box's mean is exact at any width, keeps the mass and adds the box's variance.
#[test]
fn boxes_are_exact() {
    let dictionary = small(Means::Stratified);
    let single = Dictionary::<f32>::new(dictionary.recipe()).expect("valid");
    check(20_000, |source| {
        let (i, level) = (source.pick(24) as u32, source.pick(9) as u32);
        let marginal = dictionary.marginal(i, level);
        let x = if source.pick(3) == 0 {
            f64::from(source.pick(80) as i32) / 16.0
        } else {
            source.uniform(-5.0, 5.0)
        };
        let width = source.log_uniform(1e-6, 12.0);
        let (got, want) = (marginal.mean(x, width), box_mean(&marginal, x, width));
        near(got, want, 1e-9 * want + 1e-9, &(i, level, x, width))?;
        near(marginal.mean(-x, width), got, 1e-13, &(i, level, x, width))?;
        let single = f64::from(single.marginal(i, level).mean(x as f32, width as f32));
        // Densities change by up to 140 a deviation.
        near(single, want, 2e-4 + 2e-5 * want, &(i, level, x, width))
    });
    for width in [0.0, 0.01, 0.3, 2.0, 7.0] {
        for (i, level, marginal) in all(&dictionary).step_by(17) {
            let step = 1.0 / 512.0;
            let (mut mass, mut variance, mut plain) = (0.0, 0.0, 0.0);
            for k in -4096..4096 {
                let x = (f64::from(k) + 0.5) * step;
                mass += step * marginal.mean(x, width);
                variance += step * x * x * marginal.mean(x, width);
                plain += step * x * x * marginal.density(x);
            }
            assert!((mass - 1.0).abs() < 1e-4, "{i} {level} {width}: {mass}");
            let want = plain + width * width / 12.0;
            assert!(
                (variance / want - 1.0).abs() < 1e-3,
                "{i} {level} {width}: {variance}, {want}"
            );
        }
    }
}

/// A trilinear lookup of nominal width w is about as wide as a box of 1.5 to 1.75 w, and keeps the mass but for the end.
#[test]
fn mips_are_wider_than_they_say() {
    let dictionary = small(Means::Stratified);
    for derivative in [0.125, 0.25, 0.5] {
        let (mut ratio, mut count) = (0.0, 0.0);
        for (_, _, marginal) in all(&dictionary).filter(|(_, level, _)| *level == 8) {
            let moment = |f: &dyn Fn(f64) -> f64| {
                let step = 1.0 / 256.0;
                (-1024..1024)
                    .map(|k| (f64::from(k) + 0.5) * step)
                    .map(|x| step * f(x) * x * x)
                    .sum::<f64>()
            };
            let (wide, plain) =
                (moment(&|x| marginal.mip_mean(x, derivative)), moment(&|x| marginal.density(x)));
            ratio += (12.0 * (wide - plain)).max(0.0).sqrt() / derivative;
            count += 1.0;
            let step = 1.0 / 256.0;
            let mass: f64 = (-1024..1024)
                .map(|k| step * marginal.mip_mean((f64::from(k) + 0.5) * step, derivative))
                .sum();
            assert!((mass - 1.0).abs() < 1e-3, "{derivative}: {mass}");
        }
        println!("{derivative}: {}", ratio / count);
        assert!((1.35..1.85).contains(&(ratio / count)), "{derivative}: {}", ratio / count);
    }
}

#[test]
fn quantiles_invert_the_cumulative() {
    let dictionary = small(Means::Stratified);
    for (i, level, marginal) in all(&dictionary) {
        for k in 0..=40 {
            let u = f64::from(k) / 40.0;
            let x = marginal.quantile(u);
            assert!(x.abs() <= 4.0);
            let below =
                0.5 + x.signum() * 0.5 * 2.0 * x.abs() * marginal.mean(0.5 * x, x.abs()) * 1.0;
            assert!((below - u).abs() < 1e-9, "{i} {level} {u}: {x} {below}");
        }
    }
}

/// The same bits from the same recipe, others from another seed; made in less than 2 s.
#[test]
fn generation_is_deterministic_and_fast() {
    let begin = Instant::now();
    let one = Dictionary::<f32>::new(&Recipe::default()).expect("valid");
    let time = begin.elapsed().as_secs_f64();
    println!("{time:.2} s, {} bytes", one.bytes());
    assert!(time < 2.0, "{time} s");
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
        Recipe { marginals: 0, ..good },
        Recipe { marginals: 65_537, ..good },
        Recipe { levels: 0, ..good },
        Recipe { levels: 21, ..good },
        Recipe { intervals: 4, ..good },
        Recipe { intervals: 65, ..good },
        Recipe { width: f64::NAN, ..good },
        Recipe { width: 0.03, ..good },
        Recipe { width: 0.6, ..good },
    ] {
        assert_eq!(Dictionary::<f32>::new(&bad), Err(Error::Recipe), "{bad:?}");
    }
}

/// Bytes come back as they were; damaged, they say how.
#[test]
fn damaged_bytes_are_refused() {
    let recipe = Recipe {
        marginals: 3,
        levels: 4,
        intervals: 64,
        means: Means::Published,
        seed: 5,
        ..Recipe::default()
    };
    let dictionary = Dictionary::<f32>::new(&recipe).expect("valid");
    let bytes = dictionary.to_bytes();
    assert_eq!(bytes.len(), 44 + dictionary.bytes());
    assert_eq!(Dictionary::from_bytes(&bytes), Ok(dictionary));
    for at in 0..bytes.len() {
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x10;
        let want = match at {
            0..8 => Some(Error::DictionaryMagic),
            8..12 => Some(Error::DictionaryVersion),
            // Sizes of other dictionaries, or of none; the rest is the checksum's.
            12..28 | 32..40 => None,
            _ => Some(Error::DictionaryChecksum),
        };
        let got = Dictionary::from_bytes(&damaged).expect_err("damaged");
        assert!(want.is_none_or(|want| want == got), "byte {at}: {got:?}");
    }
    for length in 0..bytes.len() {
        let got = Dictionary::from_bytes(&bytes[..length]).expect_err("cut");
        let want = if length < 8 { Error::DictionaryMagic } else { Error::DictionaryLength };
        assert_eq!(got, want, "{length}");
    }
    let longer: Vec<u8> = bytes.iter().copied().chain([0]).collect();
    assert_eq!(Dictionary::from_bytes(&longer), Err(Error::DictionaryLength));
}

#[test]
fn any_number_is_answered() {
    let dictionary =
        Dictionary::<f32>::new(&Recipe { marginals: 4, levels: 3, ..Recipe::default() })
            .expect("valid");
    let odd = [
        f32::NAN,
        f32::INFINITY,
        f32::NEG_INFINITY,
        0.0,
        -0.0,
        1e-45,
        4.0,
        -4.0,
        f32::MAX,
        -1.0,
        1e9,
    ];
    for x in odd {
        for width in odd {
            for level in [0, 2, u32::MAX] {
                let marginal = dictionary.marginal(u32::MAX, level);
                for got in
                    [marginal.density(x), marginal.mean(x, width), marginal.mip_mean(x, width)]
                {
                    assert!(got >= 0.0 && got.is_finite(), "{x} {width}: {got}");
                }
                assert!(marginal.quantile(x).abs() <= 4.0, "{x}");
            }
        }
    }
    check(1, |_| ensure(true, "", &()));
}
