//! Calls the library from a crate without std; see Cargo.toml for what that proves.
#![no_std]
#![forbid(unsafe_code)]

use lobe::material::Fresnel;
use lobe::material::leadr::{Leadr, Normalization, Quadrature, Shadowing};
use lobe::shade::Material;
use lobe::{
    Beckmann, Error, Footprint, Ggx, Isotropic, Kernel, Lobe, PixelFilter, Roughness, filter,
};

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    loop {}
}

/// One path through every floor: constructors, filters, densities, masking, the facade.
fn shade(alpha: f32, angle: f32) -> Result<f32, Error> {
    let footprint = Footprint::from_slopes([0.1, 0.02], [-0.03, 0.05]);
    let kernel = Kernel::of(&footprint, PixelFilter::KAPLANYAN).capped(0.18);
    let lobe = Lobe::new([0.1, -0.2], Roughness::from_alphas(alpha, 0.5 * alpha, angle)?)?;
    let (wo, wi) = ([0.6, 0.0, 0.8], [-0.48, 0.36, 0.8]);
    let ggx = Ggx::new(lobe.shape());
    let widened = Beckmann::new(lobe.widened(&kernel).shape());
    let exact = ggx.parallelogram_mean([0.2, 0.1], &footprint)
        + filter::ggx_gaussian_mean(&lobe, [0.2, 0.1], &kernel)
        + filter::beckmann_rectangle_mean([alpha, alpha], [0.1, 0.0], footprint.extents());
    let gold = Material::ggx(lobe, Fresnel::schlick([1.0, 0.8, 0.3])?).bake(&kernel);
    let [red, ..] = gold.evaluate(wo, wi);
    let sky = |wi: [f32; 3], _: f32| [wi[2].max(0.0); 3];
    let grid = Quadrature::<f32, 5>::cells();
    let (all, sum) = (Shadowing::Both, Normalization::Sum);
    let [relief, ..] = Leadr::new(&lobe).environment(wo, &grid, all, sum, &Fresnel::white(), &sky);
    Ok(exact + red + relief + ggx.brdf(wo, wi) + widened.brdf(wo, wi) + widened.lambda_walter(wo))
}

/// The entry point; `extern "C"` and without generics, so that all of the above is compiled.
pub extern "C" fn probe(alpha: f32, angle: f32) -> f32 {
    let mirror =
        Isotropic::new(f64::from(alpha)).map_or(0.0, |shape| Ggx::new(shape).g1([0.0, 0.0, 1.0]));
    shade(alpha, angle).unwrap_or(f32::NAN) + mirror as f32
}
