//! Elementary functions against correctly rounded ones (pxfm), the standard library and quadrature.

use crate::common::arbitrary::Source;
use crate::common::quadrature::trapezoid;
use crate::common::{check, ensure, near};
use core::f64::consts::FRAC_2_SQRT_PI;
use core::fmt::Debug;
use lobe::Real;
use lobe::filter::gaussian_peak_alpha;
use proptest::test_runner::TestCaseResult;

/// A few roundings and the polynomial's own error.
const FEW: f64 = 4.0;

/// Relative to `FEW` ulp of the precision, down to its smallest numbers.
fn rounds<R: Real>(got: R, want: f64, inputs: &dyn Debug) -> TestCaseResult {
    let (eps, tiny) = (R::EPSILON.to_f64(), R::MIN_POSITIVE.to_f64());
    near(got.to_f64(), want, FEW * eps * want.abs().max(tiny), inputs)
}

/// A number of either sign, of any size up to `largest`.
fn number<R: Real>(source: &mut Source, largest: f64) -> R {
    let x = match source.pick(4) {
        0 => source.uniform(0.0, largest),
        1 => source.uniform(0.0, 4.0_f64.min(largest)),
        2 => source.log_uniform(1e-30, largest),
        _ => {
            let whole = source.pick(32) as f64 * 0.25;
            source.nudged(whole.min(largest))
        }
    };
    R::lit(x * source.sign())
}

fn exponentials<R: Real>(source: &mut Source, largest: f64) -> TestCaseResult {
    let x: R = number(source, largest);
    rounds(x.exp(), pxfm::f_exp(x.to_f64()), &x)
}

#[test]
fn exp_is_exp() {
    check(50_000, |source| exponentials::<f64>(source, 708.0));
    check(50_000, |source| exponentials::<f32>(source, 87.0));
}

/// Powers of two that are not about to turn subnormal are powers of two, others 0. Products are
/// products, or too small for a number.
fn decays<R: Real>(source: &mut Source, largest: f64) -> TestCaseResult {
    let (x, y): (R, R) = (-number::<R>(source, largest).abs(), number(source, largest));
    let least = if R::SINGLE { -126.0 } else { -1022.0 };
    if x < R::lit(least) {
        ensure(x.exp2_of_negative() == R::ZERO, "0 below the least exponent", &x)?;
    } else {
        rounds(x.exp2_of_negative(), pxfm::f_exp2(x.to_f64()), &x)?;
    }
    let (a, b) = (x.exp2_of_negative(), (-y.abs()).exp2_of_negative());
    let (product, want) = (a.product_or_zero(b), a * b);
    let lost = product == R::ZERO && want < R::MIN_POSITIVE;
    ensure(product == want || lost, "a product, or 0", &(a, b))
}

#[test]
fn exp2_of_negative_numbers_is_exp2() {
    check(50_000, |source| decays::<f64>(source, 1100.0));
    check(50_000, |source| decays::<f32>(source, 150.0));
    assert_eq!((fallen(-127.0_f32), fallen(-1023.0_f64)), (0.0, 0.0));
    assert_eq!((fallen(f32::NEG_INFINITY), fallen(f32::NAN), fallen(0.0_f32)), (0.0, 0.0, 1.0));
    assert_eq!((fallen(f64::NEG_INFINITY), fallen(0.0_f64)), (0.0, 1.0));
}

/// The trait that has it can be named in no bound but that of `Real`.
fn fallen<R: Real>(x: R) -> R {
    x.exp2_of_negative()
}

/// A positive number: any, near 1, subnormal, or at a power of two or of root two, where the
/// reduction steps.
fn positive<R: Real>(source: &mut Source) -> R {
    let (least, largest) = (R::MIN_POSITIVE.to_f64(), R::MAX.to_f64());
    let power = |exponent: u64| f64::from(exponent as u32).exp2();
    let x = match source.pick(6) {
        0 => source.uniform(0.0, 10.0),
        1 => 1.0 + source.log_uniform(1e-12, 0.5) * source.sign(),
        2 => source.unit() * least,
        3 => {
            let whole = power(source.pick(100)) / power(source.pick(100));
            source.nudged(whole)
        }
        4 => {
            let root = power(source.pick(100)) * core::f64::consts::FRAC_1_SQRT_2;
            source.nudged(root)
        }
        // The quotient of the two is no f64.
        _ => source.uniform(least.ln(), largest.ln()).exp(),
    };
    R::lit(x)
}

