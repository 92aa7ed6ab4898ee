//! What most callers need, for `use lobe::prelude::*`.
//!
//! Types and traits of the core, from roughness to distributions. [`Error`](crate::Error) is left
//! out, as callers have one of their own, and [`Real`](crate::Real), whose methods would meet those
//! of other traits over floats; so is everything that a scene may or may not need.
//!
//! ```
//! use lobe::prelude::*;
//! let lobe = Lobe::centered(Roughness::from_alpha(0.1_f32)?);
//! let pixel = Kernel::of(&Footprint::rectangle([0.1, 0.2]), PixelFilter::BOX);
//! let up = [0.0, 0.0, 1.0];
//! assert!(Ggx::from(lobe.widened(&pixel)).brdf(up, up) < Ggx::from(lobe).brdf(up, up));
//! # Ok::<(), lobe::Error>(())
//! ```

pub use crate::filter::{Kernel, PixelFilter};
pub use crate::ndf::{Beckmann, Distribution, Ggx, Ndf};
pub use crate::scalar::Psd;
pub use crate::slope::{
    Anisotropic, AxisAligned, Footprint, Isotropic, Lobe, LobeShape, NonCentered, Roughness,
    SlopeMoments,
};
