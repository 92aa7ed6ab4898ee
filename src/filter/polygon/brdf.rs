//! The BRDF over a footprint: the mean density, at the height of the normals that it comes from.
//!
//! Layer 3.

use super::secant::secant_ratio;
use super::strip::Whitened;
use crate::filter::groove;
use crate::ndf::{GgxDistribution, Ndf};
use crate::scalar::exact::{two_product, two_sum};
use crate::scalar::{Internal, Real};
use crate::slope::{Footprint, Whiten};

impl<S: Whiten> Ndf<GgxDistribution, S> {
    /// The BRDF with D averaged over a footprint around the half vector's slope; masking and
    /// shadowing unfiltered.
    ///
    /// $\tilde D = \overline{P_{22}} / m_z^4$, then as [`Ndf::brdf`], with the height $m_z$ of the
    /// normals that the mean comes from: of a zero footprint the half vector's, and then the result
    /// is the BRDF. It is the BRDF as well where $P_{22}$ has no normal number, unless the
    /// footprint reaches the lobe. Sides of NaN count as huge.
    ///
    /// Kaplanyan divides by the half vector's $h_z^4$: of a half vector near the horizon whose
    /// footprint reaches the lobe the mean is the lobe's, and the factor, far beyond a million, is
    /// not. What a pixel sees is the mean of $P_{22}/m_z^4$. For isotropic lobes of alpha up to 1
    /// ours is $\frac{1}{\pi\alpha^2} (\alpha^2 + (1 - \alpha^2) \sqrt M)^2$ with $M = \pi\alpha^2
    /// \overline{P_{22}}$: an upper bound of that mean (by Jensen's inequality), never twice as
    /// large, never above the peak. For any other centered lobe it is an estimate: over random
    /// lobes of alphas 0.05 to 0.9, slopes and footprints up to 2, within 10 % in 98 of 100 draws
    /// and within a factor 2 in all; up to 30, within 50 % in 96 of 100, never above 4 times the
    /// mean, and in rare cases as low as a thirtieth of it (tests/laws/over.rs).
    ///
    /// A mirror's or a groove's mean is taken at the height of the mirror's own normal, or of the
    /// groove's densest in the footprint: $\overline{P_{22}} (1 + |s|^2)^2 V$, with V of
    /// [`Ndf::visibility`]. It is 0 over no area, as is the BRDF.
    ///
    /// Rounding: f32 within 1e-4 where the lobe lies within ten alphas, 1e-3 anywhere, and for
    /// alphas above 1 another 64 roundings times alpha^2; f64 as [`Ndf::parallelogram_mean`].
    ///
    /// Source: Kaplanyan et al. 2016, Eq. 11 and section 4.4, but for the factor.
    ///
    /// ```
    /// use lobe::{Footprint, Ggx, Isotropic};
    /// let ggx = Ggx::new(Isotropic::new(0.01_f64)?);
    /// let (wo, wi) = ([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]);
    /// let point = ggx.brdf_over(wo, wi, &Footprint::rectangle([0.0, 0.0]));
    /// assert!((point / ggx.brdf(wo, wi) - 1.0).abs() < 1e-12);
    /// // A mirror over a pixel: one over the area, over 4 times both cosines.
    /// let mirror = Ggx::new(Isotropic::new(0.0_f64)?);
    /// let seen = mirror.brdf_over(wo, wi, &Footprint::rectangle([0.01, 0.01]));
    /// assert!((seen - 3906.25).abs() < 1e-9);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_ggx_brdf_over")]
    pub fn brdf_over(
        &self,
        wo: impl Into<[S::Scalar; 3]>,
        wi: impl Into<[S::Scalar; 3]>,
        footprint: &Footprint<S::Scalar>,
    ) -> S::Scalar {
        let (wo, wi) = (wo.into(), wi.into());
        let (zero, one) = (S::Scalar::ZERO, S::Scalar::ONE);
        let brdf = self.brdf(wo, wi);
        let (z, z_low) = two_sum(wo[2], wi[2]);
        // The slope to twice the precision, as a narrow tilted lobe wants it.
        let along = |k: usize| {
            let (g, g_low) = two_sum(wo[k], wi[k]);
            let slope = (-g / z).kept();
            let (product, error) = two_product(slope, z);
            (slope, (-(g + product).kept() - error - g_low - slope * z_low) / z)
        };
        let ((x, x_low), (y, y_low)) = (along(0), along(1));
        let footprint = &footprint.bounded();
        let offset = self.offset_of([x, y], [x_low, y_low]);
        let whitened = Whitened::new(self.shape(), offset.0, offset.1, footprint);
        let side2 = whitened.longer_side_squared();
        if let Some(covered) = groove::unresolved(self.shape(), side2, offset, footprint) {
            return if z > zero { self.groove_over(wo, wi, covered) } else { zero };
        }
        let mean = self.mean_of(&whitened, offset, footprint);
        let q = whitened.midpoint_squared();
        let pi_point = one / (self.shape().root_det() * (one + q) * (one + q));
        let most = S::Scalar::lit(groove::LARGEST_GAIN) * pi_point;
        if !(pi_point >= S::Scalar::MIN_POSITIVE) || mean * S::Scalar::PI > most {
            // The density at the half vector says nothing about the mean: a footprint that reaches
            // the lobe has one.
            let seen = groove::seen(self.shape(), offset, footprint, mean);
            let reached = z > zero && seen.mean > zero;
            return if reached { self.groove_over(wo, wi, seen).max(brdf) } else { brdf };
        }
        if !(z > zero) {
            return zero;
        }
        let ratio = (mean * S::Scalar::PI / pi_point).sqrt();
        let groove = || self.groove_place(offset, footprint);
        let secant = secant_ratio([x, y], q, ratio, footprint, &whitened, groove);
        shaded(mean, self.visibility(wo, wi), (one + x * x + y * y) * secant)
    }

