//! Distributions of normals: density, masking and shadowing for every roughness and mean.

mod beckmann;
mod cavity;
mod distribution;
mod ggx;
mod masking;

pub use beckmann::BeckmannDistribution;
pub use cavity::{cavity_masking, cavity_masking_shadowing};
pub use distribution::{Distribution, Ndf};
pub use ggx::GgxDistribution;

/// Beckmann over a shape: Gaussian slopes, $A = 2\Sigma$.
///
/// ```
/// use lobe::{Beckmann, Isotropic};
/// let ndf = Beckmann::new(Isotropic::new(0.5_f64)?);
/// assert!((ndf.slope_pdf([0.0, 0.0]) - 4.0 / core::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), lobe::Error>(())
/// ```
pub type Beckmann<S> = Ndf<BeckmannDistribution, S>;

/// GGX (Trowbridge-Reitz) over a shape: Student-t slopes with two degrees of freedom.
///
/// The means over what a pixel covers, [`Ndf::parallelogram_mean`] and [`Ndf::brdf_over`], are
/// implemented in `filter/polygon`.
///
/// ```
/// use lobe::{Ggx, Isotropic};
/// let ndf = Ggx::new(Isotropic::new(0.25_f32)?);
/// let up = [0.0, 0.0, 1.0];
/// // At normal incidence nothing is masked: D(n) / 4.
/// assert!((ndf.brdf(up, up) - 4.0 / core::f32::consts::PI).abs() < 1e-6);
/// # Ok::<(), lobe::Error>(())
/// ```
#[doc(alias = "Trowbridge-Reitz")]
#[doc(alias = "GTR2")]
pub type Ggx<S> = Ndf<GgxDistribution, S>;
