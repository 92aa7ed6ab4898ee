//! The pixel's footprint on the slope plane: two derivative vectors and the parallelogram they
//! span.
//!
//! Layer 1. A footprint is a fact about the pixel; which filter is laid over it is a kernel's
//! choice.

use super::direction::slope_of;
use super::jacobian::{Matrix, apply, disk_to_slope};
use crate::error::{Error, Value};
use crate::scalar::Real;
use crate::scalar::exact::cross;
use core::ops::{Mul, Sub};

/// How the half vector's slope changes over one pixel to the right (`u`) and one up (`v`).
///
/// The parallelogram is center +- u/2 +- v/2. Signs and order do not matter to any filter, and a
/// slope of either sign convention gives the same footprint. No constructor limits its size.
///
/// ```
/// use lobe::Footprint;
/// let footprint = Footprint::from_slopes([0.02_f32, 0.0], [0.01, 0.03]);
/// assert_eq!(footprint.extents(), [0.03, 0.03]);
/// ```
// Further methods: slope/motion.rs.
#[doc(alias = "LobeFootprint")]
#[doc(alias = "lobe_footprint_mul")]
#[doc(alias = "lobe_footprint_sub")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Footprint<R> {
    /// Derivative along the screen's first axis, slope per pixel.
    pub u: [R; 2],
    /// Derivative along the screen's second axis, slope per pixel.
    pub v: [R; 2],
}

impl<R: Real> Footprint<R> {
    /// From two derivative vectors in slope space (Kaplanyan et al. 2016, section 4.2).
    #[doc(alias = "lobe_footprint_from_slopes")]
    #[inline]
    pub fn from_slopes(u: impl Into<[R; 2]>, v: impl Into<[R; 2]>) -> Self {
        Self { u: u.into(), v: v.into() }
    }

    /// A rectangle along the axes, of these full widths.
    #[doc(alias = "lobe_footprint_rectangle")]
    #[inline]
    pub fn rectangle(widths: impl Into<[R; 2]>) -> Self {
        let [x, y] = widths.into();
        Self { u: [x, R::ZERO], v: [R::ZERO, y] }
    }

    /// From derivatives of $(h_x, h_y)$ of the unit half vector `h`, carried to slope space.
    ///
    /// The true change of variables, by Tokuyoshi 2017 Eq. 25: it grows like $1/h_z^3$ towards the
    /// horizon. Heights below $10^{-9}$ count as $10^{-9}$: slopes end there.
    ///
    /// ```
    /// use lobe::Footprint;
    /// let footprint = Footprint::from_disk([0.0_f32, 0.0, 1.0], [0.01, 0.0], [0.0, 0.01]);
    /// assert_eq!(footprint.extents(), [0.01, 0.01]);
    /// ```
    #[doc(alias = "lobe_footprint_from_disk")]
    pub fn from_disk(h: impl Into<[R; 3]>, u: impl Into<[R; 2]>, v: impl Into<[R; 2]>) -> Self {
        let [x, y, z] = h.into();
        let jacobian = disk_to_slope([x, y, z.max(R::ONE / R::LARGEST)]);
        Self { u: apply(jacobian, u), v: apply(jacobian, v) }
    }

    /// From derivatives of $(h_x, h_y)$ used in slope space as they are.
    ///
    /// Not a change of variables but a deliberate narrowing at grazing half vectors, where quad
    /// differences are noise. Source: Tokuyoshi 2017, Eq. 7.
    #[doc(alias = "lobe_footprint_from_disk_narrowed")]
    pub fn from_disk_narrowed(u: impl Into<[R; 2]>, v: impl Into<[R; 2]>) -> Self {
        Self::from_slopes(u, v)
    }

