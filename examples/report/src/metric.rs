//! How far a picture is from the reference.

/// Softens relMSE in the dark: a tenth of the mean radiance, squared.
pub(crate) const SOFTENING: f64 = 0.01;

/// Errors of a picture against a reference, both scaled to a mean reference radiance of 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Errors {
    /// Root mean square of x - r.
    pub(crate) rmse: f64,
    /// Mean of $(x - r)^2 / (r^2 + 0.01)$.
    pub(crate) rel_mse: f64,
    /// Sum of x over sum of r.
    pub(crate) energy: f64,
    /// Largest |x - r|.
    pub(crate) worst: f64,
}

/// The factor that brings a reference to mean 1; 1 for a black one.
pub(crate) fn scale(reference: &[f64]) -> f64 {
    let mean = reference.iter().sum::<f64>() / reference.len() as f64;
    if mean > 0.0 { 1.0 / mean } else { 1.0 }
}

impl Errors {
    /// Of a picture with as many pixels as the reference, both multiplied by `scale` first.
    pub(crate) fn of(picture: &[f32], reference: &[f64], scale: f64) -> Self {
        let mut errors = Self { rmse: 0.0, rel_mse: 0.0, energy: 0.0, worst: 0.0 };
        for (&x, &r) in picture.iter().zip(reference) {
            let (x, r) = (f64::from(x) * scale, r * scale);
            let square = (x - r) * (x - r);
            errors.rmse += square;
            errors.rel_mse += square / (r * r + SOFTENING);
            errors.energy += x;
            errors.worst = errors.worst.max((x - r).abs());
        }
        let count = reference.len() as f64;
        errors.rmse = (errors.rmse / count).sqrt();
        errors.rel_mse /= count;
        errors.energy /= reference.iter().sum::<f64>() * scale;
        errors
    }
}

#[cfg(test)]
mod tests {
    use super::{Errors, scale};

    #[test]
    fn known_numbers() {
        let reference = [2.0, 0.0, 4.0, 2.0];
        let scale = scale(&reference);
        assert_eq!(scale, 0.5);
        let errors = Errors::of(&[2.0, 2.0, 0.0, 2.0], &reference, scale);
        // Scaled: r = 1 0 2 1, x = 1 1 0 1, differences 0 1 -2 0.
        assert!((errors.rmse - (5.0_f64 / 4.0).sqrt()).abs() < 1e-15);
        assert!((errors.rel_mse - 0.25 * (1.0 / 0.01 + 4.0 / 4.01)).abs() < 1e-12);
        assert!((errors.energy - 0.75).abs() < 1e-15);
        assert_eq!(errors.worst, 2.0);
    }

    #[test]
    fn a_picture_that_is_the_reference_has_no_error() {
        let errors = Errors::of(&[1.0, 3.0], &[1.0, 3.0], scale(&[1.0, 3.0]));
        assert_eq!(errors, Errors { rmse: 0.0, rel_mse: 0.0, energy: 1.0, worst: 0.0 });
        assert_eq!(scale(&[0.0, 0.0]), 1.0);
    }
}
