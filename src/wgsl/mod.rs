//! The same functions in WGSL, and nothing that a scene does not need.
//!
//! Layer 0, feature `wgsl`; needs an allocator, no other crate. Every function of this crate that a
//! shader can use has a twin: `src/X.rs` and `src/wgsl/X.wgsl`, function by function, named
//! `lobe_`, the type and the method ([`names`] is the table). The texts have no entry points, no
//! directives and, but for a dictionary ([`rebound`]), no bindings, so they go into any shader,
//! after its directives; [`source`] returns the functions asked for with all that they call, and
//! [`Module`] the files for linkers.
//!
//! ```
//! use lobe::wgsl::{Item, source};
//! let text = source(&[Item::GgxBrdf, Item::IsotropicNew, Item::IsotropicPair]);
//! assert!(text.contains("fn lobe_ggx_brdf(") && !text.contains("beckmann"));
//! let shader = format!("{text}
//! @fragment fn main(@location(0) wo: vec3f, @location(1) wi: vec3f) -> @location(0) vec4f {{
//!     let brdf = lobe_ggx_brdf(lobe_isotropic_pair(lobe_isotropic_new(0.1), wo, wi));
//!     return vec4f(vec3f(brdf * wi.z), 1.0);
//! }}");
//! # naga::front::wgsl::parse_str(&shader).expect("valid WGSL");
//! ```
//!
//! What differs from Rust, and where:
//!
//! - **Generic functions** are split in two: a shape answers (`lobe_anisotropic_normal`, `_view`,
//!   `_pair`, and `_slope_over`, `_pair_over` for means in lanes), a distribution makes a number of
//!   the answers: `lobe_ggx_d(lobe_anisotropic_normal(shape, m))`. So a shader holds the shape that
//!   its material has, and no other. The polygon means that branch take `LobeNonCentered`.
//! - **Names end in letters**, as translators mark digits: G1 and G2 are `_masking` and
//!   `_masking_shadowing`, `atan2` is `lobe_atan_of`.
//! - **Constructors do not fail**: numbers outside their range count as the nearest inside, NaN as
//!   0, and where Rust returns an error the result is 0 or a zero footprint. The comment of each
//!   function says so. No item returns NaN, whatever numbers it is given; but `lobe_min` and
//!   `lobe_max` pass on that of their second argument, as Rust's do. Structures are the WGSL port's
//!   to make: what a caller writes into one is not looked at again. Compilers that assume numbers,
//!   as Metal's with fast math and HLSL's without strict IEEE do, may drop that promise for an
//!   input that is NaN or infinite; for finite inputs it holds there, too, as no guard waits for a
//!   NaN or an infinity.
//! - **Matrices** have their columns first, as WGSL has it; `matrix * vector` means the same.
//! - **Pixel filters** are passed as their variance: `LOBE_PIXEL_FILTER_BOX` and the like.
//! - **A dictionary** of marginals is a buffer, `lobe_dictionary`, filled with `Dictionary::nodes`,
//!   or a texture for WebGL 2 ([`textured`]); values of `LobeDictionary` are its sizes.
//! - **Closures** are not passed: cells of a grid are a loop, and colored glints have the hue
//!   wheel.
//! - `lobe_fragment_*` take derivatives from the quad, for fragment shaders; CPUs have no quads.
//!
//! Equal to Rust in f32 to the bit where no operation is fused or reordered, and quotients and
//! roots are rounded correctly; within a few roundings where compilers and drivers do otherwise
//! (`tests/gpu`, which runs every twin).

mod binding;
mod declaration;
mod error;
mod item;
mod list;
mod module;
mod preset;
mod table;
mod text;

#[doc = include_str!("names.md")]
pub mod names {}

pub use binding::{rebound, textured};
pub use error::Error;
pub use item::Item;
pub use module::Module;
pub use preset::Preset;
pub use text::source;
