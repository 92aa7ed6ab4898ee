//! A normal or displacement map baked into the mip chain of its slopes' moments.
//!
//! `cargo run --release --example bake -- normal.png --out moments` writes each level as two 16-bit PNGs and as raw f32,
//! and `moments.json`, which says how their codes decode. `--help` lists the options.
//! Exit status: 0; 2 for what cannot be read, baked or written, 130 after Ctrl-C or SIGTERM; then nothing is written.

mod encode;
#[path = "../common/folder.rs"]
mod folder;
#[path = "../common/mistake.rs"]
mod mistake;
mod options;
mod picture;
#[path = "../common/print.rs"]
mod print;
#[path = "../common/progress.rs"]
mod progress;
mod slopes;
mod summary;
mod work;

use encode::Levels;
use folder::Folder;
use lobe::material::lean::{Border, MomentMap, Unorm16};
use options::Options;
use picture::{Content, Picture};
use progress::Progress;
use slopes::Slopes;
use std::process::ExitCode;
use std::time::Instant;
use summary::{DESCRIPTION, Seconds, Summary};

/// The whole way from the file to the folder.
fn bake(options: &Options, progress: &Progress) -> Result<Summary, String> {
    let cap = options.cap()?;
    options.check_range()?;
    let border = Border::from(options.border);
    let of_input = |error: String| format!("{}: {error}", options.input.display());
    let relief = options.relief()?;
    let content = if relief.is_some() { Content::Heights } else { Content::Normals };
    let picture = Picture::open(&options.input, content).map_err(of_input)?;
    // Before the work, for what cannot be written; of no name yet, and gone again if the work fails.
    let folder = Folder::new(&options.out, "bake")?;

    let size = picture.size();
    let texels = (size[0] * size[1]) as u64;
    progress.begin(texels + Levels::texels(size));
    progress.stage("decoding");
    let slopes = match relief {
        None => Slopes::of_normals(picture, options.normals(cap), options.threads(), progress),
        Some(relief) => Slopes::of_heights(picture, &relief, cap, options.threads(), progress),
    };
    let Slopes { rows, clipped, decoding, converting } = slopes.map_err(of_input)?;

    progress.stage("moments and mips");
    let start = Instant::now();
    let map = MomentMap::from_slopes_by(size, rows, border, options.threads())
        .map_err(|error| of_input(error.to_string()))?;
    let merging = start.elapsed();
    let copying = work::copying(map.slopes(), options.threads());

    let range = options.range_for(map.range())?;
    let layout = Unorm16::new(range).map_err(|error| format!("--range: {error}"))?;
    progress.stage("encoding");
    let start = Instant::now();
    let levels = Levels::new(&map, layout)?;
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
        bytes: map.bytes(),
        seconds: Seconds { decoding, converting, merging, copying, encoding: start.elapsed() },
    };
    summary.describe(options, &folder)?;
    let mut names = levels.names();
    // The last, in which a reader finds the others.
    names.push(DESCRIPTION.to_owned());
    // Levels of a larger map would be taken for this one's.
    folder.finish(&names, summary::described(&options.out))?;
    summary.seconds.encoding = start.elapsed();
    progress.end();
    Ok(summary)
}

fn main() -> ExitCode {
    let options = match Options::of_command_line() {
        Ok(options) => options,
        Err(code) => return code,
    };
    let progress = Progress::new();
    let baked = bake(&options, &progress);
    progress.end();
    match baked.and_then(|summary| summary.print(&options)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => print::failed("bake", &message, progress.stopped()),
    }
}
