//! Floats into storage buffers and back, with all their bits.

use std::sync::mpsc;

use wgpu::{Buffer, BufferDescriptor, BufferUsages, CommandEncoder, MapMode};

use crate::Gpu;

/// A storage buffer that holds `values`; never empty, as no binding may be.
pub(crate) fn upload(gpu: &Gpu, values: &[f32]) -> Buffer {
    let buffer = gpu.device.create_buffer(&BufferDescriptor {
        label: None,
        size: bytes(values.len().max(1)),
        usage: BufferUsages::STORAGE,
        mapped_at_creation: true,
    });
    let words: Vec<u8> = values.iter().flat_map(|value| value.to_bits().to_le_bytes()).collect();
    let mut view = buffer.get_mapped_range_mut(..).expect("mapped at creation");
    view.slice(..words.len()).copy_from_slice(&words);
    drop(view);
    buffer.unmap();
    buffer
}

/// A buffer of `count` floats.
pub(crate) fn empty(gpu: &Gpu, count: usize, usage: BufferUsages) -> Buffer {
    gpu.device.create_buffer(&BufferDescriptor {
        label: None,
        size: bytes(count),
        usage,
        mapped_at_creation: false,
    })
}

/// A buffer that the CPU reads.
pub(crate) fn readable(gpu: &Gpu, count: usize) -> Buffer {
    empty(gpu, count, BufferUsages::MAP_READ | BufferUsages::COPY_DST)
}

/// Submits, waits, and passes the bytes of `source` on.
pub(crate) fn download<T>(
    gpu: &Gpu,
    encoder: CommandEncoder,
    source: &Buffer,
    read: impl FnOnce(&[u8]) -> T,
) -> T {
    gpu.queue.submit([encoder.finish()]);
    let (sender, receiver) = mpsc::channel();
    source.map_async(MapMode::Read, .., move |result| {
        sender.send(result).expect("the receiver waits");
    });
    gpu.wait();
    receiver.recv().expect("mapping answers").expect("the buffer can be read");
    let result = read(&source.get_mapped_range(..).expect("mapped above"));
    source.unmap();
    result
}

/// Floats from little-endian bytes.
pub(crate) fn floats(bytes: &[u8]) -> impl Iterator<Item = f32> + '_ {
    let (words, _) = bytes.as_chunks::<4>();
    words.iter().map(|word| f32::from_bits(u32::from_le_bytes(*word)))
}

/// Size of `count` floats.
pub(crate) fn bytes(count: usize) -> u64 {
    count as u64 * 4
}
