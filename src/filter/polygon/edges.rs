//! The mass of the unit GGX density over a parallelogram as a sum over its edges.
//!
//! Layer 3. Green's theorem with the field $w/(2\pi(1 + |w|^2))$; the angles of Lambert's formula.

use super::frame::Frame;
use super::strip::Whitened;
use crate::scalar::Real;

/// Squares of the largest distance of the center and of the longest side, in lobes, at which
/// corners in plain arithmetic keep five digits in f32.
const CLOSE: f64 = 4.0 * 4.0;
const SHORT: f64 = 32.0 * 32.0;

/// Squares of least heights at which the terms, of order one, do not cancel below a hundredth: in
/// lobes times $q^{3/2}$, as the density falls; in sides, for their rounding; or else half the
/// distance.
const TALL: f64 = 0.1 * 0.1;
const TALL_FOR_SIDE: f64 = 0.0126 * 0.0126;
const HALF_DISTANCE: f64 = 0.5 * 0.5;

/// Square of the least distance of every edge, over the root of the longer side: the rounding of
/// corners, side times epsilon, then moves a density below the cube of one over that distance.
const DEEP: f64 = 0.1 * 0.1;

/// True if corners in plain arithmetic serve sides of this squared length: their rounding, side
/// times epsilon, is at most a tenth of the least distance that [`DEEP`] asks for. Up to $2^{32}$
/// lobes in f32, $2^{90}$ in f64.
#[inline(always)]
pub(super) fn serves_plain_corners<R: Real>(side2: R) -> bool {
    let longest = R::lit(1.0 / 16384.0) / (R::EPSILON * R::EPSILON);
    side2 <= longest * longest
}

/// Mean over a parallelogram around or beside the lobe, if it is one that its corners in plain
/// arithmetic serve: the common case of a large footprint.
///
/// In terms of corners $p_k$, the term of an edge $e = p_{k+1} - p_k$ with $c = p_k \times e$ and
/// $r = \sqrt{e^2 + c^2}$ is $\frac{c}{r} \mathrm{atan2}(r, 1 + p_k \cdot p_{k+1})$: Lambert's
/// formula for the directions $(p_k, 1)$. Its terms are of order one, and so must the mass be,
/// nearly: the parallelogram is near and thick. Of a long one the corners have lost digits; they do
/// not matter if all edges pass at a distance of the lobe, as the mass beyond falls like their
/// cube.
#[inline(always)]
pub(super) fn around_the_lobe<R: Real>(
    w: &Whitened<R>,
    center2: R,
    side2: R,
    exact_area: impl Fn() -> R,
) -> Option<R> {
    let area = w.u[0] * w.v[1] - w.u[1] * w.v[0];
    let q = R::ONE + center2;
    let near = center2 <= R::lit(CLOSE) && side2 <= R::lit(SHORT);
    // Squares of the least height, and of the least distance of the edges.
    let (height2, depth2) = if near {
        let tall = (R::lit(TALL) * q * q * q).max(R::lit(TALL_FOR_SIDE) * side2);
        (tall.min(R::lit(HALF_DISTANCE) * q), R::ZERO)
    } else {
        // An edge on either side of the lobe.
        let depth2 = R::lit(DEEP) * side2.sqrt();
        (R::lit(2.0 * 2.0) * depth2, depth2)
    };
    if area * area < height2 * side2 {
        return None;
    }
    let (half, turn) = (R::HALF, if area < R::ZERO { -R::ONE } else { R::ONE });
    let corners = |axis: usize| {
        let (along, across) = (half * (w.u[axis] + w.v[axis]), half * (w.u[axis] - w.v[axis]));
        let midpoint = w.midpoint[axis];
        [midpoint - along, midpoint + across, midpoint + along, midpoint - across]
    };
    let next = |p: [R; 4]| [p[1], p[2], p[3], p[0]];
    // Arrays of four, one operation at a time: the compiler turns each into lanes.
    let (px, py) = (corners(0), corners(1));
    let (qx, qy) = (next(px), next(py));
    let (mut terms, mut depth) = ([R::ZERO; 4], [R::ZERO; 4]);
    for k in 0..4 {
        let (dx, dy) = (qx[k] - px[k], qy[k] - py[k]);
        let c = px[k] * dy - py[k] * dx;
        let e2 = dx * dx + dy * dy;
        let product = R::ONE + px[k] * qx[k] + py[k] * qy[k];
        if near {
            let r = (e2 + c * c).sqrt();
            terms[k] = c / r * r.upper_angle(product);
        } else {
            // Cross products of a billion lobes by a billion have no squares in f32.
            let e = e2.sqrt();
            let d = c / e;
            let s = (R::ONE + d * d).sqrt();
            terms[k] = d / s * (e * s).upper_angle(product);
            // Positive if the lobe lies inwards, deep enough.
            depth[k] = turn * d * d.abs() - depth2;
        }
    }
    let inward = depth.iter().all(|&depth| depth > R::ZERO);
    let sum = (terms[0] + terms[1]) + (terms[2] + terms[3]);
    let area = if near { area } else { turn * exact_area() };
    let mean = (sum / area * R::lit(0.5 * core::f64::consts::FRAC_1_PI)).max(R::ZERO);
    (near || inward).then_some(mean)
}

