//! The published model does what it is said to do, mistakes included; each stands beside ours,
//! which does not.
#![cfg(feature = "glint")]

use crate::common::arbitrary::Source;
use lobe::material::cells::Patch;
use lobe::material::glint::{
    Binomial, Biscale, CoveredCell, Glints, ZirrKaplanyan, zirr_kaplanyan_count,
};
use lobe::slope::direction::normal_of;
use lobe::{Anisotropic, Beckmann};
use std::collections::HashMap;

/// A pixel of one cell of size 1, away from the others.
fn cell(k: u32) -> Patch<f64> {
    Patch::new([f64::from(k % 1000), f64::from(k / 1000)], [1.0, 0.0], [0.0, 1.0])
}

fn biscale(alpha: f64, fraction: f64) -> Biscale<f64> {
    Biscale::from_fractions([alpha; 2], [fraction; 2]).expect("in range")
}

fn published(alpha: f64, fraction: f64, n: f64) -> ZirrKaplanyan<f64> {
    ZirrKaplanyan::new(biscale(alpha, fraction), n).expect("in range")
}

/// Mean of D over cells, in units of the smooth D of alpha 0.6.
fn mean(model: &ZirrKaplanyan<f64>, h: [f64; 3], gamma: f64, count: u32) -> f64 {
    let sum: f64 = (0..count).map(|k| model.d(&cell(k), h, 1.0, gamma)).sum();
    sum / f64::from(count) / Beckmann::new(Anisotropic::new(biscale(0.6, 0.1).global())).d(h)
}

/// Mean and variance of a draw over its uniform number.
fn moments(draw: impl Fn(f64) -> f64) -> (f64, f64) {
    const COUNT: u32 = 100_000;
    let mut sums = [0.0; 2];
    for k in 0..COUNT {
        let x = draw((f64::from(k) + 0.5) / f64::from(COUNT));
        sums[0] += x / f64::from(COUNT);
        sums[1] += x * x / f64::from(COUNT);
    }
    (sums[0], sums[1] - sums[0] * sums[0])
}

/// Below a mean of 5 the published draw is right to 2 % in the mean and 8 % in the variance; above,
/// half of it is missing. With the figures stated for it: variance ratio 0.50, and quantiles at 5
/// that fall from 8.86 to 7.60.
#[test]
fn the_normal_branch_has_half_its_variance() {
    for mean in [0.01, 0.3, 1.7, 3.0, 4.9] {
        let (n, p) = (1000.0, mean / 1000.0);
        let (got, variance) = moments(|u| zirr_kaplanyan_count(u, n, p));
        assert!((got / mean - 1.0).abs() < 0.02, "{mean}: {got}");
        assert!((variance / (mean * (1.0 - p)) - 1.0).abs() < 0.08, "{mean}: {variance}");
    }
    for mean in [30.0, 1000.0] {
        let (n, p) = (1e6, mean / 1e6);
        let (_, variance) = moments(|u| zirr_kaplanyan_count(u, n, p));
        assert!((variance / mean - 0.5).abs() < 0.01, "{mean}: {variance}");
        let (_, ours) = moments(|u| Binomial::new(n, p).draw(u));
        assert!((ours / mean - 1.0).abs() < 0.02, "{mean}: {ours}");
    }
    let n = 1e4;
    let (before, after) = (4.9999 / n, 5.0001 / n);
    for (u, low, high) in [(0.95_f64, 8.86_f64, 7.60_f64), (0.999, 12.86, 9.89)] {
        let got: [f64; 2] = [before, after].map(|p| zirr_kaplanyan_count(u, n, p));
        assert!((got[0] - low).abs() < 0.1 && (got[1] - high).abs() < 0.1, "{u}: {got:?}");
        let ours: [f64; 2] = [before, after].map(|p| Binomial::new(n, p).draw(1.0 - u));
        assert!((ours[1] - ours[0]).abs() < 1e-2, "{u}: {ours:?}");
    }
}

/// Its exponential tail begins after 17 steps, which five in a million draws of a mean of 5 reach.
#[test]
fn the_tail_is_reached_by_few() {
    let (n, p) = (1e6, 5e-6);
    let rare = zirr_kaplanyan_count(1.0 - 5e-6, n, p);
    assert!(rare > 16.0 && rare < 20.0, "{rare}");
    let rarest = zirr_kaplanyan_count(1.0 - 1e-15, n, p);
    assert!(rarest > rare && rarest < 60.0, "{rarest}");
}

