//! What a light's extent does to details.
//!
//! Layer 4.

use crate::scalar::Real;
use crate::slope::direction::{dot, half_vector};

/// What a light that appears with this radius, in radians, adds to the alpha^2 of a detail:
/// $\gamma^2/(4\, (w_i \cdot h)\, h_z^3)$.
///
/// A disk of directions of radius $\gamma$ has half vectors over a solid angle of $\pi\gamma^2/(4\,
/// w_i \cdot h)$, which on the slope plane is $1/h_z^3$ times as large: an ellipse with the area
/// $\pi$ times this. At most $10^9$.
///
/// Source: Zirr & Kaplanyan 2016, section 4.3, have a "sum of microroughness and light source cone
/// angle"; their code adds to the probability instead, which brightens every half vector.
///
/// ```
/// use lobe::material::glint::light_blur;
/// let up = [0.0_f64, 0.0, 1.0];
/// assert_eq!(light_blur(up, up, 0.5), 0.0625);
/// ```
#[doc(alias = "lobe_light_blur")]
#[inline]
pub fn light_blur<R: Real>(wo: impl Into<[R; 3]>, wi: impl Into<[R; 3]>, radius: R) -> R {
    let (wo, wi) = (wo.into(), wi.into());
    let h = half_vector(wo, wi);
    let solid = R::lit(4.0) * dot(wi, h) * (h[2] * h[2] * h[2]);
    let radius = radius.max(R::ZERO);
    (radius * radius / solid.max(R::MIN_POSITIVE)).min(R::LARGEST)
}
