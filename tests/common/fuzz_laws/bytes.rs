//! Numbers from a fuzzer's bytes: every byte string means something, and a short one ends in zeros.

use lobe::Real;

/// A reader over the fuzzer's input.
pub(crate) struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self(bytes)
    }

    pub(crate) fn byte(&mut self) -> u8 {
        let Some((&first, rest)) = self.0.split_first() else { return 0 };
        self.0 = rest;
        first
    }

    fn word<const N: usize>(&mut self) -> [u8; N] {
        core::array::from_fn(|_| self.byte())
    }

    /// A tile: near the first one or far away.
    pub(crate) fn tile(&mut self) -> [i32; 2] {
        core::array::from_fn(|_| i32::from_le_bytes(self.word()) >> (self.byte() % 32))
    }

    /// In [0, 1], 32 bits.
    pub(crate) fn fraction(&mut self) -> f64 {
        f64::from(u32::from_le_bytes(self.word())) / f64::from(u32::MAX)
    }

    /// In [low, high].
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.fraction()
    }

    /// In [low, high], the logarithm evenly distributed.
    pub(crate) fn log_between(&mut self, low: f64, high: f64) -> f64 {
        // exp may leave the interval by an ulp.
        self.between(low.ln(), high.ln()).exp().clamp(low, high)
    }

    /// Any number at all: the tag byte favors the awkward ones.
    pub(crate) fn number<R: Real>(&mut self) -> R {
        match self.byte() % 24 {
            0 => R::ZERO,
            1 => -R::ZERO,
            2 => R::ONE,
            3 => -R::ONE,
            4 => R::lit(f64::NAN),
            5 => R::lit(f64::INFINITY),
            6 => -R::lit(f64::INFINITY),
            7 => R::MAX,
            8 => -R::MAX,
            9 => R::MIN_POSITIVE,
            10 => R::MIN_POSITIVE * R::EPSILON,
            11 => R::ONE + R::EPSILON,
            12..=17 => R::lit(self.log_between(1e-9, 1e9)),
            18..=20 => -R::lit(self.log_between(1e-9, 1e9)),
            _ if R::SINGLE => R::lit(f64::from(f32::from_le_bytes(self.word()))),
            _ => R::lit(f64::from_le_bytes(self.word())),
        }
    }

    pub(crate) fn pair<R: Real>(&mut self) -> [R; 2] {
        [self.number(), self.number()]
    }

    pub(crate) fn triple<R: Real>(&mut self) -> [R; 3] {
        [self.number(), self.number(), self.number()]
    }
}
