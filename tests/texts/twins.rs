//! The WGSL port's bijection: each public function has its twin or a reason, docs name each other,
//! constants are bit-equal.
#![cfg(all(feature = "wgsl", feature = "published", feature = "glint"))]
#![allow(clippy::incompatible_msrv, reason = "tests need a newer compiler, for their oracles")]

mod rust;
mod wgsl;

use crate::source::sources;
use crate::written::written;
use lobe::filter::VmfWidening;
use lobe::filter::engine::Engine;
use lobe::wgsl::{Item, Module};
use lobe::{Footprint, Kernel, PixelFilter, Real};
use rust::{Function, aliases, functions, value};
use wgsl::{Declared, declared};

/// Methods of operators, whose aliases stand at their types.
const OPERATORS: [&str; 3] = ["add", "sub", "mul"];

/// The Rust file of a module.
fn rust_text(path: &str) -> Option<String> {
    let file = format!("{}/src/{path}.rs", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(file).ok()
}

/// Rust files whose functions a module has: its own, and those whose generics it spells out.
fn homes(path: &str) -> Vec<&str> {
    match path {
        "ndf/ggx" | "ndf/beckmann" => vec![path, "ndf/distribution", "ndf/masking"],
        "slope/anisotropic" | "slope/non_centered" | "slope/widened" => {
            vec![path, "slope/shape", "slope/whiten"]
        }
        "filter/polygon/lanes" => vec![path, "filter/polygon/halves"],
        _ if path.starts_with("scalar/") => vec![path, "scalar/real"],
        _ => vec![path],
    }
}

/// Every Rust file but those that no shader can use, by its path without the extension.
fn rust_files() -> Vec<(String, String)> {
    let used = |name: &str| !name.starts_with("wgsl/") && !name.starts_with("scalar/probe/");
    let files = sources().into_iter().filter(|(name, _)| used(name));
    files.map(|(name, text)| (name.replace(".rs", ""), text)).collect()
}

/// A public function without a twin, and the reason.
struct RustOnly {
    reason: &'static str,
    file: &'static str,
    path: &'static str,
}

/// The functions of `rust_only.txt`.
fn rust_only() -> Vec<RustOnly> {
    let (mut found, mut reason) = (Vec::new(), "");
    for line in include_str!("twins/rust_only.txt").lines().filter(|line| !line.starts_with('#')) {
        match line.strip_prefix("    ").and_then(|entry| entry.split_once(' ')) {
            Some((file, path)) => found.push(RustOnly { reason, file, path }),
            None => reason = line,
        }
    }
    found
}

/// What is wrong with the names in WGSL of a public function, against what the port declares.
fn complaint(
    file: &str,
    function: &Function,
    port: &[(&str, Declared)],
    only: &[RustOnly],
) -> Option<String> {
    let place = format!("src/{file}.rs, {}", function.path);
    let alone = only.iter().any(|only| only.file == file && only.path == function.path);
    if alone != function.aliases.is_empty() {
        return Some(if alone {
            format!("{place}: has a twin, and stands in rust_only.txt")
        } else {
            format!("{place}: has neither a `doc(alias)` of its twin nor a line in rust_only.txt")
        });
    }
    for name in &function.aliases {
        let twin = port
            .iter()
            .find(|(path, declared)| declared.name == *name && homes(path).contains(&file));
        let Some((_, twin)) = twin else {
            return Some(format!("{place}: names {name}, which its file of the port has not"));
        };
        if !twin.twins.iter().any(|twin| function.is(twin)) {
            return Some(format!(
                "{place}: names {name}, which does not name it: {:?}",
                twin.twins
            ));
        }
    }
    None
}

fn port() -> Vec<(&'static str, Declared)> {
    let all = Module::ALL.iter();
    all.flat_map(|module| declared(module.body()).into_iter().map(|d| (module.path(), d))).collect()
}

#[test]
fn each_public_function_names_its_twin_or_a_reason() {
    let (port, only) = (port(), rust_only());
    let mut found = Vec::new();
    let mut count = 0;
    for (file, text) in rust_files() {
        for function in functions(&text).iter().filter(|function| function.public) {
            count += 1;
            found.extend(complaint(&file, function, &port, &only));
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
    assert!(count > 150, "only {count} public functions found");
}

#[test]
fn functions_without_a_twin_exist() {
    for RustOnly { reason, file, path } in rust_only() {
        let text = rust_text(file).unwrap_or_else(|| panic!("rust_only.txt: no src/{file}.rs"));
        let known = functions(&text).iter().any(|f| f.public && f.path == path);
        assert!(known, "rust_only.txt: no public {path} in src/{file}.rs");
        assert!(reason.len() > 3, "rust_only.txt: no reason for {path}");
    }
}

#[test]
fn each_function_of_the_port_names_its_twin() {
    let mut found = Vec::new();
    for (path, declared) in port() {
        let texts: Vec<String> = homes(path).into_iter().filter_map(rust_text).collect();
        let all: Vec<Function> = texts.iter().flat_map(|text| functions(text)).collect();
        let place = format!("src/wgsl/{path}.wgsl, {}", declared.name);
        if declared.twins.is_empty() && !declared.alone {
            found.push(format!("{place}: says neither `Rust: ` nor `WGSL only: `"));
        }
        for twin in &declared.twins {
            let last = twin.rsplit("::").next().unwrap_or_default();
            let stated = texts.iter().any(|text| {
                ["struct ", "const ", "trait ", "    "]
                    .iter()
                    .any(|kind| text.contains(&format!("{kind}{last}")))
            });
            let known = all.iter().any(|function| function.is(twin));
            if !(known || (!declared.name.starts_with("lobe_") && stated)) {
                found.push(format!("{place}: there is no `{twin}` in {:?}", homes(path)));
            }
            // A public function or operator that the port has names it, and can be asked for.
            let operator = OPERATORS.contains(&last);
            let public = all.iter().find(|f| (f.public || operator) && f.is(twin));
            let short = declared.name.strip_prefix("lobe_");
            if let (Some(function), Some(short)) = (public, short) {
                let at_type = || {
                    let (home, _) = twin.split_once("::").unwrap_or_default();
                    let of_type = |text: &str| text.contains(&format!("pub struct {home}"));
                    let files = rust_files();
                    files
                        .iter()
                        .any(|(_, text)| of_type(text) && aliases(text).contains(&declared.name))
                };
                let named = function.aliases.contains(&declared.name) || operator && at_type();
                if !named {
                    found.push(format!("{place}: `{twin}` does not name it"));
                }
                if Item::from_name(short).is_err() {
                    found.push(format!("{place}: is no item"));
                }
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn twins_come_in_the_order_of_their_functions() {
    let mut found = Vec::new();
    for module in Module::ALL {
        let Some(text) = rust_text(module.path()) else { continue };
        let order = functions(&text);
        let places = declared(module.body()).into_iter().filter_map(|declared| {
            let twin = declared.twins.first()?;
            // Of a trait's method there is one, of its twins one for each type.
            let place = order.iter().position(|function| function.path == *twin)?;
            Some((place, declared.name))
        });
        let places: Vec<(usize, String)> = places.collect();
        for pair in places.windows(2) {
            if pair[0].0 > pair[1].0 {
                found.push(format!(
                    "src/wgsl/{}.wgsl: {} after {}",
                    module.path(),
                    pair[0].1,
                    pair[1].1
                ));
            }
        }
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn every_item_is_declared_and_says_its_twin() {
    let port = port();
    for item in Item::ALL {
        let name = item.name();
        let is_file = item.module().is_some();
        let whole = [format!("lobe_{name}"), format!("LOBE_{name}")];
        let found = port.iter().find(|(_, declared)| whole.contains(&declared.name));
        assert!(is_file || found.is_some(), "{name} is not declared");
        if let Some((_, declared)) = found
            && !is_file
        {
            assert_eq!(item.twin(), declared.twins.first().map(String::as_str), "{name}");
        }
    }
}

/// Constants that Rust states as values of its own types.
fn public_constant(twin: &str) -> Option<f32> {
    let variance = |filter: PixelFilter| filter.variance() as f32;
    Some(match twin {
        "Real::PI" => <f32 as Real>::PI,
        "Real::EPSILON" => <f32 as Real>::EPSILON,
        "Real::MIN_POSITIVE" => <f32 as Real>::MIN_POSITIVE,
        "Real::MAX" => <f32 as Real>::MAX,
        "Real::LARGEST" => <f32 as Real>::LARGEST,
        "PixelFilter::BOX" => variance(PixelFilter::BOX),
        "PixelFilter::KAPLANYAN" => variance(PixelFilter::KAPLANYAN),
        "PixelFilter::TOKUYOSHI_KAPLANYAN" => variance(PixelFilter::TOKUYOSHI_KAPLANYAN),
        "PixelFilter::KAPLANYAN_PROXY" => variance(PixelFilter::KAPLANYAN_PROXY),
        "Footprint::WIDTH_LIMIT" => Footprint::<f32>::WIDTH_LIMIT as f32,
        "Kernel::ALPHA_SQUARED_LIMIT" => Kernel::<f32>::ALPHA_SQUARED_LIMIT as f32,
        "VmfWidening::THE_ORDER" => VmfWidening::THE_ORDER.gain() as f32,
        "VmfWidening::SPECULAR_AA" => VmfWidening::SPECULAR_AA.gain() as f32,
        "inverse_pi" => core::f64::consts::FRAC_1_PI as f32,
        _ => {
            let engine = twin.strip_prefix("Engine::")?;
            Engine::ALL.iter().position(|all| format!("{all:?}") == engine)? as f32
        }
    })
}

/// The table of names that the documentation of `lobe::wgsl::names` shows.
fn names() -> String {
    let mut rows = vec!["| Rust | WGSL |".to_owned(), "|---|---|".to_owned()];
    let all = rust_files();
    let given =
        |name: &str| all.iter().any(|(_, text)| aliases(text).iter().any(|alias| alias == name));
    let private = |path: &str, twin: &str| {
        let texts: Vec<String> = homes(path).into_iter().filter_map(rust_text).collect();
        let operator = twin.rsplit("::").next().is_some_and(|last| OPERATORS.contains(&last));
        let found = texts.iter().flat_map(|text| functions(text)).find(|f| f.is(twin));
        found.is_some_and(|function| !function.public && !operator && !function.of_trait)
    };
    let mut alone = Vec::new();
    for (path, declared) in port() {
        let short = declared.name.split_once('_').map_or("", |(_, short)| short);
        let asked = Item::from_name(short).is_ok();
        let name = &declared.name;
        let twins = declared.twins.iter().filter(|twin| !private(path, twin));
        let known: Vec<&String> = twins.filter(|_| asked || given(name)).collect();
        rows.extend(known.iter().map(|twin| format!("| `{twin}` | `{name}` |")));
        if asked && known.is_empty() {
            alone.push(format!("- `{name}`"));
        }
    }
    rows.extend(["", "# Only in WGSL", ""].map(String::from));
    rows.extend(["What Rust has as generics, as closures or not at all.", ""].map(String::from));
    rows.extend(alone);
    rows.extend(
        ["", "# Only in Rust", "", "| Reason, or what stands in | Rust |"].map(String::from),
    );
    rows.push("|---|---|".to_owned());
    let only = rust_only();
    let mut reasons: Vec<&str> = only.iter().map(|only| only.reason).collect();
    reasons.dedup();
    rows.extend(reasons.into_iter().map(|reason| {
        let of_reason = only.iter().filter(|only| only.reason == reason);
        let paths: Vec<String> = of_reason.map(|only| format!("`{}`", only.path)).collect();
        format!("| {reason} | {} |", paths.join(", "))
    }));
    rows.join("\n") + "\n"
}

#[test]
fn the_table_of_names_is_written_down() {
    written("src/wgsl/names.md", &names());
}

#[test]
fn constants_are_bit_equal() {
    let mut count = 0;
    for (path, declared) in port().iter().filter(|(_, declared)| declared.name.starts_with("LOBE_"))
    {
        let Some(twin) = declared.twins.first() else { continue };
        count += 1;
        let want: Vec<f32> = match public_constant(twin) {
            Some(value) => vec![value],
            None => homes(path)
                .into_iter()
                .find_map(|home| value(&rust_text(home)?, twin))
                .unwrap_or_else(|| panic!("no constant {twin} in {:?}", homes(path))),
        };
        assert!(!declared.numbers.is_empty(), "{} has no number", declared.name);
        let weights = declared.name.ends_with("_WEIGHTS");
        let got = &declared.numbers;
        // Quadrature rules state nodes, then weights, and the WGSL port half of the longest.
        let want = if twin.starts_with("GAUSS_") {
            let (nodes, rest) = want.split_at(want.len() / 2);
            (if weights { rest } else { nodes })[..got.len()].to_vec()
        } else {
            want
        };
        let bits = |values: &[f32]| values.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(got), bits(&want), "{} against {twin}: {got:?}, {want:?}", declared.name);
    }
    assert!(count > 40, "only {count} constants found");
}

#[test]
fn the_laws_notice() {
    let of = |text: &str| functions(text).pop().expect("a function");
    let port = [(
        "slope/ray",
        declared("// Rust: `step`.\nfn lobe_ray_step() {\n}\n").pop().expect("one"),
    )];
    let only = [RustOnly { reason: "text", file: "slope/ray", path: "name" }];
    let says = |text: &str| complaint("slope/ray", &of(text), &port, &only);
    let alias = |name: &str, function: &str| {
        says(&format!("/// A.\n#[doc(alias = \"lobe_{name}\")]\npub fn {function}() {{}}\n"))
    };
    assert!(says("/// A.\npub fn step() {}\n").expect("silent").contains("neither"));
    assert!(alias("step", "step").expect("wrong").contains("has not"));
    assert!(alias("ray_step", "stop").expect("other").contains("does not name it"));
    assert!(alias("ray_step", "name").expect("both").contains("stands in"));
    assert_eq!(alias("ray_step", "step"), None);
    assert_eq!(says("/// A.\npub fn name() {}\n"), None);
    assert_eq!(value("const A: f64 = 2.0 * 0.5 / 4.0;\n", "A"), Some(vec![0.25]));
    assert_eq!(value("const A: [f32; 2] = [1.5,\n -2.0];\n", "A"), Some(vec![1.5, -2.0]));
}
