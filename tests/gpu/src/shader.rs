//! WGSL as a driver's module, and the storage buffers that it sees.

use std::borrow::Cow;

use naga::ShaderStage;
use wgpu::{
    BindGroup, BindGroupLayoutEntry, BindingResource, PassthroughShaderEntryPoint, ShaderModule,
    ShaderModuleDescriptorPassthrough, ShaderStages,
};

use crate::{Gpu, exact};
use lobe_report::spirv;

/// How WGSL becomes the driver's program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// By wgpu, as an engine would: drivers may rearrange float arithmetic.
    Shipped,
    /// By [`exact`]: each operation is rounded once, in the order of the text.
    Exact,
}

/// WGSL as a module of the driver; the text must have the entry point.
pub(crate) fn module(
    gpu: &Gpu,
    mode: Mode,
    wgsl: &str,
    (stage, name): (ShaderStage, &str),
) -> Result<ShaderModule, String> {
    // By ourselves, and first: wgpu would panic where naga's message can be returned.
    let (parsed, info) = spirv::validated(wgsl)?;
    if !parsed.entry_points.iter().any(|entry| entry.stage == stage && entry.name == name) {
        return Err(format!("no {stage:?} entry point named `{name}`").to_lowercase());
    }
    match mode {
        Mode::Shipped => Ok(gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: None,
            source: wgpu::ShaderSource::Wgsl(Cow::Borrowed(wgsl)),
        })),
        Mode::Exact => {
            if !gpu.device.features().contains(wgpu::Features::PASSTHROUGH_SHADERS) {
                return Err(format!("{} takes no SPIR-V as it is", gpu.name()));
            }
            let mut words = spirv::written(&parsed, &info)?;
            exact::no_contraction(&mut words);
            Ok(passthrough(gpu, &words, name))
        }
    }
}

/// SPIR-V to the driver, past wgpu's compiler.
#[allow(unsafe_code)]
fn passthrough(gpu: &Gpu, words: &[u32], name: &str) -> ShaderModule {
    // Vulkan takes the workgroup's size from the SPIR-V.
    let entry =
        PassthroughShaderEntryPoint { name: Cow::Borrowed(name), workgroup_size: (1, 1, 1) };
    let descriptor = ShaderModuleDescriptorPassthrough {
        entry_points: Cow::Borrowed(std::slice::from_ref(&entry)),
        spirv: Some(Cow::Borrowed(words)),
        ..Default::default()
    };
    // SAFETY: naga validated the shader and wrote it with every index checked; what we added are
    // decorations that only narrow how floats may be computed.
    unsafe { gpu.device.create_shader_module_passthrough(descriptor) }
}

/// A storage buffer of a layout.
pub(crate) fn entry(
    binding: u32,
    visibility: ShaderStages,
    read_only: bool,
) -> BindGroupLayoutEntry {
    BindGroupLayoutEntry {
        binding,
        visibility,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Storage { read_only },
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

/// Explicit, as wgpu knows nothing about passthrough shaders.
pub(crate) fn layouts(
    gpu: &Gpu,
    entries: &[BindGroupLayoutEntry],
) -> (wgpu::BindGroupLayout, wgpu::PipelineLayout) {
    let descriptor = wgpu::BindGroupLayoutDescriptor { label: None, entries };
    let group = gpu.device.create_bind_group_layout(&descriptor);
    let pipeline = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: &[Some(&group)],
        immediate_size: 0,
    });
    (group, pipeline)
}

/// Resources at bindings 0, 1, ...
pub(crate) fn bind<'a>(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    resources: impl IntoIterator<Item = BindingResource<'a>>,
) -> BindGroup {
    let entries: Vec<_> = (0..)
        .zip(resources)
        .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource })
        .collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout,
        entries: &entries,
    })
}
