//! A reference in two independent halves, and pictures held against it.

use serde::Serialize;

/// Two independent estimates of every pixel.
#[derive(Clone, Debug, Default)]
pub(crate) struct Halves {
    pub(super) estimates: Vec<[f64; 2]>,
}

/// How wrong a picture is, over the reference's mean.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Errors {
    /// Root-mean-square error without the reference's noise; 0 where noise hides it.
    pub(crate) rmse: f64,
    /// What `rmse` would show of a right picture: two standard errors of its square, as a root.
    pub(crate) least: f64,
    /// Mean of the picture over the reference's, minus 1.
    pub(crate) bias: f64,
}

impl Halves {
    /// Mean of both halves.
    pub(crate) fn picture(&self) -> Vec<f64> {
        self.estimates.iter().map(|[a, b]| 0.5 * (a + b)).collect()
    }

    /// Mean over the picture.
    pub(crate) fn mean(&self) -> f64 {
        mean(self.estimates.iter().map(|[a, b]| 0.5 * (a + b)))
    }

    /// Standard error of a pixel, root-mean-square over the picture, over its mean.
    pub(crate) fn noise(&self) -> f64 {
        0.5 * mean(self.estimates.iter().map(|[a, b]| (a - b) * (a - b))).sqrt() / self.mean()
    }

    /// A picture's errors.
    ///
    /// Its distances from two independent halves multiply to its squared error, on average: each
    /// half's noise meets no second factor of its own.
    pub(crate) fn judge(&self, picture: &[f64]) -> Errors {
        let pixels = || picture.iter().zip(&self.estimates);
        let square = mean(pixels().map(|(x, [a, b])| (x - a) * (x - b)));
        // The noise of the product about a right picture, whose distances are the halves' own.
        let spread = mean(self.estimates.iter().map(|[a, b]| 0.25 * (a - b).powi(4)));
        let error = (spread / self.estimates.len() as f64).sqrt();
        Errors {
            rmse: square.max(0.0).sqrt() / self.mean(),
            least: (2.0 * error).sqrt() / self.mean(),
            bias: mean(picture.iter().copied()) / self.mean() - 1.0,
        }
    }
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len();
    values.sum::<f64>() / count as f64
}

#[cfg(test)]
mod tests {
    use super::Halves;
    use crate::pattern::Jitter;

    /// A picture of ones and twos, and halves that are wrong by uniform noise of this deviation.
    fn noisy(deviation: f64) -> (Vec<f64>, Halves) {
        let mut jitter = Jitter::new(4);
        let truth: Vec<f64> = (0..10_000).map(|k| f64::from(1 + k % 2)).collect();
        let noise = |x: f64| (x - 0.5) * 12.0_f64.sqrt() * deviation;
        let estimates = truth.iter().map(|t| jitter.next().map(|x| t + noise(x))).collect();
        (truth, Halves { estimates })
    }

    #[test]
    fn errors_are_found_below_the_noise() {
        let (truth, halves) = noisy(0.3);
        assert!((halves.mean() - 1.5).abs() < 0.01);
        // Half the deviation of a difference: 0.3 / sqrt 2, over the mean.
        assert!((halves.noise() - 0.3 / 2.0_f64.sqrt() / 1.5).abs() < 0.005);
        let right = halves.judge(&truth);
        assert!(right.rmse < right.least && right.least < 0.3 * halves.noise(), "{right:?}");
        let off: Vec<_> = truth.iter().map(|t| t + 0.15).collect();
        let wrong = halves.judge(&off);
        assert!((wrong.rmse - 0.1).abs() < 0.01 && (wrong.bias - 0.1).abs() < 0.01, "{wrong:?}");
    }

    #[test]
    fn without_noise_errors_are_exact() {
        let (truth, halves) = noisy(0.0);
        let errors = halves.judge(&truth);
        assert_eq!([errors.rmse, errors.least, errors.bias, halves.noise()], [0.0; 4]);
    }
}
