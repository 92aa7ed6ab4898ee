//! What a sample says of a distribution: mean, variance and how sure they are; and how far two
//! samples are apart.

use serde::Serialize;

/// Of a sample.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Moments {
    pub(crate) mean: f64,
    /// Standard error of the mean.
    pub(crate) mean_error: f64,
    /// Variance over the squared mean.
    pub(crate) variance: f64,
    /// Standard error of it, about.
    pub(crate) variance_error: f64,
}

impl Moments {
    pub(super) fn of(values: &[f64]) -> Self {
        let count = values.len() as f64;
        let mean = values.iter().sum::<f64>() / count;
        let central =
            |power: i32| values.iter().map(|x| (x - mean).powi(power)).sum::<f64>() / count;
        let (second, fourth) = (central(2), central(4));
        Self {
            mean,
            mean_error: (second / count).sqrt(),
            variance: second / (mean * mean),
            variance_error: ((fourth - second * second) / count).sqrt() / (mean * mean),
        }
    }
}

/// Mean distance of two samples of one size, smallest to smallest and so on: the 1-Wasserstein
/// distance.
pub(super) fn distance(a: &[f64], b: &[f64]) -> f64 {
    let sorted = |values: &[f64]| {
        let mut values = values.to_vec();
        values.sort_by(f64::total_cmp);
        values
    };
    let (a, b) = (sorted(a), sorted(b));
    a.iter().zip(&b).map(|(a, b)| (a - b).abs()).sum::<f64>() / a.len().max(1) as f64
}
