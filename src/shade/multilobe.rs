//! The facade for many lobes: bake a surface of facets under a pixel, then evaluate it for any
//! number of lights.
//!
//! Layer 5.

use super::material::color;
use crate::filter::Kernel;
use crate::material::Fresnel;
use crate::material::cells::Patch;
use crate::material::multilobe::{Dictionary, DirectionSample, MultiLobe, PatchNdf};
use crate::scalar::Real;
use crate::slope::{MeanFrame, SlopeMoments};

/// A surface of facets with a Fresnel term.
///
/// ```
/// use lobe::material::cells::Patch;
/// use lobe::material::multilobe::{Dictionary, MultiLobe, Recipe};
/// use lobe::{Kernel, Roughness, SlopeMoments, material::Fresnel, shade::MultiLobeMaterial};
///
/// // Once for all surfaces.
/// let dictionary = Dictionary::<f32>::new(&Recipe { levels: 8, ..Recipe::default() })?;
/// let facets = MultiLobe::new(Roughness::from_alpha(0.4)?, 1e6)?;
/// let sand = MultiLobeMaterial { facets, fresnel: Fresnel::white() };
/// // Once per pixel: where it lies on the surface, what a normal map has there, what the half
/// // vector does.
/// let patch = Patch::new([0.3, 0.7], [1e-3, 0.0], [0.0, 2e-3]);
/// let shading = sand.bake(&dictionary, &patch, &SlopeMoments::default(), &Kernel::default());
/// // Once per light.
/// let [red, green, blue] = shading.evaluate([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]);
/// assert!(red >= 0.0 && red == green && green == blue);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MultiLobeMaterial<R> {
    /// The facets.
    pub facets: MultiLobe<R>,
    /// The Fresnel term.
    pub fresnel: Fresnel<R>,
}

impl<R: Real> MultiLobeMaterial<R> {
    /// The material as a pixel sees it: over the moments of a normal map, under the kernel of the
    /// half vector's motion.
    ///
    /// It is shaded in the frame of the map's mean, as no masking of V-cavities with another mean
    /// is known: from there the map's covariance is seen ([`PatchNdf::over`]), and there the
    /// kernel's half vectors are to be taken, too. Zero moments and a zero kernel leave the
    /// material as it is.
    #[inline]
    pub fn bake<'a>(
        &self,
        dictionary: &'a Dictionary<R>,
        patch: &Patch<R>,
        moments: &SlopeMoments<R>,
        kernel: &Kernel<R>,
    ) -> MultiLobeShading<'a, R> {
        let frame = MeanFrame::of(moments.mean());
        let ndf = self.facets.ndf(dictionary, patch).over(moments).widened(kernel);
        MultiLobeShading { ndf, frame, fresnel: self.fresnel }
    }
}

/// A baked surface of facets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MultiLobeShading<'a, R: Real> {
    ndf: PatchNdf<'a, R>,
    frame: MeanFrame<R>,
    fresnel: Fresnel<R>,
}

impl<'a, R: Real> MultiLobeShading<'a, R> {
    /// The lobe underneath, in the frame of the mean.
    pub const fn ndf(&self) -> &PatchNdf<'a, R> {
        &self.ndf
    }

    /// The frame that it is shaded in.
    pub const fn frame(&self) -> &MeanFrame<R> {
        &self.frame
    }

    /// Radiance towards `wo` per unit of radiance and solid angle from `wi`: $F f c_i$ per channel,
    /// as [`Shading::evaluate`](super::Shading::evaluate), with the light's cosine to the mean
    /// normal. Directions in the tangent frame.
    #[doc(alias = "lobe_multi_lobe_shading_evaluate")]
    #[inline]
    pub fn evaluate(&self, wo: impl Into<[R; 3]>, wi: impl Into<[R; 3]>) -> [R; 3] {
        let (wo, wi) = (wo.into(), wi.into());
        let local = self.frame.to_local(wi);
        // The half vector's cosine is the same in any frame.
        color(&self.fresnel, self.ndf.brdf(self.frame.to_local(wo), local), local[2], wo, wi)
    }

    /// A direction towards the light, drawn as [`PatchNdf::sample`] does, between directions in the
    /// tangent frame: its weight times [`Fresnel`] is what [`MultiLobeShading::evaluate`] is over
    /// its density.
    ///
    /// ```
    /// use lobe::material::cells::Patch;
    /// use lobe::material::multilobe::{Dictionary, MultiLobe, Recipe};
    /// use lobe::{
    ///     Kernel, Psd, Roughness, SlopeMoments, material::Fresnel, shade::MultiLobeMaterial,
    /// };
    /// let dictionary = Dictionary::<f64>::new(&Recipe { levels: 8, ..Recipe::default() })?;
    /// let facets = MultiLobe::new(Roughness::from_alpha(0.4)?, 1e6)?;
    /// let sand = MultiLobeMaterial { facets, fresnel: Fresnel::white() };
    /// let leaning = SlopeMoments::new([0.3, -0.1], Psd::new(0.02, 0.01, 0.02)?)?;
    /// let shading = sand.bake(&dictionary, &Patch::default(), &leaning, &Kernel::default());
    /// let (wo, u) = ([0.6, 0.0, 0.8], [0.2, 0.9, 0.3, 0.5, 0.5, 0.1, 0.7]);
    /// let drawn = shading.sample(wo, u).expect("above");
    /// let [value, ..] = shading.evaluate(wo, drawn.wi);
    /// assert!((value - drawn.weight * drawn.pdf).abs() <= 1e-9 * value);
    /// assert!((shading.pdf(wo, drawn.wi) - drawn.pdf).abs() <= 1e-9 * drawn.pdf);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn sample(&self, wo: impl Into<[R; 3]>, u: [R; 7]) -> Option<DirectionSample<R>> {
        let drawn = self.ndf.sample(self.frame.to_local(wo), u)?;
        Some(DirectionSample { wi: self.frame.to_tangent(drawn.wi), ..drawn })
    }

    /// Density over solid angle with which [`MultiLobeShading::sample`] draws `wi`, for other ways
    /// of drawing it beside this one.
    pub fn pdf(&self, wo: impl Into<[R; 3]>, wi: impl Into<[R; 3]>) -> R {
        self.ndf.pdf(self.frame.to_local(wo), self.frame.to_local(wi))
    }
}
