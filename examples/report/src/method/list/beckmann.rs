//! Filters of Beckmann.

use core::marker::PhantomData;

use lobe::PixelFilter;
use lobe::ndf::BeckmannDistribution;

use super::super::shading::{Rectangle, Widened};
use super::super::{Distribution, Family, Method};
use super::Filter;
use crate::window::PixelWindow;

/// Gaussians of every pixel filter, and the rectangle.
pub(super) fn filters() -> Vec<Method> {
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
            note: "Mean over the footprint's bounding rectangle, extents from 0.001 to 1, error \
                functions.",
            distribution: Distribution::Beckmann,
            family: Family::Area,
            window: PixelWindow::Box,
            shade: Rectangle::<BeckmannDistribution>(PhantomData),
        }
        .in_quads(),
    ]);
    methods
}
