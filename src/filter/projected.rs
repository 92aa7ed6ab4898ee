//! Filtering on the projected disk, where GGX is the same distribution again.
//!
//! Layer 3. As $m_z^2 = 1 - |m_{xy}|^2$, D of a centered GGX is $\frac{1}{\pi \sqrt{\det A}\,(1 +
//! m_{xy}^T A_\perp^{-1} m_{xy})^2}$ with $A_\perp = (A^{-1} - I)^{-1}$: on the disk of $(h_x,
//! h_y)$ it is a GGX of roughness $A_\perp$. Kernels of half vectors have a bound there, and
//! widened roughness stays below 1 by itself.

use super::kernel::{Kernel, PixelFilter};
use crate::error::Error;
use crate::scalar::{Eigen, Psd, Real};
use crate::slope::{Footprint, Roughness};
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
    /// differences are noise. [`Roughness::widened`] and [`Kernel::capped`] do the rest.
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

impl<R: Real> Roughness<R> {
    /// The roughness of a centered GGX under a Gaussian kernel on the projected disk.
    ///
    /// $A_\perp' = A_\perp + K$ with $K = 2\Sigma_K$, back by $A' = (A_\perp' + \det A_\perp'\,
    /// I)/(1 + \mathrm{tr} A_\perp' + \det A_\perp')$: no inverse, and eigenvalues below 1 stay
    /// there without a clamp. Variance addition on the disk: its peak is too bright by as much as
    /// in slope space. GGX only; for a lobe with a mean the identity does not hold.
    ///
    /// With $C = I - A$ the two lines are $C'^{-1} = C^{-1} + K$: no pole at alpha = 1. There the
    /// lobe is uniform over the disk, and beyond it grows towards the rim; neither has a highlight.
    /// Axes with alpha at least 1 are therefore left as they are, to which the formula tends as
    /// alpha goes to 1 (engines that saturate $A_\perp$ make them smoother instead). Entries of K
    /// beyond $10^9$ shrink the kernel to that: A' is then I but for rounding.
    ///
    /// Source: Tokuyoshi & Kaplanyan 2021, Eq. 4 to 7, Listing 1; back without an inverse as in
    /// Tokuyoshi et al. 2024.
    ///
    /// ```
    /// use lobe::{PixelFilter, Roughness, filter::DiskKernel};
    /// let kernel = DiskKernel::of([0.2_f64, 0.0], [0.0, 0.2], PixelFilter::TOKUYOSHI_KAPLANYAN);
    /// let square = |alpha| {
    ///     Roughness::from_alpha(alpha).unwrap().widened_on_disk(&kernel).matrix().entries()[0]
    /// };
    /// // Small alpha: as in slope space. alpha = 1: nothing to filter.
    /// assert!((square(0.01) - (1e-4 + 0.04 / core::f64::consts::PI)).abs() < 2e-4);
    /// assert_eq!(square(1.0), 1.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_roughness_widened_on_disk")]
    #[must_use]
    #[inline]
    pub fn widened_on_disk(&self, kernel: &DiskKernel<R>) -> Self {
        let added = bounded(kernel.covariance() * R::TWO);
        let matrix = self.matrix();
        // det (I - A), as the product of 1 - a; both factors may be negative.
        let complement = R::ONE - matrix.trace() + matrix.det();
        let smooth = matrix.trace() < R::TWO;
        if smooth && complement >= R::lit(0.125) {
            return Self::from_matrix(filtered(&matrix, &added, complement));
        }
        let eigen = matrix.eigen();
        let Eigen { major, minor, axis: [cos, sin] } = eigen;
        if major < R::ONE {
            return Self::from_matrix(from_disk(&(to_disk(eigen) + added)));
        }
        if !(minor < R::ONE) {
            return *self;
        }
        // The limit of the formula as the major axis goes to 1: only the minor one sees the kernel.
        let across = filtered_square(minor, added.quadratic([-sin, cos]));
        Self::from_matrix(Psd::from_axes(major.sqrt(), across.sqrt(), cos, sin))
    }
}

