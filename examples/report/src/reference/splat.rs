//! From a pixel's cells to the windows of the pixels around it.

use super::CHANNELS;
use crate::window::{CELLS, MARGIN, OFFSETS, PerWindow, PixelWindow, Weights};

/// Numbers of a cell: radiances and hits of both halves.
const PARTS: usize = 2 * (CHANNELS + 1);

/// Sums over a cell's samples, each with the area that it stands for: radiances and hits of both
/// halves.
#[derive(Clone, Copy, Default)]
pub(super) struct Cell([f64; PARTS]);

impl Cell {
    /// Adds a hit that stands for an area of the pixel, its radiances already times that area.
    #[inline]
    pub(super) fn add(&mut self, half: usize, area: f64, values: [f64; CHANNELS]) {
        let parts = &mut self.0[half * (CHANNELS + 1)..][..=CHANNELS];
        parts.iter_mut().zip(values).for_each(|(part, value)| *part += value);
        parts[CHANNELS] += area;
    }
}

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

    /// What a row of pixels, margin included, adds to the picture's rows from [`MARGIN`] before it
    /// to as many behind it.
    pub(super) fn spread(&self, row: &[Cell], width: usize) -> Vec<Vec<Sums>> {
        let mut spread = vec![vec![Sums::default(); width]; OFFSETS];
        for (x, cells) in row.chunks_exact(CELLS * CELLS).enumerate() {
            // Where there is no surface there is nothing to spread.
            if cells.iter().all(|cell| cell.0[CHANNELS] == 0.0) {
                continue;
            }
            for (window, weights) in self.0.iter().enumerate() {
                for (offset, across) in weights.iter().enumerate() {
                    // The pixel at this offset, counted without the margin.
                    let Some(place) = (x + offset).checked_sub(2 * MARGIN) else { continue };
                    if place >= width || across.iter().all(|weight| *weight == 0.0) {
                        continue;
                    }
                    for (cell_row, cells) in cells.chunks_exact(CELLS).enumerate() {
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
fn weighted(cells: &[Cell], weights: &[f64; CELLS]) -> [f64; PARTS] {
    let mut sum = [0.0; PARTS];
    for (cell, weight) in cells.iter().zip(weights) {
        sum.iter_mut().zip(cell.0).for_each(|(sum, part)| *sum += weight * part);
    }
    sum
}
