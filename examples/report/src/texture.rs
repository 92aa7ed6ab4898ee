//! Normal maps: PNG in, unit normals, bilinear and repeating.

use lobe::material::lean::NormalTexel;
use lobe::slope::direction::normalize;

use crate::channels::Channels;
use crate::level::{Level, mix};
use crate::picture::Picture;
use crate::scalar::Scalar;
use crate::survey::{Channel, Survey};
use crate::vector::{Vector, along, dot, scaled, sub, tangential};

/// Unit normals of a tangent-space normal map, +y up as stored, rows from the top.
pub(crate) struct Texture {
    level: Level<3>,
}

/// A texture, and what its picture looks like: a line each, for the user to decide.
pub(crate) struct Decoded {
    pub(crate) texture: Texture,
    pub(crate) hints: Vec<String>,
}

impl Texture {
    /// Decodes a PNG's channels of x, y and z; of two, z is what is left to unit length.
    ///
    /// Texels are `2 v / max - 1`, then brought to unit length: compressed maps hold unequal
    /// lengths.
    pub(crate) fn decode(file: &[u8], channels: Channels) -> Result<Decoded, String> {
        let picture = Picture::of(file)?;
        let (size, texel) = (picture.size(), picture.texel());
        let places = channels.places(texel)?;
        let mut survey = Survey::new(channels, texel);
        let mut hints: Vec<_> = picture.ignored().into_iter().collect();
        let mut normals = Vec::with_capacity(size[0] * size[1]);
        picture.bands(|_, bytes| {
            survey.add(bytes, texel, false)?;
            normals.extend(bytes.chunks_exact(texel.bytes()).map(|texel_bytes| {
                let [x, y, z] = places.map(|k| {
                    if texel.wide {
                        signed(u16::at(texel_bytes, k))
                    } else {
                        signed(u8::at(texel_bytes, k))
                    }
                });
                unit(if channels.roles().len() == 3 { [x, y, z] } else { [x, y].normal() })
            }));
            Ok(())
        })?;
        if let Some(line) = survey.refusal("") {
            return Err(line);
        }
        hints.extend(survey.hints());
        let masked = if survey.is_masked() { survey.clear() } else { None };
        hints.extend(masked.map(|line| line + ", which count like all others"));
        Ok(Decoded { texture: Self { level: Level::new(size, normals) }, hints })
    }

    /// The normal at texel coordinates (x to the right, y down), before normalization.
    #[inline]
    pub(crate) fn lookup<R: Scalar>(&self, x: R, y: R) -> Vector<R> {
        self.level.between([x, y])
    }

    /// Derivative of the normalized [`Texture::lookup`] along a step, in texels. At the borders of
    /// texels, where there are two, one of them.
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

/// A channel's number in [-1, 1].
fn signed<C: Channel>(value: C) -> f64 {
    let (value, largest): (f64, f64) = (value.into(), C::LARGEST.into());
    2.0 * value / largest - 1.0
}

/// A texel's normal at unit length, by way of f64: 16 bits keep all they have.
fn unit(normal: [f64; 3]) -> [f32; 3] {
    normalize(normal).map(|c| c as f32)
}

#[cfg(test)]
mod tests {
    use super::{Decoded, Texture};
    use crate::channels::Channels;
    use png::{BitDepth, ColorType};

