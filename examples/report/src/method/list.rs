//! Every method, with its source and what it stands for.

use core::marker::PhantomData;

use lobe::PixelFilter;
use lobe::filter::preset::Engine;
use lobe::ndf::{BeckmannDistribution, GgxDistribution};

use super::count::counting;
use super::deferred::Deferred;
use super::shading::{Parallelogram, Plain, Rectangle, Shade, Tokuyoshi, Widened, Widening};
use super::{Derivatives, Distribution, Family, Method, by_pixel};
use crate::window::PixelWindow;

/// Sample counts of the line to beat.
const SUPERSAMPLING: [u32; 5] = [1, 4, 16, 64, 256];

/// A filter before it is given derivatives.
struct Filter<F> {
    name: &'static str,
    source: &'static str,
    note: &'static str,
    distribution: Distribution,
    family: Family,
    window: PixelWindow,
    shade: F,
}

impl<F: Shade + Clone + Send + Sync + 'static> Filter<F> {
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
            family: self.family,
            samples: 1,
            derivatives,
            window: self.window,
            shading: by_pixel(self.shade.clone(), derivatives),
            counting: counting(self.shade.clone(), derivatives),
        }
    }
}

/// Plain supersampling; one sample is what every engine starts from.
fn supersampling(distribution: Distribution, samples: u32) -> Method {
    let name = match samples {
        1 => "none (1 sample)".into(),
        many => format!("supersampling {many}"),
    };
    let (ggx, beckmann) =
        (Plain::<GgxDistribution>(PhantomData), Plain::<BeckmannDistribution>(PhantomData));
    let none = Derivatives::None;
    let (shading, counting) = match distribution {
        Distribution::Ggx => (by_pixel(ggx.clone(), none), counting(ggx, none)),
        Distribution::Beckmann => (by_pixel(beckmann.clone(), none), counting(beckmann, none)),
    };
    Method {
        name,
        source: "the line to beat",
        note: "Geometry and unfiltered shading at the points of a Hammersley net in the pixel.",
        distribution,
        family: Family::Supersampling,
        samples,
        derivatives: Derivatives::None,
        window: PixelWindow::Box,
        shading,
        counting,
    }
}

/// Every method, in the order of the tables.
pub(crate) fn all() -> Vec<Method> {
    let mut methods = Vec::from(SUPERSAMPLING.map(|n| supersampling(Distribution::Ggx, n)));
    methods.extend(ggx_widened());
    methods.extend(ggx_over_an_area());
    methods.extend(ggx_deferred());
    methods.extend(engines());
    methods.extend(SUPERSAMPLING.map(|n| supersampling(Distribution::Beckmann, n)));
    methods.extend(beckmann());
    methods
}

/// A filter of GGX that makes a wider lobe of the half vector's footprint.
fn forward<F>(
    name: &'static str,
    source: &'static str,
    note: &'static str,
    window: PixelWindow,
    shade: F,
) -> Filter<F> {
    let (distribution, family) = (Distribution::Ggx, Family::Widened);
    Filter { name, source, note, distribution, family, window, shade }
}

/// GGX with a wider GGX in its place.
fn ggx_widened() -> Vec<Method> {
    let added = |filter| Widened::<GgxDistribution>(filter, PhantomData);
    let widened = forward(
        "variance addition, 1/12",
        "Kaplanyan et al. 2016, Eq. 15 applied to GGX",
        "Kernel covariance with the box pixel's own variance, 1/12, added to the roughness matrix.",
        PixelWindow::GaussianTwelfth,
        added(PixelFilter::BOX),
    );
    let tokuyoshi = forward(
        "Tokuyoshi 2017",
        "Tokuyoshi 2017, Listing 1",
        "Derivatives on the projected disk used as slopes, variance 1/4, added alpha^2 at most 0.18.",
        PixelWindow::GaussianQuarter,
        Tokuyoshi,
    );
    let unit_peak = PixelFilter::TOKUYOSHI_KAPLANYAN;
    let mut methods = Vec::from(widened.both());
    methods.extend([
        forward(
            "variance addition, 1/(2 pi)",
            "Tokuyoshi & Kaplanyan 2021, the variance; alpha^2 + w^2/pi",
            "The same with the variance of the Gaussian whose peak is one per pixel.",
            PixelWindow::GaussianUnitPeak,
            added(unit_peak),
        )
        .in_quads(),
        forward(
            "variance addition, 1/4",
            "Kaplanyan et al. 2016, section 4.3",
            "The same with the published pixel variance, 1/4: three times the box's. Unclamped.",
            PixelWindow::GaussianQuarter,
            added(PixelFilter::KAPLANYAN),
        )
        .in_quads(),
        forward(
            "Kaplanyan's proxy",
            "Kaplanyan et al. 2016, Eq. 20, last form",
            "alpha^2 + w^2 along each axis of the bounding rectangle, w at most 1.",
            PixelWindow::Box,
            Widening::Proxy,
        )
        .in_quads(),
        forward(
            "Gaussian peak, fitted",
            "lobe, Roughness::peak_fitted",
            "The kernel of 1/12 times the factor that gives the widened lobe the true peak.",
            PixelWindow::GaussianTwelfth,
            Widening::Fitted(PixelFilter::BOX),
        )
        .in_quads(),
    ]);
    methods.extend(tokuyoshi.both());
    methods.extend([
        forward(
            "projected space",
            "Tokuyoshi & Kaplanyan 2021, Listing 1",
            "Variance addition on the projected disk, 1/(2 pi), there and back; no clamp.",
            PixelWindow::GaussianUnitPeak,
            Widening::Projected(unit_peak),
        )
        .in_quads(),
        forward(
            "projected space, axis-aligned",
            "Tokuyoshi & Kaplanyan 2021, axis-aligned form",
            "The same for the bounding rectangle on the disk, added alpha^2 at most 0.18.",
            PixelWindow::GaussianUnitPeak,
            Widening::ProjectedAlong(unit_peak),
        )
        .in_quads(),
    ]);
    methods
}

