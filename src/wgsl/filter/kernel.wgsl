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

// Rust: `Kernel::of`, with a filter's variance. A negative variance counts as 0. Columns hold what
// the footprint holds: BRDFs of what they widen are 0 where that is no number, and matrices count
// it as an end of the range.
fn lobe_kernel_of(footprint: LobeFootprint, variance: f32) -> LobeKernel {
    let factor = sqrt(2.0 * lobe_max(variance, 0.0));
    return LobeKernel(footprint.u * factor, footprint.v * factor);
}

// Rust: `Kernel::from_covariance`.
fn lobe_kernel_from_covariance(covariance: LobePsd) -> LobeKernel {
    let added = lobe_psd_mul(covariance, 2.0);
    return LobeKernel(vec2f(added.l_xx, added.l_yx), vec2f(0.0, added.l_yy));
}

// Rust: `Kernel::covariance`.
fn lobe_kernel_covariance(kernel: LobeKernel) -> LobePsd {
    let added = lobe_kernel_added(kernel);
    return lobe_psd_mul(lobe_psd_outer_sum(added.u, added.v), 0.5);
}

// Rust: `Kernel::added`.
fn lobe_kernel_added(kernel: LobeKernel) -> LobeKernel {
    return LobeKernel(
        vec2f(lobe_kernel_within(kernel.u.x), lobe_kernel_within(kernel.u.y)),
        vec2f(lobe_kernel_within(kernel.v.x), lobe_kernel_within(kernel.v.y))
    );
}

// WGSL only: Rust has it as a closure.
fn lobe_kernel_within(x: f32) -> f32 {
    return lobe_min(lobe_max(x, -LOBE_LARGEST), LOBE_LARGEST);
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

// WGSL only: of `Kernel::add`.
fn lobe_kernel_is_none(kernel: LobeKernel) -> bool {
    return kernel.u.x == 0.0 && kernel.u.y == 0.0 && kernel.v.x == 0.0 && kernel.v.y == 0.0;
}

// Rust: `Kernel::add`.
fn lobe_kernel_add(kernel: LobeKernel, other: LobeKernel) -> LobeKernel {
    if lobe_kernel_is_none(kernel) {
        return other;
    }
    if lobe_kernel_is_none(other) {
        return kernel;
    }
    let first = lobe_kernel_added(kernel);
    let second = lobe_kernel_added(other);
    let sum = lobe_psd_with_columns(lobe_psd_outer_sum(first.u, first.v), second.u, second.v);
    return LobeKernel(vec2f(sum.l_xx, sum.l_yx), vec2f(0.0, sum.l_yy));
}
