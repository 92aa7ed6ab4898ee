//! The WGSL port in engines: its files through their linkers, its presets in the languages of
//! others.

use crate::entry::{Device, Entry, Shader, entry, names, parse};
use crate::translate::{Language, Translation, translate};
use lobe::wgsl::{Item, Module, Preset, source};
use lobe_gpu::size::{is_long, size};
use lobe_gpu::tools::{ask, spirv_val};
use lobe_report::spirv::instructions;
use naga::ShaderStage;
use naga::valid::{Capabilities, ValidationFlags, Validator};
use naga_oil::compose::{ComposableModuleDescriptor, Composer, NagaModuleDescriptor};
use std::collections::BTreeSet;
use wesl::{CompileOptions, ManglerKind, ModulePath, VirtualResolver, Wesl};

/// Every preset and every file, with its items; in an ordinary run one in three of them, from all
/// floors.
fn requests() -> Vec<(&'static str, Vec<Item>)> {
    let presets = Preset::ALL.iter().map(|preset| (preset.name(), preset.items().to_vec()));
    let files = Item::ALL.iter().filter(|item| item.module().is_some());
    presets.chain(files.map(|item| (item.name(), vec![*item]))).step_by(size(3, 1)).collect()
}

/// Statements that bring the names of the WGSL port in a text: each begins with `start`, and ends
/// with `end`.
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

/// What WESL's linker makes of an entry point beside all files of the WGSL port.
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
        let entry = entry(&items, Device::Buffers).expect("an entry point");
        let link = |mangler| {
            linked(&entry, mangler)
                .unwrap_or_else(|error| panic!("{name}: {error}\n{}", entry.text))
        };
        let text = link(ManglerKind::None);
        assert_eq!(functions(&text), functions(&source(&items)), "{name}");
        if !is_long() && items.len() > 1 {
            continue;
        }
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
        let entry = entry(&items, Device::Buffers).expect("an entry point");
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

/// Another compiler's opinion of a translation: `None` where it is not installed, or there is none
/// for it.
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
        Language::Glsl330 | Language::GlslEs | Language::GlslEs300 => glslang(text, stage, &[]),
        Language::Hlsl => {
            // Legalizing what it accepted takes glslang twenty times as long as accepting it.
            let accept = ["-D", "-e", "main", "-V", "-o", "/dev/null", "-Od"];
            glslang(text, stage, &accept[..if is_long() { 6 } else { 7 }])
        }
        Language::Msl | Language::Spirv => None,
    }
}

/// Items of one text: glslang's time to legalize HLSL grows with its square, and for all items is a
/// minute.
const ITEMS: usize = 40;

/// Every item in some text of many: those that take derivatives apart, so that others run in
/// compute shaders. In a long run every preset, too, and one in three in an ordinary run.
fn shaders() -> Vec<(&'static str, Vec<Item>)> {
    let presets = Preset::ALL.iter().map(|preset| (preset.name(), preset.items().to_vec()));
    let (fragment, compute): (Vec<Item>, Vec<Item>) =
        Item::ALL.iter().partition(|item| item.name().starts_with("fragment"));
    let texts = [fragment, compute];
    let texts = texts.iter().flat_map(|items| items.chunks(ITEMS));
    let texts = texts.map(|items| (items[0].name(), items.to_vec()));
    presets.step_by(size(3, 1)).chain(texts).collect()
}

#[test]
fn other_compilers_accept_every_preset_and_every_item() {
    let mut missing = BTreeSet::new();
    for (name, items) in shaders() {
        for device in [Device::Buffers, Device::Textures] {
            let shader = Shader::new(&items, device).unwrap_or_else(|e| panic!("{name}: {e}"));
            for language in Language::ALL.iter().filter(|language| language.device() == device) {
                let translation = translate(&shader, *language);
                let translation = translation.unwrap_or_else(|error| panic!("{name}: {error}"));
                if let Translation::Words(words) = &translation {
                    let count = instructions(words)
                        .iter()
                        .filter(|f| f.name != "main")
                        .map(|f| f.own)
                        .sum::<usize>();
                    println!(
                        "{name}: {} bytes of WGSL, {count} instructions",
                        source(&items).len()
                    );
                    assert!(count > 0);
                }
                match opinion(&translation, shader.stage, *language) {
                    Some(Ok(_)) => {}
                    Some(Err(error)) => panic!("{name}, {}: {error}", language.name()),
                    None => drop(missing.insert(language.name())),
                }
            }
        }
    }
    for language in missing {
        println!("skipped: no compiler of {language} is installed");
    }
}

#[test]
fn other_compilers_can_refuse() {
    let refused = |text: &str, language: Language| {
        let stage = match language.device() {
            Device::Buffers => ShaderStage::Compute,
            Device::Textures => ShaderStage::Fragment,
        };
        if let Some(answer) = opinion(&Translation::Text(text.to_owned()), stage, language) {
            assert!(answer.is_err(), "{}: {text}", language.name());
        }
    };
    for (language, version) in [
        (Language::Glsl, "450"),
        (Language::Glsl330, "330"),
        (Language::GlslEs, "310 es"),
        (Language::GlslEs300, "300 es"),
    ] {
        refused(&format!("#version {version}\nvoid main() {{ none(); }}\n"), language);
    }
    refused("[numthreads(1, 1, 1)]\nvoid main() { none(); }\n", Language::Hlsl);
    // What each of the older languages does not have.
    let counting = "precision highp int;\nvoid main() { int k = findLSB(6); }\n";
    refused(&format!("#version 300 es\n{counting}"), Language::GlslEs300);
    refused(&format!("#version 330\n{counting}"), Language::Glsl330);
    // naga's arrays of HLSL before they become braces.
    let array = "typedef float ret_f[2];\nret_f f(float a) { float r[2] = { a, a }; return r; }\n\
        static const float A[2] = f(1.0);\nRWByteAddressBuffer answers : register(u1);\n\
        [numthreads(1, 1, 1)]\nvoid main() { answers.Store(0, asuint(A[1])); }\n";
    refused(array, Language::Hlsl);
    if let Some(answer) = spirv_val(&[0x0723_0203, 0]) {
        assert!(answer.is_err());
    }
}
