//! glam's matrices from ours and back (feature `glam`).
//!
//! Layer 0.

use super::Psd;
use crate::error::Error;

macro_rules! impl_glam {
    ($real:ty, $mat:ty) => {
        impl From<Psd<$real>> for $mat {
            fn from(m: Psd<$real>) -> Self {
                let [xx, xy, yy] = m.entries();
                Self::from_cols_array(&[xx, xy, xy, yy])
            }
        }

        impl TryFrom<$mat> for Psd<$real> {
            type Error = Error;

            /// Reads the symmetric part.
            fn try_from(m: $mat) -> Result<Self, Error> {
                let [xx, yx, xy, yy] = m.to_cols_array();
                Self::new(xx, 0.5 * (xy + yx), yy)
            }
        }
    };
}

impl_glam!(f32, glam::Mat2);
impl_glam!(f64, glam::DMat2);
