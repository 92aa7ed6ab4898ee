//! Glints: what they average to and how much they vary (laws Z1, Z2, Z7, Z9, Z10, Z13, B2), with
//! the figures stated for them.
#![cfg(feature = "glint")]

use crate::common::arbitrary::Source;
use crate::common::quadrature::midpoints;
use crate::common::size::size;
use lobe::material::cells::Patch;
use lobe::material::glint::{
    Biscale, CoveredCell, GlintNdf, Glints, Grid, ZirrKaplanyan, hue_wheel,
};
use lobe::slope::direction::{normal_of, normalize};
use lobe::{Beckmann, Isotropic, Psd, Roughness, SlopeMoments};
use std::collections::HashMap;

/// Snow: alpha 0.6 from afar, details of 0.0144.
fn snow(density: f64) -> Glints<f64> {
    let biscale = Biscale::from_fractions([0.6, 0.6], [0.024, 0.024]).expect("in range");
    Glints::new(biscale, density).expect("in range")
}

/// A pixel of exactly one cell, of size 1: the `k`th of a long row.
fn cell(k: u32) -> Patch<f64> {
    let (x, y) = (k % 1000, k / 1000);
    Patch::new([f64::from(x), f64::from(y)], [1.0, 0.0], [0.0, 1.0])
}

/// Mean and relative variance of the sparkle over pixels.
fn over_pixels(
    glints: &Glints<f64>,
    h: [f64; 3],
    blur: f64,
    count: u32,
    patch: impl Fn(u32) -> Patch<f64>,
) -> (f64, f64) {
    let (mut sum, mut squares) = (0.0, 0.0);
    for k in 0..count {
        let x = glints.ndf(&patch(k)).sparkle(h, blur);
        sum += x;
        squares += x * x;
    }
    let mean = sum / f64::from(count);
    (mean, squares / f64::from(count) / (mean * mean) - 1.0)
}

/// Law Z2, with its figures: of one cell of n details the relative variance is (1 - P)/(n P). Z1:
/// the mean is 1.
#[test]
fn one_cell_varies_as_its_binomial_number() {
    const COUNT: u32 = 400_000;
    let along = normal_of([0.6, 0.0]);
    let cases =
        [(100.0, [0.0, 0.0, 1.0], 17.35), (100.0, along, 47.2), (1e4, [0.0, 0.0, 1.0], 0.1735)];
    for (n, h, stated) in cases {
        let glints = snow(n);
        let p = glints.ndf(&cell(0)).probability(h, 0.0);
        let law = (1.0 - p) / (n * p);
        assert!((law / stated - 1.0).abs() < 1e-3, "{law}, stated {stated}");
        let (mean, variance) = over_pixels(&glints, h, 0.0, COUNT, cell);
        let count = f64::from(COUNT);
        assert!((mean - 1.0).abs() < 4.0 * (law / count).sqrt(), "n {n}: mean {mean}");
        // Of a Poisson number the fourth moment is that of 1/mean + 3.
        let deviation = ((1.0 / (n * p) + 3.0) / count).sqrt();
        let allowed = 4.0 * deviation + 0.01;
        assert!((variance / law - 1.0).abs() < allowed, "n {n}: {variance}, law {law}");
    }
}

/// Law Z1 for any material, half vector, light and pixel; Z10, sizes that vary; Z13, details as
/// rough as the whole.
#[test]
fn the_mean_is_the_smooth_lobe() {
    for case in 0..size(40, 160) {
        let mut source = Source::from_seed(case);
        let fraction = |source: &mut Source| match case % 4 {
            0 => 1.0,
            _ => source.log_uniform(0.02, 1.0),
        };
        let fractions = match case % 8 {
            // Grooves, along either axis.
            5 => [source.log_uniform(0.02, 0.9), 1.0],
            7 => [1.0, source.log_uniform(0.02, 0.9)],
            _ => [fraction(&mut source), fraction(&mut source)],
        };
        let alphas = [source.log_uniform(0.05, 0.8), source.log_uniform(0.05, 0.8)];
        let biscale = Biscale::from_fractions(alphas, fractions).expect("in range");
        let density = source.log_uniform(0.1, 1e4);
        let variation = if case % 3 == 0 { source.uniform(0.1, 2.0) } else { 0.0 };
        let glints = Glints::new(biscale, density)
            .and_then(|glints| glints.with_variation(variation))
            .expect("in range")
            .with_seed(case as u32);
        let slope = [0, 1].map(|k| alphas[k] * source.uniform(-1.0, 1.0));
        let (h, blur) = (normal_of(slope), source.uniform(0.0, 1.0) * source.uniform(0.0, 0.01));
        let (right, up) = (source.uniform(0.5, 6.0), source.uniform(0.5, 6.0));
        let shear = source.uniform(-0.5, 0.5);
        // Pixels apart along both axes, so that they share no cells, nor grooves.
        let patch = |k: u32| {
            Patch::new([11.3 * f64::from(k), 12.9 * f64::from(k)], [right, shear], [0.0, up])
        };
        let count = 20_000;
        let (mean, variance) = over_pixels(&glints, h, blur, count, patch);
        let deviation = mean * (variance / f64::from(count)).sqrt();
        let p = glints.ndf(&patch(0)).probability(h, blur);
        // Too rare to be met: the sample has no estimate of its own deviation.
        let rarest = p * density.max(1.0) * f64::from(count);
        if rarest > 200.0 {
            assert!(
                (mean - 1.0).abs() < 5.0 * deviation + 2e-3,
                "{case}: {alphas:?} {fractions:?} density {density} slope {slope:?} variation \
                    {variation}: \
                 {mean} +- {deviation}"
            );
        }
    }
}

