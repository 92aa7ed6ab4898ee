//! GGX: $P_{22} = 1/(\pi \sqrt{\det A} (1 + q)^2)$, Student-t slopes with two degrees of freedom.
//!
//! Layer 2. Trowbridge & Reitz 1975; Walter et al. 2007; any A: Heitz 2014, any mean: LEADR.

use super::distribution::Distribution;
use super::distribution::sealed::Sealed;
use crate::scalar::Real;
use crate::slope::Extent;

/// The scalar functions of GGX; see [`Ggx`](crate::Ggx).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GgxDistribution;

impl Sealed for GgxDistribution {
    #[cfg(feature = "serde")]
    const DATA_NAME: &'static str = "ggx";
}

impl Distribution for GgxDistribution {
    /// With $r = \sqrt{\det A}$, the unit $\kappa r$ and $n = \kappa r q z^2$:
    /// $\frac{\ell^4}{r (1 + q)^2 z^4} = r \left(\frac{\kappa \ell^2}{\kappa r z^2 + n}\right)^2$:
    /// one division, none by z.
    #[inline(always)]
    fn density<R: Real>(form: R, extent: Extent<R>, z: R, length_squared: R, weight: R) -> R {
        let Extent { root_det, unit, scale } = extent;
        let ratio = (scale * length_squared) / (unit * (z * z) + form);
        (root_det * ratio) * ratio * weight
    }

    /// $\sigma = (c + \sqrt{c^2 + a^2})/2$, so the excess is
    /// $(\sqrt{c^2 + a^2} - c)/2 = \frac{a^2}{2 (\sqrt{c^2 + a^2} + c)}$.
    #[inline(always)]
    fn excess<R: Real>(c: R, a2: R) -> R {
        a2 / (R::TWO * ((c * c + a2).sqrt() + c)).max(R::MIN_POSITIVE)
    }

    /// $\sqrt{c^2 + a^2}$: the general form without its division.
    #[inline(always)]
    fn even_area<R: Real>(c: R, a2: R) -> R {
        (c * c + a2).sqrt()
    }
}
