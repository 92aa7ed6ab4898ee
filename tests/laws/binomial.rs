//! The binomial draw: its mean and variance on both sides of every branch, its order, its
//! continuity (law Z8).
#![cfg(feature = "glint")]
#![allow(clippy::cast_sign_loss, reason = "counts are not negative")]

use crate::common::{check, ensure, near};
use lobe::material::glint::Binomial;
use statrs::distribution::{Binomial as Exact, DiscreteCDF};

/// Mean and variance of a draw over the whole range of its uniform number, by strata and by
/// midpoints; the thousandths at both ends, where counts are rarest, more finely.
fn moments(draw: impl Fn(f64) -> f64) -> (f64, f64) {
    const COUNT: u32 = 40_000;
    let mut sums = [0.0; 3];
    for (from, to) in [(0.0, 1e-6), (1e-6, 1e-3), (1e-3, 0.999), (0.999, 1.0)] {
        let weight = (to - from) / f64::from(COUNT);
        for k in 0..COUNT {
            let x = draw(from + weight * (f64::from(k) + 0.5));
            sums[0] += weight * x;
            sums[1] += weight * x * x;
            sums[2] += weight;
        }
    }
    let mean = sums[0] / sums[2];
    (mean, sums[1] / sums[2] - mean * mean)
}

/// Numbers of trials, whole and not, and means on both sides of 4, 5 and 8.
const TRIALS: [f64; 9] = [1.0, 2.5, 7.0, 16.3, 40.0, 100.0, 1e4, 3.3e6, 1e12];
const MEANS: [f64; 18] = [
    1e-6, 1e-3, 0.03, 0.3, 0.9, 1.7, 3.0, 3.99, 4.01, 4.5, 4.9, 5.1, 6.0, 7.0, 8.0, 8.2, 30.0, 1e4,
];

#[test]
fn mean_and_variance_are_those_of_the_distribution() {
    let mut count = 0;
    for n in TRIALS {
        for mean in MEANS {
            let p = mean / n;
            if p > 1.0 {
                continue;
            }
            count += 1;
            let binomial = Binomial::new(n, p);
            let (got, variance) = moments(|tail| binomial.draw(tail));
            assert!((got / mean - 1.0).abs() < 0.01, "n {n}, mean {mean}: {got}");
            // Trials are whole: of 2.5 there are three of a lower probability.
            let whole = n.ceil();
            let want = mean * (1.0 - mean / whole);
            // Of a count that never varies the difference of squares leaves its rounding.
            assert!(
                (variance - want).abs() < 0.05 * want + 1e-10 * mean * mean,
                "n {n}, mean {mean}: variance {variance}, not {want}"
            );
        }
    }
    assert!(count > 120, "only {count} cases");
}

/// In f32, with the words that a cell has: their ends are where digits go.
#[test]
fn f32_has_the_same_mean() {
    for n in TRIALS {
        for mean in MEANS.into_iter().filter(|mean| mean / n <= 1.0) {
            let single = Binomial::new(n as f32, (mean / n) as f32);
            let (got, _) = moments(|tail| f64::from(single.draw((tail as f32).min(1.0 - 6e-8))));
            assert!((got / mean - 1.0).abs() < 0.01, "n {n}, mean {mean}: {got}");
        }
    }
}

/// Where the tail is rarest, rounding may not make much more of it than there is: a count of 24 for
/// one of 5 is a firefly. Differences from 1 are off by 1e-7, a thousand times the rarest tail, and
/// each success is ten times as rare as the one before: three more.
#[test]
fn the_rarest_tails_are_those_of_f64() {
    for n in TRIALS {
        for mean in [1e-3, 0.03, 0.3, 1.0, 3.0, 3.9].into_iter().filter(|mean| mean / n <= 1.0) {
            let (single, double) =
                (Binomial::new(n as f32, (mean / n) as f32), Binomial::new(n, mean / n));
            for k in 0..330 {
                let tail = f64::exp2(-0.1 * f64::from(k)) as f32;
                let (got, want) = (single.draw(tail), double.draw(f64::from(tail)));
                let near = f64::from(got) <= want + 3.0;
                assert!(near, "n {n}, mean {mean}, tail {tail:e}: {got}, not {want}");
            }
        }
    }
}

/// The mean is exact where only the inversion serves, but for the midpoint rule's own error.
#[test]
fn between_two_probabilities_of_the_lattice_the_mean_is_kept() {
    for n in [1.0_f64, 3.7, 50.0, 1e5] {
        for k in 0..40 {
            let p = 0.5 * 0.9_f64.powf(0.25 * f64::from(k)) / n.max(1.0);
            let binomial = Binomial::new(n, p);
            let (mean, _) = moments(|tail| binomial.draw(tail));
            assert!((mean / (n * p) - 1.0).abs() < 2e-4, "n {n}, p {p}: {mean}");
        }
    }
}

