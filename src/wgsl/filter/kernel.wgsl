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
    covariance: LobePsd,
}

// Rust: `Kernel::of`, with a filter's variance. A variance beyond [0, 1e9] counts as the nearest,
// NaN as 0.
fn lobe_kernel_of(footprint: LobeFootprint, variance: f32) -> LobeKernel {
    let spread = lobe_magnitude(variance);
    let finite = LobeFootprint(lobe_kernel_finite(footprint.u), lobe_kernel_finite(footprint.v));
    let limit = LOBE_LARGEST / sqrt(lobe_max(spread, 1.0));
    let factor = limit / lobe_max(lobe_footprint_largest_component(finite), limit);
    let u = vec2f(finite.u.x * factor, finite.u.y * factor);
    let v = vec2f(finite.v.x * factor, finite.v.y * factor);
    return LobeKernel(lobe_psd_mul(lobe_psd_outer_sum(u, v), spread));
}

// WGSL only: Rust has it as a closure.
fn lobe_kernel_finite(v: vec2f) -> vec2f {
    return vec2f(lobe_finite(v.x), lobe_finite(v.y));
}

// Rust: `Kernel::from_covariance`.
fn lobe_kernel_from_covariance(covariance: LobePsd) -> LobeKernel {
    return LobeKernel(covariance);
}

// Rust: `Kernel::footprint`, for a filter's variance. The zero footprint for a variance that is not
// positive.
fn lobe_kernel_footprint(kernel: LobeKernel, variance: f32) -> LobeFootprint {
    let spread = lobe_magnitude(variance);
    if spread <= 0.0 {
        return LobeFootprint(vec2f(0.0, 0.0), vec2f(0.0, 0.0));
    }
    let least = lobe_max(spread, LOBE_MIN_POSITIVE);
    let eigen = lobe_psd_eigen(kernel.covariance);
    let long = sqrt(lobe_min(eigen.major / least, LOBE_LARGEST * LOBE_LARGEST));
    let short = sqrt(lobe_min(eigen.minor / least, LOBE_LARGEST * LOBE_LARGEST));
    let turn = eigen.axis;
    return LobeFootprint(
        vec2f(long * turn.x, long * turn.y), vec2f(-(short * turn.y), short * turn.x)
    );
}

// Rust: `Kernel::capped`.
fn lobe_kernel_capped(kernel: LobeKernel, limit: f32) -> LobeKernel {
    return LobeKernel(lobe_psd_capped(kernel.covariance, 0.5 * limit));
}

// Rust: `Kernel::ALPHA_SQUARED_LIMIT`.
const LOBE_KERNEL_ALPHA_SQUARED_LIMIT: f32 = 0.18;

// Rust: `Kernel::add`.
fn lobe_kernel_add(kernel: LobeKernel, other: LobeKernel) -> LobeKernel {
    return LobeKernel(lobe_psd_add(kernel.covariance, other.covariance));
}
