// GGX over a parallelogram. Rust: src/filter/polygon/tree.rs. For any shape: others become a `LobeAnisotropic` by their roughness.

// Rust: `COARSE`.
const LOBE_POLYGON_COARSE: f32 = 0.0025000000000000005;
// Rust: `FINE`.
const LOBE_POLYGON_FINE: f32 = 0.25;
// Rust: `SHARP`.
const LOBE_POLYGON_SHARP: f32 = 2.5600000000000005;

// Rust: `tensor`, of the rule of two.
fn lobe_polygon_tensor_of_two(w: LobeWhitened) -> f32 {
    var mean = 0.0;
    for (var k = 0u; k < 2u; k++) {
        let j = select(LOBE_GAUSS_TWO.y, LOBE_GAUSS_TWO.x, k == 0u);
        let x = w.midpoint.x + j * w.v.x;
        let y = w.midpoint.y + j * w.v.y;
        let first = lobe_segment_unit_density(x + LOBE_GAUSS_TWO.x * w.u.x, y + LOBE_GAUSS_TWO.x * w.u.y);
        let second = lobe_segment_unit_density(x + LOBE_GAUSS_TWO.y * w.u.x, y + LOBE_GAUSS_TWO.y * w.u.y);
        mean = mean + 0.5 * (0.5 * first + 0.5 * second);
    }
    return mean;
}

// Rust: `tensor`, of the rule of four.
fn lobe_polygon_tensor_of_four(w: LobeWhitened) -> f32 {
    var values = vec4f(0.0, 0.0, 0.0, 0.0);
    for (var k = 0u; k < 4u; k++) {
        let j = lobe_gauss_point(4u, k).x;
        let x = w.midpoint.x + j * w.v.x + LOBE_GAUSS_FOUR * w.u.x;
        let y = w.midpoint.y + j * w.v.y + LOBE_GAUSS_FOUR * w.u.y;
        values[k] = lobe_gauss_mean(vec4f(
            lobe_segment_unit_density(x.x, y.x), lobe_segment_unit_density(x.y, y.y),
            lobe_segment_unit_density(x.z, y.z), lobe_segment_unit_density(x.w, y.w)
        ));
    }
    return lobe_gauss_mean(values);
}

// Rust: `general_mean`.
fn lobe_polygon_general_mean(frame: LobeFrame) -> f32 {
    let long = frame.extent * frame.extent > 64.0 * frame.nearness;
    let thickness_squared = lobe_thin_thickness_squared(frame);
    if thickness_squared <= LOBE_POLYGON_FINE {
        return lobe_thin_mean(frame, 4u);
    }
    if long && thickness_squared <= LOBE_POLYGON_SHARP {
        return lobe_thin_mean(frame, 8u);
    }
    return lobe_edges_mass(frame) / (frame.extent * frame.height);
}

// Rust: `Ndf::parallelogram_mean`. 0 for a slope that is infinite or NaN; sides of NaN count as huge.
fn lobe_ggx_parallelogram_mean(shape: LobeNonCentered, slope: vec2f, footprint: LobeFootprint) -> f32 {
    let sides = lobe_footprint_bounded(footprint);
    let offset = lobe_polygon_offset_of(shape, slope, vec2f(0.0, 0.0));
    let whitened = lobe_whitened_new(shape.shape, offset.xy, offset.zw, sides);
    let side_squared = lobe_max(lobe_strip_dot(whitened.u, whitened.u), lobe_strip_dot(whitened.v, whitened.v));
    var mean = 0.0;
    if lobe_groove_is_unresolved(shape.shape, side_squared, sides) {
        mean = lobe_groove_covered(shape.shape, offset, sides).mean;
    } else {
        mean = lobe_polygon_mean_of(shape.shape, whitened, offset, sides);
    }
    return select(0.0, lobe_defined(mean), lobe_is_finite(slope.x) && lobe_is_finite(slope.y));
}

