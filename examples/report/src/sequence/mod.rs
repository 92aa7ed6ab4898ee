//! Filters in motion: what each makes of glints that are born, move by fractions of a pixel and
//! die.
//!
//! After Kaplanyan et al. 2016, Fig. 12: the largest radiance of each frame with a filter, without
//! one, and as it should be. A still picture does not tell an error that stays from one that
//! flickers.

mod track;

use lobe::Error;
use serde::Serialize;

use crate::camera::Size;
use crate::coverage;
use crate::light::LightKind;
use crate::method::{Distribution, Method, Surfacing};
use crate::reference::{Sampling, Target};
use crate::render::render;
use crate::scene::{Movement, Subject};
use crate::window::{MARGIN, PerWindow, PixelWindow};
use track::peak;

pub(crate) use track::{Tally, Track};

/// How sequences are taken.
#[derive(Clone)]
pub(crate) struct Plan {
    pub(crate) width: usize,
    pub(crate) frames: usize,
    /// Pixels from frame to frame, at the picture's center.
    pub(crate) step: f64,
    pub(crate) sampling: Sampling,
    pub(crate) light: LightKind,
    pub(crate) alpha: f64,
}

/// Most samples per pixel of the plain methods that are shown.
const MOST_SAMPLES: u32 = 16;

impl Plan {
    /// Of all methods, those that sequences are rendered with: of GGX, few samples.
    pub(crate) fn methods(all: Vec<Method>) -> Vec<Method> {
        let shown = |method: &Method| {
            method.distribution == Distribution::Ggx && method.samples <= MOST_SAMPLES
        };
        all.into_iter().filter(shown).collect()
    }

    /// Steps of progress that one sequence reports.
    pub(crate) fn steps(&self) -> u64 {
        let rows = Size::of_width(self.width).grown(MARGIN).height;
        (self.frames * rows * ROW_WEIGHT) as u64
    }

    /// How far the movement has come in a frame, in pixels; nothing half way through.
    fn shift(&self, frame: usize) -> f64 {
        (frame as f64 - 0.5 * (self.frames as f64 - 1.0)) * self.step
    }
}

/// A row of a frame counts as this many rows of a method in a study.
const ROW_WEIGHT: usize = 20;

/// A converged sequence under one pixel filter.
#[derive(Serialize)]
pub(crate) struct Converged {
    pub(crate) window: &'static str,
    /// Largest radiance of each frame.
    pub(crate) peaks: Vec<f64>,
    /// Standard error, root mean square over frames and pixels.
    pub(crate) noise: f64,
}

/// What was measured of one sequence; radiance is scaled to a mean of 1 of the box reference over
/// all frames.
#[derive(Serialize)]
pub(crate) struct Sequence {
    pub(crate) name: String,
    pub(crate) caption: String,
    pub(crate) movement: Movement,
    pub(crate) light: &'static str,
    pub(crate) alpha: f64,
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) frames: usize,
    /// Pixels from frame to frame, at the picture's center.
    pub(crate) step: f64,
    /// The part of the pixels that is judged, mean over frames.
    pub(crate) judged_part: f64,
    /// In the order of [`PixelWindow::ALL`].
    pub(crate) references: Vec<Converged>,
    /// In the order of the methods.
    pub(crate) tracks: Vec<Track>,
}

/// Sums over the frames so far, not yet scaled.
struct Sums {
    peaks: PerWindow<Vec<f64>>,
    /// Squared noise.
    squares: PerWindow<f64>,
    /// Of the box reference over judged pixels, and their number.
    radiance: f64,
    judged: f64,
    tallies: Vec<Tally>,
}

