//! Filtering on the projected disk, where GGX is the same distribution again.
//!
//! Layer 3. As $m_z^2 = 1 - |m_{xy}|^2$, D of a centered GGX is $\frac{1}{\pi \sqrt{\det A}\,(1 +
//! m_{xy}^T A_\perp^{-1} m_{xy})^2}$ with $A_\perp = (A^{-1} - I)^{-1}$: on the disk of $(h_x,
//! h_y)$ it is a GGX of roughness $A_\perp$. Kernels of half vectors have a bound there, and
//! widened roughness stays below 1 by itself.

use super::disk::DiskKernel;
use crate::error::Error;
use crate::scalar::{Eigen, Psd, Real};
use crate::slope::{Isotropic, Roughness, Widened};

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
        let [u, v] = kernel.as_slopes().added();
        let matrix = self.matrix();
        // det (I - A), as the product of 1 - a; both factors may be negative.
        let complement = R::ONE - matrix.trace() + matrix.det();
        let smooth = matrix.trace() < R::TWO;
        if smooth && complement >= R::lit(0.125) {
            return Self::from_matrix(filtered(&matrix, [u, v], complement));
        }
        let eigen = matrix.eigen();
        let Eigen { major, minor, axis: [cos, sin] } = eigen;
        if major < R::ONE {
            let [u, v] = bounded([u, v]);
            return Self::from_matrix(from_disk(&to_disk(eigen).with_columns(u, v)));
        }
        if !(minor < R::ONE) {
            return *self;
        }
        // The limit of the formula as the major axis goes to 1: only the minor one sees the kernel.
        let [along_u, along_v] = [u, v].map(|[x, y]| cos * y - sin * x);
        let across = filtered_square(minor, along_u * along_u + along_v * along_v);
        Self::from_matrix(Psd::from_axes(major.sqrt(), across.sqrt(), cos, sin))
    }
}

impl<R: Real> DiskKernel<R> {
    /// An isotropic GGX under this kernel: [`Roughness::widened_on_disk`] without a matrix.
    ///
    /// With $a = \alpha^2$ and $b = 1 - a$: $A' = \frac{(a + a b\,\mathrm{tr} K + b^2 \det K) I +
    /// b^2 K}{1 + b\,\mathrm{tr} K + b^2 \det K}$; an alpha of at least 1 stays. Total and without
    /// a branch, for loops over pixels.
    ///
    /// ```
    /// use lobe::{Isotropic, LobeShape, PixelFilter, Roughness, filter::DiskKernel};
    /// let kernel = DiskKernel::of([0.2_f64, 0.0], [0.1, 0.2], PixelFilter::BOX);
    /// let shape = kernel.widen(Isotropic::saturating(0.3));
    /// let matrix = Roughness::from_alpha(0.3)?.widened_on_disk(&kernel).matrix();
    /// assert!((shape.root_det() - matrix.root_det()).abs() < 1e-15);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_disk_kernel_widen")]
    #[inline(always)]
    pub fn widen(&self, shape: Isotropic<R>) -> Widened<Isotropic<R>> {
        let [u, v] = self.as_slopes().columns();
        let alpha = shape.alpha();
        let square = alpha * alpha;
        let rest = (R::ONE - square).max(R::ZERO);
        let trace = u[0] * u[0] + u[1] * u[1] + (v[0] * v[0] + v[1] * v[1]);
        let cross = rest * (u[0] * v[1] - u[1] * v[0]);
        let det = cross * cross;
        let root = (R::ONE / (R::ONE + rest * trace + det)).sqrt();
        let alpha = (square + square * rest * trace + det).sqrt() * root;
        let scale = rest * root;
        let [u, v] = [u, v].map(|column| column.map(|x| x * scale));
        Widened::new(Isotropic::saturating(alpha), u, v)
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
/// A)$, $m = \mathrm{tr}(\mathrm{adj}(A) K) - \det A\,\mathrm{tr} K$, of the columns of K: there
/// and back in one, for eigenvalues below 1.
///
/// All terms are at least 0 and no inverse is taken; only m cancels as an eigenvalue nears 1.
#[inline(always)]
fn filtered<R: Real>(matrix: &Psd<R>, columns: [[R; 2]; 2], complement: R) -> Psd<R> {
    let root = complement.sqrt();
    let [u, v] = columns.map(|column| column.map(|x| x * root));
    let squares = |[x, y]: [R; 2]| x * x + y * y;
    let [a, b] = columns;
    let mixed = matrix.adjugate_form(a) + matrix.adjugate_form(b);
    let spread = (mixed - matrix.det() * (squares(a) + squares(b))).max(R::ZERO);
    let cross = root * (a[0] * b[1] - a[1] * b[0]);
    let both = spread + cross * cross;
    let inverse = R::ONE / (R::ONE + squares(u) + squares(v) + both);
    let side = both.sqrt();
    matrix.with_columns(u, v).with_columns([side, R::ZERO], [R::ZERO, side]) * inverse
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

/// Columns shrunk in proportion to a trace of at most $10^9$, whose square f32 has.
#[inline(always)]
fn bounded<R: Real>([u, v]: [[R; 2]; 2]) -> [[R; 2]; 2] {
    let trace = u[0] * u[0] + u[1] * u[1] + v[0] * v[0] + v[1] * v[1];
    let factor = (R::LARGEST / trace.max(R::LARGEST)).sqrt();
    [u, v].map(|column| column.map(|x| x * factor))
}
