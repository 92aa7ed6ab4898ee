// How a path moves over a pixel: footprints without quads. Rust: src/slope/motion.rs.

// Rust: `Motion`.
struct LobeMotion {
    half_vector: vec3f,
    normal: vec2f,
    spin: f32,
}

// Rust: `Motion::plane_step`.
fn lobe_motion_plane_step(motion: LobeMotion, g: vec3f) -> vec2f {
    let p = vec2f(g.x / g.z, g.y / g.z);
    let dg = vec3f(
        motion.half_vector.x / g.z, motion.half_vector.y / g.z, motion.half_vector.z / g.z
    );
    let pull = dg.z + p.x * motion.normal.x + p.y * motion.normal.y;
    return vec2f(
        dg.x - motion.normal.x - p.x * pull + p.y * motion.spin,
        dg.y - motion.normal.y - p.y * pull + -(p.x * motion.spin)
    );
}

// Rust: `Footprint::from_motion`. The zero footprint where that returns an error.
fn lobe_footprint_from_motion(half_vector: vec3f, u: LobeMotion, v: LobeMotion) -> LobeFootprint {
    let above = half_vector.z > 0.0 && lobe_footprint_is_known(half_vector);
    let a = lobe_motion_plane_step(u, half_vector);
    let b = lobe_motion_plane_step(v, half_vector);
    return lobe_footprint_if(above, vec2f(-a.x, -a.y), vec2f(-b.x, -b.y));
}
