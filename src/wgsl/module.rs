//! The files of the WGSL port, as a linker takes them.
//!
//! Layer 0.

use super::declaration::{Declaration, declarations, uses};
use alloc::collections::BTreeMap;
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt::Write as _;

/// A file of the WGSL port, twin of the Rust file of the same path.
///
/// One body, three headers: [`Module::body`] is raw WGSL for whoever concatenates texts,
/// [`Module::wesl`] has `import` statements before it (WESL; Bevy from 0.20), [`Module::naga_oil`]
/// has `#define_import_path` and `#import` (Bevy before that).
///
/// ```
/// use lobe::wgsl::Module;
/// let ggx = Module::ALL
///     .iter()
///     .find(|module| module.path() == "ndf/ggx")
///     .expect("a file of the WGSL port");
/// assert!(ggx.body().contains("fn lobe_ggx_d("));
/// assert!(ggx.wesl().starts_with("import super::distribution::{"));
/// assert!(ggx.naga_oil().starts_with("#define_import_path lobe::ndf::ggx\n#import lobe::"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Module {
    path: &'static str,
    body: &'static str,
}

/// Each path once: the text is that of the file.
macro_rules! modules {
    ($($(#[$gate:meta])? $path:literal,)*) => {
        impl Module {
            /// Every module, callees before callers.
            pub const ALL: &'static [Self] = &[
                $($(#[$gate])? Self { path: $path, body: include_str!(concat!($path, ".wgsl")) },)*
            ];
        }
    };
}

modules! {
    "scalar/real",
    "scalar/exp",
    "scalar/ln",
    #[cfg(feature = "glint")]
    "scalar/hash",
    #[cfg(feature = "glint")]
    "scalar/quantile",
    "scalar/atan",
    "scalar/erfc",
    "scalar/expint",
    "scalar/exact",
    "scalar/quadrature",
    "scalar/psd",
    "scalar/eigen",
    "slope/direction",
    "slope/jacobian",
    "slope/footprint",
    "slope/motion",
    "slope/path",
    "slope/ray",
    "slope/roughness",
    "slope/shape",
    "slope/anisotropic",
    "slope/widened",
    "slope/non_centered",
    "slope/lobe",
    "slope/moments",
    "slope/algebra",
    "slope/mean_frame",
    "ndf/distribution",
    "ndf/masking",
    "ndf/cavity",
    "ndf/ggx",
    "ndf/beckmann",
    "filter/kernel",
    "filter/gaussian",
    "filter/disk",
    "filter/projected",
    "filter/light",
    "filter/polygon/segment",
    "filter/polygon/strip",
    "filter/polygon/frame",
    "filter/polygon/thin",
    "filter/polygon/edges",
    "filter/groove",
    "filter/polygon/secant",
    "filter/polygon/tree",
    "filter/polygon/brdf",
    "filter/polygon/lanes",
    "filter/polygon/height",
    "filter/proxy",
    "filter/beckmann",
    "filter/deferred",
    #[cfg(feature = "published")]
    "filter/length",
    #[cfg(feature = "published")]
    "filter/engine",
    #[cfg(feature = "published")]
    "filter/kaplanyan",
    "material/fresnel",
    "material/lean/storage",
    "material/leadr/surface",
    "material/leadr/lod",
    #[cfg(feature = "glint")]
    "material/cells/cell",
    #[cfg(feature = "glint")]
    "material/cells/tile",
    #[cfg(feature = "glint")]
    "material/cells/patch",
    #[cfg(feature = "glint")]
    "material/glint/binomial",
    #[cfg(feature = "glint")]
    "material/glint/biscale",
    #[cfg(feature = "glint")]
    "material/glint/color",
    #[cfg(feature = "glint")]
    "material/glint/level",
    #[cfg(feature = "glint")]
    "material/glint/grid",
    #[cfg(feature = "glint")]
    "material/glint/light",
    #[cfg(feature = "glint")]
    "material/glint/glints",
    #[cfg(feature = "glint")]
    "material/glint/ndf",
    #[cfg(feature = "glint")]
    "material/glint/sparkle",
    #[cfg(feature = "glint")]
    "material/multilobe/dictionary",
    #[cfg(feature = "glint")]
    "material/multilobe/marginal",
    #[cfg(feature = "glint")]
    "material/multilobe/material",
    #[cfg(feature = "glint")]
    "material/multilobe/ellipse",
    #[cfg(feature = "glint")]
    "material/multilobe/cells",
    #[cfg(feature = "glint")]
    "material/multilobe/pieces",
    #[cfg(feature = "glint")]
    "material/multilobe/plane",
    #[cfg(feature = "glint")]
    "material/multilobe/ndf",
    #[cfg(feature = "glint")]
    "material/multilobe/sample",
    "shade/material",
    #[cfg(feature = "glint")]
    "shade/glints",
    #[cfg(feature = "glint")]
    "shade/multilobe",
    "fragment",
    #[cfg(feature = "glint")]
    "fragment/glints",
}

impl Module {
    /// Path of the file below `src/wgsl`, without its ending: `scalar/psd`.
    pub const fn path(&self) -> &'static str {
        self.path
    }

    /// The text: plain WGSL, which uses names of other modules.
    pub const fn body(&self) -> &'static str {
        self.body
    }

    /// The text for WESL's linkers, with imports relative to a package in which the files lie as
    /// they do here.
    pub fn wesl(&self) -> String {
        let home: Vec<&str> = self.path.split('/').collect();
        let up = alloc::vec!["super"; home.len()].join("::");
        let mut text = String::new();
        for (path, names) in self.imports() {
            let there: Vec<&str> = path.split('/').collect();
            // A sibling is one step away, other modules start from the root.
            let sibling =
                there.len() == home.len() && there[..there.len() - 1] == home[..home.len() - 1];
            let place = if sibling {
                format!("super::{}", there[there.len() - 1])
            } else {
                format!("{up}::{}", there.join("::"))
            };
            let _ = writeln!(text, "import {place}::{{{}}};", names.join(", "));
        }
        text.push_str(self.body);
        text
    }

    /// The text for naga_oil's composer, as the module `lobe::` and its path.
    ///
    /// The composer takes a module after those that it imports: add the modules in the order of
    /// [`Module::ALL`].
    ///
    /// ```
    /// use lobe::wgsl::Module;
    /// let mut known = Vec::new();
    /// for module in Module::ALL {
    ///     let text = module.naga_oil();
    ///     let imports = text.lines().filter_map(|line| line.strip_prefix("#import "));
    ///     assert!(
    ///         imports
    ///             .map(|line| line.split("::{").next())
    ///             .all(|path| known.contains(&path.map(String::from)))
    ///     );
    ///     known.push(Some(format!("lobe::{}", module.path().replace('/', "::"))));
    /// }
    /// ```
    pub fn naga_oil(&self) -> String {
        let mut text = format!("#define_import_path lobe::{}\n", self.path.replace('/', "::"));
        for (path, names) in self.imports() {
            let place = path.replace('/', "::");
            let _ = writeln!(text, "#import lobe::{place}::{{{}}}", names.join(", "));
        }
        text.push_str(self.body);
        text
    }

    /// The modules whose names this one uses.
    ///
    /// ```
    /// use lobe::wgsl::Module;
    /// let exp = Module::ALL
    ///     .iter()
    ///     .find(|module| module.path() == "scalar/exp")
    ///     .expect("a file of the WGSL port");
    /// assert_eq!(exp.dependencies(), ["scalar/real"]);
    /// ```
    pub fn dependencies(&self) -> Vec<&'static str> {
        self.imports().into_iter().map(|(path, _)| path).collect()
    }

    /// Names that this module takes from others, by their paths.
    fn imports(&self) -> Vec<(&'static str, Vec<&'static str>)> {
        let homes: BTreeMap<&str, &'static str> = Self::ALL
            .iter()
            .flat_map(|module| declarations(module.body).into_iter().map(|d| (d.name, module.path)))
            .collect();
        let mut found: BTreeMap<&'static str, Vec<&'static str>> = BTreeMap::new();
        for Declaration { code, .. } in declarations(self.body) {
            for name in uses(code) {
                match homes.get(name) {
                    Some(&path) if path != self.path => {
                        let names = found.entry(path).or_default();
                        if !names.contains(&name) {
                            names.push(name);
                        }
                    }
                    _ => {}
                }
            }
        }
        found.into_iter().collect()
    }
}
