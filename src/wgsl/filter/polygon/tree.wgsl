// GGX over a parallelogram. Rust: src/filter/polygon/tree.rs. For any shape: others become a
// `LobeAnisotropic` by their roughness.

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
        let first = lobe_segment_unit_density(
            x + LOBE_GAUSS_TWO.x * w.u.x, y + LOBE_GAUSS_TWO.x * w.u.y
        );
        let second = lobe_segment_unit_density(
            x + LOBE_GAUSS_TWO.y * w.u.x, y + LOBE_GAUSS_TWO.y * w.u.y
        );
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

// Rust: `Ndf::parallelogram_mean`. 0 for a slope that is infinite or NaN; sides of NaN count as
// huge.
fn lobe_ggx_parallelogram_mean(
    shape: LobeNonCentered, slope: vec2f, footprint: LobeFootprint
) -> f32 {
    let sides = lobe_footprint_bounded(footprint);
    let offset = lobe_polygon_offset_of(shape, slope, vec2f(0.0, 0.0));
    let whitened = lobe_whitened_new(shape.shape, offset.xy, offset.zw, sides);
    let side_squared = lobe_max(
        lobe_strip_dot(whitened.u, whitened.u), lobe_strip_dot(whitened.v, whitened.v)
    );
    var mean = 0.0;
    if lobe_groove_is_unresolved(shape.shape, side_squared, sides) {
        mean = lobe_groove_covered(shape.shape, offset, sides).mean;
    } else {
        mean = lobe_polygon_mean_of(shape.shape, whitened, offset, sides);
    }
    return select(0.0, lobe_defined(mean), lobe_is_finite(slope.x) && lobe_is_finite(slope.y));
}

// Rust: `Ndf::mean_of`.
fn lobe_polygon_mean_of(
    shape: LobeAnisotropic, w: LobeWhitened, offset: vec4f, footprint: LobeFootprint
) -> f32 {
    return lobe_polygon_unit_mean(shape, w, offset, footprint) / shape.root_det;
}

// WGSL only: of `Ndf::mean_of`, the mean of the unit lobe.
fn lobe_polygon_unit_mean(
    shape: LobeAnisotropic, w: LobeWhitened, offset: vec4f, footprint: LobeFootprint
) -> f32 {
    let midpoint_squared = lobe_strip_dot(w.midpoint, w.midpoint);
    let side_squared = lobe_max(lobe_strip_dot(w.u, w.u), lobe_strip_dot(w.v, w.v));
    let nearness = 1.0 + 0.4444444444444444 * midpoint_squared;
    if side_squared <= LOBE_POLYGON_COARSE * nearness {
        return lobe_polygon_tensor_of_two(w);
    }
    if side_squared <= LOBE_POLYGON_FINE * nearness {
        return lobe_polygon_tensor_of_four(w);
    }
    if lobe_edges_serves_plain_corners(side_squared) {
        let around = lobe_edges_around_the_lobe(
            w, midpoint_squared, side_squared, footprint, shape.root_det
        );
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
    return lobe_polygon_general_mean(
        lobe_frame_new(true, w, shape, offset.xy, offset.zw, footprint)
    );
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
