//! What the words mean: directions, slopes, roughness, shapes, footprints, moments, lobes.

mod algebra;
mod anisotropic;
mod compensated;
pub mod direction;
mod footprint;
pub mod jacobian;
mod lobe;
mod mean_frame;
mod moments;
mod motion;
mod non_centered;
mod path;
pub mod ray;
mod roughness;
mod shape;
mod whiten;
mod widened;

pub use anisotropic::Anisotropic;
pub use compensated::Compensated;
pub use footprint::Footprint;
pub use lobe::Lobe;
pub use mean_frame::MeanFrame;
pub use moments::SlopeMoments;
pub use motion::Motion;
pub use non_centered::NonCentered;
pub use path::{Path, Vertex};
pub use roughness::{Alphas, Roughness};
pub use shape::{AxisAligned, Extent, Isotropic, LobeShape};
pub use whiten::Whiten;
pub use widened::Widened;
