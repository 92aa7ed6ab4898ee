//! Nanoseconds per pixel: ray, texture lookups and shading, on one thread.

use std::hint::black_box;

use super::ground::Ground;
use super::method::Method;
use crate::camera::Size;
use crate::method::Distribution;
use crate::timing::in_turns;

/// Pixels per pass, about: so few that even those of 64 samples mostly end before another process
/// interrupts them.
const PIXELS: usize = 256;

/// Of every method, the methods taking turns.
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
    let times = in_turns(methods.len(), rounds, |method| {
        for &y in &rows {
            methods[method].row(kind, black_box(ground), y, &mut out);
            black_box(&mut out);
        }
    });
    times.into_iter().map(|time| time / count).collect()
}
