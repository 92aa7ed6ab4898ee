//! Many lobes in one pixel: densities of slopes from a dictionary, each with an integral of 1
//! (feature `glint`).
//!
//! A [`Dictionary`] of even marginals is made once, by a [`Recipe`]. A [`MultiLobe`] surface has
//! them on the cells of nested levels; a pixel sees a mixture of those that it covers
//! ([`PatchNdf`]), filtered by its kernel without leaving the tables ([`Marginal::mean`]). As every
//! density is even, V-cavities mask it exactly, and as every marginal has a cumulative, it can be
//! sampled.
//!
//! Source: Chermain, Sauvage, Dischler & Dachsbacher 2020, "Procedural Physically-based BRDF for
//! Real-Time Rendering of Glints"; Chermain, Lucas, Sauvage, Dischler & Dachsbacher 2021a,
//! "Real-Time Geometric Glint Anti-Aliasing with Normal Map Filtering"; Chermain, Sauvage, Dischler
//! & Dachsbacher 2021b, "Importance Sampling of Glittering BSDFs based on Finite Mixture
//! Distributions".

mod bytes;
mod cells;
mod dictionary;
mod ellipse;
mod generate;
mod marginal;
mod material;
mod ndf;
mod pieces;
mod plane;
mod recipe;
mod sample;

pub use dictionary::Dictionary;
pub use ellipse::ELLIPSE_LIMIT;
pub use marginal::Marginal;
pub use material::MultiLobe;
pub use ndf::PatchNdf;
pub use recipe::{LobeMeans, Recipe};
pub use sample::DirectionSample;
