//! A dictionary of marginals: one-dimensional densities of slopes, each on many levels.
//!
//! Layer 4.

use alloc::vec::Vec;

use super::generate::tables;
use super::marginal::Marginal;
use super::recipe::Recipe;
use crate::error::Error;
use crate::scalar::Real;

/// Marginal densities, even, of unit variance in their mean but for what is cut, on nested levels
/// of 1, 2, 4, ... pairs of lobes.
///
/// Level L of a marginal has the first $2^L$ of its lobes, $p_L(x) = \frac{1}{2 \cdot 2^L} \sum_k
/// g(x - \mu_k) + g(x + \mu_k)$, cut at 4 deviations; what is stored are its nodes, with the
/// integral of their linear interpolant, which is 1 over the whole. Two marginals make a
/// distribution of slopes ([`MultiLobe`](super::MultiLobe)).
///
/// Everything is deterministic: the same [`Recipe`] gives the same bits on any machine.
///
/// Source: Chermain et al. 2020; 2021a, section 3. There the tables hold densities alone, of a
/// whole with deviation $0.5/\sqrt 2$, in 16 bits.
///
/// ```
/// use lobe::material::multilobe::{Dictionary, Recipe};
/// let recipe = Recipe { marginals: 16, levels: 6, ..Recipe::default() };
/// let dictionary = Dictionary::<f32>::new(&recipe)?;
/// let sharp = dictionary.marginal(3, 0);
/// let (mut sum, step) = (0.0, 1e-3);
/// for k in -4000..4000 {
///     sum += step * sharp.density(step * (k as f32 + 0.5));
/// }
/// assert!((sum - 1.0).abs() < 1e-3);
/// # Ok::<(), lobe::Error>(())
/// ```
// Further methods: material/multilobe/bytes.rs.
#[doc(alias = "LobeDictionary")]
#[derive(Clone, Debug, PartialEq)]
pub struct Dictionary<R> {
    recipe: Recipe,
    nodes: Vec<[R; 2]>,
}

impl<R: Real> Dictionary<R> {
    /// Made by a recipe: by the default one in about half a second, on one core.
    ///
    /// # Errors
    /// [`Error::Marginals`], [`Error::Levels`], [`Error::Intervals`], [`Error::LobeWidth`] outside
    /// the ranges of [`Recipe`].
    pub fn new(recipe: &Recipe) -> Result<Self, Error> {
        recipe.check()?;
        let nodes = tables(recipe).into_iter().map(|node| node.map(R::lit)).collect();
        Ok(Self { recipe: *recipe, nodes })
    }

    /// From nodes that were stored.
    pub(super) const fn from_nodes(recipe: Recipe, nodes: Vec<[R; 2]>) -> Self {
        Self { recipe, nodes }
    }

    /// What it was made by.
    pub const fn recipe(&self) -> &Recipe {
        &self.recipe
    }

    /// Density and cumulative, from 0 on, of every node: of marginal after marginal, level after
    /// level in each.
    pub fn nodes(&self) -> &[[R; 2]] {
        &self.nodes
    }

    /// Bytes that the nodes take.
    pub fn bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice())
    }

    /// One marginal on one level; the last ones for numbers beyond.
    #[doc(alias = "lobe_dictionary_marginal")]
    #[inline]
    pub fn marginal(&self, index: u32, level: u32) -> Marginal<'_, R> {
        let Recipe { marginals, levels, intervals, .. } = self.recipe;
        let (index, level) = (index.min(marginals - 1), level.min(levels - 1));
        let stride = intervals as usize + 1;
        let begin = (index as usize * levels as usize + level as usize) * stride;
        Marginal::new(&self.nodes[begin..begin + stride])
    }
}
