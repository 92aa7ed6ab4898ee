//! A plane with a map under one light, and what a pixel knows of it: texture coordinates,
//! directions, their motions.

use lobe::Footprint;
use lobe::slope::Motion;

use crate::camera::{Camera, Size};
use crate::light::{Light, LightKind};
use crate::scalar::Scalar;
use crate::vector::{Vector, add, along, dot, scaled, tangential};

/// Degrees between the view and the texture's axes: footprints that lie along them would hide every
/// mistake in the covariance's third entry.
pub(crate) const TURN: f64 = 25.0;

/// Degrees from the picture's middle row to its first and last, at most; and as a part of the
/// elevation.
const SPAN: f64 = 12.0;
const PART: f64 = 0.4;

/// Where a plane is seen from, and how densely its texels lie.
#[derive(Clone, Copy)]
pub(super) struct Station {
    pub(super) size: Size,
    /// Degrees of the view over the plane at the picture's middle.
    pub(super) elevation: f64,
    /// Texels per pixel at the picture's middle, across the view. Along it there are more, by one
    /// over the elevation's sine.
    pub(super) ratio: f64,
    pub(super) light: LightKind,
    /// Of the map, in texels.
    pub(super) map: [usize; 2],
}

/// What is seen from a station, in one precision. The plane's own frame is the tangent frame: x
/// along u, y against v.
#[derive(Clone)]
pub(super) struct View<R> {
    camera: Camera<R>,
    light: Light<R>,
    /// Texture coordinates per unit of length.
    density: [R; 2],
}

/// What shading needs of a point of the picture.
pub(super) struct Spot<R> {
    /// Texture coordinates; they repeat.
    pub(super) uv: [R; 2],
    pub(super) wo: Vector<R>,
    pub(super) wi: Vector<R>,
    /// Irradiance on a surface that faces the light.
    pub(super) strength: R,
    /// On the plane, from the eye's foot.
    point: Vector<R>,
    /// One over the distance to the eye.
    nearness: R,
    /// To the plane, of the ray with the camera's direction.
    reach: R,
    direction: Vector<R>,
}

/// Changes to the pixel at the right and to the one below.
pub(super) struct Steps<R> {
    /// Of texture coordinates.
    pub(super) du: [R; 2],
    pub(super) dv: [R; 2],
    /// On the plane.
    on_plane: [Vector<R>; 2],
}

impl View<f64> {
    /// The light's mirror image is at the picture's middle.
    pub(super) fn from(station: &Station) -> Self {
        let Station { size, elevation, ratio, light, map } = *station;
        let span = SPAN.min(PART * elevation);
        let turn = TURN.to_radians();
        let camera = Camera::spanning(size, elevation - span, elevation + span);
        let middle = [size.width, size.height].map(|side| 0.5 * side as f64);
        let [across, _] = camera.steps(middle[0], middle[1]);
        let (sin, cos) = elevation.to_radians().sin_cos();
        let towards = [0.0, cos, sin];
        let shone = match light {
            LightKind::Distant => Light::Distant(towards),
            // As far as the eye: its direction changes as much as the view's.
            LightKind::Point => Light::point([0.0, cos / sin, 0.0], towards, 1.0 / sin),
        };
        let density = ratio / across;
        Self {
            camera: camera.turned(turn),
            light: shone.turned(turn),
            density: map.map(|side| density / side as f64),
        }
    }

    /// The same in another precision.
    pub(super) fn cast<R: Scalar>(&self) -> View<R> {
        View {
            camera: self.camera.cast(),
            light: self.light.cast(),
            density: self.density.map(R::lit),
        }
    }
}

