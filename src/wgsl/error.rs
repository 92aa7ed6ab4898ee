//! Why a name is no item.
//!
//! Layer 0.

use alloc::string::String;
use core::fmt;

/// Why there is no item of a name.
///
/// ```
/// use lobe::wgsl::{Error, Item};
/// assert_eq!(Item::from_name("gx_d"), Err(Error::Unknown("gx_d".into())));
/// assert_eq!(Error::Unknown("gx_d".into()).to_string(), "no WGSL item is named `gx_d`");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// No item has this name.
    Unknown(String),
    /// The item exists behind a feature of this crate that is off.
    Off {
        /// The item.
        name: String,
        /// The feature.
        feature: &'static str,
    },
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown(name) => write!(f, "no WGSL item is named `{name}`"),
            Self::Off { name, feature } => {
                write!(f, "the WGSL item `{name}` needs the feature `{feature}` of lobe")
            }
        }
    }
}

impl core::error::Error for Error {}
