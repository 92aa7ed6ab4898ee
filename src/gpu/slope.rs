//! Footprints, moments, lobes and paths, as buffers hold them.
//!
//! Layer 6.

use crate::filter::{DiskKernel, Kernel};
use crate::slope::LobeShape;
use crate::{filter, scalar, slope};
use bytemuck::{Pod, Zeroable};

/// A matrix, by its Cholesky factor: `LobePsd`, and `LobeRoughness`, which holds one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Psd {
    /// The factor's l_xx.
    pub l_xx: f32,
    /// The factor's l_yx.
    pub l_yx: f32,
    /// The factor's l_yy.
    pub l_yy: f32,
}

impl From<scalar::Psd<f32>> for Psd {
    fn from(psd: scalar::Psd<f32>) -> Self {
        let [l_xx, l_yx, l_yy] = psd.cholesky();
        Self { l_xx, l_yx, l_yy }
    }
}

impl From<slope::Roughness<f32>> for Psd {
    fn from(roughness: slope::Roughness<f32>) -> Self {
        roughness.matrix().into()
    }
}

/// A kernel's columns: `LobeKernel`, and `LobeDiskKernel`, which holds one.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Columns {
    /// The first column of a root of the covariance.
    pub u: [f32; 2],
    /// The second column.
    pub v: [f32; 2],
}

impl From<Kernel<f32>> for Columns {
    fn from(kernel: Kernel<f32>) -> Self {
        let [u, v] = kernel.columns();
        Self { u, v }
    }
}

impl From<DiskKernel<f32>> for Columns {
    fn from(kernel: DiskKernel<f32>) -> Self {
        kernel.as_slopes().into()
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
    padding: f32,
}

impl From<slope::SlopeMoments<f32>> for SlopeMoments {
    fn from(moments: slope::SlopeMoments<f32>) -> Self {
        Self { mean: moments.mean(), covariance: moments.covariance().into(), padding: 0.0 }
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
    padding: f32,
}

impl From<slope::Lobe<f32>> for Lobe {
    fn from(lobe: slope::Lobe<f32>) -> Self {
        Self { mean: lobe.mean(), roughness: lobe.roughness().into(), padding: 0.0 }
    }
}

/// The shape of a roughness: `LobeAnisotropic`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct Anisotropic {
    /// The factor of the roughness.
    pub factor: Psd,
    /// The root of its determinant; 0 for a mirror along some axis.
    pub root_det: f32,
}

impl From<slope::Anisotropic<f32>> for Anisotropic {
    fn from(shape: slope::Anisotropic<f32>) -> Self {
        Self { factor: shape.roughness().into(), root_det: shape.root_det() }
    }
}

/// The shape of a lobe: `LobeNonCentered`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct NonCentered {
    /// The shape around the mean.
    pub shape: Anisotropic,
    /// The mean slope.
    pub mean: [f32; 2],
}

impl From<slope::NonCentered<slope::Anisotropic<f32>>> for NonCentered {
    fn from(shape: slope::NonCentered<slope::Anisotropic<f32>>) -> Self {
        Self { shape: (*shape.shape()).into(), mean: shape.mean() }
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
