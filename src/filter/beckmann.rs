//! Beckmann over an axis-aligned rectangle: two one-dimensional means.
//!
//! Layer 3.

use super::groove::{limit, share};
use crate::scalar::Real;
use crate::scalar::exact::{two_product, two_sum};
use crate::scalar::quadrature::{GAUSS_EIGHT, GAUSS_FOUR};

/// `x / y` as an unevaluated sum, high and low.
fn divide<R: Real>(x: R, y: R) -> (R, R) {
    let quotient = (x / y).kept();
    let (product, error) = two_product(quotient, y);
    quotient.with_rest(((x - product).kept() - error) / y)
}

/// $e^{-(x + x_{low})^2}$: at x = 9 the rounding of x alone costs 1e-5 in f32.
fn exp_minus_square<R: Real>(x: R, x_low: R) -> R {
    let (square, error) = two_product(x, x);
    (-square).exp() * (R::ONE - (error + R::TWO * x * x_low))
}

/// Mean of the centered Gaussian density $e^{-(s/\alpha)^2}/(\sqrt\pi\,\alpha)$ over `slope +-
/// width/2`.
///
/// A mirror's is one over the width within, half of that at either end, and 0 outside; over no
/// width 0. An interval of more than $2^{48}$ alphas (f32; $2^{106}$ in f64) is a mirror's.
fn mean_along<R: Real>(slope: R, width: R, alpha: R) -> R {
    let (midpoint, half) = (slope.abs(), R::HALF * width.abs());
    if alpha >= R::MIN_POSITIVE && half <= limit::<R>() * alpha {
        return unit_mean(slope, width, alpha) / alpha;
    }
    if !(alpha >= R::ZERO) {
        return R::ZERO;
    }
    let share = share(half - midpoint);
    if half > R::ZERO { share / half * R::HALF } else { R::ZERO }
}

/// Mean of $e^{-t^2}/\sqrt\pi$ over `(slope +- width/2) / alpha`.
///
/// Short intervals by Gauss-Legendre; long ones by a difference of erfc on the side where both are
/// small, which then differ by more than a factor of 2. The exponential is a factor of either.
fn unit_mean<R: Real>(slope: R, width: R, alpha: R) -> R {
    let (midpoint, midpoint_low) = divide(slope.abs(), alpha);
    let (half, half_low) = divide(R::HALF * width.abs(), alpha);
    if half * (R::ONE + R::TWO * midpoint) <= R::HALF {
        let inverse_root_pi = R::lit(0.564_189_583_547_756_3);
        let at = |y: R| {
            let step = R::TWO * half * y;
            (-(step * (R::TWO * midpoint + step))).exp()
        };
        let relative = if R::SINGLE { GAUSS_FOUR.mean(at) } else { GAUSS_EIGHT.mean(at) };
        return inverse_root_pi * exp_minus_square(midpoint, midpoint_low) * relative;
    }
    let far = midpoint + half;
    let (near, near_low) = two_sum(midpoint, -half);
    // Of a long interval that ends near the lobe, what division rounded off is part of the end.
    let (near, near_low) = two_sum(near, near_low + (midpoint_low - half_low));
    let mass = if near >= R::ZERO {
        let between = (-(R::lit(4.0) * half * midpoint)).exp();
        exp_minus_square(near, near_low) * (near.erfcx() - far.erfcx() * between)
    } else {
        R::TWO - (-near).erfc() - far.erfc()
    };
    mass / (R::lit(4.0) * half)
}

/// Mean of the centered Beckmann $P_{22}$ over the rectangle `slope +- widths/2`.
///
/// $\prod_k \frac{1}{2 w_k} [\mathrm{erf}((s_k + w_k/2)/\alpha_k) - \mathrm{erf}((s_k -
/// w_k/2)/\alpha_k)]$, without the cancellation of that difference. `alphas` along the axes of the
/// rectangle, 0 included: the mean of a mirror along an axis is $1/w_k$ within the rectangle, half
/// of that at its border, 0 outside, and 0 over no width. `widths` are full widths, 0 included;
/// their sign does not matter. With the Gaussian pixel kernel Beckmann has a closed form
/// ([`Roughness::widened`](crate::Roughness::widened)); this one is its box-pixel counterpart.
///
/// ```
/// use lobe::filter::beckmann_rectangle_mean;
/// let whole = beckmann_rectangle_mean([0.1_f64, 0.1], [0.0, 0.0], [2.0, 2.0]);
/// assert!((whole - 0.25).abs() < 1e-12); // mass 1 over area 4
/// ```
#[doc(alias = "lobe_beckmann_rectangle_mean")]
pub fn beckmann_rectangle_mean<R: Real>(
    alphas: impl Into<[R; 2]>,
    slope: impl Into<[R; 2]>,
    widths: impl Into<[R; 2]>,
) -> R {
    let (alphas, slope, widths) = (alphas.into(), slope.into(), widths.into());
    let along = |k: usize| mean_along(slope[k], widths[k], alphas[k]);
    // `max` drops the NaN of an infinite width.
    (along(0) * along(1)).max(R::ZERO).min(R::MAX)
}
