//! Work dealt to threads, and the copy that it is measured against.

use std::hint::black_box;
use std::thread::scope;
use std::time::{Duration, Instant};

/// The parts of a slice, one a thread, each a multiple of `step` (the last one's rest aside); what
/// `each` made of them, in order. `each` is told where its part begins.
pub(crate) fn dealt<T: Send, U: Send>(
    slice: &mut [T],
    step: usize,
    threads: usize,
    each: impl Fn(usize, &mut [T]) -> U + Sync,
) -> Vec<U> {
    let part = slice.len().div_ceil(step).div_ceil(threads).max(1) * step;
    if part >= slice.len() {
        return vec![each(0, slice)];
    }
    let each = &each;
    scope(|scope| {
        let parts = slice.chunks_mut(part).enumerate();
        let workers: Vec<_> =
            parts.map(|(k, out)| scope.spawn(move || each(k * part, out))).collect();
        let joined = workers.into_iter().map(std::thread::ScopedJoinHandle::join);
        joined.map(|made| made.unwrap_or_else(|panic| std::panic::resume_unwind(panic))).collect()
    })
}

/// How long the same threads take to copy the slopes: the best of a few, into memory that is there.
pub(crate) fn copying(slopes: &[[f32; 2]], threads: usize) -> Duration {
    let mut copy = vec![[0.0; 2]; slopes.len()];
    let mut once = || {
        let start = Instant::now();
        dealt(&mut copy, 1, threads, |place, out| {
            out.copy_from_slice(&slopes[place..][..out.len()]);
        });
        black_box(&mut copy);
        start.elapsed()
    };
    // The first one touches the pages.
    once();
    (0..5).map(|_| once()).min().unwrap_or_default()
}
