//! The methods: techniques with names, as functions of a row of pixels.

use lobe::Distribution;
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use rayon::prelude::*;

use super::ground::Ground;
use super::lean::{
    Lean, LeanAlong, LeanExact, LeanKernel, LeanNarrow, LeanRaw, LeanTwice, LeanUnmasked, Shaded,
};
use super::technique::{Clean, Mips, Point, Supersampling, Technique, Toksvig};
use crate::camera::Size;
use crate::method::Distribution as Kind;
use crate::pattern::hammersley;

/// A method with a name.
pub(crate) struct Method {
    pub(crate) name: &'static str,
    /// What it does, in a sentence.
    pub(crate) note: &'static str,
    /// Per pixel; more than one only of plain supersampling.
    pub(crate) samples: u32,
    /// In the order of [`Kind::ALL`].
    rows: [Row; 2],
}

/// Shades a row of the picture.
type Row = fn(&Ground<'_>, usize, &mut [f32]);

impl Method {
    fn of<T: Technique>(name: &'static str, note: &'static str) -> Self {
        let rows: [Row; 2] = [row::<T, GgxDistribution>, row::<T, BeckmannDistribution>];
        Self { name, note, samples: T::SAMPLES, rows }
    }

    /// Shades row `y`.
    pub(super) fn row(&self, kind: Kind, ground: &Ground<'_>, y: usize, out: &mut [f32]) {
        (self.rows[kind as usize])(ground, y, out);
    }

    /// Shades a picture, rows from the top.
    pub(super) fn picture(&self, kind: Kind, ground: &Ground<'_>, size: Size) -> Vec<f32> {
        let mut picture = vec![0.0; size.pixels()];
        let rows = picture.par_chunks_mut(size.width).enumerate();
        rows.for_each(|(y, row)| self.row(kind, ground, y, row));
        picture
    }
}

fn row<T: Technique, D: Distribution>(ground: &Ground<'_>, y: usize, out: &mut [f32]) {
    let weight = 1.0 / T::SAMPLES as f32;
    for (x, out) in out.iter_mut().enumerate() {
        let mut sum = 0.0;
        for index in 0..T::SAMPLES {
            let [right, down] = hammersley(index, T::SAMPLES);
            let spot = ground.view.spot([x as f32 + right, y as f32 + down]);
            sum += T::radiance::<D>(ground, &spot).unwrap_or_default();
        }
        *out = weight * sum;
    }
}

/// The names by which the page finds methods.
pub(crate) mod name {
    pub(crate) const POINT: &str = "point-sampled";
    pub(crate) const MIPS: &str = "plain mips";
    pub(crate) const TOKSVIG: &str = "Toksvig";
    pub(crate) const CLEAN: &str = "CLEAN";
    pub(crate) const LEAN: &str = "LEAN";
    pub(crate) const RAW: &str = "LEAN, raw moments";
    pub(crate) const KERNEL: &str = "LEAN + kernel";
    pub(crate) const SHADED: &str = "mean slope + shading kernel";
    pub(crate) const TWICE: &str = "LEAN + shading kernel";
    pub(crate) const ALONG: &str = "LEAN, anisotropic";
    pub(crate) const NARROW: &str = "LEAN, narrow probes";
    pub(crate) const EXACT: &str = "LEAN, exact pixel";
    pub(crate) const UNMASKED: &str = "LEAN, base visibility";
    pub(crate) const FOUR: &str = "4 samples";
    pub(crate) const SIXTEEN: &str = "16 samples";
    pub(crate) const SIXTY_FOUR: &str = "64 samples";
}

/// All methods, the simplest first.
pub(crate) fn all() -> Vec<Method> {
    vec![
        Method::of::<Point>(name::POINT, "The nearest texel of the finest level."),
        Method::of::<Mips>(
            name::MIPS,
            "The mean normal by trilinear mips, brought to length 1; roughness as it is.",
        ),
        Method::of::<Toksvig>(
            name::TOKSVIG,
            "The same normal; its length before that gives the variance of a rounder lobe \
                (Toksvig 2005).",
        ),
        Method::of::<Clean>(
            name::CLEAN,
            "The mean slope by trilinear mips, and half the trace of its covariance on either \
                axis (Baker 2011).",
        ),
        Method::of::<Lean>(
            name::LEAN,
            "The mean slope and the covariance by trilinear mips (Olano & Baker 2010).",
        ),
        Method::of::<LeanRaw>(
            name::RAW,
            "The same from textures of raw moments, E s and E ss\u{1d40}, as filtering hardware \
                has them; f32.",
        ),
        Method::of::<LeanKernel>(
            name::KERNEL,
            "The same, and the covariance of the half vector\u{2019}s motion over the box pixel, \
                the plane being flat.",
        ),
        Method::of::<Shaded>(
            name::SHADED,
            "The mean slope and the half vector\u{2019}s motion in its frame, as derivatives in a \
                shader have it; no \
             covariance (Kaplanyan et al. 2016, section 5.5, first part).",
        ),
        Method::of::<LeanTwice>(
            name::TWICE,
            "That kernel on top of the covariance (the same section, second part): what of the \
                map the mips resolve \
             is counted twice.",
        ),
        Method::of::<LeanAlong>(
            name::ALONG,
            "Mean and covariance merged over trilinear lookups along the pixel, 16 at most, as \
                GPUs filter.",
        ),
        Method::of::<LeanNarrow>(
            name::NARROW,
            "The same with texels 1/\u{221a}3 as wide as the pixel and lookups that spread less, \
             MomentMap::anisotropic: a bilinear lookup has three times the variance of its texel.",
        ),
        Method::of::<LeanUnmasked>(
            name::UNMASKED,
            "The density of those narrow probes over the visibility of the base roughness on the \
                slopes that reflect.",
        ),
        Method::of::<LeanExact>(
            name::EXACT,
            "Mean and covariance of 16 x 16 slopes in the pixel, which no mip chain has: its \
                error is that of one lobe \
             for all of them.",
        ),
        Method::of::<Supersampling<4>>(name::FOUR, SUPERSAMPLED),
        Method::of::<Supersampling<16>>(name::SIXTEEN, SUPERSAMPLED),
        Method::of::<Supersampling<64>>(name::SIXTY_FOUR, SUPERSAMPLED),
    ]
}

const SUPERSAMPLED: &str = "As many bilinear lookups of the finest level, each shaded.";
