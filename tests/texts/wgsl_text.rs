//! The WGSL port's texts, word by word: nothing that compilers answer differently, no name that
//! translators change.
#![cfg(all(feature = "wgsl", feature = "glint"))]

use crate::entry::{Device, Shader, declared, names};
use crate::translate::{self, Language, translate};
use lobe::wgsl::{Item, Module, Preset, rebound, source, textured};
use naga::back::wgsl::WriterFlags;
use std::collections::BTreeSet;
use std::sync::OnceLock;

/// Builtins whose accuracy, NaNs or order of operations drivers choose. The WGSL port has its own
/// of those that it needs; `sqrt` and quotients are the driver's.
const LOOSE: &str = "atan atan2 exp exp2 log log2 pow sin cos tan sinh cosh tanh asin acos asinh \
    acosh atanh mix \
    fma inverseSqrt normalize length distance smoothstep sign min max clamp saturate step dot \
    cross reflect refract faceForward \
    determinant degrees radians ldexp frexp round fract modf";

/// Builtins that GLSL ES 3.00 does not have: translators refuse them, or count bits by a logarithm.
const ABSENT: &str = "countOneBits countLeadingZeros countTrailingZeros firstLeadingBit \
    firstTrailingBit reverseBits \
    extractBits insertBits pack4x8snorm pack4x8unorm unpack4x8snorm unpack4x8unorm arrayLength";

/// Builtins of fragment shaders.
const DERIVATIVES: &str =
    "dpdx dpdy fwidth dpdxCoarse dpdyCoarse fwidthCoarse dpdxFine dpdyFine fwidthFine";

/// A body's lines without their comments.
fn code(body: &str) -> impl Iterator<Item = &str> {
    body.lines().map(|line| line.split("//").next().unwrap_or_default())
}

/// Names, numbers and keywords of a line, with what follows each.
fn words(line: &str) -> impl Iterator<Item = (&str, &str)> {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    let mut rest = line;
    std::iter::from_fn(move || {
        rest = rest.trim_start_matches(|c| !is_part(c));
        let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
        let (word, after) = rest.split_at(end);
        rest = after;
        (!word.is_empty()).then_some((word, after))
    })
}

/// What is wrong with a line of a file.
fn complaint(path: &str, line: &str) -> Option<String> {
    let listed = |list: &str, word: &str| list.split_whitespace().any(|other| other == word);
    for (word, after) in words(line) {
        // Of integers there is one answer.
        let is_exact =
            ["(bitcast<u32>(", "(bitcast<i32>("].iter().any(|bits| after.starts_with(bits));
        if listed(LOOSE, word) && after.starts_with('(') && !is_exact {
            return Some(format!("the builtin {word}"));
        }
        if listed(ABSENT, word) {
            return Some(format!("{word}, which WebGL 2 lacks"));
        }
        if listed(DERIVATIVES, word) && !path.starts_with("fragment") {
            return Some(format!("the derivative {word}"));
        }
        let is_name = word.starts_with(|c: char| c.is_alphabetic() || c == '_');
        let is_type = ["f32", "i32", "u32"].contains(&word);
        let ends_badly = word.ends_with(|c: char| c.is_ascii_digit() || c == '_');
        if is_name && !is_type && (ends_badly || word.contains("__")) {
            return Some(format!("the name {word}"));
        }
    }
    let directive =
        ["enable ", "requires ", "diagnostic"].iter().any(|word| line.starts_with(word));
    // The one buffer there is.
    let rest = match path {
        "material/multilobe/dictionary" => line.trim_start_matches("@group(1) @binding(0) var"),
        _ => line,
    };
    if directive || rest.contains(['@', '%', '#']) {
        return Some("a directive, an attribute or a remainder".to_owned());
    }
    let parts: Vec<&str> =
        line.split_whitespace().map(|part| part.trim_matches(['(', ')', ',', ';'])).collect();
    // Compilers that assume numbers know the answer, and shaders want it for what is none.
    let folded = parts.windows(3).any(|three| {
        let compared = ["!=", "=="].contains(&three[1]) && three[0] == three[2];
        compared || (["<", "<=", ">", ">="].contains(&three[1]) && three[2] == "LOBE_MAX")
    });
    let limited = line.contains("lobe_min(") && line.contains(", LOBE_MAX)");
    (folded || limited).then(|| "a guard that waits for NaN or infinity".to_owned())
}