/// How much larger than a detail's lobe its angular bin is on the slope plane, on average over
/// details: bins are equal on the paraboloid q = 2 tan(t/2), slopes are tan(t).
fn bin_over_lobe(alpha: f64) -> f64 {
    let nodes = 20_000;
    let at = |k: u32| {
        let tail = (f64::from(k) + 0.5) / f64::from(nodes);
        let angle = (alpha * (-tail.ln()).sqrt()).atan();
        let half = 0.5 * angle;
        0.5 * angle.tan() / half.tan() * (half.cos() / angle.cos()).powi(2)
    };
    (0..nodes).map(at).sum::<f64>() / f64::from(nodes)
}

/// Law Z9, with its figure: the density of one cell of 100 details integrates to 1 on average, and
/// varies by 1/n; off the pole by more.
#[test]
fn the_integral_is_one_on_average_and_varies_by_one_over_n() {
    for (alpha, stated) in [(0.05, 1.0), (0.6, 1.3), (1.0, 1.8)] {
        integral(alpha, stated);
    }
}

/// With a share of 0.15, so that few details overlap.
fn integral(alpha: f64, stated: f64) {
    let (share, n) = (0.15, 100.0);
    let biscale = Biscale::from_fractions([alpha, alpha], [share, share]).expect("in range");
    let glints = Glints::new(biscale, n).expect("in range");
    let (count, nodes) = (size(400, 1500), 64);
    let (mut sum, mut squares) = (0.0, 0.0);
    let smooth = Beckmann::new(Isotropic::new(alpha).expect("in range"));
    for k in 0..count {
        let pixel: GlintNdf<f64> = glints.ndf(&cell(k));
        let integral = midpoints(3.2 * alpha, nodes, |slope| {
            smooth.slope_pdf(slope) * pixel.sparkle(normal_of(slope), 0.0)
        });
        sum += integral;
        squares += integral * integral;
    }
    let mean = sum / f64::from(count);
    let variance = squares / f64::from(count) - mean * mean;
    // The integral of P is pi alpha_l^2, that of P^2 half of alpha_l^2/alpha_g^2 of it.
    let law = (1.0 - 0.5 * share * share) / n * bin_over_lobe(alpha);
    println!("alpha {alpha}: {} of {}", variance * n, law * n);
    // The estimate of a variance by `count` pixels deviates by sqrt(2/count) of it.
    let deviation = (2.0 / f64::from(count)).sqrt();
    let allowed = 0.05 + 3.0 * deviation * stated;
    assert!((variance * n - stated).abs() < allowed, "alpha {alpha}: {}", variance * n);
    assert!((mean - 1.0).abs() < 4.0 * (law / f64::from(count)).sqrt() + 1e-3, "mean {mean}");
    let ratio = variance / law;
    // The law is an upper bound: within bins as large as those of steep slopes probabilities fall.
    let least = if alpha < 0.1 { 0.98 } else { 0.85 };
    assert!(ratio < 1.02 + 4.0 * deviation && ratio > least - 4.0 * deviation, "{ratio}");
}

