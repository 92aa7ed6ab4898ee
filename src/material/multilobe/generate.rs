//! Generation of a dictionary: nested sums of lobes, level by level.
//!
//! Layer 4.

use alloc::vec;
use alloc::vec::Vec;

use super::recipe::{LobeMeans, Recipe};
use crate::scalar::hash::{hash, tail};
use crate::scalar::quantile::normal_quantile;
use crate::scalar::{Internal, Real};

/// Deviations that a table reaches to.
pub(super) const REACH: f64 = 4.0;

/// The normal distribution's share within those, erf(4/sqrt(2)): no lobe stands outside, where a
/// table would have none.
const INSIDE: f64 = 0.999_936_657_516_333_8;

/// Deviations of a lobe beyond which it is left out: what is below 2e-8 of its peak.
const SUPPORT: f64 = 6.0;

/// Densities and cumulatives of all marginals, levels and nodes, in that order of loops, in f64.
pub(super) fn tables(recipe: &Recipe) -> Vec<[f64; 2]> {
    let Recipe { marginals, levels, intervals, .. } = *recipe;
    let stride = intervals as usize + 1;
    let mut sums = vec![0.0; marginals as usize * stride];
    let mut tables = vec![[0.0; 2]; recipe.nodes()];
    let mut strata: Vec<u32> = (0..marginals).collect();
    let mut means = vec![0.0; marginals as usize];
    let curve = Curve::new(recipe);
    for lobe in 0..1_u32 << (levels - 1) {
        draw(recipe, lobe, &mut strata, &mut means);
        for (sum, mean) in sums.chunks_exact_mut(stride).zip(&means) {
            curve.add(*mean, sum);
        }
        let count = lobe + 1;
        if count.is_power_of_two() {
            let level = count.trailing_zeros() as usize;
            for (marginal, sum) in sums.chunks_exact(stride).enumerate() {
                let begin = (marginal * levels as usize + level) * stride;
                normalized(sum, &mut tables[begin..begin + stride]);
            }
        }
    }
    tables
}

/// Draws the mean of the `lobe`th pair of lobes of every marginal: its magnitude, as lobes come in
/// pairs.
fn draw(recipe: &Recipe, lobe: u32, strata: &mut [u32], means: &mut [f64]) {
    let deviation = match recipe.means {
        LobeMeans::Stratified => {
            // What a lobe has, and a line between nodes.
            let step = REACH / f64::from(recipe.intervals);
            Real::sqrt(1.0 - recipe.width * recipe.width - step * step / 6.0)
        }
        LobeMeans::Chermain => 1.0,
    };
    // From the last marginal on: each takes one of the strata that are left (Fisher & Yates).
    for marginal in (0..recipe.marginals).rev() {
        let left = marginal + 1;
        let [pick, place, ..] = hash([lobe, marginal, recipe.seed, STREAM]);
        let pick = (u64::from(pick) * u64::from(left)) >> 32;
        // Below the number of marginals.
        strata.swap(pick as usize, marginal as usize);
        let inside: f64 = tail(place);
        means[marginal as usize] = match recipe.means {
            LobeMeans::Stratified => {
                (f64::from(strata[marginal as usize]) + inside) / f64::from(recipe.marginals)
            }
            LobeMeans::Chermain => inside,
        };
    }
    // In a loop of their own, for lanes.
    for mean in means {
        *mean = deviation * normal_quantile(0.5 * (1.0 - INSIDE * *mean));
    }
}

/// Tells these random numbers from those of cells.
const STREAM: u32 = 0x6c6f_6265;

/// Places from one node to the next that a lobe's mean may have: of 64 intervals, steps of a 230th
/// of a lobe's deviation.
const PLACES: i32 = 256;

/// A lobe at the nodes around its mean, for each of these places.
struct Curve {
    /// Places per deviation of the whole.
    scale: f64,
    /// Nodes before the one at the mean or below it.
    before: i32,
    /// Nodes of one place, and those of all.
    count: usize,
    values: Vec<f64>,
}

impl Curve {
    fn new(recipe: &Recipe) -> Self {
        let nodes = f64::from(recipe.intervals) / REACH;
        // From node to node, in deviations of a lobe.
        let step = 1.0 / (nodes * recipe.width);
        let before = Internal::floor(SUPPORT / step) + 1;
        let part = |place: i32| f64::from(place) / f64::from(PLACES);
        let value = |distance: f64| Real::exp(-0.5 * distance * distance);
        let values = (0..PLACES).flat_map(|place| {
            (-before..=before + 1).map(move |k| value(step * (f64::from(k) - part(place))))
        });
        let count = 2 * before.unsigned_abs() as usize + 2;
        Self { scale: nodes * f64::from(PLACES), before, count, values: values.collect() }
    }

    /// Adds $g(x - \mu) + g(x + \mu)$ at the nodes from 0 on, with $\mu \ge 0$: at each the first
    /// lobe, at it and at what mirrors it.
    fn add(&self, mean: f64, sums: &mut [f64]) {
        let place = Internal::floor(mean * self.scale + 0.5);
        let begin = self.count * (place % PLACES).unsigned_abs() as usize;
        let values = &self.values[begin..begin + self.count];
        let first = place / PLACES - self.before;
        if first > 0 {
            // Most are away from 0; what stands beyond the end is left out.
            let sums = sums.iter_mut().skip(first.unsigned_abs() as usize);
            sums.zip(values).for_each(|(sum, value)| *sum += value);
            return;
        }
        for (node, value) in (first..).zip(values) {
            if let Some(sum) = sums.get_mut(node.unsigned_abs() as usize) {
                // At 0 the lobe and its mirror are the same.
                *sum += if node == 0 { 2.0 * value } else { *value };
            }
        }
    }
}

/// A sum of lobes as a density whose linear interpolant has an integral of 1/2 from 0 on, and that
/// integral up to each node.
fn normalized(sums: &[f64], table: &mut [[f64; 2]]) {
    let step = REACH / (sums.len() - 1) as f64;
    let mut whole = 0.0;
    for pair in sums.windows(2) {
        whole += 0.5 * step * (pair[0] + pair[1]);
    }
    let scale = 0.5 / whole;
    let mut cumulative = 0.0;
    for (k, node) in table.iter_mut().enumerate() {
        if k > 0 {
            cumulative = f64::min(cumulative + 0.5 * step * scale * (sums[k - 1] + sums[k]), 0.5);
        }
        *node = [scale * sums[k], cumulative];
    }
    if let Some(node) = table.last_mut() {
        node[1] = 0.5;
    }
}
