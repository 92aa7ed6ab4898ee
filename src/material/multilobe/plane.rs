//! The plane of a dictionary's marginals: slopes without roughness.
//!
//! Floor 4.

use super::dictionary::Dictionary;
use super::pieces::Pieces;
use crate::filter::Kernel;
use crate::scalar::hash::uniform;
use crate::scalar::{Psd, Real};
use crate::slope::{Footprint, Roughness};

/// Slopes in deviations of a roughness, $M^{-1} s$, and what filters them there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane<R> {
    /// Chermain's matrix: its upper row, and the last entry.
    matrix: [R; 3],
    /// One over its determinant.
    density: R,
    pieces: Pieces<R>,
    /// Instead of it, derivatives for mips.
    mips: Option<[[R; 2]; 2]>,
}

/// A cell's own numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facets<R> {
    pub(super) level: u32,
    /// Of the rotation: cosine and sine.
    pub(super) turn: [R; 2],
    pub(super) marginals: [u32; 2],
}

/// Deviations below this count as this: a lobe of no width has no plane.
const LEAST: f64 = 1e-9;

impl<R: Real> Plane<R> {
    #[inline]
    pub(super) fn new(
        roughness: &Roughness<R>,
        kernel: &Kernel<R>,
        mips: Option<Footprint<R>>,
    ) -> Self {
        let [[a, b], [_, c]] = roughness.chermain_matrix(R::ONE);
        let least = R::lit(LEAST);
        let (a, c) = (a.max(least), c.max(least));
        let matrix = [a, b, c];
        let density = R::ONE / (a * c);
        // M^-1 K M^-T by the columns of a root of K.
        let [l, m, n] = kernel.covariance().cholesky();
        let column = |v| deviations(matrix, v).map(|x| x.max(-R::LARGEST).min(R::LARGEST));
        let kernel = Psd::outer_sum(column([l, m]), column([R::ZERO, n]));
        let mips = mips.map(|Footprint { u, v }| [u, v].map(|d| deviations(matrix, d)));
        Self { matrix, density, pieces: Pieces::of(&kernel), mips }
    }

    /// A slope in deviations.
    #[inline]
    pub(super) fn point(&self, slope: [R; 2]) -> [R; 2] {
        deviations(self.matrix, slope)
    }

    /// The slope of a point in deviations.
    #[inline]
    pub(super) fn slope(&self, [x, y]: [R; 2]) -> [R; 2] {
        let [a, b, c] = self.matrix;
        [a * x + b * y, c * y]
    }

    /// The kernel, around the middle.
    #[inline]
    pub(super) fn pieces(&self) -> &Pieces<R> {
        &self.pieces
    }

    /// The same around a point, in deviations.
    #[inline]
    pub(super) fn around(&self, point: [R; 2]) -> Self {
        Self { pieces: self.pieces.around(point), ..*self }
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

/// $\tan(\pi u/4)/u$ in $u^2$, u from 0 to 1.
///
/// Maximal relative error: 3.21e-6 (2^-18.25), at u = 0.6583. Fitted by `tests/golden/fit.py`, `fit_half_turn("half_turn", ...)`.
const HALF_TURN: [f32; 5] =
    [0.785_400_6, 0.161_368_18, 0.040_797_774, 7.447_305e-3, 4.982_918_5e-3];

/// Cosine and sine of a random angle from 0 to a quarter turn, as much as products of even marginals tell apart.
///
/// By the tangent of half of it, so that their squares sum to 1 whatever that tangent's error.
#[inline]
pub(super) fn quarter_turn<R: Real>(word: u32) -> [R; 2] {
    let u = uniform::<R>(word);
    let v = u * u;
    let mut t = R::ZERO;
    for c in HALF_TURN.iter().rev() {
        t = t * v + R::lit(f64::from(*c));
    }
    let t = t * u;
    let scale = R::ONE / (R::ONE + t * t);
    [(R::ONE - t * t) * scale, R::TWO * t * scale]
}
