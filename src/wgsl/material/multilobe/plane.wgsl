// The plane of a dictionary's marginals: slopes without roughness. Rust: src/material/multilobe/plane.rs.

// Rust: `LEAST`.
const LOBE_PLANE_LEAST: f32 = 1e-9;
// Rust: `HALF_TURN`.
const LOBE_PLANE_HALF_TURN = array<f32, 5>(0.7854006, 0.16136818, 0.040797774, 7.447305e-3, 4.9829185e-3);

// Rust: `Plane`, without mips.
struct LobePlane {
    mapping: vec3f,
    density: f32,
    spread: vec3f,
}

// Rust: `Facets`. A level of -1 is none, the smooth lobe.
struct LobeFacets {
    level: i32,
    turn: vec2f,
    marginals: vec2u,
}

// Rust: `Plane::new`. 0 for NaN.
fn lobe_plane_new(roughness: LobeRoughness, kernel: LobeKernel) -> LobePlane {
    let m = lobe_roughness_chermain_matrix(roughness, 1.0);
    let a = lobe_max(m[0][0], LOBE_PLANE_LEAST);
    let b = m[1][0];
    let c = lobe_max(m[1][1], LOBE_PLANE_LEAST);
    let psd = kernel.covariance;
    let yy = psd.yy / c / c;
    let along = psd.xy / c;
    let xx = (psd.xx - 2.0 * b * along + b * b * yy) / a / a;
    let xy = (along - b * yy) / a;
    return LobePlane(
        vec3f(a, b, c), lobe_defined(1.0 / (a * c)), vec3f(lobe_max(xx, 0.0), lobe_defined(xy), lobe_defined(yy))
    );
}

// Rust: `Plane::point`.
fn lobe_plane_point(plane: LobePlane, slope: vec2f) -> vec2f {
    let y = slope.y / plane.mapping.z;
    return vec2f((slope.x - plane.mapping.y * y) / plane.mapping.x, y);
}

// Rust: `Plane::widths`.
fn lobe_plane_widths(plane: LobePlane, turn: vec2f) -> vec2f {
    let k = plane.spread;
    let cc = turn.x * turn.x;
    let ss = turn.y * turn.y;
    let cs = 2.0 * turn.x * turn.y;
    let along = cc * k.x + cs * k.y + ss * k.z;
    let across = ss * k.x - cs * k.y + cc * k.z;
    return vec2f(sqrt(12.0 * lobe_max(along, 0.0)), sqrt(12.0 * lobe_max(across, 0.0)));
}

// Rust: `Plane::density`.
fn lobe_plane_density(
    plane: LobePlane, dictionary: LobeDictionary, at: vec2f, facets: LobeFacets
) -> f32 {
    let level = u32(facets.level);
    let cosine = facets.turn.x;
    let sine = facets.turn.y;
    let x = cosine * at.x + sine * at.y;
    let y = cosine * at.y - sine * at.x;
    let widths = lobe_plane_widths(plane, facets.turn);
    let p = lobe_marginal_mean(lobe_dictionary_marginal(dictionary, facets.marginals.x, level), x, widths.x);
    if !(p > 0.0) {
        return 0.0;
    }
    let q = lobe_marginal_mean(lobe_dictionary_marginal(dictionary, facets.marginals.y, level), y, widths.y);
    return p * q * plane.density;
}

// Rust: `quarter_turn`.
fn lobe_plane_quarter_turn(word: u32) -> vec2f {
    let u = lobe_hash_uniform(word);
    let v = u * u;
    let h = LOBE_PLANE_HALF_TURN;
    let t = ((((h[4] * v + h[3]) * v + h[2]) * v + h[1]) * v + h[0]) * u;
    let scale = 1.0 / (1.0 + t * t);
    return vec2f((1.0 - t * t) * scale, 2.0 * t * scale);
}
