//! The files of the WGSL port that items need, with the headers of a linker.

use super::entry::declared;
use lobe::wgsl::{Item, Module};
use std::collections::BTreeSet;

/// Whose imports.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Linker {
    /// WESL: files `.wesl`.
    Wesl,
    /// naga_oil: files `.wgsl` that name their own import path.
    NagaOil,
}

impl Linker {
    /// A module's text.
    pub(crate) fn text(self, module: Module) -> String {
        match self {
            Self::Wesl => module.wesl(),
            Self::NagaOil => module.naga_oil(),
        }
    }

    /// A module's file, from the folder that all are in.
    pub(crate) fn file(self, module: Module) -> String {
        let ending = if self == Self::Wesl { "wesl" } else { "wgsl" };
        format!("{}.{ending}", module.path())
    }
}

/// The modules of these items and all that they import, in the order in which a composer takes
/// them.
pub(crate) fn needed(items: &[Item]) -> Vec<Module> {
    let wanted: BTreeSet<String> = items.iter().flat_map(|item| declared(*item)).collect();
    let holds = |module: &Module| super::entry::names(module.body()).any(|n| wanted.contains(n));
    let mut paths: BTreeSet<&str> = BTreeSet::new();
    let mut open: Vec<&str> = Module::ALL.iter().filter(|m| holds(m)).map(Module::path).collect();
    while let Some(path) = open.pop() {
        if paths.insert(path) {
            let module = Module::ALL.iter().find(|module| module.path() == path);
            open.extend(module.into_iter().flat_map(Module::dependencies));
        }
    }
    Module::ALL.iter().copied().filter(|module| paths.contains(module.path())).collect()
}
