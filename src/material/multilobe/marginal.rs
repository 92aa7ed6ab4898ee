//! One even density of slopes along one axis, by its nodes.
//!
//! Layer 4.
#![allow(clippy::cast_sign_loss, reason = "nodes are counted by their magnitude")]

use super::generate::REACH;
use crate::scalar::Real;

/// An even density on [-4, 4], linear between nodes, with an integral of 1.
///
/// ```
/// use lobe::material::multilobe::{Dictionary, Recipe};
/// let recipe = Recipe { marginals: 16, levels: 6, ..Recipe::default() };
/// let dictionary = Dictionary::<f64>::new(&recipe)?;
/// let marginal = dictionary.marginal(5, 2);
/// assert_eq!(marginal.density(-0.3), marginal.density(0.3));
/// // A box as wide as the whole has its mean everywhere inside.
/// assert!((marginal.mean(0.0, 8.0) - 0.125).abs() < 1e-12);
/// // A tenth lies above its quantile.
/// let x = marginal.quantile(0.9);
/// assert!((0.5 + x * marginal.mean(0.5 * x, x) - 0.9).abs() < 1e-12);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "LobeMarginal")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Marginal<'a, R> {
    /// Density and cumulative from 0 on.
    nodes: &'a [[R; 2]],
}

impl<'a, R: Real> Marginal<'a, R> {
    #[inline]
    pub(super) const fn new(nodes: &'a [[R; 2]]) -> Self {
        Self { nodes }
    }

    /// Intervals from 0 to the end.
    #[inline]
    #[allow(clippy::cast_possible_wrap, reason = "a recipe has at most 4096")]
    const fn intervals(&self) -> i32 {
        self.nodes.len() as i32 - 1
    }

    /// Nodes per deviation.
    #[inline]
    fn scale(&self) -> R {
        R::lit(f64::from(self.intervals()) / REACH)
    }

    /// Density at a node on either side.
    #[inline]
    fn node(&self, k: i32) -> R {
        self.nodes[k.unsigned_abs() as usize][0]
    }

    /// Integral from 0 to a node on either side.
    #[inline]
    fn cumulative(&self, k: i32) -> R {
        let magnitude = self.nodes[k.unsigned_abs() as usize][1];
        if k < 0 { -magnitude } else { magnitude }
    }

    /// Density at a place within the interval that begins at node `k`.
    #[inline]
    fn within(&self, k: i32, place: R) -> R {
        let part = place - R::lit(f64::from(k));
        let (a, b) = (self.node(k), self.node(k + 1));
        // Next to 0 rounding may lead below it.
        (a + part * (b - a)).max(R::ZERO)
    }

    /// The interval of a place within the table.
    #[inline]
    fn interval(&self, place: R) -> i32 {
        place.floor().min(self.intervals() - 1)
    }

    /// The density at `x`, in deviations; 0 beyond 4, and for NaN.
    #[doc(alias = "lobe_marginal_density")]
    #[inline]
    pub fn density(&self, x: R) -> R {
        let place = x.abs() * self.scale();
        if !(place <= R::lit(f64::from(self.intervals()))) {
            return R::ZERO;
        }
        self.within(self.interval(place), place)
    }

    /// The density's mean over a box around `x`, `width` wide: exact, whatever the width. A
    /// negative one counts as 0.
    ///
    /// By the cumulative where the box has whole intervals; where it has none, by the density
    /// itself and how its slope changes at a node, so that no difference of nearly equal numbers is
    /// divided by a small width. In f32, of 64 intervals, right to 4e-6 of 1 or of the mean,
    /// whichever is more; of 4096 to 2e-3.
    ///
    /// Source: in place of Chermain et al. 2021a, Eq. 19, whose hardware lookup is
    /// [`Marginal::mip_mean`].
    #[doc(alias = "lobe_marginal_mean")]
    #[inline]
    pub fn mean(&self, x: R, width: R) -> R {
        let (scale, end) = (self.scale(), R::lit(f64::from(self.intervals())));
        let place = x.abs() * scale;
        let half = R::HALF * (width.max(R::ZERO) * scale);
        let (a, b) = (place - half, place + half);
        // Also for NaN.
        if !(a < end) {
            return R::ZERO;
        }
        // Not b - a, which has lost digits of a narrow box.
        let whole = R::TWO * half;
        let inside = a >= -end && b <= end;
        let (a, b) = (a.max(-end), b.min(end));
        let share = if inside { R::ONE } else { (b - a) / whole };
        let (first, last) = (self.interval(a), self.interval(b));
        if first == last {
            let middle = if inside { place } else { R::HALF * (a + b) };
            return self.within(first, middle) * share;
        }
        let border = |k: i32| R::lit(f64::from(k));
        let (left, right) = (border(first + 1) - a, b - border(last));
        if last == first + 1 {
            // Around one node: its density, and what both slopes add, whatever the width.
            let [before, here, after] = [first, last, last + 1].map(|k| self.node(k));
            let bend = right * right * (after - here) - left * left * (here - before);
            return (here * share + R::HALF * bend / whole).max(R::ZERO);
        }
        let ends = left * self.within(first, R::HALF * (a + border(first + 1)))
            + right * self.within(last, R::HALF * (b + border(last)));
        let inner = (self.cumulative(last) - self.cumulative(first + 1)) * scale;
        (ends + inner) / whole
    }