/// Near the pole, at a point light and equal sizes, the mean is right.
#[test]
fn without_its_extras_the_mean_is_right() {
    let model = published(0.6, 0.1, 1000.0);
    let got = mean(&model, normal_of([0.05, 0.0]), 0.0, 60_000);
    assert!((got - 1.0).abs() < 0.03, "{got}");
}

/// 1/h_z^4 within the probability, which is cut at 1, darkens half vectors that graze.
#[test]
fn at_grazing_half_vectors_the_mean_is_too_low() {
    let h = normal_of([6.0, 0.0]);
    let rough = Biscale::from_fractions([3.0; 2], [0.9; 2]).expect("in range");
    let model = ZirrKaplanyan::new(rough, 1000.0).expect("in range");
    let smooth = Beckmann::new(Anisotropic::new(rough.global())).d(h);
    let sum: f64 = (0..2000).map(|k| model.d(&cell(k), h, 1.0, 0.0)).sum();
    assert!(sum / 2000.0 / smooth < 0.05, "{}", sum / 2000.0 / smooth);
    let ours = Glints::new(rough, 1000.0).expect("in range");
    let sum: f64 = (0..2000).map(|k| ours.ndf(&cell(k)).sparkle(h, 0.0)).sum();
    assert!((sum / 2000.0 - 1.0).abs() < 0.05, "{}", sum / 2000.0);
}

/// A light's radius adds a haze over all half vectors: with the demonstration's numbers 4 % of the
/// peak.
#[test]
fn a_light_adds_a_haze() {
    let model = published(0.6, 0.024, 1e4);
    let up = [0.0, 0.0, 1.0];
    let (point, sun) = (model.probability(up, 1.0, 0.0), model.probability(up, 1.0, 0.01));
    assert!(((sun - point) / point - 0.0434).abs() < 1e-3, "{}", (sun - point) / point);
    // Far from the highlight there is nothing else.
    let far = normal_of([3.0, 0.0]);
    assert!(model.probability(far, 1.0, 0.01) > 1e6 * model.probability(far, 1.0, 0.0));
}

/// Sizes that vary brighten the whole, by the figures stated: 1.12 and 3.65 times.
#[test]
fn size_variation_gains_energy() {
    for (variation, n, stated) in [(0.3, 1.0, 1.12), (1.0, 1.0, 3.65)] {
        let mut model = published(0.6, 0.1, n);
        model.variation = variation;
        // Without the cut, which hides a part of it.
        model.dynamic_range = 1e30;
        let got = mean(&model, [0.0, 0.0, 1.0], 0.0, 3_000_000);
        let ours = {
            let glints =
                Glints::new(biscale(0.6, 0.1), n).and_then(|g| g.with_variation(variation));
            let glints = glints.expect("in range");
            let sum: f64 =
                (0..300_000).map(|k| glints.ndf(&cell(k)).sparkle([0.0, 0.0, 1.0], 0.0)).sum();
            sum / 300_000.0
        };
        println!("variation {variation}: {got} {ours}");
        assert!((got / stated - 1.0).abs() < 0.25, "variation {variation}: {got}, stated {stated}");
        assert!((ours - 1.0).abs() < 0.1, "variation {variation}: ours {ours}");
    }
}

/// Indices shifted along each axis by itself: cells that are twice as far from the origin, which
/// the code moves by 100, are the same, for any half vector.
#[test]
fn distant_cells_repeat() {
    let model = published(0.6, 0.1, 1000.0);
    let ours = Glints::new(biscale(0.6, 0.1), 1000.0).expect("in range");
    let at = |u: f64, v: f64| Patch::new([u - 100.0, v - 100.0], [1.0, 0.0], [0.0, 1.0]);
    let (near, far, other) = (at(3.0, 5.0), at(24.0, 10.0), at(7.0, 5.0));
    let (mut differ, mut apart) = (0, 0);
    for k in 0..500 {
        let h = normal_of([0.001 * f64::from(k), 0.1]);
        let [a, b, c] = [near, far, other].map(|patch| model.d(&patch, h, 1.0, 0.0));
        assert_eq!(a, b);
        differ += u32::from(a != c);
        let [a, b] = [near, far].map(|patch| ours.ndf(&patch).sparkle(h, 0.0));
        apart += u32::from(a != b);
    }
    assert!(differ > 100 && apart > 100, "{differ} {apart}");
}

