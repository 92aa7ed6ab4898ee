//! What twins of glints and facets are given: words, counts, materials, pixels and directions, and
//! how WGSL reads them.

use super::input::{Drawn, Input};
use super::number::{normalized, unit};
use crate::arbitrary::{Ellipse, LobeInput, Source};

/// The WGSL expression of a group, over the place of each of its floats; `None` for groups of plain
/// numbers.
pub(super) fn wgsl(input: Input, at: impl Fn(usize) -> String) -> Option<String> {
    let bits = |k: usize| at(k).replace("at(", "bits_at(");
    let whole = |k: usize| format!("bitcast<i32>({})", bits(k));
    let pair = |k: usize| format!("vec2f({}, {})", at(k), at(k + 1));
    let triple = |k: usize| format!("vec3f({}, {}, {})", at(k), at(k + 1), at(k + 2));
    let biscale = || format!("lobe_biscale_from_fractions({}, {})", pair(0), pair(2));
    Some(match input {
        Input::Word => bits(0),
        Input::Whole => format!("vec2i({}, {})", whole(0), whole(1)),
        Input::Level => whole(0),
        Input::Trials => format!("{}, {}", at(0), at(1)),
        Input::Biscale => biscale(),
        Input::Glints => {
            format!("glittering({}, {}, {}, {}, {})", biscale(), at(4), at(5), at(6), bits(7))
        }
        Input::Facets => {
            let psd = format!("lobe_psd_new({}, {}, {})", at(0), at(1), at(2));
            let roughness = format!("lobe_roughness_from_matrix({psd})");
            format!("faceted({roughness}, {}, {}, {}, {})", at(3), at(4), at(5), bits(6))
        }
        Input::Numbers => {
            format!("array<f32, 7>({})", [0, 1, 2, 3, 4, 5, 6].map(at).join(", "))
        }
        Input::Marginal => format!("{}, {}", bits(0), bits(1)),
        Input::Patch => {
            let tile = format!("vec2i({}, {})", whole(0), whole(1));
            format!("lobe_patch_in_tile({tile}, {}, {}, {})", pair(2), pair(4), pair(6))
        }
        Input::Plain => format!("{}, {}, {}", pair(0), pair(2), pair(4)),
        Input::Mirrored => format!("{}, {}", triple(0), triple(3)),
        _ => return None,
    })
}