/// One rounding away from the correctly rounded one: ours is less than a unit wrong.
fn logarithms<R: Real>(source: &mut Source) -> TestCaseResult {
    let x: R = positive(source);
    if x == R::ZERO {
        return ensure(x.ln() == R::lit(f64::NEG_INFINITY), "minus infinity at 0", &x);
    }
    let want = pxfm::f_log(x.to_f64());
    near(x.ln().to_f64(), want, R::EPSILON.to_f64() * want.abs(), &x)?;
    ensure((x.ln() >= R::ZERO) == (x >= R::ONE), "0 at 1, with its sign on both sides", &x)?;
    // ln undoes exp to the rounding of what it is given.
    let y: R = number(source, if R::SINGLE { 87.0 } else { 708.0 });
    let tolerance = R::EPSILON.to_f64() * (1.0 + y.abs().to_f64());
    near(y.exp().ln().to_f64(), y.to_f64(), tolerance, &y)?;
    // And exp undoes ln, to the rounding of the logarithm, which it multiplies by its size.
    let tolerance = R::EPSILON.to_f64() * (2.0 + want.abs());
    let back = x.ln().exp().to_f64() / x.to_f64();
    ensure((back - 1.0).abs() <= tolerance || x < R::MIN_POSITIVE, "exp undoes ln", &(x, back))
}

#[test]
fn ln_is_ln() {
    check(100_000, logarithms::<f64>);
    check(100_000, logarithms::<f32>);
}

/// e^x E_2(x) = 1 - x e^x E_1(x), by what is made of it: alpha'^2 = k/(e^x E_2(x)), k = 2 sigma^2,
/// x = alpha^2/k.
fn exponential_integrals<R: Real>(source: &mut Source) -> TestCaseResult {
    let (alpha, sigma) = match source.pick(4) {
        0 => (source.alpha(), source.alpha()),
        1 => (0.1, source.log_uniform(0.01, 0.5)),
        // The bound between series and fraction, x = 1.
        2 => (source.nudged(0.1), source.nudged(0.1 * 0.5_f64.sqrt())),
        _ => (source.log_uniform(1e-9, 1e9), source.log_uniform(1e-9, 1e9)),
    };
    let (alpha, sigma): (R, R) = (R::lit(alpha), R::lit(sigma));
    let proxy = gaussian_peak_alpha(alpha, sigma).expect("in range").to_f64();
    let (alpha, sigma) = (alpha.to_f64(), sigma.to_f64());
    let x = alpha * alpha / (2.0 * sigma * sigma);
    // x e^x E2(x) is the integral of e^-u/(1 + u/x)^2; with u = e^y analytic for |Im y| < pi/2.
    let mut integrand = |y: f64| {
        let u = y.exp();
        u * (-u).exp() / ((1.0 + u / x) * (1.0 + u / x))
    };
    let reach = 36.0 + x.ln().abs();
    let want = alpha / trapezoid(&mut integrand, reach, 0.0625).sqrt();
    // Near x = 1 the series multiplies a rounding by five; the reference, a sum of a thousand
    // terms, errs by 2e-15.
    near(proxy, want, (2.0 * FEW * R::EPSILON.to_f64() + 2e-15) * want, &(alpha, sigma, x))
}

#[test]
fn the_exponential_integral_is_its_integral() {
    check(20_000, exponential_integrals::<f64>);
    check(20_000, exponential_integrals::<f32>);
}

fn arctangents<R: Real>(source: &mut Source) -> TestCaseResult {
    let (x, y): (R, R) = (number(source, 1e6), number(source, 1e6));
    rounds(x.atan(), pxfm::f_atan(x.to_f64()), &x)?;
    if x == R::ZERO && y == R::ZERO {
        return ensure(y.atan2(x) == R::ZERO, "0 at the origin, as documented", &(x, y));
    }
    let angle = y.atan2(x).to_f64();
    // A zero has no sign, as documented.
    let want = pxfm::f_atan2(y.to_f64() + 0.0, x.to_f64());
    rounds(y.atan2(x), want, &(x, y))?;
    ensure(angle.abs() <= R::PI.to_f64(), "no more than half a turn", &(x, y, angle))
}

#[test]
fn atan_is_atan() {
    check(50_000, arctangents::<f64>);
    check(50_000, arctangents::<f32>);
}

