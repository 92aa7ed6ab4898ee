//! The house: layers are folders, and a file imports only from its own layer and lower ones.

use crate::source::{files_below, sources};
use std::fs;
use std::path::Path;

/// Folder or file under src/, and its layer.
const LAYERS: [(&str, u8); 11] = [
    ("error", 0),
    ("scalar", 0),
    ("wgsl", 0),
    ("slope", 1),
    ("ndf", 2),
    ("filter", 3),
    ("material", 4),
    ("batch", 5),
    ("shade", 5),
    ("gpu", 6),
    ("data", 6),
];

/// What fits into one reading.
const LONGEST: usize = 320;

/// Tables, one line for each thing: looked up, not read.
const TABLES: [&str; 1] = ["wgsl/list.rs"];

fn layer_of(name: &str) -> Option<u8> {
    LAYERS.iter().find(|(layer, _)| *layer == name).map(|&(_, number)| number)
}

/// The code of a file: comments blanked, lines kept.
fn code(text: &str) -> String {
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// The name that a path begins with.
fn first_name(path: &str) -> String {
    path.trim().chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

/// The members of a group `{a::x, b::{y, z}}`, from after its opening brace.
fn members(group: &str) -> Vec<&str> {
    let (mut found, mut start, mut depth) = (Vec::new(), 0, 0);
    for (at, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth > 0 => depth -= 1,
            ',' if depth == 0 => {
                found.push(&group[start..at]);
                start = at + 1;
            }
            '}' => {
                found.push(&group[start..at]);
                break;
            }
            _ => {}
        }
    }
    found
}

/// Line and first segment of every path after `crate::`: `crate::{a::x, b}` gives a and b.
fn imports(text: &str) -> Vec<(usize, String)> {
    let code = code(text);
    let mut found = Vec::new();
    for (at, _) in code.match_indices("crate::") {
        let (line, rest) = (code[..at].matches('\n').count() + 1, &code[at + "crate::".len()..]);
        let paths = rest.strip_prefix('{').map_or(vec![rest], members);
        let names = paths.into_iter().map(first_name).filter(|name| !name.is_empty());
        found.extend(names.map(|name| (line, name)));
    }
    found
}

/// What is wrong with the imports of one file; the root and the prelude may import anything.
fn complaints(file: &str, text: &str) -> Vec<String> {
    if ["lib.rs", "prelude.rs"].contains(&file) {
        return Vec::new();
    }
    let home = file.split('/').next().unwrap_or_default().trim_end_matches(".rs");
    let Some(layer) = layer_of(home) else {
        return vec![format!(
            "src/{file}: `{home}` has no layer; give it one in tests/texts/layers.rs"
        )];
    };
    let mut found = Vec::new();
    for (line, name) in imports(text) {
        let place = format!("src/{file}:{line}");
        match layer_of(&name) {
            None => found.push(format!(
                "{place}: `crate::{name}` is no layer; import from the module that defines it"
            )),
            Some(other) if other > layer => found.push(format!(
                "{place}: layer {layer} ({home}) imports from layer {other} ({name})"
            )),
            Some(_) => {}
        }
    }
    found
}

#[test]
fn files_import_from_lower_layers_only() {
    let found: Vec<String> =
        sources().iter().flat_map(|(file, text)| complaints(file, text)).collect();
    assert!(found.is_empty(), "imports that climb the stairs:\n{}", found.join("\n"));
}

#[test]
fn no_file_is_too_long_to_read() {
    let long: Vec<String> = sources()
        .iter()
        .filter(|(file, _)| !TABLES.contains(&file.as_str()))
        .map(|(file, text)| (file, text.lines().count()))
        .filter(|&(_, lines)| lines > LONGEST)
        .map(|(file, lines)| format!("src/{file}: {lines} lines, at most {LONGEST}: split it"))
        .collect();
    assert!(long.is_empty(), "files that have grown too long:\n{}", long.join("\n"));
}

#[test]
fn the_layer_law_notices_a_climb() {
    let climbs = complaints("slope/lobe.rs", "use crate::filter::Kernel;\n");
    assert_eq!(climbs, ["src/slope/lobe.rs:1: layer 1 (slope) imports from layer 3 (filter)"]);
    assert_eq!(complaints("filter/a.rs", "use crate::{scalar::Real, shade};\n").len(), 1);
    let lines =
        "use crate::{\n    scalar::{Psd, Real}, // crate::shade\n    shade::Material,\n};\n";
    assert_eq!(complaints("filter/a.rs", lines).len(), 1);
    assert_eq!(complaints("ndf/a.rs", "    x: crate::Kernel,\n").len(), 1);
    assert_eq!(complaints("attic/a.rs", "").len(), 1);
    assert!(complaints("filter/a.rs", "use crate::slope::Lobe; // not crate::shade\n").is_empty());
    assert!(complaints("ndf/a.rs", "/// [`Kernel`](crate::Kernel)\n").is_empty());
}

/// No line is longer than the columns that `rustfmt.toml` declares: rustfmt leaves comments,
/// strings, macros and other languages as they are.
#[test]
fn no_line_is_longer_than_declared() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let declared = fs::read_to_string(root.join("rustfmt.toml")).expect("a readable file");
    let width = declared.lines().find_map(|line| line.strip_prefix("max_width = "));
    let width: usize = width.and_then(|number| number.parse().ok()).expect("a number of columns");
    let mut files = Vec::new();
    for folder in ["src", "tests", "benches", "examples", "fuzz/fuzz_targets"] {
        for extension in ["rs", "wgsl", "py", "hpp", "cpp", "html", "css"] {
            files.extend(files_below(&root.join(folder), extension));
        }
    }
    let long: Vec<String> = files
        .iter()
        .flat_map(|file| {
            let text = fs::read_to_string(file).expect("a readable file");
            let numbered = text.lines().enumerate();
            let long = numbered.filter(|(_, line)| line.chars().count() > width);
            long.map(|(at, _)| format!("{}:{}", file.display(), at + 1)).collect::<Vec<_>>()
        })
        .collect();
    assert!(long.is_empty(), "lines beyond {width} columns:\n{}", long.join("\n"));
    assert!(files.len() > 300, "only {} files found", files.len());
}
