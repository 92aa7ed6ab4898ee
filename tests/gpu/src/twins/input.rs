//! What twins are given: groups of floats, drawn ordinary and adversarial, and how either language
//! reads them.

use lobe::Footprint;

use super::glitter;
use super::number::{any, frame, normalized, size, small, unit};
use crate::arbitrary::{LobeInput, Source};

/// A group of floats with a meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Input {
    /// Any number of any size.
    Any,
    /// In [0, 1].
    Unit,
    /// In [-1, 1].
    Cosine,
    /// A roughness along an axis.
    Alpha,
    /// A width, deviation or other size, 0 included.
    Size,
    /// An exponent of e within the range of f32.
    Exponent,
    /// A positive number of any size.
    Positive,
    /// An argument of erfc.
    Deviation,
    /// A pixel filter's variance.
    Variance,
    /// A limit on alpha^2.
    Limit,
    /// One of the engines, as a whole number.
    Engine,
    /// A light's sharpness.
    Sharpness,
    /// Two numbers of any size.
    Vector,
    /// A slope; near the lobe drawn before it, where there is one.
    Slope,
    /// A mean slope.
    Mean,
    /// A point of the unit disk.
    Disk,
    /// Two alphas.
    Alphas,
    /// Two widths.
    Widths,
    /// A unit direction above the surface.
    Direction,
    /// Two of them, as two arguments.
    Pair,
    /// Three unit half vectors of neighboring pixels, as three arguments.
    Halves,
    /// A position in space.
    Position,
    /// A normal's derivative.
    Derivative,
    /// Three reflectances.
    Reflectance,
    /// Three indices of refraction.
    Index,
    /// Three extinction coefficients.
    Extinction,
    /// Three second moments, xx, xy, yy, of a distribution around the mean drawn before.
    Second,
    /// The length of a mean of unit normals.
    MeanLength,
    /// Raw moments as a sampler gives them of a unorm texture, two and three, and the range of it.
    Unorm,
    /// A matrix, row by row, with entries of moderate size.
    Matrix,
    /// A node of a grid over a Gaussian: place, weight, extent.
    Node,
    /// Curvature, b11, b12, b22.
    Curvature,
    /// A positive semi-definite matrix.
    Psd,
    /// The same as a roughness.
    Roughness,
    /// An isotropic shape under two columns.
    Widened,
    /// A roughness and a mean.
    Lobe,
    /// A roughness that is a mirror's, a groove's, or narrower than f32 has squares for, and a
    /// mean.
    Groove,
    /// A slope and a footprint around it that reaches the mean drawn before, or nearly, as two
    /// arguments.
    Covering,
    /// Two directions whose half vector's slope is that of such a footprint, and the footprint, as
    /// three arguments.
    Mirroring,
    /// Two derivative vectors of a slope.
    Footprint,
    /// A slope covariance.
    Kernel,
    /// Four shading frames of a quad, as four arguments.
    Frames,
    /// Any bits, as a word.
    Word,
    /// Two whole numbers of any size, by their bits.
    Whole,
    /// The exponent of a grid's cells, by its bits.
    Level,
    /// A number of trials and a probability, as two arguments.
    Trials,
    /// The probability of a larger count.
    Tail,
    /// Two alphas, and the shares of them that a detail has.
    Biscale,
    /// Glints with all their numbers.
    Glints,
    /// A pixel's place on a surface, by tile and fraction, and its sides.
    Patch,
    /// Plain coordinates and sides, as three arguments.
    Plain,
    /// What coordinates are compressed by.
    Factors,
    /// A unit half vector above the surface; near the lobe drawn before it, where there is one.
    Half,
    /// A pair of directions around one, as two arguments.
    Mirrored,
    /// A light's radius.
    Radius,
    /// What a light adds to alpha^2.
    Blur,
    /// A surface of facets with all its numbers.
    Facets,
    /// A mean slope, which what comes after is drawn around.
    Tilt,
    /// A covariance that leaves no lobe sharp.
    Relief,
    /// A kernel of any size up to some deviations of the lobe drawn before it.
    Blurring,
    /// The number of a marginal and its level, now and then beyond the last.
    Marginal,
    /// Seven uniform numbers.
    Numbers,
}

