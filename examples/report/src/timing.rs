//! Nanoseconds per sample: one thread, all methods in turn, medians.

use std::hint::black_box;
use std::time::Instant;

use crate::camera::Size;
use crate::method::{Method, Rows, Surfacing};
use crate::scene::{Motions, Sample, Scene};

/// Pixels per pass: few enough that their samples stay in cache, as a tile's would, and that most
/// passes end before another process interrupts them; the median then knows nothing of the others.
const PIXELS: usize = 4096;

/// Medians over the rounds, nanoseconds per sample.
#[derive(Clone)]
pub(crate) struct Timing {
    /// Ray, hit, normal, frame, directions.
    pub(crate) geometry: f64,
    /// What the motions of analytic derivatives take on top.
    pub(crate) motion: f64,
    /// Each method's shading, footprints included, in the order given.
    pub(crate) shading: Vec<f64>,
}

/// Quads of the picture, the upper rows in one row and the lower ones in another.
struct Quads {
    places: Vec<[f32; 2]>,
    here: Vec<Sample<f32>>,
    other: Vec<Sample<f32>>,
    motions: Vec<Motions<f32>>,
}

impl Quads {
    /// Quads whose upper pixels are judged, spread over the picture; any quads where none is.
    fn of(scene: &Scene<f32>, size: Size, judged: &[bool]) -> Self {
        let corners = (0..size.height)
            .step_by(2)
            .flat_map(|y| (0..size.width - size.width % 2).step_by(2).map(move |x| (x, y)));
        let is_judged = |&(x, y): &(usize, usize)| {
            let index = y * size.width + x;
            judged[index] && judged[index + 1]
        };
        let mut chosen: Vec<_> = corners.clone().filter(is_judged).collect();
        if chosen.is_empty() {
            chosen = corners.collect();
        }
        let step = chosen.len().div_ceil(PIXELS / 2).max(1);
        let places: Vec<_> = chosen
            .into_iter()
            .step_by(step)
            .flat_map(|(x, y)| [0.5, 1.5].map(|k| [x as f32 + k, y as f32 + 0.5]))
            .collect();
        let here = places.iter().map(|p| scene.sample(p[0], p[1])).collect();
        let other = places.iter().map(|p| scene.sample(p[0], p[1] + 1.0)).collect();
        let motions = places.iter().map(|p| scene.sample_in_motion(p[0], p[1]).1).collect();
        Self { places, here, other, motions }
    }
}

/// Times geometry, motions and the shading of every method, in nanoseconds per sample.
pub(crate) fn measure(
    scene: &Scene<f32>,
    size: Size,
    judged: &[bool],
    surfacing: &Surfacing,
    methods: &[&Method],
    rounds: usize,
) -> Timing {
    let quads = Quads::of(scene, size, judged);
    let count = quads.places.len();
    let (mut samples, mut motions) = (quads.here.clone(), quads.motions.clone());
    let mut out = vec![0.0; count];
    let mut shading = in_turns(methods.len() + 2, rounds, |task| {
        if let Some(method) = methods.get(task) {
            let rows = Rows { here: &quads.here, other: &quads.other, motions: &quads.motions };
            method.shade(black_box(surfacing), black_box(&rows), &mut out);
            black_box(&mut out);
        } else if task == methods.len() {
            for (sample, place) in samples.iter_mut().zip(&quads.places) {
                *sample = scene.sample(place[0], place[1]);
            }
            black_box(&mut samples);
        } else {
            for ((sample, motions), place) in
                samples.iter_mut().zip(&mut motions).zip(&quads.places)
            {
                (*sample, *motions) = scene.sample_in_motion(place[0], place[1]);
            }
            black_box((&mut samples, &mut motions));
        }
    });
    for time in &mut shading {
        *time /= count as f64;
    }
    let in_motion = shading.pop().unwrap_or_default();
    let geometry = shading.pop().unwrap_or_default();
    Timing { geometry, motion: (in_motion - geometry).max(0.0), shading }
}

/// Medians of the nanoseconds of `count` tasks, which take turns.
///
/// Rounds are interleaved, so that a change of clock or a busy neighbor touches all tasks alike,
/// and each begins with another task; the first is a warm-up and does not count.
pub(crate) fn in_turns(count: usize, rounds: usize, mut run: impl FnMut(usize)) -> Vec<f64> {
    let mut times = vec![Vec::with_capacity(rounds); count];
    for round in 0..=rounds {
        for turn in 0..count {
            let task = (round + turn) % count;
            let start = Instant::now();
            run(task);
            let nanoseconds = start.elapsed().as_secs_f64() * 1e9;
            if round > 0 {
                times[task].push(nanoseconds);
            }
        }
    }
    times.into_iter().map(median).collect()
}

/// The middle one, or the mean of the middle two.
fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    match values.len() {
        0 => 0.0,
        n if n % 2 == 1 => values[n / 2],
        n => 0.5 * (values[n / 2 - 1] + values[n / 2]),
    }
}

/// The processor's name where the system tells it, else the target's architecture.
pub fn processor() -> String {
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
