//! Filtered alphas of a whole G-buffer, from the change of its normals.
//!
//! Layer 5.

use super::columns::Columns;
use super::fill::fill;
use crate::error::Error;
use crate::filter::{PixelFilter, deferred};
use crate::scalar::Real;
use crate::slope::{Footprint, Isotropic};

/// [`tokuyoshi_deferred_alpha`](crate::filter::tokuyoshi_deferred_alpha) of every element.
///
/// Alphas beyond $[0, 10^9]$ count as the nearest in it, NaN as 0: a batch has no element to
/// refuse.
///
/// # Errors
/// [`Error::Limit`] if the limit is negative or NaN, [`Error::Length`] unless all columns are as
/// long as `out`; nothing is then written.
///
/// ```
/// use lobe::PixelFilter;
/// use lobe::batch::tokuyoshi_deferred_alpha;
/// let (alphas, flat, turn) = ([0.1_f32; 2], [0.0; 2], [0.0, 0.1]);
/// let (dn_u, dn_v) = ([&turn[..], &flat, &flat], [&flat[..], &turn, &flat]);
/// let mut filtered = [0.0; 2];
/// let filter = PixelFilter::KAPLANYAN;
/// tokuyoshi_deferred_alpha(&alphas[..], dn_u, dn_v, filter, 0.18, &mut filtered)?;
/// assert!(filtered[0] == 0.1 && (filtered[1] - (0.01_f32 + 0.01).sqrt()).abs() < 1e-7);
/// # Ok::<(), lobe::Error>(())
/// ```
pub fn tokuyoshi_deferred_alpha<R: Real>(
    alphas: impl Columns<Item = R>,
    dn_u: impl Columns<Item = [R; 3]>,
    dn_v: impl Columns<Item = [R; 3]>,
    filter: PixelFilter,
    limit: R,
    out: &mut [R],
) -> Result<(), Error> {
    let limit = deferred::checked_limit(limit)?;
    fill(
        (alphas, dn_u, dn_v),
        [out],
        #[inline(always)]
        |(alpha, dn_u, dn_v)| {
            let alpha = Isotropic::saturating(alpha).alpha();
            [deferred::filtered(alpha, deferred::summed(dn_u, dn_v, filter), limit)]
        },
    )
}

/// [`tokuyoshi_kaplanyan_deferred_alpha`](crate::filter::tokuyoshi_kaplanyan_deferred_alpha) of
/// every element.
///
/// # Errors
/// As [`tokuyoshi_deferred_alpha`], whose alphas it takes.
pub fn tokuyoshi_kaplanyan_deferred_alpha<R: Real>(
    alphas: impl Columns<Item = R>,
    dn_u: impl Columns<Item = [R; 3]>,
    dn_v: impl Columns<Item = [R; 3]>,
    filter: PixelFilter,
    limit: R,
    out: &mut [R],
) -> Result<(), Error> {
    let limit = deferred::checked_limit(limit)?;
    fill(
        (alphas, dn_u, dn_v),
        [out],
        #[inline(always)]
        |(alpha, dn_u, dn_v)| {
            let alpha = Isotropic::saturating(alpha).alpha();
            [deferred::filtered(alpha, deferred::averaged(dn_u, dn_v, filter), limit)]
        },
    )
}

/// [`largest_deferred_alpha`](crate::filter::largest_deferred_alpha) of every element.
///
/// # Errors
/// As [`tokuyoshi_deferred_alpha`], whose alphas it takes.
pub fn largest_deferred_alpha<R: Real>(
    alphas: impl Columns<Item = R>,
    dn_u: impl Columns<Item = [R; 3]>,
    dn_v: impl Columns<Item = [R; 3]>,
    filter: PixelFilter,
    limit: R,
    out: &mut [R],
) -> Result<(), Error> {
    let limit = deferred::checked_limit(limit)?;
    fill(
        (alphas, dn_u, dn_v),
        [out],
        #[inline(always)]
        |(alpha, dn_u, dn_v)| {
            let alpha = Isotropic::saturating(alpha).alpha();
            [deferred::filtered(alpha, deferred::largest(dn_u, dn_v, filter), limit)]
        },
    )
}

/// [`kaplanyan_deferred_alphas`](crate::filter::kaplanyan_deferred_alphas) of every element, a
/// column for each axis.
///
/// # Errors
/// As [`tokuyoshi_deferred_alpha`], whose alphas it takes.
///
/// ```
/// use lobe::PixelFilter;
/// use lobe::batch::{Fixed, Footprint, kaplanyan_deferred_alphas};
/// let (widths, zero) = ([0.0_f64, 0.1], [0.0; 2]);
/// let footprints = Footprint { u: [&widths[..], &zero], v: [&zero[..], &zero] };
/// let (mut along, mut across) = ([0.0; 2], [0.0; 2]);
/// let (alphas, out) = (Fixed([0.1, 0.1]), [&mut along[..], &mut across]);
/// kaplanyan_deferred_alphas(alphas, footprints, PixelFilter::KAPLANYAN, 0.18, out)?;
/// assert!(along[0] == 0.1 && along[1] > 0.12 && across == [0.1, 0.1]);
/// # Ok::<(), lobe::Error>(())
/// ```
pub fn kaplanyan_deferred_alphas<R: Real>(
    alphas: impl Columns<Item = [R; 2]>,
    footprints: impl Columns<Item = Footprint<R>>,
    filter: PixelFilter,
    limit: R,
    out: [&mut [R]; 2],
) -> Result<(), Error> {
    let limit = deferred::checked_limit(limit)?;
    fill(
        (alphas, footprints),
        out,
        #[inline(always)]
        |([x, y], footprint)| {
            let [added_x, added_y] = deferred::along_axes(&footprint, filter);
            let filtered = |alpha: R, added: R| {
                deferred::filtered(Isotropic::saturating(alpha).alpha(), added, limit)
            };
            [filtered(x, added_x), filtered(y, added_y)]
        },
    )
}

/// [`kaplanyan_deferred_alpha`](crate::filter::kaplanyan_deferred_alpha) of every element.
///
/// # Errors
/// As [`tokuyoshi_deferred_alpha`], whose alphas it takes.
pub fn kaplanyan_deferred_alpha<R: Real>(
    alphas: impl Columns<Item = R>,
    footprints: impl Columns<Item = Footprint<R>>,
    filter: PixelFilter,
    limit: R,
    out: &mut [R],
) -> Result<(), Error> {
    let limit = deferred::checked_limit(limit)?;
    fill(
        (alphas, footprints),
        [out],
        #[inline(always)]
        |(alpha, footprint)| {
            let alpha = Isotropic::saturating(alpha).alpha();
            [deferred::filtered(alpha, deferred::widest(&footprint, filter), limit)]
        },
    )
}
