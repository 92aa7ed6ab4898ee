// Pixel steps on the tangent plane from rays. Rust: src/slope/ray.rs.

// Rust: `step`. 0 for NaN.
fn lobe_ray_step(wo: vec3f, origin: vec3f, direction: vec3f, distance: f32) -> vec2f {
    let x = origin.x + distance * direction.x;
    let y = origin.y + distance * direction.y;
    let along = (origin.z + distance * direction.z) / lobe_max(wo.z, 1.0 / LOBE_LARGEST);
    return vec2f(lobe_defined(x - along * wo.x), lobe_defined(y - along * wo.y));
}

// Rust: `cone_steps`: the two steps are the columns. 0 for NaN.
fn lobe_ray_cone_steps(wo: vec3f, width: f32) -> mat2x2f {
    let length = sqrt(wo.x * wo.x + wo.y * wo.y);
    let turn = select(vec2f(1.0, 0.0), vec2f(wo.x / length, wo.y / length), length > 0.0);
    let long = width / lobe_max(wo.z, 1.0 / LOBE_LARGEST);
    return mat2x2f(
        lobe_defined(long * turn.x), lobe_defined(long * turn.y), lobe_defined(-(width * turn.y)),
        lobe_defined(width * turn.x)
    );
}
