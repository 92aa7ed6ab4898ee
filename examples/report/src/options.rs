//! The command line, and its mistakes in one line each.

use std::fmt;
use std::path::PathBuf;

use clap::error::ErrorKind;
use clap::{Parser, ValueEnum};

use crate::camera::Size;
use crate::channels::Channels;
use crate::facets;
use crate::glints;
use crate::light::LightKind;
use crate::minify;
use crate::reference::Sampling;
use crate::relief;
use crate::sequence::Plan;
use crate::study::{Effort, QUICK_SAMPLES, QUICK_WIDTH};

/// A user's mistake: one line that names the parameter or file.
#[derive(Debug)]
pub(crate) struct Mistake(pub(crate) String);

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Error against run time of specular filters, as tables and as one HTML page.
///
/// Renders each scene with every method and with plain supersampling, compares with a converged
/// reference, and times geometry and shading in the same run. Times compare within one run only.
#[derive(Parser, Debug)]
#[command(version, max_term_width = 100)]
pub(crate) struct Options {
    /// A smaller picture, fewer reference samples, one light, one normal map, two alphas: under a
    /// minute on two cores.
    #[arg(long)]
    pub(crate) quick: bool,

    /// Which scene, or all of them.
    #[arg(long, value_enum, default_value_t = Scenes::All)]
    pub(crate) scene: Scenes,

    /// Which light. [default: all, with --quick distant]
    #[arg(long, value_enum)]
    pub(crate) light: Option<Lights>,

    /// A tangent-space normal map (PNG of 8 or 16 bits or with a palette, +y up) to show on the
    /// plane and on the sphere (scenes `plane`, `mapped-sphere` and `minified`) instead of the four
    /// that the program carries.
    ///
    /// Alpha is ignored unless --channels reads it, gamma, sRGB and ICC chunks are ignored always.
    /// A file that ends early or of which any checksum is wrong is refused; bytes after the end
    /// chunk are ignored with a warning.
    #[arg(long, value_name = "FILE")]
    pub(crate) normal_map: Option<PathBuf>,

    /// Channels of the normal map's x, y and z by their letters, r, g, b or a; of two, as rg (BC5),
    /// ag (DXT5nm: x in alpha, y in green) or ra, z is what is left to unit length.
    #[arg(long, value_name = "NAMES", default_value_t = Channels::RGB, requires = "normal_map")]
    pub(crate) channels: Channels,

    /// Roughness of the material, from 0.0001 to 1: this one only. Brushed scenes have five times
    /// as much across their grooves. [default: 0.01, 0.05 and 0.3, with --quick the first two; of
    /// minified maps 0.05 and 0.2, with --quick the first]
    ///
    /// Below about 0.001 the reference may need more samples than it takes; the report says so.
    #[arg(long, value_name = "A", value_parser = alpha, allow_negative_numbers = true)]
    pub(crate) alpha: Option<f64>,

    /// Width of the pictures in pixels, 16 to 4096; the height follows (16:9).
    ///
    /// Surfaces keep their size in pixels: a smaller picture shows less of them. Above 400, balls,
    /// torus, strips and disk grow with the picture. Pictures of facets are at least 24 pixels
    /// wide. [default: 400, with --quick 240]
    #[arg(long, value_name = "N", value_parser = width, allow_negative_numbers = true)]
    pub(crate) size: Option<usize>,

    /// Folder for index.html, report.json, advice.md and cover.png; made if it does not exist.
    #[arg(long, value_name = "DIR", default_value = "target/report")]
    pub(crate) out: PathBuf,
}

