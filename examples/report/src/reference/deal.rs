//! How many samples each pixel gets: more where the pilot's halves differ.

use super::{CHANNELS, Halves, MOST_STRATA, Sampling};
use crate::camera::Size;
use crate::metric;

/// Strata of every pixel.
///
/// With errors c/n, the sum of squares is smallest for n like c^(2/3). A pixel's c is the pilot's
/// difference around it: a glint that the pilot missed has neighbors that it did not. Absolute and
/// relative errors have an equal say, as have alphas and distributions. Pixels that no window needs
/// get the fewest.
pub(super) fn deal(sampling: Sampling, pilot: &[Halves], needed: &[bool], size: Size) -> Vec<u32> {
    let mut shares = vec![0.0; pilot.len()];
    for k in 0..CHANNELS {
        let mean =
            pilot.iter().map(|h| 0.5 * (h[0][k] + h[1][k])).sum::<f64>() / shares.len() as f64;
        let square = |(h, needed): (&Halves, &bool)| {
            if *needed { (h[0][k] - h[1][k]).powi(2) } else { 0.0 }
        };
        let relative = |(h, needed): (&Halves, &bool)| {
            let radiance = 0.5 * (h[0][k] + h[1][k]);
            let softened = radiance * radiance + metric::SOFTENING * mean * mean;
            if softened > 0.0 { square((h, needed)) / softened } else { 0.0 }
        };
        add_shares(&mut shares, pilot.iter().zip(needed).map(square));
        add_shares(&mut shares, pilot.iter().zip(needed).map(relative));
    }
    let wishes: Vec<f64> = around(&shares, size).into_iter().map(f64::cbrt).collect();
    let sum: f64 = wishes.iter().sum();
    let samples = f64::from(sampling.samples) * pilot.len() as f64;
    let strata = |wish: &f64| {
        let per_half = if sum > 0.0 { 0.5 * samples * wish / sum } else { 0.0 };
        // Between the two bounds: the cast only rounds.
        #[allow(clippy::cast_sign_loss)]
        let strata = per_half.sqrt().min(f64::from(MOST_STRATA)).round() as u32;
        strata.max(sampling.fewest)
    };
    wishes.iter().map(strata).collect()
}

/// Adds to each share the value's part of the sum of all values, if there is one.
fn add_shares(shares: &mut [f64], values: impl Iterator<Item = f64> + Clone) {
    let sum: f64 = values.clone().sum();
    if sum > 0.0 && sum.is_finite() {
        shares.iter_mut().zip(values).for_each(|(share, value)| *share += value / sum);
    }
}

/// Means over the 5 x 5 pixels around each, fewer at the borders.
fn around(values: &[f64], size: Size) -> Vec<f64> {
    const REACH: usize = 2;
    let near = |at: usize, end: usize| at.saturating_sub(REACH)..(at + REACH + 1).min(end);
    let mean = |index: usize| {
        let (x, y) = (index % size.width, index / size.width);
        let (columns, rows) = (near(x, size.width), near(y, size.height));
        let count = (columns.len() * rows.len()) as f64;
        rows.flat_map(|y| &values[y * size.width..][columns.clone()]).sum::<f64>() / count
    };
    (0..values.len()).map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::{CHANNELS, Sampling, around, deal};
    use crate::camera::Size;

    #[test]
    fn samples_go_where_the_pilot_s_halves_differ_and_a_window_needs_them() {
        let size = Size { width: 20, height: 10 };
        let even = vec![[[1.0; CHANNELS]; 2]; size.pixels()];
        let mut pilot = even.clone();
        pilot[5 * 20 + 10][0][0] = 9.0;
        let sampling = Sampling::of_frame(200);
        let strata = deal(sampling, &pilot, &vec![true; size.pixels()], size);
        assert!(strata[5 * 20 + 10] > 20 && strata[4 * 20 + 11] > 20);
        assert_eq!(strata[0], sampling.fewest);
        for (pilot, needed) in [(even, true), (pilot, false)] {
            let strata = deal(sampling, &pilot, &vec![needed; size.pixels()], size);
            assert!(strata.iter().all(|&n| n == sampling.fewest));
        }
    }

    #[test]
    fn means_around_a_pixel_stay_inside_the_picture() {
        let size = Size { width: 4, height: 3 };
        let ones = around(&[1.0; 12], size);
        assert!(ones.iter().all(|&x| (x - 1.0).abs() < 1e-15));
    }
}
