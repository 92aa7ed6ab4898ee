// A pixel's place on a surface. Rust: src/material/cells/patch.rs.

// Rust: `Patch`.
struct LobePatch {
    tile: vec2i,
    uv: vec2f,
    right: vec2f,
    up: vec2f,
}

// Rust: `Patch::new`.
fn lobe_patch_new(uv: vec2f, right: vec2f, up: vec2f) -> LobePatch {
    return lobe_patch_in_tile(vec2i(0, 0), uv, right, up);
}

// Rust: `Patch::in_tile`.
fn lobe_patch_in_tile(tile: vec2i, uv: vec2f, right: vec2f, up: vec2f) -> LobePatch {
    return LobePatch(tile, uv, right, up);
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
    let long = lobe_max(lobe_max(extents.x, extents.y), LOBE_MIN_POSITIVE);
    let p = vec2f(lobe_kept(pixel.right.x / long), lobe_kept(pixel.right.y / long));
    let q = vec2f(lobe_kept(pixel.up.x / long), lobe_kept(pixel.up.y / long));
    let twice = lobe_patch_length(p.x + q.y, p.y - q.x) + lobe_patch_length(p.x - q.y, p.y + q.x);
    return lobe_defined(long * (2.0 * abs(lobe_cross(p, q)) / lobe_max(twice, LOBE_MIN_POSITIVE)));
}

// WGSL only: of `Patch::width`, which has it as a closure.
fn lobe_patch_length(x: f32, y: f32) -> f32 {
    return sqrt(x * x + y * y);
}

// Rust: `Patch::stretched`.
fn lobe_patch_stretched(pixel: LobePatch, factors: vec2f) -> LobePatch {
    var tile = vec2i(0, 0);
    var uv = pixel.uv * factors;
    if pixel.tile.x != 0 || pixel.tile.y != 0 {
        let u = lobe_tile_compressed(pixel.tile.x, pixel.uv.x, factors.x);
        let v = lobe_tile_compressed(pixel.tile.y, pixel.uv.y, factors.y);
        tile = vec2i(u.tile, v.tile);
        uv = vec2f(u.fraction, v.fraction);
    }
    return LobePatch(tile, uv, pixel.right * factors, pixel.up * factors);
}

// Rust: `Patch::distance`. NaN counts as 0.
fn lobe_patch_distance(pixel: LobePatch) -> f32 {
    return lobe_max(abs(pixel.uv.x), lobe_max(abs(pixel.uv.y), 0.0));
}
