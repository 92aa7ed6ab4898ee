// Directions drawn by what a pixel sees of many facets, and their density. Rust:
// src/material/multilobe/sample.rs.

// Rust: `DirectionSample`. A weight of 0 and a direction without length where Rust has none.
struct LobeDirectionSample {
    wi: vec3f,
    pdf: f32,
    weight: f32,
}

// Rust: `PatchNdf::sample`. None for NaN.
fn lobe_patch_ndf_sample(lobe: LobePatchNdf, wo: vec3f, u: array<f32, 7>) -> LobeDirectionSample {
    if !(wo.z > 0.0) {
        return LobeDirectionSample(vec3f(0.0, 0.0, 0.0), 0.0, 0.0);
    }
    let drawn = lobe_normal_of(lobe_patch_ndf_sample_slope(lobe, u));
    let opposite = vec3f(-drawn.x, -drawn.y, drawn.z);
    let seen = lobe_max(lobe_dot(wo, drawn), 0.0);
    let other = lobe_max(lobe_dot(wo, opposite), 0.0);
    let first = u[6] * (seen + other) < seen;
    let m = vec3f(select(opposite.x, drawn.x, first), select(opposite.y, drawn.y, first), drawn.z);
    let wi = lobe_reflect(wo, m);
    let masking = lobe_cavity_masking(wo, m);
    var weight = 0.0;
    if masking > 0.0 {
        weight = lobe_cavity_masking_shadowing(wo, wi, m) / masking;
    }
    return LobeDirectionSample(wi, lobe_patch_ndf_pdf(lobe, wo, wi), weight);
}

// Rust: `PatchNdf::pdf`. 0 for NaN.
fn lobe_patch_ndf_pdf(lobe: LobePatchNdf, wo: vec3f, wi: vec3f) -> f32 {
    let h = lobe_half_vector(wo, wi);
    let masking = lobe_cavity_masking(wo, h);
    if masking > 0.0 {
        return lobe_below_infinity(
            lobe_defined(lobe_patch_ndf_d(lobe, h) * (masking / (4.0 * wo.z)))
        );
    }
    return 0.0;
}

// Rust: `PatchNdf::sample_slope`. 0 for NaN.
fn lobe_patch_ndf_sample_slope(lobe: LobePatchNdf, u: array<f32, 7>) -> vec2f {
    var facets = LobeFacets(-1, vec2f(0.0, 0.0), vec2u(0u, 0u));
    if !lobe_patch_ndf_is_smooth(lobe) {
        facets = lobe_cells_chosen(lobe.cells, lobe.dictionary, u[0]);
    }
    if facets.level < 0 {
        return lobe_patch_ndf_sample_smooth(lobe, vec2f(u[1], u[2]));
    }
    let plane = lobe_plane_new(lobe.roughness, lobe.spread);
    let piece = lobe_pieces_piece_at(plane.pieces, u[5]);
    let widths = lobe_pieces_widths(piece, facets.turn);
    let level = u32(facets.level);
    let along = lobe_dictionary_marginal(lobe.dictionary, facets.marginals.x, level);
    let across = lobe_dictionary_marginal(lobe.dictionary, facets.marginals.y, level);
    let x = lobe_marginal_quantile(along, u[1]) + widths.x * (u[3] - 0.5);
    let y = lobe_marginal_quantile(across, u[2]) + widths.y * (u[4] - 0.5);
    let cosine = facets.turn.x;
    let sine = facets.turn.y;
    let place = vec2f(
        cosine * x - sine * y - piece.offset.x, sine * x + cosine * y - piece.offset.y
    );
    let slope = lobe_plane_slope(plane, place);
    return vec2f(lobe_defined(slope.x), lobe_defined(slope.y));
}

// Rust: `PatchNdf::sample_smooth`. 0 for NaN.
fn lobe_patch_ndf_sample_smooth(lobe: LobePatchNdf, u: vec2f) -> vec2f {
    let m = lobe_roughness_chermain_matrix(
        lobe_roughness_widened(lobe.roughness, lobe.spread), 1.0
    );
    let x = lobe_normal_quantile(1.0 - u.x);
    let y = lobe_normal_quantile(1.0 - u.y);
    return vec2f(lobe_defined(m[0][0] * x + m[1][0] * y), lobe_defined(m[1][1] * y));
}
