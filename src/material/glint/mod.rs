//! Glints: discrete details that flicker in and out of a highlight, stable at every scale (feature
//! `glint`).
//!
//! A surface has details of roughness $A_l$, whose own slopes spread with $A_m$ ([`Biscale`]); $A_g
//! = A_m + A_l$ is what it looks like from afar. A pixel covers cells of two nested grids
//! ([`Grid`]), each with its own random numbers ([`Cell`](super::cells::Cell)), of whose details a
//! binomial number reflects ([`Binomial`]). What comes out is a [`Lobe`](crate::Lobe) for masking,
//! and how much brighter than it the pixel is ([`GlintNdf`]).
//!
//! Source: Zirr & Kaplanyan 2016, "Real-time Rendering of Procedural Multiscale Materials".
//! [`Glints`] conserves the mean; [`ZirrKaplanyan`] is theirs as it was.

mod binomial;
mod biscale;
mod color;
mod glints;
mod grid;
mod level;
mod light;
mod ndf;
mod sparkle;
mod zirr_kaplanyan;

pub use binomial::Binomial;
pub use biscale::Biscale;
pub use color::hue_wheel;
pub use glints::Glints;
pub use grid::Grid;
pub use level::{ANISOTROPY_LIMIT, CoveredCell};
pub use light::light_blur;
pub use ndf::GlintNdf;
pub use zirr_kaplanyan::{ZirrKaplanyan, zirr_kaplanyan_count};
