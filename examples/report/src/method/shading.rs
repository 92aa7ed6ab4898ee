//! The shading functions: BRDF times cosine and light of one pixel, a few lines each.
//!
//! Generic over the precision, the material's shape and where derivatives come from.

use core::marker::PhantomData;

use lobe::filter::{DiskKernel, beckmann_rectangle_mean, kaplanyan_rectangle_mean};
use lobe::ndf::{BeckmannDistribution, GgxDistribution};
use lobe::slope::Whiten;
use lobe::slope::direction::slope_of;
use lobe::{
    Anisotropic, Distribution, Footprint, Kernel, LobeShape, Ndf, PixelFilter, Real, Roughness,
};

use super::material::Material;
use super::pixel::Pixel;
use crate::scene::Sample;

/// A way to shade a pixel.
pub(super) trait Shade {
    /// Radiance towards the eye.
    fn shade<S: Whiten, P: Pixel<S::Scalar>>(&self, material: &Material<S>, pixel: &P)
    -> S::Scalar;
}

/// BRDF times cosine and light.
#[inline]
pub(super) fn lit<R: Real>(brdf: R, sample: &Sample<R>) -> R {
    brdf * sample.wi[2] * sample.strength
}

/// BRDF times cosine and light of a shape in place of the material's.
#[inline]
fn lit_as<D: Distribution, S: LobeShape>(shape: S, sample: &Sample<S::Scalar>) -> S::Scalar {
    lit(Ndf::<D, S>::new(shape).brdf(sample.wo, sample.wi), sample)
}

/// BRDF times cosine and light of a lobe in place of the material's.
#[inline]
pub(super) fn lit_by<D: Distribution, R: Real>(roughness: Roughness<R>, sample: &Sample<R>) -> R {
    lit(Ndf::<D, _>::new(Anisotropic::new(roughness)).brdf(sample.wo, sample.wi), sample)
}

/// One sample, no filter.
#[derive(Clone)]
pub(super) struct Plain<D>(pub(super) PhantomData<D>);

impl<D: Distribution> Shade for Plain<D> {
    #[inline]
    fn shade<S: Whiten, P: Pixel<S::Scalar>>(
        &self,
        material: &Material<S>,
        pixel: &P,
    ) -> S::Scalar {
        let sample = pixel.sample();
        lit(Ndf::<D, S>::new(material.shape).brdf(sample.wo, sample.wi), sample)
    }
}

/// A Gaussian kernel of a pixel filter, its variance added to the roughness: for Beckmann the
/// convolution.
#[derive(Clone)]
pub(super) struct Widened<D>(pub(super) PixelFilter, pub(super) PhantomData<D>);

impl<D: Distribution> Shade for Widened<D> {
    #[inline]
    fn shade<S: Whiten, P: Pixel<S::Scalar>>(
        &self,
        material: &Material<S>,
        pixel: &P,
    ) -> S::Scalar {
        let kernel = Kernel::of(&pixel.footprint(), self.0);
        lit_as::<D, _>(kernel.widen(material.shape), pixel.sample())
    }
}

/// Which kernel a filter makes of a pixel.
#[derive(Clone, Copy)]
pub(super) enum Widening {
    /// The fit of the Gaussian's peak.
    Fitted(PixelFilter),
    /// The bounding rectangle's widths, squared: Kaplanyan's GGX proxy.
    Proxy,
    /// Disk derivatives used unchanged, a wide kernel, a cap on what it adds.
    Tokuyoshi,
    /// On the projected disk, there and back.
    Projected(PixelFilter),
    /// The same for the bounding rectangle on the disk, with a cap on what it adds.
    ProjectedAlong(PixelFilter),
}

