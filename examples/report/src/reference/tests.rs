//! The reference against itself, against constants and against direct sums.

use super::splat::{Splatter, Sums};
use super::{CHANNELS, Cell, Distribution, Sampling, Target};
use crate::camera::Size;
use crate::coverage;
use crate::light::LightKind;
use crate::scene::Subject;
use crate::window::{CELLS, MARGIN, PixelWindow};

fn render(subject: &Subject, samples: u32, alphas: &[f64]) -> (super::References, Vec<bool>) {
    let scene = subject.lit(LightKind::Distant).exact;
    let judged = coverage::judged(&scene, subject.size);
    let target = Target {
        scene: &scene,
        size: subject.size,
        finish: subject.finish,
        alphas,
        judged: &judged,
    };
    (Sampling::of_still(samples).render(&target, &|| ()).unwrap(), judged)
}

#[test]
fn more_samples_agree_within_the_noise_they_state_under_every_window() {
    let subject = Subject::water(Size::of_width(16));
    let [(few, _), (many, _)] = [256, 4096].map(|samples| render(&subject, samples, &[0.05]));
    for distribution in Distribution::ALL {
        let (few, many) = (few.of(0, distribution), many.of(0, distribution));
        for window in PixelWindow::ALL.map(|window| window as usize) {
            assert!(many.noise[window] < 0.5 * few.noise[window]);
            let pairs = few.radiance[window].iter().zip(&many.radiance[window]);
            let squares = pairs.map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
            let rms = (squares / few.radiance[window].len() as f64).sqrt();
            assert!(rms < 3.0 * few.noise[window], "{rms} {}", few.noise[window]);
        }
    }
}

#[test]
fn a_constant_under_any_window_is_the_constant_also_at_borders_and_silhouettes() {
    let width = 6;
    let splatter = Splatter::new();
    let area = 1.0 / (CELLS * CELLS) as f64;
    let mut cell = Cell::default();
    for half in 0..2 {
        cell.add(half, area, [3.0 * area; CHANNELS]);
    }
    // Nothing right of the fourth pixel.
    let row: Vec<_> = (0..(width + 2 * MARGIN) * CELLS * CELLS)
        .map(|index| if index / (CELLS * CELLS) < 4 + MARGIN { cell } else { Cell::default() })
        .collect();
    let spread = splatter.spread(&row, width);
    for x in 0..width {
        let mut sums = Sums::default();
        for row in &spread {
            sums.add(&row[x]);
        }
        for window in PixelWindow::ALL {
            let wide = window != PixelWindow::Box;
            let expected = if x < 4 || (wide && x < 6) { 3.0 } else { 0.0 };
            for mean in sums.means(window, 0) {
                assert!((mean - expected).abs() < 1e-12, "{x} {window:?} {mean}");
            }
        }
    }
}

#[test]
fn windows_average_a_picture_that_is_straight_or_square_exactly() {
    // Radiance x^2 over cells, x in pixels from the middle of pixel 4: its mean is the window's
    // variance.
    let splatter = Splatter::new();
    let (width, step) = (9, 1.0 / CELLS as f64);
    let row: Vec<_> = (0..(width + 2 * MARGIN) * CELLS * CELLS)
        .map(|index| {
            let x = (index / (CELLS * CELLS)) as f64 - (4 + MARGIN) as f64;
            let at = x + ((index % CELLS) as f64 + 0.5) * step - 0.5;
            // The mean of x^2 over the cell.
            let square = at * at + step * step / 12.0;
            let mut cell = Cell::default();
            for half in 0..2 {
                cell.add(half, step * step, [square * step * step; CHANNELS]);
            }
            cell
        })
        .collect();
    let spread = splatter.spread(&row, width);
    let mut sums = Sums::default();
    for row in &spread {
        sums.add(&row[4]);
    }
    // A window that is constant over cells is wider than the Gaussian by the variance of two cells.
    let blur = step * step / 6.0;
    for (window, variance, tolerance) in [
        (PixelWindow::Box, 1.0 / 12.0, 1e-12),
        (PixelWindow::GaussianTwelfth, 1.0 / 12.0 + blur, 1e-8),
        (PixelWindow::GaussianUnitPeak, 0.5 / std::f64::consts::PI + blur, 3e-6),
        (PixelWindow::GaussianQuarter, 0.25 + blur, 3e-4),
    ] {
        let [mean, _] = sums.means(window, 1);
        assert!((mean - variance).abs() < tolerance, "{window:?} {mean}");
    }
}

#[test]
fn a_wide_lobe_s_box_mean_is_the_mean_of_its_pixel() {
    let subject = Subject::balls(Size::of_width(48));
    let alphas = [0.3, 0.5];
    let (references, judged) = render(&subject, 512, &alphas);
    let scene = subject.lit(LightKind::Distant).exact;
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    for (index, _) in judged.iter().enumerate().filter(|(_, judged)| **judged) {
        let (x, y) = (index % 48, index / 48);
        let mut sum = 0.0;
        for k in 0..256_u32 {
            let at = |k: u32| (f64::from(k) + 0.5) / 16.0;
            let s = scene.sample(x as f64 + at(k % 16), y as f64 + at(k / 16));
            let ggx = lobe::Ggx::new(lobe::Isotropic::new(0.5).unwrap());
            sum += ggx.brdf(s.wo, s.wi) * s.wi[2] * s.strength / 256.0;
        }
        let reference = references.of(1, Distribution::Ggx).radiance[0][index];
        worst = worst.max((reference - sum).abs());
        largest = largest.max(sum);
    }
    assert!(largest > 0.0 && worst < 0.01 * largest, "{worst} {largest}");
}
