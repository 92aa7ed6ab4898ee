//! From WGSL to other languages, by naga.

use super::entry::{Device, Shader};
use naga::back::{glsl, hlsl, msl, spv};
use naga::proc::BoundsCheckPolicies;
use naga::{ResourceBinding, ShaderStage};

/// A language that naga writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Language {
    /// Desktop GLSL, 4.50.
    Glsl,
    /// Desktop GLSL, 3.30: the first that turns floats into bits. macOS ends at 4.10, without
    /// storage buffers.
    Glsl330,
    /// GLSL of OpenGL ES, 3.10: the first with storage buffers.
    GlslEs,
    /// GLSL of OpenGL ES, 3.00: that of WebGL 2.
    GlslEs300,
    /// HLSL, shader model 5.1.
    Hlsl,
    /// Metal's language, 2.0.
    Msl,
    /// SPIR-V 1.3, that of Vulkan 1.1.
    Spirv,
}

impl Language {
    /// All that naga writes.
    pub(crate) const ALL: &[Self] = &[
        Self::Glsl,
        Self::Glsl330,
        Self::GlslEs,
        Self::GlslEs300,
        Self::Hlsl,
        Self::Msl,
        Self::Spirv,
    ];

    /// Its name on a command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Glsl => "glsl",
            Self::Glsl330 => "glsl-330",
            Self::GlslEs => "glsl-es",
            Self::GlslEs300 => "glsl-es-300",
            Self::Hlsl => "hlsl",
            Self::Msl => "msl",
            Self::Spirv => "spirv",
        }
    }

    /// The devices that run it.
    pub(crate) fn device(self) -> Device {
        match self {
            Self::Glsl330 | Self::GlslEs300 => Device::Textures,
            _ => Device::Buffers,
        }
    }
}

/// A translated module.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Translation {
    /// Source text.
    Text(String),
    /// SPIR-V.
    Words(Vec<u32>),
}

impl Translation {
    /// The text; SPIR-V as words in hexadecimal, eight a line.
    pub(crate) fn text(self) -> String {
        let words = match self {
            Self::Text(text) => return text,
            Self::Words(words) => words,
        };
        let lines = words.chunks(8).map(|line| {
            let words: Vec<String> = line.iter().map(|word| format!("{word:#010x}")).collect();
            words.join(" ") + "\n"
        });
        lines.collect()
    }
}

/// The shader in a language, with its entry point `main`; the shader must be one for the language's
/// device.
///
/// Loops and indices are written as they are: the WGSL port's loops count to constants, so guards
/// would only cost.
pub(crate) fn translate(shader: &Shader, language: Language) -> Result<Translation, String> {
    match language {
        Language::Glsl => write_glsl(shader, glsl::Version::Desktop(450)),
        Language::Glsl330 => write_glsl(shader, glsl::Version::Desktop(330)),
        Language::GlslEs => write_glsl(shader, glsl::Version::new_gles(310)),
        Language::GlslEs300 => write_glsl(shader, glsl::Version::new_gles(300)),
        Language::Hlsl => write_hlsl(shader),
        Language::Msl => write_msl(shader),
        Language::Spirv => return write_spirv(shader).map(Translation::Words),
    }
    .map(|text| Translation::Text(text.replace(LARGEST, BELOW)))
}

/// The largest f32 as naga writes it: a number of few digits, which is a little larger.
const LARGEST: &str = "3.4028235e38";

/// The largest f32 as a number that is a little smaller: Chrome's WebGL reads larger ones as
/// infinity.
const BELOW: &str = "3.4028234e38";

