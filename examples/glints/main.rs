//! Glittering materials as pictures: snow, fabric, brushed metal, grooves, and one of them from
//! ever farther away.
//!
//! `cargo run --release --example glints` writes target/glints and prints each picture's energy;
//! `--help` lists the options. Exit status: 0; 2 for mistakes and for what cannot be written, 130
//! after Ctrl-C or SIGTERM; then nothing is written.

mod camera;
mod energy;
#[path = "../common/folder.rs"]
mod folder;
mod material;
#[path = "../common/mistake.rs"]
mod mistake;
mod options;
mod picture;
mod pixel;
#[path = "../common/print.rs"]
mod print;
#[path = "../common/progress.rs"]
mod progress;
mod render;
#[path = "../common/say.rs"]
mod say;
mod scene;
mod surface;
mod zoom;

use folder::Folder;
use options::{Options, Subject};
use progress::Progress;
use render::Renderer;
use std::process::ExitCode;
use std::time::Instant;
use zoom::Zoom;

/// The files of a run, and what it says of them.
struct Run<'a> {
    renderer: Renderer<'a>,
    folder: &'a Folder,
    names: Vec<String>,
    said: Vec<String>,
}

impl Run<'_> {
    /// One picture.
    fn still(&mut self, subject: Subject) -> Result<(), String> {
        let start = Instant::now();
        let scene = scene::scene(subject).map_err(|error| error.to_string())?;
        let scene = scene.seeded(self.renderer.seed);
        let (picture, energy) = self.renderer.draw(&scene)?;
        let name = format!("{}{}.png", subject.name(), self.renderer.method.suffix());
        picture.write(self.folder, &name)?;
        let cells = match energy.most {
            0 => String::new(),
            most => format!(", {:.1} cells a pixel, at most {most}", energy.cells()),
        };
        self.said.push(format!(
            "{name}: {:.4} of the smooth lobe's light{cells}, in {:.2} s\n",
            energy.ratio(),
            start.elapsed().as_secs_f64(),
        ));
        self.names.push(name);
        Ok(())
    }

    /// The frames of the zoom and their sheet.
    fn zoom(&mut self, count: usize) -> Result<(), String> {
        let start = Instant::now();
        let suffix = self.renderer.method.suffix();
        let (folder, names) = (self.folder, &mut self.names);
        let zoom = Zoom::draw(&self.renderer, count, |k, picture| {
            let name = zoom::frame_name(suffix, k);
            picture.write(folder, &name)?;
            names.push(name);
            Ok(())
        })?;
        let name = format!("zoom{suffix}.png");
        zoom.sheet().write(folder, &name)?;
        self.said.push(format!(
            "{name}: {count} frames in {:.2} s\n{}",
            start.elapsed().as_secs_f64(),
            zoom.table().map_err(|error| error.to_string())?,
        ));
        self.names.push(name);
        Ok(())
    }
}

/// Draws everything into the folder; returns what to say.
fn draw(options: &Options, progress: &Progress) -> Result<String, String> {
    let scenes = options.scenes()?;
    // Before the work, for what cannot be written; of no name yet, and gone again if the work
    // fails.
    let folder = Folder::new(&options.out, "glints")?;
    let (size, method, seed) = (options.size, options.method(), options.seed);
    let renderer = Renderer { size, method, seed, threads: options.threads(), progress };
    let pictures = |scene: &Subject| if *scene == Subject::Zoom { options.frames() } else { 1 };
    progress.begin(scenes.iter().map(pictures).sum::<usize>() as u64 * renderer.steps());
    let mut run = Run { renderer, folder: &folder, names: Vec::new(), said: Vec::new() };
    for scene in &scenes {
        progress.stage(scene.name());
        match scene {
            Subject::Zoom => run.zoom(options.frames())?,
            _ => run.still(*scene)?,
        }
    }
    let Run { names, said, .. } = run;
    let zoomed = scenes.contains(&Subject::Zoom);
    let old = if zoomed { zoom::frames(&options.out, method.suffix()) } else { Vec::new() };
    folder.finish(&names, old)?;
    Ok(said.concat())
}

/// Draws what the command line asks for.
fn main() -> ExitCode {
    let options = match Options::of_command_line() {
        Ok(options) => options,
        Err(code) => return code,
    };
    let progress = Progress::new();
    let drawn = draw(&options, &progress);
    progress.end();
    match drawn.and_then(|said| print::print(&said)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => print::failed("glints", &message, progress.stopped()),
    }
}
