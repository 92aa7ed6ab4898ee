// A slope covariance, from a footprint and a pixel filter's variance. Rust: src/filter/kernel.rs.

// Rust: `PixelFilter::BOX`.
const LOBE_PIXEL_FILTER_BOX: f32 = 0.08333333333333333;

// Rust: `PixelFilter::KAPLANYAN`.
const LOBE_PIXEL_FILTER_KAPLANYAN: f32 = 0.25;

// Rust: `PixelFilter::TOKUYOSHI_KAPLANYAN`.
const LOBE_PIXEL_FILTER_TOKUYOSHI_KAPLANYAN: f32 = 0.15915494309189535;

// Rust: `PixelFilter::KAPLANYAN_PROXY`.
const LOBE_PIXEL_FILTER_KAPLANYAN_PROXY: f32 = 0.5;

// Rust: `Kernel`.
struct LobeKernel {
    u: vec2f,
    v: vec2f,
}

// Rust: `Kernel::of`, with a filter's variance. A variance beyond [0, 1e9] counts as the nearest,
// NaN as 0.
fn lobe_kernel_of(footprint: LobeFootprint, variance: f32) -> LobeKernel {
    return lobe_kernel_scaled(
        LobeKernel(footprint.u, footprint.v), sqrt(lobe_magnitude(variance))
    );
}

// Rust: `Kernel::scaled`.
fn lobe_kernel_scaled(kernel: LobeKernel, factor: f32) -> LobeKernel {
    return LobeKernel(
        vec2f(lobe_kernel_within(kernel.u.x * factor), lobe_kernel_within(kernel.u.y * factor)),
        vec2f(lobe_kernel_within(kernel.v.x * factor), lobe_kernel_within(kernel.v.y * factor))
    );
}

// WGSL only: Rust has it as a closure.
fn lobe_kernel_within(x: f32) -> f32 {
    return lobe_min(lobe_max(x, -LOBE_LARGEST), LOBE_LARGEST);
}

// Rust: `Kernel::from_covariance`.
fn lobe_kernel_from_covariance(covariance: LobePsd) -> LobeKernel {
    return LobeKernel(vec2f(covariance.l_xx, covariance.l_yx), vec2f(0.0, covariance.l_yy));
}

// Rust: `Kernel::covariance`.
fn lobe_kernel_covariance(kernel: LobeKernel) -> LobePsd {
    return lobe_psd_outer_sum(kernel.u, kernel.v);
}

// Rust: `Kernel::added`.
fn lobe_kernel_added(kernel: LobeKernel) -> LobeKernel {
    let root = 1.4142135;
    return LobeKernel(
        vec2f(kernel.u.x * root, kernel.u.y * root), vec2f(kernel.v.x * root, kernel.v.y * root)
    );
}

// Rust: `Kernel::footprint`, for a filter's variance. The zero footprint for a variance that is not
// positive.
fn lobe_kernel_footprint(kernel: LobeKernel, variance: f32) -> LobeFootprint {
    let spread = lobe_magnitude(variance);
    if spread <= 0.0 {
        return LobeFootprint(vec2f(0.0, 0.0), vec2f(0.0, 0.0));
    }
    let least = lobe_max(spread, LOBE_MIN_POSITIVE);
    let eigen = lobe_psd_eigen(lobe_kernel_covariance(kernel));
    let long = sqrt(lobe_min(eigen.major / least, LOBE_LARGEST * LOBE_LARGEST));
    let short = sqrt(lobe_min(eigen.minor / least, LOBE_LARGEST * LOBE_LARGEST));
    let turn = eigen.axis;
    return LobeFootprint(
        vec2f(long * turn.x, long * turn.y), vec2f(-(short * turn.y), short * turn.x)
    );
}

// Rust: `Kernel::capped`.
fn lobe_kernel_capped(kernel: LobeKernel, limit: f32) -> LobeKernel {
    let covariance = lobe_kernel_covariance(kernel);
    let cap = lobe_max(0.5 * limit, 0.0);
    if lobe_psd_eigen(covariance).major <= cap {
        return kernel;
    }
    return lobe_kernel_from_covariance(lobe_psd_capped(covariance, 0.5 * limit));
}

// Rust: `Kernel::ALPHA_SQUARED_LIMIT`.
const LOBE_KERNEL_ALPHA_SQUARED_LIMIT: f32 = 0.18;

// Rust: `Kernel::add`.
fn lobe_kernel_add(kernel: LobeKernel, other: LobeKernel) -> LobeKernel {
    let covariance = lobe_psd_with_columns(lobe_kernel_covariance(kernel), other.u, other.v);
    return lobe_kernel_scaled(lobe_kernel_from_covariance(covariance), 1.0);
}
