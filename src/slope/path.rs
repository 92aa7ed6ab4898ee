//! The half vector's slope along the surface: Kaplanyan's matrix M.
//!
//! Layer 1. For renderers that know positions, distances and curvature: ray tracers, meshlets,
//! compute passes. Rasterizers difference neighboring pixels instead
//! ([`Footprint`](super::Footprint)).

use super::direction::dot;
use super::jacobian::Matrix;
use super::motion::Motion;
use crate::error::{Error, Value};
use crate::scalar::Real;

/// One end of a light path seen from the shaded point: a direction and one over the distance.
///
/// ```
/// use lobe::Vertex;
/// let lamp = Vertex::at([0.0_f64, 0.0, 2.0])?;
/// assert_eq!(lamp, Vertex { direction: [0.0, 0.0, 1.0], inverse_distance: 0.5 });
/// let sun = Vertex::distant([0.0_f64, 0.0, 1.0])?;
/// assert_eq!(sun.inverse_distance, 0.0);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "LobeVertex")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Vertex<R> {
    /// Unit vector from the shaded point, tangent frame.
    pub direction: [R; 3],
    /// One over the distance; 0 for a distant light or camera.
    pub inverse_distance: R,
}

impl<R: Real> Vertex<R> {
    /// A vertex at `position`, relative to the shaded point, in the tangent frame.
    ///
    /// # Errors
    /// [`Error::Direction`] if the position is not finite, or so near that one over its distance is
    /// not.
    #[doc(alias = "lobe_vertex_at")]
    pub fn at(position: impl Into<[R; 3]>) -> Result<Self, Error> {
        let position = position.into();
        // Scaled by the largest component: squares of far positions overflow f32.
        let scale = position.iter().fold(R::ZERO, |m, x| m.max(x.abs()));
        // Kept, so that no compiler compares `scale` with 1/MAX instead: 1/MAX is subnormal, and
        // where subnormal numbers are flushed to 0, a `scale` of 0 would pass.
        let invertible = (scale.min(R::ONE) * R::MAX).kept() >= R::ONE;
        if !(invertible && position.iter().all(|x| x.is_finite())) {
            return Err(Error::Direction(position.map(Value::from)));
        }
        let unit = position.map(|x| (x / scale).kept());
        // The exact length is at least 1. On GPUs that flush the quotient by a huge `scale` to 0,
        // `max` restores that.
        let length = dot(unit, unit).sqrt().max(R::ONE);
        Ok(Self { direction: unit.map(|x| x / length), inverse_distance: R::ONE / length / scale })
    }

    /// A vertex infinitely far away in `direction`, which need not have unit length.
    ///
    /// # Errors
    /// [`Error::Direction`] if the direction is not finite, or so short that one over its length is
    /// not.
    #[doc(alias = "lobe_vertex_distant")]
    pub fn distant(direction: impl Into<[R; 3]>) -> Result<Self, Error> {
        Ok(Self { inverse_distance: R::ZERO, ..Self::at(direction)? })
    }

    /// $-(I - w w^T) v / r$: how the unit direction turns when the shaded point moves by `v`.
    fn turn(&self, v: [R; 3]) -> [R; 3] {
        let w = self.direction;
        let along = dot(w, v);
        [0, 1, 2].map(|k| (w[k] * along - v[k]) * self.inverse_distance)
    }
}

/// A surface point between viewer and light, with the surface's curvature.
#[doc(alias = "LobePath")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Path<R> {
    /// The viewer.
    pub eye: Vertex<R>,
    /// The light.
    pub light: Vertex<R>,
    /// Shape operator `[b_11, b_12, b_22]`: a step `dx` in the tangent plane turns the normal by
    /// `dn = B dx`. Positive for convex surfaces: a sphere of radius r has B = I/r. Unit: 1/length.
    pub curvature: [R; 3],
}

