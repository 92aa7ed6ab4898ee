// The BRDF over a footprint in straight-line code. Rust: src/filter/polygon/height.rs.

// Rust: `JENSEN`.
const LOBE_HEIGHT_JENSEN: f32 = 0.02;

// Rust: `raised`, of any mean slope.
fn lobe_height_raised(
    halves: LobeHalves, shape: LobeNonCentered, offset: vec2f, sides_squared: f32, mean: f32
) -> f32 {
    let factor = shape.shape.factor;
    let trace = (factor.l_xx * factor.l_xx + factor.l_yx * factor.l_yx)
        + factor.l_yy * factor.l_yy;
    let sides = halves.aa + halves.bb;
    // Towards the lobe's center: whitened, and as a slope.
    let e = vec2f(
        halves.ca * halves.a.y + halves.cb * halves.b.y,
        -(halves.ca * halves.a.x + halves.cb * halves.b.x)
    );
    let es = vec2f(factor.l_xx * e.x, factor.l_yx * e.x + factor.l_yy * e.y);
    let m = sqrt(mean);
    let m_ab = m * halves.ab;
    let y = m * sides + m_ab * m_ab;
    let whole = 1.0 + y;
    let spread = 1.0 + LOBE_HEIGHT_JENSEN * y;
    let inverse = 1.0 / (whole * spread);
    let inverse_whole = spread * inverse;
    let less = (0.04 * y) * (whole * inverse);
    let place = (halves.c + m * e) * inverse_whole;
    let slope = shape.mean + (offset + m * es) * inverse_whole;
    let q = lobe_lanes_dot(place, place);
    let both = m_ab * halves.ab;
    let rate = (sides_squared + both * trace) / lobe_max(sides + (both + both), 1e-30);
    let f = rate * lobe_max(1.0 - m * (1.0 + q), 0.0)
        + m * (1.0 + lobe_lanes_dot(slope, slope));
    return f * f - (less * rate) * lobe_max(f - rate, 0.0);
}

// Rust: `Ndf::brdf_over_in_lanes`. 0 for NaN.
fn lobe_ggx_brdf_over_in_lanes(
    shape: LobeNonCentered, wo: vec3f, wi: vec3f, footprint: LobeFootprint
) -> f32 {
    let root_det = shape.shape.root_det;
    let inverse = lobe_lanes_inverse(root_det);
    let half = lobe_half_sum(wo, wi);
    let offset = lobe_non_centered_relative(shape, half)
        * (-1.0 / lobe_max(half.z, LOBE_MIN_POSITIVE));
    let halves = lobe_lanes_halves(shape.shape, offset, footprint, inverse);
    let sides_squared = 0.25 * (lobe_lanes_dot(footprint.u, footprint.u)
        + lobe_lanes_dot(footprint.v, footprint.v));
    let raised = lobe_height_raised(
        halves, shape, offset, sides_squared, lobe_halves_mean(halves)
    );
    let density = (LOBE_INVERSE_PI * inverse) * lobe_max(raised, 0.0);
    let visibility = lobe_ggx_visibility(
        lobe_non_centered_view(shape, wo), lobe_non_centered_view(shape, wi)
    );
    return lobe_lanes_limited(
        density * visibility, root_det >= LOBE_MIN_POSITIVE && half.z > 0.0
    );
}