/// What later groups want to know of earlier ones.
#[derive(Default)]
pub(super) struct Drawn {
    pub(super) lobe: Option<LobeInput>,
    /// Whether details are longer along an axis.
    pub(super) stretched: bool,
    mean: [f64; 2],
}

impl Input {
    /// How many floats it takes.
    pub fn floats(self) -> usize {
        match self {
            Self::Vector
            | Self::Slope
            | Self::Mean
            | Self::Disk
            | Self::Alphas
            | Self::Widths
            | Self::Whole
            | Self::Trials
            | Self::Tilt
            | Self::Marginal
            | Self::Factors => 2,
            Self::Direction
            | Self::Position
            | Self::Derivative
            | Self::Reflectance
            | Self::Index
            | Self::Extinction
            | Self::Second
            | Self::Curvature
            | Self::Psd
            | Self::Roughness
            | Self::Relief
            | Self::Half => 3,
            Self::Footprint
            | Self::Kernel
            | Self::Blurring
            | Self::Matrix
            | Self::Node
            | Self::Biscale => 4,
            Self::Lobe | Self::Groove | Self::Widened => 5,
            Self::Mirroring => 10,
            Self::Facets | Self::Numbers => 7,
            Self::Covering | Self::Pair | Self::Unorm | Self::Plain | Self::Mirrored => 6,
            Self::Glints | Self::Patch => 8,
            Self::Halves => 9,
            Self::Frames => 36,
            _ => 1,
        }
    }

    /// The WGSL expression (or arguments) that reads it from the floats that begin at `base`.
    pub(super) fn wgsl(self, base: usize) -> String {
        let at = |k: usize| format!("at({}u)", base + k);
        let pair = |k: usize| format!("vec2f({}, {})", at(k), at(k + 1));
        let triple = |k: usize| format!("vec3f({}, {}, {})", at(k), at(k + 1), at(k + 2));
        let psd = |k: usize| format!("lobe_psd_new({}, {}, {})", at(k), at(k + 1), at(k + 2));
        let frame =
            |k: usize| format!("mat3x3f({}, {}, {})", triple(k), triple(k + 3), triple(k + 6));
        match self {
            Self::Engine => format!("u32({})", at(0)),
            Self::Psd | Self::Relief => psd(0),
            Self::Roughness => format!("lobe_roughness_from_matrix({})", psd(0)),
            Self::Lobe | Self::Groove => {
                format!("lobe_lobe_new({}, lobe_roughness_from_matrix({}))", pair(3), psd(0))
            }
            Self::Footprint => format!("lobe_footprint_from_slopes({}, {})", pair(0), pair(2)),
            Self::Covering => {
                format!("{}, lobe_footprint_from_slopes({}, {})", pair(0), pair(2), pair(4))
            }
            Self::Mirroring => {
                let over = format!("lobe_footprint_from_slopes({}, {})", pair(6), pair(8));
                format!("{}, {}, {over}", triple(0), triple(3))
            }
            Self::Widened => {
                let shape = format!("lobe_isotropic_new({})", at(0));
                format!("lobe_widened_new({shape}, {}, {})", pair(1), pair(3))
            }
            Self::Kernel | Self::Blurring => {
                format!("LobeKernel({}, {})", pair(0), pair(2))
            }
            Self::Unorm => format!("{}, {}, {}", pair(0), triple(2), at(5)),
            Self::Matrix => format!("mat2x2f({}, {}, {}, {})", at(0), at(2), at(1), at(3)),
            Self::Node => format!("LobeNode({}, {}, {})", pair(0), at(2), at(3)),
            Self::Pair => format!("{}, {}", triple(0), triple(3)),
            Self::Halves => format!("{}, {}, {}", triple(0), triple(3), triple(6)),
            Self::Frames => {
                format!("{}, {}, {}, {}", frame(0), frame(9), frame(18), frame(27))
            }
            other => glitter::wgsl(other, at).unwrap_or_else(|| match other.floats() {
                1 => at(0),
                2 => pair(0),
                _ => triple(0),
            }),
        }
    }

