//! Pixel filters of the reference: the box and three Gaussians, over a pixel's cells.

use lobe::{PixelFilter, Real};
use serde::Serialize;

/// A pixel filter that references are made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum PixelWindow {
    /// The pixel itself.
    Box,
    /// A Gaussian of the box's variance, 1/12.
    GaussianTwelfth,
    /// A Gaussian whose peak is one per pixel, variance 1/(2 pi).
    GaussianUnitPeak,
    /// A Gaussian of variance 1/4.
    GaussianQuarter,
}

/// Something for every window, in the order of [`PixelWindow::ALL`].
pub(crate) type PerWindow<T> = [T; PixelWindow::ALL.len()];

/// Cells along each side of a pixel: windows are constant over one.
pub(crate) const CELLS: usize = 16;

/// Pixels that a window reaches beyond its own, on each side. Gaussians end two pixels from the
/// center.
pub(crate) const MARGIN: usize = 2;

/// Offsets of the pixels that a cell contributes to: from [`MARGIN`] before its own to as many
/// behind it.
pub(crate) const OFFSETS: usize = 2 * MARGIN + 1;

/// Weight of each cell of a pixel, along one axis, in the windows of the pixels around it:
/// `[offset][cell]`. Sums to 1 over all offsets and cells.
pub(crate) type Weights = [[f64; CELLS]; OFFSETS];

impl PixelWindow {
    pub(crate) const ALL: [Self; 4] =
        [Self::Box, Self::GaussianTwelfth, Self::GaussianUnitPeak, Self::GaussianQuarter];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Box => "box",
            Self::GaussianTwelfth => "Gaussian 1/12",
            Self::GaussianUnitPeak => "Gaussian 1/(2\u{3c0})",
            Self::GaussianQuarter => "Gaussian 1/4",
        }
    }

    /// Variance of the Gaussian along an axis, in squared pixels; `None` for the box.
    fn variance(self) -> Option<f64> {
        match self {
            Self::Box => None,
            Self::GaussianTwelfth => Some(PixelFilter::BOX.variance()),
            Self::GaussianUnitPeak => Some(PixelFilter::TOKUYOSHI_KAPLANYAN.variance()),
            Self::GaussianQuarter => Some(PixelFilter::KAPLANYAN.variance()),
        }
    }

    /// The window's exact integral over each cell, along one axis, normalized.
    pub(crate) fn weights(self) -> Weights {
        let mass = |from: f64, to: f64| match self.variance() {
            None => (to.min(0.5) - from.max(-0.5)).max(0.0),
            Some(variance) => {
                let scale = 1.0 / (2.0 * variance).sqrt();
                let end = MARGIN as f64;
                let [from, to] = [from, to].map(|x| x.clamp(-end, end) * scale);
                0.5 * (Real::erfc(from) - Real::erfc(to))
            }
        };
        let step = 1.0 / CELLS as f64;
        let mut weights = [[0.0; CELLS]; OFFSETS];
        for (offset, row) in weights.iter_mut().enumerate() {
            // Where the cell's pixel begins, from the window's center.
            let start = MARGIN as f64 - offset as f64 - 0.5;
            for (cell, weight) in row.iter_mut().enumerate() {
                let from = start + cell as f64 * step;
                *weight = mass(from, from + step);
            }
        }
        let sum: f64 = weights.iter().flatten().sum();
        weights.map(|row| row.map(|weight| weight / sum))
    }
}

#[cfg(test)]
mod tests {
    use super::{CELLS, MARGIN, PixelWindow};

    #[test]
    fn windows_have_mass_one_mean_zero_and_their_variance() {
        // Cut at n deviations, a Gaussian loses about 2 n phi(n) of its variance, phi the normal
        // density.
        for (window, variance, tolerance) in [
            (PixelWindow::Box, 1.0 / 12.0, 1e-12),
            (PixelWindow::GaussianTwelfth, 1.0 / 12.0, 1e-8),
            (PixelWindow::GaussianUnitPeak, 0.5 / std::f64::consts::PI, 3e-6),
            (PixelWindow::GaussianQuarter, 0.25, 3e-4),
        ] {
            let weights = window.weights();
            let (mut mass, mut mean, mut square) = (0.0, 0.0, 0.0);
            for (offset, row) in weights.iter().enumerate() {
                for (cell, weight) in row.iter().enumerate() {
                    let x =
                        (cell as f64 + 0.5) / CELLS as f64 - 0.5 + MARGIN as f64 - offset as f64;
                    mass += weight;
                    mean += weight * x;
                    square += weight * x * x;
                }
            }
            // Within a cell a density is nearly straight: Sheppard's correction for cell centers.
            let cell = 1.0 / (CELLS as f64 * CELLS as f64 * 12.0);
            let inside = if window == PixelWindow::Box { cell } else { -cell };
            assert!((mass - 1.0).abs() < 1e-14 && mean.abs() < 1e-14);
            assert!((square + inside - variance).abs() < tolerance, "{window:?} {square}");
        }
    }
}
