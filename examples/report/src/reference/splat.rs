//! From a pixel's cells to the windows of the pixels around it.

use super::{CHANNELS, Cell};
use crate::window::{CELLS, MARGIN, OFFSETS, PerWindow, PixelWindow, Weights};

/// Numbers of a cell: radiances and hits of both halves.
const PARTS: usize = 2 * (CHANNELS + 1);

/// Weighted sums of a pixel's windows: radiances and hits of both halves.
#[derive(Clone, Copy, Default)]
pub(super) struct Sums(PerWindow<[f64; PARTS]>);

impl Sums {
    pub(super) fn add(&mut self, other: &Self) {
        let pairs = self.0.iter_mut().flatten().zip(other.0.iter().flatten());
        pairs.for_each(|(sum, added)| *sum += added);
    }

    /// A window's two means over what it covers of the surface; 0 where it covers none.
    pub(super) fn means(&self, window: PixelWindow, channel: usize) -> [f64; 2] {
        let parts = &self.0[window as usize];
        [0, 1].map(|half| {
            let [sum, hits] = [channel, CHANNELS].map(|k| parts[half * (CHANNELS + 1) + k]);
            if hits > 0.0 { sum / hits } else { 0.0 }
        })
    }
}

/// Cells' weights in every window.
pub(super) struct Splatter(PerWindow<Weights>);

impl Splatter {
    /// Weights as densities: cells hold integrals.
    pub(super) fn new() -> Self {
        let density = |row: [f64; CELLS]| row.map(|weight| weight * CELLS as f64);
        Self(PixelWindow::ALL.map(|window| window.weights().map(density)))
    }

    /// What a row of pixels, margin included, adds to the picture's rows from [`MARGIN`] before it to as many
    /// behind it.
    pub(super) fn spread(&self, row: &[[Cell; CELLS * CELLS]], width: usize) -> Vec<Vec<Sums>> {
        let mut spread = vec![vec![Sums::default(); width]; OFFSETS];
        for (x, cells) in row.iter().enumerate() {
            let parts = cells.map(|cell| {
                let mut parts = [0.0; PARTS];
                for half in 0..2 {
                    let start = half * (CHANNELS + 1);
                    parts[start..start + CHANNELS].copy_from_slice(&cell.radiance[half]);
                    parts[start + CHANNELS] = cell.hits[half];
                }
                parts
            });
            for (window, weights) in self.0.iter().enumerate() {
                for (offset, across) in weights.iter().enumerate() {
                    // The pixel at this offset, counted without the margin.
                    let Some(place) = (x + offset).checked_sub(2 * MARGIN) else { continue };
                    if place >= width || across.iter().all(|weight| *weight == 0.0) {
                        continue;
                    }
                    for (cell_row, cells) in parts.chunks_exact(CELLS).enumerate() {
                        let sum = weighted(cells, across);
                        for (spread, down) in spread.iter_mut().zip(weights) {
                            let target = spread[place].0[window].iter_mut();
                            target
                                .zip(sum)
                                .for_each(|(target, sum)| *target += down[cell_row] * sum);
                        }
                    }
                }
            }
        }
        spread
    }
}

/// A row of cells under its weights.
fn weighted(cells: &[[f64; PARTS]], weights: &[f64; CELLS]) -> [f64; PARTS] {
    let mut sum = [0.0; PARTS];
    for (cell, weight) in cells.iter().zip(weights) {
        sum.iter_mut().zip(cell).for_each(|(sum, part)| *sum += weight * part);
    }
    sum
}
