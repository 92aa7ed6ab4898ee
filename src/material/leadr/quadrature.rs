//! Nodes and weights for means over a Gaussian's slopes, along one axis.
//!
//! Layer 4. A grid of N nodes per axis takes N^2 facets. Weights sum to 1; `widths` say which
//! stretch of the axis a node stands for, in deviations: the weight over the density there. Light
//! lookups take their solid angle from it.

use super::surface::Node;
use crate::error::Error;
use crate::scalar::Real;

/// `N` nodes along an axis, in standard deviations, with weights that sum to 1.
///
/// ```
/// use lobe::material::leadr::Quadrature;
/// // The paper's table for 5 x 5.
/// let paper = Quadrature::<f64, 5>::dupuy();
/// assert_eq!(paper.nodes(), &[-1.8, -0.9, 0.0, 0.9, 1.8]);
/// assert!((paper.weights()[1] - 0.2443).abs() < 5e-5);
/// // It has too little variance; Gauss and Hermite's has the right one.
/// let variance = |grid: &Quadrature<f64, 5>| -> f64 {
///     grid.nodes().iter().zip(grid.weights()).map(|(p, w)| w * p * p).sum()
/// };
/// assert!((variance(&paper) - 0.866).abs() < 1e-3);
/// assert!((variance(&Quadrature::hermite()) - 1.0).abs() < 1e-14);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quadrature<R, const N: usize> {
    nodes: [R; N],
    weights: [R; N],
    widths: [R; N],
}

impl<R: Real, const N: usize> Quadrature<R, N> {
    /// Equal distances of `spacing` deviations around 0, Gaussian weights.
    ///
    /// A trapezoid: for smooth light its error falls like $e^{-2 \pi^2 / \mathrm{spacing}^2}$ with
    /// the spacing and like $e^{-\mathrm{reach}^2/2}$ with the reach, `spacing` times N/2.
    ///
    /// # Errors
    /// [`Error::Spacing`] unless it lies in $(0, 10]$; [`Error::NoNode`] if `N` is 0.
    ///
    /// ```
    /// let three = lobe::material::leadr::Quadrature::<f32, 3>::uniform(1.5)?;
    /// assert_eq!(three.nodes(), &[-1.5, 0.0, 1.5]);
    /// # Ok::<(), lobe::Error>(())
    /// ```
    pub fn uniform(spacing: R) -> Result<Self, Error> {
        if N == 0 {
            return Err(Error::NoNode);
        }
        if !(spacing > R::ZERO && spacing <= R::lit(10.0)) {
            return Err(Error::Spacing(spacing.into()));
        }
        Ok(Self::spaced(spacing.to_f64()))
    }

    /// The paper's: spacing 0.9 for 5 nodes, more reach for more of them, never beyond 3
    /// deviations.
    ///
    /// Its text has nodes for N = 5 only, "larger spacing" for larger N, and the reach of 3. Read
    /// here as: a reach of 1.8 for up to 5 nodes, from there in proportion to N - 1 until it is 3.
    ///
    /// Source: Dupuy et al. 2013, section 3.4.
    pub fn dupuy() -> Self {
        let gaps = N.saturating_sub(1).max(1) as f64;
        Self::spaced(2.0 * (0.45 * gaps).clamp(1.8, 3.0) / gaps)
    }

    /// Ours: the axis in N cells, the inner ones of one width, the outer two without end; each node
    /// is the mean of the density over its cell, each weight the cell's mass.
    ///
    /// A facet's shown area is linear in the slope but for the kink where it turns away, and means
    /// of cells are exact for what is linear: only the cell with the kink errs, and always to one
    /// side, as the area is convex. The largest error of the area, over all eyes above the mean
    /// plane and all deviations, is 14 % for N = 3, 5 % for 5, 2 % for 9, 0.2 % for 32; the paper's
    /// grids have 36, 12, 5 and 1 %. What varies within a cell is the light lookup's:
    /// [`Facet::solid_angle`](super::Facet::solid_angle). In pictures under narrow lamps ours are
    /// ahead from N = 9 on and on rough surfaces, the paper's 5 x 5 at deviations of 0.25 to 0.5:
    /// the report compares them.
    ///
    /// The outer cells begin at $1 + 0.35 \ln N$ deviations, within 0.2 of the best place for N = 3
    /// to 128.
    ///
    /// ```
    /// let grid = lobe::material::leadr::Quadrature::<f64, 2>::cells();
    /// // The mean of half a Gaussian.
    /// assert!((grid.nodes()[1] - (2.0 / core::f64::consts::PI).sqrt()).abs() < 1e-14);
    /// assert_eq!(grid.weights(), &[0.5, 0.5]);
    /// ```
    pub fn cells() -> Self {
        let count = N as f64;
        let reach = 1.0 + 0.35 * Real::ln(count.max(1.0));
        // Mass from an edge upwards, and the density there.
        let beyond = |edge: f64| 0.5 * Real::erfc(edge * core::f64::consts::FRAC_1_SQRT_2);
        let (mut nodes, mut weights) = ([0.0; N], [0.0; N]);
        // The upper half, whose masses are differences of small tails; the lower one is its mirror
        // image.
        for k in N / 2..N {
            let edge = |k: usize| reach * (2.0 * k as f64 / count - 1.0);
            let (above, at) =
                if k + 1 == N { (0.0, 0.0) } else { (beyond(edge(k + 1)), density(edge(k + 1))) };
            let mirror = N - 1 - k;
            if mirror == k {
                // Around 0: what the two sides leave.
                weights[k] = 1.0 - 2.0 * above;
                continue;
            }
            let low = edge(k);
            weights[k] = beyond(low) - above;
            nodes[k] = (density(low) - at) / weights[k];
            weights[mirror] = weights[k];
            nodes[mirror] = -nodes[k];
        }
        Self::of(nodes, weights)
    }

