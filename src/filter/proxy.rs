//! Proxies: a GGX again, as bright at its peak as GGX under a pixel really is.
//!
//! Layer 3. Variance addition ([`Roughness::widened`]) is 8 to 24 % too bright at the peak,
//! Kaplanyan's Eq. 20 as it is used (`kaplanyan_proxy_alpha`) up to
//! 3.1 times too dark. These have the peak right. No proxy has the tail right: it decays from the
//! widened alpha, where the filtered lobe keeps $\alpha^2/(\pi s^4)$.
//!
//! What the isotropic formulas mean for any matrix: $A' = A + t K$, the kernel's own shape, with
//! the one number t that gives the peak, $\pi^2 \det(A + t K) = 1/\bar P(0)^2$. One lobe has one
//! peak: nothing else is matched.

use super::gaussian::ggx_gaussian_mean;
use super::kernel::Kernel;
use crate::error::Error;
use crate::ndf::Ggx;
use crate::scalar::expint::reciprocal_e2_tail;
use crate::scalar::{Psd, Real};
use crate::slope::{Anisotropic, Footprint, Lobe, LobeShape, Roughness, Widened};

/// alpha of the GGX with the peak of GGX averaged over a square: Kaplanyan's Eq. 20, re-derived.
///
/// $\alpha'^2 = \frac{w \sqrt{4\alpha^2 + w^2}}{4 \arctan(w/\sqrt{4\alpha^2 + w^2})}$: $\alpha^2 +
/// w^2/3$ for small w, $w^2/\pi$ for large. `width` is the full width w of the square, in slope.
/// Exact; a few roundings in f32. $\sqrt{\alpha^2 + w^2/\pi}$ is within 0.55 % of it and is
/// variance addition with
/// [`PixelFilter::TOKUYOSHI_KAPLANYAN`](super::PixelFilter::TOKUYOSHI_KAPLANYAN).
///
/// Source: Kaplanyan et al. 2016, Eq. 18 to 20, solved anew: the printed line is garbled, and its
/// last form (`kaplanyan_proxy_alpha`) is not close to it.
///
/// # Errors
/// [`Error::Alpha`], [`Error::Width`] outside $[0, 10^9]$.
///
/// ```
/// use lobe::{Ggx, Isotropic, filter::box_peak_alpha};
/// let (alpha, width) = (0.1_f64, 0.3);
/// let mean = Ggx::new(Isotropic::new(alpha)?).rectangle_mean([0.0, 0.0], [width, width]);
/// let proxy = Ggx::new(Isotropic::new(box_peak_alpha(alpha, width)?)?).slope_pdf([0.0, 0.0]);
/// assert!((proxy / mean - 1.0).abs() < 1e-12);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "beta")]
#[doc(alias = "lobe_box_peak_alpha")]
pub fn box_peak_alpha<R: Real>(alpha: R, width: R) -> Result<R, Error> {
    if !alpha.is_magnitude() {
        return Err(Error::Alpha(alpha.into()));
    }
    if !width.is_magnitude() {
        return Err(Error::Width(width.into()));
    }
    let diagonal = (R::lit(4.0) * alpha * alpha + width * width).sqrt();
    let x = width / diagonal.max(R::MIN_POSITIVE);
    // x / atan x is 1 where x has no square.
    let ratio = if x * x >= R::MIN_POSITIVE { x / x.atan() } else { R::ONE };
    Ok(R::HALF * diagonal * ratio.sqrt())
}

/// alpha of the GGX with the peak of GGX under an isotropic Gaussian of deviation `sigma`.
///
/// $\alpha'^2 = k / (1 - x e^x E_1(x))$ with $k = 2\sigma^2$, $x = \alpha^2/k$: $\alpha^2 + 2k$ for
/// small k, $k$ for large. Computed as $\alpha^2 + k g(x)$, $1 < g \le 2$: 1e-6 in f32, 1e-15 in
/// f64.
///
/// Source: derived here from the mixture of [`ggx_gaussian_mean`] at the lobe's center.
///
/// # Errors
/// [`Error::Alpha`], [`Error::Sigma`] outside $[0, 10^9]$.
///
/// ```
/// use lobe::filter::gaussian_peak_alpha;
/// let alpha = gaussian_peak_alpha(0.1_f64, 1e-4)?;
/// assert!((alpha.powi(2) - (0.01 + 2.0 * 2e-8)).abs() < 1e-13);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "lobe_gaussian_peak_alpha")]
pub fn gaussian_peak_alpha<R: Real>(alpha: R, sigma: R) -> Result<R, Error> {
    if !alpha.is_magnitude() {
        return Err(Error::Alpha(alpha.into()));
    }
    if !sigma.is_magnitude() {
        return Err(Error::Sigma(sigma.into()));
    }
    let added = R::TWO * sigma * sigma;
    let square = alpha * alpha;
    if !(added >= R::MIN_POSITIVE) {
        return Ok(alpha);
    }
    Ok((square + added * reciprocal_e2_tail(square / added)).sqrt())
}

