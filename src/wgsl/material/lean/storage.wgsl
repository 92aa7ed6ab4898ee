// Raw moments as textures hold them. Rust: src/material/lean/storage.rs.

// Rust: `MIDDLE`.
const LOBE_LEAN_MIDDLE: f32 = 32768.0;
// Rust: `SIGNED_STEPS`.
const LOBE_LEAN_SIGNED_STEPS: f32 = 32767.0;
// Rust: `STEPS`.
const LOBE_LEAN_STEPS: f32 = 65535.0;

// Rust: `SlopeMoments::from_unorm`: what samplers give, and the range it was written for. Beyond
// the ranges the nearest moments, 0 for NaN.
fn lobe_slope_moments_from_unorm(mean: vec2f, second: vec3f, range: f32) -> LobeSlopeMoments {
    let square = range * range;
    return lobe_slope_moments_from_raw(
        vec2f(lobe_lean_signed(mean.x) * range, lobe_lean_signed(mean.y) * range),
        vec3f(second.x * square, lobe_lean_signed(second.y) * square, second.z * square)
    );
}

// WGSL only: of `raw_of_unorm`, which has it as a closure.
fn lobe_lean_signed(v: f32) -> f32 {
    return (v * LOBE_LEAN_STEPS - LOBE_LEAN_MIDDLE) * (1.0 / LOBE_LEAN_SIGNED_STEPS);
}
