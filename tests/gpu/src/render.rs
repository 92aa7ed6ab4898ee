//! A fragment shader over every pixel of a float picture.

use naga::ShaderStage;
use wgpu::{
    BindGroup, Buffer, BufferUsages, RenderPipeline, ShaderStages, Texture, TextureFormat,
    TextureUsages,
};

use crate::shader::{bind, entry, layouts, module};
use crate::timing::Stamps;
use crate::{Gpu, Mode, buffer};

/// One triangle whose long edge, in a viewport of twice the picture's size and a pixel more, passes
/// beside the picture.
///
/// The usual triangle of twice the screen gets clipped, and the clipped pieces meet on a diagonal
/// through the picture. Quads there have helper pixels, which read zeros from storage buffers on
/// lavapipe (Mesa 22.3): derivatives of what was read would be wrong.
const VERTEX: &str = "
@vertex fn vertex(@builtin(vertex_index) index: u32) -> @builtin(position) vec4<f32> {
    let right = f32(index & 1u);
    let down = f32(index >> 1u);
    return vec4<f32>(2.0 * right - 1.0, 1.0 - 2.0 * down, 0.0, 1.0);
}
";

/// Rows of a texture copy begin at multiples of this many bytes.
const ROW_ALIGNMENT: u32 = wgpu::COPY_BYTES_PER_ROW_ALIGNMENT;
/// Four floats.
const PIXEL_BYTES: u32 = 16;

/// A fragment shader with its buffers and its picture.
#[derive(Debug)]
pub struct Painter {
    gpu: &'static Gpu,
    pipeline: RenderPipeline,
    group: BindGroup,
    picture: Texture,
}

impl Painter {
    /// Compiles `fragment`, which holds an entry point `fragment` that returns `vec4<f32>`.
    ///
    /// Even sizes make all quads whole. The buffers of `storage` are `var<storage, read>` at
    /// bindings 0, 1, ... of group 0, declared by the text.
    ///
    /// # Errors
    ///
    /// Wrong WGSL, with naga's pointed message.
    pub fn new(
        gpu: &'static Gpu,
        library: &str,
        fragment: &str,
        storage: &[&[f32]],
        width: u32,
        height: u32,
    ) -> Result<Self, String> {
        let text = format!("{library}\n{fragment}");
        let fragment = module(gpu, Mode::Shipped, &text, (ShaderStage::Fragment, "fragment"))?;
        let vertex = module(gpu, Mode::Shipped, VERTEX, (ShaderStage::Vertex, "vertex"))?;
        let buffers: Vec<_> = storage.iter().map(|floats| buffer::upload(gpu, floats)).collect();
        let entries: Vec<_> =
            (0..).zip(&buffers).map(|(k, _)| entry(k, ShaderStages::FRAGMENT, true)).collect();
        let (group_layout, layout) = layouts(gpu, &entries);
        let group = bind(gpu, &group_layout, buffers.iter().map(Buffer::as_entire_binding));
        let picture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: TextureFormat::Rgba32Float,
            usage: TextureUsages::RENDER_ATTACHMENT | TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let pipeline = gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: None,
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &vertex,
                entry_point: Some("vertex"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers: &[],
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: None,
            multisample: wgpu::MultisampleState::default(),
            fragment: Some(wgpu::FragmentState {
                module: &fragment,
                entry_point: Some("fragment"),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(TextureFormat::Rgba32Float.into())],
            }),
            multiview_mask: None,
            cache: None,
        });
        Ok(Self { gpu, pipeline, group, picture })
    }

    /// The picture, rows from the top.
    pub fn draw(&self) -> Vec<[f32; 4]> {
        let (gpu, size) = (self.gpu, self.picture.size());
        let row = (size.width * PIXEL_BYTES).next_multiple_of(ROW_ALIGNMENT);
        let usage = BufferUsages::MAP_READ | BufferUsages::COPY_DST;
        let read = buffer::empty(gpu, (row / 4 * size.height) as usize, usage);
        let mut encoder =
            gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.encode(&mut encoder, None);
        let layout = wgpu::TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(row),
            rows_per_image: None,
        };
        let target = wgpu::TexelCopyBufferInfo { buffer: &read, layout };
        encoder.copy_texture_to_buffer(self.picture.as_image_copy(), target, size);
        buffer::download(gpu, encoder, &read, |bytes| {
            let rows = bytes.chunks(row as usize);
            let used = rows.flat_map(|row| &row[..(size.width * PIXEL_BYTES) as usize]);
            let floats: Vec<f32> = buffer::floats(&used.copied().collect::<Vec<_>>()).collect();
            floats.as_chunks::<4>().0.to_vec()
        })
    }

    /// Draws and waits, without reading: what CPU time is measured on.
    pub fn paint(&self) {
        let mut encoder =
            self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.encode(&mut encoder, None);
        self.gpu.queue.submit([encoder.finish()]);
        self.gpu.wait();
    }

    /// Nanoseconds on the GPU's clock, one for each of `times` pictures; `None` without timestamps.
    pub fn nanoseconds(&self, times: usize) -> Option<Vec<f64>> {
        Stamps::repeat(self.gpu, times, |encoder, stamps| self.encode(encoder, Some(stamps)))
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder, stamps: Option<&Stamps>) {
        let view = self.picture.create_view(&wgpu::TextureViewDescriptor::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations::default(),
            })],
            timestamp_writes: stamps.map(Stamps::render),
            ..Default::default()
        });
        let size = self.picture.size();
        let twice = |length: u32| (2 * length + 2) as f32;
        pass.set_viewport(0.0, 0.0, twice(size.width), twice(size.height), 0.0, 1.0);
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}
