// Kaplanyan's Appendix A, as printed and with its corners mended, and his proxy. Rust:
// src/filter/kaplanyan.rs.

// Rust: `phi`.
fn lobe_kaplanyan_phi(x: f32, y: f32, gamma: f32, delta: f32) -> f32 {
    let root = sqrt(x * x + gamma * gamma);
    return x * lobe_atan(gamma * y / (root * delta)) / root;
}

// Rust: `eight_terms`.
fn lobe_kaplanyan_eight_terms(alphas: vec2f, slope: vec2f, reach: vec2f) -> f32 {
    let alpha = alphas.x;
    let beta = alphas.y;
    let left = slope.x - reach.x;
    let right = slope.x + reach.x;
    let low = slope.y - reach.y;
    let high = slope.y + reach.y;
    return lobe_kaplanyan_phi(left, low, alpha, beta) - lobe_kaplanyan_phi(left, high, alpha, beta)
        + lobe_kaplanyan_phi(right, high, alpha, beta) - lobe_kaplanyan_phi(right, low, alpha, beta)
        + lobe_kaplanyan_phi(low, left, beta, alpha) - lobe_kaplanyan_phi(low, right, beta, alpha)
        + lobe_kaplanyan_phi(high, right, beta, alpha)
        - lobe_kaplanyan_phi(high, left, beta, alpha);
}

// Rust: `kaplanyan_rectangle_mean`. 0 for NaN.
fn lobe_kaplanyan_rectangle_mean(alphas: vec2f, slope: vec2f, widths: vec2f) -> f32 {
    let terms = lobe_kaplanyan_eight_terms(alphas, slope, vec2f(0.5 * widths.x, 0.5 * widths.y));
    return lobe_kaplanyan_normalized(alphas, widths, terms);
}

// Rust: `kaplanyan_rectangle_mean_as_printed`. 0 for NaN.
fn lobe_kaplanyan_rectangle_mean_as_printed(alphas: vec2f, slope: vec2f, widths: vec2f) -> f32 {
    return lobe_kaplanyan_normalized(
        alphas, widths, lobe_kaplanyan_eight_terms(alphas, slope, widths)
    );
}

// Rust: `normalized`.
fn lobe_kaplanyan_normalized(alphas: vec2f, widths: vec2f, terms: f32) -> f32 {
    let area = widths.x * widths.y;
    let mean = lobe_max(terms / (2.0 * LOBE_PI * area), 0.0);
    return select(0.0, mean, alphas.x > 0.0 && alphas.y > 0.0 && area > 0.0);
}

// Rust: `kaplanyan_proxy_alpha`. Numbers beyond [0, 1e9] count as the nearest, NaN as 0.
fn lobe_kaplanyan_proxy_alpha(alpha: f32, width: f32) -> f32 {
    let a = lobe_magnitude(alpha);
    let w = lobe_magnitude(width);
    return sqrt(a * a + w * w);
}
