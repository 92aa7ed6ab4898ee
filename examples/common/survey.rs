//! What a picture's texels look like: a normal map in the channels that are read, or something
//! else.
//!
//! No texel is judged by itself: every message is about what holds for the whole picture.

use super::channels::{ALPHA, Channels, place};
use super::picture::Texel;

/// A number of a texel.
pub(crate) trait Channel: Copy + Into<i64> + Into<f64> {
    /// The number for 1.
    const LARGEST: Self;
    /// The `k`-th number of a texel's bytes.
    fn at(texel: &[u8], k: usize) -> Self;
}

impl Channel for u8 {
    const LARGEST: Self = Self::MAX;
    #[inline]
    fn at(texel: &[u8], k: usize) -> Self {
        texel[k]
    }
}

impl Channel for u16 {
    const LARGEST: Self = Self::MAX;
    #[inline]
    fn at(texel: &[u8], k: usize) -> Self {
        Self::from_be_bytes([texel[2 * k], texel[2 * k + 1]])
    }
}

/// Counts over a picture's texels.
#[derive(Clone, Debug)]
pub(crate) struct Survey {
    channels: Channels,
    has_alpha: bool,
    /// The number for 1.
    largest: i64,
    /// Texels that count: with coverage only the covered ones.
    counted: usize,
    /// All texels, and those of alpha 0.
    texels: usize,
    clear: usize,
    /// Texels of an alpha between 0 and 1.
    partly_clear: usize,
    /// The least and the largest number of red, green, blue and alpha.
    low: [i64; 4],
    high: [i64; 4],
    /// The largest difference between a texel's red, green and blue.
    color: i64,
    /// Texels in which that difference is more than a gray's.
    colored: usize,
    /// Texels whose z points up.
    up: usize,
    /// The sums of x and of y as they are read, of which the largest number is 1.
    sums: [i64; 2],
    /// The sum of the differences between squared lengths and 1, and texels in which it exceeds
    /// [`FAR_OFF`].
    off: f64,
    far_off: usize,
    /// Whether alpha is coverage, by the user's word.
    covered: bool,
    /// Whether no color is above its alpha, as in pictures premultiplied by it.
    below_alpha: bool,
}

/// How far colors may lie apart in a gray picture that a lossy format has touched, of 1.
const NEARLY_GRAY: f64 = 4.5 / 255.0;
/// A gray picture may have a colored texel, a mark or a fault, among so many.
const COLORED: usize = 1000;
/// Mean difference between a squared length and 1 above which channels are no unit vectors. Mip
/// levels and compressed maps stay far below.
const NO_UNIT_VECTORS: f64 = 0.1;
/// Difference above which a texel is no unit vector: of maps from lossy files one texel in eight
/// may be beyond it.
const FAR_OFF: f64 = 0.3;
/// Mean difference above which channels are no unit vectors, if blue is constant: codes of 8 bits
/// are off by 0.01 in such a map, by 0.016 where they were rounded down.
const NO_CONSTANT_Z: f64 = 0.02;

/// The least part of texels that a mask of islands leaves out.
const MASKED: f64 = 0.01;
/// The largest mean of x and of y, of 1, in channels that hold normals and not colors bent by a
/// curve: those of (188, 188, 255) and (55, 55, 255) are 0.47 and -0.57.
const TILTED: f64 = 0.3;
/// The largest alpha of a texel by which a picture is taken for premultiplied: near 1 colors are
/// below it by chance.
const THIN: f64 = 0.85;

impl Survey {
    /// A survey that has counted no texel yet.
    pub(crate) fn new(channels: Channels, texel: Texel) -> Self {
        Self {
            channels,
            has_alpha: texel.has_alpha(),
            largest: if texel.wide { u16::MAX.into() } else { u8::MAX.into() },
            counted: 0,
            texels: 0,
            clear: 0,
            partly_clear: 0,
            low: [i64::MAX; 4],
            high: [i64::MIN; 4],
            color: 0,
            colored: 0,
            up: 0,
            sums: [0; 2],
            off: 0.0,
            far_off: 0,
            covered: false,
            below_alpha: true,
        }
    }

    /// Adds a band of texels; `covered` leaves out those of alpha 0.
    pub(crate) fn add(&mut self, bytes: &[u8], texel: Texel, covered: bool) -> Result<(), String> {
        let mut band = Self::new(self.channels, texel);
        if texel.wide {
            band.count::<u16>(bytes, texel, covered)?;
        } else {
            band.count::<u8>(bytes, texel, covered)?;
        }
        self.join(&band);
        Ok(())
    }

