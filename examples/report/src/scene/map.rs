//! Normal maps with names: the four that the program carries, and a user's.

use std::sync::Arc;

use crate::channels::Channels;
use crate::texture::Texture;

/// A decoded normal map with the name it goes by.
pub(crate) struct NormalMap {
    pub(crate) name: String,
    pub(crate) texture: Arc<Texture>,
}

/// The maps the program carries: name and PNG. Origin and license: assets/README.md. The first is
/// the one of quick runs.
const CARRIED: [(&str, &[u8]); 4] = [
    ("leather", include_bytes!("../../assets/leather.png")),
    ("diamond-plate", include_bytes!("../../assets/diamond-plate.png")),
    ("wood-fiber", include_bytes!("../../assets/wood-fiber.png")),
    ("crumpled-paper", include_bytes!("../../assets/crumpled-paper.png")),
];

/// The carried maps, decoded; the first one only, or all.
pub(crate) fn carried_maps(all: bool) -> Result<Vec<NormalMap>, String> {
    let count = if all { CARRIED.len() } else { 1 };
    CARRIED[..count].iter().map(decode).collect()
}

/// The map of the turning ball: of the carried ones it flickers most without a filter, 68 times the
/// mean radiance in a ball of 40 pixels radius at alpha 0.01, the others 10 to 52 times.
pub(crate) fn restless_map() -> Result<NormalMap, String> {
    decode(&CARRIED[1])
}

/// The map of facets on a ball: of the carried ones it has the most of one direction.
pub(crate) fn combed_map() -> Result<NormalMap, String> {
    decode(&CARRIED[2])
}

fn decode(&(name, file): &(&str, &[u8])) -> Result<NormalMap, String> {
    let decoded = Texture::decode(file, Channels::RGB);
    let texture = decoded.map_err(|error| format!("carried {name}: {error}"))?.texture;
    Ok(NormalMap { name: name.into(), texture: Arc::new(texture) })
}

#[cfg(test)]
mod tests {
    use super::carried_maps;

    #[test]
    fn every_carried_map_decodes() {
        assert_eq!(carried_maps(true).unwrap().len(), 4);
        assert_eq!(carried_maps(false).unwrap().len(), 1);
    }
}
