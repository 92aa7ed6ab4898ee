//! A thin parallelogram under the unit GGX density: exact along, Gauss-Legendre across.
//!
//! Layer 3. The edges' terms of a thin polygon cancel; its fibers' means do not.

use super::frame::Frame;
use super::segment::{apex_mean, near_apex_mean, near_mean, uniform_mean, unit_density};
use crate::scalar::Real;
use crate::scalar::quadrature::{GAUSS_FOUR, Rule};

/// How far the ends of fibers may slide past the lobe, in distances, for one rule to follow.
const SLIDE: f64 = 0.25 * 0.25;

/// The square of how thick a parallelogram is where it matters: the largest ratio, over the pieces
/// that [`mean`] cuts it into, of thickness to distance from the lobe.
///
/// A triangle is as thick as its height only at its base. At t it has the height's share (t -
/// apex)/shear, and that over $\sqrt{1 + t^2}$ is at most $\sqrt{1 + apex^2}$/shear: however long,
/// a footprint with an acute corner near the lobe is thin there.
#[inline(always)]
pub(super) fn thickness_squared<R: Real>(p: &Frame<R>) -> R {
    let height2 = p.height * p.height;
    let shear2 = p.shear * p.shear;
    if shear2 <= R::lit(SLIDE) * p.nearness {
        return height2 / p.nearness;
    }
    let across = (p.n.abs() - R::HALF * p.height).max(R::ZERO);
    let distance2 = |from: R, to: R| {
        let along = from.max(-to).max(R::ZERO);
        R::ONE + across * across + along * along
    };
    let triangle = |apex: R, apex_n: R, from: R, to: R| {
        let corner = (R::ONE + apex * apex + apex_n * apex_n) / shear2;
        height2 * corner.min(R::ONE / distance2(from, to))
    };
    let (start, end) = (p.high[0], p.low[1]);
    let left = triangle(p.low[0], p.low_n, p.low[0], start);
    let right = triangle(p.high[1], p.high_n, end, p.high[1]);
    left.max(right).max(height2 / distance2(start, end))
}

/// Mean of the unit density over a parallelogram that is thin, by [`thickness_squared`].
///
/// Fibers run along the long side. Where the short side reaches far along the long one, the ends of
/// such fibers would sweep past the lobe, and no rule across would follow; the parallelogram is
/// then cut square into a rectangle and two triangles whose short sides lie across. A zero height
/// is no special case.
#[inline(always)]
pub(super) fn mean<R: Real, const N: usize>(p: &Frame<R>, rule: &Rule<N>) -> R {
    // Within three units of the lobe; its fibers' products of four lengths must stay in range.
    let near = R::lit(3.0 * 3.0);
    if p.nearness <= near && p.height * p.height <= near && p.length <= R::lit(1e6) {
        mean_of(p, rule, near_mean, near_apex_mean)
    } else {
        mean_of(p, rule, uniform_mean, apex_mean)
    }
}

#[inline(always)]
fn mean_of<R: Real, const N: usize>(
    p: &Frame<R>,
    rule: &Rule<N>,
    uniform: impl Fn(R, R, R, R) -> R,
    apex: impl Fn(R, R, R, R) -> R,
) -> R {
    let half = R::HALF;
    let distance_at = |y: R| p.n + y * p.height;
    if p.shear * p.shear <= R::lit(SLIDE) * p.nearness {
        let left = half * (p.low[0] + p.high[0]);
        let right = half * (p.low[1] + p.high[1]);
        return rule.mean(|y| {
            let slide = y * p.shear;
            uniform(distance_at(y), left + slide, right + slide, p.length)
        });
    }
    // The obtuse corners are high left and low right: the rectangle lies between them.
    let (start, end) = (p.high[0], p.low[1]);
    let reach2 = R::ONE + p.n * p.n + (start * start).max(end * end);
    let middle = if p.square * p.square <= R::lit(0.05 * 0.05) * reach2 {
        let midpoint = half * (start + end);
        rule.mean(|y| GAUSS_FOUR.mean(|x| unit_density(midpoint + x * p.square, distance_at(y))))
    } else {
        rule.mean(|y| uniform(distance_at(y), start, end, p.square))
    };
    // Both triangles from their apex; the right one is the left one turned half round. A loop, as a
    // closure this large would be called node by node.
    let (nodes, weights) = rule.points();
    let (mut left, mut right) = ([R::ZERO; N], [R::ZERO; N]);
    for k in 0..N {
        let [d, t0, t1, length] = triangle_fiber(p, [p.low[0], p.low_n], start, nodes[k]);
        left[k] = weights[k] * apex(d, t0, t1, length);
    }
    for k in 0..N {
        let [d, t0, t1, length] = triangle_fiber(p, [-p.high[1], -p.high_n], -end, nodes[k]);
        right[k] = weights[k] * apex(d, t0, t1, length);
    }
    let triangles = left.iter().chain(&right).fold(R::ZERO, |sum, &mean| sum + mean);
    (middle * p.square + triangles * (half * p.shear)) / p.length
}

/// The fiber from a triangle's apex to its base, `shear` away, at height `y` of the base: distance
/// of its line, ends, length.
///
/// The distance comes from the nearer end: of a fiber of a million lobes, the farther one has no
/// digits for it.
#[inline(always)]
fn triangle_fiber<R: Real>(p: &Frame<R>, apex: [R; 2], base: R, y: R) -> [R; 4] {
    let rise = (y + R::HALF) * p.height;
    let inverse = R::ONE / (p.shear * p.shear + rise * rise).sqrt();
    let (run, climb) = (p.shear * inverse, rise * inverse);
    let end = [base, apex[1] + rise];
    let (t0, t1) = (apex[0] * run + apex[1] * climb, end[0] * run + end[1] * climb);
    let nearer = if t0.abs() < t1.abs() { apex } else { end };
    [nearer[0] * climb - nearer[1] * run, t0, t1, run * p.shear + climb * rise]
}
