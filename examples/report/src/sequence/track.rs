//! One method through a sequence: its peaks, and how its error varies in time and over the picture.

use serde::Serialize;

use super::Converged;
use crate::method::Method;

/// What one method made of a sequence, on the sequence's scale.
#[derive(Serialize)]
pub(crate) struct Track {
    pub(crate) method: String,
    pub(crate) samples: u32,
    pub(crate) filters: bool,
    /// The pixel filter whose reference it is held against.
    pub(crate) window: &'static str,
    /// Largest radiance of each frame.
    pub(crate) peaks: Vec<f64>,
    /// Root mean square over pixels of the standard deviation in time of x - r.
    pub(crate) flicker: f64,
    /// Standard deviation of x - r over frames and pixels.
    pub(crate) deviation: f64,
    /// Mean over frames of the peak over its reference's.
    pub(crate) peak_ratio: f64,
    /// The peak's largest change from one frame to the next, over its reference's.
    pub(crate) jump_ratio: f64,
    /// Standard error of its reference.
    pub(crate) noise: f64,
    /// Where it is farthest from its reference.
    pub(crate) worst: Worst,
}

/// The pixel and the frame with the largest error, both counted from 0.
#[derive(Clone, Copy, Default, Serialize)]
pub(crate) struct Worst {
    /// |x - r|.
    pub(crate) error: f64,
    pub(crate) frame: usize,
    pub(crate) pixel: usize,
    /// Degrees of the half vector over the shaded surface.
    pub(crate) elevation: f64,
}

impl Track {
    /// `elevation` tells how high the half vector stands, in degrees, in a frame and pixel.
    pub(super) fn new(
        method: &Method,
        tally: &Tally,
        scale: f64,
        reference: &Converged,
        elevation: impl Fn(usize, usize) -> f64,
    ) -> Self {
        let Worst { error, frame, pixel, .. } = tally.worst;
        let peaks: Vec<_> = tally.peaks.iter().map(|peak| peak * scale).collect();
        let ratios = peaks.iter().zip(&reference.peaks).map(|(peak, right)| peak / right);
        Self {
            method: method.name.clone(),
            samples: method.samples,
            filters: method.filters(),
            window: reference.window,
            flicker: scale * tally.flicker(),
            deviation: scale * tally.deviation(),
            peak_ratio: ratios.sum::<f64>() / peaks.len() as f64,
            jump_ratio: largest_jump(&peaks) / largest_jump(&reference.peaks),
            peaks,
            noise: reference.noise,
            worst: Worst {
                error: scale * error,
                elevation: elevation(frame, pixel),
                ..tally.worst
            },
        }
    }
}

/// The largest change from one value to the next.
fn largest_jump(values: &[f64]) -> f64 {
    values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).fold(0.0, f64::max)
}

/// The largest of the judged values.
pub(super) fn peak(values: impl Iterator<Item = f64>, judged: &[bool]) -> f64 {
    values.zip(judged).filter(|(_, judged)| **judged).map(|(value, _)| value).fold(0.0, f64::max)
}

/// Mean of some numbers and the sum of their squared distances from it, by Welford's updates: equal
/// numbers have no distances, to the last bit.
#[derive(Clone, Copy, Default)]
struct Moments {
    count: f64,
    mean: f64,
    squares: f64,
}

impl Moments {
    fn push(&mut self, value: f64) {
        self.count += 1.0;
        let distance = value - self.mean;
        self.mean += distance / self.count;
        self.squares += distance * (value - self.mean);
    }
}

/// What is summed up of a method frame by frame, not yet scaled.
pub(crate) struct Tally {
    frames: usize,
    peaks: Vec<f64>,
    /// Without its elevation.
    worst: Worst,
    /// Of x - r at each pixel, in the frames in which it was judged.
    pixels: Vec<Moments>,
}

impl Tally {
    pub(crate) fn new(pixels: usize) -> Self {
        Self {
            frames: 0,
            peaks: Vec::new(),
            worst: Worst::default(),
            pixels: vec![Moments::default(); pixels],
        }
    }

    /// Adds a frame.
    pub(crate) fn push(&mut self, picture: &[f32], reference: &[f64], judged: &[bool]) {
        self.peaks.push(peak(picture.iter().map(|&x| f64::from(x)), judged));
        let values = picture.iter().zip(reference).map(|(&x, r)| f64::from(x) - r);
        let pixels = self.pixels.iter_mut().zip(values).enumerate().zip(judged);
        for ((pixel, (moments, value)), _) in pixels.filter(|(_, judged)| **judged) {
            moments.push(value);
            if value.abs() > self.worst.error {
                let (error, frame) = (value.abs(), self.frames);
                self.worst = Worst { error, frame, pixel, ..self.worst };
            }
        }
        self.frames += 1;
    }

    /// Largest value of each frame.
    pub(crate) fn peaks(&self) -> &[f64] {
        &self.peaks
    }

    /// Root mean square over the pixels that were judged in every frame of the standard deviation
    /// in time.
    pub(crate) fn flicker(&self) -> f64 {
        let frames = self.frames as f64;
        let always = self.pixels.iter().filter(|pixel| pixel.count == frames);
        let (sum, count) = always.fold((0.0, 0.0), |(sum, count), pixel| {
            (sum + pixel.squares / pixel.count, count + 1.0)
        });
        (sum / count).sqrt()
    }

    /// Over all that was judged.
    fn deviation(&self) -> f64 {
        let count: f64 = self.pixels.iter().map(|pixel| pixel.count).sum();
        let mean = self.pixels.iter().map(|p| p.count * p.mean).sum::<f64>() / count;
        let squares = |pixel: &Moments| pixel.squares + pixel.count * (pixel.mean - mean).powi(2);
        (self.pixels.iter().map(squares).sum::<f64>() / count).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::{Tally, largest_jump};

    #[test]
    fn known_numbers() {
        let mut tally = Tally::new(4);
        // The last pixel is never judged, the third only once.
        tally.push(&[1.0, 5.0, 9.0, 100.0], &[0.0, 4.0, 3.0, 0.0], &[true, true, true, false]);
        tally.push(&[4.0, 2.0, 50.0, 100.0], &[1.0, 1.0, 0.0, 0.0], &[true, true, false, false]);
        assert_eq!(tally.peaks, [9.0, 4.0]);
        // Errors 1 and 3: a deviation in time of 1; 1 and 1: of 0; 6 stands alone.
        assert!((tally.flicker() - 0.5_f64.sqrt()).abs() < 1e-15);
        // Of 1, 3, 1, 1, 6 the mean is 2.4, the variance (1.96 * 3 + 0.36 + 12.96) / 5.
        assert!((tally.deviation() - (19.2_f64 / 5.0).sqrt()).abs() < 1e-15);
        assert_eq!((tally.worst.error, tally.worst.frame, tally.worst.pixel), (6.0, 0, 2));
        assert_eq!(largest_jump(&[3.0, 1.0, 6.0, 5.0]), 5.0);
    }

    #[test]
    fn what_does_not_change_does_not_flicker_whatever_its_error() {
        let mut tally = Tally::new(2);
        for _ in 0..7 {
            tally.push(&[0.1, 0.7], &[0.3, 0.3], &[true; 2]);
        }
        assert_eq!(tally.flicker(), 0.0);
        assert!((tally.deviation() - 0.3).abs() < 1e-7);
    }
}
