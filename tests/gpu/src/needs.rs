//! What a piece of WGSL needs of the WGSL port.

use lobe::wgsl::{Item, source};

/// The functions and constants that `text` names, with all that they use, and nothing else.
///
/// ```
/// let library = lobe_gpu::needed("let a = lobe_projected_alpha(0.1, 0.2);");
/// assert!(library.contains("fn lobe_projected_alpha(") && !library.contains("fn lobe_psd_add("));
/// ```
pub fn needed(text: &str) -> String {
    let words: Vec<&str> = text.split(|c: char| !(c.is_ascii_alphanumeric() || c == '_')).collect();
    let named = |item: &&Item| {
        let name = item.name();
        words.iter().any(|word| {
            word.strip_prefix("lobe_")
                .or(word.strip_prefix("LOBE_"))
                .is_some_and(|word| word == name)
        })
    };
    source(&Item::ALL.iter().filter(named).copied().collect::<Vec<_>>())
}
