//! Materials: normal and displacement maps as lobes, and what a facade multiplies a lobe by.

#[cfg(feature = "glint")]
pub mod cells;
mod fresnel;
#[cfg(feature = "glint")]
pub mod glint;
#[cfg(feature = "leadr")]
pub mod leadr;
#[cfg(feature = "lean")]
pub mod lean;
#[cfg(feature = "glint")]
pub mod multilobe;

pub use fresnel::Fresnel;
