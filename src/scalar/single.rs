//! An f32, or a number that passes for one: what the polynomials of f32 are written over.
//!
//! Layer 0. They read and make bits, so [`Real`] is not enough; the feature `probe` has an f32 of
//! its own.

use super::Real;

/// A precision with the bits of an f32.
pub(crate) trait Single: Real {
    /// The constant `x`, as it is.
    fn of(x: f32) -> Self;
    /// The bits of this number.
    fn bits(self) -> u32;
    /// The number with these bits.
    #[inline(always)]
    fn of_bits(bits: u32) -> Self {
        Self::of(f32::from_bits(bits))
    }
}

impl Single for f32 {
    #[inline(always)]
    fn of(x: f32) -> Self {
        x
    }
    #[inline(always)]
    fn bits(self) -> u32 {
        self.to_bits()
    }
}
