//! Gauss-Legendre rules on the interval [-1/2, 1/2].
//!
//! Layer 0. Nodes and weights to 17 digits: roots of the Legendre polynomials, from mpmath. The
//! test below proves them: each rule is exact to its degree.

use super::Real;

/// Nodes and weights; the weights sum to 1.
pub(crate) struct Rule<const N: usize> {
    nodes: [f64; N],
    weights: [f64; N],
}

pub(crate) const GAUSS_TWO: Rule<2> =
    Rule { nodes: [-0.288_675_134_594_812_9, 0.288_675_134_594_812_9], weights: [0.5, 0.5] };

pub(crate) const GAUSS_FOUR: Rule<4> = Rule {
    nodes: [
        -0.430_568_155_797_026_3,
        -0.169_990_521_792_428_13,
        0.169_990_521_792_428_13,
        0.430_568_155_797_026_3,
    ],
    weights: [
        0.173_927_422_568_726_93,
        0.326_072_577_431_273_07,
        0.326_072_577_431_273_07,
        0.173_927_422_568_726_93,
    ],
};

pub(crate) const GAUSS_EIGHT: Rule<8> = Rule {
    nodes: [
        -0.480_144_928_248_768_1,
        -0.398_333_238_706_813_37,
        -0.262_766_204_958_164_5,
        -0.091_717_321_247_824_9,
        0.091_717_321_247_824_9,
        0.262_766_204_958_164_5,
        0.398_333_238_706_813_37,
        0.480_144_928_248_768_1,
    ],
    weights: [
        0.050_614_268_145_188_13,
        0.111_190_517_226_687_24,
        0.156_853_322_938_943_64,
        0.181_341_891_689_181,
        0.181_341_891_689_181,
        0.156_853_322_938_943_64,
        0.111_190_517_226_687_24,
        0.050_614_268_145_188_13,
    ],
};

impl<const N: usize> Rule<N> {
    /// Nodes and weights in this precision.
    #[inline(always)]
    pub(crate) fn points<R: Real>(&self) -> ([R; N], [R; N]) {
        (self.nodes.map(R::lit), self.weights.map(R::lit))
    }

    /// Mean of `f` over [-1/2, 1/2].
    ///
    /// All values first, then their sum: straight-line code that the compiler lays out in lanes.
    #[inline(always)]
    pub(crate) fn mean<R: Real>(&self, f: impl Fn(R) -> R) -> R {
        // Indexed, over arrays of this precision: as many lanes as it has.
        let (nodes, mut values) = self.points();
        for k in 0..N {
            values[k] = values[k] * f(nodes[k]);
        }
        values.iter().fold(R::ZERO, |sum, &value| sum + value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rule of N nodes integrates powers below 2 N exactly: the mean of x^p is (1/2)^p / (p + 1)
    /// for even p, and 0 for odd.
    fn is_exact<const N: usize>(rule: &Rule<N>) {
        for power in 0..i32::try_from(2 * N).expect("a small rule") {
            let got = rule.mean(|x: f64| x.powi(power));
            let even = if power % 2 == 0 { 1.0 } else { 0.0 };
            let want = even * 0.5_f64.powi(power) / f64::from(power + 1);
            assert!((got - want).abs() < 4e-16, "x^{power} by {N} nodes: {got} for {want}");
        }
    }

    #[test]
    fn rules_are_exact_to_their_degree() {
        is_exact(&GAUSS_TWO);
        is_exact(&GAUSS_FOUR);
        is_exact(&GAUSS_EIGHT);
    }
}
