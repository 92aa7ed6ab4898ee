//! Microfacet lobes that can be filtered.
#![no_std]
#[cfg(feature = "std")]
extern crate std;

mod error;
pub mod filter;
pub mod material;
pub mod ndf;
mod scalar;
pub mod shade;
pub mod slope;

pub use error::Error;
pub use filter::{Kernel, PixelFilter};
pub use ndf::{Beckmann, Distribution, Ggx, Ndf};
pub use scalar::{Eigen, Psd, Real};
pub use slope::{
    Alphas, AxisAligned, Footprint, Full, Isotropic, Lobe, Path, Roughness, Shape, SlopeMoments,
    Tilted, Vertex,
};
