//! Mirrors and grooves over a footprint: lobes so narrow that all of their mass lies at a point or
//! on a line.
//!
//! Layer 3. A mirror has A = 0, a groove has an A of rank one. A lobe also counts as one of them if
//! the footprint is longer than [`limit`] of the lobe's narrower alpha: its whitened coordinates
//! would leave the range of the precision.

use crate::scalar::exact::{cross, two_sum};
use crate::scalar::{Internal, Real};
use crate::slope::{Footprint, Whiten};

/// Length of a footprint in units of the lobe beyond which the lobe counts as a mirror or as a
/// groove: one over the squared unit of rounding, $2^{48}$ in f32 and $2^{106}$ in f64.
#[inline(always)]
pub(in crate::filter) fn limit<R: Real>() -> R {
    R::lit(4.0) / (R::EPSILON * R::EPSILON)
}

/// False for most lobes that a footprint resolves. True for a mirror, for a groove, and for lobes
/// that [`narrow`] must look at.
#[inline(always)]
fn may_be_unresolved<R: Real>(root_det: R, longer_side_squared: R) -> bool {
    !(root_det >= R::MIN_POSITIVE && longer_side_squared <= limit::<R>() * limit::<R>())
}

/// What a footprint covers of a mirror or of a groove.
#[derive(Clone, Copy)]
pub(in crate::filter) struct Covered<R> {
    /// Mean density over the footprint.
    pub(in crate::filter) mean: R,
    /// The slope that stands for that mean, less the lobe's mean slope.
    pub(in crate::filter) place: [R; 2],
}

/// The lobe as a mirror or a groove, none if the footprint resolves the lobe; `offset` is the
/// footprint's center less the lobe's mean as an unevaluated sum.
#[inline(always)]
pub(in crate::filter) fn unresolved<S: Whiten>(
    shape: &S,
    longer_side_squared: S::Scalar,
    offset: ([S::Scalar; 2], [S::Scalar; 2]),
    footprint: &Footprint<S::Scalar>,
) -> Option<Covered<S::Scalar>> {
    if may_be_unresolved(shape.root_det(), longer_side_squared) {
        narrow(shape, longer_side_squared, offset, footprint)
    } else {
        None
    }
}

/// [`unresolved`] of a lobe that may be.
///
/// A footprint longer than the limit may be a sliver that is as thick as the lobe is wide. A
/// regular lobe is a mirror only if the footprint's thickness exceeds the limit, too, and a groove
/// only if it is $2^{24}$ times as long as wide and the footprint reaches across it by the limit.
#[inline(never)]
fn narrow<S: Whiten>(
    shape: &S,
    longer_side_squared: S::Scalar,
    offset: ([S::Scalar; 2], [S::Scalar; 2]),
    footprint: &Footprint<S::Scalar>,
) -> Option<Covered<S::Scalar>> {
    let root_det = shape.root_det();
    let sixteenth = S::Scalar::lit(1.0 / 16.0);
    let has_squares = longer_side_squared <= S::Scalar::MAX * sixteenth;
    if root_det >= S::Scalar::MIN_POSITIVE && has_squares {
        let (axis, alpha) = shape.major();
        let (minor, limit) = ((root_det / alpha).kept(), limit::<S::Scalar>());
        let thick = is_mirror(alpha, footprint);
        let brushed = alpha >= S::Scalar::lit(f64::from(1 << 24)) * minor;
        if !(thick || (brushed && reach_across(axis, footprint) >= limit * minor)) {
            return None;
        }
    }
    Some(covered(shape, offset, footprint))
}

/// How far a footprint's sides reach across an axis.
#[inline(always)]
pub(in crate::filter) fn reach_across<R: Real>(axis: [R; 2], footprint: &Footprint<R>) -> R {
    cross(axis, footprint.u).abs().max(cross(axis, footprint.v).abs())
}

/// True for a lobe that is a mirror to the footprint: one that the footprint's thickness exceeds by
/// the limit.
#[inline(always)]
fn is_mirror<R: Real>(alpha: R, footprint: &Footprint<R>) -> bool {
    let thickness = (footprint.area() / footprint.largest_component().max(R::MIN_POSITIVE)).kept();
    alpha * limit() <= thickness
}

/// How many times as long as wide a lobe is that counts as a groove where the footprint resolves
/// it.
pub(in crate::filter) const BRUSHED: f64 = 300.0;

/// How many times the density at the half vector a mean may be that the density still says
/// something about. Greater quotients leave the range of f32.
pub(in crate::filter) const LARGEST_GAIN: f64 = 1e30;

