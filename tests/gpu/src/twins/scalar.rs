//! Twins of `src/scalar`.

use lobe::{Eigen, Psd, Real, Roughness};

fn truth<R: Real>(holds: bool) -> R {
    if holds { R::ONE } else { R::ZERO }
}

/// Two kernels or footprints in ten have parallel sides, up to the rounding of their components:
/// whether the cross product is 0 then is its own rounding's choice.
pub(super) const PARALLEL: f64 = 0.2;

super::twins! {
    "min" (Any, Any) "lobe_min($0, $1)" => |x| { let (a, b) = (x.f::<R>(), x.f()); a.min(b) };
    "max" (Any, Any) "lobe_max($0, $1)" => |x| { let (a, b) = (x.f::<R>(), x.f()); a.max(b) };
    "is_finite" (Any) "select(0.0, 1.0, lobe_is_finite($0))" => |x| {
        truth::<R>(x.f::<R>().is_finite())
    };
    "exp" (Exponent) "lobe_exp($0)" => |x| x.f::<R>().exp();
    "ln" (Positive) "lobe_ln($0)" => |x| x.f::<R>().ln();
    "atan" (Any) "lobe_atan($0)" => |x| x.f::<R>().atan();
    "atan_of" (Any, Any) "lobe_atan_of($0, $1)" => |x| {
        let (y, x) = (x.f::<R>(), x.f());
        y.atan2(x)
    };
    "erfcx" (Size) "lobe_erfcx($0)" => |x| x.f::<R>().erfcx();
    "ierfcx" (Size) "lobe_ierfcx($0)" => |x| x.f::<R>().ierfcx();
    "ierfc_excess" (Size) "lobe_ierfc_excess($0)" => |x| x.f::<R>().ierfc_excess();
    "erfc" (Deviation) "lobe_erfc($0)" => |x| x.f::<R>().erfc();
    "psd_new" (Psd) "$0" => |x| x.psd::<R>();
    "psd_nearest" (Vector, Size) "lobe_psd_nearest($0.x, $0.y, $1)" => |x| {
        let [xx, xy] = x.vec::<R, 2>();
        Psd::nearest(xx, xy, x.f())
    };
    "psd_from_axes" (Alpha) "lobe_psd_from_axes($0, $0, 1.0, 0.0)" => |x| {
        Roughness::from_alpha(x.f::<R>()).expect("in range").matrix()
    };
    "psd_outer_sum" (Footprint) "lobe_psd_outer_sum($0.u, $0.v)" => |x| {
        Psd::outer_sum(x.vec::<R, 2>(), x.vec())
    };
    "psd_det" (Psd) "lobe_psd_det($0)" => |x| x.psd::<R>().det();
    "psd_trace" (Psd) "lobe_psd_trace($0)" => |x| x.psd::<R>().trace();
    "psd_entries" (Psd) "lobe_psd_entries($0)" => |x| x.psd::<R>().entries();
    "psd_root_det" (Psd) "lobe_psd_root_det($0)" => |x| x.psd::<R>().root_det();
    "psd_is_singular" flips PARALLEL (Kernel)
        "select(0.0, 1.0, lobe_psd_is_singular(lobe_kernel_covariance($0)))" => |x| {
        truth::<R>(x.kernel::<R>().covariance().is_singular())
    };
    "psd_mul" (Psd, Any) "lobe_psd_mul($0, $1)" => |x| { let m = x.psd::<R>(); m * x.f() };
    "psd_add" (Psd, Kernel) "lobe_psd_add($0, lobe_kernel_covariance($1))" => |x| {
        let m = x.psd::<R>();
        m + x.kernel().covariance()
    };
    "psd_quadratic" (Psd, Slope) "lobe_psd_quadratic($0, \
        $1)" => |x| { let m = x.psd::<R>(); m.quadratic(x.vec()) };
    "psd_eigen" (Psd) "lobe_psd_eigen($0)" => |x| x.psd::<R>().eigen();
    // Put together again: a matrix that is nearly round has no axis, and the last bit chooses one.
    "psd_eigen" by "kernel" (Kernel)
        "put_together(lobe_psd_eigen(lobe_kernel_covariance($0)))" => |x| {
        let Eigen { major, minor, axis: [cos, sin] } = x.kernel::<R>().covariance().eigen();
        [
            major * cos * cos + minor * sin * sin,
            (major - minor) * cos * sin,
            major * sin * sin + minor * cos * cos,
        ]
    };
    "psd_capped" (Psd, Limit) "lobe_psd_capped($0, $1)" => |x| {
        let m = x.psd::<R>();
        m.capped(x.f())
    };
}
