//! Floats without microfacets: precision, elementary functions, exact products, small matrices.

pub(crate) mod atan;
pub(crate) mod eigen;
pub(crate) mod erfc;
pub(crate) mod exact;
pub(crate) mod exp;
pub(crate) mod expint;
mod factor;
mod float;
#[cfg(feature = "glam")]
mod glam;
#[cfg(feature = "glint")]
pub(crate) mod hash;
pub(crate) mod ln;
mod math;
#[cfg(feature = "probe")]
pub mod probe;
pub(crate) mod psd;
pub(crate) mod quadrature;
#[cfg(feature = "glint")]
pub(crate) mod quantile;
mod real;
mod single;

pub use eigen::Eigen;
pub use psd::Psd;
pub(crate) use real::Internal;
pub use real::Real;
