//! Merges of a map's texels by weights: a mip chain that counts covered texels only.
//!
//! Layer 4. The parallel-axis theorem again: $\mu = \sum w_i \mu_i / \sum w_i$, $\Sigma = \sum w_i
//! (\Sigma_i + (\mu_i - \mu)(\mu_i - \mu)^T) / \sum w_i$.

use super::level::{Block, Finer, Stored, gathered, halved, stored};
use crate::scalar::Real;
use alloc::vec;
use alloc::vec::Vec;

/// Shares times weights, brought to sum 1, and their sum before; none if no weight counts.
pub(super) fn weighed<R: Real, const N: usize>(
    shares: &[R; N],
    weights: &[R; N],
) -> Option<([R; N], R)> {
    let weighted: [R; N] = core::array::from_fn(|k| shares[k] * weights[k]);
    let total = total(&weighted);
    (total > R::ZERO).then(|| (weighted.map(|share| share / total), total))
}

/// The sum of shares times weights; 0 where it is too small to divide by.
fn total<R: Real>(weighted: &[R]) -> R {
    let total = weighted.iter().fold(R::ZERO, |sum, &share| sum + share);
    // Quotients by a smaller total would lose digits to underflow.
    if total * R::EPSILON >= R::MIN_POSITIVE { total } else { R::ZERO }
}

/// The weights of the next level: above 0 where [`merge_rows`] makes moments, and 0 elsewhere.
pub(super) fn coarser<R: Real>(weights: &[R], size: [usize; 2]) -> Vec<R> {
    let [columns, rows] = halved(size);
    let mut coarse = vec![R::ZERO; columns * rows];
    for (place, out) in coarse.iter_mut().enumerate() {
        let Block { places, shares } = Block::<R>::of(size, place % columns, place / columns);
        let weighted: [R; 9] = core::array::from_fn(|k| shares[k] * weights[places[k]]);
        *out = total(&weighted);
    }
    coarse
}

/// Rows from `first` on of the next level by weights, as many as fit into `out`; `size` is the
/// finer one's. Texels without weight stay as they are.
pub(super) fn merge_rows<R: Real>(
    finer: &Finer<'_, R>,
    weights: &[R],
    size: [usize; 2],
    first: usize,
    out: &mut [Stored<R>],
) {
    let [columns, _] = halved(size);
    for (place, out) in (first * columns..).zip(out) {
        let Block { places, shares } = Block::<R>::of(size, place % columns, place / columns);
        let own = places.map(|place| weights[place]);
        let Some((mut shares, _)) = weighed(&shares, &own) else { continue };
        let heaviest = (0..9).fold(0, |best, k| if shares[k] > shares[best] { k } else { best });
        // The heaviest texel comes first, as `gathered` takes means relative to the first one. It
        // also stands in for texels without weight, whose slopes may be anything.
        shares.swap(0, heaviest);
        let mut places =
            places.map(|place| if weights[place] > R::ZERO { place } else { places[heaviest] });
        places.swap(0, heaviest);
        let texels = places.map(|place| finer.at(place));
        *out = stored(&gathered(&texels, &shares));
    }
}
