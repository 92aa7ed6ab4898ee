//! Masking and shadowing, all derived from the projected area.
//!
//! Layer 2. The projected area has no pole at grazing angles and holds for means; Lambda,
//! G1, G2 and visibility follow from it. Normalization is LEADR's meso form: c(w) is the projected
//! area of the mean plane. (The macro form, G1 = w_z / sigma, gives a negative G2 for tilted
//! means.)

use super::distribution::{Distribution, Ndf};
use crate::scalar::Real;
use crate::slope::LobeShape;

impl<D: Distribution, S: LobeShape> Ndf<D, S> {
    /// Projected area of the microsurface, $\sigma(w) = \int \max(0, w \cdot m)\, D(m)\, dm$.
    ///
    /// GGX: $\sigma = (c + \sqrt{c^2 + a^2})/2$. Beckmann:
    /// $\sigma = \frac{c}{2}(1 + \mathrm{erf}\,v) + \frac{a}{2\sqrt\pi} e^{-v^2}$, $v = c/a$. With
    /// $c = w_z - \mu \cdot w_{xy}$ and $a^2 = w_{xy}^T A w_{xy}$. For any `w`, above or below the
    /// horizon; homogeneous of degree 1. At normal incidence $\sigma = c$; for a mirror $\max(c,
    /// 0)$.
    ///
    /// Source: Heitz 2014, LEADR supplement 1.5; closed forms as in Dupuy's dj_brdf.
    ///
    /// ```
    /// use lobe::{Ggx, Isotropic};
    /// let ndf = Ggx::new(Isotropic::new(0.5_f64)?);
    /// assert_eq!(ndf.projected_area([0.0, 0.0, 1.0]), 1.0);
    /// assert_eq!(ndf.projected_area([1.0, 0.0, 0.0]), 0.25);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "sigma")]
    #[doc(alias = "lobe_ggx_projected_area")]
    #[doc(alias = "lobe_beckmann_projected_area")]
    #[inline(always)]
    pub fn projected_area(&self, w: impl Into<[S::Scalar; 3]>) -> S::Scalar {
        let w = w.into();
        let c = self.shape().mean_area(w);
        c.max(S::Scalar::ZERO) + D::excess(c.abs(), self.shape().stretch_squared(w))
    }

    /// Smith's $\Lambda(w) = \sigma(w)/c(w) - 1$, exact, without that difference.
    ///
    /// 0 at normal incidence and for a mirror; grows without bound towards the horizon of the mean
    /// plane; from there on down, the largest finite number.
    ///
    /// ```
    /// use lobe::{Ggx, Isotropic};
    /// let ndf = Ggx::new(Isotropic::new(0.01_f32)?);
    /// // A difference of ones would have no digits left.
    /// let lambda = ndf.lambda([1e-3, 0.0, 1.0]);
    /// assert!((lambda - 2.5e-11).abs() < 1e-17);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "Lambda")]
    #[doc(alias = "lobe_ggx_lambda")]
    #[doc(alias = "lobe_beckmann_lambda")]
    #[inline(always)]
    pub fn lambda(&self, w: impl Into<[S::Scalar; 3]>) -> S::Scalar {
        let w = w.into();
        let c = self.shape().mean_area(w);
        let excess = D::excess(c.abs(), self.shape().stretch_squared(w));
        let lambda = excess / c.max(S::Scalar::MIN_POSITIVE);
        if c > S::Scalar::ZERO { lambda.min(S::Scalar::MAX) } else { S::Scalar::MAX }
    }

