//! What pixels should be: the mean over many points of each, none of them filtered.

use rayon::prelude::*;

use super::method::{Filter, Surface};
use super::stage::Stage;
use crate::pattern::Jitter;

/// A converged picture.
pub(super) struct Reference {
    pub(super) radiance: Vec<f64>,
    /// Pixels that lie on the body with all their points.
    pub(super) judged: Vec<bool>,
    /// Root mean square over judged pixels of what two halves of the points tell of their mean's
    /// error.
    pub(super) noise: f64,
}

impl Reference {
    /// Jittered points in `side` rows and columns of each pixel; those of a checkerboard make a
    /// half.
    pub(super) fn of(stage: &Stage, surface: &Surface<f64>, side: u32) -> Self {
        let width = stage.size.width;
        let pixels: Vec<_> = (0..stage.size.pixels())
            .into_par_iter()
            .map(|index| {
                let corner = [index % width, index / width].map(|k| k as f64);
                let mut jitter = Jitter::new(index as u64);
                let (mut sums, mut counts) = ([0.0; 2], [0.0; 2]);
                for (row, column) in (0..side).flat_map(|r| (0..side).map(move |c| (r, c))) {
                    let [right, below] = jitter.next();
                    let x = corner[0] + (f64::from(column) + right) / f64::from(side);
                    let y = corner[1] + (f64::from(row) + below) / f64::from(side);
                    if let Some(points) = stage.points(x, y) {
                        let half = usize::from((row + column) % 2 == 1);
                        sums[half] += surface.sum(Filter::None, &points);
                        counts[half] += 1.0;
                    }
                }
                let whole = counts[0] + counts[1] == f64::from(side * side);
                let means = [0, 1].map(|k| sums[k] / f64::max(counts[k], 1.0));
                (0.5 * (means[0] + means[1]), whole, 0.5 * (means[0] - means[1]))
            })
            .collect();
        let judged = pixels.iter().filter(|pixel| pixel.1);
        let squares: f64 = judged.clone().map(|pixel| pixel.2 * pixel.2).sum();
        Self {
            noise: (squares / f64::max(judged.count() as f64, 1.0)).sqrt(),
            radiance: pixels.iter().map(|pixel| pixel.0).collect(),
            judged: pixels.iter().map(|pixel| pixel.1).collect(),
        }
    }
}
