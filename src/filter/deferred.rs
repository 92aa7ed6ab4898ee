//! Filtering before the light is known: roughness from the change of the normal.
//!
//! Layer 3. All forms take the worst case, a half vector at the normal, and differ in what they
//! make of two derivative vectors: a sum, a mean, the largest, a rectangle.

use super::kernel::PixelFilter;
use crate::error::{Error, Value};
use crate::scalar::Real;
use crate::scalar::eigen::largest_eigenvalue;
use crate::slope::Footprint;
use crate::slope::direction::dot;

/// Filtered alpha for a G-buffer, from the derivatives of the world-space normal.
///
/// $\bar\alpha^2 = \alpha^2 + \min(2 \sigma_{px}^2 (|\Delta n_u|^2 + |\Delta n_v|^2),
/// \mathrm{limit})$, $\bar\alpha \le 1$. The trace stands for the largest eigenvalue, which it
/// never falls below. Needs no tangent frame. The paper has [`PixelFilter::KAPLANYAN`] and a limit
/// of 0.18 ([`Kernel::ALPHA_SQUARED_LIMIT`](super::Kernel::ALPHA_SQUARED_LIMIT)). An alpha above 1
/// stays.
///
/// Source: Tokuyoshi 2017, Eq. 13 and Listing 2.
///
/// # Errors
/// [`Error::Alpha`] unless alpha lies in $[0, 10^9]$; [`Error::Limit`] if the limit is negative
/// or NaN.
///
/// ```
/// use lobe::{PixelFilter, filter::tokuyoshi_deferred_alpha};
/// let (dn_u, dn_v) = ([0.1_f32, 0.0, 0.0], [0.0, 0.1, 0.0]);
/// let alpha = tokuyoshi_deferred_alpha(0.1, dn_u, dn_v, PixelFilter::KAPLANYAN, 0.18)?;
/// assert!((alpha - (0.01_f32 + 0.01).sqrt()).abs() < 1e-7);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_tokuyoshi_deferred_alpha")]
pub fn tokuyoshi_deferred_alpha<R: Real>(
    alpha: R,
    dn_u: impl Into<[R; 3]>,
    dn_v: impl Into<[R; 3]>,
    filter: PixelFilter,
    limit: R,
) -> Result<R, Error> {
    widened(alpha, summed(dn_u.into(), dn_v.into(), filter), limit)
}

/// What [`tokuyoshi_deferred_alpha`] adds to alpha^2, without its limit.
#[inline(always)]
pub(crate) fn summed<R: Real>(dn_u: [R; 3], dn_v: [R; 3], filter: PixelFilter) -> R {
    R::TWO * variance::<R>(filter) * (norm_squared(dn_u) + norm_squared(dn_v))
}

/// The same with the mean of the kernel's two eigenvalues in place of their sum: half of it.
///
/// $\bar\alpha^2 = \alpha^2 + \min(\sigma_{px}^2 (|\Delta n_u|^2 + |\Delta n_v|^2),
/// \mathrm{limit})$. The paper has [`PixelFilter::TOKUYOSHI_KAPLANYAN`] and a limit of 0.18: with
/// both changes its kernel is $\pi$ times narrower than that of 2017. Copies often keep the
/// factor 2.
///
/// Source: Tokuyoshi & Kaplanyan 2021, Eq. 14 and Listing 5, there with vertex normals.
///
/// # Errors
/// As [`tokuyoshi_deferred_alpha`].
///
/// ```
/// use lobe::{PixelFilter, filter::*};
/// let (dn_u, dn_v) = ([0.1_f64, 0.0, 0.0], [0.0, 0.1, 0.0]);
/// let added = |alpha: f64| alpha * alpha - 0.01;
/// let old = added(tokuyoshi_deferred_alpha(0.1, dn_u, dn_v, PixelFilter::KAPLANYAN, 0.18)?);
/// let filter = PixelFilter::TOKUYOSHI_KAPLANYAN;
/// let new = added(tokuyoshi_kaplanyan_deferred_alpha(0.1, dn_u, dn_v, filter, 0.18)?);
/// assert!((old / new - core::f64::consts::PI).abs() < 1e-9);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_tokuyoshi_kaplanyan_deferred_alpha")]
pub fn tokuyoshi_kaplanyan_deferred_alpha<R: Real>(
    alpha: R,
    dn_u: impl Into<[R; 3]>,
    dn_v: impl Into<[R; 3]>,
    filter: PixelFilter,
    limit: R,
) -> Result<R, Error> {
    widened(alpha, averaged(dn_u.into(), dn_v.into(), filter), limit)
}

/// What [`tokuyoshi_kaplanyan_deferred_alpha`] adds to alpha^2, without its limit.
#[inline(always)]
pub(crate) fn averaged<R: Real>(dn_u: [R; 3], dn_v: [R; 3], filter: PixelFilter) -> R {
    variance::<R>(filter) * (norm_squared(dn_u) + norm_squared(dn_v))
}