    /// From the half vectors of this pixel and of its neighbors to the right and above, by
    /// differences of their slopes, as a GPU's quad has them.
    ///
    /// All three in the frame of the same surface point, or each in its own shading frame (the
    /// frame's rotation is then part of the footprint, as in Kaplanyan Eq. 6). Need not have unit
    /// length.
    ///
    /// # Errors
    /// [`Error::HalfVector`] if one of them is not finite or does not point above the surface.
    ///
    /// ```
    /// use lobe::Footprint;
    /// let h = [0.0_f64, 0.0, 1.0];
    /// let f = Footprint::from_half_vectors(h, [0.1, 0.0, 1.0], [0.0, 0.2, 1.0])?;
    /// assert_eq!(f.extents(), [0.1, 0.2]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_footprint_from_half_vectors")]
    #[inline]
    pub fn from_half_vectors(
        h: impl Into<[R; 3]>,
        right: impl Into<[R; 3]>,
        up: impl Into<[R; 3]>,
    ) -> Result<Self, Error> {
        let slope = |h: [R; 3]| {
            let above = h[2] > R::ZERO && h.iter().all(|x| x.is_finite());
            if above { Ok(slope_of(h)) } else { Err(Error::HalfVector(h.map(Value::from))) }
        };
        let [s, r, t] = [h.into(), right.into(), up.into()].map(slope);
        let (s, r, t) = (s?, r?, t?);
        Self { u: [r[0] - s[0], r[1] - s[1]], v: [t[0] - s[0], t[1] - s[1]] }.known()
    }

    /// From steps of the surface point in its tangent plane, one per pixel axis, and the matrix M
    /// of [`Path::slope_jacobian`](super::Path::slope_jacobian) (Kaplanyan et al. 2016, Eq. 5).
    #[doc(alias = "lobe_footprint_from_positions")]
    pub fn from_positions(
        slope_jacobian: Matrix<R>,
        u: impl Into<[R; 2]>,
        v: impl Into<[R; 2]>,
    ) -> Self {
        Self { u: apply(slope_jacobian, u), v: apply(slope_jacobian, v) }
    }

    /// Full widths of the bounding rectangle along the slope axes, $|u| + |v|$ per axis.
    ///
    /// Source: Kaplanyan et al. 2016, section 5.3.
    #[doc(alias = "lobe_footprint_extents")]
    pub fn extents(&self) -> [R; 2] {
        [self.u[0].abs() + self.v[0].abs(), self.u[1].abs() + self.v[1].abs()]
    }

    /// The bounding rectangle as a footprint: wider than the parallelogram, and stable.
    #[doc(alias = "lobe_footprint_bounding")]
    #[must_use]
    pub fn bounding(&self) -> Self {
        Self::rectangle(self.extents())
    }

    /// The bounding rectangle with both widths limited to `limit`. A negative limit counts as 0.
    ///
    /// Source: Kaplanyan et al. 2016, section 5.2, with a limit of 1 ([`Footprint::WIDTH_LIMIT`]).
    ///
    /// ```
    /// use lobe::Footprint;
    /// let grazing = Footprint::from_slopes([9.0_f64, 0.1], [0.5, 0.1]);
    /// assert_eq!(grazing.bounding_within(Footprint::<f64>::WIDTH_LIMIT).extents(), [1.0, 0.2]);
    /// ```
    #[doc(alias = "lobe_footprint_bounding_within")]
    #[must_use]
    pub fn bounding_within(&self, limit: R) -> Self {
        Self::rectangle(self.extents().map(|width| width.min(limit.max(R::ZERO))))
    }

    /// Kaplanyan's limit on the footprint's widths, lambda of section 5.2.
    pub const WIDTH_LIMIT: f64 = 1.0;

    /// Length of the longer diagonal.
    #[doc(alias = "lobe_footprint_diameter")]
    pub fn diameter(&self) -> R {
        let length = |x: R, y: R| {
            let scale = x.abs().max(y.abs()).max(R::MIN_POSITIVE);
            let (p, q) = ((x / scale).kept(), (y / scale).kept());
            scale * (p * p + q * q).sqrt()
        };
        let sum = length(self.u[0] + self.v[0], self.u[1] + self.v[1]);
        sum.max(length(self.u[0] - self.v[0], self.u[1] - self.v[1]))
    }

