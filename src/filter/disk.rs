//! Kernels on the projected disk, of $(h_x, h_y)$.
//!
//! Layer 3.

use super::kernel::{Kernel, PixelFilter};
use crate::scalar::{Psd, Real};
use crate::slope::Footprint;
use core::ops::{Add, AddAssign, Mul};

/// A Gaussian kernel on the projected disk: a covariance of $(h_x, h_y)$ of the unit half vector.
///
/// Not a [`Kernel`], which lives in slope space: the two differ by the Jacobian of
/// [`Footprint::from_disk`](crate::Footprint::from_disk), up to $1/h_z^3$.
///
/// ```
/// use lobe::{PixelFilter, Roughness, filter::DiskKernel};
/// let kernel = DiskKernel::of([0.1_f64, 0.0], [0.05, 0.1], PixelFilter::TOKUYOSHI_KAPLANYAN);
/// let widened = Roughness::from_alpha(0.9)?.widened_on_disk(&kernel);
/// assert!(widened.alphas().major > 0.9 && widened.alphas().major < 1.0);
/// # Ok::<(), lobe::Error>(())
/// ```
// Further methods: filter/projected.rs.
#[doc(alias = "LobeDiskKernel")]
#[doc(alias = "lobe_disk_kernel_add")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DiskKernel<R> {
    /// The same numbers, as a kernel that does not know its space.
    as_slopes: Kernel<R>,
}

impl<R: Real> DiskKernel<R> {
    /// The kernel of two derivative vectors of $(h_x, h_y)$, one per pixel axis, under a pixel
    /// filter.
    ///
    /// Source: Tokuyoshi & Kaplanyan 2021, Eq. 3, there with [`PixelFilter::TOKUYOSHI_KAPLANYAN`].
    #[doc(alias = "lobe_disk_kernel_of")]
    #[inline]
    pub fn of(u: impl Into<[R; 2]>, v: impl Into<[R; 2]>, filter: PixelFilter) -> Self {
        Self { as_slopes: Kernel::of(&Footprint::from_slopes(u, v), filter) }
    }

    /// The kernel of the bounding rectangle along the frame's axes: with a lobe along the axes it
    /// stays there.
    ///
    /// ```
    /// use lobe::{PixelFilter, Roughness, filter::DiskKernel};
    /// let kernel = DiskKernel::of_bounding([0.1_f64, 0.1], [0.0, 0.1], PixelFilter::BOX);
    /// let widened = Roughness::from_alphas(0.2, 0.1, 0.0)?.widened_on_disk(&kernel);
    /// assert_eq!(widened.matrix().entries()[1], 0.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_disk_kernel_of_bounding")]
    #[inline]
    pub fn of_bounding(u: impl Into<[R; 2]>, v: impl Into<[R; 2]>, filter: PixelFilter) -> Self {
        Self { as_slopes: Kernel::of(&Footprint::from_slopes(u, v).bounding(), filter) }
    }

    /// A kernel of this covariance.
    #[doc(alias = "lobe_disk_kernel_from_covariance")]
    #[inline]
    pub fn from_covariance(covariance: Psd<R>) -> Self {
        Self { as_slopes: Kernel::from_covariance(covariance) }
    }

    /// A kernel of the numbers of a slope kernel.
    #[cfg(feature = "serde")]
    pub(crate) const fn from_kernel(as_slopes: Kernel<R>) -> Self {
        Self { as_slopes }
    }

    /// The covariance.
    #[inline]
    pub fn covariance(&self) -> Psd<R> {
        self.as_slopes.covariance()
    }

    /// The kernel with the alpha^2 that it adds limited to `limit` along each axis, as
    /// [`Kernel::capped`].
    #[doc(alias = "lobe_disk_kernel_capped")]
    #[must_use]
    pub fn capped(&self, limit: R) -> Self {
        Self { as_slopes: self.as_slopes.capped(limit) }
    }

    /// The kernel used in slope space as it is: Tokuyoshi's deliberate narrowing, and the practical
    /// approximation of the 2021 paper.
    ///
    /// Not a change of variables: right at $h = n$, narrower by up to $h_z^3$ elsewhere, where quad
    /// differences are noise. [`Kernel::widen`] and [`Kernel::capped`] do the rest.
    ///
    /// Source: Tokuyoshi 2017, Eq. 7; Tokuyoshi & Kaplanyan 2021, Eq. 9 and Listing 2.
    ///
    /// ```
    /// use lobe::{Kernel, PixelFilter, filter::DiskKernel};
    /// let (u, v) = ([0.1_f32, 0.0], [0.0, 0.2]);
    /// let narrowed = DiskKernel::of(u, v, PixelFilter::KAPLANYAN).as_slopes();
    /// assert_eq!(narrowed, Kernel::tokuyoshi_forward(u, v));
    /// ```
    #[inline]
    pub const fn as_slopes(&self) -> Kernel<R> {
        self.as_slopes
    }
}

impl<R: Real> Add for DiskKernel<R> {
    type Output = Self;

    /// Two kernels one after the other: covariances add.
    fn add(self, other: Self) -> Self {
        Self { as_slopes: self.as_slopes + other.as_slopes }
    }
}

impl<R: Real> AddAssign for DiskKernel<R> {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<R: Real> Mul<R> for DiskKernel<R> {
    type Output = Self;

    /// The kernel with its covariance times a finite factor; a negative one counts as 0.
    #[inline]
    fn mul(self, factor: R) -> Self {
        Self { as_slopes: self.as_slopes * factor }
    }
}

impl<R: Real> Kernel<R> {
    /// Tokuyoshi's kernel for forward shading, from derivatives of $(h_x, h_y)$ of the unit half
    /// vector used in slope space as they are, under [`PixelFilter::KAPLANYAN`].
    ///
    /// A deliberate narrowing at grazing half vectors, where quad differences are noise
    /// ([`Footprint::from_disk_narrowed`]).
    ///
    /// Source: Tokuyoshi 2017, Eq. 2, 3 and 7, Listing 1.
    ///
    /// ```
    /// use lobe::{Kernel, Roughness};
    /// let kernel = Kernel::tokuyoshi_forward([0.1_f64, 0.0], [0.0, 0.2]);
    /// let widened = Roughness::from_alpha(0.1)?.widened(&kernel);
    /// // alpha^2 + 2 * 0.25 * derivative^2, per axis.
    /// assert!((widened.alphas().major.powi(2) - (0.01 + 0.02)).abs() < 1e-15);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_kernel_tokuyoshi_forward")]
    #[inline]
    pub fn tokuyoshi_forward(u: impl Into<[R; 2]>, v: impl Into<[R; 2]>) -> Self {
        DiskKernel::of(u, v, PixelFilter::KAPLANYAN).as_slopes()
    }
}
