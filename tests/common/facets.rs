//! Pixels of a surface of facets, for the laws of many lobes.
#![allow(dead_code, reason = "shared by tests that use some of it each")]

use crate::common::arbitrary::Source;
use lobe::Roughness;
use lobe::material::glint::Patch;
use lobe::material::multilobe::{Dictionary, MultiLobe, PatchLobe, Recipe};
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
pub(crate) fn pixel(facets: f64, index: u64) -> PatchLobe<'static, f64> {
    let mut source = Source::from_seed(index);
    let uv = [source.uniform(-9.0, 9.0), source.uniform(-9.0, 9.0)];
    let (turn, size) = (source.uniform(-3.2, 3.2), source.uniform(1.0, 2.0));
    let (sin, cos) = turn.sin_cos();
    let patch = Patch::new(uv, [size * cos, size * sin], [-size * sin, 1.5 * size * cos]);
    MultiLobe::new(roughness(), facets)
        .expect("in range")
        .with_seed(index as u32)
        .lobe(dictionary(), &patch)
}
