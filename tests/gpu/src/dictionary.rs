//! A dictionary on the GPU, in a buffer or in a texture.

use wgpu::{BindGroupLayoutEntry, BindingResource, Buffer, ShaderStages, TextureView};

use crate::{Gpu, buffer, shader};

/// Texels in a row: odd, so that rows and marginals end at different nodes.
const WIDTH: u32 = 1021;

/// The nodes of a dictionary where a shader reads them.
#[derive(Debug)]
pub(crate) enum Dictionary {
    Buffer(Buffer),
    Texture(TextureView),
}

impl Dictionary {
    /// Puts nodes where a library reads them.
    pub(crate) fn upload(gpu: &Gpu, nodes: &[[f32; 2]], library: &str) -> Self {
        if library.contains("lobe_dictionary: texture_2d") {
            Self::Texture(texture(gpu, nodes))
        } else {
            Self::Buffer(buffer::upload(gpu, nodes.as_flattened()))
        }
    }

    /// Its entry in a layout.
    pub(crate) fn entry(&self, binding: u32, visibility: ShaderStages) -> BindGroupLayoutEntry {
        let entry = shader::entry(binding, visibility, true);
        match self {
            Self::Buffer(_) => entry,
            Self::Texture(_) => BindGroupLayoutEntry {
                ty: wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: false },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
                ..entry
            },
        }
    }

    /// What is bound.
    pub(crate) fn resource(&self) -> BindingResource<'_> {
        match self {
            Self::Buffer(buffer) => buffer.as_entire_binding(),
            Self::Texture(view) => BindingResource::TextureView(view),
        }
    }
}

/// Nodes row by row; what is left of the last row is NaN.
fn texture(gpu: &Gpu, nodes: &[[f32; 2]]) -> TextureView {
    let height = u32::try_from(nodes.len()).expect("a dictionary's size").div_ceil(WIDTH);
    let mut texels = nodes.to_vec();
    texels.resize((WIDTH * height) as usize, [f32::NAN; 2]);
    let numbers = texels.as_flattened().iter();
    let bytes: Vec<u8> = numbers.flat_map(|number| number.to_le_bytes()).collect();
    let size = wgpu::Extent3d { width: WIDTH, height, depth_or_array_layers: 1 };
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size,
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rg32Float,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(8 * WIDTH),
        rows_per_image: None,
    };
    gpu.queue.write_texture(texture.as_image_copy(), &bytes, layout, size);
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
