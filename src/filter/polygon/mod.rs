//! GGX averaged over a parallelogram: the tree of cases, and its branches.
//!
//! Layer 3. [`tree`] chooses; every other file is one branch, or what branches share.

mod edges;
mod frame;
mod secant;
mod segment;
mod strip;
mod thin;
mod tree;
