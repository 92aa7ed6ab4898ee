// The matrix A, one constructor for each number users have. Rust: src/slope/roughness.rs.

// Rust: `Roughness`.
struct LobeRoughness {
    psd: LobePsd,
}

// Rust: `Alphas`.
struct LobeAlphas {
    major: f32,
    minor: f32,
    angle: f32,
}

// Rust: `Roughness::from_alpha`. Alpha beyond [0, 1e9] counts as the nearest, NaN as 0.
fn lobe_roughness_from_alpha(alpha: f32) -> LobeRoughness {
    let a = lobe_magnitude(alpha);
    return LobeRoughness(LobePsd(a, 0.0, a));
}

// Rust: `Roughness::from_perceptual`. Values beyond [0, 1] count as the nearest, NaN as 0.
fn lobe_roughness_from_perceptual(perceptual: f32) -> LobeRoughness {
    let r = lobe_min(lobe_max(perceptual, 0.0), 1.0);
    return lobe_roughness_from_alpha(r * r);
}

// Rust: `Roughness::from_matrix`.
fn lobe_roughness_from_matrix(psd: LobePsd) -> LobeRoughness {
    return LobeRoughness(psd);
}

// Rust: `Roughness::from_covariance`.
fn lobe_roughness_from_covariance(covariance: LobePsd) -> LobeRoughness {
    return LobeRoughness(lobe_psd_mul(covariance, 2.0));
}

// Rust: `Roughness::from_sigma_rho`. Numbers outside their ranges count as the nearest, NaN as 0.
fn lobe_roughness_from_sigma_rho(sigma_x: f32, sigma_y: f32, rho: f32) -> LobeRoughness {
    let covariance = lobe_psd_from_deviations(
        lobe_magnitude(sigma_x), lobe_magnitude(sigma_y), lobe_within(rho, 1.0)
    );
    return lobe_roughness_from_covariance(covariance);
}

// Rust: `Roughness::covariance`.
fn lobe_roughness_covariance(roughness: LobeRoughness) -> LobePsd {
    return lobe_psd_mul(roughness.psd, 0.5);
}

// Rust: `Roughness::alphas`.
fn lobe_roughness_alphas(roughness: LobeRoughness) -> LobeAlphas {
    let eigen = lobe_psd_eigen(roughness.psd);
    let turn = eigen.axis;
    let angle = select(lobe_atan(turn.y / turn.x), 0.5 * LOBE_PI, turn.x == 0.0);
    return LobeAlphas(sqrt(eigen.major), sqrt(eigen.minor), angle);
}

// Rust: `Roughness::chermain_matrix`. Columns first; 0 for NaN.
fn lobe_roughness_chermain_matrix(roughness: LobeRoughness, sigma_o: f32) -> mat2x2f {
    let covariance = lobe_roughness_covariance(roughness);
    let entries = lobe_psd_entries(covariance);
    let inverse = 1.0 / sigma_o;
    if entries.z < LOBE_MIN_POSITIVE {
        return mat2x2f(lobe_defined(sqrt(entries.x) * inverse), 0.0, 0.0, 0.0);
    }
    let sigma_y = sqrt(entries.z);
    return mat2x2f(
        lobe_defined(lobe_psd_root_det(covariance) / sigma_y * inverse), 0.0,
        lobe_defined(entries.y / sigma_y * inverse), lobe_defined(sigma_y * inverse)
    );
}

// Rust: `Roughness::add`.
fn lobe_roughness_add(a: LobeRoughness, b: LobeRoughness) -> LobeRoughness {
    return LobeRoughness(lobe_psd_add(a.psd, b.psd));
}
