//! What was baked: as text for people, as JSON for programs.

use super::folder::Folder;
use super::looks::deviation;
use super::options::Options;
use super::print::print;
use super::roughness::Roughness;
use super::say::say;
use lobe::SlopeMoments;
use lobe::material::lean::{Border, ClippedTexels};
use serde_json::json;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::time::Duration;

/// The file in which a reader finds the others.
pub(crate) const DESCRIPTION: &str = "moments.json";
/// The files of a level in the description: what each is there, and its name before and after the
/// level's number.
const PARTS: [(&str, &str, &str); 4] = [
    ("mean", "mean", "png"),
    ("second", "second", "png"),
    ("raw", "moments", "f32"),
    ("roughness", "roughness", "png"),
];

/// A baked map in numbers.
pub(crate) struct Summary {
    pub(crate) size: [usize; 2],
    pub(crate) levels: usize,
    pub(crate) border: Border,
    pub(crate) cap: f32,
    /// The largest component of a slope.
    pub(crate) steepest: f32,
    pub(crate) range: f32,
    /// Of 16 bits and of f32.
    pub(crate) floors: [f32; 2],
    pub(crate) clipped: ClippedTexels,
    /// The moments of all slopes.
    pub(crate) whole: SlopeMoments<f32>,
    /// How roughness was written, and how many texels of all levels are rougher than 1.
    pub(crate) roughness: Option<(Roughness, usize)>,
    /// What the user may want to decide about, a line each.
    pub(crate) warnings: Vec<String>,
    /// Of the chain in memory.
    pub(crate) bytes: usize,
    pub(crate) seconds: Seconds,
}

/// How long each stage took.
pub(crate) struct Seconds {
    pub(crate) decoding: Duration,
    /// Texels to slopes.
    pub(crate) converting: Duration,
    /// Slopes to levels.
    pub(crate) merging: Duration,
    /// A plain copy of the slopes.
    pub(crate) copying: Duration,
    pub(crate) encoding: Duration,
}

impl Summary {
    /// Writes the description beside the files.
    pub(crate) fn describe(&self, options: &Options, folder: &Folder) -> Result<(), String> {
        let mut file = folder.create(DESCRIPTION)?;
        let written = file.write_all(self.json(options).as_bytes());
        written.map_err(|error| folder.refused(DESCRIPTION, &error))
    }

    fn json(&self, options: &Options) -> String {
        let levels: Vec<_> = (0..self.levels)
            .map(|k| {
                let mut level = json!({
                    "size": self.size.map(|n| (n >> k).max(1)),
                    "mean": format!("mean.{k}.png"),
                    "second": format!("second.{k}.png"),
                    "raw": format!("moments.{k}.f32"),
                });
                if self.roughness.is_some() {
                    level["roughness"] = format!("roughness.{k}.png").into();
                }
                level
            })
            .collect();
        let mut description = json!({
            "source": options.input.file_name().map(|name| name.to_string_lossy()),
            "channels": match options.height {
                Some(_) => "heights".to_owned(),
                None => options.channels.to_string(),
            },
            "coverage": options.coverage,
            "flip_y": options.flip_y,
            "height": options.height.as_ref().map(|height| height.single),
            "texel": options.texel.as_ref().map(|texel| texel.single),
            "size": self.size,
            "range": self.range,
            "steepest": self.steepest,
            "border": match self.border { Border::Wrap => "wrap", Border::Clamp => "clamp" },
            "cap": self.cap,
            "clipped": {
                "texels": self.clipped.texels,
                "of": self.clipped.of,
                "fraction": self.clipped.fraction(),
            },
            "mean_slope": self.whole.mean(),
            "deviation": deviation(&self.whole),
            "warnings": self.warnings,
            "alpha_floor": { "unorm16": self.floors[0], "f32": self.floors[1] },
            "decode": {
                "slopes": "s = (dh/dx, dh/dy) = (-n.x / n.z, -n.y / n.z); x to the right, y up, \
                    rows from the top",
                "mean": "16-bit RGB: red E[x], green E[y], each range * (code - 32768) / 32767; \
                    blue 0",
                "second": "16-bit RGB: red E[xx], blue E[yy], each range^2 * code / 65535; \
                    green E[xy] = range^2 * (code - 32768) / 32767",
                "raw": "little-endian f32, five a texel: E[x], E[y], E[xx], E[xy], E[yy]",
                "covariance": "second - mean mean^T; lobe::SlopeMoments::from_unorm and from_raw",
            },
            "levels": levels,
        });
        if let Some((roughness, above)) = self.roughness {
            let (kind, bits, largest) =
                (roughness.kind.name(), roughness.bits(), roughness.largest());
            description["roughness"] = json!({
                "base": roughness.base,
                "kind": kind,
                "bits": bits,
                "above_one": above,
            });
            let root = if kind == "alpha" { "" } else { "; alpha = perceptual^2" };
            description["decode"]["roughness"] = format!(
                "{bits}-bit gray: {kind} = code / {largest}{root}; \
                 alpha^2 = alpha_base^2 + covariance[xx] + covariance[yy], at most 1"
            )
            .into();
        }
        format!("{description:#}\n")
    }

