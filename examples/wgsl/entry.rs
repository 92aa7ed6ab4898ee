//! An entry point that calls every item asked for: translators drop functions that none calls.

use lobe::wgsl::{Item, source, textured};
use naga::valid::{Capabilities, ModuleInfo, ShaderStages, ValidationFlags, Validator};
use naga::{ArraySize, Handle, Module, ScalarKind, ShaderStage, Type, TypeInner};
use std::fmt::Write as _;

/// An entry point `main`, without the items' own text.
///
/// Arguments come one after the other from a uniform array of numbers; the sum of all answers goes
/// to a buffer, or to the color of a fragment. So nothing is constant, and nothing is unused.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    /// The buffers and the function.
    pub(crate) text: String,
    /// Compute, or fragment where an item takes derivatives or the device has no other stage.
    pub(crate) stage: ShaderStage,
}

/// A kind of device, by what it offers to shaders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Device {
    /// Storage buffers and compute shaders.
    Buffers,
    /// Neither of the two, as in WebGL 2: a dictionary is a texture, and the entry point a
    /// fragment's.
    Textures,
}

/// The most vectors that the array of numbers has: 16 KiB, the size of a uniform buffer that every
/// device takes. Arguments beyond it begin at the first number again.
const VECTORS: usize = 1024;

/// Items under the entry point that calls them.
#[derive(Debug)]
pub(crate) struct Shader {
    /// The WGSL of both.
    pub(crate) text: String,
    /// The stage of the entry point.
    pub(crate) stage: ShaderStage,
    /// The text as naga reads it.
    pub(crate) module: Module,
    /// The facts that naga's validator found.
    pub(crate) info: ModuleInfo,
}

impl Shader {
    /// The shader of these items, for a device.
    pub(crate) fn new(items: &[Item], device: Device) -> Result<Self, String> {
        let Entry { text, stage } = entry(items, device)?;
        let library = match device {
            Device::Buffers => source(items),
            Device::Textures => textured(&source(items)),
        };
        let text = format!("{library}\n{text}");
        let (module, info) = parse(&text)?;
        Ok(Self { text, stage, module, info })
    }
}

/// The module of a text, valid without any capability.
pub(crate) fn parse(text: &str) -> Result<(Module, ModuleInfo), String> {
    let module = naga::front::wgsl::parse_str(text).map_err(|error| error.emit_to_string(text))?;
    let info = Validator::new(ValidationFlags::all(), Capabilities::empty())
        .validate(&module)
        .map_err(|error| error.emit_to_string(text))?;
    Ok((module, info))
}

/// The names that an item asks for by its own: a function, a constant, or those of a file.
pub(crate) fn declared(item: Item) -> Vec<String> {
    let [function, constant] = [format!("lobe_{}", item.name()), format!("LOBE_{}", item.name())];
    let text = source(&[item]);
    if text.contains(&format!("fn {function}(")) {
        return vec![function];
    }
    if text.contains(&format!("const {constant}:")) || text.contains(&format!("const {constant} "))
    {
        return vec![constant];
    }
    let file = item.module().expect("an item is a function, a constant or a file");
    names(file.body()).filter(|name| !name.starts_with("Lobe")).map(str::to_owned).collect()
}

/// What a text declares.
pub(crate) fn names(text: &str) -> impl Iterator<Item = &str> {
    let lines = text.lines().filter_map(|line| {
        // A buffer has attributes before it.
        let line = line.find("var<").map_or(line, |at| &line[at..]);
        let kinds = ["fn ", "const ", "struct ", "var<storage, read> "];
        kinds.iter().find_map(|kind| line.strip_prefix(kind))
    });
    lines.filter_map(|rest| rest.split(|c: char| !c.is_alphanumeric() && c != '_').next())
}

/// The entry point of these items, for a device.
pub(crate) fn entry(items: &[Item], device: Device) -> Result<Entry, String> {
    let (module, info) = parse(&source(items))?;
    let mut wanted: Vec<String> = items.iter().flat_map(|item| declared(*item)).collect();
    wanted.sort();
    wanted.dedup();
    let mut body = String::new();
    let (mut next, mut stages) = (0, ShaderStages::all());
    if device == Device::Textures {
        stages = ShaderStages::FRAGMENT;
    }
    for (_, constant) in module.constants.iter() {
        let name = constant.name.as_deref().unwrap_or_default();
        if wanted.iter().any(|other| other == name) {
            let _ = writeln!(body, "    sum += {};", sum(&module, constant.ty, name));
        }
    }
    for (handle, function) in module.functions.iter() {
        let name = function.name.as_deref().unwrap_or_default();
        let Some(result) = function.result.as_ref().filter(|_| wanted.iter().any(|n| n == name))
        else {
            continue;
        };
        stages &= info[handle].available_stages;
        let arguments: Vec<String> =
            function.arguments.iter().map(|a| value(&module, a.ty, &mut next)).collect();
        let _ = writeln!(body, "    {{\n        let answer = {name}({});", arguments.join(", "));
        let _ = writeln!(body, "        sum += {};\n    }}", sum(&module, result.ty, "answer"));
    }
    let fragment = !stages.contains(ShaderStages::COMPUTE);
    let vectors = next.div_ceil(4).clamp(1, VECTORS);
    let numbers = format!("@group(0) @binding(0) var<uniform> numbers: array<vec4f, {vectors}>;\n");
    let text = if fragment {
        format!(
            "{numbers}\n@fragment\nfn main() -> @location(0) vec4<f32> {{\n    var sum = \
                0.0;\n{body}    \
             return vec4<f32>(sum);\n}}\n"
        )
    } else {
        format!(
            "{numbers}@group(0) @binding(1) var<storage, read_write> answers: array<f32>;\n\n\
             @compute @workgroup_size(1)\nfn main() {{\n    var sum = 0.0;\n{body}    answers[0] \
             = sum;\n}}\n"
        )
    };
    Ok(Entry { text, stage: if fragment { ShaderStage::Fragment } else { ShaderStage::Compute } })
}

