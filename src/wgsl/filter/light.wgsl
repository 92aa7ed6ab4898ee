// A spherical Gaussian light as a kernel. Rust: src/filter/light.rs.

// Rust: `SphericalGaussian`.
struct LobeSphericalGaussian {
    direction: vec3f,
    sharpness: f32,
}

// Rust: `SphericalGaussian::new`. Sharpness beyond [1e-9, 1e18] counts as the nearest; a direction
// without length is 0.
fn lobe_spherical_gaussian_new(direction: vec3f, sharpness: f32) -> LobeSphericalGaussian {
    let bounded = lobe_min(lobe_max(sharpness, 1.0 / LOBE_LARGEST), LOBE_LARGEST * LOBE_LARGEST);
    return LobeSphericalGaussian(lobe_normalize(direction), bounded);
}

// Rust: `SphericalGaussian::from_angular_radius`. Radii beyond [2e-9, 6e4] count as the nearest,
// NaN as the least.
fn lobe_spherical_gaussian_from_angular_radius(
    direction: vec3f, radius: f32
) -> LobeSphericalGaussian {
    let size = lobe_max(radius, 2e-9);
    return lobe_spherical_gaussian_new(direction, 4.0 / size / size);
}

// Rust: `SphericalGaussian::integral`.
fn lobe_spherical_gaussian_integral(light: LobeSphericalGaussian) -> f32 {
    let x = 2.0 * light.sharpness;
    var part = 0.0;
    if x < 0.001 {
        part = 1.0 - x * (0.5 - x / 6.0);
    } else {
        part = (1.0 - lobe_exp(-x)) / x;
    }
    return 4.0 * LOBE_PI * part;
}

// Rust: `SphericalGaussian::kernel`.
fn lobe_spherical_gaussian_kernel(light: LobeSphericalGaussian, wo: vec3f) -> LobeKernel {
    return lobe_kernel_of(
        lobe_spherical_gaussian_footprint(light, wo), lobe_spherical_gaussian_spread(light)
    );
}

// Rust: `SphericalGaussian::disk_kernel`.
fn lobe_spherical_gaussian_disk_kernel(light: LobeSphericalGaussian, wo: vec3f) -> LobeDiskKernel {
    let g = lobe_spherical_gaussian_sum(light, wo);
    let squared = lobe_dot(g, g);
    let inverse = 1.0 / sqrt(lobe_max(squared, LOBE_MIN_POSITIVE));
    let h = vec3f(g.x * inverse, g.y * inverse, g.z * inverse);
    let tangents = lobe_spherical_gaussian_tangents(light);
    let s = tangents[0];
    let t = tangents[1];
    let along_s = lobe_dot(h, s);
    let along_t = lobe_dot(h, t);
    let u = vec2f((s.x - h.x * along_s) * inverse, (s.y - h.y * along_s) * inverse);
    let v = vec2f((t.x - h.x * along_t) * inverse, (t.y - h.y * along_t) * inverse);
    if g.z > 0.0 && lobe_footprint_is_known(g) {
        return lobe_disk_kernel_of(u, v, lobe_spherical_gaussian_spread(light));
    }
    return lobe_disk_kernel_from_covariance(LobePsd(0.0, 0.0, 0.0));
}

// Rust: `SphericalGaussian::footprint`.
fn lobe_spherical_gaussian_footprint(light: LobeSphericalGaussian, wo: vec3f) -> LobeFootprint {
    let zero = vec2f(0.0, 0.0);
    let tangents = lobe_spherical_gaussian_tangents(light);
    return lobe_footprint_from_motion(
        lobe_spherical_gaussian_sum(light, wo), LobeMotion(tangents[0], zero, 0.0),
        LobeMotion(tangents[1], zero, 0.0)
    );
}

// Rust: `SphericalGaussian::sum`.
fn lobe_spherical_gaussian_sum(light: LobeSphericalGaussian, wo: vec3f) -> vec3f {
    let w = light.direction;
    return vec3f(wo.x + w.x, wo.y + w.y, wo.z + w.z);
}

// Rust: `SphericalGaussian::spread`.
fn lobe_spherical_gaussian_spread(light: LobeSphericalGaussian) -> f32 {
    return lobe_min(1.0 / light.sharpness, LOBE_LARGEST);
}

// Rust: `SphericalGaussian::tangents`: the two are the columns.
fn lobe_spherical_gaussian_tangents(light: LobeSphericalGaussian) -> mat2x3f {
    let w = light.direction;
    let sign = select(-1.0, 1.0, w.z >= 0.0);
    let a = -1.0 / (sign + w.z);
    let b = w.x * w.y * a;
    return mat2x3f(
        vec3f(1.0 + sign * w.x * w.x * a, sign * b, -(sign * w.x)),
        vec3f(b, sign + w.y * w.y * a, -w.y)
    );
}
