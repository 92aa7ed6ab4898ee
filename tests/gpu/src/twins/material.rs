//! Twins of `src/slope/algebra.rs`, `src/filter/length.rs` and `src/material/{lean,leadr}`.

use lobe::filter::{
    VmfWidening, clean_variance, toksvig_exponent, toksvig_variance, vmf_sharpness,
};
use lobe::material::leadr::{Shadowing, cube_lod};
use lobe::{Footprint, SlopeMoments};

use super::slope::moments;

super::twins! {
    "slope_moments_add" (Mean, Psd, Mean, Psd)
        "lobe_slope_moments_add(lobe_slope_moments_new($0, $1), lobe_slope_moments_new($2, \
            $3))" => |x| {
        let one = moments::<R>(x);
        one + moments(x)
    };
    "slope_moments_plus_correlated" (Mean, Psd, Mean, Psd, Matrix)
        "lobe_slope_moments_plus_correlated(lobe_slope_moments_new($0, $1), \
            lobe_slope_moments_new($2, $3), $4)" => |x| {
        let (one, other) = (moments::<R>(x), moments(x));
        one.plus_correlated(&other, x.matrix())
    };
    "slope_moments_cross_covariance" (Mean, Psd, Mean, Psd, Matrix)
        "lobe_slope_moments_cross_covariance(lobe_slope_moments_new($0, $1), \
            lobe_slope_moments_new($2, $3), $4)" => |x| {
        let (one, other) = (moments::<R>(x), moments(x));
        one.cross_covariance(&other, x.matrix())
    };
    "slope_moments_mul" (Mean, Psd, Size)
        "lobe_slope_moments_mul(lobe_slope_moments_new($0, $1), $2)" => |x| {
        let moments = moments::<R>(x);
        moments * x.f()
    };
    "slope_moments_tilted" (Mean, Psd, Slope)
        "lobe_slope_moments_tilted(lobe_slope_moments_new($0, $1), $2)" => |x| {
        let moments = moments::<R>(x);
        moments.tilted(x.vec::<R, 2>()).expect("in range")
    };
    "slope_moments_transformed" (Mean, Psd, Matrix)
        "lobe_slope_moments_transformed(lobe_slope_moments_new($0, $1), $2)" => |x| {
        let moments = moments::<R>(x);
        moments.transformed(x.matrix())
    };
    "footprint_sub" (Footprint, Slope, Slope) "lobe_footprint_sub($0, $1, $2)" => |x| {
        let footprint = x.footprint::<R>();
        footprint - Footprint::from_slopes(x.vec::<R, 2>(), x.vec::<R, 2>())
    };
    "toksvig_variance" (MeanLength) "lobe_toksvig_variance($0)" => |x| {
        toksvig_variance(x.f::<R>()).expect("in range")
    };
    "toksvig_exponent" (Size, MeanLength) "lobe_toksvig_exponent($0, $1)" => |x| {
        toksvig_exponent(x.f::<R>(), x.f()).expect("in range")
    };
    "clean_variance" (Mean, Size) "lobe_clean_variance($0, $1)" => |x| {
        clean_variance(x.vec::<R, 2>(), x.f()).expect("in range")
    };
    "vmf_sharpness" (MeanLength) "lobe_vmf_sharpness($0)" => |x| {
        vmf_sharpness(x.f::<R>()).expect("in range")
    };
    "vmf_widening_alpha" by "THE_ORDER" (Alpha, MeanLength)
        "lobe_vmf_widening_alpha($0, $1, LOBE_VMF_WIDENING_THE_ORDER)" => |x| {
        VmfWidening::THE_ORDER.alpha(x.f::<R>(), x.f()).expect("in range")
    };
    "vmf_widening_alpha" by "SPECULAR_AA" (Alpha, MeanLength)
        "lobe_vmf_widening_alpha($0, $1, LOBE_VMF_WIDENING_SPECULAR_AA)" => |x| {
        VmfWidening::SPECULAR_AA.alpha(x.f::<R>(), x.f()).expect("in range")
    };
    "slope_moments_from_unorm" (Unorm) "lobe_slope_moments_from_unorm($0)" => |x| {
        SlopeMoments::from_unorm(x.vec::<R, 2>(), x.vec(), x.f()).expect("in range")
    };
    "leadr_new" (Lobe, Direction) "lobe_leadr_artificial_facet(lobe_leadr_new($0), $1)" => |x| {
        let surface = x.leadr::<R>();
        surface.artificial_facet(x.vec::<R, 3>())
    };
    "leadr_brdf_cos" (Lobe, Pair) "lobe_leadr_brdf_cos(lobe_leadr_new($0), $1)" => |x| {
        let surface = x.leadr::<R>();
        surface.brdf_cos(x.vec::<R, 3>(), x.vec::<R, 3>(), Shadowing::Both)
    };
    "leadr_unshadowed_brdf_cos" (Lobe, Pair) "lobe_leadr_unshadowed_brdf_cos(lobe_leadr_new($0), \
        $1)" => |x| {
        let surface = x.leadr::<R>();
        surface.brdf_cos(x.vec::<R, 3>(), x.vec::<R, 3>(), Shadowing::MaskingOnly)
    };
    "leadr_light_reaching" (Lobe, Pair) "lobe_leadr_light_reaching(lobe_leadr_new($0), $1)" => |x| {
        let surface = x.leadr::<R>();
        surface.light_reaching(x.vec::<R, 3>(), x.vec::<R, 3>())
    };
    "leadr_facet" (Lobe, Direction, Node) "lobe_leadr_facet(lobe_leadr_new($0), $1, $2)" => |x| {
        let (surface, wo) = (x.leadr::<R>(), x.vec::<R, 3>());
        surface.facet(wo, x.node())
    };
    "leadr_artificial_facet" (Lobe, Direction) "lobe_leadr_artificial_facet(lobe_leadr_new($0), \
        -$1)" => |x| {
        let surface = x.leadr::<R>();
        let wo = x.vec::<R, 3>().map(|w| -w);
        surface.artificial_facet(wo)
    };
    "cube_lod" (Unit, Size) "lobe_cube_lod($0, $1)" => |x| cube_lod(x.f::<R>(), x.f());
}
