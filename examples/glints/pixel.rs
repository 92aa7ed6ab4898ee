//! One pixel: a place of the surface, shaded once.

use super::camera::Camera;
use super::energy::Energy;
use super::material::{Incident, Pixel};
use super::options::Method;
use super::scene::{Light, Scene};
use super::surface::Spot;
use glam::{DVec3, Vec3};
use lobe::material::cells::Patch;
use lobe::slope::direction::reflect;
use lobe::{Footprint, Kernel, PixelFilter};

/// Derivatives of half vectors are taken over this part of a pixel: where a ball turns away, a
/// whole one would leave it.
const PART: f64 = 1.0 / 16.0;

/// Radiance of a pixel that shows the surface at these texture coordinates, and what of it is of
/// details.
pub(crate) fn shade(
    scene: &Scene,
    camera: &Camera,
    uv: [f64; 2],
    method: Method,
) -> (Vec3, Energy) {
    let spot = scene.surface.spot(uv);
    let frame = scene.surface.frame(&spot);
    let steps = camera.steps(spot.point, spot.normal()).map(|step| spot.change(step));
    let wo = frame.local((camera.eye - spot.point).normalize());
    let single = |v: [f64; 2]| v.map(|x| x as f32);
    let pixel = Pixel {
        patch: Patch::new(single(uv), single(steps[0]), single(steps[1])),
        bumps: scene.surface.bumps(uv, steps, wo),
        wo: wo.as_vec3(),
    };
    // A smooth environment is in all details at once: for it the smooth lobe will do.
    let mut color = ambient(scene, &pixel, |v| frame.x * v.x + frame.y * v.y + frame.z * v.z);
    let mut energy = Energy::default();
    let nearby = steps.map(|step| {
        let moved = [uv[0] + PART * step[0], uv[1] + PART * step[1]];
        scene.surface.spot(moved)
    });
    for light in &scene.lights {
        let incident = Incident {
            wi: frame.local(light.direction).as_vec3(),
            irradiance: light.irradiance(),
            radius: light.radius,
            kernel: kernel(scene, camera, light, [spot, nearby[0], nearby[1]]),
        };
        let (radiance, part) = scene.material.reflect(&pixel, &incident, method);
        color += radiance;
        energy = energy.and(&part);
    }
    // The smooth lobe asks none, and of the published model nobody counts them.
    let cells = if method == Method::Glints { scene.material.cells(&pixel.patch) } else { 0 };
    let counted = Energy { pixels: 1.0, shaded: 1, cells: u64::from(cells), most: cells, ..energy };
    (color, counted)
}

/// How far the half vector's slope moves over the pixel, each neighbor's in its own shading frame.
///
/// A pixel sees details through all half vectors between its edges. On a curved surface seen from
/// afar they differ by more than a detail's lobe is wide: without this, a pixel would show the one
/// bin of half vectors at its center, too bright or black, and flicker as it moves.
fn kernel(scene: &Scene, camera: &Camera, light: &Light, spots: [Spot; 3]) -> Kernel<f32> {
    let [here, right, up] = spots.map(|spot| {
        let frame = scene.surface.frame(&spot);
        frame.local((camera.eye - spot.point).normalize() + light.direction.normalize())
    });
    // Below the surface there is no slope, and nothing to be lit.
    let Ok(footprint) = Footprint::from_half_vectors(here, right, up) else {
        return Kernel::default();
    };
    let footprint = (footprint * (1.0 / PART)).capped(Footprint::<f64>::WIDTH_LIMIT);
    let [u, v] = [footprint.u, footprint.v].map(|side| side.map(|x| x as f32));
    Kernel::of(&Footprint::from_slopes(u, v), PixelFilter::BOX)
}

/// What the surface scatters and mirrors of its environment, as if it were smooth; `world` turns
/// directions back.
fn ambient(scene: &Scene, pixel: &Pixel, world: impl Fn(DVec3) -> DVec3) -> Vec3 {
    let normal = lobe::slope::direction::normal_of(pixel.bumps.mean());
    let mirrored = Vec3::from(reflect(pixel.wo, normal)).as_dvec3();
    let normal = Vec3::from(normal);
    let fresnel = scene.material.fresnel.reflectance(pixel.wo.dot(normal).clamp(0.0, 1.0));
    scene.material.base * (scene.environment)(world(normal.as_dvec3()))
        + Vec3::from(fresnel) * (scene.environment)(world(mirrored))
}
