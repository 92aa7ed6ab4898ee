//! A picture: tone mapping, PNG, and sheets of several.

use super::folder::Folder;
use glam::Vec3;
use png::{BitDepth, ColorType, Encoder, EncodingError};
use std::io::{BufWriter, Write};

/// Pixels of 8 bits by rows from the top, in sRGB.
pub(crate) struct Picture {
    pub(crate) size: [usize; 2],
    pub(crate) pixels: Vec<[u8; 3]>,
}

/// Radiance that becomes white.
const WHITE: f32 = 5.0;

/// The color of a radiance at a pixel: Reinhard's curve with a white point (2002, Eq. 4), by
/// channel, and sRGB's.
///
/// A glint is brighter than white by orders of magnitude: the curve keeps the highlight below it
/// apart from it. Codes are dithered by the pixel's place, as smooth walls and skies have steps
/// otherwise (Jimenez 2014).
#[allow(clippy::cast_sign_loss, reason = "codes are not negative")]
pub(crate) fn tone(radiance: Vec3, [x, y]: [usize; 2]) -> [u8; 3] {
    let noise = (52.982_918 * (0.067_110_56 * x as f32 + 0.005_837_15 * y as f32).fract()).fract();
    radiance.to_array().map(|x| {
        let x = x.clamp(0.0, WHITE);
        let mapped = x * (1.0 + x / (WHITE * WHITE)) / (1.0 + x);
        let code = if mapped <= 0.003_130_8 {
            12.92 * mapped
        } else {
            1.055 * mapped.powf(1.0 / 2.4) - 0.055
        };
        (255.0 * code + noise) as u8
    })
}

impl Picture {
    /// Writes a PNG.
    pub(crate) fn write(&self, folder: &Folder, name: &str) -> Result<(), String> {
        let mut file = BufWriter::new(folder.create(name)?);
        self.encode(&mut file).map_err(|error| folder.refused(name, &error.into()))?;
        file.flush().map_err(|error| folder.refused(name, &error))
    }

    /// The PNG's bytes.
    fn encode(&self, file: impl Write) -> Result<(), EncodingError> {
        // Sides of a few thousand.
        let [width, height] = self.size.map(|n| n as u32);
        let mut encoder = Encoder::new(file, width, height);
        encoder.set_color(ColorType::Rgb);
        encoder.set_depth(BitDepth::Eight);
        let mut writer = encoder.write_header()?;
        writer.write_image_data(self.pixels.as_flattened())?;
        writer.finish()
    }

    /// The part of this size in its middle.
    pub(crate) fn middle(&self, size: [usize; 2]) -> Self {
        let [width, height] = [0, 1].map(|k| size[k].min(self.size[k]));
        let [left, top] = [(self.size[0] - width) / 2, (self.size[1] - height) / 2];
        let rows = self.pixels.chunks_exact(self.size[0]).skip(top).take(height);
        let pixels = rows.flat_map(|row| &row[left..][..width]).copied().collect();
        Self { size: [width, height], pixels }
    }

    /// Pictures of one size side by side, `columns` in a row, with a line between; dark where there
    /// is none.
    pub(crate) fn sheet(pictures: &[Self], columns: usize) -> Self {
        const LINE: usize = 2;
        let [width, height] = pictures.first().map_or([0, 0], |picture| picture.size);
        let rows = pictures.len().div_ceil(columns);
        let side = |count: usize, length: usize| (count * (length + LINE)).saturating_sub(LINE);
        let size = [side(columns, width), side(rows, height)];
        let mut pixels = vec![[0; 3]; size[0] * size[1]];
        for (k, picture) in pictures.iter().enumerate() {
            let [left, top] = [(k % columns) * (width + LINE), (k / columns) * (height + LINE)];
            for (y, row) in picture.pixels.chunks_exact(width).enumerate() {
                pixels[(top + y) * size[0] + left..][..width].copy_from_slice(row);
            }
        }
        Self { size, pixels }
    }
}
