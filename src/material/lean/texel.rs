//! From a normal map's texels to slopes, with a cap that is a value and a count of what it touched.
//!
//! Layer 4. A slope explodes as the normal falls to the horizon: in 8 bits the lowest but one has
//! slope 255, and its square outweighs a thousand others. So there is a cap, the caller names it,
//! and learns what it cost.

use crate::error::{Error, same_length};
use crate::scalar::Real;
use crate::slope::direction::from_disk;
use core::ops::Add;

/// A texel that stands for a normal, of any length.
///
/// Integers are unsigned normalized, $2 v / \mathrm{max} - 1$, as glTF and hardware have it. Pairs
/// (BC5 and its kind) have no z: it is what is left to unit length, $\sqrt{\max(0, 1 - x^2 -
/// y^2)}$. Triples may have any length: slopes are quotients, so the unequal lengths of compressed
/// maps change nothing. Of four the last, alpha, is ignored.
pub trait NormalTexel: Copy {
    /// The normal, not normalized.
    fn normal<R: Real>(self) -> [R; 3];
}

macro_rules! unsigned_normalized {
    ($($int:ty),*) => {$(
        impl NormalTexel for [$int; 3] {
            #[inline]
            fn normal<R: Real>(self) -> [R; 3] {
                // As long as the largest code: whole numbers, exact, and no division.
                self.map(|v| R::lit(2.0 * f64::from(v) - f64::from(<$int>::MAX)))
            }
        }
        impl NormalTexel for [$int; 2] {
            #[inline]
            fn normal<R: Real>(self) -> [R; 3] {
                let most = i64::from(<$int>::MAX);
                let [x, y] = self.map(|v| 2 * i64::from(v) - most);
                // Below 2^33: exact.
                let rest = (most * most - x * x - y * y).max(0);
                [R::lit(x as f64), R::lit(y as f64), R::lit(Real::sqrt(rest as f64))]
            }
        }
        with_alpha!($int);
    )*};
}

macro_rules! with_alpha {
    ($t:ty) => {
        impl NormalTexel for [$t; 4] {
            #[inline]
            fn normal<R: Real>(self) -> [R; 3] {
                let [x, y, z, _] = self;
                [x, y, z].normal()
            }
        }
    };
}
unsigned_normalized!(u8, u16);

macro_rules! float {
    ($($t:ty),*) => {$(
        impl NormalTexel for [$t; 3] {
            #[inline]
            fn normal<R: Real>(self) -> [R; 3] {
                self.map(|x| R::lit(f64::from(x)))
            }
        }
        impl NormalTexel for [$t; 2] {
            #[inline]
            fn normal<R: Real>(self) -> [R; 3] {
                from_disk(self.map(|x| R::lit(f64::from(x))))
            }
        }
        with_alpha!($t);
    )*};
}
float!(f32, f64);

/// The steepest slope that a map may have: longer ones are shortened to it, their direction stays.
///
/// 10 to 25 suit real maps (84 to 88 degrees). Without one, texels at the horizon would be all that
/// a moment knows.
///
/// ```
/// use lobe::material::lean::SlopeCap;
/// let cap = SlopeCap::new(10.0_f64)?;
/// // x = 0.6, z = 0.8 at length 1/2.
/// assert_eq!(cap.slope([0.3, 0.0, 0.4]), ([-0.75, 0.0], false));
/// assert_eq!(cap.slope([0.3, 0.0, 0.0]), ([-10.0, 0.0], true));
/// // Two channels: the third is what is left.
/// assert!(cap.slope([255_u8, 128]).1);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlopeCap<R> {
    steepest: R,
}

/// How many of how many texels a cap touched.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct ClippedTexels {
    /// Texels that the cap shortened, or that had no direction.
    pub texels: usize,
    /// All texels.
    pub of: usize,
}

impl ClippedTexels {
    /// Their share, in \[0, 1\]; 0 of nothing.
    ///
    /// ```
    /// use lobe::material::lean::ClippedTexels;
    /// assert_eq!(ClippedTexels { texels: 1, of: 4 }.fraction(), 0.25);
    /// ```
    pub fn fraction(&self) -> f64 {
        if self.of == 0 { 0.0 } else { self.texels as f64 / self.of as f64 }
    }
}

impl Add for ClippedTexels {
    type Output = Self;

