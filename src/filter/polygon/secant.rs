//! How high the normals stand that a footprint's mean density comes from.
//!
//! Layer 3. D is P22 times $1/m_z^4 = (1 + |s|^2)^2$, and a pixel sees the mean of that product. Of
//! a footprint that reaches from the horizon to the lobe the mean of P22 is the lobe's: the half
//! vector's own height, as in Kaplanyan et al. 2016, then multiplies it by millions.

use super::strip::{Whitened, dot};
use crate::scalar::Real;
use crate::slope::Footprint;

/// $1 + |s|^2$ of the slope s that stands for the footprint's mean, over that of the half vector's
/// slope.
///
/// `q` and `slope` are the half vector's, `ratio` is the root of mean over point density: the mean
/// is the density where $1 + q_* = (1 + q)/\mathrm{ratio}$. A first slope is the footprint's
/// densest point along sides that are long against the lobe there, and the half vector along short
/// ones; the way from its q to $q_*$ is converted at the footprint's own rate of slope to whitened
/// slope. For isotropic lobes that is $1 + \alpha^2 q_*$ whatever the first slope. Between 1 and
/// the farthest corner's value.
///
/// `groove` is called only if the whitened sides are nearly parallel. It returns the first slope
/// and its q if the lobe is so much narrower along one axis that it is a groove to the footprint.
#[inline]
pub(super) fn secant_ratio<R: Real>(
    slope: [R; 2],
    q: R,
    ratio: R,
    footprint: &Footprint<R>,
    whitened: &Whitened<R>,
    groove: impl FnOnce() -> Option<([R; 2], R)>,
) -> R {
    let (zero, one, least) = (R::ZERO, R::ONE, R::MIN_POSITIVE);
    let Whitened { u, v, .. } = *whitened;
    let there = ((one + q - ratio) / ratio.max(least)).max(zero).min(R::MAX);
    let (u_squared, v_squared) = (dot(u, u), dot(v, v));
    let area = u[0] * v[1] - u[1] * v[0];
    // By a quotient: the fourth power of a billion lobes leaves the range of f32.
    let parallel = area * (area / u_squared.max(least)).kept() <= R::lit(1e-6) * v_squared;
    let as_groove = if parallel { groove() } else { None };
    let (s, first_squared) = as_groove.unwrap_or_else(|| {
        let [i, j, first] = first_place(whitened, u_squared, v_squared, area, parallel);
        ([0, 1].map(|k| slope[k] + i * footprint.u[k] + j * footprint.v[k]), first)
    });

    let sides = dot(footprint.u, footprint.u) + dot(footprint.v, footprint.v);
    let rate = (sides / (u_squared + v_squared).max(least)).kept();
    let corner =
        [0, 1].map(|k| slope[k].abs() + R::HALF * (footprint.u[k].abs() + footprint.v[k].abs()));
    let secant = one + dot(s, s) + (there - first_squared) * rate;
    let secant = secant.max(one).min(one + dot(corner, corner));
    // A mean that is the point's density but for its own rounding says nothing about where it comes
    // from.
    let same = (one - ratio).abs() <= R::lit(16.0) * R::EPSILON;
    if same { one } else { secant / (one + dot(slope, slope)) }
}

/// Where the first slope lies, in sides from the footprint's center, and its q.
#[inline(always)]
fn first_place<R: Real>(
    whitened: &Whitened<R>,
    u_squared: R,
    v_squared: R,
    area: R,
    parallel: bool,
) -> [R; 3] {
    let (zero, one) = (R::ZERO, R::ONE);
    let Whitened { midpoint, u, v } = *whitened;
    let at = |i: R, j: R| [midpoint[0] + i * u[0] + j * v[0], midpoint[1] + i * u[1] + j * v[1]];
    let [i, j] = densest(whitened, u_squared, v_squared, area, parallel);
    let nearest = at(i, j);
    let reach = R::lit(4.0) * (one + dot(nearest, nearest));
    let (of_u, of_v) = (u_squared / (u_squared + reach), v_squared / (v_squared + reach));
    // The longer side makes up for what the shorter one gave up.
    let (i, j) = if u_squared >= v_squared {
        (along(at(zero, j * of_v), u, u_squared).0 * of_u, j * of_v)
    } else {
        (i * of_u, along(at(i * of_u, zero), v, v_squared).0 * of_v)
    };
    let first = at(i, j);
    [i, j, dot(first, first)]
}

/// Where the footprint is densest, in sides from its center: at the lobe's center if it covers
/// that, else at the nearest point of the four edges, whitened.
#[inline]
fn densest<R: Real>(
    whitened: &Whitened<R>,
    u_squared: R,
    v_squared: R,
    area: R,
    parallel: bool,
) -> [R; 2] {
    let Whitened { midpoint, u, v } = *whitened;
    let half = R::HALF;
    let cross = |a: [R; 2], b: [R; 2]| a[0] * b[1] - a[1] * b[0];
    let (i, j) = (-(cross(midpoint, v) / area), cross(midpoint, u) / area);
    // Of nearly parallel sides the area is rounding: they are one segment, end to end.
    if parallel {
        let sign = if dot(u, v) < R::ZERO { -R::ONE } else { R::ONE };
        let both = [u[0] + sign * v[0], u[1] + sign * v[1]];
        let t = along(midpoint, both, dot(both, both)).0;
        return [t, sign * t];
    }
    if i.abs() <= half && j.abs() <= half {
        return [i, j];
    }
    let from = |side: [R; 2], t: R| [midpoint[0] + t * side[0], midpoint[1] + t * side[1]];
    let edges = [-half, half].map(|t| {
        let ((j, far), (i, farther)) =
            (along(from(u, t), v, v_squared), along(from(v, t), u, u_squared));
        if far <= farther { (far, [t, j]) } else { (farther, [i, t]) }
    });
    if edges[0].0 <= edges[1].0 { edges[0].1 } else { edges[1].1 }
}

/// The point nearest to the origin on a side through `start`, half of it each way: in sides, and
/// its squared distance.
#[inline(always)]
fn along<R: Real>(start: [R; 2], side: [R; 2], squared: R) -> (R, R) {
    let t = (-dot(start, side) / squared.max(R::MIN_POSITIVE)).min(R::HALF).max(-R::HALF);
    let end = [start[0] + t * side[0], start[1] + t * side[1]];
    (t, dot(end, end))
}
