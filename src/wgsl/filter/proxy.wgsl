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
    let inverse = 1.0 / lobe_max(lobe_psd_root_det(lobe), LOBE_MIN_POSITIVE);
    let trace = lobe_kept(lobe_psd_mixed_det(lobe, kernel) * inverse) * inverse;
    return LobeProxy(
        trace, lobe_psd_root_det(kernel) * inverse, !lobe_psd_is_singular(lobe) && trace <= 1e18
    );
}

// Rust: `Whitened::factor`.
fn lobe_proxy_factor(proxy: LobeProxy, r: f32) -> f32 {
    let excess = sqrt(lobe_max(r - 1.0, 0.0)) * sqrt(r + 1.0);
    return lobe_proxy_positive_root(proxy.root_det, proxy.trace, excess);
}

// Rust: `LARGEST_KAPPA`.
const LOBE_PEAK_LARGEST_KAPPA: f32 = 1e10;
// Rust: `LARGEST_MINOR`.
const LOBE_PEAK_LARGEST_MINOR: f32 = 1e6;

// Rust: `fitted_factor`.
fn lobe_peak_factor(det: f32, mixed: f32, kernel_det: f32) -> f32 {
    let whitened = 0.5 * (mixed / lobe_max(det, LOBE_MIN_POSITIVE));
    let kappa = select(
        LOBE_PEAK_LARGEST_KAPPA, lobe_min(whitened, LOBE_PEAK_LARGEST_KAPPA),
        det >= LOBE_MIN_POSITIVE
    );
    let s = sqrt(kappa);
    let inverse = 1.0 / lobe_max(mixed, LOBE_MIN_POSITIVE);
    let minor = lobe_min(kernel_det * inverse, LOBE_PEAK_LARGEST_MINOR);
    let line = select(0.0, lobe_max(1.0 - 4.0 * minor * (det * inverse), 0.0), mixed > 0.0);
    let round = 1.0 + 1.5226 * s;
    let under_round = 1.0 + 1.5377 * s + kappa * (2.508 + 0.22979 * s);
    let growth = 0.2104 * kappa;
    let under_long = (1.0 + 0.2109 * minor) * (1.0 + 0.08939 * s + growth);
    let long = 0.27323954473516276 * (line * growth);
    return 1.0 + (round * under_long + long * under_round) / (under_round * under_long);
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

// WGSL only: the end of `Kernel::peak_columns`, of columns of what the kernel adds.
fn lobe_peak_columns(added: LobeKernel, det: f32, mixed: f32) -> LobeKernel {
    let cross = added.u.x * added.v.y - added.u.y * added.v.x;
    let root = sqrt(lobe_peak_factor(det, mixed, cross * cross));
    return LobeKernel(
        vec2f(added.u.x * root, added.u.y * root), vec2f(added.v.x * root, added.v.y * root)
    );
}

// Rust: `Kernel::widen_to_peak`, of an isotropic shape.
fn lobe_kernel_widen_to_peak(kernel: LobeKernel, shape: LobeIsotropic) -> LobeWidened {
    let added = lobe_kernel_added(kernel);
    let square = shape.alpha * shape.alpha;
    let mixed = lobe_isotropic_adjugate_form(shape, added.u)
        + lobe_isotropic_adjugate_form(shape, added.v);
    let columns = lobe_peak_columns(added, square * square, mixed);
    return LobeWidened(shape, columns.u, columns.v);
}

// Rust: `Roughness::peak_matched`.
fn lobe_roughness_peak_matched(roughness: LobeRoughness, kernel: LobeKernel) -> LobeRoughness {
    let peak = lobe_ggx_gaussian_mean(lobe_lobe_centered(roughness), vec2f(0.0, 0.0), kernel);
    let added = lobe_kernel_added(kernel);
    return lobe_roughness_with_peak(
        roughness, lobe_psd_outer_sum(added.u, added.v), peak, 1.0, 2.0
    );
}

// Rust: `Roughness::peak_fitted`.
fn lobe_roughness_peak_fitted(roughness: LobeRoughness, kernel: LobeKernel) -> LobeRoughness {
    let added = lobe_kernel_added(kernel);
    let psd = roughness.psd;
    let root_det = lobe_anisotropic_new(roughness).root_det;
    let mixed = lobe_psd_adjugate_form(psd, added.u) + lobe_psd_adjugate_form(psd, added.v);
    let columns = lobe_peak_columns(added, root_det * root_det, mixed);
    return LobeRoughness(lobe_psd_with_columns(psd, columns.u, columns.v));
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
            lobe_psd_root_det(kernel), lobe_psd_mixed_det(psd, kernel),
            1.0 / lobe_max(LOBE_PI * peak, LOBE_MIN_POSITIVE)
        );
    }
    let bounded = select(least, lobe_min(lobe_max(factor, least), most), peak > 0.0);
    return LobeRoughness(lobe_psd_add(psd, lobe_psd_mul(kernel, bounded)));
}
