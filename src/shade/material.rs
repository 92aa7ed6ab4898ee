//! A smooth material: its lobe baked under a pixel's kernel, and batches over slices.
//!
//! Layer 5.

use crate::error::{Error, same_length};
use crate::filter::Kernel;
use crate::material::Fresnel;
use crate::ndf::{BeckmannDistribution, Distribution, GgxDistribution, Ndf};
use crate::scalar::Real;
use crate::slope::direction::{dot, half_vector};
use crate::slope::{Anisotropic, Footprint, Lobe, LobeShape, NonCentered, Whiten};
use core::marker::PhantomData;

/// A lobe with a distribution and a Fresnel term.
///
/// ```
/// use lobe::material::Fresnel;
/// use lobe::shade::Material;
/// use lobe::{Footprint, Kernel, Lobe, PixelFilter, Roughness};
///
/// let metal = Material::ggx(
///     Lobe::centered(Roughness::from_alpha(0.05_f32)?),
///     Fresnel::schlick([0.95, 0.64, 0.54])?,
/// );
/// // Once per pixel: the half vector's slope changes by this much to the next pixels.
/// let footprint = Footprint::from_slopes([0.1, 0.0], [0.02, 0.05]);
/// let shading = metal.bake(&Kernel::of(&footprint, PixelFilter::BOX));
/// // Once per light.
/// let [red, _, blue] = shading.evaluate([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]);
/// assert!(red > blue);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material<D, R> {
    /// Mean slope and roughness: of the material alone, or of a normal map's texel.
    pub lobe: Lobe<R>,
    /// The Fresnel term.
    pub fresnel: Fresnel<R>,
    distribution: PhantomData<D>,
}

impl<R: Real> Material<GgxDistribution, R> {
    /// A GGX material.
    pub const fn ggx(lobe: Lobe<R>, fresnel: Fresnel<R>) -> Self {
        Self { lobe, fresnel, distribution: PhantomData }
    }
}

impl<R: Real> Material<BeckmannDistribution, R> {
    /// A Beckmann material.
    ///
    /// ```
    /// use lobe::{Lobe, Roughness, material::Fresnel, shade::Material};
    /// let lobe = Lobe::centered(Roughness::from_alpha(0.3_f64)?);
    /// let shading = Material::beckmann(lobe, Fresnel::white()).unfiltered();
    /// assert_eq!(shading.evaluate([0.0, 0.0, 1.0], [0.6, 0.0, -0.8]), [0.0; 3]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub const fn beckmann(lobe: Lobe<R>, fresnel: Fresnel<R>) -> Self {
        Self { lobe, fresnel, distribution: PhantomData }
    }
}

impl<D: Distribution, R: Real> Material<D, R> {
    #[cfg(feature = "serde")]
    pub(crate) const fn new(lobe: Lobe<R>, fresnel: Fresnel<R>) -> Self {
        Self { lobe, fresnel, distribution: PhantomData }
    }

    /// The material as a pixel with this kernel sees it: its lobe widened, ready for any number of
    /// lights.
    ///
    /// Exact for Beckmann, variance addition for GGX
    /// ([`Roughness::widened`](crate::Roughness::widened)).
    #[doc(alias = "lobe_material_bake")]
    #[inline]
    pub fn bake(&self, kernel: &Kernel<R>) -> Shading<D, NonCentered<Anisotropic<R>>> {
        Shading::new(Ndf::new(self.lobe.widened(kernel).shape()), self.fresnel)
    }

    /// The material as it is.
    #[inline]
    pub fn unfiltered(&self) -> Shading<D, NonCentered<Anisotropic<R>>> {
        Shading::new(Ndf::new(self.lobe.shape()), self.fresnel)
    }
}

/// A baked material: what evaluation needs, precomputed, for the shape that the material has.
///
/// [`Material::bake`] gives one of any lobe. A material whose shape is known costs less by its own:
/// an isotropic one under a pixel's kernel meets no matrix and no mean.
///
/// ```
/// use lobe::material::Fresnel;
/// use lobe::shade::{Material, Shading};
/// use lobe::{Footprint, Ggx, Isotropic, Kernel, Lobe, PixelFilter, Roughness};
///
/// let kernel = Kernel::of(&Footprint::rectangle([0.1, 0.2]), PixelFilter::BOX);
/// let (alpha, fresnel) = (0.05_f64, Fresnel::schlick([0.95, 0.64, 0.54])?);
/// let shading = Shading::new(Ggx::new(kernel.widen(Isotropic::new(alpha)?)), fresnel);
/// // A lobe of any matrix gives the same radiance, up to rounding.
/// let lobe = Lobe::centered(Roughness::from_alpha(alpha)?);
/// let of_any = Material::ggx(lobe, fresnel).bake(&kernel);
/// let (wo, wi) = ([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]);
/// let ratio = shading.evaluate(wo, wi)[0] / of_any.evaluate(wo, wi)[0];
/// assert!((ratio - 1.0).abs() < 1e-12);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shading<D, S: LobeShape> {
    ndf: Ndf<D, S>,
    fresnel: Fresnel<S::Scalar>,
}

impl<D: Distribution, S: LobeShape> Shading<D, S> {
    /// A distribution over a shape, with a Fresnel term.
    #[inline]
    pub const fn new(ndf: Ndf<D, S>, fresnel: Fresnel<S::Scalar>) -> Self {
        Self { ndf, fresnel }
    }

