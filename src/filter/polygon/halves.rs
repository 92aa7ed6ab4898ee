//! The mean of the unit GGX density over a parallelogram, in straight-line code: additions,
//! products, divisions, roots, selects.
//!
//! Layer 3. Whitened, with center c and half sides a (the longer) and b, the mass is a sum over the
//! edges (Lambert's formula): $\pi \bar P = \frac{1}{8\,a \times b} \sum \frac{k}{r}
//! \mathrm{atan2}(r, x)$, $k = a \times b \pm c \times a$ or $\pm c \times b$, $r^2 = k^2 +
//! |a|^2$ or $|b|^2$, and x one half of $1 + p \cdot p'$ at the edge's corners. Nine products of c,
//! a and b are all it asks. Small footprints take 2x2 nodes of Gauss' rule, far ones a bound.
//! Arrays of four are four edges, one operation at a time: `vec4f` in WGSL, and in Rust the order
//! that keeps four chains of operations interleaved. Edge by edge the sum takes 1.4 times as long.

use crate::scalar::Real;
use crate::slope::Footprint;
use core::f64::consts::{FRAC_1_PI, FRAC_PI_2};

/// Coefficients of $(\arctan(t)/t - 1)/t^2$ in $s = t^2$, $0 \le s \le 1$, with $\arctan(1) =
/// \pi/4$ kept: the two ranges of an angle join without a step, which thin footprints would show.
///
/// Largest error relative to the arctangent: 7.87e-7 (2^-20.28), at s = 0.8125; step at t = 1:
/// 2.9e-9. Fitted by `tests/golden/fit.py`, "atan_joined_f32". Degree 4 misses the stated accuracy.
pub(super) const SINGLE: [f64; 6] =
    [-0.333_282_14, 0.198_934, -0.135_214_91, 0.084_327_6, -0.037_283_733, 7.917_344e-3];

/// Coefficients as [`SINGLE`], for f64.
///
/// Largest error relative to the arctangent: 2.02e-12 (2^-38.85), at s = 0.8887; step at t = 1:
/// 1.4e-17. Fitted by `tests/golden/fit.py`, "atan_joined_f64".
pub(super) const DOUBLE: [f64; 13] = [
    -0.333_333_332_881_376_9,
    0.199_999_963_045_861_26,
    -0.142_856_093_023_228_44,
    0.111_095_979_183_681_44,
    -0.090_778_696_529_416_54,
    0.076_187_370_397_005_65,
    -0.063_789_323_128_558_03,
    0.050_709_743_034_667_756,
    -0.035_615_032_215_639_504,
    0.020_258_674_674_669_106,
    -8.433_736_527_120_42e-3,
    2.229_505_790_607_171_4e-3,
    -2.768_584_237_042_403e-4,
];

/// What differs between the precisions, chosen by the percentiles that tests/laws/lanes.rs holds.
struct Limits<R> {
    /// The squared ratio x of the longer side to the lobe's distance, up to which 2x2 nodes serve;
    /// they err by about $(x/4)^4$: 3e-5 at 0.3, 2e-8 at 0.05.
    small: R,
    /// The least half height of a footprint over its distance L is `low` $L^2$, at most `least`:
    /// lower ones are taken for that high, as the edges' terms, of order one, would cancel.
    low: R,
    least: R,
    /// $L^2$ beyond which the edges' terms are rounding, and a bound stands for their sum.
    far: R,
    /// The largest square of a length: fourth powers of it are still numbers.
    largest: R,
}

#[inline(always)]
fn limits<R: Real>() -> Limits<R> {
    let of = |single, double| R::lit(if R::SINGLE { single } else { double });
    Limits {
        small: of(0.3 * 0.3, 0.05 * 0.05),
        low: of(0.0005, 0.5e-5),
        least: of(0.015, 0.5e-4),
        far: of(2e4, 1e10),
        largest: of(1e18, 1e150),
    }
}

/// [`Limits::small`] beyond [`Limits::far`], where less is asked.
const SMALL_FAR: f64 = 2.0 * 2.0;

type Four<R> = [R; 4];

#[inline(always)]
fn each<R: Real>(a: Four<R>, f: impl Fn(R) -> R) -> Four<R> {
    [f(a[0]), f(a[1]), f(a[2]), f(a[3])]
}

#[inline(always)]
fn pairs<R: Real>(a: Four<R>, b: Four<R>, f: impl Fn(R, R) -> R) -> Four<R> {
    [f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])]
}

#[inline(always)]
fn add<R: Real>(a: Four<R>, b: Four<R>) -> Four<R> {
    pairs(a, b, |a, b| a + b)
}

#[inline(always)]
fn mul<R: Real>(a: Four<R>, b: Four<R>) -> Four<R> {
    pairs(a, b, |a, b| a * b)
}

