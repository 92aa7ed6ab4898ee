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
