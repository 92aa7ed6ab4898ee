//! SPIR-V that no driver may rearrange.

use lobe_report::spirv::{HEADER, walk};

/// Numbers from the SPIR-V specification, section 3.49.
mod op {
    pub(super) const EXT_INST: u16 = 12;
    pub(super) const TYPE_FLOAT: u16 = 22;
    pub(super) const TYPE_VECTOR: u16 = 23;
    pub(super) const DECORATE: u16 = 71;
    pub(super) const SELECT: u16 = 169;
    /// FNegate; FAdd, FSub, FMul, FDiv, FRem, FMod; products of vectors and matrices; comparisons.
    pub(super) const FLOAT: [u16; 27] = [
        127, 129, 131, 133, 136, 140, 141, 142, 143, 144, 145, 146, 147, 148, 180, 181, 182, 183,
        184, 185, 186, 187, 188, 189, 190, 191, 192,
    ];
    /// All that may stand before the annotations: capabilities to names.
    pub(super) const BEFORE_ANNOTATIONS: [u16; 15] =
        [2, 3, 4, 5, 6, 7, 10, 11, 14, 15, 16, 17, 71, 72, 330];
}

/// The decoration NoContraction.
const NO_CONTRACTION: u32 = 42;

/// Forbids drivers to rewrite any float instruction: each is rounded once, in the order of the
/// text.
pub fn no_contraction(words: &mut Vec<u32>) {
    let mut float_types = Vec::new();
    let mut decorations = Vec::new();
    let mut annotations = HEADER;
    for (at, opcode, operands) in walk(words) {
        if op::BEFORE_ANNOTATIONS.contains(&opcode) {
            annotations = at + 1 + operands.len();
        }
        let float = match opcode {
            op::TYPE_FLOAT => {
                float_types.push(operands[0]);
                false
            }
            op::TYPE_VECTOR => {
                if float_types.contains(&operands[1]) {
                    float_types.push(operands[0]);
                }
                false
            }
            op::SELECT | op::EXT_INST => float_types.contains(&operands[0]),
            _ => op::FLOAT.contains(&opcode),
        };
        if float {
            decorations.extend([3 << 16 | u32::from(op::DECORATE), operands[1], NO_CONTRACTION]);
        }
    }
    words.splice(annotations..annotations, decorations);
}
