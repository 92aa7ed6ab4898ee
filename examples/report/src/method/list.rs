//! Every method, with its source and what it stands for.

use core::marker::PhantomData;

use lobe::PixelFilter;
use lobe::ndf::{BeckmannDistribution, GgxDistribution};

use super::shading::{Parallelogram, Plain, Rectangle, Shade, Tokuyoshi, Widened};
use super::{Derivatives, Distribution, Method, by_pixel};
use crate::window::PixelWindow;

/// Sample counts of the line to beat.
const SUPERSAMPLING: [u32; 5] = [1, 4, 16, 64, 256];

/// A filter before it is given derivatives.
struct Filter<F> {
    name: &'static str,
    source: &'static str,
    note: &'static str,
    distribution: Distribution,
    window: PixelWindow,
    shade: fn() -> F,
}

impl<F: Shade + Send + Sync + 'static> Filter<F> {
    /// With differences in quads.
    fn in_quads(&self) -> Method {
        self.with(self.name.into(), Derivatives::Quad)
    }

    /// With differences in quads, and with analytic derivatives.
    fn both(&self) -> [Method; 2] {
        let name = format!("{}, analytic", self.name);
        [self.in_quads(), self.with(name, Derivatives::Analytic)]
    }

    fn with(&self, name: String, derivatives: Derivatives) -> Method {
        Method {
            name,
            source: self.source,
            note: self.note,
            distribution: self.distribution,
            samples: 1,
            derivatives,
            window: self.window,
            shading: by_pixel((self.shade)(), derivatives),
        }
    }
}

/// Plain supersampling; one sample is what every engine starts from.
fn supersampling(distribution: Distribution, samples: u32) -> Method {
    let name = match samples {
        1 => "none (1 sample)".into(),
        many => format!("supersampling {many}"),
    };
    let shading = match distribution {
        Distribution::Ggx => by_pixel(Plain::<GgxDistribution>(PhantomData), Derivatives::None),
        Distribution::Beckmann => {
            by_pixel(Plain::<BeckmannDistribution>(PhantomData), Derivatives::None)
        }
    };
    Method {
        name,
        source: "the line to beat",
        note: "Geometry and unfiltered shading at the points of a Hammersley net in the pixel.",
        distribution,
        samples,
        derivatives: Derivatives::None,
        window: PixelWindow::Box,
        shading,
    }
}

/// Every method, in the order of the tables.
pub(crate) fn all() -> Vec<Method> {
    let mut methods = ggx();
    methods.extend(beckmann());
    methods
}

fn ggx() -> Vec<Method> {
    let distribution = Distribution::Ggx;
    let mut methods = Vec::from(SUPERSAMPLING.map(|n| supersampling(distribution, n)));
    let widened = Filter {
        name: "variance addition, 1/12",
        source: "Kaplanyan et al. 2016, Eq. 15 applied to GGX",
        note: "Kernel covariance with the box pixel's own variance, 1/12, added to the roughness matrix.",
        distribution,
        window: PixelWindow::GaussianTwelfth,
        shade: || Widened::<GgxDistribution>(PixelFilter::BOX, PhantomData),
    };
    methods.extend(widened.both());
    methods.push(
        Filter {
            name: "variance addition, 1/(2 pi)",
            source: "Tokuyoshi & Kaplanyan 2021, the variance",
            note: "The same with the variance of the Gaussian whose peak is one per pixel.",
            distribution,
            window: PixelWindow::GaussianUnitPeak,
            shade: || Widened::<GgxDistribution>(PixelFilter::TOKUYOSHI_KAPLANYAN, PhantomData),
        }
        .in_quads(),
    );
    methods.push(
        Filter {
            name: "variance addition, 1/4",
            source: "Kaplanyan et al. 2016, section 4.3",
            note: "The same with the published pixel variance, 1/4: three times the box's.",
            distribution,
            window: PixelWindow::GaussianQuarter,
            shade: || Widened::<GgxDistribution>(PixelFilter::KAPLANYAN, PhantomData),
        }
        .in_quads(),
    );
    let tokuyoshi = Filter {
        name: "Tokuyoshi 2017",
        source: "Tokuyoshi 2017, Listing 1",
        note: "Derivatives on the projected disk used as slopes, variance 1/4, added alpha^2 at most 0.18.",
        distribution,
        window: PixelWindow::GaussianQuarter,
        shade: || Tokuyoshi,
    };
    methods.extend(tokuyoshi.both());
    methods.push(
        Filter {
            name: "rectangle",
            source: "Kaplanyan et al. 2016, Eq. 16 and Appendix A (corners corrected)",
            note: "Mean over the footprint's bounding rectangle, extents from 0.001 to 1, eight arctangents.",
            distribution,
            window: PixelWindow::Box,
            shade: || Rectangle::<GgxDistribution>(PhantomData),
        }
        .in_quads(),
    );
    let parallelogram = Filter {
        name: "exact parallelogram",
        source: "lobe, Ggx::brdf_over",
        note: "Mean over the footprint itself, unclamped: Lambert's polygon formula, stable in f32.",
        distribution,
        window: PixelWindow::Box,
        shade: || Parallelogram,
    };
    methods.extend(parallelogram.both());
    methods
}

fn beckmann() -> Vec<Method> {
    let distribution = Distribution::Beckmann;
    let mut methods = Vec::from(SUPERSAMPLING.map(|n| supersampling(distribution, n)));
    let gaussian = Filter {
        name: "Gaussian, 1/12",
        source: "Kaplanyan et al. 2016, Eq. 15",
        note: "Exact convolution with a Gaussian of the box pixel's variance, 1/12.",
        distribution,
        window: PixelWindow::GaussianTwelfth,
        shade: || Widened::<BeckmannDistribution>(PixelFilter::BOX, PhantomData),
    };
    methods.extend(gaussian.both());
    methods.push(
        Filter {
            name: "Gaussian, 1/(2 pi)",
            source: "Tokuyoshi & Kaplanyan 2021, the variance",
            note: "The same with the variance of the Gaussian whose peak is one per pixel.",
            distribution,
            window: PixelWindow::GaussianUnitPeak,
            shade: || {
                Widened::<BeckmannDistribution>(PixelFilter::TOKUYOSHI_KAPLANYAN, PhantomData)
            },
        }
        .in_quads(),
    );
    methods.push(
        Filter {
            name: "Gaussian, 1/4",
            source: "Kaplanyan et al. 2016, Eq. 15",
            note: "The same with the published pixel variance, 1/4.",
            distribution,
            window: PixelWindow::GaussianQuarter,
            shade: || Widened::<BeckmannDistribution>(PixelFilter::KAPLANYAN, PhantomData),
        }
        .in_quads(),
    );
    methods.push(
        Filter {
            name: "rectangle",
            source: "Kaplanyan et al. 2016, Eq. 16",
            note: "Mean over the footprint's bounding rectangle, extents from 0.001 to 1, error functions.",
            distribution,
            window: PixelWindow::Box,
            shade: || Rectangle::<BeckmannDistribution>(PhantomData),
        }
        .in_quads(),
    );
    methods
}
