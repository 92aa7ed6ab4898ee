// Schlick's and the conductor's reflectance. Rust: src/material/fresnel.rs.

// Rust: `Fresnel::schlick`, then `Fresnel::reflectance`. Numbers beyond [0, 1] count as the
// nearest, NaN as 0.
fn lobe_fresnel_schlick(normal: vec3f, cosine: f32) -> vec3f {
    let c = lobe_min(lobe_max(cosine, 0.0), 1.0);
    let rest = 1.0 - c;
    let power = (rest * rest) * (rest * rest) * rest;
    let f = vec3f(
        lobe_min(lobe_max(normal.x, 0.0), 1.0), lobe_min(lobe_max(normal.y, 0.0), 1.0),
        lobe_min(lobe_max(normal.z, 0.0), 1.0)
    );
    return vec3f(f.x + (1.0 - f.x) * power, f.y + (1.0 - f.y) * power, f.z + (1.0 - f.z) * power);
}

// Rust: `Fresnel::conductor`, then `Fresnel::reflectance`. Numbers beyond their ranges count as the
// nearest, NaN as 0.
fn lobe_fresnel_conductor(eta: vec3f, k: vec3f, cosine: f32) -> vec3f {
    let c = lobe_min(lobe_max(cosine, 0.0), 1.0);
    return vec3f(
        lobe_fresnel_channel(eta.x, k.x, c), lobe_fresnel_channel(eta.y, k.y, c),
        lobe_fresnel_channel(eta.z, k.z, c)
    );
}

// Rust: `conductor`.
fn lobe_fresnel_channel(index: f32, extinction: f32, c: f32) -> f32 {
    let eta = lobe_magnitude(index);
    let k = lobe_magnitude(extinction);
    let sine_squared = (1.0 - c) * (1.0 + c);
    let real = (eta - k) * (eta + k) - sine_squared;
    let half_imaginary = eta * k;
    let modulus = sqrt(real * real + 4.0 * half_imaginary * half_imaginary);
    let larger = lobe_max(sqrt(0.5 * (modulus + abs(real))), LOBE_MIN_POSITIVE);
    let smaller = half_imaginary / larger;
    let a = select(smaller, larger, real >= 0.0);
    let b = select(larger, smaller, real >= 0.0);
    let s = ((a - c) * (a - c) + b * b) / lobe_max((a + c) * (a + c) + b * b, LOBE_MIN_POSITIVE);
    let run = a * c;
    let rise = b * b * (c * c);
    let p = ((run - sine_squared) * (run - sine_squared) + rise)
        / lobe_max((run + sine_squared) * (run + sine_squared) + rise, LOBE_MIN_POSITIVE);
    return lobe_min(0.5 * s * (1.0 + p), 1.0);
}