    /// The footprint shrunk, in proportion, to a diameter of at most `limit` slope units. A
    /// negative limit counts as 0.
    ///
    /// Kaplanyan et al. 2016, section 5.2, limit the extents to lambda = 1. Theirs are measured
    /// along the frame's axes; the diameter does not depend on the frame.
    #[doc(alias = "lobe_footprint_capped")]
    #[must_use]
    pub fn capped(&self, limit: R) -> Self {
        let (diameter, limit) = (self.diameter(), limit.max(R::ZERO));
        if diameter <= limit {
            return *self;
        }
        // The quotient first: a tiny factor would have lost its digits.
        let shrink = |x: R| (x / diameter).kept() * limit;
        Self { u: self.u.map(shrink), v: self.v.map(shrink) }
    }

    /// The footprint, if its derivatives are finite.
    #[inline]
    pub(super) fn known(self) -> Result<Self, Error> {
        let unknown = [self.u, self.v].into_iter().find(|d| !d.iter().all(|x| x.is_finite()));
        unknown.map_or(Ok(self), |d| Err(Error::Derivative(d.map(Value::from))))
    }

    /// The largest component in magnitude.
    #[inline(always)]
    pub(crate) fn largest_component(&self) -> R {
        let Self { u, v } = *self;
        u[0].abs().max(u[1].abs()).max(v[0].abs().max(v[1].abs()))
    }

    /// The footprint shrunk in proportion to components of at most $10^9$: those of grazing half
    /// vectors have no bound, and f32 has no squares for them.
    #[inline]
    pub(crate) fn bounded(&self) -> Self {
        let largest = self.largest_component();
        if largest <= R::LARGEST {
            return *self;
        }
        // Infinite components count as the largest number.
        let shrink = |x: R| (x.max(-R::MAX).min(R::MAX) / largest.min(R::MAX)).kept() * R::LARGEST;
        Self { u: self.u.map(shrink), v: self.v.map(shrink) }
    }

    /// Area of the parallelogram, in squared slope units.
    #[doc(alias = "lobe_footprint_area")]
    pub fn area(&self) -> R {
        cross(self.u, self.v).abs()
    }
}

impl<R: Real> Mul<R> for Footprint<R> {
    type Output = Self;

    /// The footprint of a pixel of another size: both derivatives times `factor`.
    ///
    /// For derivatives that were taken over other pixels than those that are shown: $1/\sqrt n$
    /// where n samples of a pixel are shaded each (MSAA at sample rate, supersampling), the ratio
    /// of shaded to shown pixels where pictures are scaled up or down afterwards.
    ///
    /// ```
    /// use lobe::Footprint;
    /// let shaded = Footprint::rectangle([0.1_f32, 0.2]);
    /// assert_eq!((shaded * 0.5).extents(), [0.05, 0.1]); // four shaded samples a pixel
    /// ```
    #[inline]
    fn mul(self, factor: R) -> Self {
        Self { u: self.u.map(|x| x * factor), v: self.v.map(|x| x * factor) }
    }
}

impl<R: Real> Sub for Footprint<R> {
    type Output = Self;

    /// How the half vector's slope moves against a lobe whose mean moves, too: derivatives of
    /// $s_h - \mu$, the mean's given as two vectors along the same pixel axes.
    ///
    /// For moments of a normal map's finest level, whose detail the pixel then counts. Moments of
    /// the pixel's own level have it in their covariance: there take the footprint as it is, or it
    /// counts twice (`material::lean`).
    ///
    /// ```
    /// use lobe::Footprint;
    /// // A map whose slope follows the half vector's: the highlight stays where it is.
    /// let footprint = Footprint::from_slopes([0.25_f32, 0.0], [0.0, 0.5]);
    /// assert_eq!((footprint - Footprint::from_slopes([0.25, 0.0], [0.0, 0.5])).area(), 0.0);
    /// ```
    #[inline]
    fn sub(self, other: Self) -> Self {
        let (a, b) = (self, other);
        Self { u: [a.u[0] - b.u[0], a.u[1] - b.u[1]], v: [a.v[0] - b.v[0], a.v[1] - b.v[1]] }
    }
}