impl<R: Scalar> View<R> {
    /// What is seen at a place of the picture; pixel centers are at halves.
    #[inline]
    pub(super) fn spot(&self, [x, y]: [R; 2]) -> Spot<R> {
        let ray = self.camera.ray(x, y);
        let reach = -ray.eye[2] / ray.direction[2];
        let point = ray.at(reach);
        let arrival = self.light.at(point);
        let inverse = R::ONE / dot(ray.direction, ray.direction).sqrt();
        Spot {
            uv: self.coordinates(point),
            wo: scaled(-inverse, ray.direction),
            wi: arrival.wi,
            strength: arrival.strength,
            point,
            nearness: inverse / reach,
            reach,
            direction: ray.direction,
        }
    }

    /// The map's rows count down, against y.
    #[inline]
    fn coordinates(&self, on_plane: Vector<R>) -> [R; 2] {
        [on_plane[0] * self.density[0], -(on_plane[1] * self.density[1])]
    }

    /// How the point moves from pixel to pixel (Igehy 1999).
    #[inline]
    pub(super) fn steps(&self, spot: &Spot<R>) -> Steps<R> {
        let on_plane = [self.camera.right, self.camera.down].map(|change| {
            let longer = change[2] / spot.direction[2];
            scaled(spot.reach, along(change, -longer, spot.direction))
        });
        let [du, dv] = on_plane.map(|step| self.coordinates(step));
        Steps { du, dv, on_plane }
    }

    /// How the half vector's slope moves, the plane being flat: what of the pixel no texture knows.
    #[inline]
    pub(super) fn footprint(&self, spot: &Spot<R>, steps: &Steps<R>) -> Footprint<R> {
        let arrival = self.light.at(spot.point);
        let [right, down] = steps.on_plane.map(|step| {
            let eye = scaled(-spot.nearness, tangential(step, spot.wo));
            Motion { half_vector: add(eye, arrival.turn(step)), ..Motion::default() }
        });
        // Eye and light are above the plane, so is the half vector.
        Footprint::from_motion(add(spot.wo, spot.wi), &right, &down).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use lobe::slope::direction::slope_of;

    use super::{Station, View};
    use crate::camera::Size;
    use crate::light::LightKind;
    use crate::vector::add;

    fn station(elevation: f64, light: LightKind) -> Station {
        Station { size: Size::of_width(64), elevation, ratio: 4.0, light, map: [256, 128] }
    }

    #[test]
    fn the_middle_has_the_ratio_and_sees_the_light_mirrored() {
        for elevation in [90.0, 45.0, 5.0] {
            let view = View::from(&station(elevation, LightKind::Distant));
            let spot = view.spot([32.0, 18.0]);
            let half = slope_of(add(spot.wo, spot.wi));
            assert!(half.iter().all(|s| s.abs() < 1e-9), "{elevation} {half:?}");
            let steps = view.steps(&spot);
            let texels = |d: [f64; 2]| (d[0] * 256.0).hypot(d[1] * 128.0);
            let sin = elevation.to_radians().sin();
            assert!((texels(steps.du) - 4.0).abs() < 1e-9);
            assert!((texels(steps.dv) - 4.0 / sin).abs() < 1e-6, "{elevation}");
        }
    }

    #[test]
    fn steps_and_footprints_are_differences() {
        for light in LightKind::ALL {
            let view = View::from(&station(15.0, light));
            let (place, h) = ([13.2, 30.7], 1e-4);
            let spot = view.spot(place);
            let steps = view.steps(&spot);
            let footprint = view.footprint(&spot, &steps);
            for (axis, d, side) in [(0, steps.du, footprint.u), (1, steps.dv, footprint.v)] {
                let [after, before] = [h, -h].map(|h| {
                    let mut moved = place;
                    moved[axis] += h;
                    let spot = view.spot(moved);
                    (spot.uv, slope_of(add(spot.wo, spot.wi)))
                });
                for k in 0..2 {
                    assert!((d[k] - (after.0[k] - before.0[k]) / (2.0 * h)).abs() < 1e-7);
                    assert!((side[k] - (after.1[k] - before.1[k]) / (2.0 * h)).abs() < 1e-7);
                }
            }
        }
    }
}
