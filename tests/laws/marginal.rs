//! Marginals of a dictionary: means over boxes, lookups in mips, quantiles, and any number (law
//! C12).
#![cfg(feature = "glint")]

use crate::common::marginals::{all, small};
use crate::common::{ODD, check, near};
use lobe::material::multilobe::{Dictionary, LobeMeans, Marginal, Recipe};

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
    let dictionary = small(LobeMeans::Stratified);
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

/// A trilinear lookup of nominal width w is about as wide as a box of 1.5 to 1.75 w, and keeps the
/// mass but for the end.
#[test]
fn mips_are_wider_than_they_say() {
    let dictionary = small(LobeMeans::Stratified);
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
        assert!((1.5..1.8).contains(&(ratio / count)), "{derivative}: {}", ratio / count);
    }
}

#[test]
fn quantiles_invert_the_cumulative() {
    let dictionary = small(LobeMeans::Stratified);
    for (i, level, marginal) in all(&dictionary) {
        for k in 0..=40 {
            let u = f64::from(k) / 40.0;
            let x = marginal.quantile(u);
            assert!(x.abs() <= 4.0);
            // The integral from 0 to it, by the mean over a box between.
            let below = 0.5 + x * marginal.mean(0.5 * x, x.abs());
            assert!((below - u).abs() < 1e-9, "{i} {level} {u}: {x} {below}");
        }
    }
}

#[test]
fn any_number_is_answered() {
    let dictionary =
        Dictionary::<f32>::new(&Recipe { marginals: 4, levels: 3, ..Recipe::default() })
            .expect("valid");
    let odd = ODD.map(|x| x as f32);
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
}
