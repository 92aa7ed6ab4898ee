//! Pixel steps on a surface from rays: differentials and cones.
//!
//! Layer 1. What a ray tracer has in place of quads. Steps are in the tangent plane at the hit, one
//! per pixel axis; [`Path::motion`](super::Path::motion) carries them on.

use crate::scalar::Real;

/// The tangent-plane step of a ray differential: where the neighboring pixel's ray meets the plane.
///
/// $x = dO + t\,dD$, $dx = x_{xy} - \frac{x_z}{w_{o,z}} w_{o,xy}$: `origin` and `direction` are the
/// differentials of the ray's origin and of its unit direction for one pixel, in the tangent frame,
/// `distance` is t, `wo` points back along the ray. Heights of `wo` below $10^{-9}$ count as
/// $10^{-9}$.
///
/// Source: Igehy 1999, Eq. 10 to 12.
///
/// ```
/// use lobe::slope::ray;
/// // A pinhole camera 10 away, straight above: a pixel of 0.001 radians is 0.01 wide.
/// let step = ray::step([0.0_f64, 0.0, 1.0], [0.0; 3], [0.001, 0.0, 0.0], 10.0);
/// assert_eq!(step, [0.01, 0.0]);
/// ```
#[doc(alias = "lobe_ray_step")]
pub fn step<R: Real>(
    wo: impl Into<[R; 3]>,
    origin: impl Into<[R; 3]>,
    direction: impl Into<[R; 3]>,
    distance: R,
) -> [R; 2] {
    let (wo, origin, direction) = (wo.into(), origin.into(), direction.into());
    let across = [0, 1, 2].map(|k| origin[k] + distance * direction[k]);
    let along = across[2] / wo[2].max(R::ONE / R::LARGEST);
    [across[0] - along * wo[0], across[1] - along * wo[1]]
}

/// Width of a ray cone after `distance`, $w_0 + 2 t \tan(\gamma/2)$, for a spread of $\gamma$
/// radians per pixel, less than half a turn.
///
/// Source: Akenine-Möller et al. 2021, with the erratum: the full width, hence twice the tangent of
/// half the angle.
///
/// ```
/// let width = lobe::slope::ray::cone_width(0.1_f64, 0.002, 10.0);
/// assert!((width - 0.12).abs() < 1e-8);
/// ```
pub fn cone_width<R: Real>(width: R, spread: R, distance: R) -> R {
    let (sin, cos) = spread.sin_cos();
    // tan(x/2) = sin x / (1 + cos x).
    width + R::TWO * distance * (sin / (R::ONE + cos))
}

/// The two tangent-plane steps of a ray cone of this width: along the view and across it.
///
/// The cone's cross-section on the plane is an ellipse of axes $w/w_{o,z}$ and $w$. Cones know no
/// pixel axes: a kernel of the two steps is that of the pixel, a parallelogram of them stands for a
/// turned pixel. Heights of `wo` below $10^{-9}$ count as $10^{-9}$.
///
/// ```
/// let [along, across] = lobe::slope::ray::cone_steps([0.6_f64, 0.0, 0.8], 0.1);
/// assert!((along[0] - 0.125).abs() < 1e-12 && along[1] == 0.0);
/// assert_eq!(across, [0.0, 0.1]);
/// ```
#[doc(alias = "lobe_ray_cone_steps")]
pub fn cone_steps<R: Real>(wo: impl Into<[R; 3]>, width: R) -> [[R; 2]; 2] {
    let wo = wo.into();
    let length = (wo[0] * wo[0] + wo[1] * wo[1]).sqrt();
    // Straight from above any direction will do.
    let [cos, sin] =
        if length > R::ZERO { [wo[0] / length, wo[1] / length] } else { [R::ONE, R::ZERO] };
    let long = width / wo[2].max(R::ONE / R::LARGEST);
    [[long * cos, long * sin], [-(width * sin), width * cos]]
}
