//! A normal or displacement map baked into the mip chain of its slopes' moments.
//!
//! `cargo run --release --example bake -- normal.png --out moments` writes each level as two 16-bit
//! PNGs and as raw f32, and `moments.json`, which says how their codes decode; with `--roughness`
//! roughness mips, too. `--help` lists the options. Exit status: 0; 2 for what cannot be read,
//! baked or written, 130 after Ctrl-C or SIGTERM; then nothing is written.

#[path = "../common/channels.rs"]
mod channels;
mod encode;
#[path = "../common/folder.rs"]
mod folder;
#[path = "../common/integrity.rs"]
mod integrity;
#[path = "../common/looks.rs"]
mod looks;
#[path = "../common/mistake.rs"]
mod mistake;
mod number;
mod options;
#[path = "../common/picture.rs"]
mod picture;
#[path = "../common/print.rs"]
mod print;
#[path = "../common/progress.rs"]
mod progress;
mod roughness;
#[path = "../common/say.rs"]
mod say;
mod slopes;
mod summary;
#[path = "../common/survey.rs"]
mod survey;
mod warnings;
mod work;

use encode::Levels;
use folder::Folder;
use lobe::material::lean::{Border, MomentMap, Unorm16};
use options::Options;
use picture::Picture;
use progress::Progress;
use slopes::{Normals, Slopes};
use std::io::ErrorKind;
use std::process::ExitCode;
use std::time::Instant;
use summary::{DESCRIPTION, Seconds, Summary};
use warnings::Looks;

/// The whole way from the file to the folder.
fn bake(options: &Options, progress: &Progress) -> Result<(), String> {
    let cap = options.cap()?;
    options.check_range()?;
    options.check_channels()?;
    let border = Border::from(options.border);
    let of_input = |error: String| format!("{}: {error}", options.input.display());
    let (relief, roughness) = (options.relief()?, options.roughness()?);
    let start = Instant::now();
    let file = picture::bytes_of(&options.input).map_err(of_input)?;
    let picture = Picture::of(&file).map_err(of_input)?;
    let (reading, ignored) = (start.elapsed(), picture.ignored());
    // Before the work, for what cannot be written; of no name yet, and gone again if the work
    // fails.
    let folder = Folder::new(&options.out, "bake")?;

    let size = picture.size();
    let texels = (size[0] * size[1]) as u64;
    progress.begin(texels + Levels::texels(size, roughness));
    progress.stage("decoding");
    let normals = Normals {
        cap,
        channels: options.channels,
        flip: options.flip_y,
        coverage: options.coverage,
    };
    let slopes = match relief {
        None => Slopes::of_normals(picture, normals, options.threads(), progress),
        Some(relief) => Slopes::of_heights(picture, &relief, cap, options.threads(), progress),
    };
    let slopes = slopes.map_err(of_input)?;
    drop(file);
    let looks = Looks::of(&slopes, ignored, options);
    let Slopes { rows, weights, clipped, decoding, converting, .. } = slopes;

    progress.stage("moments and mips");
    let start = Instant::now();
    let map = match weights {
        None => MomentMap::from_slopes_by(size, rows, border, options.threads()),
        Some(weights) => {
            MomentMap::from_weighted_slopes_by(size, rows, weights, border, options.threads())
        }
    };
    let map = map.map_err(|error| of_input(error.to_string()))?;
    let merging = start.elapsed();
    let copying = work::copying(map.slopes(), options.threads());

    let range = options.range_for(map.range())?;
    let layout = Unorm16::new(range).map_err(|error| format!("--range: {error}"))?;
    progress.stage("encoding");
    let start = Instant::now();
    let levels = Levels::new(&map, layout, roughness)?;
    levels.write(&folder, options.threads(), progress)?;
    let mut summary = Summary {
        size,
        levels: map.levels(),
        border,
        cap: cap.steepest(),
        steepest: map.range(),
        range,
        floors: levels.alpha_floors(),
        clipped,
        whole: looks::whole(&map),
        roughness: roughness.map(|roughness| (roughness, levels.above_one())),
        warnings: looks.warnings(&map, options),
        bytes: map.bytes(),
        seconds: Seconds {
            decoding: reading + decoding,
            converting,
            merging,
            copying,
            encoding: start.elapsed(),
        },
    };
    summary.describe(options, &folder)?;
    let mut names = levels.names();
    // The last, in which a reader finds the others.
    names.push(DESCRIPTION.to_owned());
    // What is printed comes before what is seen in the folder: if it cannot be printed, nothing is
    // written.
    if let Some(name) = names.iter().find(|name| options.out.join(name).is_dir()) {
        return Err(folder.refused(name, &ErrorKind::IsADirectory.into()));
    }
    summary.seconds.encoding = start.elapsed();
    progress.end();
    summary.print(options)?;
    // Levels of a larger map would be taken for this one's.
    folder.finish(&names, summary::described(&options.out))?;
    summary.warn(options);
    Ok(())
}

fn main() -> ExitCode {
    let options = match Options::of_command_line() {
        Ok(options) => options,
        Err(code) => return code,
    };
    let progress = Progress::new();
    let baked = bake(&options, &progress);
    progress.end();
    match baked {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => print::failed("bake", &message, progress.stopped()),
    }
}