/// Which scenes to render.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Scenes {
    /// Waves at grazing view.
    Water,
    /// Balls of many sizes.
    Sphere,
    /// A torus with a thin tube.
    Torus,
    /// A plane with normal maps.
    Plane,
    /// A ball with normal maps.
    MappedSphere,
    /// A sphere of relief for LEADR, with roughnesses and lights of its own.
    Relief,
    /// Thin strips at grazing angles.
    Strip,
    /// A brushed disk with grooves.
    Disk,
    /// Normal maps on a plane, many texels to a pixel, and a zoom.
    Minified,
    /// Details that flicker: two models of glints against real details, and filters of many facets,
    /// with materials and lights of their own.
    Glints,
    /// All of them; with --quick one normal map only.
    All,
}

impl Scenes {
    /// Whether this is the scene asked for, or all are.
    pub(crate) fn include(self, scene: Self) -> bool {
        self == scene || self == Self::All
    }
}

/// Which lights to shine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Lights {
    /// The same direction everywhere.
    Distant,
    /// Near enough that its direction changes across the picture.
    Point,
    /// One after the other.
    All,
}

/// Roughnesses of a full run; a quick one takes the first two.
const ALPHAS: [f64; 3] = [0.01, 0.05, 0.3];

impl Options {
    /// From the program's arguments. Help and version are printed and give `None`.
    pub(crate) fn parse_or_explain() -> Result<Option<Self>, Mistake> {
        let options = match Self::try_parse() {
            Ok(options) => options,
            Err(error)
                if matches!(error.kind(), ErrorKind::DisplayHelp | ErrorKind::DisplayVersion) =>
            {
                // A closed pipe is no reason to complain.
                let _ = error.print();
                return Ok(None);
            }
            Err(error) => return Err(Mistake(first_paragraph(&error.to_string()))),
        };
        let mapped = [Scenes::Plane, Scenes::MappedSphere, Scenes::Minified, Scenes::All]
            .contains(&options.scene);
        if options.normal_map.is_some() && !mapped {
            let name = options.scene.to_possible_value();
            let name = name.as_ref().map_or("", |name| name.get_name());
            return Err(Mistake(format!("--normal-map is of no use with '--scene {name}'")));
        }
        Ok(Some(options))
    }

    /// How much work the options ask for.
    pub(crate) fn effort(&self) -> Effort {
        let (width, samples, rounds, count) =
            if self.quick { (QUICK_WIDTH, QUICK_SAMPLES, 41, 2) } else { (400, 320, 101, 3) };
        let lights = match (self.light, self.quick) {
            (Some(Lights::Distant), _) | (None, true) => vec![LightKind::Distant],
            (Some(Lights::Point), _) => vec![LightKind::Point],
            (Some(Lights::All), _) | (None, false) => LightKind::ALL.into(),
        };
        Effort {
            width: self.size.unwrap_or(width),
            sampling: Sampling::of_still(samples),
            rounds,
            lights,
            alphas: self.alpha.map_or(ALPHAS[..count].into(), |alpha| vec![alpha]),
        }
    }

    /// How maps are minified: under the first light, in pictures no wider than asked for.
    pub(crate) fn minification(&self) -> minify::Plan {
        let (width, alphas, fewest, rounds, frames) =
            if self.quick { (48, 1, 16, 15, 16) } else { (80, 2, 32, 41, 60) };
        minify::Plan {
            size: Size::of_width(self.size.map_or(width, |asked| asked.min(width))),
            alphas: self.alpha.map_or(MAPPED_ALPHAS[..alphas].into(), |alpha| vec![alpha]),
            light: self.first_light(),
            fewest,
            rounds,
            frames,
        }
    }

    /// How glints are measured, if they are asked for: in a picture no wider than asked for.
    pub(crate) fn glints(&self) -> Option<glints::Plan> {
        let plan = if self.quick { glints::Plan::quick() } else { glints::Plan::full() };
        let width = self.size.map_or(plan.width, |asked| asked.min(plan.width));
        self.scene.include(Scenes::Glints).then_some(glints::Plan { width, ..plan })
    }

