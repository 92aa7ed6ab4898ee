// Which level of a cube map a solid angle asks for. Rust: src/material/leadr/lod.rs.

// Rust: `cube_lod`. NaN counts as the smallest number.
fn lobe_cube_lod(solid_angle: f32, face: f32) -> f32 {
    let texels = 0.477464829 * solid_angle;
    return lobe_lod_log(texels) * 0.5 + lobe_lod_log(face);
}

// Rust: `log_two`.
fn lobe_lod_log(x: f32) -> f32 {
    return lobe_ln(lobe_below_infinity(lobe_max(x, LOBE_MIN_POSITIVE))) * 1.44269504;
}