    /// For a person.
    fn text(&self, options: &Options) -> String {
        let [width, height] = self.size;
        let Seconds { decoding, converting, merging, copying, encoding } = self.seconds;
        let baking = converting + merging;
        let texels = (width * height) as f64;
        let slopes = texels * size_of::<[f32; 2]>() as f64;
        let ratio = |time: Duration| time.as_secs_f64() / copying.as_secs_f64().max(1e-9);
        let text = format!(
            "{}: {width} x {height}, {} levels, in {}\n\
             range           slopes to {}, stored in [-{range}, {range}]\n\
             clipped         {} of {} texels at {} ({:.4} %)\n\
             mean slope      ({:.5}, {:.5}), deviation {:.5}\n\
             alpha floor     {:.2e} in 16 bits, {:.2e} in f32\n\
             decoding        {:8.3} s\n\
             moments, mips   {:8.3} s, {:.1} megapixels/s (slopes {:.3} s, mips {:.3} s; {} \
             threads)\n\
             encoding        {:8.3} s\n\
             plain copy      {:8.3} s: moments and mips take {:.1} times that, mips alone {:.1} \
             times\n\
             memory          the chain has {:.2} times the bytes of its slopes\n",
            options.input.display(),
            self.levels,
            options.out.display(),
            self.steepest,
            self.clipped.texels,
            self.clipped.of,
            self.cap,
            100.0 * self.clipped.fraction(),
            self.whole.mean()[0],
            self.whole.mean()[1],
            deviation(&self.whole),
            self.floors[0],
            self.floors[1],
            decoding.as_secs_f64(),
            baking.as_secs_f64(),
            texels / baking.as_secs_f64().max(1e-9) * 1e-6,
            converting.as_secs_f64(),
            merging.as_secs_f64(),
            options.threads(),
            encoding.as_secs_f64(),
            copying.as_secs_f64(),
            ratio(baking),
            ratio(merging),
            self.bytes as f64 / slopes,
            range = self.range,
        );
        let rough = self.roughness.map(|(roughness, above)| {
            format!(
                "roughness       {} {} under the map, {} bits; {above} texels above 1\n",
                roughness.kind.name(),
                roughness.base,
                roughness.bits(),
            )
        });
        let peak = peak().map(|peak| format!("peak            {peak:.0} MiB\n"));
        text + &rough.unwrap_or_default() + &peak.unwrap_or_default()
    }

    /// The numbers, on standard output.
    pub(crate) fn print(&self, options: &Options) -> Result<(), String> {
        print(&self.text(options))
    }

    /// The warnings, on standard error.
    pub(crate) fn warn(&self, options: &Options) {
        for warning in &self.warnings {
            say(&format!("bake: warning: {}: {warning}", options.input.display()));
        }
    }
}

/// The files of a baked map in a folder, by its description; none where there is none.
///
/// Only names that a bake gives: someone else may have written the description, and listed files of
/// another kind in it.
pub(crate) fn described(folder: &Path) -> Vec<String> {
    let text = fs::read_to_string(folder.join(DESCRIPTION)).unwrap_or_default();
    let known: serde_json::Value = serde_json::from_str(&text).unwrap_or_default();
    let levels = known["levels"].as_array().into_iter().flatten();
    let names = levels.enumerate().flat_map(|(k, level)| {
        PARTS.map(|(part, before, after)| {
            let name = format!("{before}.{k}.{after}");
            (level[part].as_str() == Some(name.as_str())).then_some(name)
        })
    });
    names.flatten().collect()
}

/// The most memory that this process has held, in MiB, where the system tells it.
fn peak() -> Option<f64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kibibytes: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kibibytes / 1024.0)
}
