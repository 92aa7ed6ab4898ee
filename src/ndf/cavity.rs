//! Masking of V-shaped cavities: a function of the facet, not of the distribution.
//!
//! Layer 2. Smith's masking needs the projected area of the whole distribution; this one is exact
//! for every distribution of slopes that is even, however many lobes it has.

use crate::scalar::Real;
use crate::slope::direction::dot;

/// Masking of V-cavities, $G_1(w, m) = \min(1, 2 m_z w_z/(w \cdot m))$, in \[0, 1\]; 0 below a
/// horizon or behind the facet.
///
/// For any even density, $\int G_1(w, m)\, (w \cdot m)^+ D(m)\, dm = w_z$: of a facet and the one
/// opposite in its cavity, as much is seen as the cavity is wide. Directions of unit length, in the
/// tangent frame.
///
/// Source: Cook & Torrance 1982; Heitz 2014, section 6.2.
///
/// ```
/// use lobe::ndf::cavity_masking;
/// let up = [0.0_f64, 0.0, 1.0];
/// assert_eq!(cavity_masking([0.6_f64, 0.0, 0.8], up), 1.0);
/// let m = [0.6_f64, 0.0, 0.8];
/// assert!(cavity_masking([0.8, 0.0, 0.6], m) == 1.0);
/// assert!(cavity_masking([0.995, 0.0, 0.1], m) < 0.25);
/// ```
#[doc(alias = "lobe_cavity_masking")]
#[inline]
pub fn cavity_masking<R: Real>(w: impl Into<[R; 3]>, m: impl Into<[R; 3]>) -> R {
    let (w, m) = (w.into(), m.into());
    let facing = dot(w, m);
    if facing > R::ZERO && w[2] > R::ZERO && m[2] > R::ZERO {
        (R::TWO * m[2] * w[2] / facing).min(R::ONE)
    } else {
        R::ZERO
    }
}

/// Masking and shadowing of V-cavities, the smaller of both: Cook & Torrance's.
///
/// Published code multiplies them (Chermain et al. 2020). For m = h the two quotients $2 m_z w_z/(w
/// \cdot m)$ add up to $4 h_z^2$: where $h_z^2 \ge 1/2$ at least one of the maskings is therefore
/// 1, and the smaller is the product.
///
/// ```
/// use lobe::ndf::cavity_masking_shadowing;
/// use lobe::slope::direction::half_vector;
/// let (wo, wi) = ([0.6_f64, 0.0, 0.8], [0.0, 0.6, 0.8]);
/// assert_eq!(cavity_masking_shadowing(wo, wi, half_vector(wo, wi)), 1.0);
/// ```
#[doc(alias = "lobe_cavity_masking_shadowing")]
#[inline]
pub fn cavity_masking_shadowing<R: Real>(
    wo: impl Into<[R; 3]>,
    wi: impl Into<[R; 3]>,
    m: impl Into<[R; 3]>,
) -> R {
    let m = m.into();
    cavity_masking(wo, m).min(cavity_masking(wi, m))
}
