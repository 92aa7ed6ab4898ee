//! A piece of WGSL, run once for each item of a list of floats.

use lobe::wgsl::rebound;
use naga::ShaderStage;
use wgpu::{BindGroup, Buffer, BufferUsages, ComputePipeline, ShaderStages};

use crate::dictionary::Dictionary;
use crate::shader::{bind, entry, layouts, module};
use crate::timing::Stamps;
use crate::{Gpu, Mode, buffer};

/// Items per workgroup.
const WORKGROUP: usize = 64;

/// What to compute: a library of functions and the statements that use them.
///
/// The body reads its item by `at(k) -> f32` or `bits_at(k) -> u32` and answers by `put(k, f32)` or
/// `put_bits(k, u32)`; `item` is its number within the dispatch.
#[derive(Clone, Copy, Debug)]
pub struct Job<'a> {
    /// WGSL declarations.
    pub library: &'a str,
    /// WGSL statements.
    pub body: &'a str,
    /// Floats that one item reads, at least 1.
    pub inputs: usize,
    /// Floats that one item writes, at least 1.
    pub outputs: usize,
    /// Nodes of the dictionary that the library reads, from a buffer or a texture; none if it reads
    /// none.
    pub dictionary: &'a [[f32; 2]],
}

impl Job<'_> {
    /// The whole shader.
    pub fn wgsl(&self) -> String {
        let Self { library, body, inputs, outputs, .. } = self;
        let library = rebound(library, 0, 2);
        format!(
            "{library}
@group(0) @binding(0) var<storage, read> job_inputs: array<u32>;
@group(0) @binding(1) var<storage, read_write> job_outputs: array<u32>;
var<private> item: u32;
fn bits_at(k: u32) -> u32 {{ return job_inputs[item * {inputs}u + k]; }}
fn at(k: u32) -> f32 {{ return bitcast<f32>(bits_at(k)); }}
fn put_bits(k: u32, bits: u32) {{ job_outputs[item * {outputs}u + k] = bits; }}
fn put(k: u32, value: f32) {{ put_bits(k, bitcast<u32>(value)); }}
@compute @workgroup_size({WORKGROUP})
fn job(@builtin(global_invocation_id) job_id: vec3<u32>) {{
item = job_id.x;
if item >= arrayLength(&job_outputs) / {outputs}u {{ return; }}
{body}
}}
"
        )
    }

    /// Compiles for one driver.
    ///
    /// # Errors
    ///
    /// Wrong WGSL, with naga's pointed message; exact mode on a driver without passthrough.
    ///
    /// # Panics
    ///
    /// If an item reads or writes nothing.
    pub fn compile(&self, gpu: &'static Gpu, mode: Mode) -> Result<Kernel, String> {
        assert!(self.inputs > 0 && self.outputs > 0, "an item reads and writes at least one float");
        let module = module(gpu, mode, &self.wgsl(), (ShaderStage::Compute, "job"))?;
        let has_dictionary = !self.dictionary.is_empty();
        let dictionary =
            has_dictionary.then(|| Dictionary::upload(gpu, self.dictionary, self.library));
        let entries = [(0, true), (1, false)];
        let entries = entries.map(|(slot, only)| entry(slot, ShaderStages::COMPUTE, only));
        let third = dictionary.iter().map(|nodes| nodes.entry(2, ShaderStages::COMPUTE));
        let entries: Vec<_> = entries.into_iter().chain(third).collect();
        let (group_layout, layout) = layouts(gpu, &entries);
        let pipeline = gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: None,
            layout: Some(&layout),
            module: &module,
            entry_point: Some("job"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            cache: None,
        });
        let Self { inputs, outputs, .. } = *self;
        Ok(Kernel { gpu, pipeline, group_layout, dictionary, inputs, outputs })
    }

    /// Compiles and runs.
    ///
    /// # Errors
    ///
    /// As [`Self::compile`].
    pub fn run(&self, gpu: &'static Gpu, mode: Mode, inputs: &[f32]) -> Result<Vec<f32>, String> {
        Ok(self.compile(gpu, mode)?.run(inputs))
    }
}

