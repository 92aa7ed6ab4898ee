//! The models that are compared: a material as each has it, and one evaluation of a pixel.

use lobe::material::cells::Patch;
use lobe::material::glint::{Glints, ZirrKaplanyan};
use lobe::slope::direction::half_vector;
use lobe::{Beckmann, Error, Isotropic, Real};
use serde::Serialize;

use super::material::Material;

/// What shades a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Model {
    /// The smooth lobe alone, isotropic Beckmann.
    Smooth,
    /// The library's.
    Default,
    /// The same with numbers of details that vary by [`VARIATION`].
    Varied,
    /// The library's on the four quarters of the pixel.
    Four,
    /// As published.
    Published,
    /// The same with sizes that vary by [`VARIATION`].
    PublishedVaried,
}

/// Of models whose details vary from cell to cell.
pub(crate) const VARIATION: f64 = 1.0;

impl Model {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Smooth => "smooth lobe",
            Self::Default => "default",
            Self::Varied => "default, numbers vary",
            Self::Four => "default, 4 samples",
            Self::Published => "published",
            Self::PublishedVaried => "published, sizes vary",
        }
    }
}

/// A pixel under a light.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seen<R> {
    pub(super) patch: Patch<R>,
    pub(super) wo: [R; 3],
    pub(super) wi: [R; 3],
    /// What the light appears with, in radians.
    pub(super) radius: R,
}

impl Seen<f64> {
    pub(super) fn cast<R: Real>(&self) -> Seen<R> {
        let Patch { tile, uv, right, up } = self.patch;
        let (pair, vector) = (|v: [f64; 2]| v.map(R::lit), |v: [f64; 3]| v.map(R::lit));
        Seen {
            patch: Patch::in_tile(tile, pair(uv), pair(right), pair(up)),
            wo: vector(self.wo),
            wi: vector(self.wi),
            radius: R::lit(self.radius),
        }
    }
}

/// A material as all models have it, with as many details as a pixel of one area should have.
pub(super) struct Made<R> {
    smooth: Beckmann<Isotropic<R>>,
    pub(super) glints: Glints<R>,
    varied: Glints<R>,
    pub(super) published: ZirrKaplanyan<R>,
    published_varied: ZirrKaplanyan<R>,
}

impl<R: Real> Made<R> {
    /// For a pixel of this area, of this surface: published models know but one.
    ///
    /// Published grooves have numbers by the cells' area: as many as they should in one of the
    /// pixel's.
    pub(super) fn new(material: &Material, area: f64, seed: u32) -> Result<Self, Error> {
        let biscale = material.biscale()?;
        let glints = Glints::new(biscale, R::lit(material.density(area)))?.with_seed(seed);
        let published = ZirrKaplanyan::new(biscale, R::lit(material.details / area))?;
        let variation = R::lit(VARIATION);
        let mut published_varied = published;
        published_varied.variation = variation;
        Ok(Self {
            smooth: Beckmann::new(Isotropic::new(R::lit(material.alpha))?),
            glints,
            varied: glints.with_variation(variation)?,
            published,
            published_varied,
        })
    }

    /// The BRDF without Fresnel that a pixel has.
    #[inline]
    pub(super) fn brdf(&self, model: Model, seen: &Seen<R>) -> R {
        let Seen { patch, wo, wi, radius } = *seen;
        match model {
            Model::Smooth => self.smooth.brdf(wo, wi),
            Model::Default => self.glints.ndf(&patch).brdf(wo, wi, radius),
            Model::Varied => self.varied.ndf(&patch).brdf(wo, wi, radius),
            Model::Four => {
                let quarters = quarters(&patch).map(|q| self.glints.ndf(&q).brdf(wo, wi, radius));
                quarters.into_iter().fold(R::ZERO, |sum, x| sum + x) * R::lit(0.25)
            }
            Model::Published => self.masked(&self.published, seen),
            Model::PublishedVaried => self.masked(&self.published_varied, seen),
        }
    }

    /// A published density with the masking of the smooth lobe, which its authors leave to the
    /// caller.
    #[inline]
    fn masked(&self, published: &ZirrKaplanyan<R>, seen: &Seen<R>) -> R {
        let h = half_vector(seen.wo, seen.wi);
        let cosine = (0..3).fold(R::ZERO, |sum, k| sum + seen.wi[k] * h[k]);
        let visibility = self.smooth.visibility(seen.wo, seen.wi);
        published.d(&seen.patch, h, cosine, seen.radius) * visibility
    }

    /// The pixel over what the smooth lobe has.
    pub(super) fn ratio(&self, model: Model, seen: &Seen<R>) -> f64 {
        (self.brdf(model, seen) / self.smooth.brdf(seen.wo, seen.wi)).to_f64()
    }
}

/// The four parallelograms that make up a pixel.
fn quarters<R: Real>(patch: &Patch<R>) -> [Patch<R>; 4] {
    let half = |v: [R; 2]| v.map(|x| R::HALF * x);
    let (right, up) = (half(patch.right), half(patch.up));
    let (half, minus) = (R::HALF, -R::HALF);
    [[minus, minus], [half, minus], [minus, half], [half, half]].map(|[a, b]| {
        let uv = [0, 1].map(|k| patch.uv[k] + a * right[k] + b * up[k]);
        Patch { uv, right, up, ..*patch }
    })
}
