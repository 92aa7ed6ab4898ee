//! The mirror in engines: its files through their linkers, its presets in the languages of others.

use crate::entry::{Entry, entry, names, parse};
use crate::translate::{Language, Translation, translate};
use lobe::wgsl::{Item, Module, Preset, source};
use lobe_gpu::tools::{ask, spirv_val};
use lobe_report::spirv::instructions;
use naga::ShaderStage;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga_oil::compose::{ComposableModuleDescriptor, Composer, NagaModuleDescriptor};
use std::collections::BTreeSet;
use wesl::{CompileOptions, ManglerKind, ModulePath, VirtualResolver, Wesl};

/// Every preset and every file, with its items.
fn requests() -> Vec<(&'static str, Vec<Item>)> {
    let presets = Preset::ALL.iter().map(|preset| (preset.name(), preset.items().to_vec()));
    let files = Item::ALL.iter().filter(|item| item.module().is_some());
    presets.chain(files.map(|item| (item.name(), vec![*item]))).collect()
}

/// Statements that bring the names of the mirror in a text: each begins with `start`, and ends with `end`.
fn imports(text: &str, start: &str, end: &str) -> String {
    let words: BTreeSet<&str> = text.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
    let lines = Module::ALL.iter().map(|module| {
        let names: Vec<&str> = names(module.body()).filter(|name| words.contains(name)).collect();
        let place = module.path().replace('/', "::");
        if names.is_empty() {
            return String::new();
        }
        format!("{start}{place}::{{{}}}{end}\n", names.join(", "))
    });
    lines.collect()
}

/// Functions of a text, but its entry point.
fn functions(text: &str) -> BTreeSet<String> {
    let (module, _) = parse(text).unwrap_or_else(|error| panic!("{error}"));
    module.functions.iter().filter_map(|(_, function)| function.name.clone()).collect()
}

/// What WESL's linker makes of an entry point beside all files of the mirror.
fn linked(entry: &Entry, mangler: ManglerKind) -> Result<String, String> {
    let mut resolver = VirtualResolver::new();
    let place = |path: &str| -> ModulePath {
        format!("package::{}", path.replace('/', "::")).parse().expect("a path")
    };
    for module in Module::ALL {
        resolver.add_module(place(module.path()), module.wesl().into());
    }
    let text = imports(&entry.text, "import package::", ";") + &entry.text;
    resolver.add_module(place("main"), text.into());
    let mut linker = Wesl::new_barebones().set_custom_resolver(resolver);
    linker.set_options(CompileOptions::default()).set_mangler(mangler);
    linker.compile(&place("main")).map(|text| text.to_string()).map_err(|error| error.to_string())
}

#[test]
fn wesl_links_what_is_imported_and_nothing_else() {
    for (name, items) in requests() {
        let entry = entry(&items).expect("an entry point");
        let link = |mangler| {
            linked(&entry, mangler)
                .unwrap_or_else(|error| panic!("{name}: {error}\n{}", entry.text))
        };
        let text = link(ManglerKind::None);
        assert_eq!(functions(&text), functions(&source(&items)), "{name}");
        // Its own names, which have the path of the file in them, are valid too.
        let mangled = link(ManglerKind::Escape);
        assert_eq!(functions(&mangled).len(), functions(&text).len(), "{name}");
    }
}

#[test]
fn naga_oil_composes_what_is_imported() {
    let mut composer = Composer::default();
    for module in Module::ALL {
        let text = module.naga_oil();
        let descriptor = ComposableModuleDescriptor {
            source: &text,
            file_path: module.path(),
            ..ComposableModuleDescriptor::default()
        };
        let added = composer.add_composable_module(descriptor).map(|_| ());
        added.unwrap_or_else(|error| panic!("{}", error.emit_to_string(&composer)));
    }
    for (name, items) in requests() {
        let entry = entry(&items).expect("an entry point");
        let text = imports(&entry.text, "#import lobe::", "") + &entry.text;
        let descriptor = NagaModuleDescriptor {
            source: &text,
            file_path: name,
            ..NagaModuleDescriptor::default()
        };
        let module = composer.make_naga_module(descriptor);
        let module = module
            .unwrap_or_else(|error| panic!("{name}: {}\n{text}", error.emit_to_string(&composer)));
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        let valid = validator.validate(&module);
        assert!(valid.is_ok(), "{name}: {valid:?}");
        assert_eq!(module.entry_points[0].stage, entry.stage, "{name}");
        let composed: BTreeSet<String> = module
            .functions
            .iter()
            .filter_map(|(_, function)| function.name.as_deref())
            .map(|name| name.split("X_naga_oil_mod").next().unwrap_or_default().to_owned())
            .collect();
        // It brings what the files import, too, whether or not that is used.
        let needed = crate::link::needed(&items);
        let imported: BTreeSet<&str> =
            needed.iter().flat_map(|module| names(module.body())).collect();
        assert!(composed.is_superset(&functions(&source(&items))), "{name}");
        assert!(composed.iter().all(|function| imported.contains(function.as_str())), "{name}");
    }
}

