//! Filtering before the light is known: roughness from the change of the normal.
//!
//! Floor 3.

use super::kernel::PixelFilter;
use crate::error::Error;
use crate::scalar::Real;

/// Filtered alpha for a G-buffer, from the derivatives of the world-space normal.
///
/// $\bar\alpha^2 = \alpha^2 + \min(2 \sigma_{px}^2 (|\Delta n_u|^2 + |\Delta n_v|^2), \mathrm{limit})$,
/// $\bar\alpha \le 1$. The trace stands for the largest eigenvalue, which it never falls below. Needs no
/// tangent frame. The paper has [`PixelFilter::KAPLANYAN`] and a limit of 0.18
/// ([`Kernel::ALPHA_SQUARED_LIMIT`](super::Kernel::ALPHA_SQUARED_LIMIT)). An alpha above 1 stays.
///
/// Source: Tokuyoshi 2017, Eq. 13 and Listing 2.
///
/// # Errors
/// [`Error::Alpha`] unless alpha lies in $[0, 10^9]$; [`Error::Limit`] if the limit is negative
/// or NaN.
///
/// ```
/// use lobe::{PixelFilter, filter::tokuyoshi_deferred_alpha};
/// let (dn_u, dn_v) = ([0.1_f32, 0.0, 0.0], [0.0, 0.1, 0.0]);
/// let alpha = tokuyoshi_deferred_alpha(0.1, dn_u, dn_v, PixelFilter::KAPLANYAN, 0.18)?;
/// assert!((alpha - (0.01_f32 + 0.01).sqrt()).abs() < 1e-7);
/// # Ok::<(), lobe::Error>(())
/// ```
pub fn tokuyoshi_deferred_alpha<R: Real>(
    alpha: R,
    dn_u: impl Into<[R; 3]>,
    dn_v: impl Into<[R; 3]>,
    filter: PixelFilter,
    limit: R,
) -> Result<R, Error> {
    if !alpha.is_magnitude() {
        return Err(Error::Alpha);
    }
    if !(limit >= R::ZERO) {
        return Err(Error::Limit);
    }
    let norm_squared = |d: [R; 3]| d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    let spread = norm_squared(dn_u.into()) + norm_squared(dn_v.into());
    // `max` drops NaN: derivatives without a number add nothing.
    let added = (R::lit(2.0 * filter.variance()) * spread).max(R::ZERO).min(limit);
    let ceiling = alpha.max(R::ONE);
    Ok((alpha * alpha + added).sqrt().min(ceiling))
}