/// alpha of a GGX under a kernel on the disk that adds `added` to alpha^2: one axis of
/// [`Roughness::widened_on_disk`].
///
/// $\alpha'^2 = (\alpha^2 + (1 - \alpha^2) k)/(1 + (1 - \alpha^2) k)$, $k = 2\sigma_{px}^2 w^2$:
/// for isotropic lobes with isotropic kernels, and for each axis of lobes and rectangles along the
/// frame's axes. alpha of at least 1 stays.
///
/// Source: Tokuyoshi & Kaplanyan 2021, Eq. 4, 6 and 7 for one axis, in $1 - \alpha^2$: no pole
/// at 1.
///
/// # Errors
/// [`Error::Alpha`] unless alpha lies in $[0, 10^9]$; [`Error::Added`] unless `added` does.
///
/// ```
/// use lobe::filter::projected_alpha;
/// assert!((projected_alpha(0.6_f64, 0.5)? - (0.68_f64 / 1.32).sqrt()).abs() < 1e-15);
/// assert_eq!(projected_alpha(2.0_f64, 0.5)?, 2.0);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_projected_alpha")]
pub fn projected_alpha<R: Real>(alpha: R, added: R) -> Result<R, Error> {
    if !alpha.is_magnitude() {
        return Err(Error::Alpha(alpha.into()));
    }
    if !added.is_magnitude() {
        return Err(Error::Added(added.into()));
    }
    if alpha < R::ONE { Ok(filtered_square(alpha * alpha, added).sqrt()) } else { Ok(alpha) }
}

/// One eigenvalue of A, below 1, under `added` along its axis.
#[inline(always)]
fn filtered_square<R: Real>(square: R, added: R) -> R {
    let seen = (R::ONE - square) * added;
    (square + seen) / (R::ONE + seen)
}

/// $A' = \frac{A + c K + (m + c \det K) I}{1 + c\,\mathrm{tr} K + m + c \det K}$, $c = \det(I -
/// A)$, $m = \mathrm{tr}(\mathrm{adj}(A) K) - \det A\,\mathrm{tr} K$: there and back in one, for
/// eigenvalues below 1.
///
/// All terms are at least 0 and no inverse is taken; only m cancels as an eigenvalue nears 1.
#[inline(always)]
fn filtered<R: Real>(matrix: &Psd<R>, added: &Psd<R>, complement: R) -> Psd<R> {
    let ([xx, xy, yy], [k_xx, k_xy, k_yy]) = (matrix.entries(), added.entries());
    let spread = (matrix.mixed_det(added) - matrix.det() * added.trace()).max(R::ZERO);
    let both = spread + complement * added.det();
    let inverse = R::ONE / (R::ONE + complement * added.trace() + both);
    let entries = [
        (xx + complement * k_xx + both) * inverse,
        (xy + complement * k_xy) * inverse,
        (yy + complement * k_yy + both) * inverse,
    ];
    Psd::with_root_det(entries, ((matrix.det() + both) * inverse).sqrt())
}

/// $A_\perp = (A^{-1} - I)^{-1}$, for eigenvalues below 1: $a/(1 - a)$ along each axis.
///
/// By axes, as entries less determinants would lose the minor one where the major nears 1.
#[inline(always)]
fn to_disk<R: Real>(Eigen { major, minor, axis: [cos, sin] }: Eigen<R>) -> Psd<R> {
    let [p, q] = [major, minor].map(|a| a / (R::ONE - a));
    let entries =
        [p * cos * cos + q * sin * sin, (p - q) * cos * sin, p * sin * sin + q * cos * cos];
    Psd::with_root_det(entries, p.sqrt() * q.sqrt())
}

/// $A = (A_\perp + \det A_\perp\, I)/(1 + \mathrm{tr} A_\perp + \det A_\perp)$.
#[inline(always)]
fn from_disk<R: Real>(projected: &Psd<R>) -> Psd<R> {
    let [xx, xy, yy] = projected.entries();
    let det = projected.det();
    let inverse = R::ONE / (R::ONE + xx + yy + det);
    let entries = [(xx + det) * inverse, xy * inverse, (yy + det) * inverse];
    Psd::with_root_det(entries, projected.root_det() * inverse.sqrt())
}

/// The matrix shrunk in proportion to a trace of at most $10^9$, whose square f32 has.
#[inline(always)]
fn bounded<R: Real>(matrix: Psd<R>) -> Psd<R> {
    matrix * (R::LARGEST / matrix.trace().max(R::LARGEST))
}
