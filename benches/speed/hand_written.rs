//! What a careful engine writes by hand: the rivals of the generic code.

use std::f32::consts::PI;

/// GGX D(h) V for one alpha, in the stable form without 1 - (n.h)^2.
#[inline(always)]
pub(crate) fn isotropic(alpha: f32, wo: [f32; 3], wi: [f32; 3]) -> f32 {
    let a2 = alpha * alpha;
    let g = [wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]];
    let g2 = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    let k = a2 * g[2] * g[2] + (g[0] * g[0] + g[1] * g[1]);
    let d = a2 * g2 * g2 / (PI * k * k);
    let root = |w: [f32; 3]| (w[2] * w[2] + a2 * (w[0] * w[0] + w[1] * w[1])).sqrt();
    let v = 0.5 / (wo[2] * root(wi) + wi[2] * root(wo));
    if wo[2] > 0.0 && wi[2] > 0.0 { d * v } else { 0.0 }
}

/// The same for two alphas along the axes.
#[inline(always)]
pub(crate) fn axis_aligned([ax, ay]: [f32; 2], wo: [f32; 3], wi: [f32; 3]) -> f32 {
    let g = [wo[0] + wi[0], wo[1] + wi[1], wo[2] + wi[2]];
    let g2 = g[0] * g[0] + g[1] * g[1] + g[2] * g[2];
    let (x, y) = (g[0] / ax, g[1] / ay);
    let k = x * x + y * y + g[2] * g[2];
    let d = g2 * g2 / (PI * ax * ay * k * k);
    let root = |w: [f32; 3]| {
        let (x, y) = (ax * w[0], ay * w[1]);
        (w[2] * w[2] + x * x + y * y).sqrt()
    };
    let v = 0.5 / (wo[2] * root(wi) + wi[2] * root(wo));
    if wo[2] > 0.0 && wi[2] > 0.0 { d * v } else { 0.0 }
}

/// Kaplanyan 2016, Appendix A, with its corners mended: the mean of GGX over `slope +- widths/2`,
/// with the standard library's arctangent.
#[inline(always)]
pub(crate) fn appendix_a([ax, ay]: [f32; 2], slope: [f32; 2], widths: [f32; 2]) -> f32 {
    let phi = |x: f32, y: f32, gamma: f32, delta: f32| {
        let root = (x * x + gamma * gamma).sqrt();
        x / root * (gamma * y / (delta * root)).atan()
    };
    let (s0, s1) = (slope[0] - 0.5 * widths[0], slope[0] + 0.5 * widths[0]);
    let (t0, t1) = (slope[1] - 0.5 * widths[1], slope[1] + 0.5 * widths[1]);
    let sum = phi(s0, t0, ax, ay) - phi(s0, t1, ax, ay) + phi(s1, t1, ax, ay) - phi(s1, t0, ax, ay)
        + phi(t0, s0, ay, ax)
        - phi(t0, s1, ay, ax)
        + phi(t1, s1, ay, ax)
        - phi(t1, s0, ay, ax);
    sum / (2.0 * PI * widths[0] * widths[1])
}
