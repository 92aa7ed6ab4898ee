//! What is compared: filters of half vectors, what is known of the normal map, plain supersampling.

use lobe::filter::DiskKernel;
use lobe::material::multilobe::{Dictionary, MultiLobe};
use lobe::{Error, Footprint, Kernel, PixelFilter, Real, Roughness};
use serde::Serialize;

use super::dictionary::Precision;
use super::stage::{Normals, Seen};

/// Of which half vectors derivatives are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Derivatives {
    /// Of $(h_x, h_y)$ of the unit half vector, used as slopes (Eq. 21).
    Disk,
    /// Of its slope (Eq. 20).
    Slope,
}

/// What is done about half vectors that differ over the pixel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Filter {
    None,
    /// The published filter, with its scale $s_K$.
    Mips(f64, Derivatives),
    /// The library's.
    Box(Derivatives),
}

/// One way to shade a pixel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Method {
    pub(crate) name: &'static str,
    pub(crate) filter: Filter,
    pub(crate) normals: Normals,
    /// Samples along either side of the pixel.
    pub(crate) side: u32,
}

/// Names that the page asks for.
pub(crate) mod name {
    pub(crate) const NONE: &str = "none";
    pub(crate) const HALF: &str = "mips, s_K 0.5, disk";
    pub(crate) const ONE: &str = "mips, s_K 1, disk";
    pub(crate) const HALF_SLOPE: &str = "mips, s_K 0.5, slope";
    pub(crate) const ONE_SLOPE: &str = "mips, s_K 1, slope";
    pub(crate) const BOX: &str = "box, disk";
    pub(crate) const BOX_SLOPE: &str = "box, slope";
    pub(crate) const FOUR: &str = "4 samples";
    pub(crate) const SIXTEEN: &str = "16 samples";
    pub(crate) const MEAN: &str = "mean normal";
    pub(crate) const APART: &str = "LEAN without \u{3c1}";
    pub(crate) const WHOLE: &str = "LEAN with \u{3c1}";
    pub(crate) const APART_NONE: &str = "without \u{3c1}, none";
    pub(crate) const APART_HALF: &str = "without \u{3c1}, mips, s_K 0.5, disk";
    pub(crate) const APART_ONE: &str = "without \u{3c1}, mips, s_K 1, disk";
    pub(crate) const APART_HALF_SLOPE: &str = "without \u{3c1}, mips, s_K 0.5, slope";
    pub(crate) const APART_ONE_SLOPE: &str = "without \u{3c1}, mips, s_K 1, slope";
    pub(crate) const WHOLE_NONE: &str = "with \u{3c1}, none";
    pub(crate) const WHOLE_HALF: &str = "with \u{3c1}, mips, s_K 0.5, disk";
    pub(crate) const WHOLE_ONE: &str = "with \u{3c1}, mips, s_K 1, disk";
    pub(crate) const WHOLE_HALF_SLOPE: &str = "with \u{3c1}, mips, s_K 0.5, slope";
    pub(crate) const WHOLE_ONE_SLOPE: &str = "with \u{3c1}, mips, s_K 1, slope";
}

const fn filtered(name: &'static str, filter: Filter) -> Method {
    Method { name, filter, normals: Normals::Mean, side: 1 }
}

const fn mapped(name: &'static str, normals: Normals, filter: Filter) -> Method {
    Method { name, filter, normals, side: 1 }
}

const fn sampled(name: &'static str, side: u32) -> Method {
    Method { name, filter: Filter::None, normals: Normals::Point, side }
}

/// On tubes, which have no normal map.
pub(super) const FILTERS: [Method; 9] = [
    filtered(name::NONE, Filter::None),
    filtered(name::HALF, Filter::Mips(0.5, Derivatives::Disk)),
    filtered(name::ONE, Filter::Mips(1.0, Derivatives::Disk)),
    filtered(name::HALF_SLOPE, Filter::Mips(0.5, Derivatives::Slope)),
    filtered(name::ONE_SLOPE, Filter::Mips(1.0, Derivatives::Slope)),
    filtered(name::BOX, Filter::Box(Derivatives::Disk)),
    filtered(name::BOX_SLOPE, Filter::Box(Derivatives::Slope)),
    sampled(name::FOUR, 2),
    sampled(name::SIXTEEN, 4),
];