    fn encode(width: u32, height: u32, color: ColorType, depth: BitDepth, data: &[u8]) -> Vec<u8> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, width, height);
        encoder.set_color(color);
        encoder.set_depth(depth);
        if color == ColorType::Indexed {
            encoder.set_palette(vec![128, 128, 255, 255, 128, 204]);
        }
        encoder.write_header().unwrap().write_image_data(data).unwrap();
        file
    }

    fn decode(file: &[u8], channels: &str) -> Result<Decoded, String> {
        Texture::decode(file, channels.parse().unwrap())
    }

    fn texture(file: &[u8]) -> Texture {
        Texture::decode(file, Channels::RGB).unwrap().texture
    }

    fn refusal(file: &[u8]) -> String {
        Texture::decode(file, Channels::RGB).err().expect("must be refused")
    }

    #[test]
    fn eight_bits_sixteen_bits_and_alpha_decode_to_the_same_unit_normals() {
        let rgb = encode(1, 1, ColorType::Rgb, BitDepth::Eight, &[255, 128, 204]);
        let rgba = encode(1, 1, ColorType::Rgba, BitDepth::Eight, &[255, 128, 204, 7]);
        let wide: Vec<u8> = [255_u8, 128, 204].iter().flat_map(|&b| [b, b]).collect();
        let wide = encode(1, 1, ColorType::Rgb, BitDepth::Sixteen, &wide);
        let [a, b, c] = [rgb, rgba, wide].map(|file| texture(&file).normals()[0]);
        assert_eq!(a, b);
        assert_eq!(a, c); // 257 v / 65535 = v / 255
        assert!((a[0] * a[0] + a[1] * a[1] + a[2] * a[2] - 1.0).abs() < 1e-6);
        assert!((a[2] / a[0] - 0.6).abs() < 1e-6);
    }

    #[test]
    fn lookups_are_bilinear_and_repeat() {
        // 2 x 1 texels: +x tilted, -x tilted.
        let file = encode(2, 1, ColorType::Rgb, BitDepth::Eight, &[255, 127, 255, 0, 127, 255]);
        let texture = texture(&file);
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
    fn palettes_and_two_channels_are_normals_too() {
        // Two texels, of the second color and the first, in the highest bits.
        let palette = encode(2, 1, ColorType::Indexed, BitDepth::One, &[0b1000_0000]);
        let rgb = encode(2, 1, ColorType::Rgb, BitDepth::Eight, &[255, 128, 204, 128, 128, 255]);
        assert_eq!(texture(&palette).normals(), texture(&rgb).normals());
        // x = 0.6, y = 0 in alpha and green: z is what is left.
        let pair = encode(1, 1, ColorType::Rgba, BitDepth::Eight, &[255, 128, 255, 204]);
        let normal = decode(&pair, "ag").unwrap().texture.normals()[0];
        assert!((normal[0] - 0.6).abs() < 1e-6 && (normal[2] - 0.8).abs() < 1e-4, "{normal:?}");
        assert!(decode(&rgb, "ag").err().unwrap().contains("no alpha channel"));
    }

    #[test]
    fn hints_say_what_a_map_looks_like() {
        let pairs: Vec<u8> = (0..16_u8).flat_map(|k| [255, 90 + 5 * k, 255, 160 - 4 * k]).collect();
        let file = encode(4, 4, ColorType::Rgba, BitDepth::Eight, &pairs);
        let hints = decode(&file, "rgb").unwrap().hints;
        assert!(hints.len() == 1 && hints[0].contains("--channels ag"), "{hints:?}");
        assert!(decode(&file, "ag").unwrap().hints.is_empty());
        let hints = decode(&[&file[..], b"more"].concat(), "ag").unwrap().hints;
        assert!(hints.len() == 1 && hints[0].contains("4 bytes"), "{hints:?}");
    }

    #[test]
    fn refusals_say_what_is_wrong() {
        assert!(refusal(&[]).contains("empty"));
        assert!(refusal(b"GIF89a").contains("not a readable PNG"));
        let gray = encode(1, 1, ColorType::Grayscale, BitDepth::Eight, &[9]);
        assert!(refusal(&gray).contains("height (bump) map"));
        let gray = encode(1, 1, ColorType::Rgb, BitDepth::Eight, &[9; 3]);
        assert!(refusal(&gray).contains("height (bump) map"));
        // A single texel of 32 x 32 has a color.
        let mut bump = [200; 3 * 1024];
        bump[..3].copy_from_slice(&[255, 0, 0]);
        let bump = encode(32, 32, ColorType::Rgb, BitDepth::Eight, &bump);
        assert!(refusal(&bump).contains("in all but 1 of 1024 texels"));
        let noise: Vec<u8> = (0..300_u32).map(|k| (k * k * 31 % 251) as u8).collect();
        let whole = encode(10, 10, ColorType::Rgb, BitDepth::Eight, &noise);
        for missing in 1..whole.len() {
            assert!(refusal(&whole[..whole.len() - missing]).contains("not a readable PNG"));
        }
        // Any byte: of names, lengths, pixels and checksums.
        for k in 0..whole.len() {
            let mut damaged = whole.clone();
            damaged[k] ^= 1;
            refusal(&damaged);
        }
    }
}
