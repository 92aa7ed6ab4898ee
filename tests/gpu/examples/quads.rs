//! Pictures of what the GPU draws: filters at 1 sample per pixel, and footprints by quads against
//! Kaplanyan's matrix.
//!
//! `cargo run --release -p lobe-gpu --example quads -- --out target/gpu`. On the first Vulkan
//! driver, lavapipe where it is there; `VK_DRIVER_FILES` chooses. Exit status: 0, or 2 for what
//! cannot be drawn or written; then nothing is written.
#![allow(
    clippy::incompatible_msrv,
    reason = "a check of the tests, and as new a compiler as theirs"
)]

#[path = "../tests/render/drawn.rs"]
#[allow(dead_code, reason = "shared with the test, which draws more")]
mod drawn;
#[path = "../../../examples/common/say.rs"]
mod say;

use std::fs;
use std::io::{IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Parser;
use drawn::{DIFFERENCE, MATRIX, QUAD, SHADED, Spread, Stage, sides};
use lobe_gpu::Gpu;
use lobe_report::shot::{Shot, non_overlap};
use say::say;

/// Draw two scenes of the report on the GPU, and how far footprints by quads are from Kaplanyan's
/// matrix.
#[derive(Parser)]
struct Options {
    /// The folder to write pictures into.
    #[arg(long, value_name = "FOLDER", default_value = "target/gpu")]
    out: PathBuf,
}

/// Roughness of all scenes.
const ALPHA: f64 = 0.01;
/// White columns between pictures.
const GAP: usize = 8;
/// Every pixel is drawn as so many by so many.
const ZOOM: usize = 2;

/// Colors of differences from a thousandth to one, a decade apart.
const COLORS: [[f64; 3]; 4] =
    [[0.0, 0.0, 20.0], [120.0, 30.0, 130.0], [240.0, 110.0, 50.0], [255.0, 250.0, 160.0]];

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            say(&format!("quads: {}", message.lines().next().unwrap_or_default()));
            ExitCode::from(2)
        }
    }
}

fn run() -> Result<(), String> {
    let Options { out: folder } = Options::parse();
    let gpu = Gpu::every()
        .first()
        .ok_or("no Vulkan driver found: lavapipe's package is mesa-vulkan-drivers")?;
    print(&format!("Drawn by {}, GGX of alpha {ALPHA}, 1 sample per pixel.", gpu.name()));

    let width = lobe_report::QUICK_WIDTH;
    let mut files = Vec::new();
    for (name, scene) in [("balls", Shot::balls as Scene), ("leather", Shot::leather)] {
        progress(&format!("{name}: reference"));
        let shot = scene(width, ALPHA)?;
        let stage = Stage { shot: &shot, gpu };
        progress(&format!("{name}: pictures"));
        files.push((format!("{name}.png"), shaded(&stage)?));
        if name == "balls" {
            files.push(("footprints.png".into(), footprints(&stage)?));
        }
    }
    let paths = write(&folder, &files);
    for path in paths.map_err(|error| format!("--out '{}': {error}", folder.display()))? {
        print(&path.display().to_string());
    }
    Ok(())
}

/// A constructor of a scene.
type Scene = fn(usize, f64) -> Result<Shot, String>;

/// Unfiltered, widened, averaged, and the reference; their errors on the terminal.
fn shaded(stage: &Stage) -> Result<Vec<u8>, String> {
    let shot = stage.shot;
    let drawn = stage.picture(SHADED)?;
    let mut pictures = Vec::new();
    print(&format!("\n{}: {}", shot.name, shot.caption));
    for (k, method) in [&shot.plain, &shot.widened, &shot.exact].into_iter().enumerate() {
        let picture: Vec<f32> = drawn.iter().map(|pixel| pixel[k]).collect();
        let (got, stated) = (shot.errors(&picture, method).rmse, method.errors.rmse);
        print(&format!("  {:24} RMSE {got:8.4}, in the report {stated:8.4}", method.name));
        pictures.push(picture.into_iter().map(f64::from).collect());
    }
    pictures.push(shot.exact.reference.clone());
    let gray = |byte| [byte; 3];
    let shown = pictures.iter().map(|x: &Vec<f64>| shot.shown(x).into_iter().map(gray).collect());
    strip(shot.width, &shown.collect::<Vec<_>>())
}

