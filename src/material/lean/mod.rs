//! LEAN: normal maps as moments of slopes, from texels to lobes (feature `lean`).
//!
//! Texels become slopes ([`SlopeCap`], [`HeightField`]), slopes a mip chain of means and
//! covariances ([`MomentMap`]), a footprint's moments a lobe
//! ([`SlopeMoments::lobe`](crate::SlopeMoments::lobe)). [`Storage`] writes the same as raw moments,
//! which filtering hardware may interpolate, and reads them again.
//!
//! # Count resolved detail once
//!
//! Kaplanyan et al. 2016 (Eq. 21) nest two kernels: the normal map's covariance and that of the
//! pixel. Both are sums: `moments.lobe(base).widened(&kernel)` is $A_{base} + 2\Sigma_{map} +
//! 2\Sigma_{pixel}$, exact for Beckmann, for GGX with the peak too bright; with the right one, both
//! as one kernel:
//!
//! ```
//! use lobe::{Footprint, Kernel, Lobe, PixelFilter, Roughness, SlopeMoments};
//! let base = Roughness::from_alpha(0.1_f32)?;
//! let patch =
//!     SlopeMoments::new([0.2, 0.0], Roughness::from_sigma_rho(0.1, 0.05, 0.3)?.covariance())?;
//! let pixel = Kernel::of(&Footprint::rectangle([0.1, 0.2]), PixelFilter::BOX);
//! let beckmann = patch.lobe(base).widened(&pixel);
//! let both = Kernel::from_covariance(patch.covariance()) + pixel;
//! let ggx = Lobe::new(patch.mean(), base.peak_fitted(&both))?;
//! assert!(ggx.roughness().alphas().major > beckmann.roughness().alphas().major);
//! # Ok::<(), lobe::Error>(())
//! ```
//!
//! But a pixel in which the map's slope changes by $d\mu$ has that change in $\Sigma_{map}$ if
//! the level of detail matches the pixel, and in $\Sigma_{pixel}$, too, if the kernel comes from
//! derivatives of the *mapped* normal, as shaders' `dFdx` after normal mapping gives it. Two ways
//! count it once:
//!
//! - moments at the pixel's level of detail, and a kernel of the *geometric* frame's motion: the
//!   slope of the half vector in that frame
//!   ([`Footprint::from_half_vectors`](crate::Footprint::from_half_vectors)), which the map does
//!   not move as the lobe's mean carries it. The default; nothing is lost below a texel or beyond a
//!   pixel;
//! - moments of the finest level, and a kernel of $d(s_h - \mu)$, the motion of the half vector's
//!   slope against the mean's: a difference of footprints. For maps that are magnified.
//!
//! Source: Olano & Baker 2010; Kaplanyan et al. 2016, section 5.5; Dupuy et al. 2013.

mod half;
mod height;
mod level;
mod map;
mod sample;
mod storage;
mod texel;
mod weight;
mod weighted;

pub use height::HeightField;
pub use map::{Border, MomentMap};
pub use storage::{Float16, Float32, Storage, Unorm16};
pub use texel::{ClippedTexels, NormalTexel, SlopeCap};
