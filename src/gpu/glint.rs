//! Glittering materials and pixels on them, as buffers hold them.
//!
//! Layer 6.

use super::slope::Psd;
use crate::material::{cells, glint, multilobe};
use bytemuck::{Pod, Zeroable};

/// Two scales of roughness: `LobeBiscale`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Biscale {
    /// How the slopes of details are distributed.
    pub spread: Psd,
    /// The roughness of one detail.
    pub local: Psd,
}

impl From<glint::Biscale<f32>> for Biscale {
    fn from(biscale: glint::Biscale<f32>) -> Self {
        Self { spread: biscale.spread().into(), local: biscale.local().into() }
    }
}

/// A glittering material: `LobeGlints`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Glints {
    /// The two roughnesses.
    pub biscale: Biscale,
    /// Details per unit area of the texture.
    pub density: f32,
    /// Deviation of the logarithm of a cell's number of details.
    pub variation: f32,
    /// Share of the surface that glitters.
    pub share: f32,
    padding: f32,
    /// Compression of the coordinates for details that are longer along one axis.
    pub stretch: [f32; 2],
    /// 1 for grooves along u, 2 for those along v, 0 for neither.
    pub groove: u32,
    /// What tells surfaces apart.
    pub seed: u32,
}

impl From<glint::Glints<f32>> for Glints {
    fn from(glints: glint::Glints<f32>) -> Self {
        let ([density, variation, share], stretch, groove, seed) = glints.numbers();
        let biscale = glints.biscale().into();
        Self { biscale, density, variation, share, padding: 0.0, stretch, groove, seed }
    }
}

/// A surface of facets: `LobeMultiLobe`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct MultiLobe {
    /// The roughness from afar.
    pub roughness: Psd,
    /// Facets per unit area of the texture.
    pub density: f32,
    /// Deviation of the base 4 logarithm of a cell's number of facets.
    pub variation: f32,
    /// Share of the cells that glitter.
    pub share: f32,
    /// What tells surfaces apart.
    pub seed: u32,
}

impl From<multilobe::MultiLobe<f32>> for MultiLobe {
    fn from(facets: multilobe::MultiLobe<f32>) -> Self {
        let ([density, variation, share], seed) = facets.numbers();
        Self { roughness: facets.roughness().into(), density, variation, share, seed }
    }
}

/// A pixel on a textured surface: `LobePatch`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Patch {
    /// Whole part of the texture coordinates.
    pub tile: [i32; 2],
    /// Texture coordinates from the corner of the tile.
    pub uv: [f32; 2],
    /// Change of the texture coordinates to the pixel at the right.
    pub right: [f32; 2],
    /// Change of the texture coordinates to the pixel above.
    pub up: [f32; 2],
}

impl From<cells::Patch<f32>> for Patch {
    fn from(patch: cells::Patch<f32>) -> Self {
        let cells::Patch { tile, uv, right, up } = patch;
        Self { tile, uv, right, up }
    }
}
