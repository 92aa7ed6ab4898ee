//! Where a text's dictionary is: at which binding, in a buffer or in a texture.
//!
//! Layer 0.

use alloc::format;
use alloc::string::String;

/// The declaration of the dictionary in the texts, but for its binding.
const BUFFER: &str = "var<storage, read> lobe_dictionary: array<vec2f>;";

/// The declaration of a dictionary in a texture.
const TEXTURE: &str = "var lobe_dictionary: texture_2d<f32>;";

/// The body of `lobe_dictionary_node`, which reads one node of the buffer.
const FROM_BUFFER: &str = "    return lobe_dictionary[place];
";

/// The body that reads the node from the texture.
const FROM_TEXTURE: &str = "    let width = textureDimensions(lobe_dictionary).x;
    let texel = vec2u(place % width, place / width);
    return textureLoad(lobe_dictionary, texel, 0).xy;
";

/// A text with its dictionary at another place than group 1, binding 0.
///
/// Texts with a dictionary of marginals (`Item::DictionaryMarginal`) declare the one binding that
/// the WGSL port has: a buffer or, after [`textured`], a texture. Other texts come back as they
/// are.
///
/// ```
/// # #[cfg(feature = "glint")] {
/// use lobe::wgsl::{Item, rebound, source};
/// let text = source(&[Item::MarginalDensity]);
/// assert!(
///     text.contains("@group(1) @binding(0) var<storage, read> lobe_dictionary: array<vec2f>;")
/// );
/// let text = rebound(&text, 0, 7);
/// assert!(
///     text.contains("@group(0) @binding(7) var<storage, read> lobe_dictionary: array<vec2f>;")
/// );
/// # }
/// ```
pub fn rebound(text: &str, group: u32, binding: u32) -> String {
    [BUFFER, TEXTURE].into_iter().fold(String::from(text), |text, declared| {
        let bound = format!("@group({group}) @binding({binding}) {declared}");
        text.replace(&format!("@group(1) @binding(0) {declared}"), &bound)
    })
}

/// A text with its dictionary in a texture instead of a buffer, for WebGL 2 and for shader stages
/// without storage buffers.
///
/// The texture has the format RG32F, one level, any width, and the nodes row by row: node k of
/// `Dictionary::nodes` is texel (k mod width, k / width), with the density in red and the
/// cumulative in green. The functions load texels without a filter, never one after the last node,
/// and return the same bits as with the buffer. Texts without a dictionary come back as they are.
///
/// ```
/// # #[cfg(feature = "glint")] {
/// use lobe::wgsl::{Item, rebound, source, textured};
/// let text = textured(&source(&[Item::MarginalDensity]));
/// assert!(text.contains("@group(1) @binding(0) var lobe_dictionary: texture_2d<f32>;"));
/// assert!(!text.contains("storage"));
/// let text = rebound(&text, 0, 7);
/// assert!(text.contains("@group(0) @binding(7) var lobe_dictionary: texture_2d<f32>;"));
/// # naga::front::wgsl::parse_str(&text).expect("valid WGSL");
/// # }
/// ```
pub fn textured(text: &str) -> String {
    text.replace(BUFFER, TEXTURE).replace(FROM_BUFFER, FROM_TEXTURE)
}