/// What a footprint with this `mean` covers of a lobe whose density at the footprint's center is no
/// normal number: of a brushed lobe its groove, of any other one the mean slope.
#[inline(never)]
pub(in crate::filter) fn seen<S: Whiten>(
    shape: &S,
    offset: ([S::Scalar; 2], [S::Scalar; 2]),
    footprint: &Footprint<S::Scalar>,
    mean: S::Scalar,
) -> Covered<S::Scalar> {
    let zero = S::Scalar::ZERO;
    let (_, alpha) = shape.major();
    if alpha * alpha < S::Scalar::lit(BRUSHED) * shape.root_det() {
        return Covered { mean, place: [zero; 2] };
    }
    let groove = covered(shape, offset, footprint);
    Covered { mean: if groove.mean > zero { mean } else { zero }, ..groove }
}

/// What a footprint covers of the lobe as a mirror, or, if the footprint resolves its major axis,
/// as a groove.
#[inline(never)]
pub(in crate::filter) fn covered<S: Whiten>(
    shape: &S,
    offset: ([S::Scalar; 2], [S::Scalar; 2]),
    footprint: &Footprint<S::Scalar>,
) -> Covered<S::Scalar> {
    let (axis, alpha) = shape.major();
    if is_mirror(alpha, footprint) {
        Covered { mean: mirror_mean(offset, footprint), place: [S::Scalar::ZERO; 2] }
    } else {
        groove(axis, alpha, offset, footprint)
    }
}

/// A point of the footprint's border, less the lobe's mean: a corner, or the middle of an edge.
///
/// Cross products with it have the right sign, and all digits, at any distance from 0: a sum of
/// center and sides alone is off by the rounding of the center.
#[derive(Clone, Copy)]
struct Border<R> {
    high: [R; 2],
    low: [R; 2],
}

impl<R: Real> Border<R> {
    /// `offset + a + b` for the unevaluated sum `offset`.
    #[inline(always)]
    fn new((offset, low): ([R; 2], [R; 2]), a: [R; 2], b: [R; 2]) -> Self {
        let at = |k: usize| {
            let (sum, first) = two_sum(offset[k], a[k]);
            let (sum, second) = two_sum(sum, b[k]);
            two_sum(sum, first + second + low[k])
        };
        let ((x, x_low), (y, y_low)) = (at(0), at(1));
        Self { high: [x, y], low: [x_low, y_low] }
    }

    /// Cross product with a vector, this point first.
    #[inline(always)]
    fn cross(&self, side: [R; 2]) -> R {
        cross(self.high, side) + (self.low[0] * side[1] - self.low[1] * side[0])
    }
}

/// Cross products of the middles of the two edges along `side` with it, half of `other` to either
/// side of the center.
#[inline(always)]
fn edges<R: Real>(offset: ([R; 2], [R; 2]), other: [R; 2], side: [R; 2]) -> [R; 2] {
    let half = other.map(|x| R::HALF * x);
    [half.map(|x| -x), half].map(|half| Border::new(offset, half, [R::ZERO; 2]).cross(side))
}

/// 1 within, 1/2 on the border, 0 beyond it, for a depth that is positive within.
#[inline(always)]
pub(in crate::filter) fn share<R: Real>(depth: R) -> R {
    if depth > R::ZERO {
        R::ONE
    } else if depth >= R::ZERO {
        R::HALF
    } else {
        R::ZERO
    }
}

/// $w_u w_v/|u \times v|$: one over the area if the footprint holds the mean, with a factor 1/2 for
/// each pair of sides on one of which the mean lies. 0 for an area below the smallest normal
/// number.
fn mirror_mean<R: Real>(offset: ([R; 2], [R; 2]), footprint: &Footprint<R>) -> R {
    let Footprint { u, v } = *footprint;
    let area = footprint.area();
    let between = |other: [R; 2], side: [R; 2]| {
        let [first, last] = edges(offset, other, side);
        share(first.max(last).min(-first.min(last)))
    };
    let weight = between(u, v) * between(v, u);
    if area >= R::MIN_POSITIVE { weight / area } else { R::ZERO }
}

