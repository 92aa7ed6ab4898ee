// The plane of a dictionary's marginals: slopes without roughness. Rust:
// src/material/multilobe/plane.rs.

// Rust: `SHARE`.
const LOBE_PLANE_SHARE: i32 = -10;
// Rust: `LEAST`.
const LOBE_PLANE_LEAST: f32 = 1e-9;

// Rust: `Plane`, without mips.
struct LobePlane {
    mapping: vec3f,
    density: f32,
    pieces: LobePieces,
}

// Rust: `Plane::new`. 0 for NaN.
fn lobe_plane_new(roughness: LobeRoughness, kernel: LobeKernel) -> LobePlane {
    let m = lobe_roughness_chermain_matrix(roughness, 1.0);
    let added = lobe_kernel_added(kernel);
    let root = 0.70710677;
    let k = vec2f(added.u.x * root, added.u.y * root);
    let l = vec2f(added.v.x * root, added.v.y * root);
    let share = lobe_power_of_two(LOBE_PLANE_SHARE);
    let across = share * sqrt(k.y * k.y + l.y * l.y);
    let c = lobe_max(lobe_max(m[1][1], LOBE_PLANE_LEAST), across);
    let b = m[1][0];
    let lean = b / c;
    let p = k.x - lean * k.y;
    let q = l.x - lean * l.y;
    let a = lobe_max(lobe_max(m[0][0], LOBE_PLANE_LEAST), share * sqrt(p * p + q * q));
    let mapping = vec3f(a, b, c);
    let u = lobe_both_within(lobe_plane_deviations(mapping, k), LOBE_LARGEST);
    let v = lobe_both_within(lobe_plane_deviations(mapping, l), LOBE_LARGEST);
    let density = lobe_defined(1.0 / (a * c));
    let root_det = lobe_below_infinity(abs(k.x * l.y - k.y * l.x) * density);
    return LobePlane(
        mapping, density, lobe_pieces_of(lobe_psd_outer_sum_with_root_det(u, v, root_det))
    );
}

// Rust: `Plane::slope`.
fn lobe_plane_slope(plane: LobePlane, place: vec2f) -> vec2f {
    return vec2f(plane.mapping.x * place.x + plane.mapping.y * place.y, plane.mapping.z * place.y);
}

// WGSL only: what `Plane::around` returns as a pair.
struct LobePlaneAround {
    plane: LobePlane,
    place: vec2f,
}

// Rust: `Plane::around`.
fn lobe_plane_around(plane: LobePlane, slope: vec2f) -> LobePlaneAround {
    let place = lobe_pieces_folded(plane.pieces, lobe_plane_deviations(plane.mapping, slope));
    let pieces = lobe_pieces_around(plane.pieces, place);
    return LobePlaneAround(LobePlane(plane.mapping, plane.density, pieces), place);
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
            sum = sum
                + piece.share * (p * lobe_marginal_mean(across, cosine * y - sine * x, widths.y));
        }
    }
    return sum * plane.density;
}

// Rust: `deviations`.
fn lobe_plane_deviations(mapping: vec3f, slope: vec2f) -> vec2f {
    let y = slope.y / mapping.z;
    return vec2f((slope.x - mapping.y * y) / mapping.x, y);
}
