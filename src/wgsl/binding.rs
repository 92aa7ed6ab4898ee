//! Where a text's buffer is bound.
//!
//! Floor 0.

use alloc::format;
use alloc::string::String;

/// How the declaration of the one buffer begins in the texts.
const BOUND: &str = "@group(1) @binding(0) var<storage, read> lobe_dictionary";

/// A text with the buffer of its dictionary at another place than group 1, binding 0.
///
/// Texts with a dictionary of marginals ([`Item::DictionaryMarginal`](super::Item::DictionaryMarginal)) declare the one
/// binding that the mirror has; others come back as they are.
///
/// ```
/// use lobe::wgsl::{Item, rebound, source};
/// let text = source(&[Item::MarginalDensity]);
/// assert!(text.contains("@group(1) @binding(0) var<storage, read> lobe_dictionary: array<vec2f>;"));
/// let text = rebound(&text, 0, 7);
/// assert!(text.contains("@group(0) @binding(7) var<storage, read> lobe_dictionary: array<vec2f>;"));
/// ```
pub fn rebound(text: &str, group: u32, binding: u32) -> String {
    text.replace(
        BOUND,
        &format!("@group({group}) @binding({binding}) var<storage, read> lobe_dictionary"),
    )
}
