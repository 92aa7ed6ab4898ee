//! Twins of `src/filter`, `src/material` and `src/shade.rs`.

use lobe::filter::{
    DiskKernel, SphericalGaussian, beckmann_rectangle_mean, box_peak_alpha, engine::Engine,
    gaussian_peak_alpha, ggx_gaussian_mean, kaplanyan_deferred_alpha, kaplanyan_deferred_alphas,
    kaplanyan_proxy_alpha, kaplanyan_rectangle_mean, kaplanyan_rectangle_mean_as_printed,
    largest_deferred_alpha, projected_alpha, quad_normal_footprint, tokuyoshi_deferred_alpha,
    tokuyoshi_kaplanyan_deferred_alpha,
};
use lobe::material::Fresnel;
use lobe::shade::Material;
use lobe::slope::direction::half_vector;
use lobe::{Ggx, Isotropic, Kernel, LobeShape, Real};

use super::scalar::PARALLEL;
use super::value::Reader;

/// An axis at the frame's, within a rounding, is exactly there or not, and what lies across it is 0
/// or a rounding: one lobe in four is along the axes, and one in eight of those has an alpha of 1,
/// of which rounding decides whether it stays.
const AXES: f64 = 1.0 / 32.0;

impl Reader<'_> {
    /// One of the engines, by its place as a whole number.
    fn engine(&mut self) -> Engine {
        let place = self.raw();
        let (_, engine) = (0_u8..)
            .zip(Engine::ALL.iter().copied())
            .find(|(k, _)| f32::from(*k) == place)
            .expect("a drawn place");
        engine
    }
}

fn light<R: Real>(x: &mut Reader<'_>) -> SphericalGaussian<R> {
    SphericalGaussian::new(x.vec::<R, 3>(), x.f()).expect("a drawn light is in range")
}

