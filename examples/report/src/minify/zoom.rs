//! A slow zoom: what each method makes of glints as they shrink below a pixel, peak by peak.
//!
//! After Kaplanyan et al. 2016, Fig. 12.

use lobe::Error;
use serde::Serialize;

use super::Plan;
use super::ground::Ground;
use super::method::Method;
use super::reference::{self, Strata};
use super::texels::Texels;
use super::view::View;
use crate::camera::Size;
use crate::method::Distribution;
use crate::sequence::Tally;

/// Texels per pixel in the first frame.
const FIRST: f64 = 2.0;

/// From frame to frame: what is at the edge of a picture 64 pixels wide moves by two thirds of a
/// pixel.
const GROWTH: f64 = 1.02;

/// What was measured of one zoom; radiance is scaled to a mean of 1 of the reference over all
/// frames.
#[derive(Serialize)]
pub(crate) struct Zoom {
    pub(crate) size: Size,
    pub(crate) alpha: f64,
    /// Degrees of the view over the plane.
    pub(crate) elevation: f64,
    /// Texels per pixel, for each frame.
    pub(crate) ratios: Vec<f64>,
    /// Largest radiance of each frame.
    pub(crate) peaks: Vec<f64>,
    /// The reference's standard error, root mean square over frames and pixels.
    pub(crate) noise: f64,
    pub(crate) tracks: Vec<Track>,
}

/// What one method made of it.
#[derive(Serialize)]
pub(crate) struct Track {
    pub(crate) method: &'static str,
    pub(crate) samples: u32,
    /// Largest radiance of each frame.
    pub(crate) peaks: Vec<f64>,
    /// Mean over frames of the peak over the reference's.
    pub(crate) peak_ratio: f64,
    /// Mean over frames of the peak's distance from the reference's, over that.
    pub(crate) peak_deviation: f64,
    /// Mean change of the peak from one frame to the next, over the reference's.
    pub(crate) restlessness: f64,
    /// Root mean square over pixels of the standard deviation in time of x - r.
    pub(crate) flicker: f64,
}

impl Zoom {
    /// Renders all frames with every method; calls `progress` after every row of the reference.
    pub(super) fn run(
        texels: &Texels,
        methods: &[Method],
        plan: &Plan,
        progress: &(impl Fn() + Sync),
    ) -> Result<Self, Error> {
        let alpha = plan.alphas.first().copied().ok_or(Error::Length { expected: 1, found: 0 })?;
        let size = plan.size;
        let judged = vec![true; size.pixels()];
        let (mut peaks, mut ratios) = (Vec::new(), Vec::new());
        let (mut radiance, mut squares) = (0.0, 0.0);
        let mut tallies: Vec<_> = methods.iter().map(|_| Tally::new(size.pixels())).collect();
        for frame in 0..plan.frames {
            let ratio = FIRST * GROWTH.powi(i32::try_from(frame).unwrap_or(i32::MAX));
            let station = plan.station(texels, super::SWEPT, ratio);
            let strata = Strata::of(&station, plan.fewest / 2);
            let references = reference::render(texels, &station, &[alpha], strata, progress)?;
            let reference = references.of(0, Distribution::Ggx);
            let ground = Ground::new(texels, &View::from(&station), alpha)?;
            ratios.push(ratio);
            peaks.push(reference.radiance.iter().copied().fold(0.0, f64::max));
            radiance += reference.radiance.iter().sum::<f64>();
            squares += reference.noise * reference.noise;
            for (tally, method) in tallies.iter_mut().zip(methods) {
                let picture = method.picture(Distribution::Ggx, &ground, size);
                tally.push(&picture, &reference.radiance, &judged);
            }
        }
        let frames = plan.frames.max(1) as f64;
        let pixels = frames * size.pixels() as f64;
        let scale = if radiance > 0.0 { pixels / radiance } else { 1.0 };
        for peak in &mut peaks {
            *peak *= scale;
        }
        let pairs = methods.iter().zip(&tallies);
        let tracks =
            pairs.map(|(method, tally)| Track::new(method, tally, scale, &peaks)).collect();
        let noise = scale * (squares / frames).sqrt();
        Ok(Self { size, alpha, elevation: super::SWEPT, ratios, peaks, noise, tracks })
    }

    pub(crate) fn track(&self, method: &str) -> Option<&Track> {
        self.tracks.iter().find(|track| track.method == method)
    }
}

impl Track {
    fn new(method: &Method, tally: &Tally, scale: f64, right: &[f64]) -> Self {
        let peaks: Vec<_> = tally.peaks().iter().map(|peak| peak * scale).collect();
        let ratios = peaks.iter().zip(right).map(|(peak, right)| peak / right);
        let frames = peaks.len() as f64;
        Self {
            method: method.name,
            samples: method.samples,
            peak_ratio: ratios.clone().sum::<f64>() / frames,
            peak_deviation: ratios.map(|ratio| (ratio - 1.0).abs()).sum::<f64>() / frames,
            restlessness: changes(&peaks) / changes(right),
            flicker: scale * tally.flicker(),
            peaks,
        }
    }
}

/// Sum of the changes from one value to the next.
fn changes(values: &[f64]) -> f64 {
    values.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum()
}
