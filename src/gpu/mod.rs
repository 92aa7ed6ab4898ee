//! Plain structures with the layout of the WGSL port's, to be written into buffers (feature
//! `bytemuck`).
//!
//! Layer 6. What a material or a pixel fixes on the CPU is computed here in f32 and read in a
//! shader as the structure of the port that has `Lobe` before its name: [`NonCentered`] as
//! `LobeNonCentered`. Layouts are those of storage buffers, padding included
//! (`tests/texts/layouts.rs` asks naga); uniform buffers align nested structures to 16 bytes, which
//! these do not. Every type is [`bytemuck::Pod`]: no function of the port checks what a
//! caller writes into one.
//!
//! ```
//! use lobe::{Lobe, Roughness, gpu};
//! let lobe = Lobe::new([0.2_f32, 0.0], Roughness::from_alpha(0.1)?)?;
//! let material = [gpu::NonCentered::from(lobe)];
//! assert_eq!(bytemuck::cast_slice::<_, u8>(&material).len(), 24);
//! # Ok::<(), lobe::Error>(())
//! ```

#[cfg(feature = "glint")]
mod glint;
mod slope;

#[cfg(feature = "glint")]
pub use glint::{Biscale, Glints, MultiLobe, Patch};
pub use slope::{
    Anisotropic, Columns, Footprint, Lobe, Motion, NonCentered, Path, Psd, SlopeMoments,
    SphericalGaussian, Vertex,
};
