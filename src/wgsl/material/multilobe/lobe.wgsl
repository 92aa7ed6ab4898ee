// What a pixel sees of many facets: a density of slopes that integrates to 1. Rust: src/material/multilobe/lobe.rs.

// Rust: `QUANTILE`.
const LOBE_PATCH_LOBE_QUANTILE: f32 = 6.5;

// Rust: `PatchLobe`, without mips.
struct LobePatchLobe {
    dictionary: LobeDictionary,
    roughness: LobeRoughness,
    spread: LobeKernel,
    ellipse: LobeEllipse,
    exponent: i32,
    coarser: f32,
    facets: f32,
    variation: f32,
    share: f32,
    seed: u32,
}

// WGSL only: what all cells share under one slope, captures of `PatchLobe::slope_pdf` in Rust.
struct LobePatchTerms {
    plane: LobePlane,
    at: vec2f,
    smoothed: f32,
}

// Rust: `PatchLobe::over`.
fn lobe_patch_lobe_over(lobe: LobePatchLobe, moments: LobeSlopeMoments) -> LobePatchLobe {
    var over = lobe;
    let seen = lobe_mean_frame_moments(lobe_mean_frame_of(moments.mean), moments);
    over.roughness = lobe_roughness_plus(lobe.roughness, lobe_roughness_from_covariance(seen.covariance));
    return over;
}

// Rust: `PatchLobe::widened`.
fn lobe_patch_lobe_widened(lobe: LobePatchLobe, kernel: LobeKernel) -> LobePatchLobe {
    var widened = lobe;
    widened.spread = lobe_kernel_then(lobe.spread, kernel);
    return widened;
}

// Rust: `PatchLobe::smooth`.
fn lobe_patch_lobe_smooth(lobe: LobePatchLobe) -> LobeFull {
    return lobe_full_new(lobe_roughness_widened(lobe.roughness, lobe.spread));
}

// Rust: `PatchLobe::slope_pdf`. 0 for NaN.
fn lobe_patch_lobe_slope_pdf(lobe: LobePatchLobe, slope: vec2f) -> f32 {
    let shape = lobe_patch_lobe_smooth(lobe);
    let smoothed = lobe_beckmann_slope_pdf(lobe_full_normal(shape, vec3f(-slope.x, -slope.y, 1.0)));
    if lobe_patch_lobe_is_smooth(lobe) {
        return smoothed;
    }
    let plane = lobe_plane_new(lobe.roughness, lobe.spread);
    let at = lobe_plane_point(plane, slope);
    let terms = LobePatchTerms(lobe_plane_around(plane, at), at, smoothed);
    var mean = 0.0;
    for (var step = 0; step < 2; step++) {
        let share = select(1.0 - lobe.coarser, lobe.coarser, step == 1);
        if share > 0.0 {
            mean = mean + share * lobe_patch_lobe_level(lobe, terms, step);
        }
    }
    return lobe_min(lobe_max(mean, 0.0), LOBE_MAX);
}

// Rust: `PatchLobe::d`. 0 for NaN.
fn lobe_patch_lobe_d(lobe: LobePatchLobe, m: vec3f) -> f32 {
    if !(m.z > 0.0) {
        return 0.0;
    }
    let square = m.z * m.z;
    // Not `lobe_slope_of`, which has 0 for NaN.
    let density = lobe_patch_lobe_slope_pdf(lobe, vec2f(-m.x / m.z, -m.y / m.z));
    return lobe_min(lobe_defined(density / (square * square)), LOBE_MAX);
}

// Rust: `PatchLobe::brdf`. 0 for NaN.
fn lobe_patch_lobe_brdf(lobe: LobePatchLobe, wo: vec3f, wi: vec3f) -> f32 {
    let h = lobe_half_vector(wo, wi);
    let masking = lobe_cavity_masking_shadowing(wo, wi, h);
    if masking > 0.0 {
        let weight = masking / (4.0 * wo.z * wi.z);
        return lobe_min(lobe_defined(lobe_patch_lobe_d(lobe, h) * weight), LOBE_MAX);
    }
    return 0.0;
}

// Rust: `PatchLobe::is_smooth`.
fn lobe_patch_lobe_is_smooth(lobe: LobePatchLobe) -> bool {
    return lobe.facets - LOBE_PATCH_LOBE_QUANTILE * lobe.variation > f32(lobe.dictionary.levels);
}

// Rust: `PatchLobe::cells`, and what `PatchLobe::slope_pdf` makes of them: the mean over a level.
fn lobe_patch_lobe_level(lobe: LobePatchLobe, terms: LobePatchTerms, step: i32) -> f32 {
    let exponent = lobe.exponent + step;
    let rows = lobe_ellipse_rows(lobe.ellipse, exponent);
    var sum = 0.0;
    var whole = 0.0;
    for (var j = 0; j < LOBE_ELLIPSE_ROWS; j++) {
        let t = rows.first + j;
        if t > rows.last {
            break;
        }
        let row = lobe_ellipse_row(rows, t);
        for (var i = 0; i < LOBE_ELLIPSE_ROWS; i++) {
            let s = row.first + i;
            if s > row.last {
                break;
            }
            let weight = lobe_ellipse_weight(row, s);
            if weight > 0.0 {
                let cell = lobe_cell_at(vec2i(s, t), exponent, lobe.seed);
                sum = sum + weight * lobe_patch_lobe_cell(lobe, terms, lobe_patch_lobe_numbers(lobe, cell, step));
                whole = whole + weight;
            }
        }
    }
    return sum / whole;
}

// WGSL only: of `PatchLobe::slope_pdf`, which has it as a closure: one cell's density.
fn lobe_patch_lobe_cell(lobe: LobePatchLobe, terms: LobePatchTerms, facets: LobeFacets) -> f32 {
    if facets.level < 0 {
        return terms.smoothed;
    }
    return lobe_plane_density(terms.plane, lobe.dictionary, terms.at, facets);
}

// Rust: `PatchLobe::numbers`.
fn lobe_patch_lobe_numbers(lobe: LobePatchLobe, cell: LobeCell, step: i32) -> LobeFacets {
    let words = cell.words;
    let deviation = lobe.variation * lobe_normal_quantile(lobe_hash_tail(words.y));
    let rounding = f32(words.z & 0xffu) * 0.00390625;
    let drawn = lobe_floor(lobe.facets + f32(step) + deviation + rounding);
    let level = select(0, drawn, drawn > 0);
    if level >= i32(lobe.dictionary.levels) || lobe_hash_tail(words.x) > lobe.share {
        return LobeFacets(-1, vec2f(0.0, 0.0), vec2u(0u, 0u));
    }
    let first = ((words.w >> 16u) * lobe.dictionary.marginals) >> 16u;
    let second = ((words.w & 0xffffu) * lobe.dictionary.marginals) >> 16u;
    return LobeFacets(level, lobe_plane_quarter_turn(words.z), vec2u(first, second));
}
