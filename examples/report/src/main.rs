//! Error against run time: every filter of lobe against plain supersampling, on scenes with glints.
//!
//! `cargo run --release -p lobe-report -- --help`. The way of the data: a `scene` gives samples, a
//! `method` shades them, `reference` is what they should have given, `metric` and `timing` put numbers
//! on both, `study` collects a scene's, `page` shows them. `kernels` judges filters of GGX without any scene.

mod camera;
mod frame;
mod frontier;
mod kernels;
mod method;
mod metric;
mod options;
mod output;
mod page;
mod pattern;
mod reference;
mod render;
mod scalar;
mod scene;
mod study;
mod texture;
mod timing;

use std::io::Write;
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;

use indicatif::{ProgressBar, ProgressStyle};

use camera::Size;
use kernels::Kernels;
use options::{Mistake, Options, Scenes};
use output::Output;
use page::Report;
use scene::{NormalMap, Subject, carried_maps};
use study::Study;
use texture::Texture;

fn main() -> ExitCode {
    match Options::parse_or_explain().and_then(|options| options.map_or(Ok(()), |o| run(&o))) {
        Ok(()) => ExitCode::SUCCESS,
        Err(mistake) => {
            eprintln!("error: {mistake}");
            ExitCode::from(2)
        }
    }
}

/// Checks the input, studies every scene, writes the page.
fn run(options: &Options) -> Result<(), Mistake> {
    let effort = options.effort();
    let size = Size::of_width(effort.width);
    let subjects = subjects(options, size)?;
    let output = Output::prepare(&options.out)?;

    let methods = method::all();
    let bar = ProgressBar::new(subjects.len() as u64 * study::steps(size, methods.len()));
    if let Ok(style) = ProgressStyle::with_template("{msg:24} {wide_bar} {percent:>3} %  {eta}") {
        bar.set_style(style);
    }
    let kernels = Kernels::measured().map_err(|error| Mistake(format!("kernels: {error}")))?;
    let mut report = Report::new(options, effort, kernels);
    for subject in subjects {
        bar.set_message(subject.name.clone());
        let study = Study::run(subject, options.alpha, &methods, effort, &|steps| bar.inc(steps))
            .map_err(|error| Mistake(format!("--alpha {}: {error}", options.alpha)))?;
        bar.suspend(|| print(&page::text(&study)));
        report.studies.push(study);
    }
    bar.finish_and_clear();
    print(&report.kernels_text());
    if let Some(cover) = report.cover() {
        output.write(output::COVER, &cover)?;
    }
    let path = output.write(output::PAGE, report.html(&methods).as_bytes())?;
    print(&format!("{}Page: {}\n", report.summary_text(), path.display()));
    Ok(())
}

/// To stdout; a reader who has seen enough may close the pipe.
fn print(text: &str) {
    let _ = std::io::stdout().write_all(text.as_bytes());
}

/// The scenes asked for, their maps read and decoded.
fn subjects(options: &Options, size: Size) -> Result<Vec<Subject>, Mistake> {
    let mut subjects = Vec::new();
    if options.scene != Scenes::Plane {
        subjects.push(Subject::water(size));
    }
    if options.scene != Scenes::Water {
        let maps = match &options.normal_map {
            Some(path) => vec![normal_map(path)?],
            None => carried_maps().map_err(Mistake)?,
        };
        subjects.extend(maps.iter().map(|map| Subject::plane(size, map)));
    }
    Ok(subjects)
}

/// A user's normal map.
fn normal_map(path: &Path) -> Result<NormalMap, Mistake> {
    let mistake = |error: &dyn std::fmt::Display| {
        Mistake(format!("--normal-map '{}': {error}", path.display()))
    };
    let file = std::fs::read(path).map_err(|error| mistake(&error))?;
    let texture = Texture::decode(&file).map_err(|error| mistake(&error))?;
    let name = path.file_stem().map_or("normal map".into(), |stem| stem.to_string_lossy());
    Ok(NormalMap { name: name.into_owned(), texture: Arc::new(texture) })
}
