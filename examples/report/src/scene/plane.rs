//! A plane with a normal map, between magnified and minified.

use std::sync::Arc;

use super::View;
use crate::camera::{Camera, Size};
use crate::scalar::Scalar;
use crate::texture::Texture;

/// The light's mirror image is at the picture's centre.
pub(super) const VIEW: View = View { top: 25.0, bottom: 50.0, light: 37.5 };

/// Texels per pixel where the view is most grazing, along the view: the densest of the picture. The
/// perspective makes the least dense, across the view at the bottom, about 0.3.
const DENSEST: f64 = 1.5;

/// A decoded normal map with the name it goes by.
pub(crate) struct NormalMap {
    pub(crate) name: String,
    pub(crate) texture: Arc<Texture>,
}

/// The maps the program carries: name and PNG. Origin and licence: assets/README.md.
const CARRIED: [(&str, &[u8]); 4] = [
    ("diamond-plate", include_bytes!("../../assets/diamond-plate.png")),
    ("leather", include_bytes!("../../assets/leather.png")),
    ("wood-fibre", include_bytes!("../../assets/wood-fibre.png")),
    ("crumpled-paper", include_bytes!("../../assets/crumpled-paper.png")),
];

/// The carried maps, decoded.
pub(crate) fn carried_maps() -> Result<Vec<NormalMap>, String> {
    let decode = |(name, file): (&str, &[u8])| {
        let texture = Texture::decode(file).map_err(|error| format!("carried {name}: {error}"))?;
        Ok(NormalMap { name: name.into(), texture: Arc::new(texture) })
    };
    CARRIED.into_iter().map(decode).collect()
}

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
            "{} ({width} x {height}), bilinear and repeating, view {} to {} degrees above the plane, \
             distant light at {} degrees ahead; {:.2} texels per pixel across the view at the bottom \
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
    /// Unit normal. The map's +y is the plane's, and its rows count down.
    #[inline]
    pub(super) fn normal(&self, p: [R; 2]) -> [R; 3] {
        let normal = self.texture.lookup(p[0] * self.density, -p[1] * self.density);
        lobe::slope::direction::normalize(normal)
    }
}

#[cfg(test)]
mod tests {
    use super::{DENSEST, MappedPlane, VIEW, carried_maps};
    use crate::camera::{Camera, Size};

    #[test]
    fn every_carried_map_decodes_and_is_seen_at_the_stated_densities() {
        let maps = carried_maps().unwrap();
        assert_eq!(maps.len(), 4);
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