/// Law Z7: many details are the smooth lobe, and before that vary by the cells' shares.
#[test]
fn many_details_are_smooth() {
    let h = normal_of([0.3, 0.2]);
    let patch = |k: u32| {
        Patch::new([1.3 * f64::from(k), 0.7 * f64::from(k)], [0.013, 0.002], [0.001, 0.017])
    };
    for density in [1e10, 1e13, 1e16] {
        let glints = snow(density);
        let count = 20_000;
        let (mean, variance) = over_pixels(&glints, h, 0.0, count, patch);
        let p = glints.ndf(&patch(0)).probability(h, 0.0);
        // Cells that both levels have draw one uniform number for two counts.
        let [_, together] = laws(density, p, count, patch, ours);
        let law = together / (density * patch(0).area() * p);
        assert!((mean - 1.0).abs() < 5.0 * (law / f64::from(count)).sqrt(), "{density}: {mean}");
        assert!((variance / law - 1.0).abs() < 0.08, "{density}: {variance}, law {law}");
        if density == 1e16 {
            assert!(variance.sqrt() < 0.003, "{variance}");
        }
    }
}

/// What a pixel of `density` details varies by, times its area, if its cells draw independently;
/// and if those of one place, which two levels have, draw one number: means over many pixels, whose
/// cells `visit` gives.
fn laws(
    density: f64,
    p: f64,
    count: u32,
    patch: impl Fn(u32) -> Patch<f64>,
    visit: impl Fn(&Patch<f64>, &mut dyn FnMut(CoveredCell<f64>)),
) -> [f64; 2] {
    let mut sums = [0.0; 2];
    for k in 0..count {
        let (mut apart, mut places) = (0.0, HashMap::new());
        visit(&patch(k), &mut |cell| {
            let deviation = cell.share / (density * f64::powi(4.0, cell.exponent) * p).sqrt();
            apart += deviation * deviation;
            let place = cell.index.map(|i| i as f64 * f64::powi(2.0, cell.exponent));
            *places.entry(place.map(f64::to_bits)).or_insert(0.0) += deviation;
        });
        sums[0] += apart;
        sums[1] += places.values().map(|x| x * x).sum::<f64>();
    }
    sums.map(|sum| sum / f64::from(count) * (1.0 - p) * density * patch(0).area() * p)
}

/// The cells of a pixel, as [`Grid`] has them.
fn ours(patch: &Patch<f64>, f: &mut dyn FnMut(CoveredCell<f64>)) {
    Grid::new(patch, 1e-9).visit(f);
}

/// Law B2, with its figures: the variance of a pixel falls with its area, rippling by 2 within an
/// octave. The figures are of two levels under one weight, as published, that draw independently.
/// Cells that come and go one by one keep the variance above that, and draws of one number for one
/// place raise it further: nearer to 1, the details' own.
#[test]
fn the_variance_of_a_pixel_ripples_as_stated() {
    let stated: [(f64, &[(u64, f64)]); 2] = [
        (
            1.0,
            &[
                (0, 0.43),
                (1, 0.39),
                (2, 0.33),
                (3, 0.28),
                (4, 0.24),
                (5, 0.22),
                (6, 0.24),
                (7, 0.30),
            ],
        ),
        (4.0, &[(0, 0.61), (5, 0.32)]),
    ];
    let (density, h) = (2e3, [0.0, 0.0, 1.0]);
    let glints = snow(density);
    let p = glints.ndf(&cell(0)).probability(h, 0.0);
    let published = ZirrKaplanyan::new(glints.biscale(), density).expect("in range");
    for (aspect, figures) in stated {
        for &(eighths, figure) in figures {
            let width = f64::exp2(eighths as f64 / 8.0);
            let patch = |k: u32| {
                let mut source = Source::from_seed(eighths << 32 | u64::from(k));
                let uv = [source.uniform(-1e5, 1e5), source.uniform(-1e5, 1e5)];
                Patch::new(uv, [width, 0.0], [0.0, aspect * width])
            };
            let place = format!("aspect {aspect}, {eighths}/8");
            let [linear, _] = laws(density, p, 20_000, patch, |patch, f| published.visit(patch, f));
            assert!((linear - figure).abs() < 0.015, "{place}: {linear}, stated {figure}");
            let [apart, together] = laws(density, p, 20_000, patch, ours);
            assert!(apart > 0.98 * linear && apart < 1.0, "{place}: {linear}, {apart}");
            let (mean, variance) = over_pixels(&glints, h, 0.0, 60_000, patch);
            assert!((mean - 1.0).abs() < 0.02, "{place}: mean {mean}");
            let got = variance * density * aspect * width * width * p / (1.0 - p);
            println!("{place}: {linear} {apart} {got} {together}");
            // The sample's own deviation is 1.5 %.
            assert!(
                got > 0.94 * apart && got < 1.06 * together,
                "{place}: {apart}, {got}, {together}"
            );
        }
    }
}

