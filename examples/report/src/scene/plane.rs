//! A plane with a normal map, between magnified and minified.

use std::sync::Arc;

use lobe::slope::direction::normalize;

use super::map::NormalMap;
use super::subject::View;
use super::surface::{Hit, Shape, plane_point, world_x, world_z};
use crate::camera::{Camera, Ray, Size};
use crate::frame::Turn;
use crate::scalar::Scalar;
use crate::texture::Texture;
use crate::vector::Vector;

/// The light's mirror image is at the picture's center.
pub(super) const VIEW: View = View { top: 25.0, bottom: 50.0, light: 37.5 };

/// Texels per pixel where the view is most grazing, along the view: the densest of the picture. The
/// perspective makes the least dense, across the view at the bottom, about 0.3.
const DENSEST: f64 = 1.5;

/// The plane and its map.
pub(super) struct MappedPlane<R> {
    texture: Arc<Texture>,
    /// Texels per unit of length.
    density: R,
}

impl MappedPlane<f64> {
    /// The map at the density of [`DENSEST`], whatever the picture's size, and a caption.
    pub(super) fn seen_by(camera: &Camera<f64>, size: Size, map: &NormalMap) -> (Self, String) {
        let middle = 0.5 * size.width as f64;
        let [_, longest] = camera.steps(middle, 0.5);
        let [shortest, _] = camera.steps(middle, size.height as f64 - 0.5);
        let density = DENSEST / longest;
        let [width, height] = map.texture.size();
        let caption = format!(
            "{} ({width} x {height}), bilinear and repeating, view {} to {} degrees above the \
                plane, \
             light {} degrees high ahead; {:.2} texels per pixel across the view at the bottom \
             to {DENSEST:.2} along it at the top.",
            map.name,
            VIEW.top,
            VIEW.bottom,
            VIEW.light,
            density * shortest,
        );
        (Self { texture: Arc::clone(&map.texture), density }, caption)
    }

    /// The same in another precision.
    pub(super) fn cast<R: Scalar>(&self) -> MappedPlane<R> {
        MappedPlane { texture: Arc::clone(&self.texture), density: R::lit(self.density) }
    }
}

impl<R: Scalar> MappedPlane<R> {
    /// Texel coordinates. The map's +y is the plane's, and its rows count down.
    #[inline]
    fn texel(&self, x: R, y: R) -> [R; 2] {
        [x * self.density, -y * self.density]
    }
}

impl<R: Scalar> Shape<R> for MappedPlane<R> {
    #[inline]
    fn hit(&self, ray: &Ray<R>) -> Option<Hit<R>> {
        let point = plane_point(ray)?;
        let [x, y] = self.texel(point[0], point[1]);
        let normal = normalize(self.texture.lookup(x, y));
        Some(Hit { point, geometric: world_z(), normal, tangent: world_x(), part: 0 })
    }

    #[inline]
    fn turn(&self, hit: &Hit<R>, step: Vector<R>) -> Turn<R> {
        let normal =
            self.texture.turn(self.texel(hit.point[0], hit.point[1]), self.texel(step[0], step[1]));
        Turn { normal, tangent: [R::ZERO; 3] }
    }
}

#[cfg(test)]
mod tests {
    use super::super::map::carried_maps;
    use super::{DENSEST, MappedPlane, VIEW};
    use crate::camera::{Camera, Size};

    #[test]
    fn maps_are_seen_at_the_stated_densities() {
        let maps = carried_maps(false).unwrap();
        for width in [32, 400] {
            let size = Size::of_width(width);
            let camera = Camera::spanning(size, VIEW.top, VIEW.bottom);
            let (plane, _) = MappedPlane::seen_by(&camera, size, &maps[0]);
            let middle = 0.5 * width as f64;
            let [across, _] =
                camera.steps(middle, size.height as f64 - 0.5).map(|s| s * plane.density);
            assert!((0.25..0.4).contains(&across), "{across}");
            let [_, along] = camera.steps(middle, 0.5).map(|s| s * plane.density);
            assert!((along - DENSEST).abs() < 1e-12);
        }
    }
}