#[test]
fn no_line_has_a_hazard() {
    for module in Module::ALL {
        for (number, line) in code(module.body()).enumerate() {
            let complaint = complaint(module.path(), line);
            assert_eq!(complaint, None, "{}.wgsl:{}: {line}", module.path(), number + 1);
        }
    }
}

#[test]
fn the_laws_notice() {
    for line in [
        "    let a = mix(b, c, 0.5);",
        "    return x - dot(a, b);",
        "    let a = dpdx(h);",
        "    let slope1 = 0.0;",
        "    let zeros = countTrailingZeros(index);",
        "    let a__b = 0.0;",
        "enable f16;",
        "@fragment fn main() {}",
        "    let a = b % c;",
        "    if x != x {",
        "    return select(0.0, x, (x != x));",
        "    return select(0.0, x, x == x);",
        "    return abs(x) <= LOBE_MAX;",
        "    return lobe_min(lobe_max(x, 0.0), LOBE_MAX);",
    ] {
        assert!(complaint("filter/kernel", line).is_some(), "{line}");
    }
    let fine = "    let a = lobe_min(b.x, 1.0) + f32(k) + vec2f(length, 0x3f3504f3u) == a;";
    assert_eq!(complaint("filter/kernel", fine), None);
    assert_eq!(complaint("fragment", "    let u = dpdx(slope);"), None);
}

#[test]
fn declarations_are_prefixed_and_commented() {
    for module in Module::ALL {
        let lines: Vec<&str> = module.body().lines().collect();
        for pair in lines.windows(2).filter(|pair| names(pair[1]).next().is_some()) {
            let name = names(pair[1]).next().unwrap_or_default();
            assert!(pair[0].starts_with("// "), "{}.wgsl: {name} has no comment", module.path());
            let prefix = ["lobe_", "LOBE_", "Lobe"].iter().any(|prefix| name.starts_with(prefix));
            assert!(prefix, "{}.wgsl: {name}", module.path());
        }
    }
}

/// The names that callers write: functions, constants, structures and their members.
fn written(module: &naga::Module) -> BTreeSet<&str> {
    let functions = module.functions.iter().map(|(_, function)| &function.name);
    let constants = module.constants.iter().map(|(_, constant)| &constant.name);
    let types = module.types.iter().map(|(_, of)| &of.name);
    let members = module.types.iter().flat_map(|(_, of)| match &of.inner {
        naga::TypeInner::Struct { members, .. } => members.as_slice(),
        _ => &[],
    });
    let all = functions.chain(constants).chain(types).chain(members.map(|member| &member.name));
    all.filter_map(|name| name.as_deref()).collect()
}

/// Languages that are text. SPIR-V has no names.
fn text_languages() -> impl Iterator<Item = Language> {
    Language::ALL.iter().copied().filter(|language| *language != Language::Spirv)
}

/// The translation of items into a language that is text.
fn translated(items: &[Item], language: Language) -> String {
    let shader = Shader::new(items, language.device()).expect("a shader");
    translate(&shader, language).expect("a translation").text()
}

/// The shader of all items, and its translations into every language that is text.
fn whole() -> &'static (Shader, Vec<(Language, String)>) {
    static WHOLE: OnceLock<(Shader, Vec<(Language, String)>)> = OnceLock::new();
    WHOLE.get_or_init(|| {
        let [buffers, textures] = [Device::Buffers, Device::Textures]
            .map(|device| Shader::new(Item::ALL, device).expect("a shader"));
        let texts = text_languages().map(|language| {
            let shader = if language.device() == Device::Buffers { &buffers } else { &textures };
            (language, translate(shader, language).expect("a translation").text())
        });
        let texts = texts.collect();
        (buffers, texts)
    })
}

