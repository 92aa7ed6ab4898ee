// Colors of details. Rust: src/material/glint/color.rs.

// Rust: `hue_wheel`.
fn lobe_hue_wheel(hue: f32) -> vec3f {
    let turn = 6.0 * hue;
    return vec3f(
        lobe_color_channel(abs(turn - 3.0) - 1.0), lobe_color_channel(2.0 - abs(turn - 2.0)),
        lobe_color_channel(2.0 - abs(turn - 4.0))
    );
}

// WGSL only: of `hue_wheel`, which has it as a closure. 0 for NaN.
fn lobe_color_channel(channel: f32) -> f32 {
    return 2.0 * lobe_min(lobe_max(channel, 0.0), 1.0);
}

// Rust: `tint`.
fn lobe_color_tint(color: vec3f, count: f32) -> vec3f {
    let contrast = 1.0 / sqrt(lobe_max(count, 1.0));
    return vec3f(
        1.0 + (color.x - 1.0) * contrast, 1.0 + (color.y - 1.0) * contrast,
        1.0 + (color.z - 1.0) * contrast
    );
}