/// A square pixel varies as much however it is turned: its cells are as large as its sides, not as
/// its diagonal.
#[test]
fn turned_pixels_vary_as_straight_ones() {
    let (density, h) = (2e3, [0.0, 0.0, 1.0]);
    let p = snow(density).ndf(&cell(0)).probability(h, 0.0);
    for width in [1.0, 1.4] {
        let varies = |turn: f64| {
            let (sin, cos) = turn.sin_cos();
            let patch = |k: u32| {
                let mut source = Source::from_seed(u64::from(k));
                let uv = [source.uniform(-1e3, 1e3), source.uniform(-1e3, 1e3)];
                Patch::new(uv, [width * cos, width * sin], [-width * sin, width * cos])
            };
            laws(density, p, 20_000, patch, ours)[1]
        };
        let straight = varies(0.0);
        for turn in [0.3, 0.5, core::f64::consts::FRAC_PI_4, 1.1] {
            let ratio = varies(turn) / straight;
            assert!((0.95..1.05).contains(&ratio), "width {width}, turned by {turn}: {ratio}");
        }
    }
}

/// Colors average to the sparkle, channel by channel, and to white where details are many.
#[test]
fn colors_keep_the_mean() {
    let h = [0.0, 0.0, 1.0];
    for density in [100.0, 1e6] {
        let glints = snow(density);
        let (mut sums, mut white, mut spread) = ([0.0; 3], 0.0, 0.0);
        let count = 100_000;
        for k in 0..count {
            let pixel = glints.ndf(&cell(k));
            let color = pixel.colored_sparkle(h, 0.0, hue_wheel);
            assert!(color.iter().all(|x| *x >= 0.0));
            for (sum, x) in sums.iter_mut().zip(color) {
                *sum += x / f64::from(count);
            }
            white += pixel.sparkle(h, 0.0) / f64::from(count);
            spread += (color[0] - color[2]).abs() / f64::from(count);
        }
        for sum in sums {
            assert!((sum / white - 1.0).abs() < 0.03, "{density}: {sum} of {white}");
        }
        let limit = if density > 1e5 { 0.1 } else { 2.0 };
        assert!(spread < limit && spread > 0.01, "{density}: {spread}");
    }
}

/// A normal map's covariance spreads the details and keeps each as bright; a tilt moves the lobe.
#[test]
fn moments_enter_through_the_global_roughness() {
    let biscale = Biscale::from_fractions([0.2, 0.2], [0.1, 0.1]).expect("in range");
    let glints = Glints::new(biscale, 500.0).expect("in range");
    let covariance = Psd::new(0.02, 0.005, 0.01).expect("in range");
    let moments = SlopeMoments::new([0.3, -0.1], covariance).expect("in range");
    let h = normal_of([0.35, 0.0]);
    let (mut sum, count) = (0.0, 40_000);
    for k in 0..count {
        sum += glints.ndf(&cell(k)).over(&moments).slope_pdf(h, 0.0);
    }
    let whole = biscale.global() + Roughness::from_covariance(covariance);
    let lobe = lobe::Lobe::new([0.3, -0.1], whole).expect("in range");
    let want = Beckmann::new(lobe.shape()).slope_pdf([0.35, 0.0]);
    assert!(
        (sum / f64::from(count) / want - 1.0).abs() < 0.05,
        "{}, {want}",
        sum / f64::from(count)
    );
}

#[test]
fn maps_over_maps_add_means_and_covariances() {
    let glints = snow(100.0).ndf(&cell(0));
    let map = |mean: [f64; 2]| {
        SlopeMoments::new(mean, Psd::new(0.01, 0.0, 0.02).expect("in range")).expect("in range")
    };
    let (a, b) = (map([0.2, 0.0]), map([0.0, 0.1]));
    assert_eq!(
        glints.over(&a).over(&b).smooth_lobe().mean(),
        glints.over(&(a + b)).smooth_lobe().mean()
    );
    assert_eq!(glints.over(&a).over(&SlopeMoments::default()), glints.over(&a));
}

/// The cells of [`Grid`] are those that a lobe asks: a share for each, and of one cell one draw.
#[test]
fn a_pixel_within_a_cell_has_its_count() {
    let glints = snow(100.0);
    let h = normalize([0.1, 0.2, 1.0]);
    let pixel = glints.ndf(&cell(5));
    let mut count = 0;
    Grid::new(&cell(5), 0.1).visit(|_| count += 1);
    assert_eq!(count, 1);
    let whole = pixel.sparkle(h, 0.0) * pixel.probability(h, 0.0) * 100.0;
    assert!(whole < 4.0, "{whole} of 100 details reflect");
}
