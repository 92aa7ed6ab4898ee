//! What the words mean: directions, slopes, roughness, shapes, footprints, moments, lobes.

pub mod direction;
mod footprint;
pub mod jacobian;
mod layers;
mod lobe;
mod mean_frame;
mod moments;
mod motion;
mod path;
pub mod ray;
mod roughness;
mod shape;
mod tilted;

pub use footprint::Footprint;
pub use lobe::Lobe;
pub use mean_frame::MeanFrame;
pub use moments::SlopeMoments;
pub use motion::Motion;
pub use path::{Path, Vertex};
pub use roughness::{Alphas, Roughness};
pub use shape::{AxisAligned, Full, Isotropic, Shape};
pub use tilted::Tilted;
