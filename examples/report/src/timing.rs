//! Nanoseconds per sample: one thread, all methods in turn, medians.

use std::hint::black_box;
use std::time::Instant;

use crate::camera::Size;
use crate::method::{Material, Method, Rows};
use crate::render::sample_row;
use crate::scene::{Sample, Scene};

/// Pixels per pass: few enough that their samples stay in cache, as a tile's would, and that most passes
/// end before another process interrupts them; the median then knows nothing of the others.
const PIXELS: usize = 4096;

/// Medians over the rounds, nanoseconds per sample.
pub(crate) struct Timing {
    /// Ray, hit, normal, frame, directions.
    pub(crate) geometry: f64,
    /// Each method's shading, footprint differences included, in the order given.
    pub(crate) shading: Vec<f64>,
}

/// A row with its samples and those of the row above.
struct Band {
    y: f32,
    here: Vec<Sample<f32>>,
    above: Vec<Sample<f32>>,
}

/// Times geometry and the shading of every method on rows spread over the picture.
///
/// Rounds are interleaved, so that a change of clock or a busy neighbour touches all methods alike, and
/// each begins with another method; the first is a warm-up and does not count.
pub(crate) fn measure(
    scene: &Scene<f32>,
    size: Size,
    material: &Material,
    methods: &[&Method],
    rounds: usize,
) -> Timing {
    let count = (PIXELS / size.width).clamp(1, size.height);
    let mut bands: Vec<_> = (0..count)
        .map(|k| {
            let y = (k * size.height / count) as f32;
            let [mut here, mut above] = [Vec::new(), Vec::new()];
            sample_row(scene, y, [0.5, 0.5], size.width + 1, &mut here);
            sample_row(scene, y - 1.0, [0.5, 0.5], size.width + 1, &mut above);
            Band { y, here, above }
        })
        .collect();
    let mut out = vec![0.0; size.width];
    let shaded = (count * size.width) as f64;
    let sampled = (count * (size.width + 1)) as f64;

    let mut times = vec![Vec::with_capacity(rounds); methods.len() + 1];
    for round in 0..=rounds {
        for turn in 0..=methods.len() {
            let task = (round + turn) % (methods.len() + 1);
            let nanoseconds = if let Some(method) = methods.get(task) {
                let start = Instant::now();
                for band in &bands {
                    let rows = Rows { here: &band.here, above: &band.above };
                    method.shade(black_box(material), black_box(&rows), &mut out);
                    black_box(&mut out);
                }
                start.elapsed().as_secs_f64() * 1e9 / shaded
            } else {
                let start = Instant::now();
                for band in &mut bands {
                    sample_row(scene, band.y, [0.5, 0.5], size.width + 1, &mut band.here);
                    black_box(&mut band.here);
                }
                start.elapsed().as_secs_f64() * 1e9 / sampled
            };
            if round > 0 {
                times[task].push(nanoseconds);
            }
        }
    }
    let mut shading: Vec<_> = times.into_iter().map(median).collect();
    let geometry = shading.pop().unwrap_or_default();
    Timing { geometry, shading }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => 0.0,
        n if n % 2 == 1 => values[n / 2],
        n => 0.5 * (values[n / 2 - 1] + values[n / 2]),
    }
}

/// The processor's name where the system tells it, else the target's architecture.
pub(crate) fn processor() -> String {
    let listed = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = listed.lines().find_map(|line| line.strip_prefix("model name"));
    match model.and_then(|rest| rest.split_once(':')) {
        Some((_, name)) => name.trim().into(),
        None => std::env::consts::ARCH.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::{median, processor};

    #[test]
    fn medians_of_odd_and_even_counts() {
        assert_eq!(median(vec![3.0, 1.0, 9.0]), 3.0);
        assert_eq!(median(vec![4.0, 1.0, 2.0, 9.0]), 3.0);
    }

    #[test]
    fn the_processor_has_a_name() {
        assert!(!processor().is_empty());
    }
}
