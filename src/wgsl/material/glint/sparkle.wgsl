// How much brighter than its smooth lobe a glittering pixel is: what its cells draw. Rust:
// src/material/glint/sparkle.rs.

// Rust: `LEAST`.
const LOBE_GLINT_LEAST: f32 = 1e-30;
// WGSL only: the side of an angular bin, the root of pi.
const LOBE_GLINT_SIDE: f32 = 1.7724539;

// Rust: `Reflection`.
struct LobeReflection {
    probability: f32,
    bin: vec2f,
}

// WGSL only: what all cells of a level share under one half vector, captures of `GlintNdf::mixed`
// in Rust.
struct LobeGlintDraws {
    reflection: LobeReflection,
    number: f32,
    draw: LobeBinomial,
    variation: f32,
    progress: f32,
    coarser: bool,
    seed: u32,
}

// WGSL only: a cell, its share of the pixel and its part of the sparkle, and the count of its
// reflecting details.
struct LobeGlintPart {
    cell: LobeCell,
    share: f32,
    part: f32,
    count: f32,
}

// Rust: `GlintNdf::probability`. 0 at the horizon and below, and for NaN.
fn lobe_glint_ndf_probability(lobe: LobeGlintNdf, h: vec3f, blur: f32) -> f32 {
    if !(h.z > 0.0) {
        return 0.0;
    }
    return lobe_glint_ndf_reflection(lobe, h, lobe_glint_ndf_blurred(lobe, blur)).probability;
}

// Rust: `GlintNdf::sparkle`.
fn lobe_glint_ndf_sparkle(lobe: LobeGlintNdf, h: vec3f, blur: f32) -> f32 {
    return lobe_glint_ndf_mixed(lobe, h, blur, false).x;
}

// Rust: `GlintNdf::colored_sparkle`, with the hue wheel.
fn lobe_glint_ndf_colored_sparkle(lobe: LobeGlintNdf, h: vec3f, blur: f32) -> vec3f {
    return lobe_glint_ndf_mixed(lobe, h, blur, true);
}

// Rust: `GlintNdf::slope_pdf`. 0 for NaN.
fn lobe_glint_ndf_slope_pdf(lobe: LobeGlintNdf, h: vec3f, blur: f32) -> f32 {
    if !(h.z > 0.0) {
        return 0.0;
    }
    // Not `lobe_slope_of`, which has 0 for NaN.
    let at = lobe_non_centered_normal(
        lobe_lobe_shape(lobe_glint_ndf_smooth_lobe(lobe)), vec3f(h.x / h.z, h.y / h.z, 1.0)
    );
    return lobe_below_infinity(
        lobe_defined(lobe_beckmann_slope_pdf(at) * lobe_glint_ndf_sparkle(lobe, h, blur))
    );
}

// Rust: `GlintNdf::brdf`. 0 for NaN.
fn lobe_glint_ndf_brdf(lobe: LobeGlintNdf, wo: vec3f, wi: vec3f, radius: f32) -> f32 {
    let brdf = lobe_beckmann_brdf(
        lobe_non_centered_pair(lobe_lobe_shape(lobe_glint_ndf_smooth_lobe(lobe)), wo, wi)
    );
    if !(brdf > 0.0) {
        return 0.0;
    }
    let sparkle = lobe_glint_ndf_sparkle(
        lobe, lobe_half_vector(wo, wi), lobe_light_blur(wo, wi, radius)
    );
    return lobe_below_infinity(lobe_defined(brdf * sparkle));
}

// Rust: `GlintNdf::blurred`.
fn lobe_glint_ndf_blurred(lobe: LobeGlintNdf, blur: f32) -> LobePsd {
    let added = lobe_magnitude(blur);
    let round = lobe_psd_with_root_det(vec3f(added, 0.0, added), added);
    return lobe_psd_add(lobe.biscale.local.psd, round);
}

// Rust: `GlintNdf::reflection`.
fn lobe_glint_ndf_reflection(lobe: LobeGlintNdf, h: vec3f, local: LobePsd) -> LobeReflection {
    let global = lobe_psd_entries(lobe.global.psd);
    let own = lobe_psd_entries(local);
    if lobe.groove == LOBE_GROOVE_ALONG_V {
        let across = lobe_glint_ndf_across(h.x / h.z, lobe.mean.x, own.x, global.x);
        return LobeReflection(across.x, vec2f(across.y, 0.0));
    }
    if lobe.groove == LOBE_GROOVE_ALONG_U {
        let across = lobe_glint_ndf_across(h.y / h.z, lobe.mean.y, own.z, global.z);
        return LobeReflection(across.x, vec2f(0.0, across.y));
    }
    let shape = lobe_lobe_shape(lobe_glint_ndf_smooth_lobe(lobe));
    let form = lobe_non_centered_form(shape, h);
    // Mirrors have nothing to divide by.
    let unit = lobe_anisotropic_extent(shape.shape).unit;
    let exponent = form / lobe_max(unit * h.z * h.z, LOBE_MIN_POSITIVE);
    let least = lobe_max(lobe_psd_root_det(lobe.global.psd), LOBE_MIN_POSITIVE);
    let peaks = lobe_min(lobe_psd_root_det(local) / least, 1.0);
    let per_bin = 2.0 / ((1.0 + h.z) * LOBE_GLINT_SIDE);
    let x = h.x * per_bin / lobe_max(local.l_xx, LOBE_MIN_POSITIVE);
    let y = (h.y * per_bin - local.l_yx * x) / lobe_max(local.l_yy, LOBE_MIN_POSITIVE);
    return LobeReflection(lobe_defined(peaks * lobe_exp(-exponent)), vec2f(x, y));
}

