//! The exponential integral, in the one form that filters ask for.
//!
//! Layer 0.

use super::Real;

/// Euler's constant, to 20 digits (OEIS A001620).
const EULER: f64 = 0.577_215_664_901_532_9;

/// $1/(e^x E_2(x)) - x$ for x >= 0, where $e^x E_2(x) = 1 - x e^x E_1(x)$: from 1 at 0 to 2 at
/// infinity.
///
/// Below 1 the power series of $E_1$, above it the continued fraction $x + 2 - 2/(x + 4 - 6/(x +
/// 6 - \dots))$ (Abramowitz & Stegun 5.1.22), whose tail is this very function: no term cancels.
/// The series lasts longer, but from 1 on it loses a digit for every half of x. Terms to 1e-8 (f32)
/// and 3e-16 (f64), relative; tests/laws/scalar.rs holds both.
pub(crate) fn reciprocal_e2_tail<R: Real>(x: R) -> R {
    let (terms, depth) = if R::SINGLE { (11, 32) } else { (18, 100) };
    if x < R::ONE {
        return by_series(x, terms);
    }
    let level = |k: i32| x + R::lit(f64::from(2 * k + 2));
    let mut tail = R::ZERO;
    for k in (1..=depth).rev() {
        tail = R::lit(f64::from(k * (k + 1))) / (level(k) - tail);
    }
    // `max` drops the NaN of an infinite x.
    R::TWO - tail.max(R::ZERO)
}

/// By $E_1(x) = -\gamma - \ln x - \sum_{k \ge 1} \frac{(-x)^k}{k\, k!}$.
fn by_series<R: Real>(x: R, terms: i32) -> R {
    if !(x >= R::MIN_POSITIVE) {
        return R::ONE;
    }
    let (mut power, mut sum) = (R::ONE, R::ZERO);
    for k in 1..=terms {
        let k = R::lit(f64::from(k));
        power = -(power * x) / k;
        sum = sum + power / k;
    }
    let e1 = -(R::lit(EULER) + x.ln() + sum);
    R::ONE / (R::ONE - x * x.exp() * e1) - x
}