/// A compiled [`Job`].
#[derive(Debug)]
pub struct Kernel {
    gpu: &'static Gpu,
    pipeline: ComputePipeline,
    group_layout: wgpu::BindGroupLayout,
    dictionary: Option<Dictionary>,
    inputs: usize,
    outputs: usize,
}

impl Kernel {
    /// The outputs of all items, bit for bit as the driver wrote them.
    ///
    /// # Panics
    ///
    /// If `inputs` does not hold whole items.
    pub fn run(&self, inputs: &[f32]) -> Vec<f32> {
        inputs
            .chunks(self.most_items() * self.inputs)
            .flat_map(|part| self.load(part).run())
            .collect()
    }

    /// Puts items on the GPU, to be run often.
    ///
    /// # Panics
    ///
    /// If `inputs` does not hold whole items, at least one and at most [`Self::most_items`].
    pub fn load(&self, inputs: &[f32]) -> Loaded<'_> {
        let items = inputs.len() / self.inputs;
        assert_eq!(items * self.inputs, inputs.len(), "whole items of {} floats", self.inputs);
        assert!((1..=self.most_items()).contains(&items), "{items} items do not fit");
        let source = buffer::upload(self.gpu, inputs);
        let usage = BufferUsages::STORAGE | BufferUsages::COPY_SRC;
        let target = buffer::empty(self.gpu, items * self.outputs, usage);
        let buffers = [&source, &target].map(|buffer| buffer.as_entire_binding());
        let all = buffers.into_iter().chain(self.dictionary.iter().map(Dictionary::resource));
        let group = bind(self.gpu, &self.group_layout, all);
        Loaded { kernel: self, items, target, group }
    }

    /// Items that fit into one dispatch: workgroups and the size of a binding limit them.
    pub fn most_items(&self) -> usize {
        let limits = self.gpu.device.limits();
        let groups = limits.max_compute_workgroups_per_dimension as usize * WORKGROUP;
        // 128 MiB is what WebGPU promises; drivers that allow gigabytes need not get them.
        let bytes = limits.max_storage_buffer_binding_size.min(1 << 27);
        let floats = (bytes / 4) as usize;
        groups.min(floats / self.inputs.max(self.outputs))
    }
}

/// A [`Kernel`] with its items.
#[derive(Debug)]
pub struct Loaded<'a> {
    kernel: &'a Kernel,
    items: usize,
    target: Buffer,
    group: BindGroup,
}

impl Loaded<'_> {
    /// Computes all items and waits for them: what CPU time is measured on.
    pub fn dispatch(&self) {
        let gpu = self.kernel.gpu;
        let mut encoder =
            gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.encode(&mut encoder, None);
        gpu.queue.submit([encoder.finish()]);
        gpu.wait();
    }

    /// Computes all items and reads their outputs.
    pub fn run(&self) -> Vec<f32> {
        let gpu = self.kernel.gpu;
        let read = buffer::readable(gpu, self.items * self.kernel.outputs);
        let mut encoder =
            gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        self.encode(&mut encoder, None);
        encoder.copy_buffer_to_buffer(&self.target, 0, &read, 0, read.size());
        buffer::download(gpu, encoder, &read, |bytes| buffer::floats(bytes).collect())
    }

    /// Nanoseconds on the GPU's clock, one for each of `times` runs; `None` without timestamps.
    pub fn nanoseconds(&self, times: usize) -> Option<Vec<f64>> {
        Stamps::repeat(self.kernel.gpu, times, |encoder, stamps| self.encode(encoder, Some(stamps)))
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder, stamps: Option<&Stamps>) {
        let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor {
            label: None,
            timestamp_writes: stamps.map(Stamps::compute),
        });
        pass.set_pipeline(&self.kernel.pipeline);
        pass.set_bind_group(0, &self.group, &[]);
        let groups = self.items.div_ceil(WORKGROUP);
        pass.dispatch_workgroups(u32::try_from(groups).expect("held by most_items"), 1, 1);
    }
}
