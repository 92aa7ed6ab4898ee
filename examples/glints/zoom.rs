//! The zoom: one material from ever farther away, and whether its light stays the same.

use super::energy::Energy;
use super::picture::Picture;
use super::render::Renderer;
use super::scene::glitter;
use std::fmt::Write;
use std::path::Path;

/// The nearest and the farthest camera, in meters.
const DISTANCES: [f64; 2] = [0.4, 51.2];

/// Frames that the sheet shows, and how many of them in a row.
const SHOWN: usize = 8;
const COLUMNS: usize = 4;

/// One picture of the sequence.
struct Frame {
    distance: f64,
    /// Details along a pixel at the middle of the picture.
    details: f64,
    energy: Energy,
}

/// The sequence's numbers, and its sheet.
pub(crate) struct Zoom {
    frames: Vec<Frame>,
    tiles: Vec<Picture>,
}

impl Zoom {
    /// Draws so many frames; each goes to `put` with its number.
    pub(crate) fn draw(
        renderer: &Renderer,
        count: usize,
        mut put: impl FnMut(usize, &Picture) -> Result<(), String>,
    ) -> Result<Self, String> {
        let mut zoom = Self { frames: Vec::new(), tiles: Vec::new() };
        let shown: Vec<usize> = (0..SHOWN).map(|k| k * (count - 1) / (SHOWN - 1)).collect();
        for k in 0..count {
            let part = k as f64 / (count - 1) as f64;
            let distance = DISTANCES[0] * (DISTANCES[1] / DISTANCES[0]).powf(part);
            let scene = glitter(distance).map_err(|error| error.to_string())?.seeded(renderer.seed);
            let (picture, energy) = renderer.draw(&scene)?;
            put(k, &picture)?;
            // Of fewer frames than places some are shown twice.
            let [width, height] = renderer.size;
            for _ in shown.iter().filter(|place| **place == k) {
                zoom.tiles.push(picture.middle([width / COLUMNS, height / 2]));
            }
            let pixel = 2.0 * distance * scene.view.half_height / height as f64;
            let details = pixel / scene.material.detail_size();
            zoom.frames.push(Frame { distance, details, energy });
        }
        Ok(zoom)
    }

    /// Some frames side by side: their middles, pixel by pixel.
    pub(crate) fn sheet(&self) -> Picture {
        Picture::sheet(&self.tiles, COLUMNS)
    }

    /// A line for each frame, and what changes between them.
    pub(crate) fn table(&self) -> Result<String, std::fmt::Error> {
        let mut text = String::from(
            "frame   distance   details   radiance     smooth    ratio   expected   cells   most\n",
        );
        for (k, Frame { distance, details, energy }) in self.frames.iter().enumerate() {
            writeln!(
                text,
                "{k:5} {distance:8.3} m {details:9.3} {:10.5} {:10.5} {:8.4} {:10.4} {:7.1} {:6}",
                energy.details / energy.pixels,
                energy.smooth / energy.pixels,
                energy.ratio(),
                energy.deviation(),
                energy.cells(),
                energy.most,
            )?;
        }
        let pairs = self.frames.windows(2);
        let change = |pair: &[Frame]| (pair[1].energy.ratio() / pair[0].energy.ratio() - 1.0).abs();
        let largest = pairs.map(change).fold(0.0, f64::max);
        let farthest = self.frames.iter().map(|frame| (frame.energy.ratio() - 1.0).abs());
        writeln!(
            text,
            "largest change between frames {:.2} %, farthest from the smooth lobe {:.2} %",
            100.0 * largest,
            100.0 * farthest.fold(0.0, f64::max),
        )?;
        Ok(text)
    }
}

/// The file of frame `k`.
pub(crate) fn frame_name(suffix: &str, k: usize) -> String {
    format!("zoom{suffix}.{k}.png")
}

/// Frames that are in a folder: of a longer sequence, some would be taken for a new one's.
pub(crate) fn frames(folder: &Path, suffix: &str) -> Vec<String> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    let start = format!("zoom{suffix}.");
    let frame = |name: &String| {
        let number = name.strip_prefix(&start).and_then(|name| name.strip_suffix(".png"));
        let number = number.and_then(|number| number.parse().ok());
        number.is_some_and(|k| frame_name(suffix, k) == *name)
    };
    names.filter(frame).collect()
}
