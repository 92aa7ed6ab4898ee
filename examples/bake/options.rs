//! The command line, and what its options say to the library.

use super::channels::Channels;
use super::mistake;
use super::number::Number;
use super::roughness::{Kind, Roughness};
use clap::{Parser, ValueEnum};
use lobe::material::lean::{Border, HeightField, SlopeCap, Unorm16};
use std::num::NonZero;
use std::path::PathBuf;
use std::process::ExitCode;
use std::thread::available_parallelism;

/// Bake a normal map into the mip chain of its slopes' moments: mean.K.png, second.K.png and
/// moments.K.f32 for each level K, and moments.json, which says how they decode. With --roughness
/// also roughness.K.png, for engines that have one roughness channel and no moments.
///
/// What the map looks like is told on standard error in lines that begin with "bake: warning: ",
/// and in moments.json. Exit status: 0; 2 for what cannot be read, baked or written, 130 after
/// Ctrl-C; then nothing is written.
#[derive(Parser)]
#[command(name = "bake")]
pub(crate) struct Options {
    /// A PNG of a normal map, or of heights with --height: 8 or 16 bits a channel, a palette, or
    /// grayscale of any depth.
    ///
    /// A palette and transparency (tRNS) are expanded exactly. Alpha is ignored unless --channels
    /// or --coverage reads it; gamma, sRGB and ICC chunks are ignored, as normals are no colors; of
    /// an animation the still picture is read. A file that ends early or of which any checksum is
    /// wrong is refused; bytes after the end chunk are ignored with a warning. Heights without
    /// --height, red = green = blue in all texels but one of a thousand, are refused.
    pub(crate) input: PathBuf,
    /// The folder to write; of one that exists, files of the same names are replaced, and files of
    /// an earlier bake that its moments.json lists are removed.
    #[arg(long, value_name = "DIR")]
    pub(crate) out: PathBuf,
    /// The steepest slope: longer ones are shortened to it.
    #[arg(long, value_name = "SLOPE", default_value = "10", allow_negative_numbers = true)]
    cap: Number,
    /// The range of slopes that 16 bits hold; by default the smallest power of two that holds the
    /// map's.
    #[arg(long, value_name = "SLOPE", allow_negative_numbers = true)]
    range: Option<Number>,
    /// What lies beyond the edges; heights have one-sided differences at clamped ones.
    #[arg(long, value_name = "WHAT", value_enum, default_value_t = Edge::Wrap)]
    pub(crate) border: Edge,
    /// Channels of x, y and z by their letters, r, g, b or a; of two, as rg (BC5), ag (DXT5nm: x in
    /// alpha, y in green) or ra, z is what is left to unit length.
    #[arg(long, value_name = "NAMES", default_value_t = Channels::RGB)]
    pub(crate) channels: Channels,
    /// Weigh every texel by the alpha channel: texels of alpha 0, outside of a texture's islands,
    /// do not count.
    ///
    /// Each level merges its moments by the coverage of its texels. A texel of a level that covers
    /// nothing takes the moments of the coarser texel that covers it; on level 0, whose texels are
    /// single slopes, it takes that texel's mean slope.
    #[arg(long, conflicts_with = "height")]
    pub(crate) coverage: bool,
    /// Negate y: for maps whose green points down (DirectX). y is up in what is written.
    #[arg(long)]
    pub(crate) flip_y: bool,
    /// The map is a displacement map: gray (or colors with red = green = blue), and white is this
    /// high.
    #[arg(long, value_name = "SCALE", requires = "texel", allow_negative_numbers = true)]
    #[arg(conflicts_with = "channels")]
    pub(crate) height: Option<Number>,
    /// The distance of a displacement map's texels, in the unit of --height.
    #[arg(long, value_name = "SIZE", requires = "height", allow_negative_numbers = true)]
    pub(crate) texel: Option<Number>,
    /// Write roughness mips, too: roughness.K.png, one channel, for a material of this roughness, 0
    /// to 1, under the map.
    ///
    /// alpha_K^2 = alpha^2 + tr Sigma_K: the isotropic lobe with the mean square slope of the
    /// material and of the map's texels together, about their mean slope, which mean.K.png or the
    /// engine's own mips of normals hold. Codes are rounded to the nearest; roughnesses above 1 are
    /// written as 1 and counted.
    #[arg(long = "roughness", value_name = "BASE", allow_negative_numbers = true)]
    base: Option<Number>,
    /// What BASE and the codes of roughness.K.png are: alpha, or its square root, as glTF and most
    /// engines have it.
    #[arg(long, value_name = "KIND", value_enum, default_value_t = Kind::Perceptual)]
    #[arg(requires = "base")]
    roughness_as: Kind,
    /// Bits of roughness.K.png.
    #[arg(long, value_name = "BITS", value_parser = ["8", "16"], default_value = "8")]
    #[arg(requires = "base")]
    roughness_bits: String,
    /// Threads; by default as many as there are cores.
    #[arg(long, value_name = "COUNT", value_parser = threads)]
    threads: Option<usize>,
}

