//! Columns of lobes of raw moments: what a sampler reads of a LEAN map, as shapes.
//!
//! Layer 5.

use super::columns::Columns;
use super::shape::made_of;
use crate::error::Error;
use crate::scalar::Real;
use crate::slope::{self, Roughness};

/// Lobes of raw moments over a base material: mean slope and $A = A_{base} + 2\Sigma$.
///
/// [`SlopeMoments::saturating_raw`](slope::SlopeMoments::saturating_raw),
/// [`lobe`](slope::SlopeMoments::lobe) and its [`shape`](slope::Lobe::shape). Such columns are
/// shapes as any: [`Ggx`](super::Ggx) shades them, [`Widened`](super::Widened) puts a pixel over
/// them.
///
/// ```
/// use lobe::batch::{Fixed, Ggx, Isotropic, SlopeMoments};
/// // A flat texel, and one of slopes -0.2 and 0.2.
/// let (zero, xx) = ([0.0_f32; 2], [0.0, 0.04]);
/// let shapes = SlopeMoments {
///     means: [&zero[..], &zero],
///     seconds: [&xx[..], &zero, &zero],
///     base: Isotropic(Fixed(0.1)),
/// };
/// let up = Fixed([0.0, 0.0, 1.0]);
/// let mut brdf = [0.0; 2];
/// Ggx::new(shapes).brdf(up, up, &mut brdf)?;
/// assert!(brdf[1] < 0.4 * brdf[0]);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlopeMoments<M, E, B> {
    /// Mean slopes.
    pub means: M,
    /// Raw second moments xx, xy and yy.
    pub seconds: E,
    /// Roughness of the base material, or shapes that have one.
    pub base: B,
}

impl<R, M, E, B> Columns for SlopeMoments<M, E, B>
where
    R: Real,
    M: Columns<Item = [R; 2]>,
    E: Columns<Item = [R; 3]>,
    B: Columns<Item: Into<Roughness<R>>>,
{
    type Item = slope::NonCentered<slope::Anisotropic<R>>;

    made_of!(means seconds base);
    #[inline(always)]
    fn part(&self, start: usize, length: usize) -> Self {
        Self {
            means: self.means.part(start, length),
            seconds: self.seconds.part(start, length),
            base: self.base.part(start, length),
        }
    }
    #[inline(always)]
    fn at(&self, index: usize) -> Self::Item {
        let (mean, second) = (self.means.at(index), self.seconds.at(index));
        let moments = slope::SlopeMoments::saturating_raw(mean, second);
        moments.lobe(self.base.at(index).into()).shape()
    }
}
