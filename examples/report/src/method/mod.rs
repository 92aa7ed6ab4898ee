//! The methods that the report compares: each a small value with a name, a source and a shading
//! function.
//!
//! A new method is one more function in `shading` and one more entry in [`all`].

mod shading;

use lobe::{Error, Isotropic, PixelFilter, Roughness};

use crate::scene::Sample;
use shading::Quad;

/// The distribution a method shades with, and is held against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Distribution {
    Ggx,
    Beckmann,
}

impl Distribution {
    pub(crate) const ALL: [Self; 2] = [Self::Ggx, Self::Beckmann];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Ggx => "GGX",
            Self::Beckmann => "Beckmann",
        }
    }
}

/// The material under the filter: isotropic, of one alpha.
pub(crate) struct Material {
    alpha: f32,
    shape: Isotropic<f32>,
    roughness: Roughness<f32>,
}

impl Material {
    pub(crate) fn new(alpha: f64) -> Result<Self, Error> {
        let alpha = alpha as f32;
        Ok(Self { alpha, shape: Isotropic::new(alpha)?, roughness: Roughness::from_alpha(alpha)? })
    }
}

/// Samples of a row of pixels and of the row above, each with one pixel more at its right end.
pub(crate) struct Rows<'a> {
    pub(crate) here: &'a [Sample<f32>],
    pub(crate) above: &'a [Sample<f32>],
}

/// Shades a row into a slice one shorter than the rows.
type Shading = Box<dyn Fn(&Material, &Rows<'_>, &mut [f32]) + Send + Sync>;

/// A way to shade a pixel.
pub(crate) struct Method {
    pub(crate) name: String,
    /// Who published it, and where.
    pub(crate) source: &'static str,
    /// What it does, in a sentence.
    pub(crate) note: &'static str,
    pub(crate) distribution: Distribution,
    /// Samples per pixel; more than one only without a filter.
    pub(crate) samples: u32,
    /// False for plain supersampling.
    pub(crate) filters: bool,
    shading: Shading,
}

impl Method {
    fn filter<F>(
        distribution: Distribution,
        name: &str,
        source: &'static str,
        note: &'static str,
        shade: F,
    ) -> Self
    where
        F: Fn(&Material, &Quad<'_>) -> f32 + Send + Sync + 'static,
    {
        Self {
            name: name.into(),
            source,
            note,
            distribution,
            samples: 1,
            filters: true,
            shading: by_pixel(shade),
        }
    }

    /// Plain supersampling; one sample is what every engine starts from.
    fn supersampling(distribution: Distribution, samples: u32) -> Self {
        let name = match samples {
            1 => "none (1 sample)".into(),
            many => format!("supersampling {many}"),
        };
        let shading = match distribution {
            Distribution::Ggx => by_pixel(shading::plain_ggx),
            Distribution::Beckmann => by_pixel(shading::plain_beckmann),
        };
        let source = "the line to beat";
        let note =
            "Geometry and unfiltered shading at the points of a Hammersley net in the pixel.";
        Self { name, source, note, distribution, samples, filters: false, shading }
    }

    /// Shades a row of pixels.
    pub(crate) fn shade(&self, material: &Material, rows: &Rows<'_>, out: &mut [f32]) {
        (self.shading)(material, rows, out);
    }
}

/// A function of one pixel as a function of a row: one indirect call per row, the rest inlined.
fn by_pixel<F>(shade: F) -> Shading
where
    F: Fn(&Material, &Quad<'_>) -> f32 + Send + Sync + 'static,
{
    Box::new(move |material, rows, out| {
        let pixels = rows.here.windows(2).zip(rows.above);
        for (out, (pair, above)) in out.iter_mut().zip(pixels) {
            *out = shade(material, &Quad { here: &pair[0], right: &pair[1], above });
        }
    })
}

/// Sample counts of the line to beat.
const SUPERSAMPLING: [u32; 5] = [1, 4, 16, 64, 256];

/// Every method, in the order of the tables.
pub(crate) fn all() -> Vec<Method> {
    use Distribution::{Beckmann, Ggx};
    let line = |distribution| SUPERSAMPLING.map(|n| Method::supersampling(distribution, n));
    let mut methods = Vec::from(line(Ggx));
    methods.extend([
        Method::filter(
            Ggx,
            "variance addition, box",
            "Kaplanyan et al. 2016, Eq. 15 applied to GGX",
            "Kernel covariance with the box pixel's own variance, 1/12, added to the roughness matrix.",
            shading::widened_ggx(PixelFilter::BOX),
        ),
        Method::filter(
            Ggx,
            "variance addition, 1/4",
            "Kaplanyan et al. 2016, section 4.3",
            "The same with the published pixel variance, 1/4: three times the box's.",
            shading::widened_ggx(PixelFilter::KAPLANYAN),
        ),
        Method::filter(
            Ggx,
            "Tokuyoshi 2017",
            "Tokuyoshi 2017, Listing 1",
            "Derivatives on the projected disk used as slopes, variance 1/4, added alpha^2 at most 0.18.",
            shading::tokuyoshi,
        ),
        Method::filter(
            Ggx,
            "rectangle",
            "Kaplanyan et al. 2016, Eq. 16 and Appendix A (corners corrected)",
            "Mean over the footprint's bounding rectangle, extents from 0.001 to 1, eight arctangents.",
            shading::rectangle_ggx,
        ),
        Method::filter(
            Ggx,
            "exact parallelogram",
            "lobe, Ggx::brdf_over",
            "Mean over the footprint itself, unclamped: Lambert's polygon formula, stable in f32.",
            shading::parallelogram_ggx,
        ),
    ]);
    methods.extend(line(Beckmann));
    methods.extend([
        Method::filter(
            Beckmann,
            "Gaussian, box",
            "Kaplanyan et al. 2016, Eq. 15",
            "Exact convolution with a Gaussian of the box pixel's variance, 1/12.",
            shading::widened_beckmann(PixelFilter::BOX),
        ),
        Method::filter(
            Beckmann,
            "Gaussian, 1/4",
            "Kaplanyan et al. 2016, Eq. 15",
            "The same with the published pixel variance, 1/4.",
            shading::widened_beckmann(PixelFilter::KAPLANYAN),
        ),
        Method::filter(
            Beckmann,
            "rectangle",
            "Kaplanyan et al. 2016, Eq. 16",
            "Mean over the footprint's bounding rectangle, extents from 0.001 to 1, error functions.",
            shading::rectangle_beckmann,
        ),
    ]);
    methods
}