/// erfc's argument x multiplies a rounding by 2 x^2 unless it is compensated, as here.
fn complements<R: Real>(source: &mut Source, largest: f64) -> TestCaseResult {
    let x: R = number(source, largest);
    let exact = x.to_f64();
    let (eps, tiny) = (R::EPSILON.to_f64(), R::MIN_POSITIVE.to_f64());
    let want = pxfm::f_erfc(exact);
    near(x.erfc().to_f64(), want, 2.0 * FEW * eps * want.max(tiny), &x)?;
    let x = x.abs();
    let want = pxfm::f_erfcx(x.to_f64());
    near(x.erfcx().to_f64(), want, 2.0 * FEW * eps * want, &x)
}

#[test]
fn erfc_and_erfcx_are_theirs() {
    check(50_000, |source| complements::<f64>(source, 26.0));
    check(50_000, |source| complements::<f32>(source, 9.2));
}

/// ierfcx(x) = (2/sqrt pi) integral over t > 0 of t e^(-t^2 - 2 x t): no cancellation. With t =
/// e^y, the integrand is analytic for |Im y| < pi/4.
fn integrals<R: Real>(source: &mut Source) -> TestCaseResult {
    let x: R = number::<R>(source, 1e3).abs();
    let exact = x.to_f64();
    let integrand_of = |v: f64| {
        move |y: f64| {
            let t = y.exp();
            t * t * (-t * t - 2.0 * v * t).exp()
        }
    };
    let want = trapezoid(&mut integrand_of(exact), 32.0, 0.0625) * FRAC_2_SQRT_PI;
    let few = 4.0 * FEW * R::EPSILON.to_f64() + 1e-15;
    near(x.ierfcx().to_f64(), want, few * want, &x)?;
    let square = x * x;
    // v of the rounded square; the integral is even in v but for an addend of -v.
    let v = square.to_f64().sqrt();
    let plain = (-v * v).exp() * trapezoid(&mut integrand_of(v), 32.0, 0.0625) * FRAC_2_SQRT_PI;
    let excess = plain * (2.0 * v + plain);
    near(square.ierfc_excess().to_f64(), excess, few * (v * v + excess), &x)
}

#[test]
fn ierfcx_is_the_integral_of_erfc() {
    check(3000, integrals::<f64>);
    check(3000, integrals::<f32>);
}

fn identities<R: Real>(source: &mut Source) -> TestCaseResult {
    let x: R = number(source, 5.0);
    let two = (x.erfc() + (-x).erfc()).to_f64();
    near(two, 2.0, 4.0 * FEW * R::EPSILON.to_f64(), &x)?;
    ensure((-x).atan() == -x.atan(), "atan is odd", &x)?;
    let one = (x.exp() * (-x).exp()).to_f64();
    near(one, 1.0, 4.0 * FEW * R::EPSILON.to_f64(), &x)?;
    let (sin, cos) = x.sin_cos();
    near((sin * sin + cos * cos).to_f64(), 1.0, FEW * R::EPSILON.to_f64(), &x)?;
    let high = x.upper_half();
    let low = x - high;
    // Subnormal numbers have no lower half to speak of.
    let small = low.abs() <= x.abs() * R::lit(0.001) || x.abs() < R::MIN_POSITIVE;
    let whole = high + low == x && small;
    ensure(whole, "a number is the sum of its halves", &x)
}

#[test]
fn elementary_identities_hold() {
    check(20_000, identities::<f64>);
    check(20_000, identities::<f32>);
}

fn edges<R: Real>() {
    let (zero, one, infinity) = (R::ZERO, R::ONE, R::lit(f64::INFINITY));
    assert_eq!((zero.exp(), zero.erfc(), zero.erfcx()), (one, one, one));
    assert_eq!(((-infinity).exp(), infinity.exp()), (zero, infinity));
    assert_eq!((infinity.erfc(), (-infinity).erfc()), (zero, R::TWO));
    assert_eq!((zero.atan2(zero), zero.atan2(one)), (zero, zero));
    assert_eq!((zero.atan2(-one), one.atan2(zero)), (R::PI, R::HALF * R::PI));
    let nan = |x: R| !(x >= zero) && !(x < zero);
    assert_eq!((one.ln(), zero.ln(), infinity.ln()), (zero, -infinity, infinity));
    assert_eq!((-zero).ln(), -infinity);
    assert!([-one, -R::MIN_POSITIVE, -infinity, R::lit(f64::NAN)].iter().all(|x| nan(x.ln())));
    assert!(R::lit(f64::NAN).exp().is_finite() == R::lit(f64::NAN).is_finite());
}

#[test]
fn elementary_functions_have_their_values_at_the_edges() {
    edges::<f64>();
    edges::<f32>();
}
