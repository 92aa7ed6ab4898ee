//! What can be asked for.
//!
//! Layer 0.

use super::declaration::declarations;
use super::error::Error;
use super::list::OFF;
use super::module::Module;
use super::table::Kind;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

pub use super::list::Item;

impl Item {
    /// The item's name: a function's or constant's without the prefix `lobe_` or `LOBE_`, or a
    /// file's path with `_` for `/`.
    ///
    /// ```
    /// use lobe::wgsl::Item;
    /// assert_eq!(Item::GgxD.name(), "ggx_d");
    /// assert_eq!(Item::PixelFilterBox.name(), "PIXEL_FILTER_BOX");
    /// assert_eq!(Item::FilterProjected.name(), "filter_projected");
    /// ```
    pub fn name(self) -> &'static str {
        self.entry().1
    }

    /// The item of a name, with the prefix or without it.
    ///
    /// ```
    /// use lobe::wgsl::Item;
    /// assert_eq!(Item::from_name("ggx_d"), Ok(Item::GgxD));
    /// assert_eq!(Item::from_name("lobe_ggx_d"), Ok(Item::GgxD));
    /// assert!(Item::from_name("ggx_e").is_err());
    /// ```
    ///
    /// # Errors
    /// [`Error::Unknown`], and [`Error::Off`] for an item behind a feature that is off.
    pub fn from_name(name: &str) -> Result<Self, Error> {
        let of = |name: &str| Self::ALL.iter().find(|item| item.name() == name).copied();
        let bare = name.strip_prefix("lobe_").or(name.strip_prefix("LOBE_"));
        if let Some(item) = of(name).or(bare.and_then(of)) {
            return Ok(item);
        }
        match OFF.iter().find(|(off, _)| *off == name) {
            Some(&(_, feature)) => Err(Error::Off { name: name.to_string(), feature }),
            None => Err(Error::Unknown(name.to_string())),
        }
    }

    /// What it stands for in Rust; `None` for files, and for what is WGSL's alone.
    ///
    /// ```
    /// use lobe::wgsl::Item;
    /// assert_eq!(Item::GgxD.twin(), Some("Ndf::d"));
    /// assert_eq!(Item::AnisotropicPair.twin(), None);
    /// ```
    pub fn twin(self) -> Option<&'static str> {
        let twin = self.entry().2;
        (!twin.is_empty()).then_some(twin)
    }

    /// The module that it stands for, if it is a file.
    ///
    /// ```
    /// use lobe::wgsl::Item;
    /// assert_eq!(Item::NdfGgx.module().map(|module| module.path()), Some("ndf/ggx"));
    /// assert_eq!(Item::GgxD.module(), None);
    /// ```
    pub fn module(self) -> Option<Module> {
        let (kind, name, _) = self.entry();
        let named = |module: &&Module| module.path().replace('/', "_") == name;
        Module::ALL.iter().filter(|_| kind == Kind::File).find(named).copied()
    }

    /// The declarations that it asks for by name: one, or all of a file.
    pub(super) fn declared(self) -> Vec<String> {
        let (kind, name, _) = self.entry();
        match kind {
            Kind::Function => alloc::vec![format!("lobe_{name}")],
            Kind::Constant => alloc::vec![format!("LOBE_{name}")],
            Kind::File => {
                let all = self.module().into_iter().flat_map(|module| declarations(module.body()));
                all.map(|declaration| declaration.name.to_string()).collect()
            }
        }
    }
}
