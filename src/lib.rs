//! Microfacet lobes that can be filtered.
//!
//! A shiny surface seen through a pixel is a distribution of slopes. Where that distribution is
//! narrower than what the pixel covers, highlights flicker. This crate has the distributions
//! (Beckmann and GGX, any roughness matrix, any mean), the pixel's footprint on the slope plane,
//! and the filters that bring the two together: exact where a closed form exists, and otherwise
//! with a stated error.
//!
//! # A tour
//!
//! ```
//! use glam::Vec3;
//! use lobe::{Anisotropic, Footprint, Ggx, Kernel, Lobe, PixelFilter, Roughness};
//!
//! // A material: roughness from what the artist has, here perceptual roughness.
//! let lobe = Lobe::centered(Roughness::from_perceptual(0.1_f32)?);
//!
//! // A pixel: how the half vector's slope changes to the next pixels, by differences of half
//! // vectors.
//! let h = Vec3::new(0.02, 0.01, 1.0).normalize();
//! let right = Vec3::new(0.07, 0.01, 1.0).normalize();
//! let up = Vec3::new(0.03, 0.05, 1.0).normalize();
//! let footprint = Footprint::from_half_vectors(h, right, up)?;
//!
//! // One filter: the lobe widened by the pixel's Gaussian, then shaded as any other lobe.
//! let widened = lobe.widened(&Kernel::of(&footprint, PixelFilter::BOX));
//! let (wo, wi) = (Vec3::new(0.6, 0.0, 0.8), Vec3::new(-0.6, 0.0, 0.8));
//! let filtered = Ggx::new(widened.shape()).brdf(wo, wi);
//!
//! // Another: the lobe averaged over the footprint's parallelogram, exactly.
//! let ggx = Ggx::new(Anisotropic::new(lobe.roughness()));
//! let exact = ggx.brdf_over(wo, wi, &footprint);
//!
//! assert!(filtered < ggx.brdf(wo, wi) && exact < ggx.brdf(wo, wi));
//! # Ok::<(), lobe::Error>(())
//! ```
//!
//! - Upstream, everything ends in a [`Lobe`]: a mean slope and a [`Roughness`]. Footprints
//!   ([`Footprint`], [`Path`]) become kernels ([`Kernel`]), normal maps become [`SlopeMoments`],
//!   and both widen a lobe.
//! - Downstream, an [`Ndf`] ([`Ggx`] or [`Beckmann`]) over a [`LobeShape`] answers what shading
//!   asks: density, projected area, Lambda, G1, G2, visibility, the BRDF without Fresnel. Choose
//!   the shape the scene needs: [`Isotropic`] costs what hand-written isotropic code costs,
//!   [`Anisotropic`] takes any anisotropy, [`NonCentered`] any mean, and [`Kernel::widen`] puts any
//!   of them under a pixel.
//! - [`filter`] has the rest: exact means over polygons, proxies with the right peak, filtering on
//!   the projected disk, roughness for G-buffers, area lights, what engines ship, the papers'
//!   formulas as printed.
//! - [`material::lean`] makes moments of normal and displacement maps, with mip chains and
//!   textures; [`material::leadr`] shades displaced surfaces under lights and environments.
//! - [`material::glint`] has discrete details: snow, glitter, brushed metal, one evaluation a
//!   pixel, the mean of which is the smooth lobe.
//! - [`material::multilobe`] has the same from a dictionary of many-lobed densities, each of which
//!   integrates to 1: masked exactly, sampled, filtered over curvature, laid over normal maps.
//! - [`shade`] puts it together for a renderer that wants one call per light.
//! - [`batch`] evaluates arrays of elements, an array for each number, in lanes.
//! - [`mod@wgsl`] has all of it for shaders, and gives out what one needs.
//!
//! # Notation
//!
//! | Here | Means | Unit, range |
//! |---|---|---|
//! | `wo`, `wi` | directions to viewer and light | unit, tangent frame, normal +z |
//! | `h`, `m` | half vector, any normal | unit or not, as said |
//! | slope $s$ | $(-m_x/m_z, -m_y/m_z)$ | the plane; Kaplanyan and Tokuyoshi use $-s$ |
//! | `alpha` | roughness along an axis; 0 is a mirror | slope, \[0, 1e9\] |
//! | $A$ | roughness matrix, alphas squared along its axes | slope squared |
//! | $\Sigma$, `sigma` | slope covariance $A/2$ (Beckmann), deviation | slope squared, slope |
//! | $\mu$, `mean` | mean slope | slope |
//! | $q$ | $(s - \mu)^T A^{-1} (s - \mu)$ | 1 |
//! | $P_{22}$, `slope_pdf` | density of slopes | 1 / slope squared |
//! | $D$, `d` | density of normals, $P_{22}/m_z^4$ | 1 / solid angle |
//! | $\sigma(w)$, `projected_area` | area of the microsurface seen from $w$ | area |
//! | $c(w)$ | $w_z - \mu \cdot w_{xy}$, area of the mean plane seen from $w$ | area |
//! | $\Lambda$, `lambda` | $\sigma/c - 1$ (Smith) | 1 |
//! | `u`, `v` | derivatives of the slope, a footprint's sides | slope / pixel |
//! | `tile` | whole part of texture coordinates, which `uv` lacks | texture |
//! | `uv` | texture coordinates of a pixel | texture |
//! | `right`, `up` | change of `uv` to the next pixels | texture / pixel |
//! | $M$ | Chermain's matrix: slopes from those of a dictionary | slope |
//! | $A_g = A_m + A_l$ | glints: roughness from afar, of spread, of a detail | slope squared |
//!
//! Angles are radians, counter-clockwise. Matrices are rows first. Directions and slopes enter as
//! `impl Into<[R; 3]>` and `impl Into<[R; 2]>`: arrays, and the vectors of glam, nalgebra, mint and
//! others.
//!
//! # Precision
//!
//! Every function is written once for `f32` and `f64` ([`Real`]). Constructors refuse what they
//! cannot serve; evaluation is total: for finite input in the documented domain it never returns
//! NaN, infinity or a negative number. For alpha from 1e-4 to 30, correlations up to 0.9999, slopes
//! to 1e3 and footprints from 1e-5 to 1e2, two promises hold. Densities, areas, masking and BRDFs
//! of every shape are *backward* accurate: the result is exact for inputs and result moved by at
//! most 16 eps. [`slope::Compensated`] is *forward* accurate, for entries of A and means that are
//! exact in the precision; its relative errors, and those of means over polygons, are held to:
//!
//! | | f32 | f64 |
//! |---|---|---|
//! | GGX density, area, BRDF | 3e-5 | 1e-12 |
//! | Beckmann density, area, BRDF | 2e-4 | 1e-12 |
//! | means over polygons, lobe within ten alphas | 1e-5, rarely 1.2e-5 | 1e-9 |
//! | means over polygons anywhere | 1e-3 | 1e-9 |
//! | means of mirrors, grooves and alphas below 1e-9, in parts of one over the area | 1e-4 | 1e-9 |
//!
//! by tables from arbitrary precision, by property tests and by fuzzing; `cargo run --release
//! --example validate` prints what is measured.
//!
//! # Features
//!
//! | Feature | |
//! |---|---|
//! | `std` (default) | square root, sine and cosine from the standard library |
//! | `libm` | the same from `libm`, for `no_std` |
//! | `published` (default) | as printed and shipped: `filter::engine`, `filter::kaplanyan_*` |
//! | `lean` (default) | normal maps as moments, [`material::lean`]; needs an allocator |
//! | `leadr` (default) | displaced surfaces under lights and environments, [`material::leadr`] |
//! | `glint` (default) | [`material::glint`], [`material::multilobe`]; needs an allocator |
//! | `wgsl` (default) | the same functions in WGSL, as text: [`mod@wgsl`]; needs an allocator |
//! | `dispatch` | [`batch`] by the machine's best instructions up to AVX2, chosen at run time |
//! | `avx512` | the same up to AVX-512; needs Rust 1.89 |
//! | `probe` | precisions that count operations and bound rounding: for checks, not for shading |
//! | `serde` | `Serialize` and `Deserialize` of plain data, by constructors where there are any |
//! | `bytemuck` | plain structures for buffers, laid out as those of the port: `gpu` |
//! | `glam` | `From` and `TryFrom` between [`Psd`] and `glam::Mat2`, `glam::DMat2` |
//!
//! # What it is not
//!
//! No sampling of smooth lobes, no multiple scattering, no color spaces, no file formats, and no
//! filter chosen for you: which one a scene wants depends on what it may cost, and the report
//! (`cargo run --release -p lobe-report`) says what each costs and how wrong it is.
#![forbid(unsafe_code)]
#![no_std]
#[cfg(any(feature = "wgsl", feature = "lean", feature = "glint"))]
extern crate alloc;
#[cfg(feature = "std")]
extern crate std;

pub mod batch;
#[cfg(feature = "serde")]
mod data;
mod error;
pub mod filter;
#[cfg(feature = "bytemuck")]
pub mod gpu;
pub mod material;
pub mod ndf;
pub mod prelude;
mod scalar;
pub mod shade;
pub mod slope;
#[cfg(feature = "wgsl")]
pub mod wgsl;

pub use error::{Error, Value};
pub use filter::{Kernel, PixelFilter};
pub use ndf::{Beckmann, Distribution, Ggx, Ndf};
#[cfg(feature = "probe")]
pub use scalar::probe;
pub use scalar::{Eigen, Psd, Real};
pub use slope::{
    Alphas, Anisotropic, AxisAligned, Footprint, Isotropic, Lobe, LobeShape, NonCentered, Path,
    Roughness, SlopeMoments, Vertex,
};

/// The README's example is a test like any other.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