/// On the ball with its normal map: what is known of that, and filters with and without its
/// correlation.
pub(super) const MAPPINGS: [Method; 15] = [
    mapped(name::MEAN, Normals::Mean, Filter::Box(Derivatives::Disk)),
    mapped(name::APART, Normals::Apart, Filter::Box(Derivatives::Disk)),
    mapped(name::APART_NONE, Normals::Apart, Filter::None),
    mapped(name::APART_HALF, Normals::Apart, Filter::Mips(0.5, Derivatives::Disk)),
    mapped(name::APART_ONE, Normals::Apart, Filter::Mips(1.0, Derivatives::Disk)),
    mapped(name::APART_HALF_SLOPE, Normals::Apart, Filter::Mips(0.5, Derivatives::Slope)),
    mapped(name::APART_ONE_SLOPE, Normals::Apart, Filter::Mips(1.0, Derivatives::Slope)),
    mapped(name::WHOLE, Normals::Whole, Filter::Box(Derivatives::Disk)),
    mapped(name::WHOLE_NONE, Normals::Whole, Filter::None),
    mapped(name::WHOLE_HALF, Normals::Whole, Filter::Mips(0.5, Derivatives::Disk)),
    mapped(name::WHOLE_ONE, Normals::Whole, Filter::Mips(1.0, Derivatives::Disk)),
    mapped(name::WHOLE_HALF_SLOPE, Normals::Whole, Filter::Mips(0.5, Derivatives::Slope)),
    mapped(name::WHOLE_ONE_SLOPE, Normals::Whole, Filter::Mips(1.0, Derivatives::Slope)),
    sampled(name::FOUR, 2),
    sampled(name::SIXTEEN, 4),
];

/// A material with its dictionary.
pub(super) struct Surface<R: 'static> {
    dictionary: &'static Dictionary<R>,
    facets: MultiLobe<R>,
}

impl<R: Precision> Surface<R> {
    /// Of a roughness from afar, with this many facets on a square of the unit.
    pub(super) fn new(alpha: f64, density: f64) -> Result<Self, Error> {
        let roughness = Roughness::from_alpha(R::lit(alpha))?;
        Ok(Self {
            dictionary: R::dictionary()?,
            facets: MultiLobe::new(roughness, R::lit(density))?,
        })
    }

    /// BRDF without Fresnel times the light's cosine.
    #[inline]
    pub(super) fn radiance(&self, filter: Filter, seen: &Seen<R>) -> R {
        let lobe = self.facets.ndf(self.dictionary, &seen.patch);
        let lobe = match &seen.moments {
            Some(moments) => lobe.over(moments),
            None => lobe,
        };
        let lobe = match filter {
            Filter::None => lobe,
            Filter::Mips(scale, derivatives) => {
                let [u, v] = seen.derivatives(derivatives);
                lobe.with_mips(&Footprint::from_slopes(u, v), R::lit(scale))
            }
            Filter::Box(derivatives) => lobe.widened(&seen.kernel(derivatives)),
        };
        lobe.brdf(seen.wo, seen.wi) * seen.wi[2].max(R::ZERO)
    }

    /// The sum over lights.
    pub(super) fn sum(&self, filter: Filter, seen: &[Seen<R>]) -> R {
        seen.iter().fold(R::ZERO, |sum, seen| sum + self.radiance(filter, seen))
    }
}

impl<R: Real> Seen<R> {
    fn derivatives(&self, derivatives: Derivatives) -> [[R; 2]; 2] {
        match derivatives {
            Derivatives::Disk => self.disk,
            Derivatives::Slope => self.slope,
        }
    }

    fn kernel(&self, derivatives: Derivatives) -> Kernel<R> {
        let [u, v] = self.derivatives(derivatives);
        match derivatives {
            Derivatives::Disk => DiskKernel::of(u, v, PixelFilter::BOX).as_slopes(),
            Derivatives::Slope => Kernel::of(&Footprint::from_slopes(u, v), PixelFilter::BOX),
        }
    }
}
