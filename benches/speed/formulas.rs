//! What the rows compute for one sample, each a small function of the sample's numbers.
//!
//! Directions come first, then parameters, of which shapes are built inside the loop by total
//! constructors, then a shape that was built before it. Every function is generic, so that what is
//! timed in f32 is counted, too.

use super::columns::Pair;
use lobe::filter::DiskKernel;
use lobe::ndf::GgxDistribution;
use lobe::{
    Anisotropic, AxisAligned, Distribution, Footprint, Ggx, Isotropic, Kernel, LobeShape, Ndf,
    NonCentered, PixelFilter, Real,
};

#[inline(always)]
fn shaded<D: Distribution, S: LobeShape>(pair: Pair<S::Scalar>, shape: S) -> S::Scalar {
    Ndf::<D, S>::new(shape).brdf(pair.wo, pair.wi)
}

/// The kernel of a footprint under the box pixel.
#[inline(always)]
fn kernel<R: Real>([a, b, c, d]: [R; 4]) -> Kernel<R> {
    Kernel::of(&Footprint::from_slopes([a, b], [c, d]), PixelFilter::BOX)
}

/// The rows of a shape that `$base` makes of its columns: as it is, with a mean, under a footprint,
/// and with both.
macro_rules! rows {
    ($base:expr, $count:literal: $plain:ident, $tilted:ident, $widened:ident, $both:ident) => {
        #[inline(always)]
        pub(crate) fn $plain<D: Distribution, R: Real>(pair: Pair<R>, p: [R; $count]) -> R {
            shaded::<D, _>(pair, $base(p))
        }

        #[inline(always)]
        pub(crate) fn $tilted<D: Distribution, R: Real>(pair: Pair<R>, p: [R; $count + 2]) -> R {
            let shape = $base(std::array::from_fn(|k| p[k]));
            shaded::<D, _>(pair, NonCentered::saturating(shape, [p[$count], p[$count + 1]]))
        }

        #[inline(always)]
        pub(crate) fn $widened<D: Distribution, R: Real>(pair: Pair<R>, p: [R; $count + 4]) -> R {
            let shape = $base(std::array::from_fn(|k| p[k]));
            let kernel = kernel(std::array::from_fn(|k| p[$count + k]));
            shaded::<D, _>(pair, kernel.widen(shape))
        }

        #[inline(always)]
        pub(crate) fn $both<D: Distribution, R: Real>(pair: Pair<R>, p: [R; $count + 6]) -> R {
            let shape = $base(std::array::from_fn(|k| p[k]));
            let shape = NonCentered::saturating(shape, [p[$count], p[$count + 1]]);
            let kernel = kernel(std::array::from_fn(|k| p[$count + 2 + k]));
            shaded::<D, _>(pair, kernel.widen(shape))
        }
    };
}

rows!(|[alpha]: [R; 1]| Isotropic::saturating(alpha), 1:
    isotropic, tilted_isotropic, widened_isotropic, widened_tilted_isotropic);
rows!(|[x, y]: [R; 2]| AxisAligned::saturating(x, y), 2:
    axis_aligned, tilted_axis_aligned, widened_axis_aligned, widened_tilted_axis_aligned);
rows!(|factor: [R; 3]| Anisotropic::saturating(factor), 3:
    full, tilted, widened_full, widened_tilted_full);

#[inline(always)]
pub(crate) fn widened_on_disk<R: Real>(pair: Pair<R>, [alpha, a, b, c, d]: [R; 5]) -> R {
    let kernel = DiskKernel::of([a, b], [c, d], PixelFilter::BOX);
    shaded::<GgxDistribution, _>(pair, kernel.widen(Isotropic::saturating(alpha)))
}

#[inline(always)]
pub(crate) fn peak_fitted<R: Real>(pair: Pair<R>, [alpha, a, b, c, d]: [R; 5]) -> R {
    let shape = Isotropic::saturating(alpha);
    shaded::<GgxDistribution, _>(pair, kernel([a, b, c, d]).widen_to_peak(shape))
}

#[inline(always)]
pub(crate) fn peak_fitted_full<R: Real>(pair: Pair<R>, p: [R; 7]) -> R {
    let [l_xx, l_yx, l_yy, a, b, c, d] = p;
    let shape = Anisotropic::saturating([l_xx, l_yx, l_yy]);
    shaded::<GgxDistribution, _>(pair, kernel([a, b, c, d]).widen_to_peak(shape))
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

/// The mean of any A over a parallelogram, without a branch.
#[inline(always)]
pub(crate) fn parallelogram_in_lanes<R: Real>(_: Pair<R>, p: [R; 9]) -> R {
    let [l_xx, l_yx, l_yy, x, y, a, b, c, d] = p;
    let ggx = Ggx::new(Anisotropic::saturating([l_xx, l_yx, l_yy]));
    ggx.parallelogram_mean_in_lanes([x, y], &Footprint::from_slopes([a, b], [c, d]))
}

/// The same in f64, for columns of f32.
#[inline(always)]
pub(crate) fn parallelogram_by_double(pair: Pair<f32>, p: [f32; 9]) -> f32 {
    let wide = Pair { wo: pair.wo.map(f64::from), wi: pair.wi.map(f64::from) };
    parallelogram_in_lanes(wide, p.map(f64::from)) as f32
}

#[inline(always)]
pub(crate) fn brdf_over_in_lanes<R: Real>(pair: Pair<R>, p: [R; 7]) -> R {
    let [l_xx, l_yx, l_yy, a, b, c, d] = p;
    let ggx = Ggx::new(Anisotropic::saturating([l_xx, l_yx, l_yy]));
    ggx.brdf_over_in_lanes(pair.wo, pair.wi, &Footprint::from_slopes([a, b], [c, d]))
}
