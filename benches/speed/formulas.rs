//! What the rows compute for one sample, each a small function of the sample's numbers.
//!
//! Directions come first, then parameters, of which shapes are built inside the loop, then a shape
//! that was built before it. Every function is generic, so that what is timed in f32 is counted,
//! too.

use super::columns::Pair;
use lobe::filter::DiskKernel;
use lobe::ndf::GgxDistribution;
use lobe::{
    Anisotropic, AxisAligned, Distribution, Error, Footprint, Ggx, Isotropic, Kernel, LobeShape,
    Ndf, NonCentered, PixelFilter, Psd, Real, Roughness,
};

/// What stands for a refused parameter.
#[inline(always)]
fn refused<R: Real>(_: Error) -> R {
    R::lit(f64::NAN)
}

#[inline(always)]
fn shaded<D: Distribution, S: LobeShape>(pair: Pair<S::Scalar>, shape: S) -> S::Scalar {
    Ndf::<D, S>::new(shape).brdf(pair.wo, pair.wi)
}

#[inline(always)]
pub(crate) fn isotropic<D: Distribution, R: Real>(pair: Pair<R>, [alpha]: [R; 1]) -> R {
    Isotropic::new(alpha).map_or_else(refused, |shape| shaded::<D, _>(pair, shape))
}

#[inline(always)]
pub(crate) fn axis_aligned<D: Distribution, R: Real>(pair: Pair<R>, [x, y]: [R; 2]) -> R {
    AxisAligned::new(x, y).map_or_else(refused, |shape| shaded::<D, _>(pair, shape))
}

#[inline(always)]
pub(crate) fn full<D: Distribution, R: Real>(
    pair: Pair<R>,
    []: [R; 0],
    shape: &Anisotropic<R>,
) -> R {
    shaded::<D, _>(pair, *shape)
}

#[inline(always)]
pub(crate) fn tilted_isotropic<D: Distribution, R: Real>(
    pair: Pair<R>,
    [alpha, m, n]: [R; 3],
) -> R {
    let tilted = Isotropic::new(alpha).and_then(|shape| NonCentered::new(shape, [m, n]));
    tilted.map_or_else(refused, |shape| shaded::<D, _>(pair, shape))
}

#[inline(always)]
pub(crate) fn tilted_axis_aligned<D: Distribution, R: Real>(
    pair: Pair<R>,
    [x, y, m, n]: [R; 4],
) -> R {
    let tilted = AxisAligned::new(x, y).and_then(|shape| NonCentered::new(shape, [m, n]));
    tilted.map_or_else(refused, |shape| shaded::<D, _>(pair, shape))
}

#[inline(always)]
pub(crate) fn tilted<D: Distribution, R: Real>(
    pair: Pair<R>,
    mean: [R; 2],
    shape: &Anisotropic<R>,
) -> R {
    NonCentered::new(*shape, mean).map_or_else(refused, |shape| shaded::<D, _>(pair, shape))
}

/// The kernel of a footprint under the box pixel.
#[inline(always)]
fn kernel<R: Real>([a, b, c, d]: [R; 4]) -> Kernel<R> {
    Kernel::of(&Footprint::from_slopes([a, b], [c, d]), PixelFilter::BOX)
}

#[inline(always)]
fn matrix<R: Real>([xx, xy, yy]: [R; 3]) -> Result<Roughness<R>, Error> {
    Psd::new(xx, xy, yy).map(Roughness::from_matrix)
}

#[inline(always)]
fn widened<D: Distribution, R: Real>(
    pair: Pair<R>,
    roughness: Result<Roughness<R>, Error>,
    footprint: [R; 4],
) -> R {
    // Not by a closure: the rows would share it, and call it.
    match roughness {
        Ok(roughness) => {
            shaded::<D, _>(pair, Anisotropic::new(roughness.widened(&kernel(footprint))))
        }
        Err(error) => refused(error),
    }
}

