//! The WGSL port as a program of the system's C++ compilers: WGSL through naga to Metal's language,
//! and a header that stands in for Metal's standard library.
//!
//! Metal's compiler may assume that no number is NaN or infinite and take sums in any order, and so
//! may those of HLSL. No such compiler runs here; `-ffast-math` allows a C++ compiler the same, and
//! Clang shares its optimizer with Metal's.

use std::fmt::Write as _;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use lobe::wgsl::rebound;
use naga::back::msl;

use crate::size::size;
use crate::twins::{Twin, dictionary, library};
use lobe_report::spirv;

/// What naga's output needs of Metal's standard library.
const METAL: &str = include_str!("cpp/metal.hpp");
/// What evaluates twins on items from the standard input.
const MAIN: &str = include_str!("cpp/main.hpp");

/// What every program is compiled with.
const FLAGS: [&str; 3] = ["-std=c++17", "-w", "-fno-strict-aliasing"];

/// Words that one item may read or write, as `main.hpp` has it.
const WORDS: usize = 64;

/// Words that a dictionary may have, as `main.hpp` has it.
const DICTIONARY_WORDS: usize = 1 << 16;

/// The C++ compilers of the system: `$CXX` alone where it is set, else `c++` and `clang++` as far
/// as they are there. An ordinary run takes `clang++`, which assumes more, and `c++` only where
/// that is missing.
///
/// # Panics
///
/// If `$CXX` is set and does not run.
pub fn compilers() -> Vec<String> {
    let runs = |name: &String| {
        let asked = command(name).arg("--version").output();
        asked.is_ok_and(|output| output.status.success())
    };
    if let Some(name) = std::env::var("CXX").ok().filter(|name| !name.trim().is_empty()) {
        assert!(runs(&name), "$CXX does not run: {name}");
        return vec![name];
    }
    let all = [String::from("clang++"), String::from("c++")].into_iter().filter(runs);
    all.take(size(1, 2)).collect()
}

/// A compiler's name as a command; words after the first one are arguments, as in `ccache g++`.
fn command(compiler: &str) -> Command {
    let mut words = compiler.split_whitespace();
    let mut command = Command::new(words.next().unwrap_or_default());
    command.args(words);
    command
}

/// A program that evaluates twins.
#[derive(Debug)]
pub struct Program {
    path: PathBuf,
}

impl Program {
    /// Compiles `twins` with `flags` to a file in `folder`, whose name ends in a hash of compiler,
    /// flags and source, and leaves the source beside it. A program that is there already is not
    /// compiled again.
    ///
    /// # Errors
    ///
    /// What naga, the file system or the compiler says.
    ///
    /// # Panics
    ///
    /// If a twin or the dictionary has more words than `main.hpp` holds.
    pub fn new(
        compiler: &str,
        flags: &[&str],
        twins: &[Twin],
        folder: &Path,
    ) -> Result<Self, String> {
        let run = |command: &mut Command| {
            let output = command.output().map_err(|error| format!("{compiler}: {error}"))?;
            let said = if output.status.success() { &output.stdout } else { &output.stderr };
            let said = String::from_utf8_lossy(said).into_owned();
            if output.status.success() { Ok(said) } else { Err(format!("{compiler}: {said}")) }
        };
        let text = text(twins)?;
        let version = run(command(compiler).arg("--version"))?;
        let mut hasher = DefaultHasher::new();
        (compiler, version, FLAGS, flags, &text).hash(&mut hasher);
        let path = folder.join(format!("twins_{:016x}", hasher.finish()));
        if path.exists() {
            return Ok(Self { path });
        }
        // By process, as two runs at once may share the folder; in place as a whole.
        let built = path.with_extension(std::process::id().to_string());
        let source = built.with_extension(format!("{}.cpp", std::process::id()));
        let of = |file: &Path| {
            let name = file.display().to_string();
            move |error: std::io::Error| format!("{name}: {error}")
        };
        std::fs::write(&source, text).map_err(of(&source))?;
        run(command(compiler).args(FLAGS).args(flags).args([
            source.as_path(),
            Path::new("-o"),
            &built,
        ]))?;
        std::fs::rename(&source, path.with_extension("cpp")).map_err(of(&source))?;
        std::fs::rename(&built, &path).map_err(of(&built))?;
        Ok(Self { path })
    }

