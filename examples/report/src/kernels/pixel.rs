//! A pixel on the slope plane of a GGX of alpha 1, and the two truths about it.

use lobe::{Error, Footprint, Kernel, PixelFilter};
use serde::Serialize;

use super::density::Density;

/// What the pixel averages with; both have the same variance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub(crate) enum Truth {
    /// A square of uniform weight.
    Box,
    /// A Gaussian.
    Gaussian,
}

impl Truth {
    pub(crate) const ALL: [Self; 2] = [Self::Box, Self::Gaussian];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Box => "box",
            Self::Gaussian => "Gaussian",
        }
    }

    /// GGX of alpha 1 under this pixel, in f64.
    pub(super) fn density(self, pixel: &Pixel) -> Result<Density, Error> {
        match self {
            Self::Box => Density::square(pixel),
            Self::Gaussian => Density::gaussian(pixel),
        }
    }
}

/// Width of a square and deviation of a Gaussian of equal variance, $\sigma^2 = w^2/12$, in alphas.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pixel {
    pub(super) width: f64,
    pub(super) sigma: f64,
}

impl Pixel {
    /// The pixel with $2\sigma^2 = \kappa \alpha^2$, its width rounded to f32: filters of either
    /// precision then see the same square.
    pub(super) fn of_kappa(kappa: f64) -> Self {
        let width = f64::from((6.0 * kappa).sqrt() as f32);
        Self { width, sigma: width / 12.0_f64.sqrt() }
    }

    /// The Gaussian's covariance.
    pub(super) fn kernel(&self) -> Kernel<f64> {
        Kernel::of(&Footprint::rectangle([self.width; 2]), PixelFilter::BOX)
    }
}