#[derive(Clone, Copy, ValueEnum)]
pub(crate) enum Edge {
    /// The map, repeated.
    Wrap,
    /// The map's outermost texels, repeated.
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

/// Of a displacement map: the height of white, the distances of texels, what lies beyond the edges.
pub(crate) struct Relief {
    pub(crate) displacement: f32,
    pub(crate) texel: [f32; 2],
    pub(crate) border: Border,
}

/// How many threads there may be.
fn threads(given: &str) -> Result<usize, &'static str> {
    let count = given.parse().ok().filter(|count| (1..=1024).contains(count));
    count.ok_or("must be a whole number from 1 to 1024")
}

/// The smallest range that 16 bits are given by themselves: a power of two above the library's
/// least.
const LEAST_RANGE: f32 = 1.0 / (1 << 29) as f32;
/// The library's largest range, beyond the last power of two below it.
const LARGEST_RANGE: f32 = 1e9;

impl Options {
    /// The options, or the exit code after help or a mistake, which is one line.
    pub(crate) fn of_command_line() -> Result<Self, ExitCode> {
        Self::try_parse().map_err(|error| mistake::told("bake", &error))
    }

    pub(crate) fn cap(&self) -> Result<SlopeCap<f32>, String> {
        SlopeCap::new(self.cap.single).map_err(|error| format!("--cap {}: {error}", self.cap))
    }

    /// The steepest slope, as given.
    pub(crate) fn steepest(&self) -> &Number {
        &self.cap
    }

    /// What roughness mips are made of, if they are asked for.
    pub(crate) fn roughness(&self) -> Result<Option<Roughness>, String> {
        let wide = self.roughness_bits == "16";
        let roughness = self.base.as_ref().map(|base| {
            Roughness::new(base.double, self.roughness_as, wide)
                .map_err(|error| format!("--roughness {base}: {error}"))
        });
        roughness.transpose()
    }

    /// What a displacement map needs, if the input is one.
    pub(crate) fn relief(&self) -> Result<Option<Relief>, String> {
        let (Some(height), Some(distance)) = (&self.height, &self.texel) else {
            return Ok(None);
        };
        let (displacement, texel) = (height.single, distance.single);
        if !(texel > 0.0) {
            return Err(format!("--texel {distance}: texel = {texel} is not in [1e-9, 1e9]"));
        }
        // Rows count down, y points up.
        let down = if self.flip_y { texel } else { -texel };
        let relief =
            Relief { displacement, texel: [texel, down], border: Border::from(self.border) };
        // Checked with one texel, before there are any.
        match HeightField::new([1, 1], &[0.0], relief.texel, displacement, relief.border) {
            Ok(_) => Ok(Some(relief)),
            Err(lobe::Error::Texel(_)) => {
                Err(format!("--texel {distance}: texel = {texel} is not in [1e-9, 1e9]"))
            }
            Err(error) => Err(format!("--height {height}: {error}")),
        }
    }

    /// What is wrong with options that go together, whatever the map.
    pub(crate) fn check_channels(&self) -> Result<(), String> {
        if self.coverage && self.channels.use_alpha() {
            return Err(format!("--coverage: --channels {} already reads alpha", self.channels));
        }
        Ok(())
    }

    /// What is wrong with the range, whatever the map.
    pub(crate) fn check_range(&self) -> Result<(), String> {
        match self.range.as_ref().map(|range| (range, Unorm16::new(range.single))) {
            Some((range, Err(error))) => Err(format!("--range {range}: {error}")),
            _ => Ok(()),
        }
    }

    /// The storage's range for a map whose slopes reach to `steepest`.
    pub(crate) fn range_for(&self, steepest: f32) -> Result<f32, String> {
        match &self.range {
            Some(range) if range.single < steepest => Err(format!(
                "--range {range}: the map's slopes reach {steepest}; --cap {range} shortens them"
            )),
            Some(range) => Ok(range.single),
            None => {
                let powers = std::iter::successors(Some(LEAST_RANGE), |range| Some(2.0 * range));
                let power = powers.into_iter().find(|range| *range >= steepest);
                Ok(power.unwrap_or(steepest).min(LARGEST_RANGE))
            }
        }
    }

    pub(crate) fn threads(&self) -> usize {
        let cores = || available_parallelism().map_or(1, NonZero::get);
        self.threads.unwrap_or_else(cores)
    }
}
