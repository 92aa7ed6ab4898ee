//! Generation of a dictionary: nested sums of lobes, level by level.
//!
//! Floor 4.

use alloc::vec;
use alloc::vec::Vec;

use super::recipe::{Means, Recipe};
use crate::scalar::Real;
use crate::scalar::hash::{hash, tail};
use crate::scalar::quantile::normal_quantile;

/// Deviations that a table reaches to.
pub(super) const REACH: f64 = 4.0;

/// The normal distribution's share within those, erf(4/sqrt(2)): no lobe stands outside, where a table would have none.
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
    let curve = Curve::new(recipe);
    for lobe in 0..1_u32 << (levels - 1) {
        add(recipe, &curve, lobe, &mut strata, &mut sums);
        let count = lobe + 1;
        if count.is_power_of_two() {
            let level = count.trailing_zeros() as usize;
            for (marginal, sum) in sums.chunks_exact(stride).enumerate() {
                let begin = (marginal * levels as usize + level) * stride;
                normalised(sum, &mut tables[begin..begin + stride]);
            }
        }
    }
    tables
}

/// Adds the `lobe`th pair of lobes to every marginal.
fn add(recipe: &Recipe, curve: &Curve, lobe: u32, strata: &mut [u32], sums: &mut [f64]) {
    let stride = recipe.intervals as usize + 1;
    let deviation = match recipe.means {
        Means::Stratified => {
            // What a lobe has, and a line between nodes.
            let step = REACH / f64::from(recipe.intervals);
            Real::sqrt(1.0 - recipe.width * recipe.width - step * step / 6.0)
        }
        Means::Published => 1.0,
    };
    // From the last marginal on: each takes one of the strata that are left (Fisher & Yates).
    for marginal in (0..recipe.marginals).rev() {
        let left = marginal + 1;
        let [pick, place, ..] = hash([lobe, marginal, recipe.seed, STREAM]);
        let pick = (u64::from(pick) * u64::from(left)) >> 32;
        // Below the number of marginals.
        strata.swap(pick as usize, marginal as usize);
        let inside: f64 = tail(place);
        let u = match recipe.means {
            Means::Stratified => {
                (f64::from(strata[marginal as usize]) + inside) / f64::from(recipe.marginals)
            }
            Means::Published => inside,
        };
        // Lobes come in pairs, so that the sign of a mean is none: strata are those of its magnitude.
        let mean = deviation * normal_quantile(0.5 * (1.0 - INSIDE * u));
        let begin = marginal as usize * stride;
        curve.add(mean, &mut sums[begin..begin + stride]);
    }
}

/// Tells these random numbers from those of cells.
const STREAM: u32 = 0x6c6f_6265;

/// One lobe at the nodes, as all of them have it.
struct Curve {
    /// Nodes per deviation of the whole.
    scale: f64,
    /// From node to node, in deviations of a lobe.
    step: f64,
    /// How many nodes to either side.
    reach: i32,
    /// $e^{-d^2/2}$ of that step, and its square.
    half: f64,
    square: f64,
}

impl Curve {
    fn new(recipe: &Recipe) -> Self {
        let scale = f64::from(recipe.intervals) / REACH;
        let step = 1.0 / (scale * recipe.width);
        let half = Real::exp(-0.5 * step * step);
        Self { scale, step, reach: Real::floor(SUPPORT / step) + 2, half, square: half * half }
    }

    /// Adds $g(x - \mu) + g(x + \mu)$ at the nodes from 0 on, with $\mu \ge 0$: at each the first lobe, at it and at what
    /// mirrors it.
    fn add(&self, mean: f64, sums: &mut [f64]) {
        // From the node at the mean or below it, outwards: each value from the one before, as logarithms of a Gaussian
        // differ by a line.
        let centre = mean * self.scale;
        let below = Real::floor(centre);
        let offset = (f64::from(below) - centre) * self.step;
        let peak = Real::exp(-0.5 * offset * offset);
        let growth = Real::exp(self.step * offset);
        self.side(below, -1, peak, self.half * growth, sums);
        let ratio = self.half / growth;
        self.side(below + 1, 1, peak * ratio, ratio * self.square, sums);
    }

    /// Adds one side of it, whose values fall by `ratio` at first.
    fn side(&self, first: i32, sign: i32, peak: f64, ratio: f64, sums: &mut [f64]) {
        let (mut node, mut value, mut ratio) = (first, peak, ratio);
        for _ in 0..self.reach {
            if let Some(sum) = sums.get_mut(node.unsigned_abs() as usize) {
                // At 0 the lobe and its mirror are the same.
                *sum += if node == 0 { 2.0 * value } else { value };
            }
            node += sign;
            value *= ratio;
            ratio *= self.square;
        }
    }
}

/// A sum of lobes as a density whose linear interpolant has an integral of 1/2 from 0 on, and that integral up to each node.
fn normalised(sums: &[f64], table: &mut [[f64; 2]]) {
    let step = REACH / (sums.len() - 1) as f64;
    let mut whole = 0.0;
    for pair in sums.windows(2) {
        whole += 0.5 * step * (pair[0] + pair[1]);
    }
    let scale = 0.5 / whole;
    let mut cumulative = 0.0;
    for (k, node) in table.iter_mut().enumerate() {
        if k > 0 {
            cumulative += 0.5 * step * scale * (sums[k - 1] + sums[k]);
        }
        *node = [scale * sums[k], cumulative];
    }
    if let Some(node) = table.last_mut() {
        node[1] = 0.5;
    }
}