/// Mean of $\frac{\alpha^2}{2 (\alpha^2 + x^2)^{3/2}}$, GGX's marginal, from x to y:
/// $\frac{\alpha^2 + S_x S_y - x y} {2 S_x S_y (S_x + S_y)}$ with $S_x = \sqrt{\alpha^2 + x^2}$.
///
/// The cumulative $x/(2 S_x)$ cancels on short intervals and on far ones. Its difference, divided
/// by y - x, is the quotient above. For x and y on one side of the mean, $S_x S_y - x y = \alpha^2
/// \frac{\alpha^2 + x^2 + y^2}{S_x S_y + x y}$: a sum of positive terms only. An end at 0 is on the
/// mean, and has half of the mass beside it, however small alpha is. Not both ends and alpha are 0.
#[inline(always)]
fn marginal_mean<R: Real>(alpha: R, x: R, y: R) -> R {
    // In units of the largest of the three, so that no square leaves the range.
    let inverse = R::ONE / alpha.max(x.abs()).max(y.abs());
    let [alpha, x, y] = [alpha, x, y].map(|x| (x * inverse).kept());
    let square = (alpha * alpha).max(R::MIN_POSITIVE);
    let (s_x, s_y) = ((square + x * x).sqrt(), (square + y * y).sqrt());
    let (product, ends) = (x * y, s_x * s_y);
    let beside = square * ((square + x * x + y * y) / (ends + product.abs()));
    let excess = if product > R::ZERO { beside } else { ends - product };
    inverse * ((square + excess) / (R::TWO * ends * (s_x + s_y))).kept()
}

/// The mean over a groove along the unit vector `axis`: the mass of the chord that the footprint
/// cuts from the line through the mean, over the footprint's area.
///
/// With the chord from x to y along the axis, g the axis, and $|g \times v| \ge |g \times u|$, the
/// chord is $t |u \times v|/|g \times v|$ long, where t is the part of u's length that it crosses,
/// $\mathrm{clamp}((|g \times u| + |g \times v|)/2 - |g \times c|,\; 0,\; |g \times u|)/|g
/// \times u|$. The area cancels: $t\,\bar p/|g \times v|$ with $\bar p$ of [`marginal_mean`], for
/// a segment, too. 0 for a footprint without extent across the groove.
fn groove<R: Real>(
    axis: [R; 2],
    alpha: R,
    offset: ([R; 2], [R; 2]),
    footprint: &Footprint<R>,
) -> Covered<R> {
    let (zero, one, half) = (R::ZERO, R::ONE, R::HALF);
    let swap = cross(axis, footprint.u).abs() > cross(axis, footprint.v).abs();
    let (u, v) = if swap { (footprint.v, footprint.u) } else { (footprint.u, footprint.v) };
    let (along_u, along_v) = (cross(axis, u), cross(axis, v));
    let (short, long) = (along_u.abs(), along_v.abs());
    if !(long > zero) {
        return Covered { mean: zero, place: [zero; 2] };
    }

    // The corner that lies farthest beyond the line, seen from the footprint's center.
    let apart = Border::new(offset, [zero; 2], [zero; 2]).cross(axis);
    let side = if apart < zero { -half } else { half };
    let beyond = |w: [R; 2], along: R| {
        let step = if along < zero { -side } else { side };
        w.map(|x| step * x)
    };
    let corner = Border::new(offset, beyond(u, along_u), beyond(v, along_v)).cross(axis);
    let depth = if apart < zero { corner } else { -corner };
    let part = if short > zero { (depth / short).max(zero).min(one) } else { share(depth) };

    // Where the line enters and leaves the strip between two opposite edges.
    let ends = |other: [R; 2], side: [R; 2], across: R| {
        let [first, last] = edges(offset, other, side).map(|cross| cross / across);
        [first.min(last), first.max(last)]
    };
    let [mut start, mut end] = ends(u, v, along_v);
    if short > zero {
        let [from, to] = ends(v, u, along_u);
        (start, end) = (start.max(from), end.min(to));
    }
    // If a side lies along the groove (`short` is 0) and the chord is short against alpha, the mean
    // comes from the chord's middle; in all other cases it comes from the chord's densest point.
    // secant.rs tends to this for a narrow lobe.
    let densest = zero.max(start).min(end);
    let (middle, length) = (half * (start + end), end - start);
    let reach = R::lit(4.0) * (alpha * alpha + densest * densest);
    let near = length * length / (length * length + reach).max(R::MIN_POSITIVE);
    let pull = if short > zero { one } else { near };
    let place = middle + (densest - middle) * pull;

    // `max` drops NaN.
    let mean = (part / long * marginal_mean(alpha, start, end)).max(zero).min(R::MAX);
    Covered { mean, place: axis.map(|x| x * place) }
}
