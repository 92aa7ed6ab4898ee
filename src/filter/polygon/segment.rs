//! The unit GGX density, and its means along a segment: what thin polygons are made of.
//!
//! Layer 3. The unit density is $1/(\pi (1 + |w|^2)^2)$ on the whitened plane. A point of the
//! segment has coordinate t along it and distance d from its line to the lobe's center; $q = 1 +
//! d^2$, $s = \sqrt q$. Straight-line code throughout: quadratures evaluate several segments at
//! once.

use crate::scalar::Real;

/// The unit density.
#[inline(always)]
pub(super) fn unit_density<R: Real>(x: R, y: R) -> R {
    let inverse = R::ONE / (R::ONE + x * x + y * y);
    inverse * inverse * R::lit(core::f64::consts::FRAC_1_PI)
}

/// $2 q^{3/2} \int_{|t|}^\infty dt/(q + t^2)^2$, between 0 and $\pi/2$.
///
/// $= G(s/|t|)$ with $G(x) = \arctan x - x/(1 + x^2)$; beyond x = 1 by its complement.
#[inline(always)]
fn tail<R: Real>(s: R, t: R) -> R {
    let t = t.abs();
    let (small, large) = (s.min(t), s.max(t));
    let x = small / large;
    let excess = x.atan_excess();
    let complement = R::HALF * R::PI - excess - R::TWO * x / (R::ONE + x * x);
    if s <= t { excess } else { complement }
}

/// $2 q^{3/2} \int_{t_0}^{t_1} dt/(q + t^2)^2$, for $t_0 \le t_1$.
#[inline(always)]
fn integral<R: Real>(s: R, t0: R, t1: R) -> R {
    let (head, end) = (tail(s, t0), tail(s, t1));
    let apart = R::PI - head - end;
    if t0 * t1 > R::ZERO { (head - end).abs() } else { apart }
}

/// Mean of the unit density over the segment from `t0` to `t1` at distance `d`.
///
/// `length = t1 - t0 > 0`, known better than by that difference, and not small against the distance
/// to the center (quadrature serves there).
#[inline(always)]
pub(super) fn uniform_mean<R: Real>(d: R, t0: R, t1: R, length: R) -> R {
    let q = R::ONE + d * d;
    let s = q.sqrt();
    integral(s, t0, t1) / (R::TWO * R::PI * q * s * length)
}

/// The same for a segment within three units of the lobe, by one arctangent: what its two terms
/// cancel is then at most the squared distance.
///
/// $\int_{t_0}^{t_1} \frac{dt}{(q + t^2)^2} = \frac{\ell (q - t_0 t_1)}{2 q (q + t_0^2)(q +
/// t_1^2)} + \frac{\mathrm{atan2}(\ell s, q + t_0 t_1)}{2 q s}$
#[inline(always)]
pub(super) fn near_mean<R: Real>(d: R, t0: R, t1: R, length: R) -> R {
    let q = R::ONE + d * d;
    let s = q.sqrt();
    let (product, run) = (t0 * t1, length * s);
    let ends = (q + t0 * t0) * (q + t1 * t1);
    let sum = run * (q - product) + ends * run.upper_angle(q + product);
    (sum / (R::TWO * R::PI * q * run * ends)).max(R::ZERO)
}

/// The mean of [`apex_mean`] for a segment within three units of the lobe, by one arctangent.
///
/// $\frac{1}{\pi q \ell^2} [\frac{\ell t_1}{q + t_1^2} - \frac{t_0}{s} \mathrm{atan2}(\ell s, q +
/// t_0 t_1)]$
#[inline(always)]
pub(super) fn near_apex_mean<R: Real>(d: R, t0: R, t1: R, length: R) -> R {
    let q = R::ONE + d * d;
    let s = q.sqrt();
    let (run, end) = (length * s, q + t1 * t1);
    let sum = run * t1 - t0 * end * run.upper_angle(q + t0 * t1);
    (sum / (R::PI * q * s * end * (length * length))).max(R::ZERO)
}

/// Mean over the segment with weight growing from 0 at `t0` to 2 at `t1`: a fiber of a triangle
/// from its apex. `length = t1 - t0`, known better than by that difference.
///
/// $\frac{2}{\pi \ell^2} \int (t - t_0)/(q + t^2)^2 dt = \frac{2}{\pi \ell^2}
/// [\frac{\ell (t_0 + t_1)}{2 (q + t_0^2)(q + t_1^2)} - t_0 \int dt/(q + t^2)^2]$
#[inline(always)]
pub(super) fn apex_mean<R: Real>(d: R, t0: R, t1: R, length: R) -> R {
    let q = R::ONE + d * d;
    let s = q.sqrt();
    let ends = length * (t0 + t1) / (R::TWO * (q + t0 * t0) * (q + t1 * t1));
    let line = integral(s, t0, t1) / (R::TWO * q * s);
    (R::TWO * (ends - t0 * line) / (R::PI * length * length)).max(R::ZERO)
}
