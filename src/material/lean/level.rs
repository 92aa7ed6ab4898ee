//! A level of a mip chain: how texels of a finer one merge into its own.
//!
//! Layer 4. By the parallel-axis theorem: the mean of the covariances plus the covariance of the
//! means. Every term is positive semi-definite, nothing cancels, and no large square is ever
//! formed.

use crate::scalar::exact::cross;
use crate::scalar::{Psd, Real};
use crate::slope::SlopeMoments;

/// A texel's moments as a level keeps them: mean, entries of the covariance, root of its
/// determinant.
///
/// Plain numbers, as a level of zeros comes from the allocator without a pass over it.
pub(super) type Stored<R> = [R; 6];

#[inline]
pub(super) fn stored<R: Real>(moments: &SlopeMoments<R>) -> Stored<R> {
    let ([x, y], covariance) = (moments.mean(), moments.covariance());
    let [xx, xy, yy] = covariance.entries();
    [x, y, xx, xy, yy, covariance.root_det()]
}

#[inline]
pub(super) fn loaded<R: Real>(&[x, y, xx, xy, yy, root_det]: &Stored<R>) -> SlopeMoments<R> {
    SlopeMoments::unchecked([x, y], Psd::with_root_det([xx, xy, yy], root_det))
}

/// What a level is merged from: the map's slopes, or the level before.
#[derive(Clone, Copy)]
pub(super) enum Finer<'a, R> {
    /// Slopes, and what their means are kept relative to.
    Slopes(&'a [[R; 2]], [R; 2]),
    Moments(&'a [Stored<R>]),
}

/// Half of a side, at least 1.
pub(super) fn halved(size: [usize; 2]) -> [usize; 2] {
    size.map(|n| (n / 2).max(1))
}

/// The finer texels that the `k`-th of `n / 2` covers, from which one on, and their shares of it.
///
/// Of an odd `n = 2 m + 1` each covers 2 + 1/m, three texels in part: a box of its exact extent.
/// Shares are sums of whole numbers over n, so all shares of a finer texel together are the same
/// for each.
pub(super) fn shares<R: Real>(k: usize, n: usize) -> (usize, [R; 3]) {
    let (zero, half) = (R::ZERO, R::HALF);
    if n == 1 {
        return (0, [R::ONE, zero, zero]);
    }
    if n % 2 == 0 {
        return (2 * k, [half, half, zero]);
    }
    let middle = n / 2;
    let share = |part: usize| R::lit(part as f64 / n as f64);
    (2 * k, [share(middle - k), share(middle), share(k + 1)])
}

/// `p - q`.
#[inline]
pub(super) fn minus<R: Real>(p: [R; 2], q: [R; 2]) -> [R; 2] {
    [p[0] - q[0], p[1] - q[1]]
}

/// Four slopes, equally, the mean relative to an origin: two pairs, and the pair of their means.
///
/// The covariance is a sum of three outer products, its determinant by Cauchy and Binet the sum of
/// the squares of their cross products.
#[inline]
fn four<R: Real>([a, b, c, d]: [[R; 2]; 4], origin: [R; 2]) -> SlopeMoments<R> {
    let half = R::HALF;
    let between = |p: [R; 2], v: [R; 2]| [p[0] + half * v[0], p[1] + half * v[1]];
    let (first, second) = (minus(b, a), minus(d, c));
    let (p, q) = (between(minus(a, origin), first), between(minus(c, origin), second));
    let third = minus(q, p);
    // Variances 1/8, 1/8 and 1/4 of the differences' squares.
    let (pair, pairs) = (R::lit(0.125), R::lit(0.25));
    let entry = |i: usize, k: usize| {
        (first[i] * first[k] + second[i] * second[k]) * pair + third[i] * third[k] * pairs
    };
    let (u, v, w) = (cross(first, second), cross(first, third), cross(second, third));
    let det = u * u * (pair * pair) + (v * v + w * w) * (pair * pairs);
    let covariance = Psd::with_root_det([entry(0, 0), entry(0, 1), entry(1, 1)], det.sqrt());
    SlopeMoments::unchecked(between(p, third), covariance)
}

/// Four moments, equally: the mean of their covariances and the covariance of their means.
#[inline]
fn four_moments<R: Real>(four_stored: [&Stored<R>; 4]) -> SlopeMoments<R> {
    let [a, b, c, d] = four_stored.map(loaded);
    let between = four([a.mean(), b.mean(), c.mean(), d.mean()], [R::ZERO; 2]);
    let pair = |p: &SlopeMoments<R>, q: &SlopeMoments<R>| p.covariance() + q.covariance();
    let within = (pair(&a, &b) + pair(&c, &d)) * R::lit(0.25);
    SlopeMoments::unchecked(between.mean(), within + between.covariance())
}

/// The texels of two rows, four by four.
fn blocks<T>(rows: &[T], width: usize) -> impl Iterator<Item = [&T; 4]> {
    let (above, below) = rows.split_at(width);
    let pairs = above.chunks_exact(2).zip(below.chunks_exact(2));
    pairs.map(|(above, below)| [&above[0], &above[1], &below[0], &below[1]])
}

impl<R: Real> Finer<'_, R> {
    /// A texel's moments.
    #[inline]
    pub(super) fn at(&self, place: usize) -> SlopeMoments<R> {
        match self {
            Self::Slopes(slopes, origin) => {
                SlopeMoments::unchecked(minus(slopes[place], *origin), Psd::zero())
            }
            Self::Moments(moments) => loaded(&moments[place]),
        }
    }

    /// Rows from `first` on of the next level, as many as fit into `out`; `size` is the finer
    /// one's.
    pub(super) fn merge_rows(&self, size: [usize; 2], first: usize, out: &mut [Stored<R>]) {
        let [width, height] = size;
        let [columns, _] = halved(size);
        let even = width % 2 == 0 && height % 2 == 0;
        for (row, out) in (first..).zip(out.chunks_exact_mut(columns)) {
            let rows = 2 * row * width..2 * (row + 1) * width;
            match self {
                Self::Slopes(slopes, origin) if even => {
                    for (out, block) in out.iter_mut().zip(blocks(&slopes[rows], width)) {
                        *out = stored(&four(block.map(|slope| *slope), *origin));
                    }
                }
                Self::Moments(moments) if even => {
                    for (out, block) in out.iter_mut().zip(blocks(&moments[rows], width)) {
                        *out = stored(&four_moments(block));
                    }
                }
                _ => self.merge_row(size, row, out),
            }
        }
    }

    /// A row of the next level, whatever the size: up to nine texels by their shares.
    fn merge_row(&self, size: [usize; 2], row: usize, out: &mut [Stored<R>]) {
        for (column, out) in out.iter_mut().enumerate() {
            let Block { places, shares } = Block::of(size, column, row);
            *out = stored(&gathered(&places.map(|place| self.at(place)), &shares));
        }
    }
}

