// A displaced surface as its lobe leaves it. Rust: src/material/leadr/surface.rs.

// Rust: `Leadr`.
struct LobeLeadr {
    shape: LobeNonCentered,
    factor: vec3f,
    cell: f32,
}

// Rust: `Node`.
struct LobeNode {
    place: vec2f,
    weight: f32,
    extent: f32,
}

// Rust: `Facet`.
struct LobeFacet {
    normal: vec3f,
    wi: vec3f,
    cosine: f32,
    area: f32,
    solid_angle: f32,
}

// Rust: `Leadr::new`.
fn lobe_leadr_new(lobe: LobeLobe) -> LobeLeadr {
    let covariance = lobe_roughness_covariance(lobe.roughness);
    return LobeLeadr(
        lobe_lobe_shape(lobe), vec3f(covariance.l_xx, covariance.l_yx, covariance.l_yy),
        lobe_psd_root_det(covariance)
    );
}

// Rust: `Leadr::brdf_cos`, with masking and shadowing. 0 for NaN.
fn lobe_leadr_brdf_cos(surface: LobeLeadr, wo: vec3f, wi: vec3f) -> f32 {
    let area = lobe_max(lobe_non_centered_mean_area(surface.shape, wi), 0.0);
    let brdf = lobe_beckmann_brdf(lobe_non_centered_pair(surface.shape, wo, wi));
    return lobe_below_infinity(lobe_defined(brdf * area));
}

// Rust: `Leadr::brdf_cos`, with masking alone. 0 for NaN.
fn lobe_leadr_unshadowed_brdf_cos(surface: LobeLeadr, wo: vec3f, wi: vec3f) -> f32 {
    return lobe_beckmann_unshadowed_brdf_cos(lobe_non_centered_pair(surface.shape, wo, wi));
}

// Rust: `Leadr::light_reaching`. 0 for NaN.
fn lobe_leadr_light_reaching(surface: LobeLeadr, wo: vec3f, wi: vec3f) -> f32 {
    let o = lobe_non_centered_view(surface.shape, wo);
    let i = lobe_non_centered_view(surface.shape, wi);
    let area = lobe_max(lobe_beckmann_projected_area(o), LOBE_MIN_POSITIVE);
    let shaded = lobe_max(o.mean_area, 0.0) * lobe_beckmann_lambda(i);
    return select(0.0, lobe_defined(area / (area + shaded)), i.mean_area > 0.0);
}

// Rust: `Leadr::facet`. Nothing is seen of a facet of NaN.
fn lobe_leadr_facet(surface: LobeLeadr, wo: vec3f, node: LobeNode) -> LobeFacet {
    let mean = surface.shape.mean;
    let factor = surface.factor;
    let slope = vec2f(
        mean.x + factor.x * node.place.x,
        mean.y + (factor.y * node.place.x + factor.z * node.place.y)
    );
    let normal = lobe_normal_of(slope);
    let shown = lobe_max(lobe_defined(wo.z - slope.x * wo.x - slope.y * wo.y), 0.0);
    let cosine = lobe_defined(shown * normal.z);
    let z = normal.z;
    let solid_angle = 4.0 * cosine * (z * z * z) * (node.extent * surface.cell);
    return LobeFacet(
        normal, lobe_reflect(wo, normal), cosine, lobe_defined(node.weight * shown),
        lobe_defined(solid_angle)
    );
}

// Rust: `Leadr::artificial_facet`. Nothing is seen of it for NaN.
fn lobe_leadr_artificial_facet(surface: LobeLeadr, wo: vec3f) -> LobeFacet {
    let n = lobe_normal_of(surface.shape.mean);
    let along = 1.01 * lobe_dot(n, wo);
    let normal = lobe_normalize(vec3f(n.x - along * wo.x, n.y - along * wo.y, n.z - along * wo.z));
    let cosine = lobe_max(lobe_defined(lobe_dot(normal, wo)), 0.0);
    let z = abs(normal.z);
    let solid_angle = 4.0 * cosine * (z * z * z) * surface.cell;
    return LobeFacet(
        normal, lobe_reflect(wo, normal), cosine, 1e-5 * cosine, lobe_defined(solid_angle)
    );
}