impl Sequence {
    /// Renders all frames with every method; calls `progress` with the steps done.
    pub(crate) fn run(
        subject: &Subject,
        movement: Movement,
        methods: &[Method],
        plan: &Plan,
        progress: &(impl Fn(u64) + Sync),
    ) -> Result<Self, Error> {
        let materials = [Surfacing::new(subject.finish, plan.alpha)?];
        let size = subject.size;
        let mut sums = Sums {
            peaks: Default::default(),
            squares: Default::default(),
            radiance: 0.0,
            judged: 0.0,
            tallies: methods.iter().map(|_| Tally::new(size.pixels())).collect(),
        };
        for frame in 0..plan.frames {
            let lit = subject.lit_after(plan.light, movement, plan.shift(frame));
            let judged = coverage::judged(&lit.exact, size);
            let target = Target {
                scene: &lit.exact,
                size,
                finish: subject.finish,
                alphas: &[plan.alpha],
                judged: &judged,
            };
            let references = plan.sampling.render(&target, &|| progress(ROW_WEIGHT as u64))?;
            let reference = references.of(0, Distribution::Ggx);
            let pictures = render(&lit.engine, size, &materials, methods, &|_| ());

            for window in PixelWindow::ALL.map(|window| window as usize) {
                let values = reference.radiance[window].iter().copied();
                sums.peaks[window].push(peak(values, &judged));
                sums.squares[window] += reference.noise[window].powi(2);
            }
            let of_box = reference.radiance[PixelWindow::Box as usize].iter().zip(&judged);
            for (radiance, _) in of_box.filter(|(_, judged)| **judged) {
                sums.radiance += radiance;
                sums.judged += 1.0;
            }
            let pairs = sums.tallies.iter_mut().zip(methods).zip(pictures.iter().flatten());
            for ((tally, method), picture) in pairs {
                tally.push(picture, &reference.radiance[method.window as usize], &judged);
            }
        }
        Ok(Self::new(subject, movement, methods, plan, &sums))
    }

    /// Sums to scaled numbers.
    fn new(
        subject: &Subject,
        movement: Movement,
        methods: &[Method],
        plan: &Plan,
        sums: &Sums,
    ) -> Self {
        let scale = if sums.radiance > 0.0 { sums.judged / sums.radiance } else { 1.0 };
        let frames = plan.frames as f64;
        let references = PixelWindow::ALL.map(|window| Converged {
            window: window.name(),
            peaks: sums.peaks[window as usize].iter().map(|peak| peak * scale).collect(),
            noise: scale * (sums.squares[window as usize] / frames).sqrt(),
        });
        let width = subject.size.width;
        let elevation = |frame: usize, pixel: usize| {
            let scene = subject.lit_after(plan.light, movement, plan.shift(frame)).exact;
            let [x, y] = [pixel % width, pixel / width].map(|corner| corner as f64 + 0.5);
            scene.sample(x, y).half[2].asin().to_degrees()
        };
        let tracks = methods.iter().zip(&sums.tallies).map(|(method, tally)| {
            let reference = &references[method.window as usize];
            Track::new(method, tally, scale, reference, elevation)
        });
        let tracks = tracks.collect();
        Self {
            name: subject.name.clone(),
            caption: subject.caption.clone(),
            movement,
            light: plan.light.name(),
            alpha: plan.alpha,
            width,
            height: subject.size.height,
            frames: plan.frames,
            step: plan.step,
            judged_part: sums.judged / (frames * subject.size.pixels() as f64),
            references: references.into(),
            tracks,
        }
    }

    /// The converged sequence that a method is held against.
    pub(crate) fn reference_of(&self, track: &Track) -> Option<&Converged> {
        self.references.iter().find(|reference| reference.window == track.window)
    }

    /// The filter that flickers least.
    pub(crate) fn best(&self) -> Option<&Track> {
        let filters = self.tracks.iter().filter(|track| track.filters);
        filters.min_by(|a, b| a.flicker.total_cmp(&b.flicker))
    }

    /// One plain sample.
    pub(crate) fn plain(&self) -> Option<&Track> {
        self.tracks.iter().find(|track| !track.filters && track.samples == 1)
    }
}

#[cfg(test)]
mod tests;
