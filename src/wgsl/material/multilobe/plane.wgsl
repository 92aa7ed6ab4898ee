// The plane of a dictionary's marginals: slopes without roughness. Rust: src/material/multilobe/plane.rs.

// Rust: `LEAST`.
const LOBE_PLANE_LEAST: f32 = 1e-9;
// Rust: `HALF_TURN`.
const LOBE_PLANE_HALF_TURN = array<f32, 5>(0.7854006, 0.16136818, 0.040797774, 7.447305e-3, 4.9829185e-3);

// Rust: `Plane`, without mips.
struct LobePlane {
    mapping: vec3f,
    density: f32,
    pieces: LobePieces,
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
    let mapping = vec3f(a, b, c);
    let root = lobe_psd_cholesky(kernel.covariance);
    let u = lobe_both_within(lobe_plane_deviations(mapping, vec2f(root.x, root.y)), LOBE_LARGEST);
    let v = lobe_both_within(lobe_plane_deviations(mapping, vec2f(0.0, root.z)), LOBE_LARGEST);
    return LobePlane(mapping, lobe_defined(1.0 / (a * c)), lobe_pieces_of(lobe_psd_outer_sum(u, v)));
}

// Rust: `Plane::point`.
fn lobe_plane_point(plane: LobePlane, slope: vec2f) -> vec2f {
    return lobe_plane_deviations(plane.mapping, slope);
}

// Rust: `Plane::around`.
fn lobe_plane_around(plane: LobePlane, place: vec2f) -> LobePlane {
    return LobePlane(plane.mapping, plane.density, lobe_pieces_around(plane.pieces, place));
}

// Rust: `Plane::density`.
fn lobe_plane_density(
    plane: LobePlane, dictionary: LobeDictionary, at: vec2f, facets: LobeFacets
) -> f32 {
    let level = u32(facets.level);
    let cosine = facets.turn.x;
    let sine = facets.turn.y;
    let along = lobe_dictionary_marginal(dictionary, facets.marginals.x, level);
    let across = lobe_dictionary_marginal(dictionary, facets.marginals.y, level);
    var sum = 0.0;
    for (var j = 0; j < LOBE_PIECES_MOST; j++) {
        let k = plane.pieces.first + j;
        if k > plane.pieces.last {
            break;
        }
        let piece = lobe_pieces_piece(plane.pieces, k);
        let widths = lobe_pieces_widths(piece, facets.turn);
        let x = at.x + piece.offset.x;
        let y = at.y + piece.offset.y;
        let p = lobe_marginal_mean(along, cosine * x + sine * y, widths.x);
        if p > 0.0 {
            sum = sum + piece.share * (p * lobe_marginal_mean(across, cosine * y - sine * x, widths.y));
        }
    }
    return sum * plane.density;
}

// Rust: `deviations`.
fn lobe_plane_deviations(mapping: vec3f, slope: vec2f) -> vec2f {
    let y = slope.y / mapping.z;
    return vec2f((slope.x - mapping.y * y) / mapping.x, y);
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