/// Draws a group.
pub(super) fn draw(input: Input, s: &mut Source, drawn: &mut Drawn, out: &mut Vec<f32>) {
    let mut put = |values: &[f64]| out.extend(values.iter().map(|&x| x as f32));
    match input {
        Input::Word => out.push(f32::from_bits(word(s))),
        Input::Whole => out.extend([0; 2].map(|_| f32::from_bits(whole(s)))),
        Input::Level => out.push(f32::from_bits(level(s))),
        Input::Trials => put(&trials(s)),
        Input::Tail => put(&[match s.pick(64) {
            0 => s.log_uniform(1e-10, 1e-3),
            _ => s.uniform(1e-3, 1.0),
        }]),
        Input::Biscale => put(&biscale(s, drawn)),
        Input::Glints => {
            put(&biscale(s, drawn));
            put(&[density(s), variation(s), share(s)]);
            out.push(f32::from_bits(word(s)));
        }
        Input::Facets => {
            let ellipse = s.ellipse();
            out.extend(ellipse.entries_single());
            drawn.lobe = Some(LobeInput { ellipse, mean: [0.0; 2] });
            let varied = if s.pick(3) == 0 { s.uniform(0.0, 4.0) } else { 2.0 };
            out.extend([density(s), varied, share(s)].map(|x| x as f32));
            out.push(f32::from_bits(word(s)));
        }
        Input::Tilt => {
            let mean = s.vector(1e-3, 1.0);
            put(&mean);
            drawn.lobe = drawn.lobe.map(|lobe| LobeInput { mean, ..lobe });
        }
        Input::Relief => {
            let mut alpha = || s.log_uniform(0.3, 3.0);
            let [x, y] = [alpha(), alpha()];
            out.extend(Ellipse { x, y, rho: s.uniform(-0.6, 0.6) }.entries_single());
        }
        Input::Blurring => {
            let lobe = drawn.lobe.expect("a lobe before its kernel");
            // Large ones are cut in pieces, whose ends move against each other: what a bound adds
            // up, a sum does not.
            let most = if s.pick(8) == 0 { 3.0 } else { 0.05 };
            let [x, y] = s.vector(1e-3, most);
            // Now and then one that is round in the lobe's plane.
            let other = if s.pick(64) == 0 { [-y, x] } else { s.vector(1e-3, most) };
            put(&[[x, y], other].map(|side| lobe.slope_at(side)).concat());
        }
        // At the ends tables are next to nothing, and a bound of what is drawn there says nothing.
        Input::Numbers => {
            put(&[0; 7].map(|_| if s.pick(99) == 0 { unit(s) } else { s.uniform(0.02, 0.98) }));
        }
        Input::Marginal => out.extend([60, 10].map(|most| f32::from_bits(s.pick(most) as u32))),
        Input::Patch => {
            out.extend(tile(s, drawn).map(f32::from_bits));
            out.extend(patch(s).map(|x| x as f32));
        }
        Input::Plain => put(&patch(s)),
        Input::Factors => {
            let factor = if s.pick(8) == 0 { 0.0 } else { s.log_uniform(1e-3, 1.0) };
            put(&if s.pick(2) == 0 { [1.0, factor] } else { [factor, 1.0] });
        }
        Input::Half => put(&half(s, drawn)),
        Input::Mirrored => {
            let (h, wo) = (half(s, drawn), s.direction());
            let twice = 2.0 * (0..3).map(|k| h[k] * wo[k]).sum::<f64>();
            let wi = [0, 1, 2].map(|k: usize| twice * h[k] - wo[k]);
            put(&if twice > 0.0 && wi[2] > 0.0 { [wo, wi] } else { s.pair() }.concat());
        }
        // The sun's now and then.
        Input::Radius => put(&[match s.pick(4) {
            0 => 0.0,
            1 => 0.00465,
            _ => s.log_uniform(1e-4, 1.0),
        }]),
        Input::Blur => put(&[if s.pick(3) == 0 { 0.0 } else { s.log_uniform(1e-8, 1.0) }]),
        other => unreachable!("{other:?} is no group of glints"),
    }
}

/// Any word, a small one, or a power of two.
fn word(s: &mut Source) -> u32 {
    match s.pick(6) {
        0 => s.pick(16) as u32,
        1 => 1 << s.pick(32),
        _ => s.pick(1 << 32) as u32,
    }
}

/// A whole number: near 0, a multiple of a power of two, at the ends, or any.
fn whole(s: &mut Source) -> u32 {
    let bits = match s.pick(8) {
        0 => s.pick(8),
        1 => (2 * s.pick(64) + 1) << s.pick(31),
        2 => 1 << 31,
        3 => (1 << 31) - 1,
        _ => s.pick(1 << 21),
    };
    let bits = bits as u32;
    if s.pick(2) == 0 { bits } else { bits.wrapping_neg() }
}

/// A pixel's tile: the first one in half of the cases, or near it, far away, at the ends.
///
/// Pixels of stretched details lie within 4 tiles of the origin. Their coordinates are multiplied
/// by a square root: where a driver rounds it differently, a pixel in tile t moves by t times the
/// difference, and far tiles would tell nothing.
fn tile(s: &mut Source, drawn: &Drawn) -> [u32; 2] {
    match s.pick(2) {
        0 => [0; 2],
        _ if drawn.stretched => [0; 2].map(|_| (s.pick(9) as u32).wrapping_sub(4)),
        _ => [whole(s), whole(s)],
    }
}

/// An exponent of a grid, and now and then one far beyond.
fn level(s: &mut Source) -> u32 {
    match s.pick(8) {
        0 => 290 + s.pick(20) as u32,
        1 => (290 + s.pick(20) as u32).wrapping_neg(),
        2 => word(s),
        _ => (s.pick(201) as u32).wrapping_sub(100),
    }
}

