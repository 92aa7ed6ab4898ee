//! The program: options in, a page and its data out, progress on the way.

use std::io::Write;
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;

use indicatif::{ProgressBar, ProgressStyle};

use crate::camera::Size;
use crate::channels::Channels;
use crate::facets::{self, Facets};
use crate::glints::{self, Glitter};
use crate::kernels::Kernels;
use crate::looks::{self, Green};
use crate::method;
use crate::minify::{self, Minified, STEEPEST};
use crate::options::{Mistake, Options, Scenes};
use crate::output::{self, Output};
use crate::page::{self, Report};
use crate::picture;
use crate::relief::{self, Relief};
use crate::say::say;
use crate::scene::{Movement, NormalMap, Subject, carried_maps, restless_map};
use crate::sequence::{Plan, Sequence};
use crate::sizes::Sizes;
use crate::study::{self, Study};
use crate::texture::{Decoded, Texture};

/// The program `lobe-report`: reads the command line, studies every scene, writes the page.
pub fn run() -> ExitCode {
    match Options::parse_or_explain().and_then(|options| options.map_or(Ok(()), |o| report(&o))) {
        Ok(()) => ExitCode::SUCCESS,
        Err(mistake) => {
            say(&format!("error: {mistake}"));
            ExitCode::from(2)
        }
    }
}

/// Checks the input, studies every scene, writes the page.
fn report(options: &Options) -> Result<(), Mistake> {
    let effort = options.effort();
    let size = Size::of_width(effort.width);
    let maps = maps(options)?;
    let subjects = subjects(options, size, &maps);
    let plan = options.plan();
    let minification = options.minification();
    let minified = if options.scene.include(Scenes::Minified) { maps.as_slice() } else { &[] };
    let moving = moving(options, Size::of_width(plan.width), &maps)?;
    let output = Output::prepare(&options.out)?;

    let methods = method::all();
    let steps = subjects.len() as u64 * study::steps(size, methods.len(), &effort);
    let (relief, glints) = (options.relief(), options.glints());
    let steps = steps
        + moving.len() as u64 * plan.steps()
        + minified.len() as u64 * minification.steps()
        + relief.as_ref().map_or(0, relief::Plan::steps)
        + glints.as_ref().map_or(0, |_| glints::steps() + facets::steps());
    let bar = ProgressBar::new(steps);
    if let Ok(style) = ProgressStyle::with_template("{msg:24} {wide_bar} {percent:>3} %  {eta}") {
        bar.set_style(style);
    }
    let kernels = Kernels::measured().map_err(|error| Mistake(format!("kernels: {error}")))?;
    let sizes = Sizes::measured().map_err(|error| Mistake(format!("shaders: {error}")))?;
    let mut report = Report::new(effort.clone(), kernels, sizes);
    for subject in subjects {
        bar.set_message(subject.name.clone());
        let study = Study::run(subject, &methods, &effort, &|steps| bar.inc(steps))
            .map_err(|error| Mistake(format!("--alpha: {error}")))?;
        bar.suspend(|| print(&page::text(&study)));
        report.studies.push(study);
    }
    let shown = Plan::methods(method::all());
    for (subject, movement) in moving {
        bar.set_message(format!("{} in motion", subject.name));
        let sequence = Sequence::run(&subject, movement, &shown, &plan, &|steps| bar.inc(steps))
            .map_err(|error| Mistake(format!("--alpha: {error}")))?;
        bar.suspend(|| print(&page::sequence_text(&sequence)));
        report.sequences.push(sequence);
    }
    for map in minified {
        bar.set_message(format!("{}, minified", map.name));
        let minified = Minified::run(map, &minification, &|steps| bar.inc(steps))
            .map_err(|error| Mistake(format!("--alpha: {error}")))?;
        bar.suspend(|| print(&page::minified_text(&minified)));
        report.minified.push(minified);
    }
    if let Some(plan) = relief {
        bar.set_message("relief");
        let relief = Relief::measured(&plan, &|| bar.inc(1));
        report.relief = Some(relief.map_err(|error| Mistake(format!("relief: {error}")))?);
    }
    if let Some(plan) = glints {
        bar.set_message("glints");
        let glints = Glitter::measured(&plan, &|| bar.inc(1));
        report.glints = Some(glints.map_err(|error| Mistake(format!("glints: {error}")))?);
    }
    if let Some(plan) = options.facets() {
        bar.set_message("facets");
        let facets = Facets::measured(&plan, &|| bar.inc(1));
        report.facets = Some(facets.map_err(|error| Mistake(format!("facets: {error}")))?);
    }
    bar.finish_and_clear();
    print(&report.relief_text());
    print(&report.glints_text());
    print(&report.facets_text());
    print(&report.kernels_text());
    print(&report.sizes_text());
    print(&report.advice_text());
    let cover = report.cover();
    let mut files = vec![
        (output::ADVICE, report.advice_markdown().into_bytes()),
        (output::DATA, report.json().map_err(Mistake)?),
        (output::PAGE, report.html(&methods).into_bytes()),
    ];
    files.extend(cover.iter().map(|cover| (output::COVER, cover.file.clone())));
    output.write(&files)?;
    let path = output.path(output::PAGE);
    print(&format!("{}Page: {}\n", report.summary_text(cover.as_ref()), path.display()));
    Ok(())
}

