//! How many of n details reflect, from one uniform number: a binomial draw without a loop over
//! details.
//!
//! Layer 4.

use crate::scalar::Real;
use crate::scalar::quantile::normal_quantile;

/// Steps of the inversion: at means up to 9 a count beyond has a probability below 2e-5.
pub(super) const STEPS: u32 = 24;

/// Means between these blend from the inverted distribution to the normal one.
const BLEND: [f64; 2] = [4.0, 8.0];

/// Ratio of neighboring probabilities of the lattice that the inversion is done on, and its
/// logarithm.
const LATTICE: f64 = 0.9;
const LN_LATTICE: f64 = -0.105_360_515_657_826_3;

/// Below this mean no word of 32 bits tells how rare a detail is.
const RAREST: f64 = 1.0 / 1_073_741_824.0;

/// The number of successes in `n` trials of probability `p`, as a function of one uniform number.
///
/// Between whole numbers of trials it keeps the mean: $\lceil n \rceil$ trials of $p n / \lceil n
/// \rceil$. Below a mean of 4 the distribution function is inverted, for the two probabilities of a
/// lattice (ratio 0.9) around p, and the two counts, of one uniform number, are weighted so that
/// the mean is exactly $n p$: continuous in p. From 8 on it is the normal distribution with its
/// first correction for skewness (Cornish & Fisher 1938), whose mean is $n p$, too; between the two
/// they are blended. Probabilities above 1/2 count failures instead.
///
/// Source: Zirr & Kaplanyan 2016, section 4.3. Theirs lacks a factor $\sqrt 2$ in the normal branch
/// (half the variance), and weights the lattice by logarithms (mean off by up to 1.6 %); it is
/// [`ZirrKaplanyan`](super::ZirrKaplanyan).
///
/// ```
/// use lobe::material::glint::Binomial;
/// let details = Binomial::new(100.0_f64, 0.02);
/// assert_eq!(details.draw(0.9), 0.0); // nine in ten draws have more: this one has none
/// assert!(details.draw(0.001) > 5.0);
/// ```
#[doc(alias = "LobeBinomial")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Binomial<R> {
    trials: R,
    /// Of success, or of failure if that is rarer.
    rarer: R,
    mean: R,
    failures: bool,
    /// The lattice's probabilities around `rarer`: starts of the inversion, and the weight of the
    /// second.
    low: Inversion<R>,
    high: Inversion<R>,
    of_high: R,
    /// Weight of the normal distribution.
    of_normal: R,
}

impl<R: Real> Binomial<R> {
    /// `n` trials, at least one (fewer count as that), of probability `p`, in [0, 1].
    ///
    /// Up to $10^{18}$ trials. NaN counts as one trial, or as probability 0.
    #[doc(alias = "lobe_binomial_new")]
    #[inline]
    pub fn new(n: R, p: R) -> Self {
        let (zero, one) = (R::ZERO, R::ONE);
        let n = n.max(one).min(R::LARGEST * R::LARGEST);
        let p = p.max(zero).min(one);
        let trials = ceiling(n);
        let each = p * (n / trials);
        let failures = each > R::HALF;
        let rarer = if failures { one - each } else { each };
        let mean = trials * rarer;
        let [least, most] = BLEND.map(R::lit);
        let of_normal = ((mean - least) / (most - least)).max(zero).min(one);
        let mut binomial = Self { trials, rarer, mean, failures, of_normal, ..Self::default() };
        if of_normal < one {
            // The lattice begins at 1/2, so that successes and failures meet.
            let place = (R::TWO * rarer.max(R::MIN_POSITIVE)).ln() / R::lit(LN_LATTICE);
            let steps = R::lit(f64::from(place.floor()));
            let above = (R::HALF * (steps * R::lit(LN_LATTICE)).exp()).min(R::HALF);
            let below = R::lit(LATTICE) * above;
            let step = (above - below).max(R::MIN_POSITIVE);
            binomial.of_high = ((rarer - below) / step).max(zero).min(one);
            binomial.low = Inversion::new(trials, below);
            binomial.high = Inversion::new(trials, above);
        }
        binomial
    }