/// `a` where `x < y`, else `b`.
#[inline(always)]
fn where_less<R: Real>(x: Four<R>, y: Four<R>, a: Four<R>, b: Four<R>) -> Four<R> {
    [
        if x[0] < y[0] { a[0] } else { b[0] },
        if x[1] < y[1] { a[1] } else { b[1] },
        if x[2] < y[2] { a[2] } else { b[2] },
        if x[3] < y[3] { a[3] } else { b[3] },
    ]
}

/// The polynomial by Estrin's scheme, whose chain of dependent operations is shorter than that of
/// Horner's rule.
#[inline(always)]
fn atan_joined<R: Real>(s: Four<R>) -> Four<R> {
    let s2 = mul(s, s);
    if R::SINGLE {
        let [a, b, c, d, e, f] = SINGLE.map(R::lit);
        let high = each(s, |s| s * f + e);
        let mid = each(s, |s| s * d + c);
        let low = each(s, |s| s * b + a);
        add(mul(add(mul(high, s2), mid), s2), low)
    } else {
        let c = DOUBLE.map(R::lit);
        let step = |sum: Four<R>, k: usize| pairs(sum, s2, |sum, s2| sum * s2 + c[k]);
        let even = step(step(step([c[12]; 4], 10), 8), 6);
        let odd = step(step(step([c[11]; 4], 9), 7), 5);
        let (even, odd) = (step(step(step(even, 4), 2), 0), step(step(odd, 3), 1));
        add(even, mul(odd, s))
    }
}

/// The sum over the edges of k/r atan2(r, x), with r^2 = k^2 + side^2, and the sum of its terms'
/// sizes, but for the polynomial's part of them.
///
/// The angle is base +- (t + t s p), s = t^2, with t = r/x and the base 0 or pi, or t = x/r and the
/// base pi/2. Both ways k/r t = k x/(larger of r^2 and x^2), up to the sign: no root stands before
/// the polynomial.
#[inline(always)]
fn terms<R: Real>(k: Four<R>, side2: Four<R>, x: Four<R>) -> (R, R) {
    let (zero, one) = ([R::ZERO; 4], R::ONE);
    let r2 = add(mul(k, k), side2);
    let x2 = mul(x, x);
    let inverse = each(pairs(r2, x2, Real::max), |larger| one / larger);
    let s = mul(pairs(r2, x2, Real::min), inverse);
    let line = mul(mul(k, x), inverse);
    let line = where_less(x2, r2, each(line, |line| -line), line);
    let p = atan_joined(s);
    let front = pairs(k, each(r2, Real::sqrt), |k, r| k / r);
    let base = where_less(x, zero, [R::PI; 4], zero);
    let base = where_less(x2, r2, [R::lit(FRAC_PI_2); 4], base);
    let first = add(mul(front, base), line);
    let second = mul(mul(line, s), p);
    let over_edges = |terms: Four<R>| (terms[0] + terms[2]) + (terms[1] + terms[3]);
    (over_edges(first) + over_edges(second), over_edges(each(first, R::abs)))
}

#[inline(always)]
fn dot<R: Real>(a: [R; 2], b: [R; 2]) -> R {
    a[0] * b[0] + a[1] * b[1]
}

#[inline(always)]
fn cross<R: Real>(a: [R; 2], b: [R; 2]) -> R {
    a[0] * b[1] - a[1] * b[0]
}

/// Relative error of an edge's term in f64: the polynomial's, as [`DOUBLE`] states, and rounding up
/// to [`RESOLVED`], twice each.
const TERM_ERROR: f64 = 8e-12;

/// The largest sum of the squares of center and longer side up to which rounding moves terms in f64
/// by less than the polynomial does: corners of 1e4 lobes have an error of 1e-12.
const RESOLVED: f64 = 1e8;

/// Relative errors of a mean that is known, within ten lobes of the footprint and beyond: half of
/// what [`Ndf::parallelogram_mean`](crate::Ndf::parallelogram_mean) promises in f32.
const KNOWN: [f64; 2] = [5e-6, 5e-4];

/// A mean of $1/(1 + |w|^2)^2$.
#[derive(Clone, Copy)]
pub(super) struct Mean<R> {
    pub(super) value: R,
    /// Whether the value is certain to err by less than [`KNOWN`], if it was computed in f64.
    pub(super) known: bool,
}

/// A whitened parallelogram: center, half sides a (the longer) and b, and their products.
#[derive(Clone, Copy)]
pub(super) struct Halves<R> {
    pub(super) c: [R; 2],
    pub(super) a: [R; 2],
    pub(super) b: [R; 2],
    /// Squares of a and b.
    pub(super) aa: R,
    pub(super) bb: R,
    /// Cross products c x a, c x b, a x b.
    pub(super) ca: R,
    pub(super) cb: R,
    pub(super) ab: R,
    /// Scalar products c . a, c . b, a . b.
    pa: R,
    pb: R,
    d: R,
}