/// The same with the largest eigenvalue itself: the narrowest isotropic kernel that covers the
/// anisotropic one.
///
/// $\bar\alpha^2 = \alpha^2 + \min(2 \lambda, \mathrm{limit})$, with $\lambda$ the largest
/// eigenvalue of $\sigma_{px}^2 (\Delta n_u \Delta n_u^T + \Delta n_v \Delta n_v^T)$. Those of the
/// Gram matrix of the two vectors are the same but for a 0, so that this form, too, needs no
/// tangent frame. One root more than the sum.
///
/// Source: Tokuyoshi 2017, Eq. 10, there from derivatives in the tangent frame.
///
/// # Errors
/// As [`tokuyoshi_deferred_alpha`].
///
/// ```
/// use lobe::{PixelFilter, filter::largest_deferred_alpha};
/// // Curved along one axis only: all of the sum. Along both: half of it.
/// let (dn_u, dn_v) = ([0.1_f64, 0.0, 0.0], [0.0, 0.1, 0.0]);
/// let added = |dn_v| largest_deferred_alpha(0.0, dn_u, dn_v, PixelFilter::KAPLANYAN, 0.18);
/// assert!((added([0.0; 3])?.powi(2) - 0.005).abs() < 1e-15);
/// assert!((added(dn_v)?.powi(2) - 0.005).abs() < 1e-15);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_largest_deferred_alpha")]
pub fn largest_deferred_alpha<R: Real>(
    alpha: R,
    dn_u: impl Into<[R; 3]>,
    dn_v: impl Into<[R; 3]>,
    filter: PixelFilter,
    limit: R,
) -> Result<R, Error> {
    widened(alpha, largest(dn_u.into(), dn_v.into(), filter), limit)
}

/// What [`largest_deferred_alpha`] adds to alpha^2, without its limit.
#[inline(always)]
pub(crate) fn largest<R: Real>(u: [R; 3], v: [R; 3], filter: PixelFilter) -> R {
    let (uu, vv) = (norm_squared(u), norm_squared(v));
    // Derivatives without a square in this precision have no eigenvalues: the trace is then
    // infinite, too.
    let trace = uu + vv;
    let largest = if trace.is_finite() { largest_eigenvalue(uu, dot(u, v), vv) } else { trace };
    R::TWO * variance::<R>(filter) * largest
}

/// Filtered alphas along the frame's axes for a G-buffer with two channels of roughness.
///
/// $\bar\alpha_k^2 = \alpha_k^2 + \min(2 \sigma_{px}^2 w_k^2, \mathrm{limit})$ with $w$ the widths
/// of the bounding rectangle of `footprint`, that of [`quad_normal_footprint`]. One channel takes
/// the larger of the two ([`kaplanyan_deferred_alpha`]). With [`PixelFilter::KAPLANYAN_PROXY`] it
/// is the paper's GGX proxy, with [`PixelFilter::KAPLANYAN`] its Beckmann and Tokuyoshi's reading
/// of its GGX.
///
/// Source: Kaplanyan et al. 2016, section 5.4, Eq. 15, 17 and 20; Tokuyoshi 2017, Listing 3.
///
/// # Errors
/// [`Error::AlphaX`], [`Error::AlphaY`] unless in $[0, 10^9]$; [`Error::Limit`] if the limit is
/// negative or NaN.
///
/// ```
/// use lobe::{Footprint, PixelFilter, filter::kaplanyan_deferred_alphas};
/// let footprint = Footprint::from_slopes([0.1_f64, 0.0], [0.1, 0.1]);
/// let alphas = kaplanyan_deferred_alphas([0.1, 0.1], &footprint, PixelFilter::KAPLANYAN, 0.18)?;
/// assert!((alphas[0].powi(2) - 0.03).abs() < 1e-15 && (alphas[1].powi(2) - 0.015).abs() < 1e-15);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_kaplanyan_deferred_alphas")]
pub fn kaplanyan_deferred_alphas<R: Real>(
    alphas: impl Into<[R; 2]>,
    footprint: &Footprint<R>,
    filter: PixelFilter,
    limit: R,
) -> Result<[R; 2], Error> {
    let ([x, y], [added_x, added_y]) = (alphas.into(), along_axes(footprint, filter));
    let along = |alpha: R, added: R, refused: fn(Value) -> Error| {
        widened(alpha, added, limit).map_err(|error| match error {
            Error::Alpha(alpha) => refused(alpha),
            other => other,
        })
    };
    Ok([along(x, added_x, Error::AlphaX)?, along(y, added_y, Error::AlphaY)?])
}

/// What [`kaplanyan_deferred_alphas`] adds to the squares of both alphas, without its limit.
#[inline(always)]
pub(crate) fn along_axes<R: Real>(footprint: &Footprint<R>, filter: PixelFilter) -> [R; 2] {
    let twice = R::TWO * variance::<R>(filter);
    footprint.extents().map(|width| twice * width * width)
}