    /// The number that more successes than have probability `tail`, in (0, 1): it falls as `tail`
    /// grows.
    ///
    /// Not whole where two distributions are blended. Of a mean below $2^{-30}$, which a word's
    /// tail does not resolve, the mean.
    #[doc(alias = "lobe_binomial_draw")]
    #[inline]
    pub fn draw(&self, tail: R) -> R {
        let (zero, one) = (R::ZERO, R::ONE);
        let Self { trials, rarer, mean, .. } = *self;
        let tail = if self.failures { one - tail } else { tail };
        let mut count = zero;
        if mean < R::lit(RAREST) {
            count = mean;
        } else {
            if self.of_normal < one {
                count = (one - self.of_normal) * self.inverted(tail);
            }
            if self.of_normal > zero {
                let z = normal_quantile(tail);
                let deviation = (mean * (one - rarer)).sqrt();
                let skew = (one - R::TWO * rarer) * (z * z - one) / R::lit(6.0);
                let normal = (mean + deviation * z + skew).max(zero).min(trials);
                count = count + self.of_normal * normal;
            }
        }
        if self.failures { trials - count } else { count }
    }

    /// Between the first counts that more than have a probability of at most `tail`, for both
    /// probabilities of the lattice: one walk, for the lower one never has more.
    #[inline]
    fn inverted(&self, tail: R) -> R {
        let (mut low, mut high) = (self.low, self.high);
        let (mut few, mut many) = (R::ZERO, R::ZERO);
        for _ in 0..STEPS {
            if !(tail < high.more) {
                break;
            }
            let next = many + R::ONE;
            if tail < low.more {
                few = next;
            }
            let ratio = (self.trials - many) / next;
            low = low.after(ratio);
            high = high.after(ratio);
            many = next;
        }
        let (few, many) = (few.min(self.trials), many.min(self.trials));
        few + self.of_high * (many - few)
    }
}

/// A walk along the probabilities of 0, 1, 2, ... successes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Inversion<R> {
    /// Probability of this number, of none at first, and of more.
    this: R,
    more: R,
    /// p/(1 - p).
    odds: R,
}

impl<R: Real> Inversion<R> {
    /// For a probability of at most 1/2.
    ///
    /// Where differences from 1 would have too few digits, by series: within 4e-8 and 2e-9.
    #[inline]
    fn new(trials: R, p: R) -> Self {
        let (one, small) = (R::ONE, R::lit(0.02));
        let over = |n: f64| R::ONE / R::lit(n);
        let ln_rest = if p < small {
            -(p * (one + p * (over(2.0) + p * (over(3.0) + p * over(4.0)))))
        } else {
            (one - p).ln()
        };
        let x = trials * ln_rest;
        let none = x.exp();
        let more = if x > -small {
            -(x * (one + x * over(2.0) * (one + x * over(3.0) * (one + x * over(4.0)))))
        } else {
            one - none
        };
        Self { this: none, more, odds: p / (one - p) }
    }

    /// A number on: `ratio` is that of the trials left to the number reached.
    #[inline]
    fn after(self, ratio: R) -> Self {
        let factor = ratio * self.odds;
        let this = self.this * factor;
        let more = self.more - this;
        // What follows falls by that factor and faster, so it is less than this: rounding may leave
        // more of it.
        Self { this, more: if factor < R::HALF { more.min(this) } else { more }, ..self }
    }
}

/// The smallest whole number not below n; of numbers that have no fraction left, n.
#[inline]
fn ceiling<R: Real>(n: R) -> R {
    if n > R::lit(8_388_608.0) {
        return n;
    }
    -R::lit(f64::from((-n).floor()))
}
