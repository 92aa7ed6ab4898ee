//! The command line, and what its options say to the library.

use super::mistake;
use super::slopes::Normals;
use clap::{Parser, ValueEnum};
use lobe::material::lean::{Border, HeightField, SlopeCap, Unorm16};
use std::num::NonZero;
use std::path::PathBuf;
use std::process::ExitCode;
use std::thread::available_parallelism;

/// Bake a normal map into the mip chain of its slopes' moments: mean.K.png, second.K.png and moments.K.f32 for each
/// level K, and moments.json, which says how they decode.
#[derive(Parser)]
#[command(name = "bake")]
pub(crate) struct Options {
    /// A PNG of 8 or 16 bits: RGB or RGBA (alpha is ignored), or greyscale heights with --height.
    pub(crate) input: PathBuf,
    /// The folder to write; of one that exists, files of the same names are replaced.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: PathBuf,
    /// The steepest slope: longer ones are shortened to it.
    #[arg(long, value_name = "SLOPE", default_value_t = 10.0, allow_negative_numbers = true)]
    cap: f32,
    /// The range of slopes that 16 bits hold; by default the smallest power of two that holds the map's.
    #[arg(long, value_name = "SLOPE", allow_negative_numbers = true)]
    range: Option<f32>,
    /// What lies beyond the edges.
    #[arg(long, value_name = "WHAT", value_enum, default_value_t = Edge::Wrap)]
    pub(crate) border: Edge,
    /// Channels that hold the normal; of rg (BC5 and its kind), z is what is left to unit length.
    #[arg(long, value_name = "NAMES", value_enum, default_value_t = Channels::Rgb)]
    pub(crate) channels: Channels,
    /// Turn y: for maps whose green points down (DirectX). y is up in what is written.
    #[arg(long)]
    pub(crate) flip_y: bool,
    /// The map is a displacement map: greyscale, and white is this high.
    #[arg(long, value_name = "SCALE", requires = "texel", allow_negative_numbers = true)]
    #[arg(conflicts_with = "channels")]
    pub(crate) height: Option<f32>,
    /// The distance of a displacement map's texels, in the unit of --height.
    #[arg(long, value_name = "SIZE", requires = "height", allow_negative_numbers = true)]
    pub(crate) texel: Option<f32>,
    /// Threads; by default as many as there are cores.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Edge {
    /// The map again.
    Wrap,
    /// Its outermost texels.
    Clamp,
}

impl From<Edge> for Border {
    fn from(edge: Edge) -> Self {
        match edge {
            Edge::Wrap => Self::Wrap,
            Edge::Clamp => Self::Clamp,
        }
    }
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum Channels {
    Rgb,
    Rg,
}

/// Of a displacement map: the height of white, the distances of texels, what lies beyond the edges.
pub(crate) struct Relief {
    pub(crate) displacement: f32,
    pub(crate) texel: [f32; 2],
    pub(crate) border: Border,
}

/// The smallest range that 16 bits are given by themselves: a power of two above the library's least.
const LEAST_RANGE: f32 = 1.0 / (1 << 29) as f32;

impl Options {
    /// The options, or the exit code after help or a mistake, which is one line.
    pub(crate) fn of_command_line() -> Result<Self, ExitCode> {
        Self::try_parse().map_err(|error| mistake::told("bake", &error))
    }

    pub(crate) fn cap(&self) -> Result<SlopeCap<f32>, String> {
        SlopeCap::new(self.cap).map_err(|error| format!("--cap {}: {error}", self.cap))
    }

    pub(crate) fn normals(&self, cap: SlopeCap<f32>) -> Normals {
        Normals { cap, pairs: self.channels == Channels::Rg, flip: self.flip_y }
    }

    /// What a displacement map needs, if the input is one.
    pub(crate) fn relief(&self) -> Result<Option<Relief>, String> {
        let (Some(displacement), Some(texel)) = (self.height, self.texel) else {
            return Ok(None);
        };
        if !(texel > 0.0) {
            return Err(format!("--texel {texel}: a distance must be positive"));
        }
        // Rows count down, y points up.
        let down = if self.flip_y { texel } else { -texel };
        let relief =
            Relief { displacement, texel: [texel, down], border: Border::from(self.border) };
        // Checked with one texel, before there are any.
        match HeightField::new([1, 1], &[0.0], relief.texel, displacement, relief.border) {
            Ok(_) => Ok(Some(relief)),
            Err(lobe::Error::Texel) => Err(format!("--texel {texel}: {}", lobe::Error::Texel)),
            Err(error) => Err(format!("--height {displacement}: {error}")),
        }
    }

    /// What is wrong with the range, whatever the map.
    pub(crate) fn check_range(&self) -> Result<(), String> {
        match self.range.map(|range| (range, Unorm16::new(range))) {
            Some((range, Err(_))) => Err(format!("--range {range}: must lie in (1e-9, 1e9]")),
            _ => Ok(()),
        }
    }

    /// The storage's range for a map whose slopes reach to `steepest`.
    pub(crate) fn range_for(&self, steepest: f32) -> Result<f32, String> {
        match self.range {
            Some(range) if range < steepest => Err(format!(
                "--range {range}: the map's slopes reach {steepest}; --cap {range} shortens them"
            )),
            Some(range) => Ok(range),
            None => {
                let powers = std::iter::successors(Some(LEAST_RANGE), |range| Some(2.0 * range));
                Ok(powers.into_iter().find(|range| *range >= steepest).unwrap_or(steepest))
            }
        }
    }

    pub(crate) fn threads(&self) -> usize {
        let cores = || available_parallelism().map_or(1, NonZero::get);
        self.threads.map_or_else(cores, usize::from)
    }
}
