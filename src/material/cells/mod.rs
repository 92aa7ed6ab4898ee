//! A pixel on a textured surface and the random cells below it (feature `glint`).
//!
//! A [`Patch`] is where a pixel lies in texture coordinates, a [`Cell`] the random numbers of one
//! place on nested grids. [`glint`](super::glint) and [`multilobe`](super::multilobe) draw their
//! details from them.

mod cell;
mod patch;
mod tile;

pub use cell::Cell;
pub use patch::Patch;
pub(super) use tile::{corner, finest, place};