/// The up to nine texels of a finer level that one of the next covers, and their shares of it.
pub(super) struct Block<R> {
    pub(super) places: [usize; 9],
    pub(super) shares: [R; 9],
}

impl<R: Real> Block<R> {
    /// The finer texels under the next level's texel in this column and row; `size` is the finer
    /// level's.
    #[inline]
    pub(super) fn of([width, height]: [usize; 2], column: usize, row: usize) -> Self {
        let (top, down) = shares::<R>(row, height);
        let (left, right) = shares::<R>(column, width);
        // Where a share is 0, there may be no texel: the first stands for it.
        let place = |k: usize, shares: &[R; 3]| if shares[k] > R::ZERO { k } else { 0 };
        Self {
            places: core::array::from_fn(|k| {
                (top + place(k / 3, &down)) * width + left + place(k % 3, &right)
            }),
            shares: core::array::from_fn(|k| down[k / 3] * right[k % 3]),
        }
    }
}

/// Moments merged by shares, not negative and with sum 1.
///
/// Two passes: the mean first, then all differences from it, so nothing cancels. The entries' own
/// determinant is good to the rounding of their product; where that says nothing, Minkowski's bound
/// does: the root of a sum's determinant is at least the sum of the roots.
#[inline]
pub(super) fn gathered<R: Real, const N: usize>(
    moments: &[SlopeMoments<R>; N],
    shares: &[R; N],
) -> SlopeMoments<R> {
    let origin = moments[0].mean();
    let (mut x, mut y) = (R::ZERO, R::ZERO);
    for (patch, &share) in moments.iter().zip(shares) {
        let [p, q] = minus(patch.mean(), origin);
        x = x + share * p;
        y = y + share * q;
    }
    let mean = [origin[0] + x, origin[1] + y];
    let (mut entries, mut least) = ([R::ZERO; 3], R::ZERO);
    for (patch, &share) in moments.iter().zip(shares) {
        let ([p, q], [xx, xy, yy]) = (minus(patch.mean(), mean), patch.covariance().entries());
        entries[0] = entries[0] + share * (xx + p * p);
        entries[1] = entries[1] + share * (xy + p * q);
        entries[2] = entries[2] + share * (yy + q * q);
        least = least + share * patch.covariance().root_det();
    }
    let own = Psd::from_entries(entries[0], entries[1], entries[2]);
    let covariance = Psd::with_root_det(entries, own.root_det().max(least));
    SlopeMoments::unchecked(mean, covariance)
}
