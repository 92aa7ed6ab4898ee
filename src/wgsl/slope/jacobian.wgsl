// Derivatives between sphere, projected disk and slope plane. Rust: src/slope/jacobian.rs.
// A matrix has its columns first, as WGSL has it; Rust's have their rows first. `matrix * vector`
// means the same.

// Rust: `azimuth`: cosine and sine.
fn lobe_jacobian_azimuth(h: vec3f) -> vec2f {
    let length = sqrt(h.x * h.x + h.y * h.y);
    return select(vec2f(1.0, 0.0), vec2f(h.x / length, h.y / length), length > 0.0);
}

// WGSL only: a matrix by its rows, 0 in place of NaN.
fn lobe_jacobian_rows(a: f32, b: f32, c: f32, d: f32) -> mat2x2f {
    return mat2x2f(lobe_defined(a), lobe_defined(c), lobe_defined(b), lobe_defined(d));
}

// Rust: `sphere_to_slope`. 0 for NaN.
fn lobe_sphere_to_slope(h: vec3f) -> mat2x2f {
    let turn = lobe_jacobian_azimuth(h);
    let z = h.z;
    return lobe_jacobian_rows(-turn.x / (z * z), turn.y / z, -turn.y / (z * z), -turn.x / z);
}

// Rust: `sphere_to_disk`. 0 for NaN.
fn lobe_sphere_to_disk(h: vec3f) -> mat2x2f {
    let turn = lobe_jacobian_azimuth(h);
    return lobe_jacobian_rows(turn.x * h.z, -turn.y, turn.y * h.z, turn.x);
}

// Rust: `disk_to_slope`. 0 for NaN.
fn lobe_disk_to_slope(h: vec3f) -> mat2x2f {
    let z = h.z;
    let inverse_cube = 1.0 / (z * z * z);
    let mixed = -inverse_cube * h.x * h.y;
    return lobe_jacobian_rows(
        -inverse_cube * (z * z + h.x * h.x), mixed, mixed, -inverse_cube * (z * z + h.y * h.y)
    );
}

// Rust: `slope_per_normal`. 0 for NaN.
fn lobe_slope_per_normal(m: vec3f) -> f32 {
    return lobe_defined(1.0 / (m.z * m.z * m.z));
}

// Rust: `reflection_per_normal`. 0 for NaN.
fn lobe_reflection_per_normal(wm: vec3f, wo: vec3f) -> f32 {
    return lobe_defined(4.0 * abs(lobe_dot(wm, wo)));
}

// Rust: `apply`. 0 for NaN.
fn lobe_jacobian_apply(m: mat2x2f, v: vec2f) -> vec2f {
    return vec2f(
        lobe_defined(m[0][0] * v.x + m[1][0] * v.y), lobe_defined(m[0][1] * v.x + m[1][1] * v.y)
    );
}
