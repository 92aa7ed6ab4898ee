//! Numbers and vectors that groups of inputs are made of.

use crate::arbitrary::Source;

/// A number of any size and sign, within the squares that f32 holds.
pub(super) fn any(s: &mut Source) -> f64 {
    match s.pick(8) {
        0 => 0.0,
        1 => s.sign(),
        _ => s.log_uniform(1e-18, 1e18) * s.sign(),
    }
}

/// A number in [0, 1], its ends included.
pub(super) fn unit(s: &mut Source) -> f64 {
    match s.pick(8) {
        0 => 0.0,
        1 => 1.0,
        2 => s.log_uniform(1e-9, 1.0),
        _ => s.unit(),
    }
}

/// 0, or a size.
pub(super) fn size(s: &mut Source, low: f64, high: f64) -> f64 {
    if s.pick(8) == 0 { 0.0 } else { s.log_uniform(low, high) }
}

/// A vector of any direction, from 0 to about 1.
pub(super) fn small(s: &mut Source) -> [f64; 3] {
    let length = size(s, 1e-5, 1.0);
    [0; 3].map(|_| length * s.uniform(-1.0, 1.0))
}

/// A vector of length 1.
pub(super) fn normalized(v: [f64; 3]) -> [f64; 3] {
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

/// Tangent, bitangent and normal, leaning by up to a half from z.
pub(super) fn frame(s: &mut Source) -> [[f64; 3]; 3] {
    let [x, y] = s.vector(1e-4, 0.5);
    let n = normalized([x, y, 1.0]);
    let (sin, cos) = s.angle().sin_cos();
    let along = n[0] * cos + n[1] * sin;
    let t = normalized([cos - along * n[0], sin - along * n[1], -along * n[2]]);
    let b = [n[1] * t[2] - n[2] * t[1], n[2] * t[0] - n[0] * t[2], n[0] * t[1] - n[1] * t[0]];
    [t, b, n]
}
