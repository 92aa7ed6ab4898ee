//! Normal maps: PNG in, unit normals, bilinear and repeating.

use std::io::Cursor;

use lobe::slope::direction::normalize;
use png::{BitDepth, ColorType, Decoder, Limits};

use crate::level::{Level, mix};
use crate::scalar::Scalar;
use crate::vector::{Vector, along, dot, scaled, sub, tangential};

/// Unit normals of a tangent-space normal map, +y up as stored, rows from the top.
pub(crate) struct Texture {
    level: Level<3>,
}

/// No side longer than this: 16 K maps are the largest that engines ship.
const LONGEST_SIDE: u32 = 16_384;
/// Bytes the decoder may take, for files that claim more than they hold.
const DECODER_BYTES: usize = 2 << 30;

impl Texture {
    /// Decodes RGB or RGBA of 8 or 16 bits; alpha is ignored.
    ///
    /// Texels are `2 v / max - 1`, then brought to unit length: compressed maps hold unequal lengths.
    pub(crate) fn decode(file: &[u8]) -> Result<Self, String> {
        if file.is_empty() {
            return Err("the file is empty".into());
        }
        let broken = |error: png::DecodingError| format!("not a readable PNG ({error})");
        let limits = Limits { bytes: DECODER_BYTES };
        let decoder = Decoder::new_with_limits(Cursor::new(file), limits);
        let mut reader = decoder.read_info().map_err(broken)?;
        let info = reader.info();
        let (width, height) = (info.width, info.height);
        if width == 0 || height == 0 {
            return Err("the picture has no pixels".into());
        }
        if width > LONGEST_SIDE || height > LONGEST_SIDE {
            return Err(format!("{width} x {height} is too large (at most {LONGEST_SIDE} a side)"));
        }
        let channels = match info.color_type {
            ColorType::Rgb => 3,
            ColorType::Rgba => 4,
            ColorType::Grayscale | ColorType::GrayscaleAlpha => return Err(not_rgb("greyscale")),
            ColorType::Indexed => return Err(not_rgb("a palette picture")),
        };
        let wide = info.bit_depth == BitDepth::Sixteen;
        let bytes = reader.output_buffer_size().ok_or("the picture is too large")?;
        let mut data = vec![0; bytes];
        reader.next_frame(&mut data).map_err(broken)?;

        let normals: Vec<_> = if wide {
            data.chunks_exact(2 * channels)
                .map(|texel| {
                    unit([0, 2, 4].map(|k| u16::from_be_bytes([texel[k], texel[k + 1]])), 65535.0)
                })
                .collect()
        } else {
            data.chunks_exact(channels)
                .map(|texel| unit([texel[0], texel[1], texel[2]].map(u16::from), 255.0))
                .collect()
        };
        // Blue is z: a picture in which half of the texels point down is something else.
        let up = normals.iter().filter(|normal| normal[2] > 0.0).count();
        if 2 * up <= normals.len() {
            return Err("not a tangent-space normal map (most texels do not point up)".into());
        }
        Ok(Self { level: Level::new([width as usize, height as usize], normals) })
    }

    /// The normal at texel coordinates (x to the right, y down), before normalisation.
    #[inline]
    pub(crate) fn lookup<R: Scalar>(&self, x: R, y: R) -> Vector<R> {
        self.level.between([x, y])
    }

    /// Derivative of the normalised [`Texture::lookup`] along a step, in texels. At the borders of texels,
    /// where there are two, one of them.
    #[inline]
    pub(crate) fn turn<R: Scalar>(&self, at: [R; 2], step: [R; 2]) -> Vector<R> {
        let ([above, below], [fx, fy]) = self.level.corners(at);
        let (upper, lower) = (mix(above[0], above[1], fx), mix(below[0], below[1], fx));
        let across = mix(sub(above[1], above[0]), sub(below[1], below[0]), fy);
        let change = along(scaled(step[0], across), step[1], sub(lower, upper));
        let normal = mix(upper, lower, fy);
        let inverse = R::ONE / dot(normal, normal).sqrt();
        scaled(inverse, tangential(change, scaled(inverse, normal)))
    }

