// What a pixel sees of many facets: a density of slopes that integrates to 1. Rust:
// src/material/multilobe/ndf.rs.

// Rust: `PatchNdf`, without mips.
struct LobePatchNdf {
    dictionary: LobeDictionary,
    roughness: LobeRoughness,
    spread: LobeKernel,
    cells: LobeCells,
}

// WGSL only: what all cells share under one slope, captures of `PatchNdf::slope_pdf` in Rust.
struct LobePatchTerms {
    plane: LobePlane,
    at: vec2f,
    tended: f32,
}

// Rust: `MultiLobe::ndf`. NaN counts as 0.
fn lobe_multi_lobe_ndf(
    facets: LobeMultiLobe, dictionary: LobeDictionary, pixel: LobePatch
) -> LobePatchNdf {
    let cells = lobe_cells_new(
        lobe_ellipse_of(pixel), lobe_multi_lobe_facet_size(facets), facets.density,
        facets.variation, facets.share,
        facets.seed
    );
    return LobePatchNdf(
        dictionary, facets.roughness, LobeKernel(vec2f(0.0, 0.0), vec2f(0.0, 0.0)), cells
    );
}

// Rust: `PatchNdf::over`.
fn lobe_patch_ndf_over(lobe: LobePatchNdf, moments: LobeSlopeMoments) -> LobePatchNdf {
    var over = lobe;
    let seen = lobe_mean_frame_moments(lobe_mean_frame_of(moments.mean), moments);
    over.roughness = lobe_roughness_add(
        lobe.roughness, lobe_roughness_from_covariance(seen.covariance)
    );
    return over;
}

// Rust: `PatchNdf::widened`.
fn lobe_patch_ndf_widened(lobe: LobePatchNdf, kernel: LobeKernel) -> LobePatchNdf {
    var widened = lobe;
    widened.spread = lobe_kernel_add(lobe.spread, kernel);
    return widened;
}

// Rust: `PatchNdf::smooth`.
fn lobe_patch_ndf_smooth(lobe: LobePatchNdf) -> LobeAnisotropic {
    return lobe_anisotropic_new(lobe_roughness_widened(lobe.roughness, lobe.spread));
}

// Rust: `PatchNdf::slope_pdf`. 0 for NaN.
fn lobe_patch_ndf_slope_pdf(lobe: LobePatchNdf, slope: vec2f) -> f32 {
    let shape = lobe_patch_ndf_smooth(lobe);
    let tended = lobe_beckmann_slope_pdf(
        lobe_anisotropic_normal(shape, vec3f(-slope.x, -slope.y, 1.0))
    );
    if lobe_patch_ndf_is_smooth(lobe) || !(shape.root_det > 0.0) {
        return tended;
    }
    let around = lobe_plane_around(lobe_plane_new(lobe.roughness, lobe.spread), slope);
    let terms = LobePatchTerms(around.plane, around.place, tended);
    var mean = 0.0;
    for (var step = 0; step < 2; step++) {
        let share = select(1.0 - lobe.cells.coarser, lobe.cells.coarser, step == 1);
        if share > 0.0 {
            mean = mean + share * lobe_patch_ndf_level(lobe, terms, step);
        }
    }
    return lobe_below_infinity(lobe_max(mean, 0.0));
}

// Rust: `PatchNdf::d`. 0 for NaN.
fn lobe_patch_ndf_d(lobe: LobePatchNdf, m: vec3f) -> f32 {
    if !(m.z > 0.0) {
        return 0.0;
    }
    let square = m.z * m.z;
    // Not `lobe_slope_of`, which has 0 for NaN.
    let density = lobe_patch_ndf_slope_pdf(lobe, vec2f(-m.x / m.z, -m.y / m.z));
    return lobe_below_infinity(lobe_defined(density / (square * square)));
}

// Rust: `PatchNdf::brdf`. 0 for NaN.
fn lobe_patch_ndf_brdf(lobe: LobePatchNdf, wo: vec3f, wi: vec3f) -> f32 {
    let h = lobe_half_vector(wo, wi);
    let masking = lobe_cavity_masking_shadowing(wo, wi, h);
    if masking > 0.0 {
        let weight = masking / (4.0 * wo.z * wi.z);
        return lobe_below_infinity(lobe_defined(lobe_patch_ndf_d(lobe, h) * weight));
    }
    return 0.0;
}

// Rust: `PatchNdf::is_smooth`.
fn lobe_patch_ndf_is_smooth(lobe: LobePatchNdf) -> bool {
    return lobe_cells_are_smooth(lobe.cells, lobe.dictionary.levels);
}

// WGSL only: of `PatchNdf::slope_pdf`, what `Cells::mean` does there on one level.
fn lobe_patch_ndf_level(lobe: LobePatchNdf, terms: LobePatchTerms, step: i32) -> f32 {
    var sum = 0.0;
    var whole = 0.0;
    for (
        var walk = lobe_cells_first(lobe.cells, step);
        lobe_cells_more(walk);
        walk = lobe_cells_next(walk)
    ) {
        let weight = lobe_cells_weight(walk);
        if weight > 0.0 {
            let cell = lobe_cells_cell(lobe.cells, step, walk);
            let facets = lobe_cells_numbers(lobe.cells, lobe.dictionary, cell, step);
            sum = sum + weight * lobe_patch_ndf_cell(lobe, terms, facets);
            whole = whole + weight;
        }
    }
    return sum / lobe_max(whole, LOBE_MIN_POSITIVE);
}

// WGSL only: of `PatchNdf::slope_pdf`, which has it as a closure: one cell's density.
fn lobe_patch_ndf_cell(lobe: LobePatchNdf, terms: LobePatchTerms, facets: LobeFacets) -> f32 {
    if facets.level < 0 {
        return terms.tended;
    }
    return lobe_plane_density(terms.plane, lobe.dictionary, terms.at, facets);
}
