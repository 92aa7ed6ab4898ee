// Half vectors, normals and slopes. Rust: src/slope/direction.rs.

// Rust: `half_vector`. 0 for opposite directions and for NaN.
fn lobe_half_vector(wo: vec3f, wi: vec3f) -> vec3f {
    return lobe_normalize(vec3f(wo.x + wi.x, wo.y + wi.y, wo.z + wi.z));
}

// Rust: `normalize`. 0 where there is no length, an infinite one, or NaN.
fn lobe_normalize(v: vec3f) -> vec3f {
    let largest = lobe_max(lobe_max(abs(v.x), abs(v.y)), abs(v.z));
    let finite = lobe_is_finite(v.x) && lobe_is_finite(v.y) && lobe_is_finite(v.z);
    if !(finite && largest >= LOBE_MIN_POSITIVE) {
        return vec3f(0.0, 0.0, 0.0);
    }
    let scaled = vec3f(
        lobe_kept(v.x / largest), lobe_kept(v.y / largest), lobe_kept(v.z / largest)
    );
    // At least 1, but where a driver's quotient by the largest numbers is 0.
    let length = lobe_max(sqrt(lobe_dot(scaled, scaled)), 1.0);
    return vec3f(scaled.x / length, scaled.y / length, scaled.z / length);
}

// Rust: `dot`.
fn lobe_dot(a: vec3f, b: vec3f) -> f32 {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

// Rust: `slope_of`. Infinite on the horizon; 0 for NaN and for the zero vector.
fn lobe_slope_of(m: vec3f) -> vec2f {
    return vec2f(lobe_defined(-m.x / m.z), lobe_defined(-m.y / m.z));
}

// Rust: `normal_of`. 0 for NaN.
fn lobe_normal_of(slope: vec2f) -> vec3f {
    let inverse = 1.0 / sqrt(1.0 + slope.x * slope.x + slope.y * slope.y);
    return vec3f(
        lobe_defined(-slope.x * inverse), lobe_defined(-slope.y * inverse), lobe_defined(inverse)
    );
}

// Rust: `from_disk`. 0 for NaN.
fn lobe_from_disk(point: vec2f) -> vec3f {
    let square = lobe_add_products(1.0, -point.x, point.x, -point.y, point.y);
    let height = lobe_max(lobe_defined(square), 0.0);
    return vec3f(lobe_defined(point.x), lobe_defined(point.y), sqrt(height));
}

// Rust: `reflect`. 0 for NaN.
fn lobe_reflect(w: vec3f, m: vec3f) -> vec3f {
    let twice = 2.0 * lobe_dot(w, m);
    return vec3f(
        lobe_defined(twice * m.x - w.x), lobe_defined(twice * m.y - w.y),
        lobe_defined(twice * m.z - w.z)
    );
}
