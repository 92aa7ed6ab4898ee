//! One generator of inputs, ordinary and adversarial, for whoever needs them.
//!
//! A [`Source`] is a string of words; every string means something, and the word 0 means the
//! plainest choice, so that a shrinker that lowers words simplifies inputs. Property tests draw the
//! words, fuzzers bring them as bytes, benches and parity tests take them from a seed. Values are
//! f64; round them to f32 where inputs have to be exactly f32.
#![allow(clippy::incompatible_msrv, reason = "tests need a newer compiler, for their oracles")]

use core::f64::consts::{FRAC_PI_2, TAU};
use lobe::Footprint;

#[path = "arbitrary/input.rs"]
mod input;

pub(crate) use input::{Ellipse, LobeInput};

/// Alpha, where something changes: the ends, powers, and 1, where a projected roughness has its
/// pole.
pub(crate) const SPECIAL_ALPHAS: [f64; 8] = [0.5, 1e-4, 1e-3, 0.01, 0.1, 1.0, 2.0, 30.0];

/// The largest correlation.
pub(crate) const LARGEST_RHO: f64 = 0.9999;

/// A string of choices; after its end every choice is the plainest.
#[derive(Clone, Debug)]
pub(crate) struct Source {
    words: Vec<u64>,
    next: usize,
}

impl Source {
    /// Words that suffice for any one law.
    pub(crate) const WORDS: usize = 64;

    pub(crate) fn from_words(words: &[u64]) -> Self {
        Self { words: words.to_vec(), next: 0 }
    }

    /// From bytes, eight to a word.
    pub(crate) fn from_bytes(bytes: &[u8]) -> Self {
        let word = |chunk: &[u8]| chunk.iter().rev().fold(0, |w, &b| (w << 8) | u64::from(b));
        Self { words: bytes.chunks(8).map(word).collect(), next: 0 }
    }

    /// From a seed, by splitmix64 (Steele, Lea & Flood 2014).
    pub(crate) fn from_seed(seed: u64) -> Self {
        let mut state = seed;
        let mut word = || {
            state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            z ^ (z >> 31)
        };
        Self { words: (0..Self::WORDS).map(|_| word()).collect(), next: 0 }
    }

    fn word(&mut self) -> u64 {
        let word = self.words.get(self.next).copied().unwrap_or(0);
        self.next += 1;
        word
    }

    /// One of `count` choices.
    pub(crate) fn pick(&mut self, count: u64) -> u64 {
        self.word() % count
    }