/// GGX averaged over the footprint.
fn ggx_over_an_area() -> Vec<Method> {
    let rectangle = forward(
        "rectangle",
        "Kaplanyan et al. 2016, Eq. 16 and Appendix A (corners corrected)",
        "Mean over the footprint's bounding rectangle, extents from 0.001 to 1, eight arctangents.",
        PixelWindow::Box,
        Rectangle::<GgxDistribution>(PhantomData),
    );
    let rectangle = Filter { family: Family::Area, ..rectangle };
    let parallelogram = forward(
        "exact parallelogram",
        "lobe, Ggx::brdf_over",
        "Mean over the footprint itself, unclamped: Lambert's polygon formula, stable in f32.",
        PixelWindow::Box,
        Parallelogram,
    );
    let parallelogram = Filter { family: Family::Area, ..parallelogram };
    let mut methods = vec![rectangle.in_quads()];
    methods.extend(parallelogram.both());
    methods
}

/// GGX whose roughness was filtered before the light was known.
fn ggx_deferred() -> Vec<Method> {
    let form = |name, source, note, window, shade: Deferred| {
        Filter { family: Family::Deferred, ..forward(name, source, note, window, shade) }.in_quads()
    };
    let (quarter, unit_peak) = (PixelWindow::GaussianQuarter, PixelWindow::GaussianUnitPeak);
    vec![
        form(
            "deferred, sum",
            "Tokuyoshi 2017, Eq. 13; O3DE ships it",
            "alpha^2 + the sum of the normal kernel's eigenvalues, variance 1/4, at most 0.18.",
            quarter,
            Deferred::Sum,
        ),
        form(
            "deferred, largest",
            "Tokuyoshi 2017, Eq. 10",
            "The same with the largest eigenvalue in place of their sum.",
            quarter,
            Deferred::Largest,
        ),
        form(
            "deferred, mean",
            "Tokuyoshi & Kaplanyan 2021, Eq. 14 and Listing 5",
            "The same with the mean of the eigenvalues and the variance 1/(2 pi).",
            unit_peak,
            Deferred::Mean,
        ),
        form(
            "deferred, rectangle",
            "Kaplanyan et al. 2016, section 5.4",
            "The quad's average normal in each frame; its rectangle widens each axis, variance 1/4, at most 0.18.",
            quarter,
            Deferred::Rectangle,
        ),
        form(
            "deferred, widest",
            "Kaplanyan et al. 2016, section 5.4; Tokuyoshi 2017, Listing 3",
            "The same with the larger width for both axes.",
            quarter,
            Deferred::Widest,
        ),
    ]
}

/// What engines ship; O3DE's is the deferred sum.
fn engines() -> Vec<Method> {
    let shipped = Engine::ALL.into_iter().filter(|engine| *engine != Engine::O3de);
    let method = |engine: Engine| {
        Filter {
            name: engine.name(),
            source: "lobe::filter::preset, as shipped",
            note: engine.formula(),
            distribution: Distribution::Ggx,
            family: Family::Engine,
            window: PixelWindow::Box,
            shade: Deferred::Engine(engine),
        }
        .in_quads()
    };
    shipped.map(method).collect()
}

fn beckmann() -> Vec<Method> {
    let filter = |name, source, note, window, filter| Filter {
        name,
        source,
        note,
        distribution: Distribution::Beckmann,
        family: Family::Widened,
        window,
        shade: Widened::<BeckmannDistribution>(filter, PhantomData),
    };
    let gaussian = filter(
        "Gaussian, 1/12",
        "Kaplanyan et al. 2016, Eq. 15",
        "Exact convolution with a Gaussian of the box pixel's variance, 1/12.",
        PixelWindow::GaussianTwelfth,
        PixelFilter::BOX,
    );
    let mut methods = Vec::from(gaussian.both());
    methods.extend([
        filter(
            "Gaussian, 1/(2 pi)",
            "Tokuyoshi & Kaplanyan 2021, the variance",
            "The same with the variance of the Gaussian whose peak is one per pixel.",
            PixelWindow::GaussianUnitPeak,
            PixelFilter::TOKUYOSHI_KAPLANYAN,
        )
        .in_quads(),
        filter(
            "Gaussian, 1/4",
            "Kaplanyan et al. 2016, Eq. 15",
            "The same with the published pixel variance, 1/4.",
            PixelWindow::GaussianQuarter,
            PixelFilter::KAPLANYAN,
        )
        .in_quads(),
        Filter {
            name: "rectangle",
            source: "Kaplanyan et al. 2016, Eq. 16",
            note: "Mean over the footprint's bounding rectangle, extents from 0.001 to 1, error functions.",
            distribution: Distribution::Beckmann,
            family: Family::Area,
            window: PixelWindow::Box,
            shade: Rectangle::<BeckmannDistribution>(PhantomData),
        }
        .in_quads(),
    ]);
    methods
}
