//! What a distribution owes: its density and its projected area, each of a few scalars.
//!
//! Layer 2. Everything else (D, Lambda, G1, G2, visibility, the BRDF; centered or not, any
//! anisotropy) is derived once, here and in masking.rs.

use crate::scalar::Real;
use crate::slope::{Anisotropic, Extent, Lobe, LobeShape, NonCentered};
use core::marker::PhantomData;

pub(super) mod sealed {
    pub trait Sealed {
        /// What files of materials call the distribution.
        #[cfg(feature = "serde")]
        const DATA_NAME: &'static str;
    }
}

/// The two scalar functions that make a distribution; sealed.
pub trait Distribution: sealed::Sealed + Copy {
    /// `weight` times $\pi P_{22}(s)\, \ell^4/z^4$ of a direction of height `z` whose
    /// [`LobeShape::form`] is `form` for a lobe of this extent, with `length_squared` = $\ell^2$.
    ///
    /// The density is homogeneous of degree 0 in form (2), z (1) and length, so that a half vector
    /// need not be normalized. The weight is a factor within: a density below the range of f32
    /// times a visibility above 1 need not be. Of a mirror, whose `root_det` is 0, it is 0 or NaN:
    /// callers drop NaN.
    #[doc(alias = "lobe_ggx_density")]
    #[doc(alias = "lobe_beckmann_density")]
    fn density<R: Real>(form: R, extent: Extent<R>, z: R, length_squared: R, weight: R) -> R;

    /// $\sigma(w) - \max(c, 0)$ for $|c|$ and $a^2$: the projected area beyond that of the mean
    /// plane.
    ///
    /// One function serves both signs of c, as $\sigma(w) - \sigma(-w) = c$. `c >= 0`, `a2 >= 0`; 0
    /// where both are.
    #[doc(alias = "lobe_ggx_excess")]
    #[doc(alias = "lobe_beckmann_excess")]
    fn excess<R: Real>(c: R, a2: R) -> R;

    /// $\sigma(w) + \sigma(-w) = |c| + 2$ excess, for c of either sign: what visibility is made of.
    #[doc(alias = "lobe_ggx_even_area")]
    #[doc(alias = "lobe_beckmann_even_area")]
    #[inline(always)]
    fn even_area<R: Real>(c: R, a2: R) -> R {
        c.abs() + R::TWO * Self::excess(c.abs(), a2)
    }
}

#[inline(always)]
fn inverse_pi<R: Real>() -> R {
    R::lit(core::f64::consts::FRAC_1_PI)
}

/// A distribution of normals: a [`Distribution`] over a [`LobeShape`].
///
/// Use it through [`Beckmann`](crate::Beckmann) and [`Ggx`](crate::Ggx). All methods are total:
/// below the horizon of the mean plane, and for a mirror, densities are 0. Finite input in the
/// documented domain (alpha 0 or 1e-9 to 1e9, slopes and means to 1e9 in f32) never gives NaN or
/// infinity.
// Further methods: ndf/masking.rs, ndf/beckmann.rs, filter/polygon/tree.rs.
// Further methods: filter/polygon/brdf.rs, filter/polygon/lanes.rs, filter/polygon/height.rs.
// Further methods: filter/polygon/double.rs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ndf<D, S> {
    shape: S,
    distribution: PhantomData<D>,
}

impl<D: Distribution, S: LobeShape> Ndf<D, S> {
    /// The distribution over this shape.
    #[inline(always)]
    pub const fn new(shape: S) -> Self {
        Self { shape, distribution: PhantomData }
    }

    /// The shape.
    #[inline(always)]
    pub const fn shape(&self) -> &S {
        &self.shape
    }

    /// Slope density $P_{22}(s)$; integrates to 1 over the plane.
    ///
    /// $P_{22} = e^{-q} / (\pi \sqrt{\det A})$ (Beckmann), $1 / (\pi \sqrt{\det A}\,(1 + q)^2)$
    /// (GGX), $q = (s - \mu)^T A^{-1} (s - \mu)$. Unit: one over squared slope. 0 for a mirror.
    ///
    /// ```
    /// use lobe::{Ggx, Isotropic};
    /// let ndf = Ggx::new(Isotropic::new(1.0_f64)?);
    /// assert!((ndf.slope_pdf([1.0, 0.0]) - 0.25 / core::f64::consts::PI).abs() < 1e-15);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "P22")]
    #[doc(alias = "lobe_ggx_slope_pdf")]
    #[doc(alias = "lobe_beckmann_slope_pdf")]
    #[inline(always)]
    pub fn slope_pdf(&self, slope: impl Into<[S::Scalar; 2]>) -> S::Scalar {
        let s = slope.into();
        let (zero, one) = (S::Scalar::ZERO, S::Scalar::ONE);
        let form = self.shape.form([-s[0], -s[1], one]);
        let density = D::density(form, self.shape.extent(), one, one, inverse_pi());
        density.max(zero).min(S::Scalar::MAX)
    }

