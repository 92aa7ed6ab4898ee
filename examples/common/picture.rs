//! A PNG: read strictly, and given out in bands of rows with every texel expanded.
//!
//! The one reader of the programs that take maps. A file is whole ([`integrity`](super::integrity))
//! or refused. Palettes, grays below 8 bits and transparency become channels of 8 or 16 bits,
//! exactly; gamma, sRGB and ICC chunks are not applied, as normals are no colors; of an animation
//! the still picture is read.

use super::integrity::{broken, trailing};
use png::{BitDepth, ColorType, Decoder, Limits, Reader, Transformations};
use std::fs::File;
use std::io::{Cursor, Read};
use std::path::Path;

/// How a texel's bytes are laid out: numbers of one width, the highest byte first.
#[derive(Clone, Copy)]
pub(crate) struct Texel {
    /// 1 is gray, 2 gray and alpha, 3 RGB, 4 RGBA.
    pub(crate) channels: usize,
    /// 16 bits, not 8.
    pub(crate) wide: bool,
}

impl Texel {
    /// Bytes of a texel.
    pub(crate) fn bytes(self) -> usize {
        self.channels * if self.wide { 2 } else { 1 }
    }

    /// Whether the last channel is alpha.
    pub(crate) fn has_alpha(self) -> bool {
        matches!(self.channels, 2 | 4)
    }
}

/// A whole PNG whose header has been read.
pub(crate) struct Picture<'a> {
    reader: Reader<Cursor<&'a [u8]>>,
    size: [usize; 2],
    texel: Texel,
    palette: Option<Palette>,
    trailing: usize,
}

/// The colors of a palette picture.
struct Palette {
    colors: Vec<[u8; 4]>,
    /// Bits of an index: 1, 2, 4 or 8.
    bits: usize,
}

/// No side longer than this: 16 K maps are the largest that engines ship.
const LONGEST_SIDE: u32 = 16_384;
/// Bytes the decoder may take, for files that claim more than they hold.
const DECODER_BYTES: usize = 256 << 20;
/// Bytes of a file at most: more than the largest map of 16-bit RGBA takes without compression.
const LONGEST_FILE: u64 = 3 << 30;
/// Texels of a band: large enough for threads, small beside the map.
const BAND: usize = 1 << 20;

/// How files of other formats begin, under whatever name.
const OTHERS: [(&[u8], &str); 12] = [
    (b"\xff\xd8\xff", "a JPEG"),
    (b"DDS ", "a DDS texture"),
    (b"\xabKTX", "a KTX texture"),
    (b"PK\x03\x04", "a zip archive"),
    (b"GIF8", "a GIF"),
    (b"BM", "a BMP"),
    (b"II*\0", "a TIFF"),
    (b"MM\0*", "a TIFF"),
    (b"8BPS", "a Photoshop document"),
    (b"\x76\x2f\x31\x01", "an OpenEXR picture"),
    (b"RIFF", "a RIFF file (WebP?)"),
    (b"#?RADIANCE", "a Radiance HDR picture"),
];