#[inline(always)]
fn widened_tilted<D: Distribution, R: Real>(
    pair: Pair<R>,
    mean: [R; 2],
    roughness: Result<Roughness<R>, Error>,
    footprint: [R; 4],
) -> R {
    // Not by closures: the rows would share them, and call them.
    let tilted = match roughness {
        Ok(roughness) => {
            NonCentered::new(Anisotropic::new(roughness.widened(&kernel(footprint))), mean)
        }
        Err(error) => Err(error),
    };
    match tilted {
        Ok(shape) => shaded::<D, _>(pair, shape),
        Err(error) => refused(error),
    }
}

#[inline(always)]
pub(crate) fn widened_isotropic<D: Distribution, R: Real>(pair: Pair<R>, p: [R; 5]) -> R {
    let [alpha, a, b, c, d] = p;
    widened::<D, R>(pair, Roughness::from_alpha(alpha), [a, b, c, d])
}

#[inline(always)]
pub(crate) fn widened_axis_aligned<D: Distribution, R: Real>(pair: Pair<R>, p: [R; 6]) -> R {
    let [x, y, a, b, c, d] = p;
    widened::<D, R>(pair, AxisAligned::new(x, y).map(Roughness::from), [a, b, c, d])
}

#[inline(always)]
pub(crate) fn widened_full<D: Distribution, R: Real>(pair: Pair<R>, p: [R; 7]) -> R {
    let [xx, xy, yy, a, b, c, d] = p;
    widened::<D, R>(pair, matrix([xx, xy, yy]), [a, b, c, d])
}

#[inline(always)]
pub(crate) fn widened_tilted_isotropic<D: Distribution, R: Real>(pair: Pair<R>, p: [R; 7]) -> R {
    let [alpha, m, n, a, b, c, d] = p;
    widened_tilted::<D, R>(pair, [m, n], Roughness::from_alpha(alpha), [a, b, c, d])
}

#[inline(always)]
pub(crate) fn widened_tilted_axis_aligned<D: Distribution, R: Real>(pair: Pair<R>, p: [R; 8]) -> R {
    let [x, y, m, n, a, b, c, d] = p;
    let roughness = AxisAligned::new(x, y).map(Roughness::from);
    widened_tilted::<D, R>(pair, [m, n], roughness, [a, b, c, d])
}

#[inline(always)]
pub(crate) fn widened_tilted_full<D: Distribution, R: Real>(pair: Pair<R>, p: [R; 9]) -> R {
    let [xx, xy, yy, m, n, a, b, c, d] = p;
    widened_tilted::<D, R>(pair, [m, n], matrix([xx, xy, yy]), [a, b, c, d])
}

#[inline(always)]
pub(crate) fn widened_on_disk<R: Real>(pair: Pair<R>, [xx, xy, yy, a, b, c, d]: [R; 7]) -> R {
    let kernel = DiskKernel::of([a, b], [c, d], PixelFilter::BOX);
    matrix([xx, xy, yy]).map_or_else(refused, |roughness| {
        shaded::<GgxDistribution, _>(pair, Anisotropic::new(roughness.widened_on_disk(&kernel)))
    })
}

#[inline(always)]
pub(crate) fn peak_fitted<R: Real>(pair: Pair<R>, [xx, xy, yy, a, b, c, d]: [R; 7]) -> R {
    matrix([xx, xy, yy]).map_or_else(refused, |roughness| {
        let fitted = roughness.peak_fitted(&kernel([a, b, c, d]));
        shaded::<GgxDistribution, _>(pair, Anisotropic::new(fitted))
    })
}

#[inline(always)]
pub(crate) fn parallelogram<R: Real>(_: Pair<R>, p: [R; 6], shape: &Anisotropic<R>) -> R {
    let [x, y, a, b, c, d] = p;
    Ggx::new(*shape).parallelogram_mean([x, y], &Footprint::from_slopes([a, b], [c, d]))
}

#[inline(always)]
pub(crate) fn brdf_over<R: Real>(pair: Pair<R>, [a, b, c, d]: [R; 4], shape: &Anisotropic<R>) -> R {
    Ggx::new(*shape).brdf_over(pair.wo, pair.wi, &Footprint::from_slopes([a, b], [c, d]))
}