/// A cell of less than one detail is brighter than a detail.
#[test]
fn parts_of_details_are_brighter_than_details() {
    let n = 0.01;
    let model = published(0.6, 0.1, n);
    let peak = Beckmann::new(Anisotropic::new(biscale(0.6, 0.1).local())).d([0.0, 0.0, 1.0]);
    let most =
        (0..20_000).map(|k| model.d(&cell(k), [0.0, 0.0, 1.0], 1.0, 0.0)).fold(0.0, f64::max);
    assert!((most / peak - 1.0 / n).abs() < 0.01 / n, "{most} of {peak}");
}

/// Calls a function with every cell of a pixel.
type Visit<'a> = dyn Fn(&Patch<f64>, &mut dyn FnMut(CoveredCell<f64>)) + 'a;

/// Columns along the longer median: where the other becomes longer, they are elsewhere at once.
/// Ours are not.
#[test]
fn columns_jump_where_medians_change() {
    let model = published(0.6, 0.5, 1e6);
    let ours = Glints::new(biscale(0.6, 0.5), 1e6).expect("in range");
    let patch = |x: f64| Patch::new([0.3, 0.2], [4.0, 1.5], [4.0 * x, -1.5]);
    let moved = |visit: &Visit<'_>| {
        let mut shares = HashMap::new();
        for (sign, x) in [(1.0, 1.0 - 1e-9), (-1.0, 1.0 + 1e-9)] {
            visit(&patch(x), &mut |cell| {
                *shares.entry((cell.index, cell.exponent)).or_insert(0.0) += sign * cell.share;
            });
        }
        shares.values().map(|x: &f64| x.abs()).sum::<f64>()
    };
    let theirs = moved(&|patch, f| model.visit(patch, f));
    let ours = moved(&|patch, f| ours.ndf(patch).grid().visit(f));
    assert!(theirs > 0.2 && ours < 1e-6, "{theirs} {ours}");
}

/// Pixels that are long need more columns than the loop has: the cells at their end are not seen.
#[test]
fn long_pixels_are_cut_short() {
    let model = published(0.6, 0.5, 1e6);
    let ours = Glints::new(biscale(0.6, 0.5), 1e6).expect("in range");
    let mut counts = [0; 2];
    for length in 1..=22 {
        let patch = Patch::new([0.5, 0.5], [1.4, 0.0], [0.0, f64::from(length)]);
        let (mut theirs, mut whole, mut seen) = (0, 0, 0.0);
        model.visit(&patch, |cell| {
            theirs += 1;
            seen += cell.share;
        });
        ours.ndf(&patch).grid().visit(|_| whole += 1);
        assert!(theirs <= whole && theirs <= 60, "{length}: {theirs} of {whole}");
        assert!((seen - 1.0).abs() < 1e-12 || theirs < whole, "{length}: {seen}");
        counts = [theirs, whole];
    }
    assert!(counts[0] <= 60 && counts[1] > 64, "{counts:?}");
}

#[test]
fn any_input_gives_a_number() {
    let odd = [f32::NAN, f32::INFINITY, 0.0, 1e-45, 1e-30, -1.0, 0.5, 1.0, 1e9, 1e30, f32::MAX];
    for seed in 0..50_000 {
        let mut source = Source::from_seed(seed);
        let mut any = || odd[source.pick(odd.len() as u64) as usize];
        let patch = Patch::new([any(), any()], [any(), any()], [any(), any()]);
        let biscale = Biscale::from_fractions([0.5_f32, 0.3], [0.2, 1.0]).expect("in range");
        let mut model = ZirrKaplanyan::new(biscale, 1e4).expect("in range");
        model.variation = if source.pick(2) == 0 { 0.0 } else { 100.0 };
        let h = normal_of([source.uniform(-2.0, 2.0) as f32, source.uniform(-2.0, 2.0) as f32]);
        let d = model.d(&patch, h, 0.9, 0.01);
        assert!(d >= 0.0 && d.is_finite(), "{patch:?}, {h:?}: {d}");
    }
}
