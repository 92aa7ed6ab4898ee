//! Formulas as their papers have them: to reproduce the papers, and to compare ours with.
//!
//! Layer 3. Kaplanyan et al. 2016: Appendix A, GGX over an axis-aligned rectangle by eight
//! arctangents, and the proxy that Eq. 20 ends in. Both forms of Appendix A cancel in f32 when the
//! rectangle is small against alpha (at a thousandth of it they may be ten times too large within
//! two alphas of the peak, and worse beyond) or far from the lobe;
//! [`Ndf::rectangle_mean`](crate::Ndf::rectangle_mean) does not.

use crate::error::Error;
use crate::scalar::Real;

/// The shorthand of Appendix A, $\varphi(x, y, \gamma, \delta) = \frac{x}{\sqrt{x^2 + \gamma^2}}
/// \arctan \frac{\gamma y}{\delta \sqrt{x^2 + \gamma^2}}$.
#[inline(always)]
fn phi<R: Real>(x: R, y: R, gamma: R, delta: R) -> R {
    let root = (x * x + gamma * gamma).sqrt();
    x * (gamma * y / (root * delta)).atan() / root
}

/// The eight terms of Appendix A over the corners `slope -+ reach`.
#[inline(always)]
fn eight_terms<R: Real>(alphas: [R; 2], slope: [R; 2], reach: [R; 2]) -> R {
    let [alpha, beta] = alphas;
    let (s0, s1) = (slope[0] - reach[0], slope[0] + reach[0]);
    let (t0, t1) = (slope[1] - reach[1], slope[1] + reach[1]);
    phi(s0, t0, alpha, beta) - phi(s0, t1, alpha, beta) + phi(s1, t1, alpha, beta)
        - phi(s1, t0, alpha, beta)
        + phi(t0, s0, beta, alpha)
        - phi(t0, s1, beta, alpha)
        + phi(t1, s1, beta, alpha)
        - phi(t1, s0, beta, alpha)
}

/// Mean of the centered GGX $P_{22}$ over `slope +- widths/2`, by Appendix A with its corners
/// mended.
///
/// $\frac{1}{2\pi w_x w_y} \sum \pm\varphi$ over the corners $s \pm w/2$. Exact in exact
/// arithmetic; see the module for f32. `alphas` along the axes of the rectangle; all four positive,
/// else 0.
///
/// Source: Kaplanyan et al. 2016, Eq. 16 and Appendix A. Departs from the print in the corners: the
/// printed prefactor belongs to half the printed reach.
///
/// ```
/// use lobe::filter::kaplanyan_rectangle_mean;
/// let whole = kaplanyan_rectangle_mean([0.01_f64, 0.01], [0.0, 0.0], [20.0, 20.0]);
/// assert!((whole - 1.0 / 400.0).abs() < 1e-8); // mass 1 over area 400
/// ```
#[doc(alias = "lobe_kaplanyan_rectangle_mean")]
pub fn kaplanyan_rectangle_mean<R: Real>(
    alphas: impl Into<[R; 2]>,
    slope: impl Into<[R; 2]>,
    widths: impl Into<[R; 2]>,
) -> R {
    let (alphas, widths) = (alphas.into(), widths.into());
    let reach = widths.map(|w| R::HALF * w);
    normalized(alphas, widths, eight_terms(alphas, slope.into(), reach))
}

/// The same as printed: corners `slope -+ widths` under the prefactor of half that reach.
///
/// That is 4 times the mean over a rectangle of twice the widths: 4 times too large where the
/// rectangle is small against alpha, right where it holds the whole lobe. Kept to reproduce the
/// paper, and to recognize code copied from it.
///
/// ```
/// use lobe::filter::{kaplanyan_rectangle_mean, kaplanyan_rectangle_mean_as_printed};
/// let (alphas, slope) = ([0.1_f64, 0.1], [0.02, 0.03]);
/// let printed = kaplanyan_rectangle_mean_as_printed(alphas, slope, [0.05, 0.05]);
/// let meant = kaplanyan_rectangle_mean(alphas, slope, [0.1, 0.1]);
/// assert!((printed / meant - 4.0).abs() < 1e-12);
/// ```
#[doc(alias = "lobe_kaplanyan_rectangle_mean_as_printed")]
pub fn kaplanyan_rectangle_mean_as_printed<R: Real>(
    alphas: impl Into<[R; 2]>,
    slope: impl Into<[R; 2]>,
    widths: impl Into<[R; 2]>,
) -> R {
    let (alphas, widths) = (alphas.into(), widths.into());
    normalized(alphas, widths, eight_terms(alphas, slope.into(), widths))
}

/// The prefactor of Appendix A; 0 where it divides by 0, and for the negative means that
/// cancellation produces.
#[inline(always)]
fn normalized<R: Real>(alphas: [R; 2], widths: [R; 2], terms: R) -> R {
    let area = widths[0] * widths[1];
    if alphas[0] > R::ZERO && alphas[1] > R::ZERO && area > R::ZERO {
        (terms / (R::TWO * R::PI * area)).max(R::ZERO)
    } else {
        R::ZERO
    }
}

/// Kaplanyan's "GGX proxy" as his results use it, $\alpha' = \sqrt{\alpha^2 + w^2}$, per axis of
/// the rectangle.
///
/// Called indistinguishable from the peak of GGX over a square of width w; its peak is up to 3.1
/// times too dark, as $w^2$ should be $w^2/3$ for small squares and $w^2/\pi$ for large ones
/// ([`box_peak_alpha`](super::box_peak_alpha)). As a kernel it is variance addition with
/// [`PixelFilter::KAPLANYAN_PROXY`](super::PixelFilter::KAPLANYAN_PROXY).
///
/// Source: Kaplanyan et al. 2016, Eq. 20, last form.
///
/// # Errors
/// [`Error::Alpha`], [`Error::Width`] outside $[0, 10^9]$.
///
/// ```
/// use lobe::filter::{box_peak_alpha, kaplanyan_proxy_alpha};
/// let [printed, exact] =
///     [kaplanyan_proxy_alpha, box_peak_alpha].map(|f| f(0.01_f64, 0.1).unwrap());
/// assert!((printed / exact).powi(2) > 3.0); // the peak falls like 1/alpha^2
/// ```
#[doc(alias = "lobe_kaplanyan_proxy_alpha")]
pub fn kaplanyan_proxy_alpha<R: Real>(alpha: R, width: R) -> Result<R, Error> {
    if !alpha.is_magnitude() {
        return Err(Error::Alpha(alpha.into()));
    }
    if !width.is_magnitude() {
        return Err(Error::Width(width.into()));
    }
    Ok((alpha * alpha + width * width).sqrt())
}