/// The kernel whitened by the lobe, $A^{-1} K$: its trace, and the root of its determinant.
struct Whitened<R> {
    trace: R,
    root_det: R,
}

impl<R: Real> Whitened<R> {
    /// `None` for a mirror or a groove, and for a kernel so large (a trace above 1e18) that the
    /// lobe counts as one.
    #[inline(always)]
    fn of(lobe: &Psd<R>, kernel: &Psd<R>) -> Option<Self> {
        if lobe.is_singular() {
            return None;
        }
        let inverse = R::ONE / lobe.root_det().max(R::MIN_POSITIVE);
        let trace = (lobe.mixed_det(kernel) * inverse).kept() * inverse;
        let root_det = kernel.root_det() * inverse;
        (trace <= R::LARGEST * R::LARGEST).then_some(Self { trace, root_det })
    }

    /// t with $\det(I + t A^{-1} K) = r^2$.
    fn factor(&self, r: R) -> R {
        let excess = (r - R::ONE).max(R::ZERO).sqrt() * (r + R::ONE).sqrt();
        positive_root(self.root_det, self.trace, excess)
    }
}

/// The largest $\kappa$ and the largest minor axis that the fit is asked for, and what a mirror
/// has: beyond them the factor is within 3e-6 of its limit, and products of four stay in f32. Of
/// f64, whose factor then is its limit, 1e24.
const LARGEST_KAPPA: f64 = 1e10;
const LARGEST_MINOR: f64 = 1e6;
const LARGEST_IN_DOUBLE: f64 = 1e24;

/// A fit of the factor for which $A + tK$ has the peak of GGX under the Gaussian of $K =
/// 2\Sigma_K$, from $\det A$, $\mathrm{tr}(\mathrm{adj}(A)\, K)$ and $\det K$.
///
/// The first term is the isotropic case, where $\kappa$ is k/alpha^2: largest error of alpha'^2
/// 0.04 % over any kappa. The second is what lines need, $4/\pi - 1$ in the limit, and fades as
/// the kernel's minor axis grows. Largest error of the peak over kernels of every size and
/// aspect: 1.32 %, at 126 by 4 alpha^2 (`the_fit_of_the_peak_errs_as_stated` in
/// tests/laws/proxy.rs). Fitted by `tests/golden/fit.py`, `peak_round` and `peak_long`.
#[doc(alias = "lobe_peak_factor")]
#[inline(always)]
fn fitted_factor<R: Real>(det: R, mixed: R, kernel_det: R) -> R {
    let (lit, one, least) = (R::lit, R::ONE, R::MIN_POSITIVE);
    let [largest, largest_minor] =
        if R::SINGLE { [LARGEST_KAPPA, LARGEST_MINOR] } else { [LARGEST_IN_DOUBLE; 2] };
    let kappa = (R::HALF * (mixed / det.max(least))).min(lit(largest));
    let kappa = if det >= least { kappa } else { lit(largest) };
    let s = kappa.sqrt();
    // The kernel's minor axis in units of the lobe, and how far from round it is there.
    let inverse = one / mixed.max(least);
    let minor = (kernel_det * inverse).min(lit(largest_minor));
    let line = (one - lit(4.0) * minor * (det * inverse)).max(R::ZERO);
    let line = if mixed > R::ZERO { line } else { R::ZERO };
    // Two quotients over one divisor.
    let (round, under_round) =
        (one + lit(1.5226) * s, one + lit(1.5377) * s + kappa * (lit(2.508) + lit(0.22979) * s));
    let growth = lit(0.2104) * kappa;
    let under_long = (one + lit(0.2109) * minor) * (one + lit(0.08939) * s + growth);
    let long = lit(4.0 * core::f64::consts::FRAC_1_PI - 1.0) * (line * growth);
    one + (round * under_long + long * under_round) / (under_round * under_long)
}

