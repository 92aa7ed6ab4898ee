//! Floats without microfacets: precision, elementary functions, exact products, small matrices.

pub(crate) mod atan;
#[cfg(feature = "count")]
pub mod count;
pub(crate) mod erfc;
pub(crate) mod exact;
pub(crate) mod exp;
pub(crate) mod expint;
pub(crate) mod ln;
mod math;
pub(crate) mod psd;
pub(crate) mod quadrature;
mod real;

pub use psd::{Eigen, Psd};
pub use real::Real;
