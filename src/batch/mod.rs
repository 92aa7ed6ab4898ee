//! Batches: the same evaluation for every element of columns, in lanes.
//!
//! Layer 5. Renderers that keep an array for each number of their pixels, and tools that widen
//! whole maps, hand the arrays over as they are. Names are those of one element: [`Isotropic`] here
//! is a column of [`lobe::Isotropic`](crate::Isotropic), [`Ggx`] a [`lobe::Ggx`](crate::Ggx) over
//! such columns.
//!
//! | Columns of | are |
//! |---|---|
//! | numbers | `&[R]`, or [`Fixed`] for all elements |
//! | slopes, directions | `[&x, &y]`, `[&x, &y, &z]`, or [`Fixed`] |
//! | footprints | [`Footprint`] |
//! | shapes | [`Isotropic`], [`AxisAligned`], [`Anisotropic`], [`SlopeMoments`] |
//! | shapes of shapes | [`NonCentered`], [`Widened`], [`WidenedToPeak`], [`WidenedOnDisk`] |
//!
//! | Written for every element | by |
//! |---|---|
//! | density, masking, the BRDF, filtered or not | [`Ndf`] |
//! | roughness under footprints | [`widened`], [`peak_fitted`], [`widened_on_disk`] |
//! | alphas of a G-buffer | `*_deferred_alpha`, [`kaplanyan_deferred_alphas`] |
//!
//! What is written equals the functions of one element to the bit, whatever the length and the
//! instructions; columns of different lengths are refused before anything is written. A number
//! beyond its range counts as the nearest in it, as the total constructors have it
//! ([`lobe::Isotropic::saturating`](crate::Isotropic::saturating)): a batch has no element to
//! refuse.
//!
//! Loops are compiled for the target. With the feature `dispatch` they are also compiled for AVX2,
//! with `avx512` for AVX-512, and the machine's best is chosen at each call; on the default target
//! of x86-64, whose lanes are four f32 wide, that makes them about twice as fast.
//!
//! ```
//! use lobe::PixelFilter;
//! use lobe::batch::{Fixed, Footprint, Ggx, Isotropic, Widened};
//! // Four pixels: alpha, the half vector's derivatives, and the direction to the viewer.
//! let alpha = [0.05_f32, 0.1, 0.2, 0.4];
//! let (across, along, zero) = ([0.1_f32; 4], [0.02; 4], [0.0; 4]);
//! let (x, z) = ([0.0_f32, 0.1, 0.2, 0.28], [1.0, 0.995, 0.98, 0.96]);
//! let footprints = Footprint { u: [&across[..], &zero], v: [&zero[..], &along] };
//! let shapes = Widened { shapes: Isotropic(&alpha[..]), footprints, filter: PixelFilter::BOX };
//! let (wo, wi) = ([&x[..], &zero, &z], Fixed([0.0, 0.0, 1.0]));
//! let mut brdf = [0.0; 4];
//! Ggx::new(shapes).brdf(wo, wi, &mut brdf)?;
//!
//! // The same of one pixel.
//! let footprint = lobe::Footprint::from_slopes([0.1, 0.0], [0.0, 0.02]);
//! let kernel = lobe::Kernel::of(&footprint, PixelFilter::BOX);
//! let shape = kernel.widen(lobe::Isotropic::new(0.2)?);
//! assert_eq!(brdf[2], lobe::Ggx::new(shape).brdf([0.2, 0.0, 0.98], [0.0, 0.0, 1.0]));
//! # Ok::<(), lobe::Error>(())
//! ```

mod columns;
mod deferred;
mod fill;
mod moments;
mod ndf;
mod roughness;
mod shape;
mod widened;

pub use columns::{Columns, Fixed};
pub use deferred::{
    kaplanyan_deferred_alpha, kaplanyan_deferred_alphas, largest_deferred_alpha,
    tokuyoshi_deferred_alpha, tokuyoshi_kaplanyan_deferred_alpha,
};
pub use moments::SlopeMoments;
pub use ndf::{Beckmann, Ggx, Ndf};
pub use roughness::{Factors, peak_fitted, widened, widened_on_disk};
pub use shape::{Anisotropic, AxisAligned, Isotropic, NonCentered};
pub use widened::{Footprint, Widened, WidenedOnDisk, WidenedToPeak};
