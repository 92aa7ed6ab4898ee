//! The command line of examples/wgsl: texts, mistakes in one line, and nothing half-written.
#![cfg(feature = "wgsl")]

use lobe::wgsl::{Item, Module, Preset, source};
use std::fs;
use std::path::PathBuf;
use std::process::{Command, Output};
use std::sync::OnceLock;

fn wgsl(arguments: &[&str]) -> Output {
    static EXAMPLE: OnceLock<PathBuf> = OnceLock::new();
    let example =
        EXAMPLE.get_or_init(|| crate::program::example("wgsl", &["examples/wgsl", "src"]));
    Command::new(example).args(arguments).output().expect("the example runs")
}

/// What it prints, if it succeeds.
#[track_caller]
fn printed(arguments: &[&str]) -> String {
    let output = wgsl(arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {said}");
    assert!(said.is_empty(), "{said}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

/// What it complains of: one line, and nothing is printed.
#[track_caller]
fn complaint(arguments: &[&str]) -> String {
    let output = wgsl(arguments);
    let said = String::from_utf8(output.stderr).expect("UTF-8");
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {said}");
    assert!(output.stdout.is_empty());
    assert_eq!(said.lines().count(), 1, "{said}");
    said
}

/// A folder of the test's own, empty.
fn folder(name: &str) -> PathBuf {
    crate::program::folder("wgsl", name)
}

#[test]
fn items_and_presets_are_the_librarys_text() {
    let items = [Item::FilterProjected, Item::GgxD, Item::Pi];
    assert_eq!(printed(&["--items", "ggx_d, filter_projected,PI"]), source(&items));
    for preset in Preset::ALL {
        assert_eq!(printed(&["--preset", preset.name(), "--lang", "wgsl"]), preset.source());
    }
}

#[test]
fn an_entry_point_is_appended_when_asked_for() {
    let text = printed(&["--items", "ggx_d", "--entry"]);
    let rest = text.strip_prefix(&source(&[Item::GgxD])).expect("the library's text first");
    assert!(rest.contains("@compute") && rest.contains("lobe_ggx_d("), "{rest}");
    assert!(printed(&["--preset", "facade", "--entry"]).contains("@fragment\nfn main()"));
}

#[test]
fn the_list_names_everything() {
    let list = printed(&["--list"]);
    for item in Item::ALL {
        let line = list.lines().find(|line| line.split_whitespace().next() == Some(item.name()));
        let line = line.unwrap_or_else(|| panic!("{} is missing", item.name()));
        assert!(line.ends_with(item.twin().unwrap_or(item.name())), "{line}");
    }
    for preset in Preset::ALL {
        assert!(list.contains(&format!("\n{} ", preset.name())), "{}", preset.name());
    }
}

#[test]
fn translations_say_what_was_added() {
    let marks = [
        ("glsl", "#version 450", "void main()"),
        ("glsl-330", "#version 330", "void main()"),
        ("glsl-es", "#version 310 es", "void main()"),
        ("glsl-es-300", "#version 300 es", "void main()"),
        ("hlsl", "// Translated", "void main("),
        ("msl", "// Translated", "kernel void main_("),
    ];
    for (language, first, main) in marks {
        let text = printed(&["--items", "ggx_d", "--lang", language]);
        assert!(text.starts_with(first), "{language}: {text}");
        assert!(text.contains("no part of the items"), "{language}");
        assert!(text.contains(main) && text.contains("lobe_ggx_d("), "{language}: {text}");
    }
    let fragment = printed(&["--preset", "forward_variance", "--lang", "glsl"]);
    assert!(fragment.contains("dFdx") && fragment.contains("lobe_fragment_footprint("));
    let arrays = printed(&["--items", "exp", "--lang", "hlsl"]);
    assert!(arrays.contains("static const float LOBE_EXP[5] = { "), "{arrays}");
}

#[test]
fn a_dictionary_is_a_texture_where_there_are_no_buffers() {
    for (language, declared) in [
        ("glsl", "vec2 lobe_dictionary[];"),
        ("glsl-330", "uniform sampler2D lobe_dictionary;"),
        ("glsl-es", "vec2 lobe_dictionary[];"),
        ("glsl-es-300", "uniform highp sampler2D lobe_dictionary;"),
    ] {
        let text = printed(&["--items", "marginal_density", "--lang", language]);
        assert!(text.contains(declared), "{language}: {text}");
    }
}

#[test]
fn spirv_is_hexadecimal_in_print_and_binary_in_files() {
    let printed = printed(&["--items", "ggx_d", "--lang", "spirv"]);
    let words: Vec<u32> = printed
        .split_whitespace()
        .map(|word| u32::from_str_radix(word.trim_start_matches("0x"), 16).expect("hexadecimal"))
        .collect();
    assert_eq!(words[0], 0x0723_0203);
    let file = folder("spirv").join("ggx_d.spv");
    let path = file.to_str().expect("UTF-8");
    assert!(wgsl(&["--items", "ggx_d", "--lang", "spirv", "--out", path]).status.success());
    let bytes: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    assert_eq!(fs::read(file).expect("a file"), bytes);
}

#[test]
fn linkers_get_the_files_that_they_need_and_no_other() {
    for (language, ending) in [("wesl", "wesl"), ("naga-oil", "wgsl")] {
        let target = folder(language).join("lobe");
        let path = target.to_str().expect("UTF-8");
        assert_eq!(printed(&["--items", "ggx_d", "--lang", language, "--out", path]), "");
        let whole = printed(&["--items", "ggx_d", "--lang", language]);
        for module in Module::ALL {
            let name = format!("{}.{ending}", module.path());
            let text = if ending == "wesl" { module.wesl() } else { module.naga_oil() };
            let heading = format!("// {name}\n");
            assert_eq!(target.join(&name).exists(), whole.contains(&heading), "{name}");
            if let Ok(written) = fs::read_to_string(target.join(&name)) {
                assert_eq!(written, text);
                assert!(whole.contains(&format!("{heading}{text}")), "{name}");
            }
        }
        assert!(target.join(format!("ndf/ggx.{ending}")).exists());
        assert!(!target.join(format!("ndf/beckmann.{ending}")).exists());
        let again = complaint(&["--items", "ggx_d", "--lang", language, "--out", path]);
        assert!(again.contains("does not exist"), "{again}");
    }
}

#[test]
fn mistakes_are_one_line_that_names_them() {
    let cases: [(&[&str], &str); 15] = [
        (&["--items", "ggx_d,ggx_e"], "`ggx_e`"),
        (&["--items", ""], "--items : a name is empty"),
        (&["--items", "ggx_d,"], "--items ggx_d,: a name is empty"),
        (&["--preset", "plane"], "`plane`"),
        (&["--items", "ggx_d", "--lang", "cg"], "`cg`"),
        (&["--items", "ggx_d", "--preset", "plain"], "exclude"),
        (&["--items", "ggx_d", "--lang", "hlsl", "--entry"], "--entry"),
        (&[], "--items, --preset or --list"),
        (&["--items", "ggx_d", "--out", "/"], "cannot write /"),
        (&["foo"], "'foo'"),
        (&["--preset", "plain", "--list"], "--list"),
        (&["--list", "--lang", "hlsl"], "--list"),
        (&["--items", "a", "--items", "b"], "--items"),
        (&["--items", "ggx_d", "--out", ""], "--out"),
        (&["--items", "ggx_d", "--lang"], "--lang"),
    ];
    for (arguments, said) in cases {
        let complaint = complaint(arguments);
        assert!(complaint.starts_with("wgsl: ") && complaint.contains(said), "{complaint}");
    }
}

#[test]
fn what_cannot_be_written_leaves_nothing() {
    let folder = folder("nothing");
    let file = folder.join("plain.wgsl");
    let path = file.to_str().expect("UTF-8");
    complaint(&["--items", "ggx_e", "--out", path]);
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 0);
    printed(&["--preset", "plain", "--out", path]);
    printed(&["--preset", "facade", "--out", path]);
    assert_eq!(fs::read_to_string(&file).expect("a file"), Preset::Facade.source());
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 1);
    let missing = folder.join("missing/plain.wgsl");
    complaint(&["--preset", "plain", "--out", missing.to_str().expect("UTF-8")]);
    complaint(&["--preset", "plain", "--out", folder.to_str().expect("UTF-8")]);
    assert_eq!(fs::read_dir(&folder).expect("a folder").count(), 1);
}
