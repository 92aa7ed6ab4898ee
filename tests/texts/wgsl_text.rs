//! The mirror's texts, word by word: nothing that compilers answer differently, no name that translators change.
#![cfg(feature = "wgsl")]

use crate::entry::{declared, entry, names, parse};
use crate::translate::{Language, translate};
use lobe::wgsl::{Item, Module, Preset, source};
use naga::back::wgsl::WriterFlags;
use std::collections::BTreeSet;

/// Builtins whose accuracy, NaNs or order of operations drivers choose. The mirror has its own of those that it needs;
/// `sqrt` and quotients are the driver's.
const LOOSE: &str = "atan atan2 exp exp2 log log2 pow sin cos tan sinh cosh tanh asin acos asinh acosh atanh mix \
    fma inverseSqrt normalize length distance smoothstep sign min max clamp saturate step dot cross reflect refract faceForward \
    determinant degrees radians ldexp frexp round fract modf";

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

#[test]
fn translators_keep_names() {
    let text = source(Item::ALL);
    let entry = entry(Item::ALL).expect("an entry point");
    let (module, info) = parse(&format!("{text}\n{}", entry.text)).expect("valid");
    let again = naga::back::wgsl::write_string(&module, &info, WriterFlags::empty());
    let again = ("wgsl", again.expect("a translation"));
    // SPIR-V has no names.
    let others = Language::ALL.into_iter().filter(|language| *language != Language::Spirv);
    let others = others.map(|language| {
        let translated = translate(&module, &info, entry.stage, language);
        (language.name(), translated.expect("a translation").text())
    });
    let names = written(&module);
    for (language, translated) in others.chain([again]) {
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
        let entry = entry(items).unwrap_or_else(|error| panic!("{name}: {error}"));
        let text = format!("{}\n{}", source(items), entry.text);
        let (module, info) = parse(&text).unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
        for asked in items.iter().flat_map(|item| declared(*item)) {
            assert!(entry.text.contains(&asked), "{name} does not use {asked}");
        }
        for language in Language::ALL {
            let translated = translate(&module, &info, entry.stage, language);
            assert!(translated.is_ok(), "{name}, {language:?}: {translated:?}");
        }
    }
}
