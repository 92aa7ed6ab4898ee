// Kaplanyan's matrix M from positions, distances and curvature. Rust: src/slope/path.rs.

// Rust: `Vertex`.
struct LobeVertex {
    direction: vec3f,
    inverse_distance: f32,
}

// Rust: `Path`. The curvature is b11, b12, b22.
struct LobePath {
    eye: LobeVertex,
    light: LobeVertex,
    curvature: vec3f,
}

// Rust: `Vertex::at`. The zero vector, infinitely far, where that returns an error.
fn lobe_vertex_at(position: vec3f) -> LobeVertex {
    let none = LobeVertex(vec3f(0.0, 0.0, 0.0), 0.0);
    let scale = lobe_max(
        lobe_max(lobe_max(0.0, abs(position.x)), abs(position.y)), abs(position.z)
    );
    let invertible = lobe_kept(lobe_min(scale, 1.0) * LOBE_MAX) >= 1.0;
    if !(invertible && lobe_footprint_is_known(position)) {
        return none;
    }
    let unit =
        vec3f(
            lobe_kept(position.x / scale), lobe_kept(position.y / scale),
            lobe_kept(position.z / scale)
        );
    // At least 1, but where a driver's quotient by the largest numbers is 0.
    let length = lobe_max(sqrt(lobe_dot(unit, unit)), 1.0);
    return LobeVertex(
        vec3f(unit.x / length, unit.y / length, unit.z / length), 1.0 / length / scale
    );
}

// Rust: `Vertex::distant`. The zero vector where that returns an error.
fn lobe_vertex_distant(direction: vec3f) -> LobeVertex {
    return LobeVertex(lobe_vertex_at(direction).direction, 0.0);
}

// Rust: `Vertex::turn`.
fn lobe_vertex_turn(vertex: LobeVertex, v: vec3f) -> vec3f {
    let w = vertex.direction;
    let along = lobe_dot(w, v);
    let inverse = vertex.inverse_distance;
    return vec3f(
        (w.x * along - v.x) * inverse, (w.y * along - v.y) * inverse, (w.z * along - v.z) * inverse
    );
}

// Rust: `Path::plane_point`. 0 for NaN.
fn lobe_path_plane_point(path: LobePath) -> vec2f {
    let g = lobe_path_half_vector(path);
    return select(
        vec2f(0.0, 0.0), vec2f(lobe_defined(g.x / g.z), lobe_defined(g.y / g.z)), g.z > 0.0
    );
}

// Rust: `Path::half_vector`.
fn lobe_path_half_vector(path: LobePath) -> vec3f {
    let wo = path.eye.direction;
    let wi = path.light.direction;
    return vec3f(wo.x + wi.x, wo.y + wi.y, wo.z + wi.z);
}

// Rust: `Path::motion`. 0 for NaN.
fn lobe_path_motion(path: LobePath, step: vec2f) -> LobeMotion {
    let b = path.curvature;
    let eye = lobe_vertex_turn(path.eye, vec3f(step.x, step.y, 0.0));
    let light = lobe_vertex_turn(path.light, vec3f(step.x, step.y, 0.0));
    return LobeMotion(
        vec3f(
            lobe_defined(eye.x + light.x), lobe_defined(eye.y + light.y),
            lobe_defined(eye.z + light.z)
        ),
        vec2f(lobe_defined(b.x * step.x + b.y * step.y), lobe_defined(b.y * step.x + b.z * step.y)),
        0.0
    );
}

// Rust: `Path::slope_jacobian`. Columns first.
fn lobe_path_slope_jacobian(path: LobePath) -> mat2x2f {
    let g = lobe_path_half_vector(path);
    if !(g.z > 0.0) {
        return mat2x2f(0.0, 0.0, 0.0, 0.0);
    }
    let s = lobe_motion_plane_step(lobe_path_motion(path, vec2f(1.0, 0.0)), g);
    let t = lobe_motion_plane_step(lobe_path_motion(path, vec2f(0.0, 1.0)), g);
    return mat2x2f(
        lobe_finite(s.x), lobe_finite(s.y), lobe_finite(t.x), lobe_finite(t.y)
    );
}