    /// Density of normals $D(m) = P_{22}(s(m)) / m_z^4$, per solid angle.
    ///
    /// $\int m_z D(m)\,dm = 1$. `m` is taken as given: it is not renormalized (D is then
    /// homogeneous of degree -4). Takes the vector, never a cosine: $1 - (n \cdot h)^2$ costs 18 %
    /// at alpha = 0.001 in f32. 0 for `m_z <= 0`.
    ///
    /// ```
    /// use lobe::{Ggx, Isotropic};
    /// let ndf = Ggx::new(Isotropic::new(0.1_f32)?);
    /// assert_eq!(ndf.d([0.6, 0.0, -0.8]), 0.0);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "D")]
    #[doc(alias = "lobe_ggx_d")]
    #[doc(alias = "lobe_beckmann_d")]
    #[inline(always)]
    pub fn d(&self, m: impl Into<[S::Scalar; 3]>) -> S::Scalar {
        let (m, zero, one) = (m.into(), S::Scalar::ZERO, S::Scalar::ONE);
        let form = self.shape.form(m);
        let density = D::density(form, self.shape.extent(), m[2], one, inverse_pi());
        density.max(zero).min(if m[2] > zero { S::Scalar::MAX } else { zero })
    }

    /// The BRDF without Fresnel, $D(h)\, G_2 / (4 c_o c_i)$, per solid angle.
    ///
    /// $h$ is the half vector of the unit directions `wo` and `wi`, $c$ the projected area of the
    /// mean plane (meso normalization, LEADR; for centered lobes $c = w_z$), $G_2$
    /// height-correlated. Multiply by Fresnel and by $c_i$ to shade. 0 if $c_o \le 0$, $c_i \le
    /// 0$ or $h$ is below the horizon; at most the largest finite number.
    ///
    /// ```
    /// use lobe::{Beckmann, Isotropic};
    /// let ndf = Beckmann::new(Isotropic::new(0.3_f64)?);
    /// let (wo, wi) = ([0.6, 0.0, 0.8], [-0.48, 0.36, 0.8]);
    /// assert_eq!(ndf.brdf(wo, wi), ndf.brdf(wi, wo));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_ggx_brdf")]
    #[doc(alias = "lobe_beckmann_brdf")]
    #[inline(always)]
    pub fn brdf(&self, wo: impl Into<[S::Scalar; 3]>, wi: impl Into<[S::Scalar; 3]>) -> S::Scalar {
        let (wo, wi) = (wo.into(), wi.into());
        let (c_o, c_i, sum) = self.visibility_terms(wo, wi);
        let weight = S::Scalar::HALF * inverse_pi::<S::Scalar>() / sum;
        let (brdf, z) = self.half_density(wo, wi, weight);
        let lowest = c_o.min(c_i);
        // Directions above the surface have a half vector above it; above a tilted plane, not
        // always.
        let lowest = if S::CENTERED { lowest } else { lowest.min(z) };
        // A limit of 0 instead of a branch: loops over samples stay free of jumps. `max` drops the
        // NaN of a mirror's 0/0.
        let limit = if lowest > S::Scalar::ZERO { S::Scalar::MAX } else { S::Scalar::ZERO };
        brdf.max(S::Scalar::ZERO).min(limit)
    }

    /// `weight` times $\pi D$ at the half vector, of directions that are not checked, and the
    /// height of their sum.
    #[inline(always)]
    fn half_density(
        &self,
        wo: [S::Scalar; 3],
        wi: [S::Scalar; 3],
        weight: S::Scalar,
    ) -> (S::Scalar, S::Scalar) {
        let [x, y, z] = [0, 1, 2].map(|k| wo[k] + wi[k]);
        let form = self.shape.form_of_sum(wo, wi);
        let length_squared = x * x + y * y + z * z;
        (D::density(form, self.shape.extent(), z, length_squared, weight), z)
    }

    /// The BRDF times the cosine of `wi` with masking alone, $D(h)/(4 \sigma_o)$: no shadows.
    ///
    /// For displaced surfaces whose own shadows are not drawn (LEADR). `wi` may lie anywhere, as
    /// nothing shades it; 0 if $\sigma_o$ is, or h lies below the horizon; at most the largest
    /// finite number.
    ///
    /// Source: Dupuy et al. 2013, supplement, section 1.5.
    ///
    /// ```
    /// use lobe::{Beckmann, Isotropic};
    /// let ndf = Beckmann::new(Isotropic::new(0.3_f64)?);
    /// let (wo, wi) = ([0.6, 0.0, 0.8], [-0.48, 0.36, 0.8]);
    /// assert!(ndf.unshadowed_brdf_cos(wo, wi) > ndf.brdf(wo, wi) * wi[2]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_ggx_unshadowed_brdf_cos")]
    #[doc(alias = "lobe_beckmann_unshadowed_brdf_cos")]
    #[inline(always)]
    pub fn unshadowed_brdf_cos(
        &self,
        wo: impl Into<[S::Scalar; 3]>,
        wi: impl Into<[S::Scalar; 3]>,
    ) -> S::Scalar {
        let (wo, wi) = (wo.into(), wi.into());
        let quarter = S::Scalar::HALF * S::Scalar::HALF;
        let area = self.projected_area(wo);
        let weight = quarter * inverse_pi::<S::Scalar>() / area;
        let (value, z) = self.half_density(wo, wi, weight);
        let limit = if area.min(z) > S::Scalar::ZERO { S::Scalar::MAX } else { S::Scalar::ZERO };
        value.max(S::Scalar::ZERO).min(limit)
    }
}

/// The distribution over a shape: [`Ndf::new`].
impl<D: Distribution, S: LobeShape> From<S> for Ndf<D, S> {
    fn from(shape: S) -> Self {
        Self::new(shape)
    }
}

/// The distribution over the shape of a lobe: [`Lobe::shape`].
impl<D: Distribution, R: Real> From<Lobe<R>> for Ndf<D, NonCentered<Anisotropic<R>>> {
    fn from(lobe: Lobe<R>) -> Self {
        Self::new(lobe.shape())
    }
}
