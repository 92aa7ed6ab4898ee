//! WGSL on Vulkan drivers, for tests: the shaders of `lobe` against its Rust code.
//!
//! Two ways lead from WGSL to a driver. [`Mode::Shipped`] is what engines do: wgpu compiles the
//! text, and driver compilers may rewrite float arithmetic, so results are compared within
//! tolerances. [`Mode::Exact`] forbids every rewrite: results of + - * / and sqrt equal Rust's f32
//! bit for bit.
//!
//! The drivers are lavapipe, which tests need, and SwiftShader and real GPUs where they are
//! present.

pub mod compute;
pub mod cpp;
pub mod device;
mod dictionary;
pub mod exact;
pub mod render;
#[path = "../../common/size.rs"]
pub mod size;
pub mod timing;
pub mod tools;
pub mod twins;

#[path = "../../common/arbitrary.rs"]
#[allow(dead_code, unreachable_pub, reason = "shared with the law tests, which use the rest")]
mod arbitrary;
mod buffer;
mod needs;
mod shader;

pub use compute::{Job, Kernel};
pub use device::{Driver, Gpu};
pub use needs::needed;
pub use render::Painter;
pub use shader::Mode;
