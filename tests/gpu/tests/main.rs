//! The WGSL port on Vulkan drivers and in engines' linkers: one binary, so that wgpu is linked
//! once.

#[allow(dead_code, reason = "shared with the example wgsl")]
#[path = "../../../examples/wgsl/entry.rs"]
mod entry;
#[allow(dead_code, reason = "shared with the example wgsl")]
#[path = "../../../examples/wgsl/link.rs"]
mod link;
#[allow(dead_code, reason = "shared with the example wgsl")]
#[path = "../../../examples/wgsl/translate.rs"]
mod translate;

mod dictionary;
mod engines;
mod fast_math;
mod harness;
mod instructions;
mod render;
mod twins;
