//! Slope densities that are held against each other: truths, and what filters make of them.

use std::f64::consts::FRAC_PI_4;

use lobe::filter::{ggx_gaussian_mean, kaplanyan_rectangle_mean};
use lobe::{Error, Ggx, Isotropic, Kernel, Lobe, Roughness};

use super::pixel::Pixel;

/// Directions of a [`Density::ring`]: enough that angles leave no error in the digits shown.
pub(super) const DIRECTIONS: usize = 24;

/// A density over slopes, centered and with the symmetries of the square.
pub(crate) enum Density {
    /// GGX of some alpha: what every widened lobe is.
    Widened(Ggx<Isotropic<f64>>),
    /// GGX of alpha 1 over a square of this width, exactly.
    Square(Ggx<Isotropic<f64>>, f64),
    /// The same in f32.
    SquareSingle(Ggx<Isotropic<f32>>, f32),
    /// The same by Kaplanyan's Appendix A.
    AppendixA(f32),
    /// GGX of alpha 1 under a Gaussian, by quadrature.
    Gaussian(Lobe<f64>, Kernel<f64>),
}

impl Density {
    pub(super) fn widened(alpha: f64) -> Result<Self, Error> {
        Ok(Self::Widened(Ggx::new(Isotropic::new(alpha)?)))
    }

    pub(super) fn square(pixel: &Pixel) -> Result<Self, Error> {
        Ok(Self::Square(Ggx::new(Isotropic::new(1.0)?), pixel.width))
    }

    pub(super) fn square_single(pixel: &Pixel) -> Result<Self, Error> {
        Ok(Self::SquareSingle(Ggx::new(Isotropic::new(1.0)?), pixel.width as f32))
    }

    pub(super) fn gaussian(pixel: &Pixel) -> Result<Self, Error> {
        Ok(Self::Gaussian(Lobe::centered(Roughness::from_alpha(1.0)?), pixel.kernel()))
    }

    /// The density at a slope, along the axes of the pixel.
    pub(super) fn at(&self, slope: [f64; 2]) -> f64 {
        let single = slope.map(|s| s as f32);
        match self {
            Self::Widened(ggx) => ggx.slope_pdf(slope),
            Self::Square(ggx, width) => ggx.rectangle_mean(slope, [*width; 2]),
            Self::SquareSingle(ggx, width) => ggx.rectangle_mean(single, [*width; 2]).into(),
            Self::AppendixA(width) => {
                kaplanyan_rectangle_mean([1.0, 1.0], single, [*width; 2]).into()
            }
            Self::Gaussian(lobe, kernel) => ggx_gaussian_mean(lobe, slope, kernel),
        }
    }

    /// Whether it falls to 0 far from the lobe. Appendix A does not in f32: its terms cancel to a
    /// rounding error that does not depend on distance, and whose integral over the plane has no
    /// limit.
    pub(super) fn decays(&self) -> bool {
        !matches!(self, Self::AppendixA(_))
    }

    fn is_radial(&self) -> bool {
        matches!(self, Self::Widened(_) | Self::Gaussian(..))
    }

    /// Values on a circle, at the middles of equal parts of an eighth of it; the rest is their
    /// mirror image.
    pub(super) fn ring(&self, radius: f64) -> [f64; DIRECTIONS] {
        if self.is_radial() {
            return [self.at([radius, 0.0]); DIRECTIONS];
        }
        std::array::from_fn(|k| {
            let angle = FRAC_PI_4 * (k as f64 + 0.5) / DIRECTIONS as f64;
            self.at([radius * angle.cos(), radius * angle.sin()])
        })
    }
}
