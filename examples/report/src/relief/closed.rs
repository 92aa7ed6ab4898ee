//! What needs no grid: the BRDF of a distant light, in closed form; and normal mapping, for
//! contrast.

use std::f64::consts::TAU;

use lobe::Lobe;
use lobe::material::leadr::{Leadr, Shadowing};
use lobe::slope::direction::{normal_of, normalize, reflect};

use super::ball::Spot;
use super::rule::Pixel;
use super::sky::{Lamp, Sky};
use crate::pattern::hammersley;
use crate::vector::{along, cross};

/// Radiance of a pixel under lamps that are taken for points.
pub(super) fn lit(pixel: &Pixel, sky: &Sky<f32>, shadowing: Shadowing) -> f32 {
    let leadr = Leadr::new(&pixel.lobe);
    let lamps = sky.lamps().iter().map(|lamp| {
        let wi = pixel.spot.local(lamp.direction);
        lamp.irradiance * leadr.brdf_cos(pixel.spot.wo, wi, shadowing)
    });
    lamps.sum()
}

/// Nodes along each side of a square of [`LAMP_REACH`] deviations of a lamp.
const LAMP_NODES: i32 = 40;
const LAMP_REACH: f64 = 4.5;

/// Radiance of a pixel under lamps as large as they are: the closed form's mean over each.
pub(super) fn lit_by_all(
    spot: &Spot<f64>,
    lobe: &Lobe<f64>,
    sky: &Sky<f64>,
    shadowing: Shadowing,
) -> f64 {
    let leadr = Leadr::new(lobe);
    let lit = |lamp: &Lamp<f64>| {
        let across = normalize(cross(lamp.direction, [0.6, 0.0, 0.8]));
        let upwards = cross(lamp.direction, across);
        let half = LAMP_REACH / lamp.sharpness.sqrt();
        let area = (2.0 * half / f64::from(LAMP_NODES)).powi(2);
        let mut sum = 0.0;
        for [a, b] in square(LAMP_NODES, half) {
            let place = along(along(lamp.direction, a, across), b, upwards);
            let direction = normalize(place);
            // The plane across, seen from its distance of 1.
            let solid_angle = area / (1.0 + a * a + b * b).powf(1.5);
            let wi = spot.local(direction);
            sum += solid_angle * lamp.radiance(direction) * leadr.brdf_cos(spot.wo, wi, shadowing);
        }
        sum
    };
    sky.lamps().iter().map(lit).sum()
}

/// Slopes of a normal map: enough, and in no rows, so that a lamp's images by single ones do not
/// show.
const SLOPES: u32 = 4096;

/// What a normal map of these slopes gives: every normal's reflection alike, however much of its
/// facet is seen.
pub(super) fn normal_mapped(spot: &Spot<f64>, sigma: [f64; 2], sky: &Sky<f64>) -> f64 {
    let radiances = (0..SLOPES).map(|index| {
        let [u, v] = hammersley(index, SLOPES).map(f64::from);
        // Box and Muller: a Gaussian pair from a radius and an angle.
        let (radius, (sin, cos)) = ((-2.0 * u.ln()).sqrt(), (TAU * v).sin_cos());
        let wi = reflect(spot.wo, normal_of([sigma[0] * radius * cos, sigma[1] * radius * sin]));
        sky.radiance(spot.world(wi))
    });
    radiances.sum::<f64>() / f64::from(SLOPES)
}

/// The middles of a square's parts, from -`half` to `half`.
fn square(count: i32, half: f64) -> impl Iterator<Item = [f64; 2]> {
    let at = move |k: i32| half * (f64::from(2 * k + 1) / f64::from(count) - 1.0);
    (0..count).flat_map(move |j| (0..count).map(move |k| [at(j), at(k)]))
}

#[cfg(test)]
mod tests {
    use super::{lit, lit_by_all, normal_mapped};
    use crate::relief::ball::Ball;
    use crate::relief::rule::Pixel;
    use crate::relief::sky::Sky;
    use lobe::material::leadr::Shadowing;
    use lobe::slope::direction::reflect;
    use lobe::{Lobe, Roughness};

    #[test]
    fn a_lobe_much_wider_than_the_lamp_sees_a_point() {
        let ball = Ball { side: 6 };
        let (sky, sky32) = (Sky::lamp(), Sky::lamp().cast());
        let lobe = Lobe::centered(Roughness::from_sigma_rho(2.0, 2.0, 0.0).unwrap());
        let lobe32 = Lobe::centered(Roughness::from_sigma_rho(2.0, 2.0, 0.0).unwrap());
        // In the middle of the picture, where nothing grazes.
        let spot = ball.spot([2, 2]).unwrap();
        let pixel = Pixel { spot: spot.cast(), lobe: lobe32 };
        for shadowing in [Shadowing::MaskingOnly, Shadowing::Both] {
            let (point, all) =
                (lit(&pixel, &sky32, shadowing), lit_by_all(&spot, &lobe, &sky, shadowing));
            assert!((f64::from(point) / all - 1.0).abs() < 0.03, "{point} {all}");
        }
    }

    #[test]
    fn without_deviation_a_normal_map_is_a_mirror() {
        let (ball, sky) = (Ball { side: 6 }, Sky::whole());
        let spot = ball.spot([1, 3]).unwrap();
        let mirrored = sky.radiance(spot.world(reflect(spot.wo, [0.0, 0.0, 1.0])));
        assert!((normal_mapped(&spot, [0.0; 2], &sky) / mirrored - 1.0).abs() < 1e-12);
    }
}
