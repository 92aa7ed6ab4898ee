//! Laws that take a fuzzer's bytes and panic if the library breaks them.
//!
//! The targets in fuzz/ run them on new inputs, tests/laws/corpus.rs on those that are kept.
#![allow(dead_code, unused_imports, reason = "each fuzz target calls one of the laws")]

mod bytes;
mod constructors;
mod facets;
mod glints;
mod maps;
mod precision;
mod valid;
mod widenings;

pub(crate) use constructors::constructors;
pub(crate) use facets::facets;
pub(crate) use glints::glints;
pub(crate) use maps::maps;
pub(crate) use precision::precision;
