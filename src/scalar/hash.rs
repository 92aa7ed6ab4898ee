//! Four words from four words, by integer arithmetic alone: the same bits on every machine.
//!
//! Layer 0.

use super::Real;

/// pcg4d: a step of a linear congruential generator in each word, and two rounds that mix them.
///
/// Source: Jarzynski & Olano 2020, "Hash Functions for GPU Rendering", JCGT 9(3), section 4.1.
#[inline(always)]
pub(crate) fn hash(key: [u32; 4]) -> [u32; 4] {
    let mix = |[x, y, z, w]: [u32; 4]| {
        let x = x.wrapping_add(y.wrapping_mul(w));
        let y = y.wrapping_add(z.wrapping_mul(x));
        let z = z.wrapping_add(x.wrapping_mul(y));
        [x, y, z, w.wrapping_add(y.wrapping_mul(z))]
    };
    let stepped = key.map(|word| word.wrapping_mul(1_664_525).wrapping_add(1_013_904_223));
    mix(mix(stepped).map(|word| word ^ (word >> 16)))
}

/// A word as a number in [0, 1), by its upper 24 bits: never 1.
#[inline(always)]
pub(crate) fn uniform<R: Real>(word: u32) -> R {
    R::lit(f64::from(word >> 8)) * R::power_of_two(-24)
}

/// A word as a number in (0, 1), $2^{-33}$ to $1 - 2^{-24}$: the middle of its cell of width
/// $2^{-23}$, and of $2^{-32}$ below $2^{-9}$, where rare events are told apart.
#[inline(always)]
pub(crate) fn tail<R: Real>(word: u32) -> R {
    if word < 1 << 23 {
        (R::lit(f64::from(word)) + R::HALF) * R::power_of_two(-32)
    } else {
        (R::lit(f64::from(word >> 9)) + R::HALF) * R::power_of_two(-23)
    }
}