/// The same for a G-buffer with one channel: the larger width.
///
/// Not the bound on the kernel that Tokuyoshi 2017, section 4, takes it for: where the change runs
/// along the diagonal it adds half of what the largest eigenvalue does
/// ([`largest_deferred_alpha`]).
///
/// Source: Kaplanyan et al. 2016, section 5.4; Tokuyoshi 2017, Listing 3.
///
/// # Errors
/// As [`tokuyoshi_deferred_alpha`].
///
/// ```
/// use lobe::{Footprint, PixelFilter, filter::kaplanyan_deferred_alpha};
/// let footprint = Footprint::from_slopes([0.1_f64, 0.0], [0.1, 0.1]);
/// let alpha = kaplanyan_deferred_alpha(0.1, &footprint, PixelFilter::KAPLANYAN, 0.18)?;
/// assert!((alpha.powi(2) - 0.03).abs() < 1e-15);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_kaplanyan_deferred_alpha")]
pub fn kaplanyan_deferred_alpha<R: Real>(
    alpha: R,
    footprint: &Footprint<R>,
    filter: PixelFilter,
    limit: R,
) -> Result<R, Error> {
    widened(alpha, widest(footprint, filter), limit)
}

/// What [`kaplanyan_deferred_alpha`] adds to alpha^2, without its limit.
#[inline(always)]
pub(crate) fn widest<R: Real>(footprint: &Footprint<R>, filter: PixelFilter) -> R {
    let [width, height] = footprint.extents();
    let widest = width.max(height);
    R::TWO * variance::<R>(filter) * widest * widest
}

/// A shading frame in world space: unit tangent, bitangent and normal.
pub type ShadingFrame<R> = [[R; 3]; 3];

/// The footprint of a quad whose half vectors all stand at its average normal: the deferred
/// assumption.
///
/// `quad`: the frames of this pixel, its horizontal, its vertical and its diagonal neighbor. The
/// average of the four normals stands for every half vector; seen from the frames of the first
/// three it moves as the frames turn.
///
/// Source: Kaplanyan et al. 2016, section 5.4 and Eq. 17; Tokuyoshi 2017, Listing 3.
///
/// # Errors
/// [`Error::QuadNormal`] if the average is not above all three surfaces.
///
/// ```
/// use lobe::filter::quad_normal_footprint;
/// // A cylinder that turns by 0.02 from column to column.
/// let frame = |angle: f64| {
///     let (sin, cos) = angle.sin_cos();
///     [[cos, 0.0, -sin], [0.0, 1.0, 0.0], [sin, 0.0, cos]]
/// };
/// let quad = [frame(0.0), frame(0.02), frame(0.0), frame(0.02)];
/// let [width, height] = quad_normal_footprint(&quad)?.extents();
/// assert!((width - 0.02).abs() < 1e-5 && height == 0.0);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_quad_normal_footprint")]
pub fn quad_normal_footprint<R: Real>(quad: &[ShadingFrame<R>; 4]) -> Result<Footprint<R>, Error> {
    let average = [0, 1, 2].map(|k| quad[0][2][k] + quad[1][2][k] + quad[2][2][k] + quad[3][2][k]);
    let seen = |frame: &ShadingFrame<R>| frame.map(|axis| dot(axis, average));
    // Seen from each surface, the average stands where a half vector does.
    Footprint::from_half_vectors(seen(&quad[0]), seen(&quad[1]), seen(&quad[2])).map_err(|error| {
        match error {
            Error::HalfVector(_) => Error::QuadNormal(average.map(Value::from)),
            other => other,
        }
    })
}

/// Squared length.
#[inline(always)]
pub(super) fn norm_squared<R: Real>(v: [R; 3]) -> R {
    dot(v, v)
}

#[inline(always)]
fn variance<R: Real>(filter: PixelFilter) -> R {
    R::lit(filter.variance())
}

/// $\sqrt{\alpha^2 + \min(\mathrm{added}, \mathrm{limit})}$, at most 1 unless alpha is more.
pub(super) fn widened<R: Real>(alpha: R, added: R, limit: R) -> Result<R, Error> {
    if !alpha.is_magnitude() {
        return Err(Error::Alpha(alpha.into()));
    }
    Ok(filtered(alpha, added, checked_limit(limit)?))
}

/// A limit that is not negative.
pub(crate) fn checked_limit<R: Real>(limit: R) -> Result<R, Error> {
    if limit >= R::ZERO { Ok(limit) } else { Err(Error::Limit(limit.into())) }
}

/// [`widened`] of an alpha and a limit that are known to be in range.
#[inline(always)]
pub(crate) fn filtered<R: Real>(alpha: R, added: R, limit: R) -> R {
    // `max` drops NaN: derivatives without a number add nothing.
    let added = added.max(R::ZERO).min(limit);
    (alpha * alpha + added).sqrt().min(alpha.max(R::ONE))
}
