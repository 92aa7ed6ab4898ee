//! Raw moments as textures hold them: what filtering hardware may interpolate, and what alpha is
//! lost in it.
//!
//! Layer 4. Raw moments are linear in area, so any filter may average them; covariances are not.
//! What is left of a covariance is a difference of stored numbers, so the storage's step sets a
//! floor. Texels are written with the second moment about the mean *as stored*, $\Sigma +
//! \hat\mu\hat\mu^T$: the mean's rounding then moves the lobe a little and leaves its width alone.

use super::half::{from_half, to_half};
use crate::error::Error;
use crate::scalar::Real;
use crate::slope::SlopeMoments;

/// A texel layout for $\mathrm{E}\,s_x$, $\mathrm{E}\,s_y$, $\mathrm{E}\,s_x^2$, $\mathrm{E}\,s_x
/// s_y$, $\mathrm{E}\,s_y^2$, in this order.
///
/// ```
/// use lobe::material::lean::{Storage, Unorm16};
/// use lobe::{Roughness, SlopeMoments};
/// let layout = Unorm16::new(2.0)?;
/// let sigma = Roughness::from_sigma_rho(0.3, 0.1, 0.5)?.covariance();
/// let texel = layout.encode(&SlopeMoments::new([1.5_f32, -0.2], sigma)?);
/// let back = layout.decode(texel)?;
/// let error = (back.covariance().entries()[0] - 0.09).abs();
/// assert!((2.0 * error).sqrt() <= layout.alpha_floor());
/// # Ok::<(), lobe::Error>(())
/// ```
pub trait Storage {
    /// A stored number.
    type Word: Copy;

    /// The nearest texel. Slopes beyond the layout's range have none: they are stored as its end,
    /// where a map's [`MomentMap::range`](super::MomentMap::range) tells which range it needs.
    fn encode(&self, moments: &SlopeMoments<f32>) -> [Self::Word; 5];

    /// The raw moments of a texel, $\mathrm{E}\,s$ and $\mathrm{E}\,s s^T$.
    fn raw(&self, texel: [Self::Word; 5]) -> ([f32; 2], [f32; 3]);

    /// Mean and covariance of a texel: [`SlopeMoments::from_raw`].
    ///
    /// # Errors
    /// [`Error::Mean`] or [`Error::MatrixEntry`] of floats that are no moments.
    fn decode(&self, texel: [Self::Word; 5]) -> Result<SlopeMoments<f32>, Error> {
        let (mean, second) = self.raw(texel);
        SlopeMoments::from_raw(mean, second)
    }

    /// The alpha below which a stored lobe may not be told from a mirror: $\sqrt{2 e}$ with $e$
    /// half a step of the stored second moments at the end of the range, which is what a decoder's
    /// difference $\mathrm{E}\,s s^T - \hat\mu\hat\mu^T$ errs by at most, for slopes within the
    /// range.
    ///
    /// For range 1: unorm16 0.0055, f16 0.031, f32 3.5e-4. (Moments that are rounded each for
    /// itself, as published, have 0.0087, 0.038 and 4.2e-4 or more: the mean's error counts twice
    /// its slope.) Not in it: mending an indefinite difference, which moves entries once more by as
    /// much; a decoder's own rounding, of the size of what it gives; and interpolation in hardware.
    fn alpha_floor(&self) -> f32;
}

/// A range of slopes that is one.
fn checked(range: f32) -> Result<f32, Error> {
    // Squares of slopes are stored, and covariances beside them.
    if range > 1e-9 && range <= 1e9 { Ok(range) } else { Err(Error::Range(range.into())) }
}

/// The second moments about a mean as it is stored.
fn about(moments: &SlopeMoments<f32>, [x, y]: [f32; 2]) -> [f32; 3] {
    // In f64 nothing of the covariance is lost before the one rounding.
    let [xx, xy, yy] = moments.covariance().entries().map(f64::from);
    let (x, y) = (f64::from(x), f64::from(y));
    [xx + x * x, xy + x * y, yy + y * y].map(|m| m as f32)
}

/// Five f32: for slopes up to `range`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Float32 {
    range: f32,
}

/// Five halves: for slopes up to `range`, at most 255, whose square is nearly the largest half.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Float16 {
    range: f32,
}

/// Five unsigned normalized 16-bit numbers: means in [-range, range], second moments in [0,
/// range^2] and, of xy, [-range^2, range^2]; both zeros are exact.
///
/// The code of a signed number is `32768 + 32767 x / range`, so 0 is one. Hardware reads codes as
/// `v = code / 65535`: [`SlopeMoments::from_unorm`] takes those.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unorm16 {
    range: f32,
}

impl Float32 {
    /// For slopes up to `range`, on which only the floor depends.
    ///
    /// # Errors
    /// [`Error::Range`] unless it lies in $(10^{-9}, 10^9]$.
    pub fn new(range: f32) -> Result<Self, Error> {
        Ok(Self { range: checked(range)? })
    }
}

impl Storage for Float32 {
    type Word = f32;

    fn encode(&self, moments: &SlopeMoments<f32>) -> [f32; 5] {
        let mean = moments.mean();
        let [xx, xy, yy] = about(moments, mean);
        [mean[0], mean[1], xx, xy, yy]
    }

    fn raw(&self, [x, y, xx, xy, yy]: [f32; 5]) -> ([f32; 2], [f32; 3]) {
        ([x, y], [xx, xy, yy])
    }

    fn alpha_floor(&self) -> f32 {
        self.range * f32::EPSILON.sqrt()
    }
}