/// The four edges, counter-clockwise from the bottom: signed distance d of the lobe's center from
/// each line, positive to its left, coordinates along it of its two ends, and its length. An array
/// each, as the terms are evaluated side by side.
struct Edges<R> {
    d: [R; 4],
    t0: [R; 4],
    t1: [R; 4],
    length: [R; 4],
}

impl<R: Real> Edges<R> {
    #[inline(always)]
    fn new(p: &Frame<R>) -> Self {
        let Frame { low, high, low_n, high_n, side, within_left, within_right, .. } = *p;
        let (bt, bn) = (p.shear / side, p.height / side);
        let up = |t: R, n: R| t * bt + n * bn;
        Self {
            d: [-low_n, within_right, high_n, within_left],
            t0: [low[0], up(low[1], low_n), -high[1], -up(high[0], high_n)],
            t1: [low[1], up(high[1], high_n), -high[0], -up(low[0], low_n)],
            length: [p.length, side, p.length, side],
        }
    }

    /// Squared distance of the lobe's center from the parallelogram; 0 inside.
    #[inline(always)]
    fn distance_squared(&self) -> R {
        let mut nearest = R::MAX;
        let mut deepest = R::MAX;
        for k in 0..4 {
            let beyond = self.t0[k].max(-self.t1[k]).max(R::ZERO);
            nearest = nearest.min(self.d[k] * self.d[k] + beyond * beyond);
            deepest = deepest.min(self.d[k]);
        }
        if deepest > R::ZERO { R::ZERO } else { nearest }
    }

    /// A term of every edge.
    #[inline(always)]
    fn terms(&self, term: impl Fn(R, R, R, R) -> R) -> [R; 4] {
        let mut terms = [R::ZERO; 4];
        for (k, value) in terms.iter_mut().enumerate() {
            *value = term(self.d[k], self.t0[k], self.t1[k], self.length[k]);
        }
        terms
    }

    /// True if the edge points at the lobe, so that its angles on the sphere and on the plane
    /// nearly agree.
    #[inline(always)]
    fn is_radial(&self, k: usize) -> bool {
        let (product, square) = (self.t0[k] * self.t1[k], self.d[k] * self.d[k]);
        let q = R::ONE + square;
        square * self.length[k].max(R::ONE) <= product && q.sqrt() * self.length[k] <= q + product
    }

    /// The terms of [`far`], those of radial edges by [`radial`].
    #[inline(always)]
    fn far_terms(&self) -> [R; 4] {
        let mut terms = self.terms(far);
        for (k, term) in terms.iter_mut().enumerate() {
            if self.is_radial(k) {
                *term = -radial(self.d[k], self.t0[k], self.t1[k], self.length[k]);
            }
        }
        terms
    }
}

