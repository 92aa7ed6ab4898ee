//! How far a picture is from the reference, over the pixels that are judged.

use serde::Serialize;

/// Softens relMSE in the dark: a tenth of the mean radiance, squared.
pub(crate) const SOFTENING: f64 = 0.01;

/// Errors of a picture against a reference, both scaled to a mean reference radiance of 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Errors {
    /// Root mean square of x - r.
    pub rmse: f64,
    /// Mean of $(x - r)^2 / (r^2 + 0.01)$.
    pub rel_mse: f64,
    /// Mean of $2|x - r| / (|x| + |r|)$, 0 where both are 0: from 0 to 2.
    pub smape: f64,
    /// Sum of x over sum of r.
    pub energy: f64,
    /// Largest |x - r|.
    pub worst: f64,
}

/// The factor that brings a reference to mean 1 over the judged pixels; 1 for a black one.
pub(crate) fn scale(reference: &[f64], judged: &[bool]) -> f64 {
    let values = reference.iter().zip(judged).filter(|(_, judged)| **judged);
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), (r, _)| (sum + r, count + 1.0));
    if sum > 0.0 { count / sum } else { 1.0 }
}

impl Errors {
    /// The errors of a picture with as many pixels as the reference, both multiplied by `scale`
    /// first. Without a judged pixel, the means are NaN.
    pub(crate) fn of(picture: &[f32], reference: &[f64], judged: &[bool], scale: f64) -> Self {
        let mut errors = Self { rmse: 0.0, rel_mse: 0.0, smape: 0.0, energy: 0.0, worst: 0.0 };
        let (mut count, mut whole) = (0.0, 0.0);
        let pixels = picture.iter().zip(reference).zip(judged).filter(|(_, judged)| **judged);
        for ((&x, &r), _) in pixels {
            let (x, r) = (f64::from(x) * scale, r * scale);
            let difference = (x - r).abs();
            let size = x.abs() + r.abs();
            errors.rmse += difference * difference;
            errors.rel_mse += difference * difference / (r * r + SOFTENING);
            errors.smape += if size > 0.0 { 2.0 * difference / size } else { 0.0 };
            errors.energy += x;
            errors.worst = errors.worst.max(difference);
            whole += r;
            count += 1.0;
        }
        errors.rmse = (errors.rmse / count).sqrt();
        errors.rel_mse /= count;
        errors.smape /= count;
        errors.energy /= whole;
        errors
    }
}

#[cfg(test)]
mod tests {
    use super::{Errors, scale};

    #[test]
    fn known_numbers_and_pixels_that_are_not_judged() {
        let reference = [2.0, 0.0, 4.0, 2.0, 77.0];
        let judged = [true, true, true, true, false];
        let scale = scale(&reference, &judged);
        assert_eq!(scale, 0.5);
        let errors = Errors::of(&[2.0, 2.0, 0.0, 2.0, -9.0], &reference, &judged, scale);
        // Scaled: r = 1 0 2 1, x = 1 1 0 1, differences 0 1 -2 0.
        assert!((errors.rmse - (5.0_f64 / 4.0).sqrt()).abs() < 1e-15);
        assert!((errors.rel_mse - 0.25 * (1.0 / 0.01 + 4.0 / 4.01)).abs() < 1e-12);
        assert!((errors.smape - 1.0).abs() < 1e-15);
        assert!((errors.energy - 0.75).abs() < 1e-15);
        assert_eq!(errors.worst, 2.0);
    }

    #[test]
    fn a_picture_that_is_the_reference_has_no_error() {
        let (picture, judged) = ([1.0, 0.0], [true; 2]);
        let reference = picture.map(f64::from);
        let errors = Errors::of(&picture, &reference, &judged, scale(&reference, &judged));
        let none = Errors { rmse: 0.0, rel_mse: 0.0, smape: 0.0, energy: 1.0, worst: 0.0 };
        assert_eq!(errors, none);
        assert_eq!(scale(&[0.0, 0.0], &judged), 1.0);
        assert_eq!(scale(&[3.0, 0.0], &[false; 2]), 1.0);
    }
}