    /// [`Ndf::brdf_over`] of a mirror or a groove, for a half vector above the surface: the density
    /// of normals that its footprint covers, at their own height.
    #[inline(never)]
    fn groove_over(
        &self,
        wo: [S::Scalar; 3],
        wi: [S::Scalar; 3],
        groove::Covered { mean, place }: groove::Covered<S::Scalar>,
    ) -> S::Scalar {
        let [x, y] = self.at_place(place);
        shaded(mean, self.visibility(wo, wi), S::Scalar::ONE + x * x + y * y)
    }

    /// The slope that the mean comes from, and its q, if the lobe is at least 300 times as long as
    /// wide and the footprint reaches at least 300 of the lobe's widths across it; else none.
    #[inline(never)]
    fn groove_place(
        &self,
        offset: ([S::Scalar; 2], [S::Scalar; 2]),
        footprint: &Footprint<S::Scalar>,
    ) -> Option<([S::Scalar; 2], S::Scalar)> {
        let (axis, alpha) = self.shape().major();
        let least = S::Scalar::lit(groove::BRUSHED) * self.shape().root_det();
        if !(alpha * alpha.min(groove::reach_across(axis, footprint)) >= least) {
            return None;
        }
        let place = groove::covered(self.shape(), offset, footprint).place;
        let [x, y] = place.map(|x| (x / alpha).kept());
        Some((self.at_place(place), x * x + y * y))
    }

    /// A slope from its difference to the mean slope.
    #[inline(always)]
    fn at_place(&self, [x, y]: [S::Scalar; 2]) -> [S::Scalar; 2] {
        // The origin less the mean slope.
        let ([a, b], _) = self.shape().offset([S::Scalar::ZERO; 2]);
        [x - a, y - b]
    }
}

/// The BRDF of a mean density of slopes at normals of this squared secant.
#[inline(always)]
fn shaded<R: Real>(mean: R, visibility: R, secant2: R) -> R {
    // `max` drops NaN: of a NaN footprint, or of 0 times infinity.
    (((mean * visibility).kept() * secant2).kept() * secant2).max(R::ZERO).min(R::MAX)
}