    /// How facets are measured, if glints are asked for: in pictures no wider than asked for, but
    /// for the least width.
    pub(crate) fn facets(&self) -> Option<facets::Plan> {
        let plan = if self.quick { facets::Plan::quick() } else { facets::Plan::full() };
        let least = facets::Plan::LEAST_WIDTH;
        let narrow = |width: usize| self.size.map_or(width, |asked| asked.max(least).min(width));
        let [width, zoom, sweep] = [plan.width, plan.zoom, plan.sweep].map(narrow);
        let plan = facets::Plan { width, zoom, sweep, ..plan };
        self.scene.include(Scenes::Glints).then_some(plan)
    }

    fn first_light(&self) -> LightKind {
        if self.light == Some(Lights::Point) { LightKind::Point } else { LightKind::Distant }
    }

    /// How sequences are taken: under the first light, at the smallest alpha, in pictures no wider
    /// than asked for.
    pub(crate) fn plan(&self) -> Plan {
        let (width, frames) = if self.quick { (96, 16) } else { (144, 60) };
        Plan {
            width: self.size.map_or(width, |asked| asked.min(width)),
            frames,
            step: STEP,
            sampling: Sampling::of_frame(128),
            light: self.first_light(),
            alpha: self.alpha.unwrap_or(ALPHAS[0]),
        }
    }

    /// How relief is measured, if it is asked for: in pictures no wider than asked for, of an even
    /// number of pixels.
    pub(crate) fn relief(&self) -> Option<relief::Plan> {
        let plan = if self.quick { relief::Plan::quick() } else { relief::Plan::full() };
        let side = self.size.map_or(plan.side, |asked| (asked & !1).min(plan.side));
        self.scene.include(Scenes::Relief).then_some(relief::Plan { side, ..plan })
    }
}

/// Roughnesses of minified maps: narrower lobes than the first would show the steps of 8 bits. A
/// quick run takes the first one.
const MAPPED_ALPHAS: [f64; 2] = [0.05, 0.2];

/// Pixels from frame to frame of a sequence, in its middle: small, and no simple part of a pixel,
/// so that glints meet pixels at every phase.
const STEP: f64 = 0.23;

/// What clap says up to its first blank line, as one line and without its `error:`.
fn first_paragraph(message: &str) -> String {
    let lines = message.lines().take_while(|line| !line.trim().is_empty()).map(str::trim);
    let joined = lines.collect::<Vec<_>>().join(" ");
    joined.strip_prefix("error: ").map_or(joined.clone(), Into::into)
}

fn alpha(text: &str) -> Result<f64, String> {
    let refusal = "must be a number from 0.0001 to 1";
    let alpha: f64 = text.parse().map_err(|_| refusal)?;
    if (1e-4..=1.0).contains(&alpha) { Ok(alpha) } else { Err(refusal.into()) }
}

fn width(text: &str) -> Result<usize, String> {
    let refusal = "must be a whole number from 16 to 4096";
    let width: usize = text.parse().map_err(|_| refusal)?;
    if (16..=4096).contains(&width) { Ok(width) } else { Err(refusal.into()) }
}

#[cfg(test)]
mod tests {
    use super::{Options, first_paragraph};
    use clap::{CommandFactory, Parser};

    #[test]
    fn the_command_line_is_well_formed() {
        Options::command().debug_assert();
    }

    #[test]
    fn numbers_out_of_range_are_refused_by_name() {
        for bad in [
            "--alpha=0",
            "--alpha=-1",
            "--alpha=nan",
            "--alpha=inf",
            "--alpha=x",
            "--size=0",
            "--size=-4",
            "--size=99999999999999999999",
            "--size=3.5",
            "--scene=fire",
            "--light=none",
        ] {
            let error = Options::try_parse_from(["lobe-report", bad]).unwrap_err();
            let line = first_paragraph(&error.to_string());
            let name = bad.split('=').next().unwrap();
            assert!(line.contains(name) && !line.contains('\n'), "{line}");
        }
    }
}
