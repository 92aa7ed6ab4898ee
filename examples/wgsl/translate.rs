//! From WGSL to other languages, by naga.

use naga::back::{glsl, hlsl, msl, spv};
use naga::proc::BoundsCheckPolicies;
use naga::valid::ModuleInfo;
use naga::{Module, ResourceBinding, ShaderStage};

/// A language that naga writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Language {
    /// Desktop GLSL, 4.50.
    Glsl,
    /// GLSL of OpenGL ES, 3.10: the first with storage buffers.
    GlslEs,
    /// HLSL, shader model 5.1.
    Hlsl,
    /// Metal's language, 2.0.
    Msl,
    /// SPIR-V 1.3, that of Vulkan 1.1.
    Spirv,
}

impl Language {
    /// All that naga writes.
    pub(crate) const ALL: [Self; 5] =
        [Self::Glsl, Self::GlslEs, Self::Hlsl, Self::Msl, Self::Spirv];

    /// Its name on a command line.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Glsl => "glsl",
            Self::GlslEs => "glsl-es",
            Self::Hlsl => "hlsl",
            Self::Msl => "msl",
            Self::Spirv => "spirv",
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

/// The module in a language, with its entry point `main`.
///
/// Loops and indices are written as they are: the mirror's loops count to constants, so guards would only cost.
pub(crate) fn translate(
    module: &Module,
    info: &ModuleInfo,
    stage: ShaderStage,
    language: Language,
) -> Result<Translation, String> {
    match language {
        Language::Glsl => write_glsl(module, info, stage, glsl::Version::Desktop(450)),
        Language::GlslEs => write_glsl(module, info, stage, glsl::Version::new_gles(310)),
        Language::Hlsl => write_hlsl(module, info),
        Language::Msl => write_msl(module, info),
        Language::Spirv => return write_spirv(module, info).map(Translation::Words),
    }
    .map(Translation::Text)
}

fn write_glsl(
    module: &Module,
    info: &ModuleInfo,
    stage: ShaderStage,
    version: glsl::Version,
) -> Result<String, String> {
    let options = glsl::Options {
        version,
        writer_flags: glsl::WriterFlags::empty(),
        // GLSL for Vulkan must say where its buffers are: the entry point's two, and a dictionary's.
        binding_map: [(0, 0), (0, 1), (1, 0)]
            .into_iter()
            .zip(0..)
            .map(|((group, binding), slot)| (ResourceBinding { group, binding }, slot))
            .collect(),
        ..glsl::Options::default()
    };
    let pipeline = glsl::PipelineOptions {
        shader_stage: stage,
        entry_point: "main".to_owned(),
        multiview: None,
    };
    let mut text = String::new();
    let policies = BoundsCheckPolicies::default();
    glsl::Writer::new(&mut text, module, info, &options, &pipeline, policies)
        .and_then(|mut writer| writer.write())
        .map_err(|error| error.to_string())?;
    Ok(text)
}

fn write_hlsl(module: &Module, info: &ModuleInfo) -> Result<String, String> {
    let options = hlsl::Options {
        restrict_indexing: false,
        force_loop_bounding: false,
        ..hlsl::Options::default()
    };
    let mut text = String::new();
    let pipeline = hlsl::PipelineOptions::default();
    hlsl::Writer::new(&mut text, &options, &pipeline)
        .write(module, info, None)
        .map_err(|error| error.to_string())?;
    Ok(text)
}

fn write_msl(module: &Module, info: &ModuleInfo) -> Result<String, String> {
    let options = msl::Options {
        lang_version: (2, 0),
        fake_missing_bindings: true,
        force_loop_bounding: false,
        ..msl::Options::default()
    };
    let pipeline = msl::PipelineOptions::default();
    let (text, _) =
        msl::write_string(module, info, &options, &pipeline).map_err(|error| error.to_string())?;
    Ok(text)
}

fn write_spirv(module: &Module, info: &ModuleInfo) -> Result<Vec<u32>, String> {
    let options = spv::Options {
        lang_version: (1, 3),
        // Names, for whoever reads or counts the instructions of a function.
        flags: spv::WriterFlags::DEBUG,
        force_loop_bounding: false,
        ..spv::Options::default()
    };
    spv::write_vec(module, info, &options, None).map_err(|error| error.to_string())
}
