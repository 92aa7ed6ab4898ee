//! Dictionaries and their marginals, for the laws of both.
#![allow(dead_code, reason = "shared by tests that use some of it each")]

use lobe::material::multilobe::{Dictionary, LobeMeans, Marginal, Recipe};

/// A small one with all that a large one has.
pub(crate) fn small(means: LobeMeans) -> Dictionary<f64> {
    Dictionary::new(&Recipe { marginals: 24, levels: 9, means, ..Recipe::default() })
        .expect("valid")
}

/// Integral by the trapezoid rule over the nodes, exact for what is linear between them.
pub(crate) fn integral(f: impl Fn(f64) -> f64, intervals: i32) -> f64 {
    let step = 4.0 / f64::from(intervals);
    let nodes = -intervals..=intervals;
    let inner: f64 = nodes.map(|k| f(f64::from(k) * step)).sum();
    step * (inner - 0.5 * (f(-4.0) + f(4.0)))
}

pub(crate) fn all(
    dictionary: &Dictionary<f64>,
) -> impl Iterator<Item = (u32, u32, Marginal<'_, f64>)> {
    let Recipe { marginals, levels, .. } = *dictionary.recipe();
    let pairs = (0..marginals).flat_map(move |i| (0..levels).map(move |level| (i, level)));
    pairs.map(|(i, level)| (i, level, dictionary.marginal(i, level)))
}