    fn count<C: Channel>(
        &mut self,
        bytes: &[u8],
        texel: Texel,
        covered: bool,
    ) -> Result<(), String> {
        let places = self.channels.places(texel)?;
        self.covered = covered;
        let three = self.channels.roles().len() == 3;
        let roles = [0, 1, 2].map(|role| place(role, texel));
        let largest: i64 = C::LARGEST.into();
        // A picture without alpha is opaque.
        let alpha = self.has_alpha.then(|| place(ALPHA, texel));
        let nearly = (NEARLY_GRAY * largest as f64) as i64;
        let far = (FAR_OFF * (largest * largest) as f64) as i64;
        let (mut low, mut high) = (self.low, self.high);
        let mut off = 0_i64;
        for texel in bytes.chunks_exact(texel.bytes()) {
            let [r, g, b] = roles.map(|k| Into::<i64>::into(C::at(texel, k)));
            let alpha = alpha.map_or(largest, |k| C::at(texel, k).into());
            self.texels += 1;
            self.clear += usize::from(alpha == 0);
            self.partly_clear += usize::from(alpha > 0 && alpha < largest);
            let most = r.max(g).max(b);
            self.below_alpha &= most <= alpha;
            if covered && alpha == 0 {
                continue;
            }
            self.counted += 1;
            for (k, value) in [r, g, b, alpha].into_iter().enumerate() {
                low[k] = low[k].min(value);
                high[k] = high[k].max(value);
            }
            let color = most - r.min(g).min(b);
            self.color = self.color.max(color);
            self.colored += usize::from(color > nearly);
            let signed = |k: usize| 2 * Into::<i64>::into(C::at(texel, k)) - largest;
            let [x, y, z] = places.map(signed);
            self.sums = [self.sums[0] + x, self.sums[1] + y];
            let rest = largest * largest - x * x - y * y;
            if three {
                self.up += usize::from(z > 0);
                let difference = (rest - z * z).abs();
                off += difference;
                self.far_off += usize::from(difference > far);
            } else {
                self.up += usize::from(rest > 0);
            }
        }
        (self.low, self.high) = (low, high);
        self.off += off as f64 / (largest * largest) as f64;
        Ok(())
    }

    /// Takes the counts of another band of the picture in.
    pub(crate) fn join(&mut self, other: &Self) {
        self.counted += other.counted;
        self.texels += other.texels;
        self.clear += other.clear;
        self.partly_clear += other.partly_clear;
        for k in 0..4 {
            self.low[k] = self.low[k].min(other.low[k]);
            self.high[k] = self.high[k].max(other.high[k]);
        }
        self.color = self.color.max(other.color);
        self.colored += other.colored;
        self.up += other.up;
        self.sums = [0, 1].map(|k| self.sums[k] + other.sums[k]);
        self.off += other.off;
        self.far_off += other.far_off;
        self.covered |= other.covered;
        self.below_alpha &= other.below_alpha;
    }

    /// Whether red, green, blue or alpha, 0 to 3, is not one number everywhere.
    fn varies(&self, role: usize) -> bool {
        self.high[role] > self.low[role]
    }

    /// Whether red, green and blue are equal, or as good as equal, in all texels but one of a
    /// thousand.
    pub(crate) fn is_gray(&self) -> bool {
        COLORED * self.colored <= self.counted
    }

    /// How many texels of alpha 0 count like all others, if any do.
    pub(crate) fn clear(&self) -> Option<String> {
        // An alpha of 0 everywhere masks nothing.
        let ignored =
            (1..self.texels).contains(&self.clear) && !self.covered && !self.channels.use_alpha();
        let percent = 100.0 * self.clear as f64 / self.texels as f64;
        ignored.then(|| format!("alpha is 0 in {percent:.1} % of all texels"))
    }

    /// Whether alpha looks like a mask of islands: 0 in many texels, and between 0 and 1 in fewer.
    pub(crate) fn is_masked(&self) -> bool {
        self.clear as f64 > MASKED * self.texels as f64 && self.partly_clear < self.clear
    }

