//! Moments between texels: bilinear, trilinear, and along a footprint.
//!
//! Layer 4. Interpolating covariances alone forgets that the texels' means differ; a merge by
//! weights does not. This is what linear filtering of raw moments gives, without their
//! cancellation.

use super::level::gathered;
use super::map::{Border, MomentMap};
use crate::scalar::Real;
use crate::slope::SlopeMoments;

/// Probes of one lookup at most.
const MOST_PROBES: usize = 1024;
/// 1/sqrt 3.
const INVERSE_ROOT_THREE: f64 = 0.577_350_269_189_625_8;

/// Four texels of a level, their bilinear shares, columns and rows.
struct Corners<R> {
    level: usize,
    texels: [SlopeMoments<R>; 4],
    shares: [R; 4],
    places: [[usize; 2]; 4],
}

impl<R: Real> MomentMap<R> {
    /// Moments at `uv` of a level: the four texels around, merged by bilinear weights,
    /// between-texel term included.
    ///
    /// Texel (i, j) has its center at ((i + 1/2) / width, (j + 1/2) / height). Coordinates beyond
    /// $10^9$ texels and NaN count as 0.
    ///
    /// ```
    /// use lobe::material::lean::{Border, MomentMap};
    /// let map = MomentMap::from_slopes([2, 1], vec![[0.0_f64, 0.0], [1.0, 0.0]], Border::Clamp)?;
    /// let between = map.bilinear(0, [0.5, 0.5]);
    /// assert_eq!(between.mean(), [0.5, 0.0]);
    /// assert_eq!(between.covariance().entries()[0], 0.25);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn bilinear(&self, level: usize, uv: impl Into<[R; 2]>) -> SlopeMoments<R> {
        let corners = self.corners(level, uv.into());
        let (shares, _) = self.by_weight(corners.shares, |k| self.weight_of(&corners, k));
        self.absolute(gathered(&corners.texels, &shares))
    }

    /// Moments at `uv` between levels: [`MomentMap::bilinear`] on the two around `lod`, merged by
    /// its fraction.
    ///
    /// `lod` 0 is the map, 1 the level of half its size; it is kept between the first and the last
    /// level, NaN counts as 0.
    ///
    /// ```
    /// use lobe::material::lean::{Border, MomentMap};
    /// let map = MomentMap::from_slopes([2, 1], vec![[0.0_f64, 0.0], [1.0, 0.0]], Border::Wrap)?;
    /// assert_eq!(map.trilinear([0.25, 0.5], -3.0).mean(), [0.0, 0.0]);
    /// assert_eq!(map.trilinear([0.25, 0.5], 0.5).mean(), [0.25, 0.0]);
    /// assert_eq!(map.trilinear([0.25, 0.5], 9.0).mean(), [0.5, 0.0]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn trilinear(&self, uv: impl Into<[R; 2]>, lod: R) -> SlopeMoments<R> {
        let (level, share) = self.levels_around(lod);
        self.absolute(self.between_levels(uv.into(), level, share).0)
    }

    /// The level below a level of detail, and how far it is to the next, in [0, 1).
    #[inline]
    fn levels_around(&self, lod: R) -> (usize, R) {
        let last = R::lit((self.levels() - 1) as f64);
        let (level, share) = floor(lod.max(R::ZERO).min(last));
        (usize::try_from(level).unwrap_or_default(), share)
    }

    /// A level and the next by its share; the mean is relative to the map's origin. Their weight,
    /// too.
    fn between_levels(&self, uv: [R; 2], level: usize, share: R) -> (SlopeMoments<R>, R) {
        let fine = self.corners(level, uv);
        if share == R::ZERO {
            let (shares, weight) = self.by_weight(fine.shares, |k| self.weight_of(&fine, k));
            return (gathered(&fine.texels, &shares), weight);
        }
        let coarse = self.corners(level + 1, uv);
        let of = |k: usize| if k < 4 { (&fine, k) } else { (&coarse, k - 4) };
        let shares: [R; 8] = core::array::from_fn(|k| {
            let (corners, at) = of(k);
            corners.shares[at] * if k < 4 { R::ONE - share } else { share }
        });
        let texels: [_; 8] = core::array::from_fn(|k| of(k).0.texels[of(k).1]);
        let (shares, weight) = self.by_weight(shares, |k| self.weight_of(of(k).0, of(k).1));
        (gathered(&texels, &shares), weight)
    }

    /// Moments of a footprint: its center and the steps `du`, `dv` of its sides in uv, a pixel
    /// apart.
    ///
    /// Trilinear probes along the longer side, `most` and one at the most (counted within 1 and
    /// 1024), all merged, so what lies between them counts. They are as wide as the shorter side,
    /// or as it takes to span the longer one: a bilinear lookup has, in the mean over its phases,
    /// three times the variance of a texel, so texels are $1/\sqrt 3$ as wide as a probe; levels
    /// are mixed to the variance between theirs; and the probes' places have the variance that is
    /// left of the longer side's. On an even slope the whole has that of the footprint, where
    /// hardware's filter has three to four times as much. No probe is narrower than a texel, which
    /// a lookup of the finest level widens to $\sqrt 3$ of them.
    ///
    /// ```
    /// use lobe::material::lean::{Border, MomentMap};
    /// let slopes = (0..64).map(|k| [if k % 8 < 4 { 1.0_f64 } else { 0.0 }, 0.0]).collect();
    /// let map = MomentMap::from_slopes([8, 8], slopes, Border::Wrap)?;
    /// // Long across the step, and long along it.
    /// let across = map.anisotropic([0.5, 0.5], [1.0, 0.0], [0.0, 0.125], 8);
    /// let along = map.anisotropic([0.25, 0.5], [0.125, 0.0], [0.0, 1.0], 8);
    /// assert!(across.covariance().trace() > 0.2 && along.covariance().trace() < 0.01);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn anisotropic(
        &self,
        uv: impl Into<[R; 2]>,
        du: [R; 2],
        dv: [R; 2],
        most: usize,
    ) -> SlopeMoments<R> {
        let [u, v] = uv.into();
        let [width, height] = self.size(0).map(|n| R::lit(n as f64));
        let texels = |d: [R; 2]| {
            let (x, y) = (d[0] * width, d[1] * height);
            (x * x + y * y).sqrt().min(R::LARGEST)
        };
        let (a, b) = (texels(du), texels(dv));
        let (long, short, side) = if a >= b { (a, b, du) } else { (b, a, dv) };
        let most = R::lit(most.clamp(1, MOST_PROBES) as f64);
        // A probe's side, in texels and one at least; of the longer side what places make up for.
        let probe = short.max(long / most).max(R::ONE);
        let spread = ((long - probe) * (long + probe)).max(R::ZERO).sqrt();
        let (whole, rest) = floor((spread / probe).min(most));
        let count = 1 + whole + i64::from(rest > R::ZERO);
        let log_two = R::lit(core::f64::consts::LN_2);
        let (level, between) =
            self.levels_around((probe * R::lit(INVERSE_ROOT_THREE)).ln() / log_two);
        // Texels of levels differ fourfold in variance: the share at which the mixture has the
        // probe's.
        let share = ((between * R::TWO * log_two).exp() - R::ONE) / R::lit(3.0);
        // Places n - 1 distances apart have the variance (n^2 - 1)/12 of one.
        let n = R::lit(count as f64);
        let reach = spread / (long * ((n - R::ONE) * (n + R::ONE)).sqrt()).max(R::MIN_POSITIVE);
        let at = |k: i64| {
            let t = (R::lit(k as f64) - R::HALF * (n - R::ONE)) * reach;
            self.between_levels([u + t * side[0], v + t * side[1]], level, share)
        };
        let (mut sum, mut total) = at(0);
        for k in 1..count {
            let (probe, weight) = at(k);
            // As long as no probe has weight, all count the same; the first one with weight
            // replaces them.
            let (own, all) = if total + weight > R::ZERO {
                (weight, total + weight)
            } else {
                (R::ONE, R::lit((k + 1) as f64))
            };
            let share = own / all;
            sum = sum.shared(R::ONE - share, &probe, share);
            total = total + weight;
        }
        self.absolute(sum)
    }

    /// The four texels around a point of a level.
    #[inline]
    fn corners(&self, level: usize, [u, v]: [R; 2]) -> Corners<R> {
        let [width, height] = self.size(level);
        let ([left, right], x) = self.around(u, width);
        let ([above, below], y) = self.around(v, height);
        let places = [[left, above], [right, above], [left, below], [right, below]];
        let (p, q) = (R::ONE - x, R::ONE - y);
        Corners {
            level,
            texels: places.map(|[column, row]| self.relative(level, column, row)),
            shares: [p * q, x * q, p * y, x * y],
            places,
        }
    }

    /// The weight of the `k`th corner.
    fn weight_of(&self, corners: &Corners<R>, k: usize) -> R {
        let [column, row] = corners.places[k];
        self.weight(corners.level, column, row)
    }

    /// The two texels around a coordinate along one axis, and the share of the second.
    #[inline]
    fn around(&self, u: R, count: usize) -> ([usize; 2], R) {
        let x = u * R::lit(count as f64);
        let x = if x.abs() <= R::LARGEST { x } else { R::ZERO };
        let (first, fraction) = floor(x - R::HALF);
        let count = i64::try_from(count).unwrap_or(i64::MAX);
        let (first, second) = match self.border() {
            Border::Wrap => {
                let first =
                    if (0..count).contains(&first) { first } else { first.rem_euclid(count) };
                (first, if first + 1 == count { 0 } else { first + 1 })
            }
            Border::Clamp => (first.clamp(0, count - 1), (first + 1).clamp(0, count - 1)),
        };
        ([first, second].map(|k| usize::try_from(k).unwrap_or_default()), fraction)
    }
}

/// The next whole number from below, and what is left, in [0, 1). For magnitudes of up to about
/// $10^9$.
fn floor<R: Real>(x: R) -> (i64, R) {
    // `as` towards zero; of negative fractions that is one too many.
    let towards_zero = x.to_f64() as i64;
    let whole = towards_zero - i64::from(R::lit(towards_zero as f64) > x);
    (whole, x - R::lit(whole as f64))
}
