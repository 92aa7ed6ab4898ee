//! The files of each level: written by rows, several at a time.

use super::folder::Folder;
use super::progress::Progress;
use super::roughness::Roughness;
use lobe::material::lean::{Float32, MomentMap, Storage, Unorm16};
use png::{BitDepth, ColorType, Compression, Encoder};
use std::fs::File;
use std::io::{BufWriter, Write};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::scope;

/// What a file holds of its level.
#[derive(Clone, Copy)]
enum Part {
    Mean,
    Second,
    Raw,
    Roughness(Roughness),
}

impl Part {
    const MOMENTS: [Self; 3] = [Self::Raw, Self::Second, Self::Mean];

    /// Every file of a level.
    fn all(roughness: Option<Roughness>) -> Vec<Self> {
        Self::MOMENTS.into_iter().chain(roughness.map(Self::Roughness)).collect()
    }

    /// Of a texel.
    fn bytes(self) -> usize {
        match self {
            Self::Mean | Self::Second => 6,
            Self::Raw => 20,
            Self::Roughness(roughness) => roughness.bits() as usize / 8,
        }
    }

    fn name(self, level: usize) -> String {
        match self {
            Self::Mean => format!("mean.{level}.png"),
            Self::Second => format!("second.{level}.png"),
            Self::Raw => format!("moments.{level}.f32"),
            Self::Roughness(_) => format!("roughness.{level}.png"),
        }
    }
}

/// A map's levels in the layouts of 16 bits and of f32.
pub(crate) struct Levels<'a> {
    map: &'a MomentMap<f32>,
    short: Unorm16,
    long: Float32,
    parts: Vec<Part>,
    /// Texels of a roughness above 1.
    above: AtomicUsize,
}

/// Texels between two looks at the progress.
const STEP: usize = 1 << 16;
/// Bytes of the buffers before a file and of a PNG's chunks.
const BUFFER: usize = 1 << 18;

impl<'a> Levels<'a> {
    pub(crate) fn new(
        map: &'a MomentMap<f32>,
        short: Unorm16,
        roughness: Option<Roughness>,
    ) -> Result<Self, String> {
        // Floats need no range to be written; their floor depends on the steepest slope, which a
        // flat map has not.
        let steepest = map.range().max(2e-9);
        let long = Float32::new(steepest).map_err(|error| error.to_string())?;
        Ok(Self { map, short, long, parts: Part::all(roughness), above: AtomicUsize::new(0) })
    }

    /// How many texels all files of a map have together.
    pub(crate) fn texels(mut size: [usize; 2], roughness: Option<Roughness>) -> u64 {
        let mut sum = size[0] * size[1];
        while size != [1, 1] {
            size = size.map(|n| (n / 2).max(1));
            sum += size[0] * size[1];
        }
        (sum * Part::all(roughness).len()) as u64
    }

    /// Texels of all levels written so far whose roughness is above 1.
    pub(crate) fn above_one(&self) -> usize {
        self.above.load(Ordering::Relaxed)
    }

    /// Of 16 bits and of f32.
    pub(crate) fn alpha_floors(&self) -> [f32; 2] {
        [self.short.alpha_floor(), self.long.alpha_floor()]
    }

    /// Every file's name, the finest level first.
    pub(crate) fn names(&self) -> Vec<String> {
        let levels = 0..self.map.levels();
        levels.flat_map(|level| self.parts.iter().map(move |part| part.name(level))).collect()
    }

    /// Every file, into the folder.
    pub(crate) fn write(
        &self,
        folder: &Folder,
        threads: usize,
        progress: &Progress,
    ) -> Result<(), String> {
        let next = AtomicUsize::new(0);
        let files = self.map.levels() * self.parts.len();
        let failed = Mutex::new(None);
        let work = || {
            loop {
                let file = next.fetch_add(1, Ordering::Relaxed);
                if file >= files {
                    return;
                }
                let (level, part) = (file / self.parts.len(), self.parts[file % self.parts.len()]);
                if let Err(error) = self.file(folder, level, part, progress) {
                    // The others end with their file, and the first error is the one told.
                    next.store(files, Ordering::Relaxed);
                    if let Ok(mut failed) = failed.lock() {
                        failed.get_or_insert(error);
                    }
                }
            }
        };
        scope(|scope| {
            for _ in 0..threads.min(files) {
                scope.spawn(work);
            }
        });
        failed.into_inner().map_or(Ok(()), |failed| failed.map_or(Ok(()), Err))
    }

