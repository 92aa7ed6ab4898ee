//! Footprints, moments, lobes and paths, as buffers hold them.
//!
//! Layer 6.

use crate::filter::{DiskKernel, Kernel};
use crate::{filter, scalar, slope};
use bytemuck::{Pod, Zeroable};

/// A matrix: `LobePsd`, and `LobeRoughness`, `LobeKernel` and `LobeDiskKernel`, which hold one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Psd {
    /// The entries xx, xy and yy.
    pub entries: [f32; 3],
    /// The root of the determinant.
    pub root_det: f32,
}

impl From<scalar::Psd<f32>> for Psd {
    fn from(psd: scalar::Psd<f32>) -> Self {
        Self { entries: psd.entries(), root_det: psd.root_det() }
    }
}

impl From<slope::Roughness<f32>> for Psd {
    fn from(roughness: slope::Roughness<f32>) -> Self {
        roughness.matrix().into()
    }
}

impl From<Kernel<f32>> for Psd {
    fn from(kernel: Kernel<f32>) -> Self {
        kernel.covariance().into()
    }
}

impl From<DiskKernel<f32>> for Psd {
    fn from(kernel: DiskKernel<f32>) -> Self {
        kernel.covariance().into()
    }
}

/// A pixel's footprint: `LobeFootprint`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Footprint {
    /// Derivative of the slope to the pixel at the right.
    pub u: [f32; 2],
    /// Derivative of the slope to the pixel above.
    pub v: [f32; 2],
}

impl From<slope::Footprint<f32>> for Footprint {
    fn from(footprint: slope::Footprint<f32>) -> Self {
        let slope::Footprint { u, v } = footprint;
        Self { u, v }
    }
}

/// Mean and covariance of slopes: `LobeSlopeMoments`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct SlopeMoments {
    /// The mean slope.
    pub mean: [f32; 2],
    /// The covariance.
    pub covariance: Psd,
}

impl From<slope::SlopeMoments<f32>> for SlopeMoments {
    fn from(moments: slope::SlopeMoments<f32>) -> Self {
        Self { mean: moments.mean(), covariance: moments.covariance().into() }
    }
}

/// A mean and a roughness: `LobeLobe`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Lobe {
    /// The mean slope.
    pub mean: [f32; 2],
    /// The roughness matrix.
    pub roughness: Psd,
}

impl From<slope::Lobe<f32>> for Lobe {
    fn from(lobe: slope::Lobe<f32>) -> Self {
        Self { mean: lobe.mean(), roughness: lobe.roughness().into() }
    }
}

/// The shape of a roughness, precomputed: `LobeAnisotropic`.
///
/// The fields are what the port computes of the matrix in `lobe_anisotropic_new`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Anisotropic {
    /// The entry xx of the matrix.
    pub xx: f32,
    /// The entry xy of the matrix.
    pub xy: f32,
    /// The root of its determinant.
    pub root_det: f32,
    /// One over xx, or 0.
    pub inverse_xx: f32,
    /// The root of the determinant over xx.
    pub along: f32,
    /// xx over the root of the determinant.
    pub across: f32,
    /// The determinant over xx; the entry yy if xx is 0.
    pub schur: f32,
}

impl From<slope::Anisotropic<f32>> for Anisotropic {
    fn from(shape: slope::Anisotropic<f32>) -> Self {
        let [xx, xy, root_det, inverse_xx, along, across, schur] = shape.numbers();
        Self { xx, xy, root_det, inverse_xx, along, across, schur }
    }
}

/// The shape of a lobe, precomputed: `LobeNonCentered`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct NonCentered {
    /// The shape around the mean.
    pub shape: Anisotropic,
    padding: f32,
    /// The mean slope.
    pub mean: [f32; 2],
}

impl From<slope::NonCentered<slope::Anisotropic<f32>>> for NonCentered {
    fn from(shape: slope::NonCentered<slope::Anisotropic<f32>>) -> Self {
        Self { shape: (*shape.shape()).into(), padding: 0.0, mean: shape.mean() }
    }
}

impl From<slope::Lobe<f32>> for NonCentered {
    fn from(lobe: slope::Lobe<f32>) -> Self {
        lobe.shape().into()
    }
}

/// One end of a light path: `LobeVertex`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Vertex {
    /// Unit vector from the shaded point, tangent frame.
    pub direction: [f32; 3],
    /// One over the distance.
    pub inverse_distance: f32,
}

impl From<slope::Vertex<f32>> for Vertex {
    fn from(vertex: slope::Vertex<f32>) -> Self {
        let slope::Vertex { direction, inverse_distance } = vertex;
        Self { direction, inverse_distance }
    }
}

/// A surface point between viewer and light: `LobePath`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Path {
    /// The viewer.
    pub eye: Vertex,
    /// The light.
    pub light: Vertex,
    /// The shape operator's b_11, b_12 and b_22.
    pub curvature: [f32; 3],
    padding: f32,
}

impl From<slope::Path<f32>> for Path {
    fn from(path: slope::Path<f32>) -> Self {
        let slope::Path { eye, light, curvature } = path;
        Self { eye: eye.into(), light: light.into(), curvature, padding: 0.0 }
    }
}

/// Changes at a shaded point over one pixel: `LobeMotion`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Motion {
    /// Change of the half vector.
    pub half_vector: [f32; 3],
    padding: f32,
    /// Change of the shading normal, tangential components.
    pub normal: [f32; 2],
    /// Turn of the frame about its normal.
    pub spin: f32,
    padding_after: f32,
}

impl From<slope::Motion<f32>> for Motion {
    fn from(motion: slope::Motion<f32>) -> Self {
        let slope::Motion { half_vector, normal, spin } = motion;
        Self { half_vector, padding: 0.0, normal, spin, padding_after: 0.0 }
    }
}

/// A spherical Gaussian light: `LobeSphericalGaussian`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct SphericalGaussian {
    /// The unit direction of the brightest point.
    pub direction: [f32; 3],
    /// The sharpness.
    pub sharpness: f32,
}

impl From<filter::SphericalGaussian<f32>> for SphericalGaussian {
    fn from(light: filter::SphericalGaussian<f32>) -> Self {
        Self { direction: light.direction(), sharpness: light.sharpness() }
    }
}
