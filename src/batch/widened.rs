//! Columns of shapes under columns of footprints, by each way to widen a lobe.
//!
//! Layer 5.

use super::columns::Columns;
use super::shape::made_of;
use crate::error::Error;
use crate::filter::{DiskKernel, Kernel, PixelFilter};
use crate::scalar::Real;
use crate::slope::{self, LobeShape};

/// Footprints of columns of their two sides: [`lobe::Footprint::from_slopes`](slope::Footprint).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footprint<C> {
    /// Derivatives along the pixel's first axis.
    pub u: C,
    /// Derivatives along its second axis.
    pub v: C,
}

impl<R: Real, C: Columns<Item = [R; 2]>> Columns for Footprint<C> {
    type Item = slope::Footprint<R>;

    made_of!(u v);
    #[inline(always)]
    fn part(&self, start: usize, length: usize) -> Self {
        Self { u: self.u.part(start, length), v: self.v.part(start, length) }
    }
    #[inline(always)]
    fn at(&self, index: usize) -> Self::Item {
        slope::Footprint { u: self.u.at(index), v: self.v.at(index) }
    }
}

/// Shapes under the Gaussian kernels of footprints, by variance addition: [`Kernel::widen`].
///
/// Exact for Beckmann.
///
/// ```
/// use lobe::PixelFilter;
/// use lobe::batch::{Fixed, Footprint, Ggx, Isotropic, Widened};
/// let (alpha, x): ([f32; 2], [f32; 2]) = ([0.1, 0.1], [0.0, 0.2]);
/// let footprints = Footprint { u: [&x[..], &[0.0; 2]], v: [&[0.0; 2][..], &x] };
/// let shapes = Widened { shapes: Isotropic(&alpha[..]), footprints, filter: PixelFilter::BOX };
/// let (wo, wi) = (Fixed([0.6, 0.0, 0.8]), Fixed([-0.6, 0.0, 0.8]));
/// let mut brdf = [0.0; 2];
/// Ggx::new(shapes).brdf(wo, wi, &mut brdf)?;
/// assert!(brdf[0] > brdf[1]);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Widened<S, F> {
    /// Shapes before a pixel sees them.
    pub shapes: S,
    /// What pixels cover.
    pub footprints: F,
    /// The pixel filter, one for all.
    pub filter: PixelFilter,
}

/// Shapes under the Gaussian kernels of footprints, with the peak of GGX there:
/// [`Kernel::widen_to_peak`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WidenedToPeak<S, F> {
    /// Shapes before a pixel sees them.
    pub shapes: S,
    /// What pixels cover.
    pub footprints: F,
    /// The pixel filter, one for all.
    pub filter: PixelFilter,
}

/// Isotropic GGX under kernels on the projected disk: [`DiskKernel::widen`].
///
/// The sides of a footprint are here derivatives of $(h_x, h_y)$ of the unit half vector, as
/// [`DiskKernel::of`] takes them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WidenedOnDisk<S, F> {
    /// Shapes before a pixel sees them.
    pub shapes: S,
    /// What pixels cover of the disk.
    pub footprints: F,
    /// The pixel filter, one for all.
    pub filter: PixelFilter,
}

/// The columns of shapes under kernels of slopes, by what becomes of one shape.
macro_rules! under_kernels {
    ($name:ident, $widen:ident) => {
        impl<R, S, F> Columns for $name<S, F>
        where
            R: Real,
            S: Columns<Item: LobeShape<Scalar = R>>,
            F: Columns<Item = slope::Footprint<R>>,
        {
            type Item = slope::Widened<S::Item>;

            made_of!(shapes footprints);
            #[inline(always)]
            fn part(&self, start: usize, length: usize) -> Self {
                let shapes = self.shapes.part(start, length);
                Self { shapes, footprints: self.footprints.part(start, length), ..*self }
            }
            #[inline(always)]
            fn at(&self, index: usize) -> Self::Item {
                let kernel = Kernel::of(&self.footprints.at(index), self.filter);
                kernel.$widen(self.shapes.at(index))
            }
        }
    };
}

under_kernels!(Widened, widen);
under_kernels!(WidenedToPeak, widen_to_peak);

impl<R, S, F> Columns for WidenedOnDisk<S, F>
where
    R: Real,
    S: Columns<Item = slope::Isotropic<R>>,
    F: Columns<Item = slope::Footprint<R>>,
{
    type Item = slope::Widened<slope::Isotropic<R>>;

    made_of!(shapes footprints);
    #[inline(always)]
    fn part(&self, start: usize, length: usize) -> Self {
        let shapes = self.shapes.part(start, length);
        Self { shapes, footprints: self.footprints.part(start, length), ..*self }
    }
    #[inline(always)]
    fn at(&self, index: usize) -> Self::Item {
        let slope::Footprint { u, v } = self.footprints.at(index);
        DiskKernel::of(u, v, self.filter).widen(self.shapes.at(index))
    }
}