fn write_glsl(shader: &Shader, version: glsl::Version) -> Result<String, String> {
    let options = glsl::Options {
        version,
        writer_flags: glsl::WriterFlags::empty(),
        // GLSL for Vulkan must say where its buffers are: the entry point's two, and a
        // dictionary's.
        binding_map: [(0, 0), (0, 1), (1, 0)]
            .into_iter()
            .zip(0..)
            .map(|((group, binding), slot)| (ResourceBinding { group, binding }, slot))
            .collect(),
        ..glsl::Options::default()
    };
    let pipeline = glsl::PipelineOptions {
        shader_stage: shader.stage,
        entry_point: "main".to_owned(),
        multiview: None,
    };
    let mut text = String::new();
    let policies = BoundsCheckPolicies::default();
    glsl::Writer::new(&mut text, &shader.module, &shader.info, &options, &pipeline, policies)
        .and_then(|mut writer| writer.write())
        .map_err(|error| error.to_string())?;
    // Before GLSL 4.20 and ES 3.10 programs find a texture by its name, and naga's tells a reader
    // nothing.
    let stage = if shader.stage == ShaderStage::Fragment { "fs" } else { "cs" };
    Ok(text.replace(&format!("_group_1_binding_0_{stage}"), "lobe_dictionary"))
}

fn write_hlsl(shader: &Shader) -> Result<String, String> {
    let options = hlsl::Options {
        restrict_indexing: false,
        force_loop_bounding: false,
        ..hlsl::Options::default()
    };
    let mut text = String::new();
    let pipeline = hlsl::PipelineOptions::default();
    hlsl::Writer::new(&mut text, &options, &pipeline)
        .write(&shader.module, &shader.info, None)
        .map_err(|error| error.to_string())?;
    Ok(braced(&text))
}

/// The beginning of the names of naga's functions that make arrays in HLSL.
const CONSTRUCT: &str = "Constructarray";

/// HLSL whose constant arrays are numbers in braces.
///
/// naga initializes each by a call of a function, which glslang takes for a recursion, and Slang
/// for no constant. Functions that nothing calls any more are left out.
pub(crate) fn braced(hlsl: &str) -> String {
    let lines: Vec<String> =
        hlsl.lines().map(|line| with_braces(line).unwrap_or_else(|| line.to_owned())).collect();
    let text = lines.join("\n") + "\n";
    let is_used = |paragraph: &&str| {
        made_by(paragraph).is_none_or(|name| text.matches(&format!("{name}(")).count() > 1)
    };
    text.split("\n\n").filter(is_used).collect::<Vec<_>>().join("\n\n")
}

/// The line of a constant array, with braces for naga's call.
fn with_braces(line: &str) -> Option<String> {
    let (declared, value) = line.strip_prefix("static const ")?.split_once(" = ")?;
    let (_, numbers) = value.strip_prefix(CONSTRUCT)?.strip_suffix(");")?.split_once('(')?;
    Some(format!("static const {declared} = {{ {numbers} }};"))
}

/// The name of the function that a paragraph of HLSL defines, if it is one of naga's that make
/// arrays.
fn made_by(paragraph: &str) -> Option<&str> {
    // A type for the result comes first, as functions of HLSL cannot spell an array.
    let (_, function) =
        paragraph.strip_prefix("typedef ")?.split_once(&format!("\nret_{CONSTRUCT}"))?;
    function.split_once(' ')?.1.split_once('(').map(|(name, _)| name)
}

fn write_msl(shader: &Shader) -> Result<String, String> {
    let options = msl::Options {
        lang_version: (2, 0),
        fake_missing_bindings: true,
        force_loop_bounding: false,
        ..msl::Options::default()
    };
    let pipeline = msl::PipelineOptions::default();
    let (text, _) = msl::write_string(&shader.module, &shader.info, &options, &pipeline)
        .map_err(|error| error.to_string())?;
    Ok(text)
}

fn write_spirv(shader: &Shader) -> Result<Vec<u32>, String> {
    let options = spv::Options {
        lang_version: (1, 3),
        // Names, for whoever reads or counts the instructions of a function.
        flags: spv::WriterFlags::DEBUG,
        force_loop_bounding: false,
        ..spv::Options::default()
    };
    spv::write_vec(&shader.module, &shader.info, &options, None).map_err(|error| error.to_string())
}