// Rust: `Ndf::mean_of`.
fn lobe_polygon_mean_of(shape: LobeAnisotropic, w: LobeWhitened, offset: vec4f, footprint: LobeFootprint) -> f32 {
    return lobe_polygon_unit_mean(shape, w, offset, footprint) / shape.root_det;
}

// WGSL only: of `Ndf::mean_of`, the mean of the unit lobe.
fn lobe_polygon_unit_mean(shape: LobeAnisotropic, w: LobeWhitened, offset: vec4f, footprint: LobeFootprint) -> f32 {
    let center_squared = lobe_strip_dot(w.midpoint, w.midpoint);
    let side_squared = lobe_max(lobe_strip_dot(w.u, w.u), lobe_strip_dot(w.v, w.v));
    let nearness = 1.0 + 0.4444444444444444 * center_squared;
    if side_squared <= LOBE_POLYGON_COARSE * nearness {
        return lobe_polygon_tensor_of_two(w);
    }
    if side_squared <= LOBE_POLYGON_FINE * nearness {
        return lobe_polygon_tensor_of_four(w);
    }
    if lobe_edges_serves_plain_corners(side_squared) {
        let around = lobe_edges_around_the_lobe(w, center_squared, side_squared, footprint, shape.root_det);
        if around >= 0.0 {
            return around;
        }
    }
    var strip = lobe_strip_new(w);
    let keeps_digits = lobe_strip_keeps_digits(strip);
    var narrow = lobe_strip_is_narrow(strip);
    if narrow && !keeps_digits {
        // What looks narrow from afar may not be.
        strip = lobe_strip_sharpened(strip, w, shape, offset.xy, offset.zw, footprint);
        narrow = lobe_strip_is_narrow(strip);
    }
    if narrow {
        return lobe_strip_mean(strip);
    }
    if keeps_digits {
        return lobe_polygon_general_mean(lobe_frame_plain(w, shape));
    }
    return lobe_polygon_general_mean(lobe_frame_new(true, w, shape, offset.xy, offset.zw, footprint));
}

// Rust: `Ndf::offset_of`: high parts, then low ones.
fn lobe_polygon_offset_of(shape: LobeNonCentered, slope: vec2f, slope_low: vec2f) -> vec4f {
    let offset = lobe_non_centered_offset(shape, slope);
    let x = lobe_two_sum(offset.x, offset.z + slope_low.x);
    let y = lobe_two_sum(offset.y, offset.w + slope_low.y);
    return vec4f(x.x, y.x, x.y, y.y);
}

// Rust: `Ndf::rectangle_mean`. 0 for a slope that is infinite or NaN; a width of NaN counts as 0.
fn lobe_ggx_rectangle_mean(shape: LobeNonCentered, slope: vec2f, widths: vec2f) -> f32 {
    return lobe_ggx_parallelogram_mean(shape, slope, lobe_footprint_rectangle(widths));
}

// WGSL only: Rust has it as a closure.
fn lobe_polygon_slope(g: vec2f, z: vec2f) -> vec2f {
    let slope = lobe_kept(-g.x / z.x);
    let product = lobe_two_product(slope, z.x);
    return vec2f(slope, (-lobe_kept(g.x + product.x) - product.y - g.y - slope * z.y) / z.x);
}

