//! The facade: bake a material under a pixel's kernel once, then evaluate it for any number of
//! lights.
//!
//! Layer 5. [`Lobe`](crate::Lobe), [`Kernel`](crate::Kernel), [`Ndf`](crate::Ndf) and
//! [`Fresnel`](crate::material::Fresnel) offer everything here one by one; a renderer that wants
//! only some of it takes those.

#[cfg(feature = "glint")]
mod glints;
mod material;
#[cfg(feature = "glint")]
mod multilobe;

#[cfg(feature = "glint")]
pub use glints::{GlintMaterial, GlintShading};
pub use material::{Material, Shading, bake_all, evaluate_all};
#[cfg(feature = "glint")]
pub use multilobe::{MultiLobeMaterial, MultiLobeShading};
