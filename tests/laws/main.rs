//! Laws of the library, its golden tables, the errata of the papers, and the fuzzers' corpus: one
//! module for each subject.
//!
//! `cargo test --test laws SUBJECT::` runs one module. All of them stand in one binary, because
//! each binary compiles the oracles and the generator of inputs again.

#[path = "../budget.rs"]
mod budget;
#[path = "../common/mod.rs"]
mod common;
#[path = "../common/fuzz_laws/mod.rs"]
mod fuzz_laws;
#[path = "../common/roundings.rs"]
mod roundings;
#[path = "../common/tables/mod.rs"]
mod tables;

mod algebra;
mod backward;
mod batch;
mod binomial;
mod cells;
mod certificates;
mod constructors;
mod corpus;
mod deferred;
mod dictionary;
mod dictionary_bytes;
mod double;
mod errata;
mod errata_glints;
mod errata_leadr;
mod errata_multilobe;
mod filter;
mod generator;
mod glint_grid;
mod glint_limits;
mod glints;
mod golden;
mod groove;
mod jacobian;
mod lanes;
mod leadr;
mod lean;
mod length;
mod light;
mod light_maps;
mod limits;
mod marginal;
mod masking;
mod mean_frame;
mod motion;
mod multilobe;
mod multilobe_ends;
mod multilobe_limits;
mod multilobe_mean;
mod multilobe_sampling;
mod multilobe_scales;
mod ndf;
mod over;
mod polygon;
mod precision;
mod probe;
mod projected;
mod proxy;
mod proxy_limits;
mod psd;
mod quadrature;
mod ray;
mod rotation;
mod scalar;
mod serde;
mod shade;
mod storage;
mod tiles;
mod weights;
mod zirr_kaplanyan;
