//! A glittering material under a light: the library's side of a pixel.

use super::energy::Energy;
use super::options::Method;
use glam::Vec3;
use lobe::material::Fresnel;
use lobe::material::cells::Patch;
use lobe::material::glint::{Biscale, GlintNdf, Glints, ZirrKaplanyan, light_blur};
use lobe::slope::direction::{half_vector, normal_of, slope_of};
use lobe::{Beckmann, Error, Kernel, Lobe, SlopeMoments};

/// Details over a diffuse base.
pub(crate) struct Material {
    glints: Glints<f32>,
    density: f32,
    variation: f32,
    pub(crate) fresnel: Fresnel<f32>,
    pub(crate) base: Vec3,
    /// Colors of details, by a number in [0, 1]; white without.
    pub(crate) palette: Option<fn(f32) -> [f32; 3]>,
}

/// What a pixel sees of the surface, in its shading frame.
pub(crate) struct Pixel {
    pub(crate) patch: Patch<f32>,
    /// Of a normal map.
    pub(crate) bumps: SlopeMoments<f32>,
    pub(crate) wo: Vec3,
}

/// A light as the surface sees it, in its shading frame.
pub(crate) struct Incident {
    pub(crate) wi: Vec3,
    /// Across its direction.
    pub(crate) irradiance: Vec3,
    pub(crate) radius: f32,
    /// How the half vector spreads over the pixel.
    pub(crate) kernel: Kernel<f32>,
}

impl Material {
    /// White, without a base: alphas from afar, the share of them that one detail has, and details
    /// per unit area.
    pub(crate) fn new(
        alphas: [f32; 2],
        fractions: [f32; 2],
        density: f32,
        variation: f32,
    ) -> Result<Self, Error> {
        let biscale = Biscale::from_fractions(alphas, fractions)?;
        let glints = Glints::new(biscale, density)?.with_variation(variation)?;
        let (fresnel, base, palette) = (Fresnel::white(), Vec3::ZERO, None);
        Ok(Self { glints, density, variation, fresnel, base, palette })
    }

    /// With other random numbers.
    pub(crate) fn seeded(self, seed: u32) -> Self {
        Self { glints: self.glints.with_seed(seed), ..self }
    }

    /// Edge of the square that one detail has.
    pub(crate) fn detail_size(&self) -> f64 {
        f64::from(self.glints.detail_size())
    }

    /// How many cells a pixel asks.
    pub(crate) fn cells(&self, patch: &Patch<f32>) -> u32 {
        let mut cells = 0;
        self.glints.ndf(patch).grid().visit(|_| cells += 1);
        cells
    }

    /// Radiance towards the camera, and what of it is of details.
    pub(crate) fn reflect(
        &self,
        pixel: &Pixel,
        light: &Incident,
        method: Method,
    ) -> (Vec3, Energy) {
        let (wo, wi) = (pixel.wo, light.wi);
        // The mean plane's cosine, as `Ndf::brdf` is normalized by it.
        let [x, y] = pixel.bumps.mean();
        let cosine = wi.z - x * wi.x - y * wi.y;
        if !(cosine > 0.0) {
            return (Vec3::ZERO, Energy::default());
        }
        let tilted = cosine / (1.0 + x * x + y * y).sqrt();
        let diffuse = self.base * light.irradiance * (tilted * std::f32::consts::FRAC_1_PI);

        let lobe = self.glints.ndf(&pixel.patch).over(&pixel.bumps).widened(&light.kernel);
        let h = Vec3::from(half_vector(wo, wi));
        let fresnel = Vec3::from(self.fresnel.reflectance(wi.dot(h)));
        let smooth = lobe.smooth().brdf(wo, wi) * cosine * fresnel * light.irradiance;
        let weight = f64::from(smooth.element_sum() / 3.0);
        if !(weight > 0.0) {
            return (diffuse, Energy::default());
        }
        let sparkle = self.sparkle(&lobe, pixel, light, method);
        let probability = f64::from(lobe.probability(h, light_blur(wo, wi, light.radius)));
        let number = f64::from(self.density * pixel.patch.area());
        let energy = Energy {
            details: weight * f64::from(sparkle.element_sum() / 3.0),
            smooth: weight,
            variance: weight * weight * (1.0 - probability) / (number * probability).max(1e-30),
            ..Energy::default()
        };
        (diffuse + smooth * sparkle, energy)
    }

    /// How much brighter than the smooth lobe the pixel is.
    fn sparkle(
        &self,
        lobe: &GlintNdf<f32>,
        pixel: &Pixel,
        light: &Incident,
        method: Method,
    ) -> Vec3 {
        let (wo, wi) = (pixel.wo, light.wi);
        let (h, blur) = (half_vector(wo, wi), light_blur(wo, wi, light.radius));
        match (method, self.palette) {
            (Method::Smooth, _) => Vec3::ONE,
            (Method::Published, _) => Vec3::splat(self.published(lobe, pixel, light)),
            (Method::Glints, Some(palette)) => lobe.colored_sparkle(h, blur, palette).into(),
            (Method::Glints, None) => Vec3::splat(lobe.sparkle(h, blur)),
        }
    }

    /// How much brighter than the smooth lobe the pixel is by the paper and its shader, with our
    /// masking and without colors.
    fn published(&self, lobe: &GlintNdf<f32>, pixel: &Pixel, light: &Incident) -> f32 {
        let (wo, wi) = (pixel.wo, light.wi);
        let biscale = self.glints.biscale().over(&pixel.bumps).widened(&light.kernel);
        // The paper has no tilted lobe, so slopes are taken relative to the mean.
        let slope = slope_of(half_vector(wo, wi));
        let [x, y] = pixel.bumps.mean();
        let h = normal_of([slope[0] - x, slope[1] - y]);
        let smooth = Beckmann::new(Lobe::centered(lobe.smooth_lobe().roughness()).shape()).d(h);
        let Ok(mut published) = ZirrKaplanyan::new(biscale, self.density) else { return 1.0 };
        published.variation = self.variation;
        let cosine = wi.dot(Vec3::from(half_vector(wo, wi)));
        published.d(&pixel.patch, h, cosine, light.radius) / smooth.max(f32::MIN_POSITIVE)
    }
}
