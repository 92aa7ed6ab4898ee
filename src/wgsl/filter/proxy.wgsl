// Proxies: a GGX again, as bright at its peak as GGX under a pixel really is. Rust:
// src/filter/proxy.rs.

// Rust: `box_peak_alpha`. Numbers beyond [0, 1e9] count as the nearest, NaN as 0.
fn lobe_box_peak_alpha(alpha: f32, width: f32) -> f32 {
    let a = lobe_magnitude(alpha);
    let w = lobe_magnitude(width);
    let diagonal = sqrt(4.0 * a * a + w * w);
    let x = w / lobe_max(diagonal, LOBE_MIN_POSITIVE);
    let ratio = select(1.0, x / lobe_atan(x), x * x >= LOBE_MIN_POSITIVE);
    return 0.5 * diagonal * sqrt(ratio);
}

// Rust: `gaussian_peak_alpha`. Numbers beyond [0, 1e9] count as the nearest, NaN as 0.
fn lobe_gaussian_peak_alpha(alpha: f32, sigma: f32) -> f32 {
    let a = lobe_magnitude(alpha);
    let deviation = lobe_magnitude(sigma);
    let added = 2.0 * deviation * deviation;
    let square = a * a;
    if !(added >= LOBE_MIN_POSITIVE) {
        return a;
    }
    return sqrt(square + added * lobe_expint_reciprocal_tail(square / added));
}

// Rust: `Whitened`; unknown for a mirror.
struct LobeProxy {
    trace: f32,
    root_det: f32,
    known: bool,
}

// Rust: `Whitened::of`.
fn lobe_proxy_of(lobe: LobePsd, kernel: LobePsd) -> LobeProxy {
    let inverse = 1.0 / lobe_max(lobe.root_det, LOBE_MIN_POSITIVE);
    let trace = lobe_kept(lobe_psd_mixed_det(lobe, kernel) * inverse) * inverse;
    return LobeProxy(
        trace, kernel.root_det * inverse, !lobe_psd_is_singular(lobe) && trace <= 1e18
    );
}

// Rust: `Whitened::factor`.
fn lobe_proxy_factor(proxy: LobeProxy, r: f32) -> f32 {
    let excess = sqrt(lobe_max(r - 1.0, 0.0)) * sqrt(r + 1.0);
    return lobe_proxy_positive_root(proxy.root_det, proxy.trace, excess);
}

// Rust: `Whitened::fitted_factor`.
fn lobe_proxy_fitted_factor(proxy: LobeProxy) -> f32 {
    let kappa = 0.5 * proxy.trace;
    let s = sqrt(kappa);
    let round = (1.0 + 1.5226 * s) / (1.0 + 1.5377 * s + 2.508 * kappa + 0.22979 * kappa * s);
    let ratio = lobe_kept(proxy.root_det / lobe_max(kappa, LOBE_MIN_POSITIVE));
    let line = lobe_max(1.0 - ratio * ratio, 0.0);
    let minor = 0.5 * proxy.root_det * ratio;
    let long = lobe_kept(0.2104 * kappa / (1.0 + 0.08939 * s + 0.2104 * kappa));
    return 1.0 + lobe_kept(round) + lobe_proxy_long_term(minor) * line * long;
}

// Rust: `long_term`.
fn lobe_proxy_long_term(minor: f32) -> f32 {
    // 4/pi, rounded, less 1.
    let most = f32(1.2732395447351628) - 1.0;
    return most / (1.0 + 0.2109 * minor);
}

// Rust: `mirror_factor`.
fn lobe_proxy_mirror_factor(lobe: LobePsd, kernel: LobePsd) -> f32 {
    let mixed = lobe_psd_mixed_det(lobe, kernel);
    let minor = kernel.root_det * (kernel.root_det / lobe_max(mixed, LOBE_MIN_POSITIVE));
    return select(1.0, 1.0 + lobe_proxy_long_term(minor), mixed > 0.0);
}

// Rust: `positive_root`.
fn lobe_proxy_positive_root(d: f32, m: f32, e: f32) -> f32 {
    let twice = lobe_below_infinity(2.0 * d * e);
    let scale = lobe_max(m, twice);
    let least = lobe_max(scale, LOBE_MIN_POSITIVE);
    if !(scale > 0.0) {
        return select(0.0, e / lobe_max(d, LOBE_MIN_POSITIVE), d > 0.0);
    }
    let x = lobe_kept(m / least);
    let y = lobe_kept(twice / least);
    let sum = m + least * sqrt(x * x + y * y);
    return 2.0 * e * (e / lobe_max(sum, LOBE_MIN_POSITIVE));
}

// Rust: `Roughness::peak_matched`.
fn lobe_roughness_peak_matched(roughness: LobeRoughness, kernel: LobeKernel) -> LobeRoughness {
    let peak = lobe_ggx_gaussian_mean(lobe_lobe_centered(roughness), vec2f(0.0, 0.0), kernel);
    return lobe_roughness_with_peak(
        roughness, lobe_psd_mul(kernel.covariance, 2.0), peak, 1.0, 2.0
    );
}

// Rust: `Roughness::peak_fitted`.
fn lobe_roughness_peak_fitted(roughness: LobeRoughness, kernel: LobeKernel) -> LobeRoughness {
    let added = lobe_psd_mul(kernel.covariance, 2.0);
    let proxy = lobe_proxy_of(roughness.psd, added);
    var factor = 0.0;
    if proxy.known {
        factor = lobe_proxy_fitted_factor(proxy);
    } else {
        factor = lobe_proxy_mirror_factor(roughness.psd, added);
    }
    return LobeRoughness(lobe_psd_add(roughness.psd, lobe_psd_mul(added, factor)));
}

// Rust: `Roughness::peak_matched_over`.
fn lobe_roughness_peak_matched_over(
    roughness: LobeRoughness, footprint: LobeFootprint
) -> LobeRoughness {
    let sides = lobe_footprint_bounded(footprint);
    let kernel = lobe_psd_outer_sum(sides.u, sides.v);
    let shape = LobeNonCentered(lobe_anisotropic_new(roughness), vec2f(0.0, 0.0));
    let peak = lobe_ggx_parallelogram_mean(shape, vec2f(0.0, 0.0), sides);
    if !(peak > 0.0) {
        return LobeRoughness(lobe_psd_add(roughness.psd, lobe_psd_mul(kernel, LOBE_INVERSE_PI)));
    }
    return lobe_roughness_with_peak(roughness, kernel, peak, 0.2, 0.41);
}

// Rust: `Roughness::with_peak`.
fn lobe_roughness_with_peak(
    roughness: LobeRoughness, kernel: LobePsd, peak: f32, least: f32, most: f32
) -> LobeRoughness {
    let psd = roughness.psd;
    let root_det = lobe_anisotropic_new(roughness).root_det;
    let proxy = lobe_proxy_of(psd, kernel);
    var factor = 0.0;
    if proxy.known {
        factor = lobe_proxy_factor(
            proxy, 1.0 / lobe_max(LOBE_PI * peak * root_det, LOBE_MIN_POSITIVE)
        );
    } else {
        factor = lobe_proxy_positive_root(
            kernel.root_det, lobe_psd_mixed_det(psd, kernel),
            1.0 / lobe_max(LOBE_PI * peak, LOBE_MIN_POSITIVE)
        );
    }
    let bounded = select(least, lobe_min(lobe_max(factor, least), most), peak > 0.0);
    return LobeRoughness(lobe_psd_add(psd, lobe_psd_mul(kernel, bounded)));
}
