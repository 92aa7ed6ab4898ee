//! Columns of shapes: of alphas, of factors, around means.
//!
//! Layer 5. Numbers beyond their range count as the nearest in it, as the total constructors of the
//! shapes have it: a batch has no element to refuse.

use super::columns::Columns;
use crate::error::Error;
use crate::scalar::{Psd, Real};
use crate::slope::{self, LobeShape, Roughness};

/// Columns that are made of other columns.
macro_rules! made_of {
    ($($part:tt)*) => {
        #[inline(always)]
        fn check(&self, length: usize) -> Result<(), Error> {
            $(self.$part.check(length)?;)*
            Ok(())
        }
    };
}
pub(super) use made_of;

/// Isotropic shapes of a column of alphas: [`lobe::Isotropic::saturating`](slope::Isotropic).
///
/// ```
/// use lobe::batch::{Fixed, Ggx, Isotropic};
/// let alphas = [0.1_f32, 0.2, f32::NAN];
/// let mut density = [0.0; 3];
/// Ggx::new(Isotropic(alphas.as_slice())).d(Fixed([0.0, 0.0, 1.0]), &mut density)?;
/// assert_eq!(density[1], lobe::Ggx::new(lobe::Isotropic::new(0.2)?).d([0.0, 0.0, 1.0]));
/// // What is no number counts as a mirror.
/// assert_eq!(density[2], 0.0);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Isotropic<C>(pub C);

impl<R: Real, C: Columns<Item = R>> Columns for Isotropic<C> {
    type Item = slope::Isotropic<R>;

    made_of!(0);
    #[inline(always)]
    fn part(&self, start: usize, length: usize) -> Self {
        Self(self.0.part(start, length))
    }
    #[inline(always)]
    fn at(&self, index: usize) -> Self::Item {
        slope::Isotropic::saturating(self.0.at(index))
    }
}

/// Shapes along the frame's axes, of columns `[alpha_x, alpha_y]`:
/// [`lobe::AxisAligned::saturating`](slope::AxisAligned).
///
/// ```
/// use lobe::batch::{AxisAligned, Beckmann, Fixed};
/// let (along, across): (&[f64], &[f64]) = (&[0.5, 0.3], &[0.05, 0.3]);
/// let mut area = [0.0; 2];
/// let brushed = Beckmann::new(AxisAligned([along, across]));
/// brushed.projected_area(Fixed([1.0, 0.0, 0.0]), &mut area)?;
/// assert!(area[0] > area[1]);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxisAligned<C>(pub C);

impl<R: Real, C: Columns<Item = [R; 2]>> Columns for AxisAligned<C> {
    type Item = slope::AxisAligned<R>;

    made_of!(0);
    #[inline(always)]
    fn part(&self, start: usize, length: usize) -> Self {
        Self(self.0.part(start, length))
    }
    #[inline(always)]
    fn at(&self, index: usize) -> Self::Item {
        let [x, y] = self.0.at(index);
        slope::AxisAligned::saturating(x, y)
    }
}

/// Shapes of any A, of columns `[l_xx, l_yx, l_yy]` of its Cholesky factor:
/// [`Psd::saturating_cholesky`].
///
/// [`widened`](super::widened) writes such columns.
///
/// ```
/// use lobe::batch::{Anisotropic, Fixed, Ggx};
/// let factor = lobe::Roughness::from_alphas(0.4_f32, 0.1, 0.7)?.matrix().cholesky();
/// let [l_xx, l_yx, l_yy] = factor.map(|x| [x; 2]);
/// let mut density = [0.0; 2];
/// let ggx = Ggx::new(Anisotropic([&l_xx[..], &l_yx, &l_yy]));
/// ggx.slope_pdf(Fixed([0.1, 0.1]), &mut density)?;
/// assert!(density[0] > 0.0 && density[0] == density[1]);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Anisotropic<C>(pub C);

impl<R: Real, C: Columns<Item = [R; 3]>> Columns for Anisotropic<C> {
    type Item = slope::Anisotropic<R>;

    made_of!(0);
    #[inline(always)]
    fn part(&self, start: usize, length: usize) -> Self {
        Self(self.0.part(start, length))
    }
    #[inline(always)]
    fn at(&self, index: usize) -> Self::Item {
        let factor = Psd::saturating_cholesky(self.0.at(index));
        slope::Anisotropic::new(Roughness::from_matrix(factor))
    }
}

/// Shapes moved to means, columns of slopes:
/// [`lobe::NonCentered::saturating`](slope::NonCentered::saturating).
///
/// ```
/// use lobe::batch::{Fixed, Ggx, Isotropic, NonCentered};
/// let (x, y): (&[f64], &[f64]) = (&[0.0, 0.3], &[0.0, 0.0]);
/// let shapes = NonCentered { shapes: Isotropic(Fixed(0.1)), means: [x, y] };
/// let mut density = [0.0; 2];
/// Ggx::new(shapes).slope_pdf(Fixed([0.3, 0.0]), &mut density)?;
/// assert!(density[1] > density[0]);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NonCentered<S, M> {
    /// Shapes around their means.
    pub shapes: S,
    /// The means, slopes.
    pub means: M,
}

impl<S, M> Columns for NonCentered<S, M>
where
    S: Columns<Item: LobeShape>,
    M: Columns<Item = [<S::Item as LobeShape>::Scalar; 2]>,
{
    type Item = slope::NonCentered<S::Item>;

    made_of!(shapes means);
    #[inline(always)]
    fn part(&self, start: usize, length: usize) -> Self {
        Self { shapes: self.shapes.part(start, length), means: self.means.part(start, length) }
    }
    #[inline(always)]
    fn at(&self, index: usize) -> Self::Item {
        slope::NonCentered::saturating(self.shapes.at(index), self.means.at(index))
    }
}