    /// What a trilinear lookup gives where the density is a texture of means over intervals, with
    /// mips, mirrored at its ends: `derivative` is the larger one of `x` over the pixel, scaled.
    ///
    /// Linear in nominal boxes of $2^m$ intervals, $m = \log_2$ of the derivative in intervals:
    /// about a box of 1.5 to 1.75 derivatives. 0 for `x` beyond 4.
    ///
    /// Source: Chermain et al. 2021a, Eq. 19, by OpenGL's rules for textures. Mips are differences
    /// of the cumulative here, and need no memory; as published, tables of nodes are read as if
    /// they were means, half an interval off.
    ///
    /// ```
    /// use lobe::material::multilobe::{Dictionary, Recipe};
    /// let recipe = Recipe { marginals: 4, levels: 3, ..Recipe::default() };
    /// let dictionary = Dictionary::<f64>::new(&recipe)?;
    /// let marginal = dictionary.marginal(2, 1);
    /// // The last mip has one texel, the mean.
    /// assert!((marginal.mip_mean(1.0, 100.0) - 0.125).abs() < 1e-12);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn mip_mean(&self, x: R, derivative: R) -> R {
        let place = x.abs() * self.scale();
        let intervals = R::lit(f64::from(self.intervals()));
        if !(place <= intervals) {
            return R::ZERO;
        }
        let top = intervals.exponent();
        let footprint = (derivative.abs() * self.scale()).max(R::ONE);
        let level = (footprint.ln() / R::TWO.ln()).min(R::lit(f64::from(top)));
        let finer = level.floor().min(top);
        let part = level - R::lit(f64::from(finer));
        let (fine, coarse) = (self.texel(place, finer), self.texel(place, (finer + 1).min(top)));
        (fine + part * (coarse - fine)).max(R::ZERO)
    }

    /// A linear lookup in one mip.
    fn texel(&self, place: R, mip: i32) -> R {
        let size = 1_i32 << mip;
        let count = self.intervals() / size;
        let at = place / R::lit(f64::from(size)) - R::HALF;
        let first = at.floor();
        let part = at - R::lit(f64::from(first));
        let mean = |k: i32| {
            // Mirrored: before the first texel the first one, after the last the last.
            let k = k.max(0).min(count - 1);
            let mass = self.cumulative((k + 1) * size) - self.cumulative(k * size);
            mass * self.scale() / R::lit(f64::from(size))
        };
        mean(first) + part * (mean(first + 1) - mean(first))
    }

    /// The `x` below which a share `u` of the density lies, with u in [0, 1]: exact for the linear
    /// interpolant.
    #[doc(alias = "lobe_marginal_quantile")]
    pub fn quantile(&self, u: R) -> R {
        let (zero, one) = (R::ZERO, R::ONE);
        let offset = u.max(zero).min(one) - R::HALF;
        let target = offset.abs();
        // The last node whose cumulative is not above the target.
        let after = self.nodes.partition_point(|node| node[1] <= target);
        let k = after.saturating_sub(1).min(self.nodes.len() - 2);
        let ([a, before], [b, _]) = (self.nodes[k], self.nodes[k + 1]);
        // t with a t + (b - a) t^2/2 = rest, by the root that does not cancel.
        let rest = (target - before).max(zero) * self.scale();
        let root = (a * a + R::TWO * (b - a) * rest).max(zero).sqrt();
        let part = (R::TWO * rest / (a + root).max(R::MIN_POSITIVE)).min(one);
        let x = (R::lit(k as f64) + part) / self.scale();
        if offset < zero { -x } else { x }
    }
}