    fn file(
        &self,
        folder: &Folder,
        level: usize,
        part: Part,
        progress: &Progress,
    ) -> Result<(), String> {
        let name = part.name(level);
        let full = |error: std::io::Error| folder.refused(&name, &error);
        let of_png = |error: png::EncodingError| full(error.into());
        let mut file = BufWriter::with_capacity(BUFFER, folder.create(&name)?);
        if let Part::Raw = part {
            self.rows(level, part, progress, |bytes| file.write_all(bytes).map_err(full))?;
        } else {
            let mut png = self.png(&mut file, level, part).map_err(of_png)?;
            let mut pixels = png.stream_writer_with_size(BUFFER).map_err(of_png)?;
            self.rows(level, part, progress, |bytes| pixels.write_all(bytes).map_err(full))?;
            pixels.finish().map_err(of_png)?;
            png.finish().map_err(of_png)?;
        }
        file.flush().map_err(full)
    }

    /// Gives `put` the bytes of row after row.
    fn rows(
        &self,
        level: usize,
        part: Part,
        progress: &Progress,
        mut put: impl FnMut(&[u8]) -> Result<(), String>,
    ) -> Result<(), String> {
        let [width, height] = self.map.size(level);
        let mut bytes = vec![0; width * part.bytes()];
        let (mut since, mut above) = (0, 0);
        for row in 0..height {
            for (column, out) in bytes.chunks_exact_mut(part.bytes()).enumerate() {
                let moments = self.map.texel(level, column, row);
                match part {
                    Part::Raw => numbers(out, self.long.encode(&moments).map(f32::to_le_bytes)),
                    Part::Mean => {
                        let [x, y, ..] = self.short.encode(&moments);
                        // Blue is 0, so the normals would point down: nobody bakes this file as a
                        // normal map by mistake.
                        numbers(out, [x, y, 0].map(u16::to_be_bytes));
                    }
                    Part::Second => {
                        let [_, _, xx, xy, yy] = self.short.encode(&moments);
                        numbers(out, [xx, xy, yy].map(u16::to_be_bytes));
                    }
                    Part::Roughness(roughness) => {
                        let (code, over) = roughness.code(&moments);
                        // The highest byte first; 8 bits are the lowest one.
                        let code = code.to_be_bytes();
                        out.copy_from_slice(&code[code.len() - out.len()..]);
                        above += usize::from(over);
                    }
                }
            }
            put(&bytes)?;
            since += width;
            if since >= STEP || row + 1 == height {
                progress.by(since as u64)?;
                since = 0;
            }
        }
        self.above.fetch_add(above, Ordering::Relaxed);
        Ok(())
    }

    fn png<'w>(
        &self,
        file: &'w mut BufWriter<File>,
        level: usize,
        part: Part,
    ) -> Result<png::Writer<&'w mut BufWriter<File>>, png::EncodingError> {
        // Sides of at most 16384.
        let [width, height] = self.map.size(level).map(|n| n as u32);
        let mut encoder = Encoder::new(file, width, height);
        let (color, wide) = match part {
            Part::Roughness(roughness) => (ColorType::Grayscale, roughness.wide),
            _ => (ColorType::Rgb, true),
        };
        encoder.set_color(color);
        encoder.set_depth(if wide { BitDepth::Sixteen } else { BitDepth::Eight });
        encoder.set_compression(Compression::Fast);
        encoder.write_header()
    }
}

/// A texel's numbers, one after the other.
#[inline]
fn numbers<const BYTES: usize, const COUNT: usize>(out: &mut [u8], numbers: [[u8; BYTES]; COUNT]) {
    out.copy_from_slice(numbers.as_flattened());
}
