//! The cells that a pixel covers, on two levels, and what each of them has drawn.
//!
//! Layer 4.

use super::ellipse::Ellipse;
use super::material::MultiLobe;
use super::recipe::Recipe;
use crate::material::cells::{Cell, finest};
use crate::scalar::Real;
use crate::scalar::hash::{tail, uniform};
use crate::scalar::quantile::normal_quantile;

/// Cells from the tile's corner, as a power of two: beyond it f32 places a pixel within a cell too
/// coarsely for its weights, and in f64 indices end.
const fn farthest<R: Real>() -> i32 {
    if R::SINGLE { 20 } else { 28 }
}

/// The largest quantile that a cell may have.
const QUANTILE: f64 = 6.5;

/// Which cells a pixel covers, and by what rule they draw.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cells<R> {
    ellipse: Ellipse<R>,
    /// Of the finer level, and how far the coarser one has come.
    pub(super) exponent: i32,
    pub(super) coarser: R,
    /// Base 4 logarithm of the facets in a cell of the finer level.
    facets: R,
    variation: R,
    share: R,
    seed: u32,
}

/// What a cell has drawn.
#[derive(Clone, Copy, Debug)]
pub(super) struct Facets<R> {
    pub(super) level: u32,
    /// Of the rotation: cosine and sine.
    pub(super) turn: [R; 2],
    pub(super) marginals: [u32; 2],
}

impl<R: Real> Cells<R> {
    /// Of a material under an ellipse.
    #[inline]
    pub(super) fn new(material: &MultiLobe<R>, ellipse: Ellipse<R>) -> Self {
        let MultiLobe { density, variation, share, seed, .. } = *material;
        let distance = ellipse.uv[0].abs().max(ellipse.uv[1].abs().max(R::ZERO));
        let size = ellipse
            .width
            .max(material.facet_size())
            .max(distance * R::power_of_two(-farthest::<R>()))
            .max(finest(ellipse.tile));
        let size = size.max(R::power_of_two(-100)).min(R::power_of_two(100));
        let exponent = size.exponent();
        let ln_two = R::TWO.ln();
        let coarser = (size * R::power_of_two(-exponent)).ln() / ln_two;
        let coarser = coarser.max(R::ZERO).min(R::ONE);
        let facets = R::HALF * density.ln() / ln_two + R::lit(f64::from(exponent));
        Self { ellipse, exponent, coarser, facets, variation, share, seed }
    }

    /// Whether all of them are beyond the dictionary's last level, whatever their random numbers.
    #[inline]
    pub(super) fn are_smooth(&self, recipe: &Recipe) -> bool {
        self.facets - R::lit(QUANTILE) * self.variation > R::lit(f64::from(recipe.levels))
    }

    /// The mean of `f` over what cells have drawn, by their shares; none: the smooth lobe.
    #[inline]
    pub(super) fn mean(&self, recipe: &Recipe, f: impl Fn(Option<Facets<R>>) -> R) -> R {
        let mut mean = R::ZERO;
        for (step, share) in self.levels() {
            if share > R::ZERO {
                let (mut sum, mut whole) = (R::ZERO, R::ZERO);
                self.level(step, |weight, cell| {
                    sum = sum + weight * f(self.numbers(recipe, cell, step));
                    whole = whole + weight;
                });
                mean = mean + share * (sum / whole.max(R::MIN_POSITIVE));
            }
        }
        mean
    }

    /// What the cell has drawn in which the sum of shares, which is 1 over all, passes `u`; none:
    /// the smooth lobe.
    pub(super) fn chosen(&self, recipe: &Recipe, u: R) -> Option<Facets<R>> {
        let (mut chosen, mut sum) = (None, R::ZERO);
        for (step, share) in self.levels() {
            if share > R::ZERO {
                // Twice over the cells: for the sum of their weights, and with it for their shares.
                let mut whole = R::ZERO;
                self.level(step, |weight, _| whole = whole + weight);
                let share = share / whole.max(R::MIN_POSITIVE);
                self.level(step, |weight, cell| {
                    if chosen.is_none() || sum <= u {
                        chosen = Some((cell, step));
                    }
                    sum = sum + share * weight;
                });
            }
        }
        chosen.and_then(|(cell, step)| self.numbers(recipe, cell, step))
    }

    /// Both levels and their shares.
    #[inline]
    fn levels(&self) -> [(i32, R); 2] {
        [(0, R::ONE - self.coarser), (1, self.coarser)]
    }

    /// Calls `f` with the weight of every cell of a level.
    #[inline]
    fn level(&self, step: i32, mut f: impl FnMut(R, Cell)) {
        let exponent = self.exponent + step;
        let rows = self.ellipse.rows(exponent);
        for t in rows.first..=rows.last {
            let row = rows.row(t);
            for s in row.first..=row.last {
                let weight = row.weight(s);
                if weight > R::ZERO {
                    f(weight, Cell::at(rows.index(s, t), exponent, self.seed));
                }
            }
        }
    }

    /// What a cell has drawn; none: the smooth lobe.
    #[inline]
    fn numbers(&self, recipe: &Recipe, cell: Cell, step: i32) -> Option<Facets<R>> {
        let [area, level, turn, pair] = cell.words();
        let deviation = self.variation * normal_quantile(tail::<R>(level));
        let mean = self.facets + R::lit(f64::from(step));
        // Rounded by chance, with bits that the turn leaves: numbers between powers of 4 have their
        // share of both.
        let rounding = R::lit(f64::from(turn & 0xff)) * R::power_of_two(-8);
        let level = (mean + deviation + rounding).floor().max(0).unsigned_abs();
        if level >= recipe.levels || tail::<R>(area) > self.share {
            return None;
        }
        let pick = |word: u32| ((word & 0xffff) * recipe.marginals) >> 16;
        Some(Facets { level, turn: quarter_turn(turn), marginals: [pick(pair >> 16), pick(pair)] })
    }
}

/// $\tan(\pi u/4)/u$ in $u^2$, u from 0 to 1.
///
/// Maximal relative error: 3.21e-6 (2^-18.25), at u = 0.6583. Fitted by `tests/golden/fit.py`,
/// `fit_half_turn("half_turn", ...)`.
const HALF_TURN: [f32; 5] =
    [0.785_400_6, 0.161_368_18, 0.040_797_774, 7.447_305e-3, 4.982_918_5e-3];

/// Cosine and sine of a random angle from 0 to a quarter turn, as much as products of even
/// marginals tell apart.
///
/// By the tangent of half of it, so that their squares sum to 1 whatever that tangent's error.
#[inline]
fn quarter_turn<R: Real>(word: u32) -> [R; 2] {
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
