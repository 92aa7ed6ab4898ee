//! How a light path moves from one pixel to the next, and the footprint that this makes.
//!
//! Layer 1. The door for renderers without quads: compute passes, meshlets, ray tracers. Any
//! surface, any shading normal, any frame; Kaplanyan's matrix M is the case of a smooth surface
//! ([`Path`](super::Path)).

use super::footprint::Footprint;
use crate::error::{Error, Value};
use crate::scalar::Real;

/// Changes at a shaded point over one pixel, in its shading frame.
///
/// Whatever does not move is 0: a distant light and camera leave `normal`, a flat surface leaves
/// `half_vector`.
///
/// ```
/// use lobe::{Footprint, slope::Motion};
/// // A mirror ball of radius 100 pixels under distant light and camera: only the normal turns.
/// let over = |x, y| Motion { normal: [x, y], ..Motion::default() };
/// let (right, up) = (over(0.01_f64, 0.0), over(0.0, 0.01));
/// let footprint = Footprint::from_motion([0.0, 0.0, 1.0], &right, &up)?;
/// assert_eq!(footprint.extents(), [0.01, 0.01]);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "LobeMotion")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Motion<R> {
    /// Change of the half vector, the frame held fixed: of $w_o + w_i$, or of any multiple of it,
    /// the same that [`Footprint::from_motion`] is given.
    pub half_vector: [R; 3],
    /// Change of the shading normal: its two tangential components.
    pub normal: [R; 2],
    /// Turn of the frame about its normal, counter-clockwise, in radians: of brushed metal's axes.
    /// It leaves an isotropic lobe as it is, and is 0 for a frame that only follows its normal.
    pub spin: R,
}

impl<R: Real> Motion<R> {
    /// Change of the plane point $p = (g_x, g_y)/g_z$; the slope is its negative.
    ///
    /// $dp_k = dg_k/g_z - dn_k - p_k (dg_z/g_z + p \cdot dn)$, and a spin turns p the other way.
    #[inline]
    pub(super) fn plane_step(&self, g: [R; 3]) -> [R; 2] {
        let p = [g[0] / g[2], g[1] / g[2]];
        let dg = self.half_vector.map(|x| x / g[2]);
        let common = dg[2] + p[0] * self.normal[0] + p[1] * self.normal[1];
        let turned = [p[1] * self.spin, -(p[0] * self.spin)];
        [0, 1].map(|k| dg[k] - self.normal[k] - p[k] * common + turned[k])
    }
}

impl<R: Real> Footprint<R> {
    /// From the motions of the path to the pixels at the right and above.
    ///
    /// With $g$ the half vector (any length), $p = (g_x, g_y)/g_z$ and $dn$ the change of the
    /// normal: $dp_k = dg_k/g_z - dn_k - p_k (dg_z/g_z + p \cdot dn)$. Grows like $1/g_z^2$ towards
    /// the horizon.
    ///
    /// Source: Kaplanyan et al. 2016, Eq. 4 to 6, for shading normals and turning frames. Their
    /// deferred form, Eq. 17, is `half_vector` = 0.
    ///
    /// # Errors
    /// [`Error::HalfVector`] unless the half vector is finite and points above the surface;
    /// [`Error::Derivative`] unless the derivatives are finite.
    ///
    /// ```
    /// use lobe::{Footprint, slope::Motion};
    /// // Explicit derivatives of the unit half vector: the disk's, carried to slope space.
    /// let h = [0.6_f64, 0.0, 0.8];
    /// let right = Motion { half_vector: [0.008, 0.0, -0.006], ..Motion::default() };
    /// let up = Motion { half_vector: [0.0, 0.01, 0.0], ..Motion::default() };
    /// let footprint = Footprint::from_motion(h, &right, &up)?;
    /// let same = Footprint::from_disk(h, [0.008, 0.0], [0.0, 0.01]);
    /// assert!((footprint.area() / same.area() - 1.0).abs() < 1e-12);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_footprint_from_motion")]
    #[inline]
    pub fn from_motion(
        half_vector: impl Into<[R; 3]>,
        u: &Motion<R>,
        v: &Motion<R>,
    ) -> Result<Self, Error> {
        let g = half_vector.into();
        let above = g[2] > R::ZERO && g.iter().all(|x| x.is_finite());
        // The slope is minus the plane point.
        let [u, v] = [u, v].map(|motion| motion.plane_step(g).map(|x| -x));
        let known = Self { u, v }.known();
        if above { known } else { Err(Error::HalfVector(g.map(Value::from))) }
    }
}
