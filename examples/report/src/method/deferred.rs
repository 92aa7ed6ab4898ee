//! Shading with a roughness that was filtered before the light was known.

use lobe::filter::engine::Engine;
use lobe::filter::{
    kaplanyan_deferred_alpha, kaplanyan_deferred_alphas, largest_deferred_alpha,
    tokuyoshi_deferred_alpha, tokuyoshi_kaplanyan_deferred_alpha,
};
use lobe::ndf::GgxDistribution;
use lobe::slope::Whiten;
use lobe::{AxisAligned, Error, Kernel, Ndf, PixelFilter, Real};

use super::material::Material;
use super::pixel::Pixel;
use super::shading::{Shade, lit};

/// What becomes of the change of the normal.
#[derive(Clone, Copy)]
pub(super) enum Deferred {
    /// Tokuyoshi 2017, Eq. 13.
    Sum,
    /// Tokuyoshi & Kaplanyan 2021, Eq. 14.
    Mean,
    /// Tokuyoshi 2017, Eq. 10.
    Largest,
    /// Kaplanyan et al. 2016, section 5.4: two channels.
    Rectangle,
    /// The same, one channel.
    Widest,
    /// What an engine ships, given the shading normal.
    Engine(Engine),
}

impl Deferred {
    /// Roughness along the shading frame's axes, widened.
    #[inline]
    fn alphas<R: Real>(self, alphas: [R; 2], pixel: &impl Pixel<R>) -> Result<[R; 2], Error> {
        let limit = R::lit(Kernel::<R>::ALPHA_SQUARED_LIMIT);
        let quarter = PixelFilter::KAPLANYAN;
        if let Self::Rectangle = self {
            return kaplanyan_deferred_alphas(alphas, &pixel.normal_footprint(), quarter, limit);
        }
        let [u, v] = pixel.normal_steps();
        let along = |alpha: R| match self {
            Self::Sum => tokuyoshi_deferred_alpha(alpha, u, v, quarter, limit),
            Self::Mean => {
                let narrow = PixelFilter::TOKUYOSHI_KAPLANYAN;
                tokuyoshi_kaplanyan_deferred_alpha(alpha, u, v, narrow, limit)
            }
            Self::Largest => largest_deferred_alpha(alpha, u, v, quarter, limit),
            Self::Rectangle | Self::Widest => {
                kaplanyan_deferred_alpha(alpha, &pixel.normal_footprint(), quarter, limit)
            }
            Self::Engine(engine) => engine.alpha(alpha, u, v),
        };
        Ok([along(alphas[0])?, along(alphas[1])?])
    }
}

impl Shade for Deferred {
    #[inline]
    fn shade<S: Whiten, P: Pixel<S::Scalar>>(
        &self,
        material: &Material<S>,
        pixel: &P,
    ) -> S::Scalar {
        let shape = self.alphas(material.alphas, pixel).and_then(|[x, y]| AxisAligned::new(x, y));
        let sample = pixel.sample();
        // Alphas of a material are in range, and only grow.
        shape.map_or(S::Scalar::ZERO, |shape| {
            lit(Ndf::<GgxDistribution, _>::new(shape).brdf(sample.wo, sample.wi), sample)
        })
    }
}
