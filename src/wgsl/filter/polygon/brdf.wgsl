// The BRDF over a footprint: the mean density, at the height of the normals that it comes from.
// Rust: src/filter/polygon/brdf.rs.

// WGSL only: Rust has it as a closure.
fn lobe_polygon_slope(g: vec2f, z: vec2f) -> vec2f {
    let slope = lobe_kept(-g.x / z.x);
    let product = lobe_two_product(slope, z.x);
    return vec2f(slope, (-lobe_kept(g.x + product.x) - product.y - g.y - slope * z.y) / z.x);
}

// Rust: `Ndf::brdf_over`. Sides of NaN count as huge.
fn lobe_ggx_brdf_over(
    shape: LobeNonCentered, wo: vec3f, wi: vec3f, footprint: LobeFootprint
) -> f32 {
    let brdf = lobe_ggx_brdf(lobe_non_centered_pair(shape, wo, wi));
    let z = lobe_two_sum(wo.z, wi.z);
    let x = lobe_polygon_slope(lobe_two_sum(wo.x, wi.x), z);
    let y = lobe_polygon_slope(lobe_two_sum(wo.y, wi.y), z);
    let slope = vec2f(x.x, y.x);
    let sides = lobe_footprint_bounded(footprint);
    let offset = lobe_polygon_offset_of(shape, slope, vec2f(x.y, y.y));
    let whitened = lobe_whitened_new(shape.shape, offset.xy, offset.zw, sides);
    let side_squared = lobe_max(
        lobe_strip_dot(whitened.u, whitened.u), lobe_strip_dot(whitened.v, whitened.v)
    );
    let unresolved = lobe_groove_is_unresolved(shape.shape, side_squared, sides);
    var mean = 0.0;
    if !unresolved {
        mean = lobe_polygon_mean_of(shape.shape, whitened, offset, sides);
    }
    let q = lobe_strip_dot(whitened.midpoint, whitened.midpoint);
    let root_det = shape.shape.root_det;
    let at_point = 1.0 / (root_det * (1.0 + q) * (1.0 + q));
    let faint = !(at_point >= LOBE_MIN_POSITIVE)
        || mean * LOBE_PI > LOBE_GROOVE_LARGEST_GAIN * at_point;
    let parallel = lobe_secant_is_parallel(whitened);
    // Rust asks for the groove in three places. Here they share one call: each call is code of its
    // own in a shader.
    var covered = LobeGrooveCovered(mean, vec2f(0.0, 0.0));
    var first = LobeSecantFirst(parallel, false, vec2f(0.0, 0.0), 0.0);
    if unresolved || faint || parallel {
        let major = lobe_anisotropic_major(shape.shape);
        let alpha = major.z;
        let reach = select(
            lobe_min(alpha, lobe_groove_reach_across(major.xy, sides)), alpha, faint
        );
        let brushed = alpha * reach >= LOBE_GROOVE_BRUSHED * root_det;
        if unresolved || brushed {
            covered = lobe_groove_covered(shape.shape, offset, sides);
            let x = lobe_kept(covered.place.x / alpha);
            let y = lobe_kept(covered.place.y / alpha);
            first = LobeSecantFirst(
                parallel, true, lobe_polygon_at_place(shape, covered.place), x * x + y * y
            );
        }
    }
    if unresolved || faint {
        // The density at the half vector says nothing about the mean: a footprint that reaches the
        // lobe has one.
        covered.mean = select(select(0.0, mean, covered.mean > 0.0), covered.mean, unresolved);
        var over = 0.0;
        if z.x > 0.0 && covered.mean > 0.0 {
            over = lobe_polygon_groove_over(shape, wo, wi, covered);
        }
        return select(lobe_max(over, brdf), over, unresolved);
    }
    if !(z.x > 0.0) {
        return 0.0;
    }
    let ratio = sqrt(mean * LOBE_PI / at_point);
    let secant = lobe_secant_ratio(slope, q, ratio, sides, whitened, first);
    let secant_squared = (1.0 + x.x * x.x + y.x * y.x) * secant;
    return lobe_polygon_shaded(
        mean, lobe_polygon_visibility(shape, wo, wi), secant_squared
    );
}

// WGSL only: of `Ndf::brdf_over`.
fn lobe_polygon_visibility(shape: LobeNonCentered, wo: vec3f, wi: vec3f) -> f32 {
    return lobe_ggx_visibility(
        lobe_non_centered_view(shape, wo), lobe_non_centered_view(shape, wi)
    );
}

// Rust: `Ndf::groove_over`. 0 for NaN.
fn lobe_polygon_groove_over(
    shape: LobeNonCentered, wo: vec3f, wi: vec3f, covered: LobeGrooveCovered
) -> f32 {
    let s = lobe_polygon_at_place(shape, covered.place);
    return lobe_polygon_shaded(
        covered.mean, lobe_polygon_visibility(shape, wo, wi), 1.0 + s.x * s.x + s.y * s.y
    );
}

// Rust: `Ndf::at_place`.
fn lobe_polygon_at_place(shape: LobeNonCentered, place: vec2f) -> vec2f {
    let origin = lobe_non_centered_offset(shape, vec2f(0.0, 0.0));
    return vec2f(place.x - origin.x, place.y - origin.y);
}

// Rust: `shaded`. 0 for NaN.
fn lobe_polygon_shaded(mean: f32, visibility: f32, secant_squared: f32) -> f32 {
    let filtered = lobe_kept(lobe_kept(mean * visibility) * secant_squared) * secant_squared;
    return lobe_below_infinity(lobe_max(lobe_defined(filtered), 0.0));
}
