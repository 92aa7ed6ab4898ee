//! Nanoseconds per pixel: ray, texture lookups and shading, on one thread.

use std::hint::black_box;
use std::time::Instant;

use super::ground::Ground;
use super::method::Method;
use crate::camera::Size;
use crate::method::Distribution;
use crate::timing::median;

/// Pixels per pass, about: so few that even those of 64 samples mostly end before another process interrupts them.
const PIXELS: usize = 256;

/// Medians over the rounds for every method, which take turns and begin with another each round; the first round is
/// a warm-up.
pub(super) fn measure(
    methods: &[Method],
    kind: Distribution,
    ground: &Ground<'_>,
    size: Size,
    rounds: usize,
) -> Vec<f64> {
    // Rows spread over the picture: near and far texels alike.
    let step = size.pixels().div_ceil(PIXELS);
    let rows: Vec<_> = (step / 2..size.height).step_by(step).collect();
    let count = (rows.len() * size.width).max(1) as f64;
    let mut out = vec![0.0; size.width];
    let mut times = vec![Vec::with_capacity(rounds); methods.len()];
    for round in 0..=rounds {
        for turn in 0..methods.len() {
            let index = (round + turn) % methods.len();
            let start = Instant::now();
            for &y in &rows {
                methods[index].row(kind, black_box(ground), y, &mut out);
                black_box(&mut out);
            }
            if round > 0 {
                times[index].push(start.elapsed().as_secs_f64() * 1e9 / count);
            }
        }
    }
    times.into_iter().map(median).collect()
}