    /// The results of the twins that it was made of, each on its own inputs.
    ///
    /// # Errors
    ///
    /// If the program does not end well, or answers less than it was asked.
    ///
    /// # Panics
    ///
    /// If the program cannot be talked to.
    pub fn run(&self, twins: &[Twin], inputs: &[Vec<f32>]) -> Result<Vec<Vec<f32>>, String> {
        let mut child = Command::new(&self.path)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("{}: {error}", self.path.display()))?;
        let mut stdin = child.stdin.take().expect("piped above");
        let mut words = bytes(dictionary().as_flattened());
        for (twin, floats) in twins.iter().zip(inputs) {
            let count = u32::try_from(floats.len() / twin.reads()).expect("few items");
            words.extend(count.to_le_bytes());
            words.extend(bytes(floats));
        }
        // A program that ends early takes no more; its exit status tells.
        let writer = std::thread::spawn(move || stdin.write_all(&words).is_ok());
        let output = child.wait_with_output().expect("the program ends");
        let written = writer.join().expect("writing does not panic");
        if !output.status.success() || !written {
            return Err(format!("{}: {}", self.path.display(), output.status));
        }
        let mut answers = output.stdout.as_chunks::<4>().0.iter().map(|x| f32::from_le_bytes(*x));
        twins
            .iter()
            .zip(inputs)
            .map(|(twin, floats)| {
                let count = floats.len() / twin.reads() * twin.writes();
                let results: Vec<f32> = answers.by_ref().take(count).collect();
                let whole = results.len() == count;
                whole.then_some(results).ok_or(format!("{}: no answer", twin.name))
            })
            .collect()
    }
}

fn bytes(floats: &[f32]) -> Vec<u8> {
    floats.iter().flat_map(|x| x.to_le_bytes()).collect()
}

/// The program's text: the header, what naga writes, and a call for each twin.
fn text(twins: &[Twin]) -> Result<String, String> {
    let metal = metal(twins)?;
    let mut calls = String::new();
    for (k, twin) in twins.iter().enumerate() {
        let function = format!("kernel void twin_{k}_(");
        let (_, after) = metal.split_once(&function).ok_or(format!("naga wrote no {function}"))?;
        let (parameters, _) = after.split_once(") {").ok_or(format!("no body of {function}"))?;
        // Functions take the buffers that they use, in this order.
        let buffers = ["dictionary", "inputs", "outputs"];
        let arguments =
            buffers.into_iter().filter(|name| parameters.contains(&format!("_{name} ")));
        let arguments = arguments.collect::<Vec<_>>().join(", ");
        let (reads, writes) = (twin.reads(), twin.writes());
        let _ = writeln!(calls, "    run([] {{ twin_{k}_({arguments}); }}, {reads}, {writes});");
    }
    let words = 2 * dictionary().len();
    assert!(words <= DICTIONARY_WORDS, "the dictionary has {words} words, main.hpp takes fewer");
    Ok(format!(
        "{METAL}\n{metal}\n{MAIN}\nint main() {{\n    read_words(dictionary_words, \
            {words});\n{calls}}}\n"
    ))
}

/// What naga writes of the twins, each with an entry point.
fn metal(twins: &[Twin]) -> Result<String, String> {
    // Arrays with a length: C++ has none without.
    let sized = format!("lobe_dictionary: array<vec2f, {}>", dictionary().len());
    let library = rebound(&library(twins), 0, 2).replace("lobe_dictionary: array<vec2f>", &sized);
    let mut wgsl = format!(
        "{library}
@group(0) @binding(0) var<storage, read> item_inputs: array<u32, {WORDS}>;
@group(0) @binding(1) var<storage, read_write> item_outputs: array<u32, {WORDS}>;
fn bits_at(k: u32) -> u32 {{ return item_inputs[k]; }}
fn at(k: u32) -> f32 {{ return bitcast<f32>(bits_at(k)); }}
fn put(k: u32, value: f32) {{ item_outputs[k] = bitcast<u32>(value); }}
"
    );
    for (k, twin) in twins.iter().enumerate() {
        let most = twin.reads().max(twin.writes());
        assert!(most <= WORDS, "{} reads or writes more than {WORDS} words", twin.name);
        let body = twin.body();
        let _ = write!(wgsl, "@compute @workgroup_size(1)\nfn twin_{k}_() {{\n{body}\n}}\n");
    }
    let (module, info) = spirv::validated(&wgsl)?;
    // As `examples/wgsl` translates.
    let options = msl::Options {
        lang_version: (2, 0),
        fake_missing_bindings: true,
        force_loop_bounding: false,
        ..msl::Options::default()
    };
    let (text, _) = msl::write_string(&module, &info, &options, &msl::PipelineOptions::default())
        .map_err(|error| error.to_string())?;
    Ok(single(&text.replace("#include <", "// ")))
}

/// Literals of Metal's language are single precision, where C++ has double.
fn single(metal: &str) -> String {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '.';
    let mut text = String::with_capacity(metal.len());
    for piece in metal.split_inclusive(|c: char| !is_part(c)) {
        let word = piece.trim_end_matches(|c: char| !is_part(c));
        let is_float = word.starts_with(|c: char| c.is_ascii_digit()) && word.contains('.');
        text.push_str(word);
        text.push_str(if is_float { "f" } else { "" });
        text.push_str(&piece[word.len()..]);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_become_single_and_nothing_else_changes() {
        let metal = "float a_1 = (-0.5 * x.y) + 1.0; uint b = 0x7fu; v.inner[4] = 12582912.0;";
        let wanted = "float a_1 = (-0.5f * x.y) + 1.0f; uint b = 0x7fu; v.inner[4] = 12582912.0f;";
        assert_eq!(single(metal), wanted);
    }
}
