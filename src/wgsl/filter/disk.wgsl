// Kernels on the projected disk. Rust: src/filter/disk.rs.

// Rust: `DiskKernel`.
struct LobeDiskKernel {
    as_slopes: LobeKernel,
}

// Rust: `DiskKernel::of`, with a filter's variance.
fn lobe_disk_kernel_of(u: vec2f, v: vec2f, variance: f32) -> LobeDiskKernel {
    return LobeDiskKernel(lobe_kernel_of(LobeFootprint(u, v), variance));
}

// Rust: `DiskKernel::of_bounding`, with a filter's variance.
fn lobe_disk_kernel_of_bounding(u: vec2f, v: vec2f, variance: f32) -> LobeDiskKernel {
    return LobeDiskKernel(lobe_kernel_of(lobe_footprint_bounding(LobeFootprint(u, v)), variance));
}

// Rust: `DiskKernel::from_covariance`.
fn lobe_disk_kernel_from_covariance(covariance: LobePsd) -> LobeDiskKernel {
    return LobeDiskKernel(lobe_kernel_from_covariance(covariance));
}

// Rust: `DiskKernel::capped`.
fn lobe_disk_kernel_capped(kernel: LobeDiskKernel, limit: f32) -> LobeDiskKernel {
    return LobeDiskKernel(lobe_kernel_capped(kernel.as_slopes, limit));
}

// Rust: `DiskKernel::add`.
fn lobe_disk_kernel_add(kernel: LobeDiskKernel, other: LobeDiskKernel) -> LobeDiskKernel {
    return LobeDiskKernel(lobe_kernel_add(kernel.as_slopes, other.as_slopes));
}

// Rust: `Kernel::tokuyoshi_forward`.
fn lobe_kernel_tokuyoshi_forward(u: vec2f, v: vec2f) -> LobeKernel {
    return lobe_kernel_of(LobeFootprint(u, v), LOBE_PIXEL_FILTER_KAPLANYAN);
}
