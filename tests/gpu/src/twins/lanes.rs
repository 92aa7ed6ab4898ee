//! Twins of `src/filter/polygon/lanes.rs` and `height.rs`: means and BRDFs without a branch, of
//! every shape that has coordinates in units of the lobe.

use lobe::slope::Whiten;
use lobe::{Anisotropic, AxisAligned, Ggx, Isotropic, Real};

use super::value::Reader;

fn mean<S: Whiten>(shape: S, x: &mut Reader<'_>) -> S::Scalar {
    let slope = x.vec::<S::Scalar, 2>();
    Ggx::new(shape).parallelogram_mean_in_lanes(slope, &x.footprint())
}

fn brdf<S: Whiten>(shape: S, x: &mut Reader<'_>) -> S::Scalar {
    let (wo, wi) = (x.vec::<S::Scalar, 3>(), x.vec::<S::Scalar, 3>());
    Ggx::new(shape).brdf_over_in_lanes(wo, wi, &x.footprint())
}

fn isotropic<R: Real>(x: &mut Reader<'_>) -> Isotropic<R> {
    Isotropic::new(x.f()).expect("a drawn alpha is in range")
}

fn axis_aligned<R: Real>(x: &mut Reader<'_>) -> AxisAligned<R> {
    AxisAligned::new(x.f(), x.f()).expect("drawn alphas are in range")
}

super::twins! {
    "ggx_parallelogram_mean_in_lanes" by "isotropic" (Alpha, Slope, Footprint)
        "lobe_ggx_parallelogram_mean_in_lanes(
            lobe_isotropic_slope_over(lobe_isotropic_new($0), $1, $2))" => |x| {
        let shape = isotropic::<R>(x);
        mean(shape, x)
    };
    "ggx_parallelogram_mean_in_lanes" by "axis_aligned" (Alphas, Slope, Footprint)
        "lobe_ggx_parallelogram_mean_in_lanes(
            lobe_axis_aligned_slope_over(lobe_axis_aligned_new($0.x, $0.y), $1, $2))" => |x| {
        let shape = axis_aligned::<R>(x);
        mean(shape, x)
    };
    "ggx_parallelogram_mean_in_lanes" by "anisotropic" (Roughness, Slope, Footprint)
        "lobe_ggx_parallelogram_mean_in_lanes(
            lobe_anisotropic_slope_over(lobe_anisotropic_new($0), $1, $2))" => |x| {
        let shape = Anisotropic::new(x.roughness::<R>());
        mean(shape, x)
    };
    "ggx_parallelogram_mean_in_lanes" by "non_centered" (Lobe, Slope, Footprint)
        "lobe_ggx_parallelogram_mean_in_lanes(
            lobe_non_centered_slope_over(lobe_lobe_shape($0), $1, $2))" => |x| {
        let shape = x.lobe::<R>().shape();
        mean(shape, x)
    };
    "ggx_brdf_over_in_lanes" by "isotropic" (Alpha, Pair, Footprint)
        "lobe_ggx_brdf_over_in_lanes(
            lobe_isotropic_pair_over(lobe_isotropic_new($0), $1, $2))" => |x| {
        let shape = isotropic::<R>(x);
        brdf(shape, x)
    };
    "ggx_brdf_over_in_lanes" by "axis_aligned" (Alphas, Pair, Footprint)
        "lobe_ggx_brdf_over_in_lanes(
            lobe_axis_aligned_pair_over(lobe_axis_aligned_new($0.x, $0.y), $1, $2))" => |x| {
        let shape = axis_aligned::<R>(x);
        brdf(shape, x)
    };
    "ggx_brdf_over_in_lanes" by "anisotropic" (Roughness, Pair, Footprint)
        "lobe_ggx_brdf_over_in_lanes(
            lobe_anisotropic_pair_over(lobe_anisotropic_new($0), $1, $2))" => |x| {
        let shape = Anisotropic::new(x.roughness::<R>());
        brdf(shape, x)
    };
    "ggx_brdf_over_in_lanes" by "non_centered" (Lobe, Pair, Footprint)
        "lobe_ggx_brdf_over_in_lanes(
            lobe_non_centered_pair_over(lobe_lobe_shape($0), $1, $2))" => |x| {
        let shape = x.lobe::<R>().shape();
        brdf(shape, x)
    };
}
