//! What is written rather than computed: the texts of the WGSL port, the layers of `src`, tables in
//! the documentation.

#[path = "../common/mod.rs"]
mod common;
#[cfg(feature = "wgsl")]
#[allow(dead_code, reason = "shared with the example wgsl")]
#[path = "../../examples/wgsl/entry.rs"]
mod entry;
#[cfg(feature = "wgsl")]
#[allow(dead_code, reason = "shared with the example wgsl")]
#[path = "../../examples/wgsl/link.rs"]
mod link;
#[cfg(feature = "wgsl")]
#[allow(dead_code, reason = "shared with the example wgsl")]
#[path = "../../examples/wgsl/translate.rs"]
mod translate;

mod documents;
mod imports;
mod layers;
mod layouts;
mod modules;
mod source;
mod surface;
mod twins;
mod wgsl;
mod wgsl_text;
mod written;
