//! The plane of a dictionary's marginals: slopes without roughness.
//!
//! Layer 4.

use super::cells::Facets;
use super::dictionary::Dictionary;
use super::pieces::Pieces;
use crate::filter::Kernel;
use crate::scalar::{Psd, Real};
use crate::slope::{Footprint, Roughness};

/// Slopes in deviations of a roughness, $M^{-1} s$, and what filters them there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane<R> {
    /// Chermain's matrix: its upper row, and the last entry.
    mapping: [R; 3],
    /// One over its determinant.
    density: R,
    pieces: Pieces<R>,
    /// Instead of them, derivatives for mips.
    mips: Option<[[R; 2]; 2]>,
}

/// A lobe counts as no narrower than this share of its kernel's deviation, a power of two: a
/// thousandth of it no pixel shows, and f32 can still count the pieces.
const SHARE: i32 = -10;

/// Deviations below this count as this.
const LEAST: f64 = 1e-9;

impl<R: Real> Plane<R> {
    #[inline]
    pub(super) fn new(
        roughness: &Roughness<R>,
        kernel: &Kernel<R>,
        mips: Option<Footprint<R>>,
    ) -> Self {
        // Mips take the place of kernels.
        let kernel = if mips.is_some() { Kernel::default() } else { *kernel };
        let [[a, b], [_, c]] = roughness.chermain_matrix(R::ONE);
        let root = R::HALF.sqrt();
        let [k, l] = kernel.added().map(|column| column.map(|x| x * root));
        // No narrower than the kernel allows: along y, and along x less what goes with y.
        let (least, share) = (R::lit(LEAST), R::power_of_two(SHARE));
        let c = c.max(least).max(share * (k[1] * k[1] + l[1] * l[1]).sqrt());
        let lean = b / c;
        let (p, q) = (k[0] - lean * k[1], l[0] - lean * l[1]);
        let a = a.max(least).max(share * (p * p + q * q).sqrt());
        let mapping = [a, b, c];
        let density = R::ONE / (a * c);
        // M^-1 K M^-T by the columns of a root of K.
        let column = |v| deviations(mapping, v).map(|x| x.max(-R::LARGEST).min(R::LARGEST));
        // Whitening cancels; the determinant is the kernel's own over that of the mapping.
        let root_det = (k[0] * l[1] - k[1] * l[0]).abs() * density;
        let kernel = Psd::outer_sum_with_root_det(column(k), column(l), root_det.min(R::MAX));
        let mips = mips.map(|Footprint { u, v }| [u, v].map(|d| deviations(mapping, d)));
        Self { mapping, density, pieces: Pieces::of(&kernel), mips }
    }

    /// The slope of a point in deviations.
    #[inline]
    pub(super) fn slope(&self, [x, y]: [R; 2]) -> [R; 2] {
        let [a, b, c] = self.mapping;
        [a * x + b * y, c * y]
    }

    /// The kernel, around the middle.
    #[inline]
    pub(super) const fn pieces(&self) -> &Pieces<R> {
        &self.pieces
    }

    /// The same around a slope, and that in deviations, or the one opposite, where the density is
    /// the same.
    #[inline]
    pub(super) fn around(&self, slope: [R; 2]) -> (Self, [R; 2]) {
        let point = self.pieces.folded(deviations(self.mapping, slope));
        (Self { pieces: self.pieces.around(point), ..*self }, point)
    }

    /// A cell's density of slopes at the point that the kernel is laid around.
    #[inline]
    pub(super) fn density(
        &self,
        dictionary: &Dictionary<R>,
        [x, y]: [R; 2],
        facets: &Facets<R>,
    ) -> R {
        let [cos, sin] = facets.turn;
        let turned = |[x, y]: [R; 2]| [cos * x + sin * y, cos * y - sin * x];
        let [first, second] =
            facets.marginals.map(|index| dictionary.marginal(index, facets.level));
        if let Some(mips) = self.mips {
            let [u, v] = mips.map(turned);
            let [along, across] = [0, 1].map(|k| u[k].abs().max(v[k].abs()));
            let [x, y] = turned([x, y]);
            return first.mip_mean(x, along) * second.mip_mean(y, across) * self.density;
        }
        let mut sum = R::ZERO;
        for k in self.pieces.first..=self.pieces.last {
            let piece = self.pieces.piece(k);
            let [along, across] = piece.widths(facets.turn);
            let [x, y] = turned([x + piece.offset[0], y + piece.offset[1]]);
            let p = first.mean(x, along);
            if p > R::ZERO {
                sum = sum + piece.share * (p * second.mean(y, across));
            }
        }
        sum * self.density
    }
}

/// $M^{-1} s$, of the matrix's upper row and last entry.
#[inline]
fn deviations<R: Real>([a, b, c]: [R; 3], [x, y]: [R; 2]) -> [R; 2] {
    let y = y / c;
    [(x - b * y) / a, y]
}