    /// Unit normals, rows from the top.
    pub(crate) fn normals(&self) -> &[[f32; 3]] {
        self.level.texels()
    }

    /// Width and height in texels.
    pub(crate) fn size(&self) -> [usize; 2] {
        self.level.size()
    }
}

fn not_rgb(kind: &str) -> String {
    format!("is {kind}; a normal map needs RGB or RGBA")
}

/// A texel's normal at unit length, by way of f64: 16 bits keep all they have.
fn unit(texel: [u16; 3], max: f64) -> [f32; 3] {
    normalize(texel.map(|v| 2.0 * f64::from(v) / max - 1.0)).map(|c| c as f32)
}

#[cfg(test)]
mod tests {
    use super::Texture;
    use png::{BitDepth, ColorType};

    fn encode(width: u32, height: u32, color: ColorType, depth: BitDepth, data: &[u8]) -> Vec<u8> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, width, height);
        encoder.set_color(color);
        encoder.set_depth(depth);
        if color == ColorType::Indexed {
            encoder.set_palette(vec![128, 128, 255]);
        }
        encoder.write_header().unwrap().write_image_data(data).unwrap();
        file
    }

    fn refusal(file: &[u8]) -> String {
        Texture::decode(file).err().expect("must be refused")
    }

    #[test]
    fn eight_bits_sixteen_bits_and_alpha_decode_to_the_same_unit_normals() {
        let rgb = encode(1, 1, ColorType::Rgb, BitDepth::Eight, &[255, 128, 204]);
        let rgba = encode(1, 1, ColorType::Rgba, BitDepth::Eight, &[255, 128, 204, 7]);
        let wide: Vec<u8> = [255_u8, 128, 204].iter().flat_map(|&b| [b, b]).collect();
        let wide = encode(1, 1, ColorType::Rgb, BitDepth::Sixteen, &wide);
        let [a, b, c] = [rgb, rgba, wide].map(|file| Texture::decode(&file).unwrap().normals()[0]);
        assert_eq!(a, b);
        assert_eq!(a, c); // 257 v / 65535 = v / 255
        assert!((a[0] * a[0] + a[1] * a[1] + a[2] * a[2] - 1.0).abs() < 1e-6);
        assert!((a[2] / a[0] - 0.6).abs() < 1e-6);
    }

    #[test]
    fn lookups_are_bilinear_and_repeat() {
        // 2 x 1 texels: +x tilted, -x tilted.
        let file = encode(2, 1, ColorType::Rgb, BitDepth::Eight, &[255, 127, 255, 0, 127, 255]);
        let texture = Texture::decode(&file).unwrap();
        let at = |x: f64| texture.lookup(x, 0.5)[0];
        let peak = at(0.5);
        assert!((peak - 0.5_f64.sqrt()).abs() < 1e-4);
        assert!((at(1.5) + peak).abs() < 1e-6);
        assert!(at(1.0).abs() < 1e-6 && at(0.0).abs() < 1e-6);
        assert!((at(0.75) - 0.5 * peak).abs() < 1e-6);
        for x in [-4.3, -1.0, 6.7] {
            assert!((at(x) - at(x + 2.0)).abs() < 1e-6);
        }
        assert!((texture.lookup(0.75_f32, -7.5)[0] - at(0.75) as f32).abs() < 1e-6);
    }

    #[test]
    fn refusals_say_what_is_wrong() {
        assert!(refusal(&[]).contains("empty"));
        assert!(refusal(b"GIF89a").contains("not a readable PNG"));
        let grey = encode(1, 1, ColorType::Grayscale, BitDepth::Eight, &[9]);
        assert!(refusal(&grey).contains("greyscale"));
        let palette = encode(1, 1, ColorType::Indexed, BitDepth::Eight, &[0]);
        assert!(refusal(&palette).contains("palette"));
        let noise: Vec<u8> = (0..300_u32).map(|k| (k * k * 31 % 251) as u8).collect();
        let whole = encode(10, 10, ColorType::Rgb, BitDepth::Eight, &noise);
        assert!(refusal(&whole[..whole.len() / 2]).contains("not a readable PNG"));
        let mut none = whole;
        none[16..20].fill(0); // the width in the header
        assert!(Texture::decode(&none).is_err());
    }
}
