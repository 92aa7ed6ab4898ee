//! The facade for glints: bake a glittering material under a pixel, then evaluate it for any number
//! of lights.
//!
//! Layer 5.

use super::material::color;
use crate::filter::Kernel;
use crate::material::Fresnel;
use crate::material::cells::Patch;
use crate::material::glint::{GlintNdf, Glints, light_blur};
use crate::scalar::Real;
use crate::slope::direction::half_vector;
use crate::slope::{LobeShape, SlopeMoments};

/// Glints with a Fresnel term.
///
/// ```
/// use lobe::material::cells::Patch;
/// use lobe::material::glint::{Biscale, Glints};
/// use lobe::{Kernel, SlopeMoments, material::Fresnel, shade::GlintMaterial};
///
/// let details = Biscale::from_fractions([0.4_f32, 0.4], [0.05, 0.05])?;
/// let flakes = GlintMaterial { glints: Glints::new(details, 1e5)?, fresnel: Fresnel::white() };
/// // Once per pixel: where it lies on the surface, what a normal map has there, what the half
/// // vector does.
/// let patch = Patch::new([0.3, 0.7], [1e-3, 0.0], [0.0, 2e-3]);
/// let shading = flakes.bake(&patch, &SlopeMoments::default(), &Kernel::default());
/// // Once per light, which appears half a degree wide.
/// let [red, green, blue] = shading.evaluate([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8], 0.00465);
/// assert!(red >= 0.0 && red == green && green == blue);
/// # Ok::<(), lobe::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlintMaterial<R> {
    /// The details.
    pub glints: Glints<R>,
    /// The Fresnel term.
    pub fresnel: Fresnel<R>,
}

impl<R: Real> GlintMaterial<R> {
    /// The material as a pixel sees it: over the moments of a normal map, under the kernel of the
    /// half vector's motion.
    ///
    /// Zero moments and a zero kernel leave the material as it is.
    #[inline]
    pub fn bake(
        &self,
        patch: &Patch<R>,
        moments: &SlopeMoments<R>,
        kernel: &Kernel<R>,
    ) -> GlintShading<R> {
        let ndf = self.glints.ndf(patch).over(moments).widened(kernel);
        GlintShading { ndf, fresnel: self.fresnel }
    }
}

/// A baked glittering material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlintShading<R: Real> {
    ndf: GlintNdf<R>,
    fresnel: Fresnel<R>,
}

impl<R: Real> GlintShading<R> {
    /// The density under the pixel.
    pub const fn ndf(&self) -> &GlintNdf<R> {
        &self.ndf
    }

    /// Radiance towards `wo` per unit of radiance and solid angle from `wi`, where a light appears
    /// with this radius in radians: $F f c_i$ per channel, as
    /// [`Shading::evaluate`](super::Shading::evaluate).
    #[doc(alias = "lobe_glint_shading_evaluate")]
    #[inline]
    pub fn evaluate(&self, wo: impl Into<[R; 3]>, wi: impl Into<[R; 3]>, radius: R) -> [R; 3] {
        let (wo, wi) = (wo.into(), wi.into());
        let brdf = self.ndf.brdf(wo, wi, radius);
        color(&self.fresnel, brdf, self.ndf.smooth().shape().mean_area(wi), wo, wi)
    }

    /// The same with a color for each cell: [`GlintNdf::colored_sparkle`].
    ///
    /// ```
    /// use lobe::material::cells::Patch;
    /// use lobe::material::glint::{Biscale, Glints, hue_wheel};
    /// use lobe::{Kernel, SlopeMoments, material::Fresnel, shade::GlintMaterial};
    /// let details = Biscale::from_fractions([0.4_f64, 0.4], [0.2, 0.2])?;
    /// let foil = GlintMaterial { glints: Glints::new(details, 1e3)?, fresnel: Fresnel::white() };
    /// let shading = foil.bake(&Patch::default(), &SlopeMoments::default(), &Kernel::default());
    /// let (wo, wi) = ([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]);
    /// let plain = shading.evaluate(wo, wi, 0.0);
    /// let white = shading.evaluate_colored(wo, wi, 0.0, |_| [1.0; 3]);
    /// assert!((white[0] - plain[0]).abs() <= 1e-12 * plain[0]);
    /// assert!(shading.evaluate_colored(wo, wi, 0.0, hue_wheel).iter().all(|x| *x >= 0.0));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    #[doc(alias = "lobe_glint_shading_evaluate_colored")]
    pub fn evaluate_colored(
        &self,
        wo: impl Into<[R; 3]>,
        wi: impl Into<[R; 3]>,
        radius: R,
        palette: impl Fn(R) -> [R; 3],
    ) -> [R; 3] {
        let (wo, wi) = (wo.into(), wi.into());
        let ndf = self.ndf.smooth();
        let smooth = color(&self.fresnel, ndf.brdf(wo, wi), ndf.shape().mean_area(wi), wo, wi);
        if !(smooth.iter().any(|x| *x > R::ZERO)) {
            return smooth;
        }
        let h = half_vector(wo, wi);
        let sparkle = self.ndf.colored_sparkle(h, light_blur(wo, wi, radius), palette);
        [0, 1, 2].map(|k| (smooth[k] * sparkle[k]).min(R::MAX))
    }
}
