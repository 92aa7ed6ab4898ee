//! How high the normals stand that a footprint's mean density comes from.
//!
//! Floor 3. D is P22 times $1/m_z^4 = (1 + |s|^2)^2$, and a pixel sees the mean of that product. Of a footprint that
//! reaches from the horizon to the lobe the mean of P22 is the lobe's: the half vector's own height, as in Kaplanyan
//! et al. 2016, then multiplies it by millions.

use super::strip::{Whitened, dot};
use crate::scalar::Real;
use crate::slope::Footprint;

/// $1 + |s|^2$ of the slope s that stands for the footprint's mean, over that of the half vector's slope.
///
/// `q` and `slope` are the half vector's, `ratio` is the root of mean over point density: the mean is the density
/// where $1 + q_* = (1 + q)/\mathrm{ratio}$. A first slope is the footprint's densest point along sides that are long
/// against the lobe there, and the half vector along short ones; the way from its q to $q_*$ is converted at the
/// footprint's own rate of slope to whitened slope. For isotropic lobes that is $1 + \alpha^2 q_*$ whatever the first
/// slope. Between 1 and the farthest corner's value.
#[inline]
pub(super) fn secant_ratio<R: Real>(
    slope: [R; 2],
    q: R,
    ratio: R,
    footprint: &Footprint<R>,
    whitened: &Whitened<R>,
) -> R {
    let (zero, one, least) = (R::ZERO, R::ONE, R::MIN_POSITIVE);
    let Whitened { centre, u, v } = *whitened;
    let there = ((one + q - ratio) / ratio).max(zero);
    let (u_squared, v_squared) = (dot(u, u), dot(v, v));

    // The densest point: whitened, the nearest to the lobe's centre, side by side.
    let along = |other: R, side: [R; 2], across: [R; 2], squared: R| {
        let from = [centre[0] + other * across[0], centre[1] + other * across[1]];
        (-dot(from, side) / squared.max(least)).min(R::HALF).max(-R::HALF)
    };
    let (mut i, mut j) = (zero, zero);
    for _ in 0..4 {
        i = along(j, u, v, u_squared);
        j = along(i, v, u, v_squared);
    }
    let at = |i: R, j: R| [centre[0] + i * u[0] + j * v[0], centre[1] + i * u[1] + j * v[1]];
    let densest = at(i, j);
    let reach = R::lit(4.0) * (one + dot(densest, densest));
    let (i, j) = (i * (u_squared / (u_squared + reach)), j * (v_squared / (v_squared + reach)));
    let first = at(i, j);
    let s = [0, 1].map(|k| slope[k] + i * footprint.u[k] + j * footprint.v[k]);

    let sides = dot(footprint.u, footprint.u) + dot(footprint.v, footprint.v);
    let rate = sides / (u_squared + v_squared).max(least);
    let corner =
        [0, 1].map(|k| slope[k].abs() + R::HALF * (footprint.u[k].abs() + footprint.v[k].abs()));
    let secant = one + dot(s, s) + (there - dot(first, first)) * rate;
    let secant = secant.max(one).min(one + dot(corner, corner));
    // A mean that is the point's density but for its own rounding says nothing about where it comes from.
    let same = (one - ratio).abs() <= R::lit(16.0) * R::EPSILON;
    if same { one } else { secant / (one + dot(slope, slope)) }
}
