//! GGX averaged over a parallelogram: the tree of cases, and its branches.
//!
//! Layer 3. `tree` chooses; `brdf` shades by what it finds; `lanes` and `height` are both without a
//! branch, and less accurate; every other file is a branch, or what branches share.

mod brdf;
mod edges;
mod frame;
mod height;
mod lanes;
mod secant;
mod segment;
mod strip;
mod thin;
mod tree;