/// Mass over the parallelogram, $\frac{1}{2\pi} \sum \frac{d}{\sqrt q} \mathrm{atan2}(\ell \sqrt q,
/// q + t_0 t_1)$.
#[inline(always)]
pub(super) fn mass<R: Real>(p: &Frame<R>) -> R {
    let edges = Edges::new(p);
    let turn = R::lit(0.5 * core::f64::consts::FRAC_1_PI);
    // From outside, the terms add up to whole turns plus a mass that falls like the squared
    // distance: far away the turns are left out. (The bounding rectangle of a long sheared
    // footprint does not tell.)
    let terms =
        if edges.distance_squared() <= R::lit(3.0) { edges.terms(near) } else { edges.far_terms() };
    let sum = (terms[0] + terms[1]) + (terms[2] + terms[3]);
    (sum * turn).max(R::ZERO)
}

/// An edge's term as it stands in the formula.
#[inline(always)]
fn near<R: Real>(d: R, t0: R, t1: R, length: R) -> R {
    let q = R::ONE + d * d;
    let s = q.sqrt();
    d / s * (length * s).upper_angle(q + t0 * t1)
}

/// An edge's term less the angle F that the edge subtends at the center of the flat plane: both are
/// of order one, their difference of order 1/q, formed without subtracting them.
///
/// With $\delta = \sqrt q - |d| = 1/(\sqrt q + |d|)$, the formula's angle A exceeds F by
/// $\mathrm{atan2}(\ell \delta (t_0 t_1 - \sqrt q |d|),\; (q + t_0 t_1)(d^2 + t_0 t_1) + \ell^2
/// \sqrt q
/// |d|)$, and $|d|/\sqrt q = 1 - \delta/\sqrt q$. The angles F sum to whole turns.
#[inline(always)]
fn far<R: Real>(d: R, t0: R, t1: R, length: R) -> R {
    let (product, depth) = (t0 * t1, d.abs());
    let q = R::ONE + d * d;
    let s = q.sqrt();
    let delta = R::ONE / (s + depth);
    let angle = (length * s).upper_angle(q + product);
    // Both over the squared length: products of four lengths of a billion lobes leave f32.
    let inverse = R::ONE / length;
    let y = delta * ((product - s * depth) * inverse);
    let x = ((q + product) * inverse) * ((d * d + product) * inverse) + s * depth;
    let term = y.atan2(x) - angle * delta / s;
    if d > R::ZERO { term } else { -term }
}

/// $F - \frac{d}{s} A$ of [`far`] for an edge that points at the lobe, whose two angles nearly
/// agree.
///
/// With $E(z) = \arctan z - z/(1 + z^2)$ and $z_x = x \ell/(x^2 + t_0 t_1)$ it is
/// $d \ell \frac{(d^2 + t_0 t_1)(q + t_0 t_1) + t_0 t_1 \ell^2}{(d^2 + t_0^2)(d^2 + t_1^2)(q +
/// t_0^2)(q + t_1^2)} + E(z_d) - \frac{d}{s} E(z_s)$: a sum of positive terms and a small rest.
#[inline(always)]
fn radial<R: Real>(d: R, t0: R, t1: R, length: R) -> R {
    let (product, d2) = (t0 * t1, d * d);
    let q = R::ONE + d2;
    let s = q.sqrt();
    let (flat, round) = (d2 + product, q + product);
    let (first, second) = ((d2 + t0 * t0) * (q + t0 * t0), (d2 + t1 * t1) * (q + t1 * t1));
    let main = length
        * ((flat / first) * (round / second) + (product / first) * (length * length / second));
    let rest =
        (d.abs() * length / flat).atan_excess() - d.abs() / s * (s * length / round).atan_excess();
    d * main + if d > R::ZERO { rest } else { -rest }
}
