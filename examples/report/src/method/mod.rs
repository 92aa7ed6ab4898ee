//! The methods that the report compares: each a small value with a name, a source and a shading
//! function.
//!
//! A new method is one more shading function in `shading` and one more entry in `list`.

mod count;
mod deferred;
mod list;
mod material;
mod pixel;
mod shading;

use lobe::slope::Whiten;
use serde::Serialize;

use crate::scene::{Motions, Sample};
use crate::window::PixelWindow;
use count::Counting;
use shading::Shade;

pub(crate) use count::{CountedPixels, Tally};
pub(crate) use list::all;
pub(crate) use material::{Finish, Material, Surfacing};
pub(crate) use pixel::{Derivatives, MovingPixel, Pixel, QuadPixel};

/// The distribution a method shades with, and is held against.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
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

/// What a method needs to know, and so where in an engine it can stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Family {
    /// More samples.
    Supersampling,
    /// The half vector, of which it makes a wider lobe: one for a light, or for many that are near
    /// each other.
    Widened,
    /// The half vector, over whose footprint it averages: a number for each light, and no lobe.
    Area,
    /// The normal: roughness for a G-buffer.
    Deferred,
    /// The same, with an engine's formula and constants.
    Engine,
}

/// A row of pixels, the other row of its quads, and the row's motions where a method wants them.
/// Even in length; the row to shade may be one shorter.
pub(crate) struct Rows<'a> {
    pub(crate) here: &'a [Sample<f32>],
    pub(crate) other: &'a [Sample<f32>],
    pub(crate) motions: &'a [Motions<f32>],
}

/// Shades a row.
type Shading = Box<dyn Fn(&Surfacing, &Rows<'_>, &mut [f32]) + Send + Sync>;

/// A way to shade a pixel, with a footprint from somewhere.
pub(crate) struct Method {
    pub(crate) name: String,
    /// Who published it, and where.
    pub(crate) source: &'static str,
    /// What it does, in a sentence.
    pub(crate) note: &'static str,
    pub(crate) distribution: Distribution,
    pub(crate) family: Family,
    /// Samples per pixel; more than one only without a filter.
    pub(crate) samples: u32,
    /// Where the footprint comes from; nowhere for plain supersampling.
    pub(crate) derivatives: Derivatives,
    /// The pixel filter whose picture it approximates.
    pub(crate) window: PixelWindow,
    shading: Shading,
    counting: Counting,
}

impl Method {
    /// False for plain supersampling.
    pub(crate) fn filters(&self) -> bool {
        self.derivatives != Derivatives::None
    }

    /// Operations per pixel of its shading, of one sample.
    pub(crate) fn count(&self, pixels: &CountedPixels) -> Tally {
        (self.counting)(pixels)
    }

    /// Shades a row of pixels.
    pub(crate) fn shade(&self, surfacing: &Surfacing, rows: &Rows<'_>, out: &mut [f32]) {
        (self.shading)(surfacing, rows, out);
    }
}

/// A function of one pixel as a function of a row: one indirect call per row, the rest inlined.
fn by_pixel<F>(shade: F, derivatives: Derivatives) -> Shading
where
    F: Shade + Send + Sync + 'static,
{
    Box::new(move |surfacing, rows, out| match surfacing {
        Surfacing::Isotropic(material) => shade_row(&shade, derivatives, material, rows, out),
        Surfacing::Brushed(material) => shade_row(&shade, derivatives, material, rows, out),
    })
}

fn shade_row<F: Shade, S: Whiten<Scalar = f32>>(
    shade: &F,
    derivatives: Derivatives,
    material: &Material<S>,
    rows: &Rows<'_>,
    out: &mut [f32],
) {
    if derivatives == Derivatives::Analytic {
        for ((out, here), motions) in out.iter_mut().zip(rows.here).zip(rows.motions) {
            *out = shade.shade(material, &MovingPixel { here, motions });
        }
        return;
    }
    let pairs = rows.here.chunks_exact(2).zip(rows.other.chunks_exact(2));
    for (out, (here, other)) in out.chunks_mut(2).zip(pairs) {
        for (k, out) in out.iter_mut().enumerate() {
            let (beside, below, across) = (&here[1 - k], &other[k], &other[1 - k]);
            let pixel = QuadPixel { here: &here[k], beside, below, across };
            *out = shade.shade(material, &pixel);
        }
    }
}
