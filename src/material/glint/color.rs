//! Colors of details.
//!
//! Layer 4.

use crate::scalar::Real;

/// The hue wheel from a number in [0, 1]: red at 0, green at 1/3, blue at 2/3; every channel lies
/// in [0, 2], and its mean over the wheel is 1.
///
/// ```
/// use lobe::material::glint::hue_wheel;
/// assert_eq!(hue_wheel(0.0_f64), [2.0, 0.0, 0.0]);
/// assert_eq!(hue_wheel(0.5_f64), [0.0, 2.0, 2.0]);
/// ```
#[doc(alias = "lobe_hue_wheel")]
#[inline]
pub fn hue_wheel<R: Real>(hue: R) -> [R; 3] {
    let (zero, one) = (R::ZERO, R::ONE);
    let turn = R::lit(6.0) * hue;
    let from = |place: f64| (turn - R::lit(place)).abs();
    [from(3.0) - one, R::TWO - from(2.0), R::TWO - from(4.0)]
        .map(|channel| R::TWO * channel.max(zero).min(one))
}

/// What a cell's color leaves of its light: a mean of `count` details of independent colors differs
/// from white by $1/\sqrt{count}$ of what one does.
///
/// Source: Zirr & Kaplanyan 2016, section 4.5.
#[inline]
pub(super) fn tint<R: Real>(color: [R; 3], count: R) -> [R; 3] {
    let contrast = R::ONE / count.max(R::ONE).sqrt();
    color.map(|channel| R::ONE + (channel - R::ONE) * contrast)
}
