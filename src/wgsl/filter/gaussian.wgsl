// Widened lobes, and GGX under a Gaussian by quadrature. Rust: src/filter/gaussian.rs.

// Rust: `Roughness::widened`.
fn lobe_roughness_widened(roughness: LobeRoughness, kernel: LobeKernel) -> LobeRoughness {
    let added = lobe_kernel_added(kernel);
    return LobeRoughness(lobe_psd_with_columns(roughness.psd, added.u, added.v));
}

// Rust: `Kernel::widen`, of an isotropic shape.
fn lobe_kernel_widen(kernel: LobeKernel, shape: LobeIsotropic) -> LobeWidened {
    return LobeWidened(shape, kernel.u, kernel.v);
}

// Rust: `Lobe::widened`.
fn lobe_lobe_widened(lobe: LobeLobe, kernel: LobeKernel) -> LobeLobe {
    return LobeLobe(lobe.mean, lobe_roughness_widened(lobe.roughness, kernel));
}

// WGSL only: the forms and determinants of `ggx_gaussian_mean`, which has them as a closure's
// captures.
struct LobeGaussianTerms {
    base_form: f32,
    added_form: f32,
    base_det: f32,
    mixed: f32,
    added_det: f32,
}

// WGSL only: Rust has it as a closure.
fn lobe_gaussian_exponent(terms: LobeGaussianTerms, t: f32) -> f32 {
    return (terms.base_form / t + terms.added_form)
        / ((terms.base_det / t + terms.mixed) / t + terms.added_det);
}

// Rust: `ggx_gaussian_mean`. 0 for a slope that is infinite or NaN.
fn lobe_ggx_gaussian_mean(lobe: LobeLobe, slope: vec2f, kernel: LobeKernel) -> f32 {
    let base = lobe.roughness.psd;
    let columns = lobe_kernel_added(kernel);
    let added = lobe_psd_outer_sum(columns.u, columns.v);
    let known = lobe_is_finite(slope.x) && lobe_is_finite(slope.y);
    if !known || lobe_psd_is_singular(lobe_psd_add(base, added)) {
        return 0.0;
    }
    let offset = vec2f(slope.x - lobe.mean.x, slope.y - lobe.mean.y);
    let terms = LobeGaussianTerms(
        lobe_psd_adjugate_form(base, offset), lobe_psd_adjugate_form(added, offset),
        lobe_psd_det(base), lobe_psd_mixed_det(base, added), lobe_psd_det(added)
    );
    let step = 0.4375;
    let reach = 4.0 * step;
    var reaches = 0;
    for (; reaches < 39; reaches++) {
        if !(lobe_gaussian_exponent(terms, lobe_exp(-(reach * f32(reaches)))) > 1.0) {
            break;
        }
    }
    let start = -(18.0 + reach * f32(reaches));
    var sum = 0.0;
    for (var node = 0; node <= 49 + 4 * reaches; node++) {
        let t = lobe_exp(start + step * f32(node));
        let det = (terms.base_det / t + terms.mixed) / t + terms.added_det;
        sum = sum + t * lobe_exp(-t - lobe_gaussian_exponent(terms, t)) / sqrt(det);
    }
    let mean = sum * (step * LOBE_INVERSE_PI);
    if lobe_is_finite(mean) {
        return mean;
    }
    let widened = lobe_lobe_shape(lobe_lobe_widened(lobe, kernel));
    return lobe_ggx_slope_pdf(lobe_non_centered_normal(widened, vec3f(-slope.x, -slope.y, 1.0)));
}