/// t with $t^2 d^2 + t m = e^2$ from d, m and e, none negative: without cancellation, and without
/// their squares, which leave f32.
fn positive_root<R: Real>(d: R, m: R, e: R) -> R {
    let twice = (R::TWO * d * e).min(R::MAX);
    let scale = m.max(twice);
    if !(scale > R::ZERO) {
        // A mirror. Over a small area, m is 0 and 2 d e underflows to 0: t = e/d. Along a line d is
        // 0, and no t gives e.
        return if d > R::ZERO { e / d.max(R::MIN_POSITIVE) } else { R::ZERO };
    }
    let scale = scale.max(R::MIN_POSITIVE);
    let (x, y) = ((m / scale).kept(), (twice / scale).kept());
    let sum = m + scale * (x * x + y * y).sqrt();
    R::TWO * e * (e / sum.max(R::MIN_POSITIVE))
}

impl<R: Real> Kernel<R> {
    /// The kernel's columns times the root of [`fitted_factor`].
    #[inline(always)]
    fn peak_columns<S: LobeShape<Scalar = R>>(&self, shape: &S) -> [[R; 2]; 2] {
        let [u, v] = self.added();
        let (root_det, cross) = (shape.root_det(), u[0] * v[1] - u[1] * v[0]);
        let mixed = shape.adjugate_form(u) + shape.adjugate_form(v);
        let root = fitted_factor(root_det * root_det, mixed, cross * cross).sqrt();
        [u.map(|x| x * root), v.map(|x| x * root)]
    }

    /// A shape under this kernel with the peak of GGX there: [`Roughness::peak_fitted`] without a
    /// matrix.
    ///
    /// ```
    /// use lobe::{Footprint, Ggx, Isotropic, Kernel, PixelFilter};
    /// let kernel = Kernel::of(&Footprint::rectangle([0.2_f32, 0.2]), PixelFilter::KAPLANYAN);
    /// let shape = Isotropic::saturating(0.1);
    /// let fitted = Ggx::new(kernel.widen_to_peak(shape));
    /// let added = Ggx::new(kernel.widen(shape));
    /// assert!(fitted.slope_pdf([0.0, 0.0]) < 0.9 * added.slope_pdf([0.0, 0.0]));
    /// ```
    #[doc(alias = "lobe_kernel_widen_to_peak")]
    #[inline(always)]
    pub fn widen_to_peak<S: LobeShape<Scalar = R>>(&self, shape: S) -> Widened<S> {
        let [u, v] = self.peak_columns(&shape);
        Widened::new(shape, u, v)
    }
}

impl<R: Real> Roughness<R> {
    /// The roughness $A + t K$, $K = 2\Sigma_K$, with the exact peak of GGX under the Gaussian
    /// kernel.
    ///
    /// By [`ggx_gaussian_mean`]: a reference; [`Roughness::peak_fitted`] is for shading. For
    /// isotropic A and K it is [`gaussian_peak_alpha`]. t lies in \[1, 2\]; for a mirror it is 1,
    /// where GGX is the kernel; for a mirror along one axis only it is what the peak asks for,
    /// unless the kernel is a line along the other axis: then the peak has no end, and t is 1.
    ///
    /// ```
    /// use lobe::{Footprint, Kernel, PixelFilter, Roughness, filter::gaussian_peak_alpha};
    /// let kernel = Kernel::of(&Footprint::rectangle([0.2_f64, 0.2]), PixelFilter::KAPLANYAN);
    /// let matched = Roughness::from_alpha(0.1)?.peak_matched(&kernel);
    /// assert!((matched.alphas().major / gaussian_peak_alpha(0.1, 0.1)? - 1.0).abs() < 1e-9);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_roughness_peak_matched")]
    #[must_use]
    pub fn peak_matched(&self, kernel: &Kernel<R>) -> Self {
        let peak = ggx_gaussian_mean(&Lobe::centered(*self), [R::ZERO; 2], kernel);
        let [u, v] = kernel.added();
        self.with_peak(&Psd::outer_sum(u, v), peak, [1.0, 2.0])
    }

