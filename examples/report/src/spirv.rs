//! SPIR-V: what a shader's text becomes, and how many instructions that is.

use std::collections::HashMap;

use lobe::wgsl::Item;
use naga::back::spv;
use naga::proc::{BoundsCheckPolicies, BoundsCheckPolicy};
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

/// Words before the first instruction.
pub const HEADER: usize = 5;

/// Numbers from the SPIR-V specification, section 3.49.
mod op {
    pub(super) const NAME: u16 = 5;
    pub(super) const FUNCTION: u16 = 54;
    pub(super) const FUNCTION_END: u16 = 56;
    pub(super) const FUNCTION_CALL: u16 = 57;
    pub(super) const LABEL: u16 = 248;

    /// Whether it computes: extended instructions, conversions, arithmetic, comparisons, bits and
    /// derivatives.
    pub(super) fn computes(opcode: u16) -> bool {
        const EXTENDED: u16 = 12;
        matches!(opcode, EXTENDED | 109..=215)
    }
}

/// Parses and validates WGSL as core WebGPU, without any extension.
///
/// # Errors
///
/// naga's message, with the line that it points at.
pub fn validated(wgsl: &str) -> Result<(naga::Module, ModuleInfo), String> {
    let module = naga::front::wgsl::parse_str(wgsl).map_err(|error| error.emit_to_string(wgsl))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|error| error.emit_to_string(wgsl))?;
    Ok((module, info))
}

/// WGSL as SPIR-V 1.3: names kept, indices checked, loops as written.
///
/// # Errors
///
/// What [`validated`] and naga's writer refuse.
pub fn assembled(wgsl: &str) -> Result<Vec<u32>, String> {
    let (module, info) = validated(wgsl)?;
    written(&module, &info)
}

/// A validated module as SPIR-V 1.3, like [`assembled`].
///
/// # Errors
///
/// What naga's writer refuses.
pub fn written(module: &naga::Module, info: &ModuleInfo) -> Result<Vec<u32>, String> {
    let options = spv::Options {
        lang_version: (1, 3),
        flags: spv::WriterFlags::DEBUG,
        // Nothing checks passthrough shaders after us.
        bounds_check_policies: BoundsCheckPolicies {
            index: BoundsCheckPolicy::Restrict,
            buffer: BoundsCheckPolicy::Restrict,
            image_load: BoundsCheckPolicy::Restrict,
            binding_array: BoundsCheckPolicy::Restrict,
        },
        force_loop_bounding: false,
        ..Default::default()
    };
    spv::write_vec(module, info, &options, None).map_err(|error| error.to_string())
}

/// Index, opcode and operands of each instruction.
pub fn walk(words: &[u32]) -> impl Iterator<Item = (usize, u16, &[u32])> {
    let mut at = HEADER;
    std::iter::from_fn(move || {
        let first = *words.get(at)?;
        let length = (first >> 16) as usize;
        let instruction = (at, first as u16, words.get(at + 1..at + length)?);
        at += length;
        Some(instruction)
    })
}

/// A function of a shader.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Instructions {
    /// Its name in WGSL.
    pub name: String,
    /// Static instructions of its body, labels not counted.
    pub own: usize,
    /// The same with every call in place of its callee's, loops counted once.
    pub inlined: usize,
    /// Those of `inlined` that compute: without moves, loads, stores and branches.
    pub arithmetic: usize,
}

/// The instructions of every function.
pub fn instructions(words: &[u32]) -> Vec<Instructions> {
    let mut names: HashMap<u32, String> = HashMap::new();
    let mut bodies: Vec<(u32, [usize; 2], Vec<u32>)> = Vec::new();
    let mut inside = false;
    for (_, opcode, operands) in walk(words) {
        match opcode {
            op::NAME => {
                names.insert(operands[0], text(&operands[1..]));
            }
            op::FUNCTION => {
                bodies.push((operands[1], [0; 2], Vec::new()));
                inside = true;
            }
            op::FUNCTION_END => inside = false,
            // A label is no work.
            op::LABEL => {}
            _ if inside => {
                if let Some((_, [own, arithmetic], calls)) = bodies.last_mut() {
                    *own += 1;
                    *arithmetic += usize::from(op::computes(opcode));
                    if opcode == op::FUNCTION_CALL {
                        calls.push(operands[2]);
                    }
                }
            }
            _ => {}
        }
    }
    // naga writes callees before their callers.
    let mut inlined: HashMap<u32, [usize; 2]> = HashMap::new();
    let mut found = Vec::new();
    for (id, [own, arithmetic], calls) in bodies {
        let called = |k: usize| calls.iter().map(|callee| inlined[callee][k]).sum::<usize>();
        let (whole, arithmetic) = (own - calls.len() + called(0), arithmetic + called(1));
        inlined.insert(id, [whole, arithmetic]);
        let name = names.get(&id).cloned().unwrap_or_else(|| format!("%{id}"));
        found.push(Instructions { name, own, inlined: whole, arithmetic });
    }
    found
}

/// One call of each function that items ask for, calls written out: instructions, and those of them
/// that compute.
pub fn called(functions: &[Instructions], items: &[Item]) -> [usize; 2] {
    let asked = |name: &str| items.iter().any(|item| name == format!("lobe_{}", item.name()));
    let called = functions.iter().filter(|function| asked(&function.name));
    called.fold([0; 2], |[all, arithmetic], function| {
        [all + function.inlined, arithmetic + function.arithmetic]
    })
}

/// A literal string: UTF-8, little-endian, ended by a zero byte.
fn text(words: &[u32]) -> String {
    let bytes = words.iter().flat_map(|word| word.to_le_bytes());
    String::from_utf8_lossy(&bytes.take_while(|&byte| byte != 0).collect::<Vec<_>>()).into_owned()
}

#[cfg(test)]
mod tests {
    use super::{assembled, instructions};

    #[test]
    fn calls_are_counted_as_what_they_call() {
        let wgsl = "fn one(x: f32) -> f32 { return x * 2.0; }\nfn two(x: f32) -> f32 { return \
            one(x) + one(x); }\n";
        let words = assembled(wgsl).expect("valid WGSL");
        let found = instructions(&words);
        assert_eq!(found.len(), 2);
        let (one, two) = (&found[0], &found[1]);
        assert_eq!((one.name.as_str(), one.own), ("one", one.inlined));
        assert_eq!(two.inlined, two.own - 2 + 2 * one.inlined);
        // A product, and two of them with their sum.
        assert_eq!([one.arithmetic, two.arithmetic], [1, 3]);
    }

    #[test]
    fn wrong_text_is_pointed_at() {
        let message = assembled("fn f() -> f32 { return g; }").expect_err("no such name");
        assert!(message.contains("wgsl:1:24"), "{message}");
    }
}
