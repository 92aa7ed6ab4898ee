//! Filters: a lobe averaged over what a pixel covers.
//!
//! - Gaussian kernels widen a lobe into another lobe: [`Kernel`],
//!   [`Lobe::widened`](crate::Lobe::widened); with the peak right,
//!   [`Roughness::peak_fitted`](crate::Roughness::peak_fitted); on the projected disk,
//!   [`DiskKernel`]. Area lights are kernels, too: [`SphericalGaussian`].
//! - Polygons average its density exactly:
//!   [`Ndf::parallelogram_mean`](crate::Ndf::parallelogram_mean),
//!   [`Ndf::brdf_over`](crate::Ndf::brdf_over).
//! - Before the light is known, roughness is filtered by the normal's change: `*_deferred_alpha`.
//! - What papers and engines have, to reproduce and to compare: `kaplanyan_*`, [`engine`].

mod beckmann;
pub(crate) mod deferred;
mod disk;
#[cfg(feature = "published")]
pub mod engine;
mod gaussian;
mod groove;
#[cfg(feature = "published")]
mod kaplanyan;
mod kernel;
#[cfg(feature = "published")]
mod length;
mod light;
mod polygon;
mod projected;
mod proxy;

pub use beckmann::beckmann_rectangle_mean;
pub use deferred::{
    ShadingFrame, kaplanyan_deferred_alpha, kaplanyan_deferred_alphas, largest_deferred_alpha,
    quad_normal_footprint, tokuyoshi_deferred_alpha, tokuyoshi_kaplanyan_deferred_alpha,
};
pub use disk::DiskKernel;
pub use gaussian::ggx_gaussian_mean;
#[cfg(feature = "published")]
pub use kaplanyan::{
    kaplanyan_proxy_alpha, kaplanyan_rectangle_mean, kaplanyan_rectangle_mean_as_printed,
};
pub use kernel::{Kernel, PixelFilter};
#[cfg(feature = "published")]
pub use length::{
    MEAN_LENGTH_TOLERANCE, VmfWidening, clean_variance, toksvig_exponent, toksvig_variance,
    vmf_sharpness,
};
pub use light::SphericalGaussian;
pub use projected::projected_alpha;
pub use proxy::{box_peak_alpha, gaussian_peak_alpha};
