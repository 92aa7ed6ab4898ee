// What engines read off a mean of normals. Rust: src/filter/length.rs.

// Rust: `MEAN_LENGTH_TOLERANCE`.
const LOBE_MEAN_LENGTH_TOLERANCE: f32 = 0.006819097667594005;

// Rust: `checked`. Lengths above 1 count as 1, also those above 1 + LOBE_MEAN_LENGTH_TOLERANCE,
// which Rust refuses; lengths not above 0 count as the smallest normal number, NaN too.
fn lobe_mean_length(length: f32) -> f32 {
    return lobe_min(lobe_max(length, LOBE_MIN_POSITIVE), 1.0);
}

// Rust: `toksvig_variance`.
fn lobe_toksvig_variance(length: f32) -> f32 {
    let r = lobe_mean_length(length);
    return lobe_min((1.0 - r) / r, LOBE_LARGEST);
}

// Rust: `toksvig_exponent`.
fn lobe_toksvig_exponent(exponent: f32, length: f32) -> f32 {
    let s = lobe_magnitude(exponent);
    let r = lobe_mean_length(length);
    return s * r / (r + s * (1.0 - r));
}

// Rust: `clean_variance`. Moments beyond the ranges count as the nearest, NaN as 0.
fn lobe_clean_variance(mean: vec2f, second: f32) -> f32 {
    let m = lobe_both_within(mean, LOBE_LARGEST);
    let squares = lobe_add_products(lobe_within(second, 1e18), -m.x, m.x, -m.y, m.y);
    return lobe_max(0.5 * squares, 0.0);
}

// Rust: `vmf_sharpness`.
fn lobe_vmf_sharpness(length: f32) -> f32 {
    let r = lobe_mean_length(length);
    let spread = (1.0 - r) * (1.0 + r);
    return lobe_min(r * (3.0 - r * r) / lobe_max(spread, 1e-9), LOBE_LARGEST);
}

// Rust: `VmfWidening::THE_ORDER`.
const LOBE_VMF_WIDENING_THE_ORDER: f32 = 0.5;
// Rust: `VmfWidening::SPECULAR_AA`.
const LOBE_VMF_WIDENING_SPECULAR_AA: f32 = 2.0;

// Rust: `VmfWidening::alpha`, the gain last. Gains outside [0, 1e9] count as the nearest, NaN as 0.
fn lobe_vmf_widening_alpha(alpha: f32, length: f32, gain: f32) -> f32 {
    let a = lobe_magnitude(alpha);
    let added = lobe_min(
        lobe_magnitude(gain) / lobe_vmf_sharpness(length), LOBE_LARGEST * LOBE_LARGEST
    );
    return sqrt(a * a + added);
}