impl<R: Real> Halves<R> {
    /// Of a footprint around `center`, by what whitens a vector.
    ///
    /// Products are taken before it is known which side is longer: nothing waits for that.
    #[inline(always)]
    pub(super) fn new(
        center: [R; 2],
        footprint: &Footprint<R>,
        whiten: impl Fn([R; 2]) -> [R; 2],
    ) -> Self {
        let half = |v: [R; 2]| whiten(v.map(|x| R::HALF * x));
        let (c, u, v) = (whiten(center), half(footprint.u), half(footprint.v));
        let (uu, vv) = (dot(u, u), dot(v, v));
        let (cu, cv, uv) = (cross(c, u), cross(c, v), cross(u, v));
        let (pu, pv) = (dot(c, u), dot(c, v));
        let swap = uu < vv;
        let either = |x: R, y: R| if swap { y } else { x };
        Self {
            c,
            a: [either(u[0], v[0]), either(u[1], v[1])],
            b: [either(v[0], u[0]), either(v[1], u[1])],
            aa: uu.max(vv),
            bb: uu.min(vv),
            ca: either(cu, cv),
            cb: either(cv, cu),
            ab: either(uv, -uv),
            pa: either(pu, pv),
            pb: either(pv, pu),
            d: dot(u, v),
        }
    }

    /// The mean of $1/(1 + |w|^2)^2$: pi times that of the unit density. 0 beyond the largest
    /// lengths, and for NaN.
    #[inline(always)]
    pub(super) fn mean(&self) -> Mean<R> {
        let Self { c, aa, bb, ca, cb, ab, pa, pb, d, .. } = *self;
        let (zero, half, one) = (R::ZERO, R::HALF, R::ONE);
        let limits = limits::<R>();
        let q = one + dot(c, c);

        // Small: Gauss' 2x2 nodes, in pairs. 1 + |w|^2 at them is x +- y and z +- t; 2/sqrt(3) is
        // twice a node.
        let middle = q + R::lit(1.0 / 3.0) * (aa + bb);
        let skew = R::lit(2.0 / 3.0) * d;
        let node = R::lit(1.154_700_538_379_251_5);
        let (x, z) = (middle + skew, middle - skew);
        let (y, t) = (node * (pa + pb), node * (pa - pb));
        let (x2, y2, z2, t2) = (x * x, y * y, z * z, t * t);
        // Products of two 1 + |w|^2, so at least 1; of what is not small, rounding is not.
        let (i, j) = (one / (x2 - y2).max(one), one / (z2 - t2).max(one));
        let small = half * (((x2 + y2) * i).kept() * i + ((z2 + t2) * j).kept() * j);

        // Distance L = sqrt(1 + d^2) of the rectangle around it, along its longer side; the least
        // height that the terms resolve there.
        let length2 = R::lit(4.0) * aa;
        // Shorter ones are small: the floor keeps what is not used for them finite.
        let aa = aa.max(R::lit(0.25) * limits.small);
        let inverse_aa = one / aa;
        let across = (ca.abs() - ab.abs()).max(zero);
        let along = (pa.abs() - (aa + d.abs())).max(zero);
        let beyond2 = across * across + along * along;
        let l2 = one + beyond2 * inverse_aa;
        // a L, without waiting for the division.
        let long = (aa + beyond2).sqrt();
        let least = long * (limits.low * l2).min(limits.least);
        let size = ab.abs().max(least);
        let area = if ab < zero { -size } else { size };
        // The shorter half side moves across the longer one by that much of it.
        let nudge = (area - ab) * inverse_aa;
        let pb = pb - nudge * ca;
        let cb = cb + nudge * pa;
        let bb = bb + nudge * (ab + area);

        // Far: a harmonic mean of three bounds, those of a point, a line and all of the mass.
        let is_far = limits.far < l2;
        let bound = l2 * (l2 + (R::lit(4.0 * FRAC_1_PI) * long + R::lit(8.0 * FRAC_1_PI) * size));
        let below = if is_far { bound } else { R::lit(8.0) * area };
        let inverse_below = one / below;

        // Edges below, right, above and left; half of 1 + p.p' of their corners p and p'.
        let gap = aa - bb;
        let (low, high) = (half * (q - gap), half * (q + gap));
        let (sum, sizes) = terms(
            [area + ca, area + cb, area - ca, area - cb],
            [aa, bb, aa, bb],
            [low - pb, high + pa, low + pb, high - pa],
        );
        let above = if is_far { one } else { sum };
        let large = (above * inverse_below).max(zero);
        let up_to = if is_far { R::lit(SMALL_FAR) } else { limits.small };
        let mean = if length2 < up_to * l2 { small } else { large };
        let lengths2 = q + length2;

        // Known: small, or a sum that its terms' errors leave standing, of the very footprint.
        let [near, beyond] = KNOWN.map(|known| R::lit(known / TERM_ERROR));
        let allowed = if l2 < R::lit(10.0 * 10.0) { near } else { beyond };
        let sum = if area < zero { -sum } else { sum };
        let resolved = sizes < sum * allowed && !is_far && size == ab.abs();
        let known = lengths2 < R::lit(RESOLVED) && (resolved || length2 < limits.small * l2);
        Mean { value: if lengths2 < limits.largest { mean } else { zero }, known }
    }
}
