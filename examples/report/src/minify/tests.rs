use super::ground::Ground;
use super::method::{self, Method, name};
use super::reference::{self, Strata};
use super::texels::Texels;
use super::view::{Station, View};
use crate::camera::Size;
use crate::light::LightKind;
use crate::method::Distribution;
use crate::metric::{Errors, scale};

const SIZE: Size = Size { width: 12, height: 8 };

fn station(map: [usize; 2], elevation: f64, ratio: f64) -> Station {
    Station { size: SIZE, elevation, ratio, light: LightKind::Distant, map }
}

/// Every method's errors in a view, and the reference's noise.
fn errors(
    texels: &Texels,
    elevation: f64,
    ratio: f64,
    alpha: f64,
    distribution: Distribution,
) -> (Vec<(Method, Errors)>, f64) {
    let station = station(texels.slopes.size(), elevation, ratio);
    let strata = Strata::of(&station, 24);
    let references = reference::render(texels, &station, &[alpha], strata, &|| ()).unwrap();
    let reference = references.of(0, distribution);
    let ground = Ground::new(texels, &View::from(&station), alpha).unwrap();
    let judged = vec![true; SIZE.pixels()];
    let scale = scale(&reference.radiance, &judged);
    let measured = method::all().into_iter().map(|method| {
        let picture = method.picture(distribution, &ground, SIZE);
        let errors = Errors::of(&picture, &reference.radiance, &judged, scale);
        (method, errors)
    });
    (measured.collect(), reference.noise * scale)
}

fn of(measured: &[(Method, Errors)], name: &str) -> Errors {
    measured.iter().find(|(method, _)| method.name == name).unwrap().1
}

/// A tilted plane without a map: all methods shade the same lobe, and what the pixel's own motion
/// adds is small.
#[test]
fn on_a_constant_map_every_method_is_the_reference() {
    let texels = Texels::of_slopes([8, 4], vec![[0.12, -0.07]; 32]).unwrap();
    for distribution in Distribution::ALL {
        for (elevation, ratio) in [(90.0, 1.0), (45.0, 8.0), (15.0, 2.0)] {
            let (measured, noise) = errors(&texels, elevation, ratio, 0.3, distribution);
            // On a constant map, point sampling evaluates the reference's lobe at the pixel's
            // center. Its error is the lobe's curvature over the pixel, which a kernel integrates.
            let center = of(&measured, name::POINT).rmse;
            assert!(noise < 1e-3 && center < 0.02, "{elevation} {noise} {center}");
            for (method, errors) in &measured {
                let name = method.name;
                assert!(errors.rmse < 1.01 * center + 1e-4, "{elevation} {name} {errors:?}");
            }
        }
    }
}

/// Where the half vector moves by as much as alpha from pixel to pixel, its kernel is what is
/// missing.
#[test]
fn on_a_narrow_lobe_the_kernel_mends_what_the_center_misses() {
    let texels = Texels::of_slopes([4, 4], vec![[0.0; 2]; 16]).unwrap();
    let (measured, noise) = errors(&texels, 45.0, 4.0, 0.02, Distribution::Beckmann);
    let [plain, kernel] = [name::LEAN, name::KERNEL].map(|name| of(&measured, name).rmse);
    assert!(noise < 0.01 * plain && kernel < 0.35 * plain, "{plain} {kernel} {noise}");
}

/// Raw moments are moments, but for their rounding; and one bumpy map is seen through both.
#[test]
fn raw_moments_shade_as_merged_ones_do() {
    let slope = |k: u16| [0.3 * f32::from(k * 7 % 11) / 11.0, 0.2 * f32::from(k * 5 % 13) / 13.0];
    let texels = Texels::of_slopes([16, 16], (0..256).map(slope).collect()).unwrap();
    for distribution in Distribution::ALL {
        let (measured, noise) = errors(&texels, 45.0, 4.0, 0.2, distribution);
        let [merged, raw] = [name::LEAN, name::RAW].map(|name| of(&measured, name));
        assert!((merged.rmse - raw.rmse).abs() < 1e-4 && (merged.energy - raw.energy).abs() < 1e-4);
        // More samples are nearer to the reference, whose 2 x 24^2 are worth at least as many
        // random ones.
        let counts = [name::FOUR, name::SIXTEEN, name::SIXTY_FOUR].map(|name| of(&measured, name));
        assert!(counts[2].rmse < counts[1].rmse && counts[1].rmse < counts[0].rmse);
        assert!(noise < (64.0_f64 / 1152.0).sqrt() * counts[2].rmse, "{noise} {counts:?}");
    }
}

/// Slopes that change evenly: how much of that a lookup takes for roughness.
#[test]
fn on_a_ramp_lookups_are_wider_than_the_pixel_by_what_tents_are_wider_than_boxes() {
    let side: u16 = 256;
    let per_texel = 0.4 / f32::from(side);
    // There and back: no jump at the border.
    let slope = |k: u16| per_texel * f32::from(k.min(side - 1 - k));
    let row = (0..side).map(|column| [slope(column), 0.0]);
    let slopes = (0..side).flat_map(|_| row.clone()).collect();
    let texels = Texels::of_slopes([usize::from(side); 2], slopes).unwrap();
    let view = View::from(&station(texels.slopes.size(), 90.0, 16.0));
    let ground = Ground::new(&texels, &view, 0.1).unwrap();
    let mut spot = view.cast().spot([6.0, 4.0]);
    let steps = ground.view.steps(&spot);
    // A square of 16 texels, however it is turned.
    let exact = (16.0 * per_texel).powi(2) / 12.0;
    // On the middle of a texel of that level, on the border of two, and in the mean over all
    // phases.
    let mut at = |texel: f32| {
        spot.uv = [texel * 16.0 / f32::from(side), 0.5];
        let [plain, narrow] = [ground.trilinear(spot.uv, &steps), ground.narrow(&spot, &steps)]
            .map(|moments| {
                let [xx, xy, yy] = moments.covariance().entries();
                assert!(xy.abs() < 1e-9 && yy.abs() < 1e-9);
                // Texels are points: n of them have the variance (n^2 - 1)/12.
                (xx + per_texel * per_texel / 12.0) / exact
            });
        [plain, narrow]
    };
    assert!((at(4.5)[0] - 1.0).abs() < 1e-3 && (at(4.0)[0] - 4.0).abs() < 1e-3);
    let phases = (0..64_u8).map(|k| at(3.0 + (f32::from(k) + 0.5) / 64.0));
    let [plain, narrow] = phases.fold([0.0; 2], |sum, x| [0, 1].map(|k| sum[k] + x[k] / 64.0));
    assert!((plain - 3.0).abs() < 1e-3 && (narrow - 1.0).abs() < 1e-3, "{plain} {narrow}");
    // Uniform along one axis: 9/5.
    assert!((texels.spread()[1] - 1.8).abs() < 0.01 && texels.clipped == 0.0);
}