    /// The same by a fit without transcendental functions: the peak is within 1.32 % for any A and
    /// kernel; where both are isotropic, alpha'^2 is within 0.04 %.
    ///
    /// Variance addition is 8 to 24 % too bright there. One GGX cannot have both the peak and the
    /// flanks: against the exact convolution this one's L1 error is no smaller than variance
    /// addition's, and in pictures neither is better throughout (the report measures both). A
    /// mirror becomes the kernel; a kernel of 0 leaves A.
    ///
    /// ```
    /// use lobe::{Footprint, Kernel, PixelFilter, Roughness};
    /// let kernel =
    ///     Kernel::of(&Footprint::from_slopes([0.3_f64, 0.1], [0.0, 0.02]), PixelFilter::BOX);
    /// let base = Roughness::from_alphas(0.05, 0.02, 0.4)?;
    /// let (fitted, matched) = (base.peak_fitted(&kernel), base.peak_matched(&kernel));
    /// assert!((fitted.matrix().root_det() / matched.matrix().root_det() - 1.0).abs() < 0.0132);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_roughness_peak_fitted")]
    #[must_use]
    #[inline]
    pub fn peak_fitted(&self, kernel: &Kernel<R>) -> Self {
        let matrix = self.matrix();
        let [u, v] = kernel.peak_columns(&Anisotropic::new(*self));
        Self::from_matrix(matrix.with_columns(u, v))
    }

    /// The roughness $A + t (u u^T + v v^T)$ with the exact peak of GGX averaged over the
    /// footprint.
    ///
    /// By [`Ndf::parallelogram_mean`](crate::Ndf::parallelogram_mean) at the center. For isotropic
    /// A and a square it is [`box_peak_alpha`]; t is 1/3 for small footprints, $1/\pi$ for large
    /// areas, $4/\pi^2$ for long lines, down to $2/\pi^2$ where both sides lie along one line. A
    /// mirror gets $1/\pi$, and so does a groove over a line along it.
    ///
    /// ```
    /// use lobe::{Footprint, Ggx, Roughness, filter::box_peak_alpha};
    /// let square = Footprint::rectangle([0.3_f64, 0.3]);
    /// let matched = Roughness::from_alpha(0.1)?.peak_matched_over(&square);
    /// assert!((matched.alphas().major / box_peak_alpha(0.1, 0.3)? - 1.0).abs() < 1e-9);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_roughness_peak_matched_over")]
    #[must_use]
    pub fn peak_matched_over(&self, footprint: &Footprint<R>) -> Self {
        let footprint = footprint.bounded();
        let kernel = Psd::outer_sum(footprint.u, footprint.v);
        let peak = Ggx::new(Anisotropic::new(*self)).parallelogram_mean([R::ZERO; 2], &footprint);
        if !(peak > R::ZERO) {
            // A mirror over no area, or a groove over a line along it: the peak has no end.
            return *self + Self::from_matrix(kernel * R::lit(core::f64::consts::FRAC_1_PI));
        }
        self.with_peak(&kernel, peak, [0.2, 0.41])
    }

    /// $A + t K$ with this peak; t is known to lie in a range, which rounding may leave for small
    /// kernels.
    fn with_peak(&self, kernel: &Psd<R>, peak: R, [least, most]: [f64; 2]) -> Self {
        let matrix = self.matrix();
        let root_det = Anisotropic::new(*self).root_det();
        // The peak of a lobe under a very wide kernel underflows: it must not become a divisor
        // of 0.
        let least_peak = R::MIN_POSITIVE;
        let factor = if let Some(whitened) = Whitened::of(&matrix, kernel) {
            whitened.factor(R::ONE / (R::PI * peak * root_det).max(least_peak))
        } else {
            let ratio = R::ONE / (R::PI * peak).max(least_peak);
            positive_root(kernel.root_det(), matrix.mixed_det(kernel), ratio)
        };
        // `peak` is 0 if the averaged density has no finite peak. No t gives such a peak; the least
        // one is taken.
        let factor = if peak > R::ZERO {
            factor.max(R::lit(least)).min(R::lit(most))
        } else {
            R::lit(least)
        };
        *self + Self::from_matrix(*kernel * factor)
    }
}
