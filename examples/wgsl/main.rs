//! The WGSL of items or of a preset, or its translation.
//!
//! `cargo run --example wgsl -- --items ggx_d,filter_projected --lang hlsl`; `--list` names the
//! items and the presets. Exit status: 0, or 2 for what does not exist or cannot be written; then
//! nothing is written.

mod entry;
mod link;
#[path = "../common/mistake.rs"]
mod mistake;
mod output;
#[path = "../common/print.rs"]
mod print;
#[path = "../common/say.rs"]
mod say;
mod translate;

use clap::Parser;
use entry::{Device, Shader};
use link::Linker;
use lobe::wgsl::{Item, Preset, source};
use output::Output;
use std::path::PathBuf;
use std::process::ExitCode;
use translate::{Language, Translation, translate};

/// Print the WGSL of items or of a preset, or its translation.
#[derive(Parser)]
#[command(after_help = "Languages: wgsl, wesl, naga-oil, glsl (4.50), glsl-330, glsl-es (3.10), \
        glsl-es-300, hlsl (5.1), \
    msl (2.0), spirv (1.3).\nglsl-es-300 is for WebGL 2 and glsl-330 for OpenGL 3.3 to 4.1: a \
    dictionary is a texture \
    there (`lobe::wgsl::textured` says how it is filled).\nwesl and naga-oil are several files: \
    --out is a folder that does not exist.\n\
    spirv is printed as words in hexadecimal, and written to --out as it is.")]
struct Options {
    /// Names of functions without `lobe_`, of constants without `LOBE_`, or of files, with commas
    /// between.
    #[arg(long, value_name = "NAMES")]
    items: Option<String>,
    /// The name of a preset.
    #[arg(long, value_name = "NAME")]
    preset: Option<String>,
    /// The items with what they are in Rust, and the presets.
    #[arg(long, conflicts_with_all = ["items", "preset", "lang", "entry"])]
    list: bool,
    /// The language.
    #[arg(long, value_name = "NAME", default_value = "wgsl")]
    lang: String,
    /// An entry point that calls every item, as translations have it; for wgsl alone.
    #[arg(long)]
    entry: bool,
    /// The file or folder to write, instead of printing.
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,
}

/// The items of the command line.
fn asked(options: &Options) -> Result<Vec<Item>, String> {
    match (&options.items, &options.preset) {
        (Some(names), None) => names
            .split(',')
            .map(|name| match name.trim() {
                "" => Err(format!("--items {names}: a name is empty")),
                name => Item::from_name(name).map_err(|error| format!("--items: {error}")),
            })
            .collect(),
        (None, Some(name)) => Preset::ALL
            .iter()
            .find(|preset| preset.name() == name)
            .map(|preset| preset.items().to_vec())
            .ok_or_else(|| format!("--preset: no preset is named `{name}`")),
        (Some(_), Some(_)) => Err("--items and --preset exclude each other".to_owned()),
        (None, None) => Err("give --items, --preset or --list".to_owned()),
    }
}

fn output(options: &Options) -> Result<Output, String> {
    if options.list {
        return Ok(Output::Text(list()));
    }
    let items = asked(options)?;
    if options.entry && options.lang != "wgsl" {
        return Err("--entry is for --lang wgsl: translations have it, files have none".to_owned());
    }
    let linked = |linker: Linker| {
        let modules = link::needed(&items).into_iter();
        Ok(Output::Files(modules.map(|m| (linker.file(m), linker.text(m))).collect()))
    };
    match options.lang.as_str() {
        "wgsl" if options.entry => Ok(Output::Text(Shader::new(&items, Device::Buffers)?.text)),
        "wgsl" => Ok(Output::Text(source(&items))),
        "wesl" => linked(Linker::Wesl),
        "naga-oil" => linked(Linker::NagaOil),
        name => match Language::ALL.iter().find(|language| language.name() == name) {
            Some(language) => translated(&items, *language),
            None => Err(format!("--lang: no language is named `{name}`; --help lists them")),
        },
    }
}

/// The items in another language, under a line that says what was added.
fn translated(items: &[Item], language: Language) -> Result<Output, String> {
    let shader = Shader::new(items, language.device())?;
    let text = match translate(&shader, language)? {
        Translation::Words(words) => return Ok(Output::Words(words)),
        Translation::Text(text) => text,
    };
    let note = "// Translated by naga from the WGSL of lobe. The entry point and its buffers are \
        no part of the items:\n\
        // they call each of them, because translators drop functions that no entry point calls. Put
        // yours there.\n";
    // GLSL's version must be the first line of all.
    let (first, rest) = match text.split_once('\n') {
        Some((first, rest)) if first.starts_with("#version") => (format!("{first}\n"), rest),
        _ => (String::new(), text.as_str()),
    };
    Ok(Output::Text(format!("{first}{note}{rest}")))
}

/// Every item and preset, one a line.
fn list() -> String {
    let items = Item::ALL.iter().map(|item| match item.twin() {
        Some(twin) => format!("{:44} {twin}\n", item.name()),
        None => format!("{}\n", item.name()),
    });
    let presets = Preset::ALL.iter().map(|preset| {
        let names: Vec<&str> = preset.items().iter().map(|item| item.name()).collect();
        format!("{:44} {}\n", preset.name(), names.join(","))
    });
    format!(
        "Items, and what they are in Rust:\n{}\nPresets, and their items:\n{}",
        items.collect::<String>(),
        presets.collect::<String>()
    )
}

fn main() -> ExitCode {
    let options = match Options::try_parse() {
        Ok(options) => options,
        Err(error) => return mistake::told("wgsl", &error),
    };
    match output(&options).and_then(|output| output.put(options.out.as_deref())) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => print::failed("wgsl", &message, false),
    }
}