/// All items in a language that is text.
fn all_in(language: Language) -> &'static str {
    let text = whole().1.iter().find(|(other, _)| *other == language);
    &text.expect("a language that is text").1
}

#[test]
fn translators_keep_names() {
    let (Shader { module, info, .. }, texts) = whole();
    let again = naga::back::wgsl::write_string(module, info, WriterFlags::empty());
    let again = again.expect("a translation");
    let others = texts.iter().map(|(language, text)| (language.name(), text));
    let names = written(module);
    for (language, translated) in others.chain([("wgsl", &again)]) {
        let after: BTreeSet<&str> =
            translated.lines().flat_map(words).map(|(word, _)| word).collect();
        // A reserved word, or one that ends in a digit, gets an underscore.
        let changed = |name: &&str| after.contains(format!("{name}_").as_str());
        let lost = |name: &&str| name.starts_with("lobe_") && !after.contains(*name);
        let wrong: Vec<&&str> = names.iter().filter(|name| changed(name) || lost(name)).collect();
        assert!(wrong.is_empty(), "{language} renames {wrong:?}");
    }
}

#[test]
fn presets_and_items_translate_into_every_language() {
    let singles = Item::ALL.iter().map(|item| (item.name(), std::slice::from_ref(item)));
    let presets = Preset::ALL.iter().map(|preset| (preset.name(), preset.items()));
    for (name, items) in singles.chain(presets) {
        for device in [Device::Buffers, Device::Textures] {
            let shader = Shader::new(items, device).unwrap_or_else(|e| panic!("{name}: {e}"));
            for asked in items.iter().flat_map(|item| declared(*item)) {
                let calls = shader.text.matches(&format!("{asked}(")).count();
                assert!(calls != 1, "{name}: nothing calls {asked}");
            }
            for language in Language::ALL.iter().filter(|language| language.device() == device) {
                let translated = translate(&shader, *language);
                assert!(translated.is_ok(), "{name}, {language:?}: {translated:?}");
            }
        }
    }
}

#[test]
fn constant_arrays_of_hlsl_are_braces() {
    let hlsl = all_in(Language::Hlsl);
    let arrays: Vec<&str> = hlsl
        .lines()
        .filter(|line| line.starts_with("static const ") && line.contains("] = "))
        .collect();
    let module = &whole().0.module;
    let is_array =
        |c: &naga::Constant| matches!(module.types[c.ty].inner, naga::TypeInner::Array { .. });
    let count = module.constants.iter().filter(|(_, c)| is_array(c)).count();
    assert!(count > 0 && arrays.len() == count, "{count} arrays, in HLSL {arrays:?}");
    for line in &arrays {
        // As many numbers as the size says.
        let size = line.split(['[', ']']).nth(1).and_then(|size| size.parse::<usize>().ok());
        let numbers = line.split(['{', '}']).nth(1).map(|list| list.split(", ").count());
        assert!(size.is_some() && size == numbers && line.ends_with(" };"), "{line}");
    }
    let statics = hlsl.lines().filter(|line| line.starts_with("static "));
    assert_eq!(statics.filter(|line| line.contains("Construct")).count(), 0);
    // A function that makes an array is there where one calls it, and not where none does.
    let made = |text: &str| text.matches("Constructarray7_float_(").count();
    assert!(made(hlsl) > 1);
    let plain = translated(&[Item::Exp, Item::Ln], Language::Hlsl);
    assert!(plain.contains("LOBE_EXP[5] = { ") && !plain.contains("Construct"), "{plain}");
}