/// Where quads and the matrix M disagree: by their sides, and by the areas that they cover
/// (Kaplanyan et al. 2016, Fig. 7).
fn footprints(stage: &Stage) -> Result<Vec<u8>, String> {
    let shot = stage.shot;
    let (quad, matrix) = (stage.picture(QUAD)?, stage.picture(MATRIX)?);
    let difference = stage.picture(DIFFERENCE)?;
    let by_sides: Vec<f64> = difference.iter().map(|pixel| f64::from(pixel[0])).collect();
    let both = quad.into_iter().zip(matrix);
    let by_areas: Vec<f64> = both.map(|(a, b)| non_overlap(sides(a), sides(b))).collect();
    print("\nFootprints by dpdx against the matrix M from positions, distances and curvature:");
    print("                                    median      99 %  above 10 %");
    let areas = "non-overlap over larger area";
    for (what, values) in [
        ("difference of sides over M's", &by_sides),
        (areas, &by_areas),
        ("the same in the report", &shot.disagreement),
    ] {
        let Spread { median, high, share, .. } = Spread::of(values, &shot.judged);
        print(&format!("  {what:30} {median:9.4} {high:9.4} {:9.2} %", 100.0 * share));
    }
    print(
        "Left sides, right areas: dark blue 0.001 and less, purple 0.01, orange 0.1, yellow 1 and \
            more;",
    );
    print(
        "gray where half vectors are below the horizon and both footprints zero, which counts as \
            0 above.",
    );
    let colored = |values: &Vec<f64>| {
        let pixels = values.iter().zip(&shot.judged);
        let shown = |(&value, &judged)| match judged {
            false => [255; 3],
            true if value == 0.0 => [128; 3],
            true => color(value),
        };
        pixels.map(shown).collect()
    };
    strip(shot.width, &[colored(&by_sides), colored(&by_areas)])
}

/// Of [`COLORS`], by the logarithm.
fn color(value: f64) -> [u8; 3] {
    let at = (value.max(1e-3).log10() + 3.0).min(2.999_999);
    // From 0 to 2: the cast only drops the fraction.
    #[allow(clippy::cast_sign_loss)]
    let decade = at as usize;
    let (from, to) = (COLORS[decade], COLORS[decade + 1]);
    #[allow(clippy::cast_sign_loss)]
    std::array::from_fn(|k| (from[k] + at.fract() * (to[k] - from[k])) as u8)
}

/// A PNG file of pictures side by side.
fn strip(width: usize, pictures: &[Vec<[u8; 3]>]) -> Result<Vec<u8>, String> {
    let height = pictures.first().map_or(0, |picture| picture.len() / width);
    let mut bytes = Vec::new();
    for row in (0..height).flat_map(|row| [row; ZOOM]) {
        for (n, picture) in pictures.iter().enumerate() {
            bytes.extend([255; 3 * GAP].iter().filter(|_| n > 0));
            let pixels = &picture[row * width..][..width];
            bytes.extend(pixels.iter().flat_map(|pixel| [*pixel; ZOOM].into_iter().flatten()));
        }
    }
    let mut file = Vec::new();
    let across = pictures.len() * (width * ZOOM + GAP) - GAP;
    let [across, down] =
        [across, height * ZOOM].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
    let mut encoder = png::Encoder::new(&mut file, across, down);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    let mut writer = encoder.write_header().map_err(|error| error.to_string())?;
    writer.write_image_data(&bytes).map_err(|error| error.to_string())?;
    writer.finish().map_err(|error| error.to_string())?;
    Ok(file)
}

/// All files under other names first, then renamed: a reader sees whole ones.
fn write(folder: &Path, files: &[(String, Vec<u8>)]) -> std::io::Result<Vec<PathBuf>> {
    let unfinished = |name: &str| folder.join(format!(".{name}.{}", std::process::id()));
    let written = || -> std::io::Result<Vec<PathBuf>> {
        fs::create_dir_all(folder)?;
        for (name, bytes) in files {
            fs::write(unfinished(name), bytes)?;
        }
        let finish = |(name, _): &(String, Vec<u8>)| {
            let path = folder.join(name);
            fs::rename(unfinished(name), &path).map(|()| path)
        };
        files.iter().map(finish).collect()
    };
    let paths = written();
    if paths.is_err() {
        for (name, _) in files {
            // The first error is the one to report.
            let _ = fs::remove_file(unfinished(name));
        }
    }
    paths
}

/// To stdout; a reader who has seen enough may close the pipe.
fn print(line: &str) {
    let _ = writeln!(std::io::stdout(), "{line}");
}

/// What is being done, on a terminal only.
fn progress(what: &str) {
    let mut stderr = std::io::stderr();
    if stderr.is_terminal() {
        let _ = writeln!(stderr, "{what} ...");
    }
}