    /// Draws it.
    #[allow(clippy::too_many_lines, reason = "a table")]
    pub(super) fn draw(self, source: &mut Source, drawn: &mut Drawn, out: &mut Vec<f32>) {
        let mut put = |values: &[f64]| out.extend(values.iter().map(|&x| x as f32));
        let s = source;
        match self {
            Self::Any => put(&[any(s)]),
            Self::Unit => put(&[unit(s)]),
            Self::Cosine => put(&[unit(s) * s.sign()]),
            Self::Alpha => put(&[s.alpha()]),
            Self::Size => put(&[size(s, 1e-5, 1e2)]),
            Self::Exponent => put(&[match s.pick(4) {
                0 => size(s, 1e-12, 1.0) * s.sign(),
                _ => s.uniform(-103.0, 88.7),
            }]),
            Self::Positive => put(&[match s.pick(4) {
                0 => 1.0 + s.uniform(-1e-3, 1e-3),
                _ => s.log_uniform(1e-37, 1e38),
            }]),
            Self::Deviation => put(&[s.uniform(0.0, 10.0) * s.sign()]),
            Self::Variance => {
                let known = [1.0 / 12.0, 0.25, 0.5 * core::f64::consts::FRAC_1_PI, 0.5];
                put(&[match s.pick(3) {
                    0 => s.log_uniform(1e-3, 10.0),
                    _ => known[s.pick(4) as usize],
                }]);
            }
            Self::Limit => put(&[match s.pick(3) {
                0 => 0.18,
                1 => 1e9,
                _ => size(s, 1e-6, 1e3),
            }]),
            Self::Engine => put(&[s.pick(7) as f64]),
            Self::Sharpness => put(&[s.log_uniform(1e-6, 1e9)]),
            Self::Vector => put(&[any(s), any(s)]),
            Self::Slope => put(&match drawn.lobe {
                Some(lobe) if s.pick(2) == 0 => s.slope_near(&lobe),
                _ => s.slope(),
            }),
            Self::Mean => {
                drawn.mean = s.mean();
                put(&drawn.mean);
            }
            Self::Disk => put(&s.vector(1e-6, 1.0)),
            Self::Alphas => put(&[s.alpha(), s.alpha()]),
            Self::Widths => put(&[size(s, 1e-5, 1e2), size(s, 1e-5, 1e2)]),
            Self::Direction => put(&s.direction()),
            Self::Pair => put(&s.pair().concat()),
            Self::Halves => {
                let h = s.direction();
                let mut near = |_| {
                    let [x, y] = s.vector(1e-6, 0.3);
                    normalized([h[0] + x, h[1] + y, h[2].max(1e-3)])
                };
                put(&[h, near(0), near(1)].concat());
            }
            Self::Position => {
                let (far, w) = (s.log_uniform(1e-3, 1e4), s.direction());
                put(&w.map(|x| far * x));
            }
            Self::Derivative | Self::Curvature => put(&small(s)),
            Self::Reflectance => put(&[unit(s), unit(s), unit(s)]),
            Self::Index => put(&[0; 3].map(|_| s.log_uniform(0.05, 5.0))),
            Self::Extinction => put(&[0; 3].map(|_| size(s, 1e-3, 10.0))),
            Self::Second => {
                let ([x, y], e) = (drawn.mean, s.ellipse());
                let [xx, xy, yy] = e.entries();
                put(&[0.5 * xx + x * x, 0.5 * xy + x * y, 0.5 * yy + y * y]);
            }
            Self::MeanLength => put(&[match s.pick(4) {
                0 => 1.0,
                1 => s.log_uniform(1e-6, 1.0),
                _ => 1.0 - s.log_uniform(1e-7, 0.5),
            }]),
            Self::Unorm => {
                let [xx, xy, yy] = s.mild_ellipse(10.0).entries().map(|a| 0.5 * a);
                // Where steps leave no digit of a determinant, the last bit says whether there is
                // one.
                let [x, y] = [xx, yy].map(|variance| s.uniform(-3.0, 3.0) * variance.sqrt());
                let second = [xx + x * x, xy + x * y, yy + y * y];
                let range = second[0].max(second[2]).sqrt().max(1e-6);
                let signed = |x: f64| (32768.0 + 32767.0 * x) / 65535.0;
                let square = range * range;
                put(&[signed(x / range), signed(y / range), second[0] / square]);
                put(&[signed(second[1] / square), second[2] / square, range]);
            }
            Self::Matrix => put(&[0; 4].map(|_| size(s, 1e-3, 1e2) * s.sign())),
            Self::Node => {
                let place = s.vector(1e-3, 5.0);
                put(&[place[0], place[1], s.log_uniform(1e-6, 1.0), s.log_uniform(1e-3, 10.0)]);
            }
            Self::Psd | Self::Roughness => {
                out.extend(s.ellipse().entries_single());
            }
            Self::Lobe => {
                let lobe = s.lobe();
                out.extend(lobe.ellipse.entries_single());
                out.extend(lobe.mean.map(|x| x as f32));
                drawn.lobe = Some(lobe);
            }
            Self::Groove => {
                let mut narrow = |least: f64| s.log_uniform(least, 1e-6);
                let (x, y) = (narrow(1e-18), narrow(1e-18));
                let wide = s.log_uniform(1e-3, 3.0);
                // Whole numbers of few bits, so that the outer product is exact and has no
                // determinant.
                let whole = |s: &mut Source| s.uniform(1.0, 2047.0).floor() * s.sign();
                let (a, b, scale) = (whole(s), whole(s), 2.0_f64.powi(-(s.pick(24) as i32)));
                // Few lobes that are narrow, but none of these: their roundings' bounds leave the
                // range of f32.
                put(&match s.pick(20) {
                    0..4 => [0.0; 3],
                    4..8 => [wide * wide, 0.0, 0.0],
                    8..12 => [0.0, 0.0, wide * wide],
                    12 => [x * x, 0.0, wide * wide],
                    13 => [x * x, 0.0, y * y],
                    _ => [a * a, a * b, b * b].map(|entry| scale * entry),
                });
                drawn.mean = s.mean();
                put(&drawn.mean);
            }
            Self::Covering => {
                let (slope, [u, v]) = covering(s, drawn.mean);
                put(&[slope, u, v].concat());
            }
            Self::Mirroring => {
                let (slope, [u, v]) = covering(s, drawn.mean);
                let (h, wo) = (normalized([-slope[0], -slope[1], 1.0]), s.direction());
                let twice = 2.0 * (0..3).map(|k| h[k] * wo[k]).sum::<f64>();
                let wi = [0, 1, 2].map(|k: usize| twice * h[k] - wo[k]);
                put(&if twice > 0.0 && wi[2] > 0.0 { [wo, wi] } else { s.pair() }.concat());
                put(&[u, v].concat());
            }
            Self::Footprint => {
                let Footprint { u, v } = s.footprint();
                put(&[u, v].concat());
            }
            Self::Widened => {
                put(&[s.alpha()]);
                put(&s.kernel().concat());
            }
            Self::Kernel => put(&s.kernel().concat()),
            Self::Frames => {
                for _ in 0..4 {
                    put(&frame(s).concat());
                }
            }
            other => glitter::draw(other, s, drawn, out),
        }
    }
}

/// A slope, and the sides of a footprint around it that reaches this mean, or nearly.
fn covering(s: &mut Source, mean: [f64; 2]) -> ([f64; 2], [[f64; 2]; 2]) {
    let (u, v) = (s.vector(1e-3, 3.0), s.vector(1e-3, 3.0));
    let (i, j) = (s.uniform(-0.8, 0.8), s.uniform(-0.8, 0.8));
    ([0, 1].map(|k| mean[k] + i * u[k] + j * v[k]), [u, v])
}
