//! Filters of GGX that know the half vector.

use core::marker::PhantomData;

use lobe::PixelFilter;
use lobe::ndf::GgxDistribution;

use super::super::shading::{Parallelogram, Rectangle, Widened, Widening};
use super::super::{Distribution, Family, Method};
use super::Filter;
use crate::window::PixelWindow;

/// A filter of GGX that makes a wider lobe of the half vector's footprint.
pub(super) fn forward<F>(
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
pub(super) fn widened() -> Vec<Method> {
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
        "Derivatives on the projected disk used as slopes, variance 1/4, added alpha^2 at most \
            0.18.",
        PixelWindow::GaussianQuarter,
        Widening::Tokuyoshi,
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
    let projected = forward(
        "projected space",
        "Tokuyoshi & Kaplanyan 2021, Listing 1",
        "Variance addition on the projected disk, 1/(2 pi), there and back; no clamp.",
        PixelWindow::GaussianUnitPeak,
        Widening::Projected(unit_peak),
    );
    methods.extend(tokuyoshi.both());
    methods.extend(projected.both());
    methods.push(
        forward(
            "projected space, axis-aligned",
            "Tokuyoshi & Kaplanyan 2021, axis-aligned form",
            "The same for the bounding rectangle on the disk, added alpha^2 at most 0.18.",
            PixelWindow::GaussianUnitPeak,
            Widening::ProjectedAlong(unit_peak),
        )
        .in_quads(),
    );
    methods
}

/// GGX averaged over the footprint.
pub(super) fn over_an_area() -> Vec<Method> {
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
