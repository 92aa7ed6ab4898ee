//! Materials beyond the lobe: what a facade multiplies it by.

mod fresnel;

pub use fresnel::Fresnel;
