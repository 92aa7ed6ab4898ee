// The BRDF over a footprint in straight-line code. Rust: src/filter/polygon/height.rs.

// Rust: `JENSEN`.
const LOBE_HEIGHT_JENSEN: f32 = 0.02;

// Rust: `Meeting`.
struct LobeMeeting {
    offset: vec2f,
    mean_slope: vec2f,
    factor: LobePsd,
    sides_squared: f32,
}

// WGSL only: what a BRDF in lanes asks of a shape at a pair of directions and a footprint.
struct LobePairOver {
    slope: LobeSlopeOver,
    meeting: LobeMeeting,
    wo: LobeView,
    wi: LobeView,
    z: f32,
}

// WGSL only: of `Ndf::brdf_over_in_lanes`, the half vector's slope less the mean.
fn lobe_height_offset(relative: vec2f, z: f32) -> vec2f {
    return relative * (-1.0 / lobe_max(z, LOBE_MIN_POSITIVE));
}

// WGSL only: of `Ndf::brdf_over_in_lanes`.
fn lobe_height_meeting(
    offset: vec2f, mean_slope: vec2f, factor: LobePsd, footprint: LobeFootprint
) -> LobeMeeting {
    let sides_squared = 0.25 * (lobe_lanes_dot(footprint.u, footprint.u)
        + lobe_lanes_dot(footprint.v, footprint.v));
    return LobeMeeting(offset, mean_slope, factor, sides_squared);
}

// WGSL only: the answers of an isotropic shape at a pair of directions and a footprint.
fn lobe_isotropic_pair_over(
    shape: LobeIsotropic, wo: vec3f, wi: vec3f, footprint: LobeFootprint
) -> LobePairOver {
    let half = lobe_half_sum(wo, wi);
    let offset = lobe_height_offset(half.xy, half.z);
    let factor = LobePsd(shape.alpha, 0.0, shape.alpha);
    return LobePairOver(
        lobe_isotropic_slope_over(shape, offset, footprint),
        lobe_height_meeting(offset, vec2f(0.0), factor, footprint),
        lobe_isotropic_view(shape, wo), lobe_isotropic_view(shape, wi), half.z
    );
}

// WGSL only: the answers of an axis-aligned shape at a pair of directions and a footprint.
fn lobe_axis_aligned_pair_over(
    shape: LobeAxisAligned, wo: vec3f, wi: vec3f, footprint: LobeFootprint
) -> LobePairOver {
    let half = lobe_half_sum(wo, wi);
    let offset = lobe_height_offset(half.xy, half.z);
    let factor = LobePsd(shape.alphas.x, 0.0, shape.alphas.y);
    return LobePairOver(
        lobe_axis_aligned_slope_over(shape, offset, footprint),
        lobe_height_meeting(offset, vec2f(0.0), factor, footprint),
        lobe_axis_aligned_view(shape, wo), lobe_axis_aligned_view(shape, wi), half.z
    );
}

// WGSL only: the answers of an anisotropic shape at a pair of directions and a footprint.
fn lobe_anisotropic_pair_over(
    shape: LobeAnisotropic, wo: vec3f, wi: vec3f, footprint: LobeFootprint
) -> LobePairOver {
    let half = lobe_half_sum(wo, wi);
    let offset = lobe_height_offset(half.xy, half.z);
    return LobePairOver(
        lobe_anisotropic_slope_over(shape, offset, footprint),
        lobe_height_meeting(offset, vec2f(0.0), shape.factor, footprint),
        lobe_anisotropic_view(shape, wo), lobe_anisotropic_view(shape, wi), half.z
    );
}

// WGSL only: the answers of a shape with a mean at a pair of directions and a footprint.
fn lobe_non_centered_pair_over(
    shape: LobeNonCentered, wo: vec3f, wi: vec3f, footprint: LobeFootprint
) -> LobePairOver {
    let half = lobe_half_sum(wo, wi);
    let offset = lobe_height_offset(lobe_non_centered_relative(shape, half), half.z);
    return LobePairOver(
        lobe_anisotropic_slope_over(shape.shape, offset, footprint),
        lobe_height_meeting(offset, shape.mean, shape.shape.factor, footprint),
        lobe_non_centered_view(shape, wo), lobe_non_centered_view(shape, wi), half.z
    );
}

// Rust: `raised`, of any mean slope.
fn lobe_height_raised(halves: LobeHalves, at: LobeMeeting, mean: f32) -> f32 {
    let factor = at.factor;
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
    let slope = at.mean_slope + (at.offset + m * es) * inverse_whole;
    let q = lobe_lanes_dot(place, place);
    let both = m_ab * halves.ab;
    let rate = (at.sides_squared + both * trace) / lobe_max(sides + (both + both), 1e-30);
    let f = rate * lobe_max(1.0 - m * (1.0 + q), 0.0)
        + m * (1.0 + lobe_lanes_dot(slope, slope));
    return f * f - (less * rate) * lobe_max(f - rate, 0.0);
}

// Rust: `Ndf::brdf_over_in_lanes`, of a shape's answers at a pair of directions and a footprint. 0
// for NaN.
fn lobe_ggx_brdf_over_in_lanes(at: LobePairOver) -> f32 {
    let halves = at.slope.halves;
    let raised = lobe_height_raised(halves, at.meeting, lobe_halves_mean(halves));
    let density = (LOBE_INVERSE_PI * at.slope.inverse_root_det) * lobe_max(raised, 0.0);
    return lobe_lanes_limited(
        density * lobe_ggx_visibility(at.wo, at.wi), at.slope.resolved && at.z > 0.0
    );
}
