//! A picture's texels as slopes, band by band on several threads.

use super::options::Relief;
use super::picture::{Picture, Texel};
use super::progress::Progress;
use super::work::dealt;
use lobe::material::lean::{Clipped, HeightField, NormalTexel, SlopeCap};
use std::time::{Duration, Instant};

/// The slopes of a map, and how long the two steps took.
pub(crate) struct Slopes {
    pub(crate) rows: Vec<[f32; 2]>,
    pub(crate) clipped: Clipped,
    pub(crate) decoding: Duration,
    pub(crate) converting: Duration,
}

/// How a texel is a normal.
#[derive(Clone, Copy)]
pub(crate) struct Normals {
    pub(crate) cap: SlopeCap<f32>,
    /// Two channels: z is what is left.
    pub(crate) pairs: bool,
    /// y counts down.
    pub(crate) flip: bool,
}

/// What a thread found in its rows.
#[derive(Clone, Copy, Default)]
struct Found {
    clipped: Clipped,
    /// Normals that point up.
    up: usize,
}

impl Found {
    fn plus(self, other: Self) -> Self {
        Self { clipped: self.clipped.plus(other.clipped), up: self.up + other.up }
    }
}

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
        let convert = match (texel.wide, normals.pairs) {
            (false, false) => convert::<u8, false>,
            (false, true) => convert::<u8, true>,
            (true, false) => convert::<u16, false>,
            (true, true) => convert::<u16, true>,
        };
        let start = Instant::now();
        let mut rows = vec![[0.0; 2]; width * height];
        let mut converting = start.elapsed();
        let mut found = Found::default();
        let decoding = picture.bands(|first, bytes| {
            let start = Instant::now();
            let texels = bytes.len() / texel.bytes();
            let band = dealt(&mut rows[first * width..][..texels], 1, threads, |place, out| {
                convert(&bytes[place * texel.bytes()..], texel, normals, out)
            });
            found = band.into_iter().fold(found, Found::plus);
            converting += start.elapsed();
            progress.by(texels as u64)
        })?;
        // A picture in which half of the texels point down is something else.
        if 2 * found.up <= rows.len() {
            return Err("not a tangent-space normal map (most texels do not point up)".to_owned());
        }
        Ok(Self { rows, clipped: found.clipped, decoding, converting })
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
        let mut heights = Vec::with_capacity(size[0] * size[1]);
        let mut converting = Duration::ZERO;
        let decoding = picture.bands(|_, bytes| {
            let start = Instant::now();
            let texels = bytes.chunks_exact(texel.bytes());
            let count = texels.len();
            if texel.wide {
                heights.extend(texels.map(|texel| u16::at(texel, 0).share()));
            } else {
                heights.extend(texels.map(|texel| u8::at(texel, 0).share()));
            }
            converting += start.elapsed();
            progress.by(count as u64)
        })?;
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
            .try_fold(Clipped::default(), |sum, band| band.map(|clipped| sum.plus(clipped)))?;
        converting += start.elapsed();
        Ok(Self { rows, clipped, decoding, converting })
    }
}

/// A number of a texel.
trait Channel: Copy + Into<i64> + Into<f64> {
    const LARGEST: Self;
    /// The `k`-th of a texel's bytes.
    fn at(texel: &[u8], k: usize) -> Self;
    /// The number of the opposite sign.
    fn opposite(self) -> Self;

    /// Of the largest one, in [0, 1].
    fn share(self) -> f32 {
        let (value, largest): (f64, f64) = (self.into(), Self::LARGEST.into());
        (value / largest) as f32
    }
}

impl Channel for u8 {
    const LARGEST: Self = Self::MAX;
    #[inline]
    fn at(texel: &[u8], k: usize) -> Self {
        texel[k]
    }
    #[inline]
    fn opposite(self) -> Self {
        Self::MAX - self
    }
}

impl Channel for u16 {
    const LARGEST: Self = Self::MAX;
    #[inline]
    fn at(texel: &[u8], k: usize) -> Self {
        Self::from_be_bytes([texel[2 * k], texel[2 * k + 1]])
    }
    #[inline]
    fn opposite(self) -> Self {
        Self::MAX - self
    }
}

/// The slopes of as many texels as `out` holds.
fn convert<C: Channel, const PAIRS: bool>(
    bytes: &[u8],
    texel: Texel,
    normals: Normals,
    out: &mut [[f32; 2]],
) -> Found
where
    [C; 2]: NormalTexel,
    [C; 3]: NormalTexel,
{
    let (mut touched, mut up) = (0, 0);
    let largest: i64 = C::LARGEST.into();
    let signed = |channel: C| 2 * Into::<i64>::into(channel) - largest;
    for (out, texel) in out.iter_mut().zip(bytes.chunks_exact(texel.bytes())) {
        let (x, y) = (C::at(texel, 0), C::at(texel, 1));
        let y = if normals.flip { y.opposite() } else { y };
        let (slope, clipped, points_up);
        if PAIRS {
            (slope, clipped) = normals.cap.slope([x, y]);
            points_up = signed(x).pow(2) + signed(y).pow(2) < largest.pow(2);
        } else {
            let z = C::at(texel, 2);
            (slope, clipped) = normals.cap.slope([x, y, z]);
            points_up = signed(z) > 0;
        }
        *out = slope;
        touched += usize::from(clipped);
        up += usize::from(points_up);
    }
    Found { clipped: Clipped { texels: touched, of: out.len() }, up }
}
