//! The command line.

use super::mistake;
use clap::{Parser, ValueEnum};
use std::num::NonZero;
use std::path::PathBuf;
use std::process::ExitCode;
use std::thread::available_parallelism;

/// Draw glittering materials, one evaluation a pixel: SCENE.png, and of the zoom zoom.K.png for
/// each frame K.
#[derive(Parser)]
#[command(
    name = "glints",
    after_help = "Printed for the zoom: details along a pixel in the picture's middle, mean \
        radiance of details, of the \
    smooth lobe, the first over the second, the standard deviation that its noise may have, and \
    cells a pixel, in the \
    mean and at most."
)]
pub(crate) struct Options {
    /// The folder to write; of one that exists, files of the same names are replaced.
    #[arg(long, value_name = "DIR", default_value = "target/glints")]
    pub(crate) out: PathBuf,
    /// What to draw; may be given several times. All by default.
    #[arg(long = "scene", value_name = "NAME", value_enum)]
    scenes: Vec<Subject>,
    /// Width and height in pixels.
    #[arg(long, value_name = "WxH", value_parser = size, default_value = "960x540")]
    #[arg(allow_hyphen_values = true)]
    pub(crate) size: [usize; 2],
    /// Frames of the zoom, 24 by default.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(2..=1000))]
    #[arg(allow_negative_numbers = true)]
    frames: Option<u16>,
    /// Other random numbers: other details of the same materials.
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["published", "smooth"])]
    #[arg(default_value_t = 0, allow_negative_numbers = true)]
    pub(crate) seed: u32,
    /// The model as it was published, with the smooth lobe's masking: SCENE.published.png.
    #[arg(long, conflicts_with = "smooth")]
    published: bool,
    /// The smooth lobe, which glints average to: SCENE.smooth.png.
    #[arg(long)]
    smooth: bool,
    /// Threads; by default as many as there are cores. Pictures do not depend on it.
    #[arg(long, value_name = "COUNT", value_parser = clap::value_parser!(u16).range(1..=1024))]
    #[arg(allow_negative_numbers = true)]
    threads: Option<u16>,
}

/// A picture, or a sequence of them.
#[derive(Clone, Copy, PartialEq, ValueEnum)]
pub(crate) enum Subject {
    /// Snow against a low sun, to the horizon.
    Snow,
    /// A dress of cloth with colored sparkles.
    Fabric,
    /// A disk of metal, brushed in circles.
    Brushed,
    /// A ball with grooves.
    Ball,
    /// Glitter from ever farther away.
    Zoom,
}

/// What shades the pixels.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Method {
    Glints,
    Published,
    Smooth,
}

/// The sides that a picture may have.
const SIDES: [usize; 2] = [16, 8192];

/// `WIDTHxHEIGHT`.
fn size(text: &str) -> Result<[usize; 2], String> {
    let sides = text.split_once('x').map(|(width, height)| [width.parse(), height.parse()]);
    let Some([Ok(width), Ok(height)]) = sides else {
        return Err("not of the form 960x540".to_owned());
    };
    let size: [usize; 2] = [width, height];
    if size.iter().all(|side| (SIDES[0]..=SIDES[1]).contains(side)) {
        Ok(size)
    } else {
        Err(format!("sides must lie between {} and {}", SIDES[0], SIDES[1]))
    }
}

impl Options {
    /// The options, or the exit code after help or a mistake, which is one line.
    pub(crate) fn of_command_line() -> Result<Self, ExitCode> {
        Self::try_parse().map_err(|error| mistake::told("glints", &error))
    }

    /// What to draw, each once, in the order of the list.
    pub(crate) fn scenes(&self) -> Result<Vec<Subject>, String> {
        let asked = |scene: &Subject| self.scenes.is_empty() || self.scenes.contains(scene);
        let scenes: Vec<Subject> =
            Subject::value_variants().iter().copied().filter(asked).collect();
        if self.frames.is_some() && !scenes.contains(&Subject::Zoom) {
            return Err("--frames: of the scenes only zoom has frames".to_owned());
        }
        Ok(scenes)
    }

    /// Frames of the zoom.
    pub(crate) fn frames(&self) -> usize {
        self.frames.map_or(24, usize::from)
    }

    /// What shades the pixels.
    pub(crate) fn method(&self) -> Method {
        match (self.published, self.smooth) {
            (true, _) => Method::Published,
            (_, true) => Method::Smooth,
            _ => Method::Glints,
        }
    }

    /// As many as asked for, or as there are cores.
    pub(crate) fn threads(&self) -> usize {
        let cores = || available_parallelism().map_or(1, NonZero::get);
        self.threads.map_or_else(cores, usize::from)
    }
}

impl Subject {
    /// As the command line and files have it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Snow => "snow",
            Self::Fabric => "fabric",
            Self::Brushed => "brushed",
            Self::Ball => "ball",
            Self::Zoom => "zoom",
        }
    }
}

impl Method {
    /// What it adds to a file's name.
    pub(crate) fn suffix(self) -> &'static str {
        match self {
            Self::Glints => "",
            Self::Published => ".published",
            Self::Smooth => ".smooth",
        }
    }
}
