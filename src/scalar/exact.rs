//! Sums and products with their rounding errors: what keeps f32 determinants and dot products true.
//!
//! Layer 0. Written without fused multiply-add, which is a slow library call on targets that lack
//! it; the split by bit mask cannot overflow, and no compiler can fuse it away. What shader
//! compilers could fold, fuse or factor is kept (`Internal::kept`): under fast math they take
//! sums in any order, so that every partial sum that is exact stands alone.

use super::Real;

/// `a + b` as rounded sum and exact error (Knuth 1969, TwoSum).
#[inline(always)]
pub(crate) fn two_sum<R: Real>(a: R, b: R) -> (R, R) {
    let sum = (a + b).kept();
    let b_part = (sum - a).kept();
    let a_part = (sum - b_part).kept();
    sum.with_rest((a - a_part).kept() + (b - b_part).kept())
}

/// `a * b` as rounded product and its error (Dekker 1971, with the split of
/// `Internal::upper_half`).
///
/// The error is exact in f32, and to one unit of twice the precision in f64, as long as it does
/// not underflow.
#[inline(always)]
pub(crate) fn two_product<R: Real>(a: R, b: R) -> (R, R) {
    let product = (a * b).kept();
    let (a_high, b_high) = (a.upper_half(), b.upper_half());
    let (a_low, b_low) = (a - a_high, b - b_high);
    let first = (a_high * b_high - product).kept();
    let second = (first + a_high * b_low).kept();
    let third = (second + a_low * b_high).kept();
    product.with_rest(third + a_low * b_low)
}

/// `a b + c d` within 1.5 ulp of the result, whatever cancels (Kahan; Jeannerod et al. 2013).
#[inline(always)]
pub(crate) fn sum_of_products<R: Real>(a: R, b: R, c: R, d: R) -> R {
    let (p, p_error) = two_product(a, b);
    let (q, q_error) = two_product(c, d);
    (p + q).kept() + (p_error + q_error)
}

/// `a b - c d` within 1.5 ulp of the result, whatever cancels.
#[inline(always)]
pub(crate) fn difference_of_products<R: Real>(a: R, b: R, c: R, d: R) -> R {
    sum_of_products(a, b, -c, d)
}

/// `x + a b + c d` as if computed in twice the precision (Ogita, Rump & Oishi 2005, Dot2).
#[inline(always)]
pub(crate) fn add_products<R: Real>(x: R, a: R, b: R, c: R, d: R) -> R {
    let (p, p_error) = two_product(a, b);
    let (q, q_error) = two_product(c, d);
    let (s, s_error) = two_sum(x, p);
    let (t, t_error) = two_sum(s, q);
    t + ((p_error + q_error) + (s_error + t_error))
}

/// `x + a b` as an unevaluated pair, high and low.
#[inline(always)]
pub(crate) fn add_product<R: Real>(x: R, a: R, b: R) -> (R, R) {
    let (p, p_error) = two_product(a, b);
    let (s, s_error) = two_sum(x, p);
    (s, s_error + p_error)
}

/// Cross product `u_x v_y - u_y v_x`, within 1.5 ulp.
#[inline(always)]
pub(crate) fn cross<R: Real>(u: [R; 2], v: [R; 2]) -> R {
    difference_of_products(u[0], v[1], u[1], v[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_determinant_survives_total_cancellation() {
        // 1 + 2^-23 squared minus its rounded self: the naive difference is 0.
        let x = 1.0_f32 + f32::EPSILON;
        let det = difference_of_products(x, x, x * x, 1.0);
        assert_eq!(f64::from(det), f64::from(x).powi(2) - f64::from(x * x));
    }

    #[test]
    fn the_error_of_a_product_is_exact_in_f32() {
        for (a, b) in [(1.1_f32, 3.3), (1e-9, -7.7), (12345.678, 0.001_234)] {
            let (p, e) = two_product(a, b);
            assert_eq!(f64::from(p) + f64::from(e), f64::from(a) * f64::from(b), "{a} * {b}");
        }
    }
}
