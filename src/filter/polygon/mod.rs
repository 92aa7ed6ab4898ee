//! GGX averaged over a parallelogram: the tree of cases, and its branches.
//!
//! Layer 3. `tree` chooses; `brdf` shades by what it finds; `lanes` and `height` are both without a
//! branch, and less accurate, by the sum in `halves`; `double` takes that sum in f64, and the tree
//! where the sum does not serve; `certificate` tests the arctangents of `halves`; every other file
//! is a branch, or what branches share.

mod brdf;
#[cfg(test)]
mod certificate;
mod double;
mod edges;
mod frame;
mod halves;
mod height;
mod lanes;
mod secant;
mod segment;
mod strip;
mod thin;
mod tree;