    /// Gauss and Hermite's: exact for polynomials of the slope up to degree 2N - 1.
    ///
    /// The best for small deviations and smooth light. An area that ends where facets turn away is
    /// no polynomial, and its outer nodes lie far apart: for deviations above about 0.25, and under
    /// narrow lamps, the others do better. Newton's method on Hermite polynomials in f64, for N up
    /// to 256; build it once.
    ///
    /// Source: Golub & Welsch 1969 for what the nodes are; weights by Christoffel's formula.
    ///
    /// ```
    /// use lobe::material::leadr::Quadrature;
    /// let three = Quadrature::<f64, 3>::hermite();
    /// assert!((three.nodes()[2] - 3.0_f64.sqrt()).abs() < 1e-14);
    /// assert!((three.weights()[1] - 2.0 / 3.0).abs() < 1e-14);
    /// ```
    pub fn hermite() -> Self {
        let mut nodes = [0.0; N];
        for k in 0..N / 2 {
            // From the right: what is found is divided out, so Newton's steps fall onto the next
            // root.
            let last = N - 1 - k;
            let start = if k == 0 { Real::sqrt(4.0 * N as f64 + 2.0) } else { nodes[last + 1] };
            nodes[last] = hermite_root(N, start, &nodes[last + 1..]);
            nodes[k] = -nodes[last];
        }
        // Christoffel: w = 1 / (N h_{N-1}^2) for orthonormal h.
        let weights = nodes.map(|p| {
            let [_, before] = hermite_polynomials(N, p);
            1.0 / (N as f64 * before * before)
        });
        Self::of(nodes, weights)
    }

    fn spaced(spacing: f64) -> Self {
        let middle = 0.5 * (N as f64 - 1.0);
        let mut nodes = [0.0; N];
        for (k, node) in nodes.iter_mut().enumerate() {
            *node = (k as f64 - middle) * spacing;
        }
        let weights = nodes.map(|p| Real::exp(-0.5 * p * p));
        let total: f64 = weights.iter().sum();
        Self::of(nodes, weights.map(|w| w / total))
    }

    fn of(nodes: [f64; N], weights: [f64; N]) -> Self {
        let mut widths = [0.0; N];
        for (width, (p, w)) in widths.iter_mut().zip(nodes.iter().zip(&weights)) {
            // Where the density is no number any more, nor is the weight.
            let density = density(*p);
            *width = if density > 0.0 { w / density } else { 0.0 };
        }
        Self { nodes: nodes.map(R::lit), weights: weights.map(R::lit), widths: widths.map(R::lit) }
    }

    /// The node in column `j` and row `k`.
    ///
    /// # Panics
    /// If one is not below N.
    #[inline]
    pub fn node(&self, j: usize, k: usize) -> Node<R> {
        Node {
            place: [self.nodes[j], self.nodes[k]],
            weight: self.weights[j] * self.weights[k],
            extent: self.widths[j] * self.widths[k],
        }
    }

    /// Positions in standard deviations, ascending.
    pub const fn nodes(&self) -> &[R; N] {
        &self.nodes
    }

    /// Weights; their sum is 1.
    pub const fn weights(&self) -> &[R; N] {
        &self.weights
    }

    /// How much of the axis a node stands for, in standard deviations: its weight over the normal
    /// density.
    pub const fn widths(&self) -> &[R; N] {
        &self.widths
    }
}

/// The normal density.
fn density(p: f64) -> f64 {
    Real::exp(-0.5 * p * p) * 0.398_942_280_401_432_7
}

/// Orthonormal Hermite polynomials of degrees n and n - 1 under the normal density.
fn hermite_polynomials(n: usize, x: f64) -> [f64; 2] {
    let (mut before, mut at) = (0.0, 1.0);
    for k in 0..n {
        let (below, above) = (k as f64, k as f64 + 1.0);
        (before, at) = (at, (x * at - Real::sqrt(below) * before) / Real::sqrt(above));
    }
    [at, before]
}

/// The largest root of degree `n` below `start` and the roots that are `known`.
fn hermite_root(n: usize, start: f64, known: &[f64]) -> f64 {
    let slope = Real::sqrt(n as f64);
    let mut x = if known.is_empty() { start } else { start - 1e-3 / slope };
    for _ in 0..200 {
        let [at, before] = hermite_polynomials(n, x);
        let divided: f64 = known.iter().map(|root| 1.0 / (x - root)).sum();
        let step = at / (slope * before - at * divided);
        x -= step;
        if step.abs() <= 1e-9 {
            break;
        }
    }
    // What rounding of the division left goes with two plain steps.
    for _ in 0..2 {
        let [at, before] = hermite_polynomials(n, x);
        x -= at / (slope * before);
    }
    x
}