#[test]
fn linkers_refuse_what_is_not_there() {
    let text = "@compute @workgroup_size(1) fn main() { _ = lobe_ggx_none(); }";
    let entry = Entry { text: text.to_owned(), stage: ShaderStage::Compute };
    assert!(linked(&entry, ManglerKind::None).is_err());
    let text = format!("#import lobe::ndf::ggx::{{lobe_ggx_none}}\n{text}");
    let descriptor = NagaModuleDescriptor {
        source: &text,
        file_path: "none",
        ..NagaModuleDescriptor::default()
    };
    assert!(Composer::default().make_naga_module(descriptor).is_err());
}

/// What glslang says of a text: `None` where it is not installed.
fn glslang(text: &str, stage: ShaderStage, options: &[&str]) -> Option<Result<String, String>> {
    let stage = if stage == ShaderStage::Fragment { "frag" } else { "comp" };
    let arguments = [&["--stdin", "-S", stage], options].concat();
    ask("glslangValidator", &arguments, text.as_bytes())
}

/// Another compiler's opinion of a translation: `None` where it is not installed, or there is none for it.
fn opinion(
    translation: &Translation,
    stage: ShaderStage,
    language: Language,
) -> Option<Result<String, String>> {
    let text = match translation {
        Translation::Words(words) => return spirv_val(words),
        Translation::Text(text) => text,
    };
    match language {
        Language::Glsl => glslang(text, stage, &["-V", "-o", "/dev/null"]),
        Language::GlslEs => glslang(text, stage, &[]),
        Language::Hlsl => {
            let answer = glslang(text, stage, &["-D", "-e", "main", "-V", "-o", "/dev/null"]);
            answer.map(|answer| answer.or_else(only_false_recursion))
        }
        Language::Msl | Language::Spirv => None,
    }
}

/// Accepted but for one complaint: glslang takes the function that fills a global array of HLSL for its own caller.
fn only_false_recursion(said: String) -> Result<String, String> {
    let mut errors = said.lines().filter(|line| line.contains("ERROR")).peekable();
    let any = errors.peek().is_some();
    let only = errors.all(|line| line.contains("Linking") && line.contains("Recursion detected"));
    let calls: Vec<&str> = said.lines().filter(|line| line.contains(" calling ")).collect();
    let constructors = calls.iter().all(|line| line.matches("Constructarray").count() == 2);
    if any && only && constructors { Ok(said) } else { Err(said) }
}

#[test]
fn other_compilers_accept_every_preset() {
    let mut missing = BTreeSet::new();
    for preset in Preset::ALL {
        let (items, name) = (preset.items(), preset.name());
        let entry = entry(items).expect("an entry point");
        let (module, info) = parse(&(source(items) + &entry.text)).expect("valid");
        for language in Language::ALL {
            let translation = translate(&module, &info, entry.stage, language);
            let translation = translation.unwrap_or_else(|error| panic!("{name}: {error}"));
            if let Translation::Words(words) = &translation {
                let count = instructions(words)
                    .iter()
                    .filter(|f| f.name != "main")
                    .map(|f| f.own)
                    .sum::<usize>();
                println!("{name}: {} bytes of WGSL, {count} instructions", source(items).len());
                assert!(count > 0);
            }
            match opinion(&translation, entry.stage, language) {
                Some(Ok(_)) => {}
                Some(Err(error)) => panic!("{name}, {}: {error}", language.name()),
                None => drop(missing.insert(language.name())),
            }
        }
    }
    for language in missing {
        println!("skipped: no compiler of {language} is installed");
    }
}

#[test]
fn other_compilers_can_refuse() {
    let broken = Translation::Text("#version 450\nvoid main() { none(); }\n".to_owned());
    for language in [Language::Glsl, Language::GlslEs, Language::Hlsl] {
        if let Some(answer) = opinion(&broken, ShaderStage::Compute, language) {
            assert!(answer.is_err(), "{}", language.name());
        }
    }
    if let Some(answer) = spirv_val(&[0x0723_0203, 0]) {
        assert!(answer.is_err());
    }
}
