//! What a shader costs: CPU time of this process, and the GPU's own clock.
//!
//! On software drivers wall time and timestamps vary by a factor of 2. CPU time is good to about 5
//! % if works take turns, the least of many rounds counts, and the driver has no threads of its own
//! (`LP_NUM_THREADS=0` before the first device opens).

use wgpu::{
    BufferUsages, CommandEncoder, ComputePassTimestampWrites, QuerySet, RenderPassTimestampWrites,
};

use crate::{Gpu, buffer};

/// CPU time of this process in seconds, all threads, from an arbitrary origin.
pub fn cpu_seconds() -> f64 {
    let time = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    time.tv_sec as f64 + time.tv_nsec as f64 * 1e-9
}

/// Least CPU seconds of each work over `rounds`, in which they take turns.
///
/// Other threads of the process must rest. The first round, which compiles, does not count.
pub fn least_cpu_seconds(rounds: usize, works: &mut [&mut dyn FnMut()]) -> Vec<f64> {
    let mut least = vec![f64::INFINITY; works.len()];
    for round in 0..=rounds {
        for (work, least) in works.iter_mut().zip(&mut least) {
            let start = cpu_seconds();
            work();
            if round > 0 {
                *least = least.min(cpu_seconds() - start);
            }
        }
    }
    least
}

/// Two timestamps, at the beginning and the end of a pass.
pub(crate) struct Stamps {
    set: QuerySet,
}

impl Stamps {
    /// Nanoseconds of each of `times` passes, one submission each; `None` without timestamps.
    pub(crate) fn repeat(
        gpu: &Gpu,
        times: usize,
        encode: impl Fn(&mut CommandEncoder, &Self),
    ) -> Option<Vec<f64>> {
        if !gpu.has_timestamps() {
            return None;
        }
        let stamps = Self {
            set: gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
                label: None,
                ty: wgpu::QueryType::Timestamp,
                count: 2,
            }),
        };
        // Four words: two ticks of 64 bits.
        let usage = BufferUsages::QUERY_RESOLVE | BufferUsages::COPY_SRC;
        let resolved = buffer::empty(gpu, 4, usage);
        let read = buffer::readable(gpu, 4);
        let period = f64::from(gpu.queue.get_timestamp_period());
        let measure = || {
            let mut encoder =
                gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            encode(&mut encoder, &stamps);
            encoder.resolve_query_set(&stamps.set, 0..2, &resolved, 0);
            encoder.copy_buffer_to_buffer(&resolved, 0, &read, 0, read.size());
            let ticks = buffer::download(gpu, encoder, &read, |bytes| {
                let (ticks, _) = bytes.as_chunks::<8>();
                u64::from_le_bytes(ticks[1]).wrapping_sub(u64::from_le_bytes(ticks[0]))
            });
            ticks as f64 * period
        };
        Some((0..times).map(|_| measure()).collect())
    }

    pub(crate) fn compute(&self) -> ComputePassTimestampWrites<'_> {
        ComputePassTimestampWrites {
            query_set: &self.set,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        }
    }

    pub(crate) fn render(&self) -> RenderPassTimestampWrites<'_> {
        RenderPassTimestampWrites {
            query_set: &self.set,
            beginning_of_pass_write_index: Some(0),
            end_of_pass_write_index: Some(1),
        }
    }
}