    /// Why the texels are no normals, if they are none; `heights` says who reads heights.
    pub(crate) fn refusal(&self, heights: &str) -> Option<String> {
        if self.counted == 0 {
            return Some("alpha is 0 in every texel".to_owned());
        }
        if self.is_gray() && !self.channels.use_alpha() {
            let equal = if self.color == 0 { "equal" } else { "nearly equal" };
            let texels = match self.colored {
                0 => "in every texel".to_owned(),
                colored => format!("in all but {colored} of {} texels", self.counted),
            };
            let mut line = format!(
                "looks like a height (bump) map, not a normal map: red, green and blue are \
                    {equal} {texels}{heights}"
            );
            if self.varies(ALPHA) {
                line +=
                    "; --channels ag reads x from alpha and y from green, ga the other way round";
            }
            return Some(line);
        }
        if 2 * self.up > self.counted {
            return None;
        }
        let line = "not a tangent-space normal map (most texels do not point up)";
        Some(self.layout().map_or(line.to_owned(), |layout| format!("{line}; it {layout}")))
    }

    /// What else the texels look like: for the user to decide.
    pub(crate) fn hints(&self) -> Vec<String> {
        let mut hints: Vec<_> = self.layout().map(str::to_owned).into_iter().collect();
        let thin = self.partly_clear > 0 && self.low[ALPHA] as f64 <= THIN * self.largest as f64;
        let straight = !self.below_alpha || !thin || self.channels.use_alpha();
        if hints.is_empty() && self.has_alpha && !straight {
            hints.push(
                "looks premultiplied by alpha (no color is above its alpha), which bends normals: \
                 save it with straight alpha"
                    .to_owned(),
            );
        }
        hints
    }

    /// The layout of two channels that the texels look like, if it is not the one that is read.
    ///
    /// Red, green and blue of unit length are normals, whatever alpha holds: nearly flat maps and
    /// roofs have a constant blue, too. Of other channels, one read as x or y that is at an end
    /// everywhere is none, and another one was meant.
    fn layout(&self) -> Option<&'static str> {
        const AG: &str = "looks like two channels in alpha and green: --channels ag (x in alpha: \
            DXT5nm) or ga reads them";
        const RA: &str = "looks like two channels in red and alpha: --channels ra or ar reads them";
        const RG: &str = "looks like x in red and y in green (BC5): --channels rg reads it so";
        const ANY: &str = "looks like two channels without z: --channels rg reads x and y from \
            red and green, \
                           ag from alpha and green";
        const PACKED: &str = "has red, green and blue that are no unit vectors: if blue is not z, \
            --channels rg reads x and y alone";
        const PACKED_WITH_ALPHA: &str = "has red, green and blue that are no unit vectors: if \
            blue is not z, --channels rg reads x \
                                         and y from red and green, ag from alpha and green";
        let [r, g, b, a] = [0, 1, 2, ALPHA].map(|role| self.varies(role));
        let a = a && !self.covered;
        if self.channels != Channels::RGB {
            // A pair of which one is at an end everywhere, beside another that varies.
            let at_an_end = self
                .channels
                .roles()
                .iter()
                .take(2)
                .any(|&role| !self.varies(role) && [0, self.largest].contains(&self.low[role]));
            return match (at_an_end, r, g, a) {
                (true, false, true, true) => Some(AG),
                (true, true, false, true) => Some(RA),
                (true, true, true, false) => Some(RG),
                _ => None,
            };
        }
        let mean = self.off / self.counted as f64;
        let down = 2 * self.high[2] <= self.largest;
        let off = down || mean > NO_UNIT_VECTORS;
        let slightly_off = off || !b && mean > NO_CONSTANT_Z;
        // Colors that a curve has bent are no unit vectors either, and have other remedies.
        let bent = self.sums.iter().any(|&sum| {
            sum.unsigned_abs() as f64 > TILTED * (self.largest as f64) * self.counted as f64
        });
        // Texels outside of islands hold anything.
        let masked = self.is_masked() && !self.covered;
        match (r, g, b, a) {
            (true, true, false, _) if slightly_off && !bent => Some(if a { ANY } else { RG }),
            (true, true, true, _) if 2 * self.far_off > self.counted && !bent && !masked => {
                Some(if a { PACKED_WITH_ALPHA } else { PACKED })
            }
            (false, true, _, true) if slightly_off => Some(AG),
            (true, false, _, true) if slightly_off => Some(RA),
            _ => None,
        }
    }
}