/// To stdout; a reader who has seen enough may close the pipe.
fn print(text: &str) {
    let _ = std::io::stdout().write_all(text.as_bytes());
}

/// The maps of the scenes asked for, read and decoded.
fn maps(options: &Options) -> Result<Vec<NormalMap>, Mistake> {
    let asked = |scene: Scenes| options.scene.include(scene);
    match &options.normal_map {
        _ if ![Scenes::Plane, Scenes::MappedSphere, Scenes::Minified].into_iter().any(asked) => {
            Ok(Vec::new())
        }
        Some(path) => Ok(vec![normal_map(path, options.channels)?]),
        None => carried_maps(!options.quick).map_err(Mistake),
    }
}

/// The scenes asked for that are shown in motion, and how they move; a user's map on the ball that
/// turns.
fn moving(
    options: &Options,
    size: Size,
    maps: &[NormalMap],
) -> Result<Vec<(Subject, Movement)>, Mistake> {
    let mut moving = Vec::new();
    if options.scene.include(Scenes::MappedSphere) {
        let ball = match (&options.normal_map, maps) {
            (Some(_), [map, ..]) => Subject::mapped_ball(size, map),
            _ => Subject::mapped_ball(size, &restless_map().map_err(Mistake)?),
        };
        moving.push((ball, Movement::Turn));
    }
    if options.scene.include(Scenes::Water) {
        moving.push((Subject::water(size), Movement::Pan));
    }
    Ok(moving)
}

/// The scenes asked for.
fn subjects(options: &Options, size: Size, maps: &[NormalMap]) -> Vec<Subject> {
    let asked = |scene: Scenes| options.scene.include(scene);
    let mut subjects = Vec::new();
    let mut add = |scene: Scenes, make: &dyn Fn() -> Vec<Subject>| {
        if asked(scene) {
            subjects.extend(make());
        }
    };
    add(Scenes::Water, &|| vec![Subject::water(size)]);
    add(Scenes::Sphere, &|| vec![Subject::balls(size)]);
    add(Scenes::Torus, &|| vec![Subject::torus(size)]);
    add(Scenes::Plane, &|| maps.iter().map(|map| Subject::plane(size, map)).collect());
    add(Scenes::MappedSphere, &|| maps.iter().map(|map| Subject::mapped_ball(size, map)).collect());
    add(Scenes::Strip, &|| vec![Subject::strips(size)]);
    add(Scenes::Disk, &|| vec![Subject::disk(size)]);
    subjects
}

/// A user's normal map; what it looks like is told on standard error.
fn normal_map(path: &Path, channels: Channels) -> Result<NormalMap, Mistake> {
    let named = |line: &str| format!("--normal-map '{}': {line}", path.display());
    let mistake = |error: String| Mistake(named(&error));
    let file = picture::bytes_of(path).map_err(mistake)?;
    let Decoded { texture, hints } = Texture::decode(&file, channels).map_err(mistake)?;
    for hint in
        hints.into_iter().chain(looks_of(&texture).map_err(|error| mistake(error.to_string()))?)
    {
        say(&format!("warning: {}", named(&hint)));
    }
    let name = path.file_stem().map_or("normal map".into(), |stem| stem.to_string_lossy());
    Ok(NormalMap { name: name.into_owned(), texture: Arc::new(texture) })
}

/// What the slopes of a user's map look like, a line each.
fn looks_of(texture: &Texture) -> Result<Vec<String>, lobe::Error> {
    let (map, clipped) = minify::moments(texture)?;
    let clipped = looks::clipped(clipped, &format!("a slope of {STEEPEST}"));
    let green = Green { flipped: false, remedy: "invert its green channel" };
    Ok(clipped.into_iter().chain(looks::lines(&map, Some(green))).collect())
}