impl Float16 {
    /// For slopes up to `range`, on which only the floor depends.
    ///
    /// # Errors
    /// [`Error::HalfRange`] unless it lies in $(10^{-9}, 255]$.
    pub fn new(range: f32) -> Result<Self, Error> {
        if range > 1e-9 && range <= 255.0 {
            Ok(Self { range })
        } else {
            Err(Error::HalfRange(range.into()))
        }
    }
}

impl Storage for Float16 {
    type Word = u16;

    fn encode(&self, moments: &SlopeMoments<f32>) -> [u16; 5] {
        let mean = moments.mean().map(to_half);
        let [xx, xy, yy] = about(moments, mean.map(from_half)).map(to_half);
        [mean[0], mean[1], xx, xy, yy]
    }

    fn raw(&self, texel: [u16; 5]) -> ([f32; 2], [f32; 3]) {
        let [x, y, xx, xy, yy] = texel.map(from_half);
        ([x, y], [xx, xy, yy])
    }

    fn alpha_floor(&self) -> f32 {
        // Half of the spacing of halves at the largest second moment, of a mean that was rounded
        // away from 0.
        let mean = from_half(to_half(self.range) + 1);
        let most = to_half(mean * mean);
        (from_half(most + 1) - from_half(most)).sqrt()
    }
}

/// Codes of signed numbers: 0 has one, in the middle.
const MIDDLE: f32 = 32768.0;
const SIGNED_STEPS: f32 = 32767.0;
const STEPS: f32 = 65535.0;

impl Unorm16 {
    /// For slopes up to `range`.
    ///
    /// # Errors
    /// [`Error::Range`] unless it lies in $(10^{-9}, 10^9]$.
    pub fn new(range: f32) -> Result<Self, Error> {
        Ok(Self { range: checked(range)? })
    }
}

impl Storage for Unorm16 {
    type Word = u16;

    fn encode(&self, moments: &SlopeMoments<f32>) -> [u16; 5] {
        let square = self.range * self.range;
        let signed = |x: f32, range: f32| code(MIDDLE + SIGNED_STEPS * (x / range).max(-1.0));
        let unsigned = |x: f32| code(STEPS * (x / square));
        let variances = moments.covariance().entries();
        let mean = moments.mean();
        let axis = |k: usize| {
            let nearest = signed(mean[k], self.range);
            let ([stored, _], _) = self.raw([nearest, 0, 0, 0, 0]);
            // Rounded up to the end of the range, a mean leaves its variance no room: towards 0 it
            // does.
            let beyond = variances[2 * k] + stored * stored > square;
            match nearest {
                _ if !beyond || stored.abs() <= mean[k].abs() => nearest,
                32769.. => nearest - 1,
                _ => nearest + 1,
            }
        };
        let [x, y] = [axis(0), axis(1)];
        let (mean, _) = self.raw([x, y, 0, 0, 0]);
        let [xx, xy, yy] = about(moments, mean);
        [x, y, unsigned(xx), signed(xy, square), unsigned(yy)]
    }

    fn raw(&self, texel: [u16; 5]) -> ([f32; 2], [f32; 3]) {
        let [x, y, xx, xy, yy] = texel.map(|code| f32::from(code) / STEPS);
        raw_of_unorm([x, y], [xx, xy, yy], self.range)
    }

    fn alpha_floor(&self) -> f32 {
        // Half a step of xy, the coarser: e = range^2 / 65534.
        self.range * (2.0 / (2.0 * SIGNED_STEPS)).sqrt()
    }
}

/// The nearest code of a number of steps; signed ones begin at 1.
fn code(steps: f32) -> u16 {
    // In range after the clamp, and not negative.
    #[allow(clippy::cast_sign_loss)]
    let nearest = (steps.clamp(0.0, STEPS) + 0.5) as u16;
    nearest
}

/// Raw moments of [`Unorm16`] numbers in [0, 1].
fn raw_of_unorm<R: Real>(mean: [R; 2], second: [R; 3], range: R) -> ([R; 2], [R; 3]) {
    let (steps, middle) = (R::lit(f64::from(STEPS)), R::lit(f64::from(MIDDLE)));
    let step = R::ONE / R::lit(f64::from(SIGNED_STEPS));
    let signed = |v: R| (v * steps - middle) * step;
    let square = range * range;
    let [xx, xy, yy] = second;
    (mean.map(|v| signed(v) * range), [xx * square, signed(xy) * square, yy * square])
}

impl<R: Real> SlopeMoments<R> {
    /// From what a sampler gives of [`Unorm16`] textures: numbers
    /// in \[0, 1\], filtered or not, and the range they were written for.
    ///
    /// Negative eigenvalues that rounding leaves become 0, as in [`SlopeMoments::from_raw`].
    ///
    /// # Errors
    /// [`Error::Mean`], [`Error::MatrixEntry`] of numbers far outside of \[0, 1\].
    ///
    /// ```
    /// let flat = [32768.0_f32 / 65535.0; 2];
    /// let moments = lobe::SlopeMoments::from_unorm(flat, [0.0, flat[0], 0.0], 4.0)?;
    /// assert!(moments.mean()[0].abs() < 1e-6 && moments.covariance().trace() < 1e-12);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_slope_moments_from_unorm")]
    pub fn from_unorm(mean: [R; 2], second: [R; 3], range: R) -> Result<Self, Error> {
        let (mean, second) = raw_of_unorm(mean, second, range);
        Self::from_raw(mean, second)
    }
}
