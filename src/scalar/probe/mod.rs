//! Precisions that measure: operations, contraction, rounding. For reports and checks, not for
//! shading.
//!
//! Layer 0, feature `probe`. Three further types of the trait [`Real`](crate::Real), each an f32 in
//! disguise, so that every function of this crate runs on them as it stands:
//!
//! | | answers |
//! |---|---|
//! | [`Counted`] | how many operations is this? |
//! | [`Fused`] | what would a GPU compute that fuses every product into the sum after it? |
//! | [`Rounded`] | how much of this value may be rounding? |
//!
//! The last two judge one formula on two machines: two results of it differ by at most twice the
//! bound.
//!
//! ```
//! use lobe::probe::{Fused, Rounded};
//! use lobe::{Ggx, Isotropic, Real};
//! fn pdf<R: Real>(of: fn(f32) -> R) -> Result<R, lobe::Error> {
//!     Ok(Ggx::new(Isotropic::new(of(0.1))?).slope_pdf([of(0.05), of(0.3)]))
//! }
//! let (fused, rounded) = (pdf(Fused::new)?, pdf(Rounded::exact)?);
//! assert_eq!(rounded.value(), pdf(|x| x)?);
//! assert!(f64::from(fused.value() - rounded.value()).abs() <= 2.0 * rounded.bound());
//! # Ok::<(), lobe::Error>(())
//! ```

mod counted;
mod fused;
mod rounded;

pub use counted::{Counted, Operations, operations_of};
pub use fused::Fused;
pub use rounded::Rounded;
