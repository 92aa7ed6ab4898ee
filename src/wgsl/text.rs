//! The text of items, with all that they use.
//!
//! Layer 0.

use super::declaration::{Declaration, declarations, uses};
use super::item::Item;
use super::module::Module;
use alloc::collections::{BTreeMap, BTreeSet};
use alloc::string::String;
use alloc::vec::Vec;

/// The WGSL text of these items and of everything they use, each once and in the order of the
/// files; nothing else.
///
/// No entry points, no directives, and no bindings but a dictionary's buffer: append your shader to
/// it. The same items in any order, or twice, give the same text; none give an empty one.
///
/// ```
/// use lobe::wgsl::{Item, source};
/// let text = source(&[Item::GgxD]);
/// assert!(text.contains("fn lobe_ggx_d(") && text.contains("fn lobe_ggx_density("));
/// assert!(!text.contains("fn lobe_ggx_brdf("));
/// assert!(source(&[]).is_empty());
/// ```
pub fn source(items: &[Item]) -> String {
    let files: Vec<(&'static str, Vec<Declaration>)> =
        Module::ALL.iter().map(|module| (module.path(), declarations(module.body()))).collect();
    let by_name: BTreeMap<&str, &Declaration> =
        files.iter().flat_map(|(_, all)| all.iter().map(|d| (d.name, d))).collect();
    let mut wanted: BTreeSet<&'static str> = BTreeSet::new();
    let asked = items.iter().flat_map(|item| item.declared());
    let mut open: Vec<&Declaration> =
        asked.filter_map(|name| by_name.get(name.as_str()).copied()).collect();
    while let Some(declaration) = open.pop() {
        if wanted.insert(declaration.name) {
            open.extend(uses(declaration.code).filter_map(|name| by_name.get(name).copied()));
        }
    }
    let mut text = String::new();
    for declaration in files.iter().flat_map(|(_, all)| all) {
        if wanted.contains(declaration.name) {
            if !text.is_empty() {
                text.push('\n');
            }
            text.push_str(declaration.whole);
        }
    }
    text
}