// Rust: `GlintNdf::across`: the probability, and the bin across.
fn lobe_glint_ndf_across(slope: f32, mean: f32, local: f32, global: f32) -> vec2f {
    let offset = slope + mean;
    let square = lobe_max(global, LOBE_MIN_POSITIVE);
    let peaks = sqrt(lobe_min(local / square, 1.0));
    let probability = lobe_defined(peaks * lobe_exp(-(offset * offset / square)));
    return vec2f(probability, slope / lobe_max(LOBE_GLINT_SIDE * sqrt(local), LOBE_MIN_POSITIVE));
}

// Rust: `GlintNdf::mixed`, and what its two callers make of the cells: white, or in colors.
fn lobe_glint_ndf_mixed(lobe: LobeGlintNdf, h: vec3f, blur: f32, colored: bool) -> vec3f {
    if !(h.z > 0.0) {
        return vec3f(0.0, 0.0, 0.0);
    }
    let reflection = lobe_glint_ndf_reflection(lobe, h, lobe_glint_ndf_blurred(lobe, blur));
    if !(reflection.probability >= LOBE_GLINT_LEAST) {
        return vec3f(1.0, 1.0, 1.0);
    }
    var shares = 0.0;
    var sum = vec3f(0.0, 0.0, 0.0);
    for (var k = 0u; k < 2u; k++) {
        let level = lobe_grid_level(lobe.grid, k == 1u);
        let draws = lobe_glint_ndf_draws(lobe, reflection, k == 1u);
        for (var n = 0u; n < LOBE_LEVEL_COLUMNS; n++) {
            if n >= level.count {
                break;
            }
            let column = lobe_level_column(level, n);
            for (var row = 0; row < 2; row++) {
                let covered = lobe_level_covered(level, column, n, row);
                if !(covered.share > 0.0) {
                    continue;
                }
                let cell = lobe_glint_ndf_cell(draws, covered);
                var tint = vec3f(1.0, 1.0, 1.0);
                if colored {
                    tint = lobe_color_tint(lobe_hue_wheel(lobe_cell_hue(cell.cell)), cell.count);
                }
                shares = shares + cell.share;
                sum = sum + tint * cell.part;
            }
        }
    }
    let whole = lobe_max(shares, LOBE_MIN_POSITIVE);
    return vec3f(
        lobe_glint_ndf_shared(lobe, sum.x / whole), lobe_glint_ndf_shared(lobe, sum.y / whole),
        lobe_glint_ndf_shared(lobe, sum.z / whole)
    );
}

// WGSL only: of `GlintNdf::mixed`: the draws of the finer level's cells, or of the coarser one's.
fn lobe_glint_ndf_draws(
    lobe: LobeGlintNdf, reflection: LobeReflection, coarser: bool
) -> LobeGlintDraws {
    let number = lobe_glint_ndf_number(lobe, coarser);
    let draw = lobe_binomial_new(number, reflection.probability);
    return LobeGlintDraws(
        reflection, number, draw, lobe.variation, lobe.grid.coarser, coarser, lobe.grid.seed
    );
}

// WGSL only: of `GlintNdf::mixed`, which has it as a closure: all that is done for one cell.
fn lobe_glint_ndf_cell(draws: LobeGlintDraws, covered: LobeCoveredCell) -> LobeGlintPart {
    let cell = lobe_cell_at_wide(covered.index, covered.exponent, draws.seed);
    let share = covered.share * lobe_grid_presence(draws.progress, cell, draws.coarser);
    if !(share > 0.0) {
        return LobeGlintPart(cell, 0.0, 0.0, 0.0);
    }
    let varied = lobe_glint_ndf_varied(draws, cell);
    let jitter = lobe_cell_jitter(cell);
    let bin = vec2i(
        lobe_floor(draws.reflection.bin.x + jitter.x), lobe_floor(draws.reflection.bin.y + jitter.y)
    );
    let count = lobe_binomial_draw(varied.draw, lobe_cell_count(cell, bin));
    let part = share * (count / (varied.number * draws.reflection.probability));
    return LobeGlintPart(cell, share, part, count);
}

// WGSL only: the end of `GlintNdf::sparkle`, of the sum over the cells. 0 for NaN.
fn lobe_glint_ndf_shared(lobe: LobeGlintNdf, sum: f32) -> f32 {
    return lobe_defined(1.0 + lobe.share * (sum - 1.0));
}

// Rust: `GlintNdf::varied`: the draws of a cell.
fn lobe_glint_ndf_varied(draws: LobeGlintDraws, cell: LobeCell) -> LobeGlintDraws {
    var varied = draws;
    if draws.variation > 0.0 {
        let z = lobe_normal_quantile(lobe_cell_size(cell));
        varied.number = draws.number * lobe_exp(draws.variation * (z - 0.5 * draws.variation));
        varied.draw = lobe_binomial_new(varied.number, draws.reflection.probability);
    }
    varied.number = lobe_min(lobe_max(varied.number, 1.0), 1e18);
    return varied;
}

// Rust: `GlintNdf::numbers`, of one level.
fn lobe_glint_ndf_number(lobe: LobeGlintNdf, coarser: bool) -> f32 {
    let across = sqrt(lobe.density) * lobe_power_of_two(lobe.grid.exponent);
    if lobe.groove == LOBE_GROOVE_NONE {
        return select(1.0, 4.0, coarser) * (across * across);
    }
    return select(1.0, 2.0, coarser) * across;
}
