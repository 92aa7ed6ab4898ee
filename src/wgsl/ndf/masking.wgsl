// The ends of masking terms, the same for every distribution. Rust: src/ndf/masking.rs.

// WGSL only: the end of `Ndf::g2`.
fn lobe_masking_shadowing_of(c_o: f32, c_i: f32, sum: f32) -> f32 {
    let ratio = lobe_min(2.0 * c_o * c_i / lobe_max(sum, LOBE_MIN_POSITIVE), 1.0);
    return select(0.0, lobe_defined(ratio), lobe_min(c_o, c_i) > 0.0);
}

// WGSL only: the end of `Ndf::visibility`.
fn lobe_visibility_of(c_o: f32, c_i: f32, sum: f32) -> f32 {
    return select(0.0, 0.5 / lobe_max(sum, LOBE_MIN_POSITIVE), lobe_min(c_o, c_i) > 0.0);
}