    /// In [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        (self.word() >> 11) as f64 * (0.5 * ULP)
    }

    /// In [low, high).
    pub(crate) fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// In [low, high), evenly in the logarithm.
    pub(crate) fn log_uniform(&mut self, low: f64, high: f64) -> f64 {
        (low.ln() + (high / low).ln() * self.unit()).exp()
    }

    /// 1 or -1.
    pub(crate) fn sign(&mut self) -> f64 {
        if self.pick(2) == 0 { 1.0 } else { -1.0 }
    }

    /// An angle; 0, or a right one, now and then.
    pub(crate) fn angle(&mut self) -> f64 {
        match self.pick(6) {
            0 => 0.0,
            1 => self.pick(4) as f64 * FRAC_PI_2,
            _ => self.uniform(0.0, TAU),
        }
    }

    /// `x`, or up to three f32 or f64 away from it.
    pub(crate) fn nudged(&mut self, x: f64) -> f64 {
        let steps = self.pick(7);
        let down = steps > 3;
        let count = if down { steps - 3 } else { steps };
        let single = self.pick(2) == 0;
        (0..count).fold(x, |x, _| match (single, down) {
            (true, true) => f64::from((x as f32).next_down()),
            (true, false) => f64::from((x as f32).next_up()),
            (false, true) => x.next_down(),
            (false, false) => x.next_up(),
        })
    }

    /// Alpha, from 1e-4 to 30.
    pub(crate) fn alpha(&mut self) -> f64 {
        match self.pick(8) {
            0 | 1 => {
                let special = SPECIAL_ALPHAS[self.pick(8) as usize];
                self.nudged(special)
            }
            _ => self.log_uniform(1e-4, 30.0),
        }
    }

    /// Correlation, up to +-0.9999.
    pub(crate) fn rho(&mut self) -> f64 {
        match self.pick(6) {
            0 => 0.0,
            1 => LARGEST_RHO * self.sign(),
            2 => (1.0 - self.log_uniform(1.0 - LARGEST_RHO, 0.1)) * self.sign(),
            _ => self.uniform(-0.99, 0.99),
        }
    }

    /// A roughness: round, along the axes, or correlated.
    pub(crate) fn ellipse(&mut self) -> Ellipse {
        let x = self.alpha();
        match self.pick(4) {
            0 => Ellipse { x, y: x, rho: 0.0 },
            1 => Ellipse { x, y: self.alpha(), rho: 0.0 },
            _ => Ellipse { x, y: self.alpha(), rho: self.rho() },
        }
    }

    /// A roughness whose axes differ by no more than `aspect`, for laws on quadratures.
    pub(crate) fn mild_ellipse(&mut self, aspect: f64) -> Ellipse {
        let x = self.alpha();
        let y = self.log_uniform(x / aspect, x * aspect);
        Ellipse { x, y, rho: self.uniform(-0.9, 0.9) }
    }

    /// A vector of a length from `low` to `high`; along an axis now and then.
    pub(crate) fn vector(&mut self, low: f64, high: f64) -> [f64; 2] {
        let length = self.log_uniform(low, high);
        let (sin, cos) = self.angle().sin_cos();
        [length * cos, length * sin]
    }

    /// A slope, up to 1e3.
    pub(crate) fn slope(&mut self) -> [f64; 2] {
        match self.pick(6) {
            0 => [0.0; 2],
            1 => self.vector(1e-6, 1e3),
            _ => self.vector(1e-3, 10.0),
        }
    }

    /// A slope within some alphas of a lobe, where densities are not negligible.
    pub(crate) fn slope_near(&mut self, lobe: &LobeInput) -> [f64; 2] {
        let w = self.vector(1e-3, 8.0);
        lobe.slope_at(w)
    }

    /// A mean slope.
    pub(crate) fn mean(&mut self) -> [f64; 2] {
        match self.pick(4) {
            0 => [0.0; 2],
            1 => self.vector(1e-6, 1e3),
            _ => self.vector(1e-2, 1.0),
        }
    }

    /// Any lobe.
    pub(crate) fn lobe(&mut self) -> LobeInput {
        LobeInput { ellipse: self.ellipse(), mean: self.mean() }
    }

    /// A lobe whose axes and mean leave a quadrature its digits.
    pub(crate) fn mild_lobe(&mut self) -> LobeInput {
        let ellipse = self.mild_ellipse(30.0);
        let mean = if self.pick(3) == 0 { [0.0; 2] } else { self.vector(1e-2, 1.0) };
        LobeInput { ellipse, mean }
    }

    /// A unit direction above the surface: the normal, nearly the normal, grazing, or any.
    pub(crate) fn direction(&mut self) -> [f64; 3] {
        let z = match self.pick(8) {
            0 => return [0.0, 0.0, 1.0],
            1 => {
                let [x, y] = self.vector(1e-9, 1e-2);
                return [x, y, (1.0 - x * x - y * y).sqrt()];
            }
            2 | 3 => self.log_uniform(1e-6, 1e-2),
            _ => self.uniform(1e-2, 1.0),
        };
        let (sin, cos) = self.angle().sin_cos();
        let radius = ((1.0 - z) * (1.0 + z)).sqrt();
        [radius * cos, radius * sin, z]
    }

    /// Two directions above the surface: any, equal, a mirror pair, or both grazing and opposed.
    pub(crate) fn pair(&mut self) -> [[f64; 3]; 2] {
        let wo = self.direction();
        let [x, y, z] = wo;
        let wi = match self.pick(6) {
            0 => wo,
            1 => [-x, -y, z],
            2 => {
                let [dx, dy] = self.vector(1e-9, 1e-3);
                unit([dx - x, dy - y, z])
            }
            3 => unit([-x, -y, self.log_uniform(1e-6, 1e-3)]),
            _ => self.direction(),
        };
        [wo, wi]
    }

    /// A footprint of sizes from 1e-5 to 1e2, of every degenerate kind.
    pub(crate) fn footprint(&mut self) -> Footprint<f64> {
        let zero = [0.0; 2];
        let u = self.vector(1e-5, 1e2);
        let turned = |factor: f64| [-u[1] * factor, u[0] * factor];
        let v = match self.pick(10) {
            0 => return Footprint { u: zero, v: zero },
            1 => zero,
            2 => {
                let factor = self.uniform(-1.5, 1.5);
                u.map(|x| x * factor)
            }
            3 => turned(1.0),
            4 => {
                let (shear, height) = (self.uniform(-1.0, 1.0), self.log_uniform(1e-7, 1e-2));
                let across = turned(height);
                [shear * u[0] + across[0], shear * u[1] + across[1]]
            }
            5 => return Footprint { u: [u[0], 0.0], v: [0.0, u[1]] },
            6 => return Footprint { u: self.vector(10.0, 1e2), v: self.vector(10.0, 1e2) },
            _ => self.vector(1e-5, 1e2),
        };
        if self.pick(2) == 0 { Footprint { u, v } } else { Footprint { u: v, v: u } }
    }

    /// A kernel's covariance as two deviation vectors, whose outer products it sums.
    pub(crate) fn kernel(&mut self) -> [[f64; 2]; 2] {
        let footprint = self.footprint();
        [footprint.u, footprint.v].map(|v| v.map(|x| 0.5 * x))
    }
}

const ULP: f64 = f64::EPSILON;

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt();
    v.map(|x| x / length)
}