    /// The distribution underneath.
    #[inline]
    pub const fn ndf(&self) -> &Ndf<D, S> {
        &self.ndf
    }

    /// Radiance towards `wo` per unit of radiance and solid angle from `wi`: $F\, f\, c_i$ per
    /// channel.
    ///
    /// $f$ is [`Ndf::brdf`], $c_i$ the cosine of `wi`, for a lobe with a mean the projected area of
    /// its mean plane. Multiply by the light's radiance and solid angle. `wo`, `wi`: unit, tangent
    /// frame. 0 where either lies below the horizon.
    #[doc(alias = "lobe_ggx_evaluate")]
    #[doc(alias = "lobe_beckmann_evaluate")]
    #[inline]
    pub fn evaluate(
        &self,
        wo: impl Into<[S::Scalar; 3]>,
        wi: impl Into<[S::Scalar; 3]>,
    ) -> [S::Scalar; 3] {
        let (wo, wi) = (wo.into(), wi.into());
        color(&self.fresnel, self.ndf.brdf(wo, wi), self.ndf.shape().mean_area(wi), wo, wi)
    }
}

/// `brdf` times Fresnel and `area`, the mean plane's that the light sees; 0 where it sees none.
#[inline]
pub(super) fn color<R: Real>(
    fresnel: &Fresnel<R>,
    brdf: R,
    area: R,
    wo: [R; 3],
    wi: [R; 3],
) -> [R; 3] {
    let area = area.max(R::ZERO);
    let reflectance = fresnel.reflectance(dot(wo, half_vector(wo, wi)));
    reflectance.map(|f| (f * brdf * area).min(R::MAX))
}

impl<S: Whiten> Shading<GgxDistribution, S> {
    /// [`Shading::evaluate`] with D averaged exactly over a footprint:
    /// [`Ndf::brdf_over`](crate::Ndf::brdf_over).
    ///
    /// For a material that was not baked with the same footprint's kernel: one filter, not two.
    ///
    /// ```
    /// use lobe::{Footprint, Lobe, Roughness, material::Fresnel, shade::Material};
    /// let lobe = Lobe::centered(Roughness::from_alpha(0.1_f64)?);
    /// let shading = Material::ggx(lobe, Fresnel::white()).unfiltered();
    /// let (wo, wi) = ([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]);
    /// let wide = shading.evaluate_over(wo, wi, &Footprint::rectangle([0.2, 0.2]));
    /// assert!(wide[0] < shading.evaluate(wo, wi)[0]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_ggx_evaluate_over")]
    #[inline]
    pub fn evaluate_over(
        &self,
        wo: impl Into<[S::Scalar; 3]>,
        wi: impl Into<[S::Scalar; 3]>,
        footprint: &Footprint<S::Scalar>,
    ) -> [S::Scalar; 3] {
        let (wo, wi) = (wo.into(), wi.into());
        let brdf = self.ndf.brdf_over(wo, wi, footprint);
        color(&self.fresnel, brdf, self.ndf.shape().mean_area(wi), wo, wi)
    }
}

/// Bakes a slice of materials, each under its own kernel.
///
/// # Errors
/// [`Error::Length`] unless the slices have one length; nothing is then written.
pub fn bake_all<D: Distribution, R: Real>(
    materials: &[Material<D, R>],
    kernels: &[Kernel<R>],
    out: &mut [Shading<D, NonCentered<Anisotropic<R>>>],
) -> Result<(), Error> {
    same_length(out.len(), materials.len())?;
    same_length(out.len(), kernels.len())?;
    for ((out, material), kernel) in out.iter_mut().zip(materials).zip(kernels) {
        *out = material.bake(kernel);
    }
    Ok(())
}

/// Evaluates a slice of baked materials, each for its own directions.
///
/// # Errors
/// [`Error::Length`] unless the slices have one length; nothing is then written.
///
/// ```
/// use lobe::shade::{Material, bake_all, evaluate_all};
/// use lobe::{Kernel, Lobe, Roughness, material::Fresnel};
/// let material = Material::ggx(Lobe::centered(Roughness::from_alpha(0.2_f32)?), Fresnel::white());
/// let mut baked = [material.unfiltered(); 2];
/// bake_all(&[material; 2], &[Kernel::default(); 2], &mut baked)?;
/// let mut radiance = [[0.0; 3]; 2];
/// let up = [0.0, 0.0, 1.0];
/// evaluate_all(&baked, &[up, up], &[up, [0.0, 0.0, -1.0]], &mut radiance)?;
/// assert!(radiance[0][0] > 1.0 && radiance[1] == [0.0; 3]);
/// let short = evaluate_all(&baked, &[up], &[up, up], &mut radiance);
/// assert_eq!(short, Err(lobe::Error::Length { expected: 2, found: 1 }));
/// # Ok::<(), lobe::Error>(())
/// ```
pub fn evaluate_all<D: Distribution, S: LobeShape>(
    shadings: &[Shading<D, S>],
    wo: &[[S::Scalar; 3]],
    wi: &[[S::Scalar; 3]],
    out: &mut [[S::Scalar; 3]],
) -> Result<(), Error> {
    for length in [shadings.len(), wo.len(), wi.len()] {
        same_length(out.len(), length)?;
    }
    for (((out, shading), &wo), &wi) in out.iter_mut().zip(shadings).zip(wo).zip(wi) {
        *out = shading.evaluate(wo, wi);
    }
    Ok(())
}