    /// Both together, as of bands of one map.
    ///
    /// ```
    /// use lobe::material::lean::ClippedTexels;
    /// let band = ClippedTexels { texels: 1, of: 4 };
    /// assert_eq!(band + ClippedTexels::default(), band);
    /// ```
    fn add(self, other: Self) -> Self {
        Self { texels: self.texels + other.texels, of: self.of + other.of }
    }
}

impl<R: Real> SlopeCap<R> {
    /// The cap, a slope's length.
    ///
    /// # Errors
    /// [`Error::Cap`] unless it lies in $(0, 10^9]$.
    pub fn new(steepest: R) -> Result<Self, Error> {
        if steepest > R::ZERO && steepest <= R::LARGEST {
            Ok(Self { steepest })
        } else {
            Err(Error::Cap(steepest.into()))
        }
    }

    /// The cap's slope.
    pub const fn steepest(&self) -> R {
        self.steepest
    }

    /// A texel's slope $(-m_x/m_z, -m_y/m_z)$, and whether the cap touched it.
    ///
    /// A normal at or below the horizon has the cap's length, towards where it points; one without
    /// a direction (0, straight down, infinite, NaN) is flat, and counts as touched.
    #[inline]
    pub fn slope(&self, texel: impl NormalTexel) -> ([R; 2], bool) {
        let [x, y, z] = texel.normal::<R>();
        // Signs turned before the quotient: a flat texel has slope +0.
        self.within([R::ZERO - x, R::ZERO - y], z)
    }

    /// A slope of a map of slopes, and whether the cap touched it.
    ///
    /// ```
    /// let cap = lobe::material::lean::SlopeCap::new(5.0_f32)?;
    /// assert_eq!(cap.limited([6.0, 8.0]), ([3.0, 4.0], true));
    /// assert_eq!(cap.limited([3.0, 4.0]), ([3.0, 4.0], false));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[inline]
    pub fn limited(&self, slope: impl Into<[R; 2]>) -> ([R; 2], bool) {
        self.within(slope.into(), R::ONE)
    }

    /// `rise / run` if it is not steeper than the cap.
    #[inline]
    fn within(&self, [x, y]: [R; 2], run: R) -> ([R; 2], bool) {
        let reach = self.steepest * run;
        let square = reach * reach;
        let usual = run > R::ZERO && square >= R::MIN_POSITIVE && square <= R::MAX;
        if usual && x * x + y * y <= square {
            let inverse = R::ONE / run;
            return ([x * inverse, y * inverse], false);
        }
        self.capped([x, y], run)
    }

    /// The same where the cap may touch it, or squares leave the range of floats.
    fn capped(&self, [x, y]: [R; 2], run: R) -> ([R; 2], bool) {
        let finite = x.is_finite() && y.is_finite() && run.is_finite();
        let quotient = [x / run, y / run];
        let [p, q] = quotient;
        if finite && run > R::ZERO && p * p + q * q <= self.steepest * self.steepest {
            return (quotient, false);
        }
        let largest = x.abs().max(y.abs());
        if !(finite && largest > R::ZERO) {
            return ([R::ZERO; 2], true);
        }
        let (x, y) = (x / largest, y / largest);
        let along = self.steepest / (x * x + y * y).sqrt();
        ([x * along, y * along], true)
    }

    /// The slopes of a row, a band or a whole map of texels; how many were touched.
    ///
    /// # Errors
    /// [`Error::Length`] unless both slices have one length; nothing is then written.
    ///
    /// ```
    /// use lobe::material::lean::{ClippedTexels, SlopeCap};
    /// let mut slopes = [[0.0_f32; 2]; 2];
    /// let texels = [[128_u8, 128, 255], [255, 128, 128]];
    /// let clipped = SlopeCap::new(10.0)?.slopes(&texels, &mut slopes)?;
    /// assert_eq!(clipped, ClippedTexels { texels: 1, of: 2 });
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn slopes<T: NormalTexel>(
        &self,
        texels: &[T],
        out: &mut [[R; 2]],
    ) -> Result<ClippedTexels, Error> {
        same_length(texels.len(), out.len())?;
        let mut touched = 0;
        for (slope, &texel) in out.iter_mut().zip(texels) {
            let (limited, clipped) = self.slope(texel);
            *slope = limited;
            touched += usize::from(clipped);
        }
        Ok(ClippedTexels { texels: touched, of: texels.len() })
    }
}
