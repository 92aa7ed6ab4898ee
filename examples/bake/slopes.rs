//! A picture's texels as slopes, band by band on several threads.

use super::channels::{ALPHA, Channels, place};
use super::options::Relief;
use super::picture::{Picture, Texel};
use super::progress::Progress;
use super::survey::{Channel, Survey};
use super::warnings::clear;
use super::work::dealt;
use lobe::material::lean::{ClippedTexels, HeightField, NormalTexel, SlopeCap};
use std::time::{Duration, Instant};

/// The slopes of a map, and how long the two steps took.
pub(crate) struct Slopes {
    pub(crate) rows: Vec<[f32; 2]>,
    /// What each texel counts, if not all count the same.
    pub(crate) weights: Option<Vec<f32>>,
    pub(crate) clipped: ClippedTexels,
    pub(crate) survey: Survey,
    pub(crate) decoding: Duration,
    pub(crate) converting: Duration,
}

/// How a texel is a normal.
#[derive(Clone, Copy)]
pub(crate) struct Normals {
    pub(crate) cap: SlopeCap<f32>,
    pub(crate) channels: Channels,
    /// y counts down.
    pub(crate) flip: bool,
    /// Alpha is how much of a texel counts.
    pub(crate) coverage: bool,
}

/// Who reads the heights that a user gave as normals.
const HEIGHTS: &str = "; --height SCALE --texel SIZE reads it as heights";

impl Slopes {
    /// Of a normal map.
    pub(crate) fn of_normals(
        picture: Picture,
        normals: Normals,
        threads: usize,
        progress: &Progress,
    ) -> Result<Self, String> {
        let [width, height] = picture.size();
        let texel = picture.texel();
        let places = normals.channels.places(texel)?;
        if normals.coverage && !texel.has_alpha() {
            return Err("has no alpha channel, which --coverage reads".to_owned());
        }
        let convert = match (texel.wide, normals.channels.roles().len()) {
            (false, 3) => convert::<u8, false>,
            (false, _) => convert::<u8, true>,
            (true, 3) => convert::<u16, false>,
            (true, _) => convert::<u16, true>,
        };
        let mut rows = vec![[0.0; 2]; width * height];
        let mut weights = normals.coverage.then(|| Vec::with_capacity(rows.len()));
        let mut survey = Survey::new(normals.channels, texel);
        let mut clipped = ClippedTexels::default();
        let (mut converting, whole) = (Duration::ZERO, Instant::now());
        picture.bands(|first, bytes| {
            let start = Instant::now();
            let texels = bytes.len() / texel.bytes();
            let found = dealt(&mut rows[first * width..][..texels], 1, threads, |place, out| {
                let bytes = &bytes[place * texel.bytes()..][..out.len() * texel.bytes()];
                let mut survey = Survey::new(normals.channels, texel);
                let surveyed = survey.add(bytes, texel, normals.coverage);
                surveyed.map(|()| (survey, convert(bytes, texel, places, normals, out)))
            });
            for found in found {
                let (part, found) = found?;
                survey.join(&part);
                clipped = clipped + found;
            }
            if let Some(weights) = &mut weights {
                let alpha = place(ALPHA, texel);
                let texels = bytes.chunks_exact(texel.bytes());
                if texel.wide {
                    weights.extend(texels.map(|texel| share(u16::at(texel, alpha))));
                } else {
                    weights.extend(texels.map(|texel| share(u8::at(texel, alpha))));
                }
            }
            converting += start.elapsed();
            progress.by(texels as u64)
        })?;
        if let Some(line) = survey.refusal(HEIGHTS) {
            return Err(match clear(&survey) {
                Some(clear) => format!("{line}; {clear}"),
                None => line,
            });
        }
        let decoding = whole.elapsed().saturating_sub(converting);
        Ok(Self { rows, weights, clipped, survey, decoding, converting })
    }

    /// Of a displacement map.
    pub(crate) fn of_heights(
        picture: Picture,
        relief: &Relief,
        cap: SlopeCap<f32>,
        threads: usize,
        progress: &Progress,
    ) -> Result<Self, String> {
        let size = picture.size();
        let texel = picture.texel();
        // Green, of which a gray that a lossy format has touched keeps the most.
        let [_, green, _] = Channels::RGB.places(texel)?;
        let mut survey = Survey::new(Channels::RGB, texel);
        let mut heights = Vec::with_capacity(size[0] * size[1]);
        let (mut converting, whole) = (Duration::ZERO, Instant::now());
        picture.bands(|_, bytes| {
            let start = Instant::now();
            survey.add(bytes, texel, false)?;
            let texels = bytes.chunks_exact(texel.bytes());
            let count = texels.len();
            if texel.wide {
                heights.extend(texels.map(|texel| share(u16::at(texel, green))));
            } else {
                heights.extend(texels.map(|texel| share(u8::at(texel, green))));
            }
            converting += start.elapsed();
            progress.by(count as u64)
        })?;
        if !survey.is_gray() {
            return Err("is a color picture; --height needs grayscale".to_owned());
        }
        let decoding = whole.elapsed().saturating_sub(converting);
        let start = Instant::now();
        let field =
            HeightField::new(size, &heights, relief.texel, relief.displacement, relief.border)
                .map_err(|error| error.to_string())?;
        let mut rows = vec![[0.0; 2]; heights.len()];
        let bands = dealt(&mut rows, size[0], threads, |place, out| {
            field.slopes(cap, place / size[0], out).map_err(|error| error.to_string())
        });
        let clipped = bands
            .into_iter()
            .try_fold(ClippedTexels::default(), |sum, band| band.map(|clipped| sum + clipped))?;
        converting += start.elapsed();
        Ok(Self { rows, weights: None, clipped, survey, decoding, converting })
    }
}

/// A number that has an opposite sign: normals' x and y around half of the largest number.
trait Signed: Channel {
    /// The number for the opposite sign.
    fn opposite(self) -> Self;
}

impl Signed for u8 {
    #[inline]
    fn opposite(self) -> Self {
        Self::MAX - self
    }
}

impl Signed for u16 {
    #[inline]
    fn opposite(self) -> Self {
        Self::MAX - self
    }
}

/// A number's part of the largest one, in [0, 1].
#[inline]
fn share<C: Channel>(value: C) -> f32 {
    let (value, largest): (f64, f64) = (value.into(), C::LARGEST.into());
    (value / largest) as f32
}

/// The slopes of as many texels as `out` holds.
fn convert<C: Signed, const PAIRS: bool>(
    bytes: &[u8],
    texel: Texel,
    [x, y, z]: [usize; 3],
    normals: Normals,
    out: &mut [[f32; 2]],
) -> ClippedTexels
where
    [C; 2]: NormalTexel,
    [C; 3]: NormalTexel,
{
    let mut clipped = ClippedTexels::default();
    let alpha = texel.has_alpha().then(|| place(ALPHA, texel));
    for (out, bytes) in out.iter_mut().zip(bytes.chunks_exact(texel.bytes())) {
        let at = |k: usize| C::at(bytes, k);
        let y = if normals.flip { at(y).opposite() } else { at(y) };
        let touched;
        (*out, touched) = if PAIRS {
            normals.cap.slope([at(x), y])
        } else {
            normals.cap.slope([at(x), y, at(z)])
        };
        let clear = alpha.is_some_and(|k| Into::<i64>::into(at(k)) == 0);
        let counts = !(clear && normals.coverage);
        clipped.texels += usize::from(touched && counts);
        clipped.of += usize::from(counts);
    }
    clipped
}
