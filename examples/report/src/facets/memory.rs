//! Bytes of dictionaries: the library's, and as published.

use lobe::Error;
use lobe::material::multilobe::Recipe;
use serde::Serialize;

use super::dictionary::Precision;

/// Bytes.
#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Memory {
    /// Density and cumulative in f32, filter included.
    pub(crate) ours: usize,
    /// Half-precision densities, without a filter and with its mips.
    pub(crate) published: usize,
    pub(crate) mips: usize,
}

impl Memory {
    pub(super) fn counted() -> Result<Self, Error> {
        let Recipe { marginals, levels, intervals, .. } = Recipe::default();
        let texels = |one: u32| 2 * (marginals * levels * one) as usize;
        // 64 + 32 + ... + 1.
        let chain = 2 * intervals - 1;
        Ok(Self {
            ours: f32::dictionary()?.bytes(),
            published: texels(intervals),
            mips: texels(chain),
        })
    }
}