super::twins! {
    // Columns hold what footprints hold; matrices made of them are numbers.
    "kernel_of" (Footprint, Variance) "lobe_kernel_covariance(lobe_kernel_of($0, $1))" => |x| {
        let footprint = x.footprint::<R>();
        Kernel::of(&footprint, x.filter()).covariance()
    };
    "kernel_tokuyoshi_forward" (Footprint)
        "lobe_kernel_covariance(lobe_kernel_tokuyoshi_forward($0.u, $0.v))" => |x| {
        Kernel::tokuyoshi_forward(x.vec::<R, 2>(), x.vec()).covariance()
    };
    "kernel_covariance" (Kernel) "lobe_kernel_covariance($0)" => |x| {
        x.kernel::<R>().covariance()
    };
    "kernel_widen" (Kernel, Alpha, Direction)
        "lobe_widened_form(lobe_kernel_widen($0, lobe_isotropic_new($1)), $2.xy)" => |x| {
        let kernel = x.kernel::<R>();
        let shape = kernel.widen(Isotropic::saturating(x.f()));
        shape.form(x.vec())
    };
    "kernel_widen_to_peak" (Kernel, Alpha)
        "lobe_widened_extent(lobe_kernel_widen_to_peak($0, lobe_isotropic_new($1)))" => |x| {
        let kernel = x.kernel::<R>();
        kernel.widen_to_peak(Isotropic::saturating(x.f())).extent()
    };
    "disk_kernel_widen" (Kernel, Alpha)
        "lobe_widened_extent(lobe_disk_kernel_widen(
            lobe_disk_kernel_from_covariance(lobe_kernel_covariance($0)), lobe_isotropic_new($1)
        ))" => |x| {
        let kernel = DiskKernel::from_covariance(x.kernel::<R>().covariance());
        kernel.widen(Isotropic::saturating(x.f())).extent()
    };
    "kernel_from_covariance" (Psd) "lobe_kernel_from_covariance($0)" => |x| {
        Kernel::from_covariance(x.psd::<R>())
    };
    "kernel_add" (Kernel, Kernel) "lobe_kernel_covariance(lobe_kernel_add($0, $1))" => |x| {
        let kernel = x.kernel::<R>();
        (kernel + x.kernel()).covariance()
    };
    // As a kernel again: one that is nearly round has no axes, and the last bit chooses them.
    "kernel_footprint" (Kernel, Variance)
        "lobe_kernel_covariance(lobe_kernel_of(lobe_kernel_footprint($0, $1), $1))" => |x| {
        let (kernel, filter) = (x.kernel::<R>(), x.filter());
        Kernel::of(&kernel.footprint(filter), filter).covariance()
    };
    "kernel_capped" (Kernel, Limit) "lobe_kernel_covariance(lobe_kernel_capped($0, $1))" => |x| {
        let kernel = x.kernel::<R>();
        kernel.capped(x.f()).covariance()
    };
    "roughness_widened" (Roughness, Kernel) "lobe_roughness_widened($0, $1)" => |x| {
        let roughness = x.roughness::<R>();
        roughness.widened(&x.kernel())
    };
    "lobe_widened" (Lobe, Kernel) "lobe_lobe_widened($0, $1)" => |x| {
        let lobe = x.lobe::<R>();
        lobe.widened(&x.kernel())
    };
    "ggx_gaussian_mean" (Lobe, Slope, Kernel) "lobe_ggx_gaussian_mean($0, $1, $2)" => |x| {
        let (lobe, slope) = (x.lobe::<R>(), x.vec::<R, 2>());
        ggx_gaussian_mean(&lobe, slope, &x.kernel())
    };
    "box_peak_alpha" (Alpha, Size) "lobe_box_peak_alpha($0, $1)" => |x| {
        box_peak_alpha(x.f::<R>(), x.f()).expect("in range")
    };
    "gaussian_peak_alpha" (Alpha, Size) "lobe_gaussian_peak_alpha($0, $1)" => |x| {
        gaussian_peak_alpha(x.f::<R>(), x.f()).expect("in range")
    };
    "roughness_peak_matched" (Roughness, Kernel) "lobe_roughness_peak_matched($0, $1)" => |x| {
        let roughness = x.roughness::<R>();
        roughness.peak_matched(&x.kernel())
    };
    "roughness_peak_fitted" (Roughness, Kernel) "lobe_roughness_peak_fitted($0, $1)" => |x| {
        let roughness = x.roughness::<R>();
        roughness.peak_fitted(&x.kernel())
    };
    "roughness_peak_matched_over" flips PARALLEL (Groove, Footprint)
        "lobe_roughness_peak_matched_over(($0).roughness, $1)" => |x| {
        let roughness = x.lobe::<R>().roughness();
        roughness.peak_matched_over(&x.footprint())
    };
    "roughness_peak_matched_over" flips PARALLEL (Roughness, Footprint)
        "lobe_roughness_peak_matched_over($0, $1)" => |x| {
        let roughness = x.roughness::<R>();
        roughness.peak_matched_over(&x.footprint())
    };
    "disk_kernel_of" (Footprint, Variance)
        "lobe_kernel_covariance(lobe_disk_kernel_of($0.u, $0.v, $1).as_slopes)" => |x| {
        let (u, v) = (x.vec::<R, 2>(), x.vec::<R, 2>());
        DiskKernel::of(u, v, x.filter()).covariance()
    };
    "disk_kernel_of_bounding" (Footprint, Variance)
        "lobe_kernel_covariance(lobe_disk_kernel_of_bounding($0.u, $0.v, $1).as_slopes)" => |x| {
        let (u, v) = (x.vec::<R, 2>(), x.vec::<R, 2>());
        DiskKernel::of_bounding(u, v, x.filter()).covariance()
    };
    "disk_kernel_from_covariance" (Psd) "lobe_disk_kernel_from_covariance($0)" => |x| {
        DiskKernel::from_covariance(x.psd::<R>())
    };
    "disk_kernel_add" (Kernel, Kernel)
        "lobe_disk_kernel_add(lobe_disk_kernel_from_covariance(lobe_kernel_covariance($0)),
            lobe_disk_kernel_from_covariance(lobe_kernel_covariance($1)))" => |x| {
        let kernel = x.disk::<R>();
        kernel + x.disk()
    };
    "disk_kernel_capped" (Kernel, Limit)
        "lobe_disk_kernel_capped(lobe_disk_kernel_from_covariance(lobe_kernel_covariance($0)), \
            $1)" => |x| {
        let kernel = x.disk::<R>();
        kernel.capped(x.f())
    };
    "roughness_widened_on_disk" flips AXES (Roughness, Kernel)
        "lobe_roughness_widened_on_disk($0, \
            lobe_disk_kernel_from_covariance(lobe_kernel_covariance($1)))" => |x| {
        let roughness = x.roughness::<R>();
        roughness.widened_on_disk(&x.disk())
    };
    "projected_alpha" (Alpha, Size) "lobe_projected_alpha($0, $1)" => |x| {
        projected_alpha(x.f::<R>(), x.f()).expect("in range")
    };
    "spherical_gaussian_new" (Position, Sharpness)
        "lobe_spherical_gaussian_new($0, $1).direction * lobe_spherical_gaussian_new($0, \
            $1).sharpness" => |x| {
        let light = light::<R>(x);
        light.direction().map(|x| x * light.sharpness())
    };
    "spherical_gaussian_from_angular_radius" (Position, Size)
        "lobe_spherical_gaussian_from_angular_radius($0, $1 + 1e-6).sharpness" => |x| {
        let (direction, radius) = (x.vec::<R, 3>(), x.f::<R>() + R::lit(1e-6));
        SphericalGaussian::from_angular_radius(direction, radius).expect("in range").sharpness()
    };
    "spherical_gaussian_integral" (Direction, Sharpness)
        "lobe_spherical_gaussian_integral(lobe_spherical_gaussian_new($0, \
            $1))" => |x| light::<R>(x).integral();
    "spherical_gaussian_kernel" (Direction, Sharpness, Direction)
        "lobe_kernel_covariance(
            lobe_spherical_gaussian_kernel(lobe_spherical_gaussian_new($0, $1), $2)
        )" => |x| {
        let light = light::<R>(x);
        light.kernel(x.vec::<R, 3>()).covariance()
    };
    "spherical_gaussian_disk_kernel" (Direction, Sharpness, Direction)
        "lobe_kernel_covariance(
            lobe_spherical_gaussian_disk_kernel(lobe_spherical_gaussian_new($0, $1), $2).as_slopes
        )" => |x| {
        let light = light::<R>(x);
        light.disk_kernel(x.vec::<R, 3>()).covariance()
    };
    "spherical_gaussian_footprint" (Direction, Sharpness, Direction)
        "lobe_spherical_gaussian_footprint(lobe_spherical_gaussian_new($0, $1), $2)" => |x| {
        let light = light::<R>(x);
        light.footprint(x.vec::<R, 3>())
    };
    "ggx_parallelogram_mean" (Lobe, Slope, Footprint)
        "lobe_ggx_parallelogram_mean(lobe_lobe_shape($0), $1, $2)" => |x| {
        let (ggx, slope) = (Ggx::new(x.lobe::<R>().shape()), x.vec::<R, 2>());
        ggx.parallelogram_mean(slope, &x.footprint())
    };
    "ggx_parallelogram_mean" (Groove, Covering) "lobe_ggx_parallelogram_mean(lobe_lobe_shape($0), \
        $1)" => |x| {
        let (ggx, slope) = (Ggx::new(x.lobe::<R>().shape()), x.vec::<R, 2>());
        ggx.parallelogram_mean(slope, &x.footprint())
    };
    "ggx_rectangle_mean" (Lobe, Slope, Widths) "lobe_ggx_rectangle_mean(lobe_lobe_shape($0), $1, \
        $2)" => |x| {
        let (ggx, slope) = (Ggx::new(x.lobe::<R>().shape()), x.vec::<R, 2>());
        ggx.rectangle_mean(slope, x.vec())
    };
    "ggx_brdf_over" (Lobe, Pair, Footprint) "lobe_ggx_brdf_over(lobe_lobe_shape($0), $1, \
        $2)" => |x| {
        let ggx = Ggx::new(x.lobe::<R>().shape());
        let (wo, wi) = (x.vec::<R, 3>(), x.vec::<R, 3>());
        ggx.brdf_over(wo, wi, &x.footprint())
    };
    "ggx_brdf_over" (Groove, Mirroring) "lobe_ggx_brdf_over(lobe_lobe_shape($0), $1)" => |x| {
        let ggx = Ggx::new(x.lobe::<R>().shape());
        let (wo, wi) = (x.vec::<R, 3>(), x.vec::<R, 3>());
        ggx.brdf_over(wo, wi, &x.footprint())
    };
    "beckmann_rectangle_mean" (Size, Size, Slope, Widths)
        "lobe_beckmann_rectangle_mean(vec2f($0, $1), $2, $3)" => |x| {
        beckmann_rectangle_mean(x.vec::<R, 2>(), x.vec::<R, 2>(), x.vec::<R, 2>())
    };
    "beckmann_rectangle_mean" (Alphas, Slope, Widths) "lobe_beckmann_rectangle_mean($0, $1, \
        $2)" => |x| {
        beckmann_rectangle_mean(x.vec::<R, 2>(), x.vec::<R, 2>(), x.vec::<R, 2>())
    };
    "tokuyoshi_deferred_alpha" (Alpha, Derivative, Derivative, Variance, Limit)
        "lobe_tokuyoshi_deferred_alpha($0, $1, $2, $3, $4)" => |x| {
        let (alpha, u, v) = (x.f::<R>(), x.vec::<R, 3>(), x.vec::<R, 3>());
        let filter = x.filter();
        tokuyoshi_deferred_alpha(alpha, u, v, filter, x.f()).expect("in range")
    };
    "tokuyoshi_kaplanyan_deferred_alpha" (Alpha, Derivative, Derivative, Variance, Limit)
        "lobe_tokuyoshi_kaplanyan_deferred_alpha($0, $1, $2, $3, $4)" => |x| {
        let (alpha, u, v) = (x.f::<R>(), x.vec::<R, 3>(), x.vec::<R, 3>());
        let filter = x.filter();
        tokuyoshi_kaplanyan_deferred_alpha(alpha, u, v, filter, x.f()).expect("in range")
    };
    "largest_deferred_alpha" (Alpha, Derivative, Derivative, Variance, Limit)
        "lobe_largest_deferred_alpha($0, $1, $2, $3, $4)" => |x| {
        let (alpha, u, v) = (x.f::<R>(), x.vec::<R, 3>(), x.vec::<R, 3>());
        let filter = x.filter();
        largest_deferred_alpha(alpha, u, v, filter, x.f()).expect("in range")
    };
    "kaplanyan_deferred_alphas" (Alphas, Footprint, Variance, Limit)
        "lobe_kaplanyan_deferred_alphas($0, $1, $2, $3)" => |x| {
        let (alphas, footprint, filter) = (x.vec::<R, 2>(), x.footprint::<R>(), x.filter());
        kaplanyan_deferred_alphas(alphas, &footprint, filter, x.f()).expect("in range")
    };
    "kaplanyan_deferred_alpha" (Alpha, Footprint, Variance, Limit)
        "lobe_kaplanyan_deferred_alpha($0, $1, $2, $3)" => |x| {
        let (alpha, footprint, filter) = (x.f::<R>(), x.footprint::<R>(), x.filter());
        kaplanyan_deferred_alpha(alpha, &footprint, filter, x.f()).expect("in range")
    };
    "quad_normal_footprint" (Frames) "lobe_quad_normal_footprint($0)" => |x| {
        let quad = [0; 4].map(|_| [0; 3].map(|_| x.vec::<R, 3>()));
        quad_normal_footprint(&quad).unwrap_or_default()
    };
    "engine_alpha" (Engine, Alpha, Derivative, Derivative) "lobe_engine_alpha($0, $1, $2, \
        $3)" => |x| {
        let engine = x.engine();
        engine.alpha(x.f::<R>(), x.vec::<R, 3>(), x.vec::<R, 3>()).expect("in range")
    };
    "kaplanyan_rectangle_mean" (Alphas, Slope, Widths) "lobe_kaplanyan_rectangle_mean($0, $1, \
        $2)" => |x| {
        kaplanyan_rectangle_mean(x.vec::<R, 2>(), x.vec::<R, 2>(), x.vec::<R, 2>())
    };
    "kaplanyan_rectangle_mean_as_printed" (Alphas, Slope, Widths)
        "lobe_kaplanyan_rectangle_mean_as_printed($0, $1, $2)" => |x| {
        kaplanyan_rectangle_mean_as_printed(x.vec::<R, 2>(), x.vec::<R, 2>(), x.vec::<R, 2>())
    };
    "kaplanyan_proxy_alpha" (Alpha, Size) "lobe_kaplanyan_proxy_alpha($0, $1)" => |x| {
        kaplanyan_proxy_alpha(x.f::<R>(), x.f()).expect("in range")
    };
    "fresnel_schlick" (Reflectance, Cosine) "lobe_fresnel_schlick($0, $1)" => |x| {
        let fresnel = Fresnel::schlick(x.vec::<R, 3>()).expect("in range");
        fresnel.reflectance(x.f())
    };
    "fresnel_conductor" (Index, Extinction, Cosine) "lobe_fresnel_conductor($0, $1, $2)" => |x| {
        let fresnel = Fresnel::conductor(x.vec::<R, 3>(), x.vec()).expect("in range");
        fresnel.reflectance(x.f())
    };
    "material_bake" (Lobe, Kernel, Direction) "lobe_non_centered_form(lobe_material_bake($0, $1), \
        $2)" => |x| {
        let material = Material::ggx(x.lobe::<R>(), Fresnel::white());
        let shading = material.bake(&x.kernel());
        let m = x.vec();
        shading.ndf().shape().form(m)
    };
    "half_cosine" (Pair) "lobe_half_cosine($0)" => |x| {
        let (wo, wi) = (x.vec::<R, 3>(), x.vec::<R, 3>());
        let h = half_vector(wo, wi);
        wo[0] * h[0] + wo[1] * h[1] + wo[2] * h[2]
    };
    "ggx_evaluate" by "bake" flips PARALLEL (Lobe, Kernel, Pair, Reflectance)
        "lobe_ggx_evaluate(lobe_non_centered_pair(lobe_material_bake($0, $1), $2), \
            lobe_fresnel_schlick($3, lobe_half_cosine($2)))" => |x| {
        let (lobe, kernel) = (x.lobe::<R>(), x.kernel());
        let (wo, wi) = (x.vec::<R, 3>(), x.vec::<R, 3>());
        let fresnel = Fresnel::schlick(x.vec()).expect("in range");
        Material::ggx(lobe, fresnel).bake(&kernel).evaluate(wo, wi)
    };
    "beckmann_evaluate" by "bake" (Lobe, Kernel, Pair, Reflectance)
        "lobe_beckmann_evaluate(lobe_non_centered_pair(lobe_material_bake($0, $1), $2), \
            lobe_fresnel_schlick($3, lobe_half_cosine($2)))" => |x| {
        let (lobe, kernel) = (x.lobe::<R>(), x.kernel());
        let (wo, wi) = (x.vec::<R, 3>(), x.vec::<R, 3>());
        let fresnel = Fresnel::schlick(x.vec()).expect("in range");
        Material::beckmann(lobe, fresnel).bake(&kernel).evaluate(wo, wi)
    };
    "ggx_evaluate_over" (Lobe, Pair, Footprint, Reflectance)
        "lobe_ggx_evaluate_over(lobe_lobe_shape($0), $1, $2, lobe_fresnel_schlick($3, \
            lobe_half_cosine($1)))" => |x| {
        let lobe = x.lobe::<R>();
        let (wo, wi, footprint) = (x.vec::<R, 3>(), x.vec::<R, 3>(), x.footprint());
        let fresnel = Fresnel::schlick(x.vec()).expect("in range");
        Material::ggx(lobe, fresnel).unfiltered().evaluate_over(wo, wi, &footprint)
    };
}
