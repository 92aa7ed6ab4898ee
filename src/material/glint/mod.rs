//! Glints: discrete details that flicker in and out of a highlight, stable at every scale (feature `glint`).
//!
//! A surface has details of roughness $A_l$, whose own slopes spread with $A_m$ ([`Biscale`]); $A_g = A_m + A_l$ is what it
//! looks like from afar. A pixel covers cells of two nested grids ([`Grid`]), each with its own random numbers
//! ([`Cell`]), of whose details a binomial number reflects ([`Binomial`]). What comes out is a [`Lobe`](crate::Lobe)
//! for masking, and how much brighter than it the pixel is ([`GlintLobe`]).
//!
//! Source: Zirr & Kaplanyan 2016, "Real-time Rendering of Procedural Multiscale Materials". [`Glints`] conserves the mean;
//! [`Published`] is theirs as it was.

mod binomial;
mod biscale;
mod cell;
mod colour;
mod glints;
mod grid;
mod level;
mod light;
mod lobe;
mod patch;
mod published;
mod tile;

pub use binomial::Binomial;
pub use biscale::Biscale;
pub use cell::Cell;
pub use colour::hue_wheel;
pub use glints::Glints;
pub use grid::{ANISOTROPY_LIMIT, Covered, Grid};
pub use light::light_blur;
pub use lobe::GlintLobe;
pub use patch::Patch;
pub use published::{Published, published_count};
pub(crate) use tile::{corner, finest, place};
