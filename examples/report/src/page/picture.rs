//! Pictures: radiance to a tone-mapped PNG in a data URL.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::camera::Size;

/// The tone curve of a scene's pictures, $1 - e^{-k x}$ in sRGB: highlights without a hard edge.
#[derive(Clone, Copy)]
pub(crate) struct Tone {
    exposure: f64,
    /// The radiance that shows as [`WHITE`], in multiples of the mean.
    pub(super) bright: f64,
}

/// How white the reference's 99th percentile is: one pixel in a hundred is brighter, and shows it.
pub(super) const WHITE: f64 = 0.8;

impl Tone {
    /// The curve for a reference picture.
    pub(crate) fn of(reference: &[f64]) -> Self {
        let mut sorted = reference.to_vec();
        sorted.sort_by(f64::total_cmp);
        let bright =
            sorted.get(sorted.len() * 99 / 100).copied().filter(|&x| x > 0.0).unwrap_or(1.0);
        Self { exposure: -(1.0 - WHITE).ln() / bright, bright }
    }

    /// Radiance to an sRGB byte.
    fn byte(self, x: f64) -> u8 {
        let linear = 1.0 - (-self.exposure * x.max(0.0)).exp();
        let encoded = if linear <= 0.003_130_8 {
            12.92 * linear
        } else {
            1.055 * linear.powf(1.0 / 2.4) - 0.055
        };
        // In 0 to 255: the cast only drops the fraction.
        #[allow(clippy::cast_sign_loss)]
        let byte = (255.0 * encoded + 0.5) as u8;
        byte
    }

    /// Radiances to sRGB bytes.
    pub(crate) fn gray(self, values: &[f64]) -> Vec<u8> {
        values.iter().map(|&x| self.byte(x)).collect()
    }

    /// A gray picture as `data:image/png;base64,...`.
    pub(super) fn data_url(self, size: Size, values: &[f64]) -> String {
        format!("data:image/png;base64,{}", STANDARD.encode(self.file(size, values)))
    }

    /// A gray picture as a PNG file.
    fn file(self, size: Size, values: &[f64]) -> Vec<u8> {
        encode(size.width, size.height, &self.gray(values))
    }

    /// The middles of pictures of one size side by side, with a white gap, as a PNG file: half
    /// their width and height, every pixel as two by two.
    pub(super) fn strip(self, size: Size, pictures: &[&[f64]]) -> Vec<u8> {
        let (width, height) = (size.width / 2, size.height / 2);
        let mut gray = Vec::new();
        for row in 0..2 * height {
            for (n, picture) in pictures.iter().enumerate() {
                if n > 0 {
                    gray.extend([255; GAP]);
                }
                gray.extend(middle(size, picture, row / 2).iter().flat_map(|&x| [self.byte(x); 2]));
            }
        }
        encode(pictures.len() * (2 * width + GAP) - GAP, 2 * height, &gray)
    }

    /// How far the middles of two pictures differ as they are shown, mean over pixels, in steps
    /// of 255.
    pub(super) fn difference(self, size: Size, a: &[f64], b: &[f64]) -> f64 {
        let rows = (0..size.height / 2).map(|row| {
            let pixels = middle(size, a, row).iter().zip(middle(size, b, row));
            pixels.map(|(&a, &b)| f64::from(self.byte(a).abs_diff(self.byte(b)))).sum::<f64>()
        });
        rows.sum::<f64>() / (size.width / 2 * (size.height / 2)) as f64
    }
}

/// A picture of numbers from 0, black, to 1, white, without a tone curve, as
/// `data:image/png;base64,...`.
pub(super) fn linear(size: Size, values: &[f64]) -> String {
    // In 0 to 255: the cast only drops the fraction.
    #[allow(clippy::cast_sign_loss)]
    let gray: Vec<u8> = values.iter().map(|x| (255.0 * x.clamp(0.0, 1.0) + 0.5) as u8).collect();
    format!("data:image/png;base64,{}", STANDARD.encode(encode(size.width, size.height, &gray)))
}

/// A picture in colors as `data:image/png;base64,...`.
pub(super) fn colored(size: Size, colors: &[[u8; 3]]) -> String {
    let file = encoded(size.width, size.height, png::ColorType::Rgb, colors.as_flattened());
    format!("data:image/png;base64,{}", STANDARD.encode(file))
}

/// A row of the middle of a picture, half as wide and high.
fn middle(size: Size, picture: &[f64], row: usize) -> &[f64] {
    &picture[(size.height / 4 + row) * size.width + size.width / 4..][..size.width / 2]
}

/// White pixels between the pictures of a strip.
const GAP: usize = 8;

/// An 8-bit gray PNG file.
fn encode(width: usize, height: usize, gray: &[u8]) -> Vec<u8> {
    encoded(width, height, png::ColorType::Grayscale, gray)
}

/// An 8-bit PNG file.
fn encoded(width: usize, height: usize, color: png::ColorType, bytes: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, extent(width), extent(height));
    encoder.set_color(color);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    // Into memory, with as many bytes as the header says: nothing here can fail.
    let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(bytes));
    debug_assert!(written.is_ok());
    file
}

/// A side of a picture; at most 4096 by the command line's check.
fn extent(side: usize) -> u32 {
    u32::try_from(side).unwrap_or(u32::MAX)
}

#[cfg(test)]
mod tests {
    use super::Tone;
    use crate::camera::Size;

    #[test]
    fn tones_run_from_black_to_white_by_the_reference() {
        let reference: Vec<f64> = (0..1000).map(f64::from).collect();
        let tone = Tone::of(&reference);
        assert_eq!(tone.bright, 990.0);
        assert_eq!([0.0, -1.0, 1e9].map(|x| tone.byte(x)), [0, 0, 255]);
        // 0.8 in linear light is 231 in sRGB.
        assert_eq!(tone.byte(990.0), 231);
        assert!(Tone::of(&[0.0; 4]).byte(1.0) > 200);
    }

    #[test]
    fn a_strip_is_the_middle_of_its_pictures_and_the_gaps() {
        let size = Size { width: 8, height: 4 };
        // White in the middle of the second, black all around.
        let (dark, mut bright) = ([0.0; 32], [0.0; 32]);
        for row in [1, 2] {
            bright[row * 8 + 2..row * 8 + 6].fill(1e9);
        }
        assert_eq!(Tone::of(&[1.0]).difference(size, &dark, &bright), 255.0);
        let file = Tone::of(&[1.0]).strip(size, &[&dark, &bright]);
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        let row = [[0; 8].as_slice(), &[255; super::GAP], &[255; 8]].concat();
        assert_eq!(pixels, row.repeat(4));
    }

    #[test]
    fn the_png_decodes_to_what_went_in() {
        use base64::Engine;
        let values = [0.0, 0.1, 1.0, 9.0, 0.0, 0.5];
        let tone = Tone::of(&values);
        let url = tone.data_url(Size { width: 3, height: 2 }, &values);
        let encoded = url.strip_prefix("data:image/png;base64,").unwrap();
        let file = base64::engine::general_purpose::STANDARD.decode(encoded).unwrap();
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
        let mut gray = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut gray).unwrap();
        assert_eq!(gray, values.map(|x| tone.byte(x)));
    }
}
