//! Gaussian kernels: exact on Beckmann, by variance addition or by quadrature on GGX.
//!
//! Layer 3.

use super::kernel::Kernel;
use crate::ndf::Ggx;
use crate::scalar::{Psd, Real};
use crate::slope::{Lobe, LobeShape, Roughness, Widened};

impl<R: Real> Roughness<R> {
    /// The roughness under a Gaussian kernel, $A' = A + 2\Sigma_K$.
    ///
    /// For Beckmann this is the convolution, exactly. For GGX it is variance addition, what
    /// Kaplanyan, Tokuyoshi and every engine do: its peak is too bright by 8, 24, 22 and 14 % at
    /// $2\sigma_K^2/\alpha^2$ = 0.1, 1, 3 and 10, and its tail decays from the widened alpha, where
    /// the true one keeps $\alpha^2/(\pi s^4)$. A mirror under a regular kernel becomes a regular
    /// lobe.
    ///
    /// Source: Kaplanyan et al. 2016, Eq. 15; Tokuyoshi 2017, Eq. 3.
    ///
    /// ```
    /// use lobe::{Footprint, Kernel, PixelFilter, Roughness};
    /// let kernel = Kernel::of(&Footprint::rectangle([0.2_f64, 0.2]), PixelFilter::KAPLANYAN);
    /// let widened = Roughness::from_alpha(0.1)?.widened(&kernel);
    /// assert!((widened.alphas().major - (0.01_f64 + 0.02).sqrt()).abs() < 1e-15);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_roughness_widened")]
    #[must_use]
    #[inline]
    pub fn widened(&self, kernel: &Kernel<R>) -> Self {
        let [u, v] = kernel.added();
        Self::from_matrix(self.matrix().with_columns(u, v))
    }
}

impl<R: Real> Kernel<R> {
    /// A shape under this kernel, $A' = A + 2\Sigma_K$: [`Roughness::widened`] without a matrix.
    ///
    /// For lobes that are widened for one evaluation or a few. Total and without a branch. An
    /// isotropic shape costs least, and a shape with a mean keeps it.
    ///
    /// ```
    /// use lobe::{Footprint, Ggx, Isotropic, Kernel, PixelFilter};
    /// let footprint = Footprint::from_slopes([0.1_f32, 0.0], [0.02, 0.05]);
    /// let shape = Isotropic::saturating(0.1);
    /// let filtered = Ggx::new(Kernel::of(&footprint, PixelFilter::BOX).widen(shape));
    /// assert!(filtered.slope_pdf([0.0, 0.0]) < Ggx::new(shape).slope_pdf([0.0, 0.0]));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_kernel_widen")]
    #[inline(always)]
    pub fn widen<S: LobeShape<Scalar = R>>(&self, shape: S) -> Widened<S> {
        let [u, v] = self.columns();
        Widened::new(shape, u, v)
    }
}

impl<R: Real> Lobe<R> {
    /// The lobe under a Gaussian kernel: the same mean, [`Roughness::widened`].
    ///
    /// ```
    /// use lobe::{Footprint, Ggx, Kernel, Lobe, PixelFilter, Roughness};
    /// let lobe = Lobe::centered(Roughness::from_alpha(0.01_f32)?);
    /// let footprint = Footprint::from_slopes([0.1, 0.0], [0.02, 0.05]);
    /// let filtered = lobe.widened(&Kernel::of(&footprint, PixelFilter::KAPLANYAN));
    /// let ndf = Ggx::new(filtered.shape());
    /// let up = [0.0, 0.0, 1.0];
    /// assert!(ndf.brdf(up, up) < Ggx::new(lobe.shape()).brdf(up, up));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_lobe_widened")]
    #[must_use]
    #[inline]
    pub fn widened(&self, kernel: &Kernel<R>) -> Self {
        self.with_roughness(self.roughness().widened(kernel))
    }
}