    /// Masking $G_1(w) = c(w)/\sigma(w) = 1/(1 + \Lambda)$, in \[0, 1\]; 0 for $c \le 0$.
    ///
    /// ```
    /// use lobe::{Beckmann, Isotropic};
    /// let ndf = Beckmann::new(Isotropic::new(0.5_f32)?);
    /// assert_eq!(ndf.g1([0.0, 0.0, 1.0]), 1.0);
    /// assert_eq!(ndf.g1([1.0, 0.0, 0.0]), 0.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "G1")]
    #[doc(alias = "lobe_ggx_masking")]
    #[doc(alias = "lobe_beckmann_masking")]
    #[inline(always)]
    pub fn g1(&self, w: impl Into<[S::Scalar; 3]>) -> S::Scalar {
        let w = w.into();
        let c = self.shape().mean_area(w).max(S::Scalar::ZERO);
        let excess = D::excess(c, self.shape().stretch_squared(w));
        // Both are 0 below the horizon of a mirror; `max` drops the NaN of an infinite direction.
        (c / (c + excess).max(S::Scalar::MIN_POSITIVE)).max(S::Scalar::ZERO)
    }

    /// Height-correlated masking and shadowing $G_2 = 1/(1 + \Lambda_o + \Lambda_i)$, in \[0, 1\];
    /// 0 for $c_o \le 0$ or $c_i \le 0$.
    ///
    /// Source: Heitz 2014, Eq. 99.
    ///
    /// ```
    /// use lobe::{Ggx, Isotropic};
    /// let ndf = Ggx::new(Isotropic::new(0.5_f32)?);
    /// let (wo, wi) = ([0.6, 0.0, 0.8], [0.0, 0.6, 0.8]);
    /// assert!(ndf.g2(wo, wi) <= ndf.g1(wo));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "G2")]
    #[doc(alias = "lobe_ggx_masking_shadowing")]
    #[doc(alias = "lobe_beckmann_masking_shadowing")]
    #[inline(always)]
    pub fn g2(&self, wo: impl Into<[S::Scalar; 3]>, wi: impl Into<[S::Scalar; 3]>) -> S::Scalar {
        let (c_o, c_i, sum) = self.visibility_terms(wo.into(), wi.into());
        // The ratio is at most 1; rounding must not exceed it.
        let g2 =
            (S::Scalar::TWO * c_o * c_i / sum.max(S::Scalar::MIN_POSITIVE)).min(S::Scalar::ONE);
        if c_o.min(c_i) > S::Scalar::ZERO { g2 } else { S::Scalar::ZERO }
    }

    /// Visibility $V = G_2/(4 c_o c_i) = 1/(4 (\sigma_o c_i + \sigma_i c_o - c_o c_i))$.
    ///
    /// Computed from the even part of the area, $e = \sigma(w) + \sigma(-w)$, as
    /// $1/(2 (e_o c_i + e_i c_o))$: neither a small cosine divides nor nearly equal terms subtract.
    /// 0 for $c_o \le 0$ or $c_i \le 0$. Grows without bound when both directions graze.
    ///
    /// ```
    /// use lobe::{Ggx, Isotropic};
    /// let ndf = Ggx::new(Isotropic::new(0.5_f32)?);
    /// assert_eq!(ndf.visibility([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]), 0.25);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "V")]
    #[doc(alias = "lobe_ggx_visibility")]
    #[doc(alias = "lobe_beckmann_visibility")]
    #[inline(always)]
    pub fn visibility(
        &self,
        wo: impl Into<[S::Scalar; 3]>,
        wi: impl Into<[S::Scalar; 3]>,
    ) -> S::Scalar {
        let (c_o, c_i, sum) = self.visibility_terms(wo.into(), wi.into());
        let visibility = S::Scalar::HALF / sum.max(S::Scalar::MIN_POSITIVE);
        if c_o.min(c_i) > S::Scalar::ZERO { visibility } else { S::Scalar::ZERO }
    }

    /// $c_o$, $c_i$ and $e_o c_i + e_i c_o$.
    #[inline(always)]
    pub(super) fn visibility_terms(
        &self,
        wo: [S::Scalar; 3],
        wi: [S::Scalar; 3],
    ) -> (S::Scalar, S::Scalar, S::Scalar) {
        let (c_o, c_i) = (self.shape().mean_area(wo), self.shape().mean_area(wi));
        let e_o = D::even_area(c_o, self.shape().stretch_squared(wo));
        let e_i = D::even_area(c_i, self.shape().stretch_squared(wi));
        (c_o, c_i, e_o * c_i + e_i * c_o)
    }
}
