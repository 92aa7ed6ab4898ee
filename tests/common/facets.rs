//! Pixels of a surface of facets, for the laws of many lobes.
#![allow(dead_code, reason = "shared by tests that use some of it each")]

use crate::common::arbitrary::Source;
use crate::common::quadrature::midpoints;
use lobe::material::cells::Patch;
use lobe::material::multilobe::{Dictionary, MultiLobe, PatchNdf, Recipe};
use lobe::{Kernel, Psd, Roughness};
use std::sync::OnceLock;

/// The default one, made once.
pub(crate) fn dictionary() -> &'static Dictionary<f64> {
    static DICTIONARY: OnceLock<Dictionary<f64>> = OnceLock::new();
    DICTIONARY.get_or_init(|| Dictionary::new(&Recipe::default()).expect("valid"))
}

/// Deviations that differ, and a correlation.
pub(crate) fn roughness() -> Roughness<f64> {
    Roughness::from_sigma_rho(0.3, 0.15, 0.6).expect("in range")
}

/// A pixel of about this many facets, somewhere.
pub(crate) fn pixel(facets: f64, index: u64) -> PatchNdf<'static, f64> {
    let mut source = Source::from_seed(index);
    let uv = [source.uniform(-9.0, 9.0), source.uniform(-9.0, 9.0)];
    let (turn, size) = (source.uniform(-3.2, 3.2), source.uniform(1.0, 2.0));
    let (sin, cos) = turn.sin_cos();
    let patch = Patch::new(uv, [size * cos, size * sin], [-size * sin, 1.5 * size * cos]);
    surface(facets, index as u32).ndf(dictionary(), &patch)
}

/// A surface of that roughness.
pub(crate) fn surface(density: f64, seed: u32) -> MultiLobe<f64> {
    MultiLobe::new(roughness(), density).expect("in range").with_seed(seed)
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Integral over slopes of the plane, in deviations of the roughness, by midpoints.
pub(crate) fn integral(f: impl Fn([f64; 2]) -> f64, reach: f64, nodes: u32) -> f64 {
    let [[a, b], [_, c]] = roughness().chermain_matrix(1.0);
    midpoints(reach, nodes, |[x, y]| f([a * x + b * y, c * y])) * a * c
}

/// Kernels against a lobe's covariance: round in its plane, and so but for a rounding, at the
/// longest piece and around it, long, a segment, of the plane's own axes, and any.
pub(crate) fn kernels(covariance: Psd<f64>) -> Vec<Kernel<f64>> {
    // A side of 1.5 deviations is the longest piece.
    let longest = 1.5 * 1.5 / 12.0;
    let round = [0.01, longest * (1.0 - 1e-15), longest, longest * (1.0 + 1e-15), 0.7, 1.2];
    let scaled = round.map(|share| covariance * share);
    let [l, m, n] = covariance.cholesky();
    let (x, y) = ([l, m], [0.0, n]);
    let outer = |u: [f64; 2], v: [f64; 2], [a, b]: [f64; 2]| {
        Psd::outer_sum(u.map(|c| a * c), v.map(|c| b * c))
    };
    let long = [[1.0, 0.1], [1.3, 0.5], [0.1, 1.4], [1.2, 0.0]].map(|sides| outer(x, y, sides));
    let nearly = outer(x, y, [1.0, 1.0 + 1e-15]);
    let any =
        [Psd::new(0.004, 0.001, 0.003), Psd::new(0.02, -0.01, 0.05)].map(|psd| psd.expect("valid"));
    let all = scaled.into_iter().chain(long).chain([nearly]).chain(any);
    all.map(Kernel::from_covariance).collect()
}