// Rust: `Ndf::brdf_over`. Sides of NaN count as huge.
fn lobe_ggx_brdf_over(shape: LobeNonCentered, wo: vec3f, wi: vec3f, footprint: LobeFootprint) -> f32 {
    let brdf = lobe_ggx_brdf(lobe_non_centered_pair(shape, wo, wi));
    let z = lobe_two_sum(wo.z, wi.z);
    let x = lobe_polygon_slope(lobe_two_sum(wo.x, wi.x), z);
    let y = lobe_polygon_slope(lobe_two_sum(wo.y, wi.y), z);
    let slope = vec2f(x.x, y.x);
    let form = lobe_non_centered_form(shape, vec3f(-x.x, -y.x, 1.0), vec3f(-x.y, -y.y, 0.0));
    let root_det = shape.shape.root_det;
    let at_point = lobe_ggx_density(form, root_det, 1.0, 1.0, 1.0);
    let sides = lobe_footprint_bounded(footprint);
    let offset = lobe_polygon_offset_of(shape, slope, vec2f(x.y, y.y));
    let whitened = lobe_whitened_new(shape.shape, offset.xy, offset.zw, sides);
    let side_squared = lobe_max(lobe_strip_dot(whitened.u, whitened.u), lobe_strip_dot(whitened.v, whitened.v));
    let unresolved = lobe_groove_is_unresolved(shape.shape, side_squared, sides);
    var mean = 0.0;
    if !unresolved {
        mean = lobe_polygon_mean_of(shape.shape, whitened, offset, sides);
    }
    let faint = !(at_point >= LOBE_MIN_POSITIVE) || mean * LOBE_PI > LOBE_GROOVE_LARGEST_GAIN * at_point;
    let parallel = lobe_secant_is_parallel(whitened);
    // Rust asks for the groove in three places. Here they share one call: each call is code of its own in a shader.
    var covered = LobeGrooveCovered(mean, vec2f(0.0, 0.0));
    var first = LobeSecantFirst(parallel, false, vec2f(0.0, 0.0), 0.0);
    if unresolved || faint || parallel {
        let major = lobe_anisotropic_major(shape.shape);
        let alpha = major.z;
        let reach = select(lobe_min(alpha, lobe_groove_reach_across(major.xy, sides)), alpha, faint);
        let brushed = alpha * reach >= LOBE_GROOVE_BRUSHED * root_det;
        if unresolved || brushed {
            covered = lobe_groove_covered(shape.shape, offset, sides);
            let x = lobe_kept(covered.place.x / alpha);
            let y = lobe_kept(covered.place.y / alpha);
            first = LobeSecantFirst(parallel, true, lobe_polygon_at_place(shape, covered.place), x * x + y * y);
        }
    }
    if unresolved || faint {
        // The density at the half vector says nothing about the mean: a footprint that reaches the lobe has one.
        covered.mean = select(select(0.0, mean, covered.mean > 0.0), covered.mean, unresolved);
        var over = 0.0;
        if z.x > 0.0 && covered.mean > 0.0 {
            over = lobe_polygon_groove_over(shape, wo, wi, covered);
        }
        return select(lobe_max(over, brdf), over, unresolved);
    }
    let ratio = sqrt(mean * LOBE_PI / at_point);
    let factor = ratio * lobe_secant_ratio(slope, form / root_det, ratio, sides, whitened, first);
    return lobe_below_infinity(lobe_max(lobe_defined(lobe_kept(brdf * factor) * factor), 0.0));
}

// Rust: `Ndf::groove_over`. 0 for NaN.
fn lobe_polygon_groove_over(shape: LobeNonCentered, wo: vec3f, wi: vec3f, covered: LobeGrooveCovered) -> f32 {
    let s = lobe_polygon_at_place(shape, covered.place);
    let secant_squared = 1.0 + s.x * s.x + s.y * s.y;
    let visibility = lobe_ggx_visibility(lobe_non_centered_view(shape, wo), lobe_non_centered_view(shape, wi));
    let filtered = lobe_kept(lobe_kept(covered.mean * visibility) * secant_squared) * secant_squared;
    return lobe_below_infinity(lobe_max(lobe_defined(filtered), 0.0));
}

// Rust: `Ndf::at_place`.
fn lobe_polygon_at_place(shape: LobeNonCentered, place: vec2f) -> vec2f {
    let origin = lobe_non_centered_offset(shape, vec2f(0.0, 0.0));
    return vec2f(place.x - origin.x, place.y - origin.y);
}