/// A file's bytes.
pub(crate) fn bytes_of(path: &Path) -> Result<Vec<u8>, String> {
    let unreadable = |error: std::io::Error| format!("cannot be read ({error})");
    let file = File::open(path).map_err(unreadable)?;
    if file.metadata().map_err(unreadable)?.is_dir() {
        return Err("is a folder".to_owned());
    }
    let mut bytes = Vec::new();
    file.take(LONGEST_FILE + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    if bytes.len() as u64 > LONGEST_FILE {
        return Err("the file is larger than 3 GiB".to_owned());
    }
    Ok(bytes)
}

impl<'a> Picture<'a> {
    /// Checks the whole file, then reads its header.
    pub(crate) fn of(file: &'a [u8]) -> Result<Self, String> {
        if file.is_empty() {
            return Err("the file is empty".to_owned());
        }
        if let Some((_, kind)) = OTHERS.iter().find(|(begin, _)| file.starts_with(begin)) {
            return Err(format!("not a readable PNG (by its first bytes it is {kind})"));
        }
        let trailing = trailing(file)?;
        let mut decoder =
            Decoder::new_with_limits(Cursor::new(file), Limits { bytes: DECODER_BYTES });
        // Whatever its checksums are of has been checked.
        decoder.ignore_checksums(true);
        decoder.set_ignore_text_chunk(true);
        decoder.set_ignore_iccp_chunk(true);
        let header = decoder.read_header_info().map_err(broken)?;
        let (width, height) = (header.width, header.height);
        if width > LONGEST_SIDE || height > LONGEST_SIDE {
            return Err(format!("{width} x {height} is too large (at most {LONGEST_SIDE} a side)"));
        }
        let indexed = header.color_type == ColorType::Indexed;
        // Indices are expanded below: the decoder takes those beyond the palette for black.
        decoder.set_transformations(if indexed {
            Transformations::IDENTITY
        } else {
            Transformations::EXPAND
        });
        let reader = decoder.read_info().map_err(broken)?;
        let palette = if indexed { Some(Palette::of(reader.info())?) } else { None };
        let texel = match (reader.output_color_type(), &palette) {
            (_, Some(_)) => {
                Texel { channels: if reader.info().trns.is_some() { 4 } else { 3 }, wide: false }
            }
            ((color, depth), None) => {
                Texel { channels: color.samples(), wide: depth == BitDepth::Sixteen }
            }
        };
        // Both sides are at most LONGEST_SIDE.
        let size = [width, height].map(|n| n as usize);
        Ok(Self { reader, size, texel, palette, trailing })
    }

    /// Width and height in texels.
    pub(crate) fn size(&self) -> [usize; 2] {
        self.size
    }

    /// How texels are laid out in the bands.
    pub(crate) fn texel(&self) -> Texel {
        self.texel
    }

    /// A line about bytes after the picture's end, which are ignored; none if there are none.
    pub(crate) fn ignored(&self) -> Option<String> {
        let count = self.trailing;
        (count > 0).then(|| format!("{count} bytes after the picture's end are ignored"))
    }

    /// Gives `take` the bytes of band after band, with the number of the first row.
    pub(crate) fn bands(
        mut self,
        mut take: impl FnMut(usize, &[u8]) -> Result<(), String>,
    ) -> Result<(), String> {
        let [width, height] = self.size;
        let line = width * self.texel.bytes();
        let coded = match &self.palette {
            Some(palette) => (width * palette.bits).div_ceil(8),
            None => line,
        };
        // Interlaced rows arrive in no order: the picture is then one band.
        let interlaced = self.reader.info().interlaced;
        let rows = if interlaced { height } else { (BAND / width).clamp(1, height) };
        let mut codes = vec![0; rows * coded];
        let mut expanded = vec![0; if self.palette.is_some() { rows * line } else { 0 }];
        for first in (0..height).step_by(rows) {
            let rows = rows.min(height - first);
            let codes = &mut codes[..rows * coded];
            if interlaced {
                self.reader.next_frame(codes).map_err(broken)?;
            } else {
                for row in codes.chunks_exact_mut(coded) {
                    let read = self.reader.read_row(row).map_err(broken)?;
                    read.ok_or("not a readable PNG (it has too few rows)")?;
                }
            }
            match &self.palette {
                None => take(first, codes)?,
                Some(palette) => {
                    let expanded = &mut expanded[..rows * line];
                    let lines = expanded.chunks_exact_mut(line);
                    for (codes, out) in codes.chunks_exact(coded).zip(lines) {
                        palette.expand(codes, self.texel.channels, out)?;
                    }
                    take(first, expanded)?;
                }
            }
        }
        Ok(())
    }
}

impl Palette {
    fn of(info: &png::Info) -> Result<Self, String> {
        let colors = info.palette.as_deref().unwrap_or_default();
        if colors.is_empty() || !colors.chunks_exact(3).remainder().is_empty() {
            return Err("not a readable PNG (its palette is missing or malformed)".to_owned());
        }
        let transparency = info.trns.as_deref().unwrap_or_default();
        if transparency.len() > colors.len() / 3 {
            return Err("not a readable PNG (more transparencies than colors)".to_owned());
        }
        // Colors without a transparency of their own are opaque.
        let alphas = transparency.iter().copied().chain(std::iter::repeat(u8::MAX));
        let colors = colors.chunks_exact(3).zip(alphas);
        let colors = colors.map(|(rgb, alpha)| [rgb[0], rgb[1], rgb[2], alpha]).collect();
        Ok(Self { colors, bits: info.bit_depth as usize })
    }

    /// A row of packed indices as colors, with or without alpha.
    fn expand(&self, codes: &[u8], channels: usize, out: &mut [u8]) -> Result<(), String> {
        let mask = u8::MAX >> (8 - self.bits);
        for (k, out) in out.chunks_exact_mut(channels).enumerate() {
            // The leftmost texel is in the highest bits.
            let bit = k * self.bits;
            let index = codes[bit / 8] >> (8 - self.bits - bit % 8) & mask;
            let color = self.colors.get(usize::from(index)).ok_or_else(|| {
                let count = self.colors.len();
                format!("not a readable PNG (texels of color {index}, a palette of {count})")
            })?;
            out.copy_from_slice(&color[..channels]);
        }
        Ok(())
    }
}