/// A type as WGSL spells it.
fn spelled(module: &Module, ty: Handle<Type>) -> String {
    let Type { name, inner } = &module.types[ty];
    match (name, inner) {
        (Some(name), _) => name.clone(),
        (None, TypeInner::Array { base, size: ArraySize::Constant(size), .. }) => {
            format!("array<{}, {size}>", spelled(module, *base))
        }
        (None, TypeInner::Scalar(scalar)) => scalar_name(scalar.kind).to_owned(),
        (None, TypeInner::Vector { size, scalar }) => {
            format!("vec{}<{}>", *size as u8, scalar_name(scalar.kind))
        }
        (None, TypeInner::Matrix { columns, rows, scalar }) => {
            format!("mat{}x{}<{}>", *columns as u8, *rows as u8, scalar_name(scalar.kind))
        }
        other => unreachable!("no function of the WGSL port takes or returns {other:?}"),
    }
}

/// The one width that the WGSL port uses.
fn scalar_name(kind: ScalarKind) -> &'static str {
    match kind {
        ScalarKind::Sint => "i32",
        ScalarKind::Uint => "u32",
        ScalarKind::Bool => "bool",
        _ => "f32",
    }
}

/// A value of a type, made of the next numbers of the buffer.
fn value(module: &Module, ty: Handle<Type>, next: &mut usize) -> String {
    let parts: Vec<String> = match &module.types[ty].inner {
        TypeInner::Struct { members, .. } => {
            members.iter().map(|member| value(module, member.ty, next)).collect()
        }
        TypeInner::Array { base, size: ArraySize::Constant(size), .. } => {
            (0..size.get()).map(|_| value(module, *base, next)).collect()
        }
        inner => {
            let (count, kind) = numbers(inner);
            let mut number = || {
                *next += 1;
                let (vector, part) = ((*next - 1) / 4 % VECTORS, (*next - 1) % 4);
                let number = format!("numbers[{vector}].{}", ["x", "y", "z", "w"][part]);
                match kind {
                    ScalarKind::Bool => format!("{number} > 0.0"),
                    ScalarKind::Float => number,
                    _ => format!("{}({number})", scalar_name(kind)),
                }
            };
            if matches!(inner, TypeInner::Scalar(_)) {
                return number();
            }
            (0..count).map(|_| number()).collect()
        }
    };
    format!("{}({})", spelled(module, ty), parts.join(", "))
}

/// How many numbers a scalar, vector or matrix has, and of what kind.
fn numbers(inner: &TypeInner) -> (usize, ScalarKind) {
    match inner {
        TypeInner::Vector { size, scalar } => (*size as usize, scalar.kind),
        TypeInner::Matrix { columns, rows, scalar } => {
            (*columns as usize * *rows as usize, scalar.kind)
        }
        TypeInner::Scalar(scalar) => (1, scalar.kind),
        other => unreachable!("no function of the WGSL port takes or returns {other:?}"),
    }
}

/// The sum of all numbers in a value.
fn sum(module: &Module, ty: Handle<Type>, of: &str) -> String {
    let parts: Vec<String> = match &module.types[ty].inner {
        TypeInner::Struct { members, .. } => members
            .iter()
            .map(|member| {
                let name = member.name.as_deref().unwrap_or_default();
                sum(module, member.ty, &format!("{of}.{name}"))
            })
            .collect(),
        TypeInner::Array { base, size: ArraySize::Constant(size), .. } => {
            (0..size.get()).map(|k| sum(module, *base, &format!("{of}[{k}]"))).collect()
        }
        TypeInner::Matrix { columns, rows, .. } => (0..*columns as u8)
            .flat_map(|column| (0..*rows as u8).map(move |row| format!("{of}[{column}][{row}]")))
            .collect(),
        TypeInner::Vector { size, scalar } => {
            (0..*size as usize).map(|k| number(scalar.kind, &format!("{of}[{k}]"))).collect()
        }
        TypeInner::Scalar(scalar) => vec![number(scalar.kind, of)],
        other => unreachable!("no function of the WGSL port takes or returns {other:?}"),
    };
    parts.join(" + ")
}

/// A scalar as f32.
fn number(kind: ScalarKind, of: &str) -> String {
    match kind {
        ScalarKind::Float => of.to_owned(),
        ScalarKind::Bool => format!("select(0.0, 1.0, {of})"),
        _ => format!("f32({of})"),
    }
}
