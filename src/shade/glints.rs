//! The facade for glints: bake a glittering material under a pixel, then evaluate it for any number of lights.
//!
//! Floor 5.

use super::colour;
use crate::filter::Kernel;
use crate::material::Fresnel;
use crate::material::glint::{GlintLobe, Glints, Patch, light_blur};
use crate::scalar::Real;
use crate::slope::direction::half_vector;
use crate::slope::{Shape, SlopeMoments};

/// Glints with a Fresnel term.
///
/// ```
/// use lobe::material::glint::{Biscale, Glints, Patch};
/// use lobe::{Kernel, SlopeMoments, material::Fresnel, shade::GlintMaterial};
///
/// let details = Biscale::from_fractions([0.4_f32, 0.4], [0.05, 0.05])?;
/// let flakes = GlintMaterial { glints: Glints::new(details, 1e5)?, fresnel: Fresnel::white() };
/// // Once per pixel: where it lies on the surface, what a normal map has there, what the half vector does.
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
    /// The material as a pixel sees it: over the moments of a normal map, under the kernel of the half vector's motion.
    ///
    /// Zero moments and a zero kernel leave the material as it is.
    ///
    /// WGSL: none, `lobe_glints_lobe`, `lobe_glint_lobe_over` and `lobe_glint_lobe_widened` there.
    #[inline]
    pub fn bake(
        &self,
        patch: &Patch<R>,
        moments: &SlopeMoments<R>,
        kernel: &Kernel<R>,
    ) -> GlintShading<R> {
        let lobe = self.glints.lobe(patch).over(moments).widened(kernel);
        GlintShading { lobe, fresnel: self.fresnel }
    }
}

/// A baked glittering material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlintShading<R: Real> {
    lobe: GlintLobe<R>,
    fresnel: Fresnel<R>,
}

impl<R: Real> GlintShading<R> {
    /// The lobe underneath.
    ///
    /// WGSL: none, an argument there.
    pub fn lobe(&self) -> &GlintLobe<R> {
        &self.lobe
    }

    /// Radiance towards `wo` per unit of radiance and solid angle from `wi`, where a light appears with this radius in
    /// radians: $F f c_i$ per channel, as [`Shading::evaluate`](super::Shading::evaluate).
    ///
    /// WGSL: `lobe_glint_evaluate`.
    #[inline]
    pub fn evaluate(&self, wo: impl Into<[R; 3]>, wi: impl Into<[R; 3]>, radius: R) -> [R; 3] {
        let (wo, wi) = (wo.into(), wi.into());
        let brdf = self.lobe.brdf(wo, wi, radius);
        colour(&self.fresnel, brdf, self.lobe.ndf().shape().mean_area(wi), wo, wi)
    }

    /// The same with a colour for each cell: [`GlintLobe::coloured_sparkle`].
    ///
    /// ```
    /// use lobe::material::glint::{Biscale, Glints, Patch, hue_wheel};
    /// use lobe::{Kernel, SlopeMoments, material::Fresnel, shade::GlintMaterial};
    /// let details = Biscale::from_fractions([0.4_f64, 0.4], [0.2, 0.2])?;
    /// let foil = GlintMaterial { glints: Glints::new(details, 1e3)?, fresnel: Fresnel::white() };
    /// let shading = foil.bake(&Patch::default(), &SlopeMoments::default(), &Kernel::default());
    /// let (wo, wi) = ([0.6, 0.0, 0.8], [-0.6, 0.0, 0.8]);
    /// let plain = shading.evaluate(wo, wi, 0.0);
    /// let white = shading.evaluate_coloured(wo, wi, 0.0, |_| [1.0; 3]);
    /// assert!((white[0] - plain[0]).abs() <= 1e-12 * plain[0]);
    /// assert!(shading.evaluate_coloured(wo, wi, 0.0, hue_wheel).iter().all(|x| *x >= 0.0));
    /// # Ok::<(), lobe::Error>(())
    /// ```
    ///
    /// WGSL: `lobe_glint_evaluate_coloured`, with the hue wheel.
    pub fn evaluate_coloured(
        &self,
        wo: impl Into<[R; 3]>,
        wi: impl Into<[R; 3]>,
        radius: R,
        palette: impl Fn(R) -> [R; 3],
    ) -> [R; 3] {
        let (wo, wi) = (wo.into(), wi.into());
        let ndf = self.lobe.ndf();
        let smooth = colour(&self.fresnel, ndf.brdf(wo, wi), ndf.shape().mean_area(wi), wo, wi);
        if !(smooth.iter().any(|x| *x > R::ZERO)) {
            return smooth;
        }
        let h = half_vector(wo, wi);
        let sparkle = self.lobe.coloured_sparkle(h, light_blur(wo, wi, radius), palette);
        [0, 1, 2].map(|k| (smooth[k] * sparkle[k]).min(R::MAX))
    }
}
