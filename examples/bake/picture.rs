//! A PNG: opened, checked, and given out in bands of rows.

use png::{BitDepth, ColorType, Decoder, DecodingError, Limits, Reader};
use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use std::time::{Duration, Instant};

/// What a picture is expected to be.
#[derive(Clone, Copy, PartialEq)]
pub(crate) enum Content {
    Normals,
    Heights,
}

/// How a texel's bytes are laid out: numbers of one width, the highest byte first.
#[derive(Clone, Copy)]
pub(crate) struct Texel {
    pub(crate) channels: usize,
    /// 16 bits, not 8.
    pub(crate) wide: bool,
}

impl Texel {
    pub(crate) fn bytes(self) -> usize {
        self.channels * if self.wide { 2 } else { 1 }
    }
}

/// A picture whose header has been read and is what was expected.
pub(crate) struct Picture {
    reader: Reader<BufReader<File>>,
    size: [usize; 2],
    texel: Texel,
}

/// No side longer than this: 16 K maps are the largest that engines ship.
const LONGEST_SIDE: u32 = 16_384;
/// Bytes the decoder may take, for files that claim more than they hold.
const DECODER_BYTES: usize = 256 << 20;
/// Texels of a band: large enough for threads, small beside the map.
const BAND: usize = 1 << 20;

impl Picture {
    /// RGB or RGBA for normals, greyscale with or without alpha for heights; 8 or 16 bits.
    pub(crate) fn open(path: &Path, content: Content) -> Result<Self, String> {
        let unreadable = |error: std::io::Error| format!("cannot be read ({error})");
        let file = File::open(path).map_err(unreadable)?;
        let data = file.metadata().map_err(unreadable)?;
        if data.is_dir() {
            return Err("is a folder".to_owned());
        }
        if data.is_file() && data.len() == 0 {
            return Err("the file is empty".to_owned());
        }
        let limits = Limits { bytes: DECODER_BYTES };
        let mut decoder = Decoder::new_with_limits(BufReader::with_capacity(1 << 16, file), limits);
        // By default the checksum of the pixels is not looked at.
        decoder.ignore_checksums(false);
        let reader = decoder.read_info().map_err(broken)?;
        let info = reader.info();
        let (width, height) = (info.width, info.height);
        if width == 0 || height == 0 {
            return Err("the picture has no pixels".to_owned());
        }
        if width > LONGEST_SIDE || height > LONGEST_SIDE {
            return Err(format!("{width} x {height} is too large (at most {LONGEST_SIDE} a side)"));
        }
        let channels = channels(info.color_type, content)?;
        let wide = match info.bit_depth {
            BitDepth::Eight => false,
            BitDepth::Sixteen => true,
            _ => return Err("has fewer than 8 bits a channel".to_owned()),
        };
        // Both sides are at most LONGEST_SIDE.
        let size = [width, height].map(|n| n as usize);
        Ok(Self { reader, size, texel: Texel { channels, wide } })
    }

    /// Width and height in texels.
    pub(crate) fn size(&self) -> [usize; 2] {
        self.size
    }

    pub(crate) fn texel(&self) -> Texel {
        self.texel
    }

    /// Gives `take` the bytes of band after band, with the number of the first row; how long decoding alone took.
    pub(crate) fn bands(
        mut self,
        mut take: impl FnMut(usize, &[u8]) -> Result<(), String>,
    ) -> Result<Duration, String> {
        let [width, height] = self.size;
        let line = width * self.texel.bytes();
        // Interlaced rows arrive in no order: the picture is then one band.
        let interlaced = self.reader.info().interlaced;
        let rows = if interlaced { height } else { (BAND / width).clamp(1, height) };
        let mut band = vec![0; rows * line];
        let mut decoding = Duration::ZERO;
        for first in (0..height).step_by(rows) {
            let start = Instant::now();
            let band = &mut band[..rows.min(height - first) * line];
            if interlaced {
                self.reader.next_frame(band).map_err(broken)?;
            } else {
                for row in band.chunks_exact_mut(line) {
                    let read = self.reader.read_row(row).map_err(broken)?;
                    read.ok_or("not a readable PNG (it has too few rows)")?;
                }
            }
            decoding += start.elapsed();
            take(first, band)?;
        }
        // What is cut off after the last row is cut off, too.
        self.reader.finish().map_err(broken)?;
        Ok(decoding)
    }
}

fn channels(color: ColorType, content: Content) -> Result<usize, String> {
    let normals = "a normal map needs RGB or RGBA";
    Err(match (color, content) {
        (ColorType::Rgb, Content::Normals) => return Ok(3),
        (ColorType::Rgba, Content::Normals) => return Ok(4),
        (ColorType::Grayscale, Content::Heights) => return Ok(1),
        (ColorType::GrayscaleAlpha, Content::Heights) => return Ok(2),
        (ColorType::Indexed, Content::Normals) => format!("is a palette picture; {normals}"),
        (_, Content::Normals) => format!("is greyscale; {normals}, a displacement map --height"),
        (ColorType::Indexed, _) => "is a palette picture; --height needs greyscale".to_owned(),
        _ => "is a colour picture; --height needs greyscale".to_owned(),
    })
}

// By value: the shape that `map_err` takes.
#[allow(clippy::needless_pass_by_value)]
fn broken(error: DecodingError) -> String {
    match error {
        DecodingError::IoError(error) if error.kind() != std::io::ErrorKind::UnexpectedEof => {
            format!("cannot be read ({error})")
        }
        error => format!("not a readable PNG ({error})"),
    }
}