/// A number of trials, whole or not, of any size, and a probability: means up to 40, points of the
/// lattice, the ends.
fn trials(s: &mut Source) -> [f64; 2] {
    let n = match s.pick(6) {
        0 => 1.0,
        1 => 1.0 + s.pick(100) as f64,
        2 => s.log_uniform(1e-3, 1e18),
        3 => 8_388_608.0 + s.uniform(-4.0, 4.0),
        _ => s.log_uniform(1.0, 1e6),
    };
    let p = match s.pick(6) {
        0 => s.nudged(0.5) * 0.9_f64.powi(s.pick(60) as i32),
        1 => unit(s),
        _ => s.log_uniform(1e-10, 40.0) / n,
    };
    [n, p.min(1.0)]
}

/// Two alphas and two fractions: details round, longer along an axis, without end. Sharp ones have
/// alphas of 2e-4.
fn biscale(s: &mut Source, drawn: &mut Drawn) -> [f64; 4] {
    let mut alpha = || s.log_uniform(0.01, 3.0);
    let [a, b] = [alpha(), alpha()];
    let mut fraction = || if s.pick(6) == 0 { 1.0 } else { s.log_uniform(0.02, 1.0) };
    let [f, g] = [fraction(), fraction()];
    let [b, g] = if s.pick(3) == 0 { [a, f] } else { [b, g] };
    drawn.stretched = [b, g] != [a, f];
    drawn.lobe = Some(LobeInput { ellipse: Ellipse { x: a, y: b, rho: 0.0 }, mean: [0.0; 2] });
    [a, b, f, g]
}

/// Details per unit area: with the sizes of pixels below from one in a hundred pixels to any
/// number.
fn density(s: &mut Source) -> f64 {
    match s.pick(16) {
        0 => 1e-18,
        1 => 1e18,
        _ => s.log_uniform(1e-2, 1e8),
    }
}

fn variation(s: &mut Source) -> f64 {
    match s.pick(6) {
        0 => s.uniform(0.0, 4.0),
        1 => s.log_uniform(1e-6, 1.0),
        _ => 0.0,
    }
}

fn share(s: &mut Source) -> f64 {
    if s.pick(4) == 0 { unit(s) } else { 1.0 }
}

/// A pixel: near the origin or not; square, long, flat, a line, a point, tiny or huge.
fn patch(s: &mut Source) -> [f64; 6] {
    let mut coordinate = || match s.pick(8) {
        0 => 0.0,
        1 => s.pick(8) as f64 - 4.0,
        2 => s.log_uniform(1e-6, 1e4) * s.sign(),
        _ => s.uniform(-1.0, 1.0),
    };
    let [u, v] = [coordinate(), coordinate()];
    let size = if s.pick(8) == 0 { s.log_uniform(1e-8, 1e6) } else { s.log_uniform(1e-3, 3.0) };
    let (sin, cos) = s.angle().sin_cos();
    let right = [size * cos, size * sin];
    let across = |factor: f64| [-factor * right[1], factor * right[0]];
    let up = match s.pick(8) {
        0 => return [u, v, 0.0, 0.0, 0.0, 0.0],
        1 => [0.0; 2],
        2 => {
            let factor = s.uniform(-1.5, 1.5);
            right.map(|x| factor * x)
        }
        3 => across(1.0),
        4 => across(s.log_uniform(1e-3, 1e3)),
        _ => s.vector(0.2 * size, 5.0 * size),
    };
    [u, v, right[0], right[1], up[0], up[1]]
}

/// A unit half vector: within some alphas of the lobe, or any.
fn half(s: &mut Source, drawn: &Drawn) -> [f64; 3] {
    match drawn.lobe {
        Some(lobe) if s.pick(4) != 0 => {
            let w = s.vector(1e-3, 4.0);
            let [x, y] = lobe.slope_at(w);
            normalized([-x, -y, 1.0])
        }
        _ => s.direction(),
    }
}
