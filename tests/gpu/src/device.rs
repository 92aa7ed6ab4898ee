//! One Vulkan driver with a device and a queue, opened once per process.

use std::future::Future;
use std::sync::OnceLock;
use std::task::{Context, Poll, Waker};

use wgpu::{Adapter, Backends, Features, InstanceDescriptor, InstanceFlags};

/// What kind of machine runs the shaders.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Driver {
    /// Mesa's driver on the CPU. Compute keeps denormals, fragments flush them.
    Lavapipe,
    /// Chromium's driver on the CPU: an independent compiler. Flushes denormals everywhere.
    SwiftShader,
    /// A real GPU.
    Hardware,
}

impl Driver {
    fn of(adapter: &Adapter) -> Self {
        let name = adapter.get_info().name;
        if name.contains("llvmpipe") {
            Self::Lavapipe
        } else if name.contains("SwiftShader") {
            Self::SwiftShader
        } else {
            Self::Hardware
        }
    }
}

/// A driver, opened.
#[derive(Debug)]
pub struct Gpu {
    name: String,
    kind: Driver,
    pub(crate) device: wgpu::Device,
    pub(crate) queue: wgpu::Queue,
}

impl Gpu {
    /// All Vulkan drivers that open, lavapipe first; empty where there is none.
    pub fn every() -> &'static [Self] {
        static EVERY: OnceLock<Vec<Gpu>> = OnceLock::new();
        EVERY.get_or_init(|| {
            // No validation layers: debug and release builds shall do the same.
            let instance = wgpu::Instance::new(InstanceDescriptor {
                backends: Backends::VULKAN,
                flags: InstanceFlags::empty(),
                ..InstanceDescriptor::new_without_display_handle()
            });
            let adapters = block_on(instance.enumerate_adapters(Backends::VULKAN));
            let mut gpus: Vec<_> = adapters.iter().filter_map(Self::open).collect();
            gpus.sort_by_key(|gpu| gpu.kind);
            gpus
        })
    }

    /// The driver that every test can rely on.
    ///
    /// # Panics
    ///
    /// Where it is missing: a GPU test that skips itself proves nothing.
    pub fn lavapipe() -> &'static Self {
        Self::every().iter().find(|gpu| gpu.kind == Driver::Lavapipe).unwrap_or_else(|| {
            panic!(
                "no Vulkan driver found: install libvulkan1 and mesa-vulkan-drivers (./test.sh \
                 does) or point VK_DRIVER_FILES at lavapipe's lvp_icd*.json"
            )
        })
    }

    /// The adapter's own name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Software or a real GPU.
    pub fn kind(&self) -> Driver {
        self.kind
    }

    /// With everything that the adapter allows; exact mode and timestamps may be missing.
    fn open(adapter: &Adapter) -> Option<Self> {
        let wanted = Features::PASSTHROUGH_SHADERS | Features::TIMESTAMP_QUERY;
        let offered = wanted & adapter.features();
        let descriptor = wgpu::DeviceDescriptor {
            required_features: offered,
            required_limits: adapter.limits(),
            ..Default::default()
        };
        let name = adapter.get_info().name;
        match block_on(adapter.request_device(&descriptor)) {
            Ok((device, queue)) => Some(Self { name, kind: Driver::of(adapter), device, queue }),
            Err(error) => {
                eprintln!("lobe-gpu: {name} does not open: {error}");
                None
            }
        }
    }

    /// Whether passes can be timed on the GPU's clock.
    pub fn has_timestamps(&self) -> bool {
        self.device.features().contains(Features::TIMESTAMP_QUERY)
    }

    /// Waits until all submitted work is done.
    pub(crate) fn wait(&self) {
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("the device answers");
    }
}

/// wgpu's native futures are ready at once, so this spins at most for moments.
pub(crate) fn block_on<F: Future>(future: F) -> F::Output {
    let mut future = std::pin::pin!(future);
    let mut context = Context::from_waker(Waker::noop());
    loop {
        if let Poll::Ready(value) = future.as_mut().poll(&mut context) {
            return value;
        }
        std::thread::yield_now();
    }
}