impl Shade for Widening {
    #[inline]
    fn shade<S: Whiten, P: Pixel<S::Scalar>>(
        &self,
        material: &Material<S>,
        pixel: &P,
    ) -> S::Scalar {
        let limit = S::Scalar::lit(Kernel::<S::Scalar>::ALPHA_SQUARED_LIMIT);
        let (shape, roughness) = (material.shape, &material.roughness);
        let wider = match *self {
            Self::Fitted(filter) => Kernel::of(&pixel.footprint(), filter).widen_to_peak(shape),
            Self::Proxy => {
                let widths = S::Scalar::lit(Footprint::<S::Scalar>::WIDTH_LIMIT);
                let rectangle = pixel.footprint().bounding_within(widths);
                Kernel::of(&rectangle, PixelFilter::KAPLANYAN_PROXY).widen(shape)
            }
            Self::Tokuyoshi => {
                let kernel = Kernel::of(&pixel.narrowed_footprint(), PixelFilter::KAPLANYAN);
                kernel.capped(limit).widen(shape)
            }
            Self::Projected(filter) => {
                let steps = pixel.narrowed_footprint();
                let kernel = DiskKernel::of(steps.u, steps.v, filter);
                let wider = roughness.widened_on_disk(&kernel);
                return lit_by::<GgxDistribution, _>(wider, pixel.sample());
            }
            Self::ProjectedAlong(filter) => {
                let steps = pixel.narrowed_footprint();
                let kernel = DiskKernel::of_bounding(steps.u, steps.v, filter).capped(limit);
                let wider = roughness.widened_on_disk(&kernel);
                return lit_by::<GgxDistribution, _>(wider, pixel.sample());
            }
        };
        lit_as::<GgxDistribution, _>(wider, pixel.sample())
    }
}

/// Extents of the rectangle, below and above: Kaplanyan et al. 2016, section 5.2. The lower one
/// keeps Appendix A out of its cancellation.
const EXTENTS: [f64; 2] = [1e-3, 1.0];

/// The mean of a distribution over the footprint's clamped bounding rectangle.
#[derive(Clone)]
pub(super) struct Rectangle<D>(pub(super) PhantomData<D>);

/// A distribution with a mean over rectangles along its axes, given alphas, slope and widths.
pub(super) trait RectangleMean: Distribution {
    fn mean<R: Real>(alphas: [R; 2], slope: [R; 2], widths: [R; 2]) -> R;
}

impl RectangleMean for GgxDistribution {
    /// By eight arctangents.
    #[inline]
    fn mean<R: Real>(alphas: [R; 2], slope: [R; 2], widths: [R; 2]) -> R {
        kaplanyan_rectangle_mean(alphas, slope, widths)
    }
}

impl RectangleMean for BeckmannDistribution {
    /// By differences of the error function.
    #[inline]
    fn mean<R: Real>(alphas: [R; 2], slope: [R; 2], widths: [R; 2]) -> R {
        beckmann_rectangle_mean(alphas, slope, widths)
    }
}

impl<D: RectangleMean> Shade for Rectangle<D> {
    #[inline]
    fn shade<S: Whiten, P: Pixel<S::Scalar>>(
        &self,
        material: &Material<S>,
        pixel: &P,
    ) -> S::Scalar {
        let sample = pixel.sample();
        let half = sample.half;
        if !(half[2] > S::Scalar::ZERO) {
            return S::Scalar::ZERO;
        }
        let [least, most] = EXTENTS.map(S::Scalar::lit);
        let widths = pixel.footprint().extents().map(|width| width.max(least).min(most));
        let cos2 = half[2] * half[2];
        let d = D::mean(material.alphas, slope_of(half), widths) / (cos2 * cos2);
        let visibility = Ndf::<D, S>::new(material.shape).visibility(sample.wo, sample.wi);
        lit(d * visibility, sample)
    }
}

/// GGX over the footprint itself.
#[derive(Clone)]
pub(super) struct Parallelogram;

impl Shade for Parallelogram {
    #[inline]
    fn shade<S: Whiten, P: Pixel<S::Scalar>>(
        &self,
        material: &Material<S>,
        pixel: &P,
    ) -> S::Scalar {
        let sample = pixel.sample();
        let ggx = Ndf::<GgxDistribution, S>::new(material.shape);
        lit(ggx.brdf_over(sample.wo, sample.wi, &pixel.footprint()), sample)
    }
}