impl<R: Real> Path<R> {
    /// Kaplanyan's plane point of the half vector, $p = (g_x, g_y)/g_z$ with $g = w_i + w_o$; the
    /// slope is its negative.
    ///
    /// Zero for a vertex pair whose sum does not point above the surface.
    #[doc(alias = "lobe_path_plane_point")]
    pub fn plane_point(&self) -> [R; 2] {
        let g = self.half_vector();
        if g[2] > R::ZERO { [g[0] / g[2], g[1] / g[2]] } else { [R::ZERO; 2] }
    }

    /// The half vector without its normalization, $g = w_i + w_o$.
    #[doc(alias = "lobe_path_half_vector")]
    pub fn half_vector(&self) -> [R; 3] {
        let (wo, wi) = (self.eye.direction, self.light.direction);
        [wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]]
    }

    /// What a step of the surface point in its tangent plane moves: per pixel,
    /// [`Footprint::from_motion`] takes it.
    ///
    /// $dg = -[(I - w_i w_i^T)/r_i + (I - w_o w_o^T)/r_o]\, dx$, $dn = B\, dx$. A distant vertex
    /// drops its term.
    ///
    /// [`Footprint::from_motion`]: super::Footprint::from_motion
    ///
    /// ```
    /// use lobe::{Footprint, Path, Vertex, slope::ray};
    /// let (wo, above) = ([0.0_f64, 0.0, 1.0], Vertex::distant([0.0, 0.0, 1.0])?);
    /// let path = Path { eye: above, light: above, curvature: [0.5, 0.0, 0.5] };
    /// // A ray tracer's pixel: the width of its ray cone at the hit.
    /// let [u, v] =
    ///     ray::cone_steps(wo, ray::cone_width(0.0, 0.001, 20.0)).map(|dx| path.motion(dx));
    /// let footprint = Footprint::from_motion(path.half_vector(), &u, &v)?;
    /// assert!((footprint.extents()[0] - 0.01).abs() < 1e-8);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_path_motion")]
    pub fn motion(&self, step: impl Into<[R; 2]>) -> Motion<R> {
        let [x, y] = step.into();
        let [b11, b12, b22] = self.curvature;
        let (eye, light) = (self.eye.turn([x, y, R::ZERO]), self.light.turn([x, y, R::ZERO]));
        Motion {
            half_vector: [0, 1, 2].map(|k| eye[k] + light[k]),
            normal: [b11 * x + b12 * y, b12 * x + b22 * y],
            spin: R::ZERO,
        }
    }

    /// The derivative of the plane point by the surface point.
    ///
    /// Columns are the plane's answer to [`Path::motion`] along each tangent; unit 1/length.
    /// Returns zeros if $g$ does not point above the surface; at grazing half vectors entries grow
    /// like $1/g_z^2$, to at most the largest number. The slope's Jacobian is $-M$; as every kernel
    /// and polygon is even in its derivatives, both signs give the same filter.
    ///
    /// Source: Kaplanyan et al. 2016, Eq. 4 and 6, derived in full (the paper refers to Jakob
    /// 2013).
    ///
    /// ```
    /// use lobe::{Path, Vertex};
    /// // A mirror ball of radius 2 under a distant sun, seen from far above: dp = -dx/2.
    /// let above = Vertex::distant([0.0_f64, 0.0, 1.0])?;
    /// let path = Path { eye: above, light: above, curvature: [0.5, 0.0, 0.5] };
    /// assert_eq!(path.slope_jacobian(), [[-0.5, 0.0], [0.0, -0.5]]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "M")]
    #[doc(alias = "lobe_path_slope_jacobian")]
    pub fn slope_jacobian(&self) -> Matrix<R> {
        let g = self.half_vector();
        if !(g[2] > R::ZERO) {
            return [[R::ZERO; 2]; 2];
        }
        let column =
            |step: [R; 2]| self.motion(step).plane_step(g).map(|x| x.max(-R::MAX).min(R::MAX));
        let (along_s, along_t) = (column([R::ONE, R::ZERO]), column([R::ZERO, R::ONE]));
        [[along_s[0], along_t[0]], [along_s[1], along_t[1]]]
    }
}
