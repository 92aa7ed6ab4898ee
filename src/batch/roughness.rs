//! Maps of roughness under maps of footprints.
//!
//! Layer 5.

use super::columns::Columns;
use super::fill::{fill, fill_one_by_one};
use crate::error::Error;
use crate::filter::{DiskKernel, Kernel, PixelFilter};
use crate::scalar::Real;
use crate::slope::{Footprint, Roughness};

/// Columns of the Cholesky factor of a roughness matrix: `l_xx`, `l_yx` and `l_yy`.
pub type Factors<'a, R> = [&'a mut [R]; 3];

/// [`Roughness::widened`] of every element, as the columns that
/// [`Anisotropic`](super::Anisotropic) reads.
///
/// `shapes` are columns of roughness, or of shapes that have one: alphas by
/// [`Isotropic`](super::Isotropic), say.
///
/// # Errors
/// [`Error::Length`] unless all columns have one length; nothing is then written.
///
/// ```
/// use lobe::batch::{Anisotropic, Fixed, Footprint, Ggx, Isotropic, widened};
/// use lobe::PixelFilter;
/// let (alphas, x): ([f32; 2], [f32; 2]) = ([0.1, 0.2], [0.3, 0.0]);
/// let footprints = Footprint { u: [&x[..], &[0.0; 2]], v: [&[0.0; 2][..], &[0.0; 2]] };
/// let (mut l_xx, mut l_yx, mut l_yy) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let out = [&mut l_xx[..], &mut l_yx, &mut l_yy];
/// widened(Isotropic(&alphas[..]), footprints, PixelFilter::BOX, out)?;
/// assert!((l_xx[0] - (0.01_f32 + 0.015).sqrt()).abs() < 1e-7 && l_yy == [0.1, 0.2]);
/// // Shaded later, for as many lights as there are.
/// let mut brdf = [0.0; 2];
/// let (wo, wi) = (Fixed([0.6, 0.0, 0.8]), Fixed([-0.6, 0.0, 0.8]));
/// Ggx::new(Anisotropic([&l_xx[..], &l_yx, &l_yy])).brdf(wo, wi, &mut brdf)?;
/// assert!(brdf[0] > brdf[1]);
/// # Ok::<(), lobe::Error>(())
/// ```
pub fn widened<R: Real, S: Columns<Item: Into<Roughness<R>>>>(
    shapes: S,
    footprints: impl Columns<Item = Footprint<R>>,
    filter: PixelFilter,
    out: Factors<'_, R>,
) -> Result<(), Error> {
    fill(
        (shapes, footprints),
        out,
        #[inline(always)]
        |(shape, footprint)| {
            let roughness: Roughness<R> = shape.into();
            roughness.widened(&Kernel::of(&footprint, filter)).matrix().cholesky()
        },
    )
}

/// [`Roughness::peak_fitted`] of every element, in the columns of [`widened`].
///
/// # Errors
/// As [`widened`].
pub fn peak_fitted<R: Real, S: Columns<Item: Into<Roughness<R>>>>(
    shapes: S,
    footprints: impl Columns<Item = Footprint<R>>,
    filter: PixelFilter,
    out: Factors<'_, R>,
) -> Result<(), Error> {
    fill(
        (shapes, footprints),
        out,
        #[inline(always)]
        |(shape, footprint)| {
            let roughness: Roughness<R> = shape.into();
            roughness.peak_fitted(&Kernel::of(&footprint, filter)).matrix().cholesky()
        },
    )
}

/// [`Roughness::widened_on_disk`] of every element, in the columns of [`widened`], one after the
/// other: it has branches, and is no lanes.
///
/// The sides of a footprint are here derivatives of $(h_x, h_y)$ of the unit half vector, as
/// [`DiskKernel::of`] takes them.
///
/// # Errors
/// As [`widened`].
pub fn widened_on_disk<R: Real, S: Columns<Item: Into<Roughness<R>>>>(
    shapes: S,
    footprints: impl Columns<Item = Footprint<R>>,
    filter: PixelFilter,
    out: Factors<'_, R>,
) -> Result<(), Error> {
    fill_one_by_one((shapes, footprints), out, |(shape, Footprint { u, v })| {
        let roughness: Roughness<R> = shape.into();
        roughness.widened_on_disk(&DiskKernel::of(u, v, filter)).matrix().cholesky()
    })
}
