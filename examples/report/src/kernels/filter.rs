//! The filters: what each makes of a GGX of alpha 1 under a pixel.

use lobe::filter::{box_peak_alpha, gaussian_peak_alpha, kaplanyan_proxy_alpha};
use lobe::{Error, Footprint, Kernel, PixelFilter, Roughness};
use serde::Serialize;

use super::density::Density;
use super::pixel::Pixel;

/// Filters of one idea.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) enum Family {
    /// No filter.
    Nothing,
    /// The kernel added to the roughness matrix, under some pixel variance.
    Added,
    /// Kaplanyan et al. 2016 as they are used.
    Published,
    /// A GGX with the peak of the filtered one.
    Peak,
    /// The filtered density itself.
    Exact,
}

/// What a filter gives.
enum Form {
    /// A GGX of this alpha.
    Alpha(fn(&Pixel) -> Result<f64, Error>),
    /// Another density.
    Density(fn(&Pixel) -> Result<Density, Error>),
}

/// A filter: its names, where it comes from, and what it gives.
#[derive(Serialize)]
pub(crate) struct Filter {
    pub(crate) name: &'static str,
    /// The name where there is little room.
    pub(crate) label: &'static str,
    pub(crate) formula: &'static str,
    pub(crate) source: &'static str,
    pub(crate) family: Family,
    #[serde(skip)]
    form: Form,
}

impl Filter {
    /// True if the result is a GGX again.
    pub(crate) fn is_closed(&self) -> bool {
        matches!(self.form, Form::Alpha(_))
    }

    /// alpha of the resulting GGX; none if it is none.
    pub(super) fn alpha(&self, pixel: &Pixel) -> Result<Option<f64>, Error> {
        match self.form {
            Form::Alpha(alpha) => alpha(pixel).map(Some),
            Form::Density(_) => Ok(None),
        }
    }

    /// What the filter gives under a pixel.
    pub(super) fn density(&self, pixel: &Pixel) -> Result<Density, Error> {
        match self.form {
            Form::Alpha(alpha) => Density::widened(alpha(pixel)?),
            Form::Density(density) => density(pixel),
        }
    }
}

/// Variance addition as the library has it, over a square footprint of the pixel's width.
fn added(pixel: &Pixel, filter: PixelFilter) -> Result<f64, Error> {
    let kernel = Kernel::of(&Footprint::rectangle([pixel.width; 2]), filter);
    Ok(Roughness::from_alpha(1.0)?.widened(&kernel).alphas().major)
}

/// Every filter, in the order of the tables.
pub(super) static FILTERS: [Filter; 11] = [
    Filter {
        name: "none",
        label: "none",
        formula: "alpha",
        source: "what every engine starts from",
        family: Family::Nothing,
        form: Form::Alpha(|_| Ok(1.0)),
    },
    Filter {
        name: "variance addition, 1/12",
        label: "variance, 1/12",
        formula: "alpha'^2 = alpha^2 + 2 sigma^2 = alpha^2 + w^2/6: the pixels' own variance",
        source: "Kaplanyan et al. 2016, Eq. 15 applied to GGX",
        family: Family::Added,
        form: Form::Alpha(|pixel| added(pixel, PixelFilter::BOX)),
    },
    Filter {
        name: "variance addition, 1/4",
        label: "variance, 1/4",
        formula: "alpha'^2 = alpha^2 + w^2/2",
        source: "Kaplanyan et al. 2016, section 4.3; Tokuyoshi 2017, Eq. 2",
        family: Family::Added,
        form: Form::Alpha(|pixel| added(pixel, PixelFilter::KAPLANYAN)),
    },
    Filter {
        name: "variance addition, 1/(2 pi)",
        label: "variance, 1/(2\u{3c0})",
        formula: "alpha'^2 = alpha^2 + w^2/pi",
        source: "Tokuyoshi & Kaplanyan 2021, its variance in slope space",
        family: Family::Added,
        form: Form::Alpha(|pixel| added(pixel, PixelFilter::TOKUYOSHI_KAPLANYAN)),
    },
    Filter {
        name: "Eq. 20, last form",
        label: "Eq. 20, last form",
        formula: "alpha'^2 = alpha^2 + w^2",
        source: "Kaplanyan et al. 2016, Eq. 20, second line",
        family: Family::Published,
        form: Form::Alpha(|pixel| kaplanyan_proxy_alpha(1.0, pixel.width)),
    },
    Filter {
        name: "Eq. 20, re-derived",
        label: "Eq. 20, re-derived",
        formula: "alpha'^2 = w r / (4 atan(w/r)), r^2 = 4 alpha^2 + w^2: the exact peak of the box",
        source: "Kaplanyan et al. 2016, Eq. 18 to 20, solved anew; filter::box_peak_alpha",
        family: Family::Peak,
        form: Form::Alpha(|pixel| box_peak_alpha(1.0, pixel.width)),
    },
    Filter {
        name: "Gaussian peak, exact",
        label: "Gaussian peak",
        formula: "alpha'^2 = k / (1 - x e^x E1(x)), k = 2 sigma^2, x = alpha^2/k",
        source: "lobe, filter::gaussian_peak_alpha",
        family: Family::Peak,
        form: Form::Alpha(|pixel| gaussian_peak_alpha(1.0, pixel.sigma)),
    },
    Filter {
        name: "Gaussian peak, fitted",
        label: "its fit",
        formula: "alpha'^2 = alpha^2 + t k, t a quotient of polynomials in sqrt(k)/alpha",
        source: "lobe, Roughness::peak_fitted",
        family: Family::Peak,
        form: Form::Alpha(|pixel| {
            Ok(Roughness::from_alpha(1.0)?.peak_fitted(&pixel.kernel()).alphas().major)
        }),
    },
    Filter {
        name: "Appendix A rectangle, f32",
        label: "Appendix A, f32",
        formula: "mean over the square, eight arctangents",
        source: "Kaplanyan et al. 2016, Eq. 16 and Appendix A (corners corrected)",
        family: Family::Published,
        form: Form::Density(|pixel| Ok(Density::AppendixA(pixel.width as f32))),
    },
    Filter {
        name: "exact square, f32",
        label: "exact square, f32",
        formula: "mean over the square, stable in f32",
        source: "lobe, Ndf::rectangle_mean, which is Ndf::parallelogram_mean along the axes",
        family: Family::Exact,
        form: Form::Density(Density::square_single),
    },
    Filter {
        name: "exact Gaussian, f64",
        label: "exact Gaussian",
        formula: "convolution with the Gaussian, by quadrature",
        source: "lobe, filter::ggx_gaussian_mean",
        family: Family::Exact,
        form: Form::Density(Density::gaussian),
    },
];