#[test]
fn braces_change_nothing_else() {
    let text = "static const float A = lobe_max(1.0, 2.0);\n\ntypedef float Kept;\n\nint x;\n";
    assert_eq!(translate::braced(text), text);
}

#[test]
fn numbers_are_in_range_of_f32() {
    // WebGL in Chrome takes 3.4028235e38 for infinity: the digits of the largest f32, but above it.
    // Metal's compiler is one of C++, where such a number is the nearest f32.
    for language in text_languages().filter(|language| *language != Language::Msl) {
        let text = translated(&[Item::Max, Item::IsFinite, Item::GgxBrdfOver], language);
        let mut largest = 0.0_f64;
        let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || ".+_".contains(c)));
        for word in words.filter(|word| word.starts_with(|c: char| c.is_ascii_digit())) {
            largest = largest.max(word.trim_end_matches(['f', 'u', 'i']).parse().unwrap_or(0.0));
        }
        assert!(largest <= f64::from(f32::MAX), "{language:?}: {largest}");
        assert_eq!(largest as f32, f32::MAX, "{language:?}");
    }
}

#[test]
fn structures_nest_as_deep_as_webgl_allows() {
    fn depth(module: &naga::Module, of: naga::Handle<naga::Type>) -> usize {
        match &module.types[of].inner {
            naga::TypeInner::Struct { members, .. } => {
                1 + members.iter().map(|member| depth(module, member.ty)).max().unwrap_or(0)
            }
            naga::TypeInner::Array { base, .. } => depth(module, *base),
            _ => 0,
        }
    }
    let module = &whole().0.module;
    for (handle, of) in module.types.iter() {
        assert!(depth(module, handle) <= 4, "{:?}", of.name);
    }
}

#[test]
fn webgl_gets_a_fragment_shader_without_buffers() {
    for language in [Language::GlslEs300, Language::Glsl330] {
        let text = all_in(language);
        assert!(!text.contains("buffer ") && !text.contains("local_size"), "{language:?}");
        let sampler = text.lines().filter(|line| line.ends_with("sampler2D lobe_dictionary;"));
        assert_eq!(sampler.count(), 1, "{language:?}");
        // Bit counting came with 3.10 and 4.00.
        for builtin in ["findLSB", "findMSB", "bitCount", "bitfield", "ldexp", "frexp"] {
            assert!(!text.contains(builtin), "{language:?}: {builtin}");
        }
    }
    let es = all_in(Language::GlslEs300);
    for line in ["precision highp float;", "precision highp int;"] {
        assert!(es.lines().any(|other| other == line), "{line}");
    }
    assert!(es.contains("uniform highp sampler2D"));
}

#[test]
fn a_texture_holds_the_dictionary_and_nothing_else_changes() {
    let text = source(Item::ALL);
    let other = textured(&text);
    assert!(text.contains("var<storage, read> lobe_dictionary") && !other.contains("var<storage"));
    let [before, after] = [&text, &other].map(|text| text.lines().collect::<BTreeSet<&str>>());
    assert_eq!([before.difference(&after).count(), after.difference(&before).count()], [2, 4]);
    // Two calls that commute.
    let [first, second] = [rebound(&other, 2, 3), textured(&rebound(&text, 2, 3))];
    assert_eq!(first, second);
    assert!(first.contains("@group(2) @binding(3) var lobe_dictionary: texture_2d<f32>;"));
    // In the files for linkers, too.
    let file = Module::ALL.iter().find(|module| module.path().ends_with("/dictionary"));
    let file = file.expect("the dictionary's file");
    for text in [file.wesl(), file.naga_oil()] {
        assert!(
            textured(&text).contains("texture_2d<f32>") && !textured(&text).contains("storage")
        );
        assert!(textured(&text).contains("textureLoad("));
    }
    let plain = source(&[Item::GgxBrdf, Item::GlintNdfBrdf]);
    assert_eq!(textured(&plain), plain);
}