/// On a point of the lattice the draw is the quantile function, as statrs has it.
#[test]
fn on_the_lattice_it_is_the_quantile() {
    for (trials, steps) in [(7_u64, 0_i32), (10, 5), (30, 18), (400, 45), (100_000, 95)] {
        let p = 0.5 * 0.9_f64.powi(steps);
        let exact = Exact::new(p, trials).expect("a distribution");
        assert!(p * (trials as f64) < 4.0, "{trials} trials blend");
        let binomial = Binomial::new(trials as f64, p);
        for k in 1..400 {
            let tail = f64::from(k) / 400.0;
            let got = binomial.draw(tail);
            // P(N > count) <= tail < P(N > count - 1), but within the rounding of p on the lattice.
            let count = got.round() as u64;
            let above = exact.sf(count);
            assert!(above <= tail + 1e-6, "{trials} of {p}, tail {tail}: {got}, {above}");
            if count >= 1 {
                let below = exact.sf(count - 1);
                assert!(below > tail - 1e-6, "{trials} of {p}, tail {tail}: {got}, {below}");
            }
        }
    }
}

/// The normal branch follows the distribution's skewness: quantiles within three quarters of a
/// count of the exact ones.
#[test]
fn above_eight_quantiles_are_near_the_exact_ones() {
    for (trials, p) in [(20_u64, 0.45), (100, 0.1), (10_000, 9e-4), (1_000_000, 2e-5)] {
        let exact = Exact::new(p, trials).expect("a distribution");
        let binomial = Binomial::new(trials as f64, p);
        for k in 1..1000 {
            let tail = f64::from(k) / 1000.0;
            let want = exact.inverse_cdf(1.0 - tail) as f64;
            let got = binomial.draw(tail);
            assert!((got - want).abs() < 1.25, "{trials} of {p}, tail {tail}: {got}, not {want}");
        }
    }
}

#[test]
fn it_falls_with_the_tail_and_rises_with_probability_and_lies_in_range() {
    check(20_000, |source| {
        let n = source.log_uniform(0.1, 1e9);
        let p = source.log_uniform(1e-9, 1.0);
        let (a, b) = (source.uniform(0.0, 1.0), source.uniform(0.0, 1.0));
        let (low, high) = (a.min(b).max(1e-9), a.max(b).max(1e-9));
        let one = Binomial::new(n, p);
        let inputs = (n, p, low, high);
        let trials = n.max(1.0).ceil();
        // Differences of counts near 1e9 have seven digits.
        let noise = 1e-9 * trials;
        ensure(one.draw(low) >= one.draw(high) - noise, "rises with the tail", &inputs)?;
        ensure((0.0..=trials).contains(&one.draw(low)), "out of range", &inputs)?;
        let rarer = Binomial::new(n, p * source.uniform(0.5, 1.0));
        // Both distributions are ordered; where they blend, weights shift by less than the count
        // does.
        ensure(rarer.draw(low) <= one.draw(low) + 0.35 + noise, "falls with p", &inputs)
    });
}

#[test]
fn it_is_continuous_in_the_probability() {
    check(20_000, |source| {
        let n = source.log_uniform(1.0, 1e6);
        let p = source.log_uniform(1e-6, 0.98);
        let tail = source.uniform(0.001, 0.999);
        let step = 1e-9;
        let (here, there) = (Binomial::new(n, p), Binomial::new(n, p * (1.0 + step)));
        // Between neighbors of the lattice, a tenth apart, a count changes by a few deviations at
        // most.
        let mean = n * p;
        let slope = 40.0 * (1.0 + mean + (n - mean).abs().min(mean));
        near(there.draw(tail), here.draw(tail), 1e3 * step * slope, &(n, p, tail))
    });
}

#[test]
fn the_ends_of_the_range() {
    for n in [1.0_f64, 2.5, 100.0, 1e12, 1e18] {
        for tail in [1e-10, 0.3, 0.999] {
            assert_eq!(Binomial::new(n, 0.0).draw(tail), 0.0);
            // Of two and a half there are three of a lower probability.
            assert!(n == 2.5 || Binomial::new(n, 1.0).draw(tail) == n);
            // A rare detail that no word can tell has its mean.
            let rare = 1e-10 / n;
            assert!((Binomial::new(n, rare).draw(tail) / 1e-10 - 1.0).abs() < 1e-12);
        }
    }
    for odd in [f32::NAN, f32::INFINITY, -1.0, 0.0, f32::MAX] {
        for p in [0.3, f32::NAN, -1.0, 2.0] {
            let drawn = Binomial::new(odd, p).draw(0.3);
            assert!((0.0..=1e18).contains(&drawn), "{odd} of {p}: {drawn}");
        }
    }
}
