// A pixel's place on a surface. Rust: src/material/glint/patch.rs.

// Rust: `Patch`.
struct LobePatch {
    uv: vec2f,
    right: vec2f,
    up: vec2f,
}

// Rust: `Patch::extents`. NaN counts as 0.
fn lobe_patch_extents(pixel: LobePatch) -> vec2f {
    return vec2f(
        lobe_max(abs(pixel.right.x), lobe_max(abs(pixel.up.x), 0.0)),
        lobe_max(abs(pixel.right.y), lobe_max(abs(pixel.up.y), 0.0))
    );
}

// Rust: `Patch::area`. 0 for NaN, and where a side has no end.
fn lobe_patch_area(pixel: LobePatch) -> f32 {
    return lobe_defined(abs(lobe_cross(pixel.right, pixel.up)));
}

// Rust: `Patch::width`. 0 for NaN.
fn lobe_patch_width(pixel: LobePatch) -> f32 {
    let extents = lobe_patch_extents(pixel);
    let long = lobe_max(extents.x, extents.y);
    let p = vec2f(pixel.right.x / long, pixel.right.y / long);
    let q = vec2f(pixel.up.x / long, pixel.up.y / long);
    let twice = lobe_patch_length(p.x + q.y, p.y - q.x) + lobe_patch_length(p.x - q.y, p.y + q.x);
    return lobe_max(long * (2.0 * abs(lobe_cross(p, q)) / twice), 0.0);
}

// WGSL only: of `Patch::width`, which has it as a closure.
fn lobe_patch_length(x: f32, y: f32) -> f32 {
    return sqrt(x * x + y * y);
}

// Rust: `Patch::stretched`.
fn lobe_patch_stretched(pixel: LobePatch, factors: vec2f) -> LobePatch {
    return LobePatch(pixel.uv * factors, pixel.right * factors, pixel.up * factors);
}