/// GGX convolved with a Gaussian kernel, $(P_{22} * \mathcal N(0, \Sigma_K))(s)$, by quadrature.
///
/// GGX is a scale mixture of Beckmann lobes, so with $M = A/t + 2\Sigma_K$ and $d = s - \mu$
/// $$\int_0^\infty e^{-t}\, \frac{e^{-d^T M^{-1} d}}{\pi \sqrt{\det M}}\, dt.$$
/// Trapezoid rule in $x = \ln t$ with the determinant and adjugate form of M as sums of
/// non-negative terms; the range follows the exponent, so that far tails are as exact as the peak.
/// Error below 1e-5 (f32) and 1e-12 (f64), relative; 50 to 350 nodes: a reference, not a shading
/// method. With a zero kernel it is GGX itself; for a mirror it is the kernel's Gaussian; where the
/// sum is singular, 0. For slopes to 1e3 and alphas to 30; where far beyond them the quadrature
/// leaves the range of the precision, variance addition stands in.
///
/// Source: the mixture, d'Eon 2023 "Student-T and Beyond", Eq. 7, for two degrees of freedom.
///
/// ```
/// use lobe::{Footprint, Kernel, Lobe, PixelFilter, Roughness, filter};
/// let lobe = Lobe::centered(Roughness::from_alpha(0.1_f64)?);
/// let kernel = Kernel::of(&Footprint::rectangle([0.1, 0.1]), PixelFilter::KAPLANYAN);
/// let exact = filter::ggx_gaussian_mean(&lobe, [0.0, 0.0], &kernel);
/// let added = lobe.widened(&kernel);
/// let proxy = lobe::Ggx::new(added.shape()).slope_pdf([0.0, 0.0]);
/// assert!(proxy > 1.1 * exact); // variance addition is too bright
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_ggx_gaussian_mean")]
pub fn ggx_gaussian_mean<R: Real>(
    lobe: &Lobe<R>,
    slope: impl Into<[R; 2]>,
    kernel: &Kernel<R>,
) -> R {
    let base = lobe.roughness().matrix();
    let [u, v] = kernel.added();
    let added = Psd::outer_sum(u, v);
    if (base + added).is_singular() {
        return R::ZERO;
    }
    // d^T adj(M) d = base_form / t + added_form; det M = base_det / t^2 + mixed / t + added_det.
    let (slope, mean) = (slope.into(), lobe.mean());
    let d = [slope[0] - mean[0], slope[1] - mean[1]];
    let (base_form, added_form) = (base.adjugate_form(d), added.adjugate_form(d));
    let (base_det, mixed, added_det) = (base.det(), base.mixed_det(&added), added.det());

    // The integrand t e^{-t - E(t)} / sqrt(det M) falls at least like t below the smaller of 1 and
    // the t where E(t) = 1, and like e^{-t} above 1: cut at relative 1e-8 (f32) and 1e-14 (f64). In
    // f32 the nodes are exact, and the smallest t is no subnormal number.
    let (below, step, least_steps, most_reaches) =
        if R::SINGLE { (18.0, 0.4375, 49, 39) } else { (32.0, 0.28, 127, 52) };
    let (below, step) = (R::lit(below), R::lit(step));
    let exponent_at =
        |t: R| (base_form / t + added_form) / ((base_det / t + mixed) / t + added_det);
    // E(t) <= E'(0) t: lower x until E is small, by four steps at a time.
    let reach = R::lit(4.0) * step;
    let mut reaches = 0;
    while reaches < most_reaches
        && exponent_at((-(reach * R::lit(f64::from(reaches)))).exp()) > R::ONE
    {
        reaches += 1;
    }
    let start = -(below + reach * R::lit(f64::from(reaches)));
    let mut sum = R::ZERO;
    for node in 0..=least_steps + 4 * reaches {
        let t = (start + step * R::lit(f64::from(node))).exp();
        let det = (base_det / t + mixed) / t + added_det;
        sum = sum + t * (-t - exponent_at(t)).exp() / det.sqrt();
    }
    let mean = sum * (step * R::lit(core::f64::consts::FRAC_1_PI));
    if mean.is_finite() { mean } else { Ggx::new(lobe.widened(kernel).shape()).slope_pdf(slope) }
}
