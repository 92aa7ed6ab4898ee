//! What the law tests share: inputs, quadrature, independent references, and a runner.
#![allow(dead_code, reason = "each law file uses a part of it")]

pub(crate) mod arbitrary;
#[cfg(feature = "glint")]
pub(crate) mod facets;
#[cfg(feature = "glint")]
pub(crate) mod marginals;
pub(crate) mod quadrature;
pub(crate) mod reference;
#[allow(unreachable_pub, reason = "the package of the GPU tests has it, too")]
pub(crate) mod size;

use arbitrary::Source;
use core::fmt::Debug;
use proptest::strategy::Strategy;
use proptest::test_runner::{
    Config, RngAlgorithm, RngSeed, TestCaseError, TestCaseResult, TestRunner,
};

/// One unit of rounding of f64 and of f32.
pub(crate) const ULP: f64 = f64::EPSILON;
pub(crate) const ULP_SINGLE: f64 = f32::EPSILON as f64;

/// Numbers that are none, have no sign or no size, lie at an end of a range, or are as large as
/// they get in f32.
pub(crate) const ODD: [f64; 17] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -0.0,
    1e-45,
    1e-30,
    1e-9,
    0.3,
    0.5,
    1.0,
    -1.0,
    4.0,
    -4.0,
    1e9,
    1e30,
    f32::MAX as f64,
];

/// Runs a law on its inputs, the same ones every time: on `full` of them in a long run, on a share
/// in an ordinary one ([`size::cases`]). A failure is shrunk towards plain inputs.
#[track_caller]
pub(crate) fn check(full: u32, law: impl Fn(&mut Source) -> TestCaseResult) {
    check_all(size::cases(full), law);
}

/// Runs a law on all of its inputs in every run: one whose violations are too rare for a share of
/// them.
#[track_caller]
pub(crate) fn check_all(cases: u32, law: impl Fn(&mut Source) -> TestCaseResult) {
    let config = Config {
        cases,
        rng_algorithm: RngAlgorithm::ChaCha,
        rng_seed: RngSeed::Fixed(0x10be),
        failure_persistence: None,
        max_shrink_iters: 4096,
        max_shrink_time: 20_000,
        ..Config::default()
    };
    let words = proptest::collection::vec(proptest::num::u64::ANY, Source::WORDS)
        .prop_map(|words| Source::from_words(&words));
    // The words themselves say nothing: laws put their inputs into the message.
    let outcome = TestRunner::new(config).run(&words, |mut source| law(&mut source));
    if let Err(failure) = outcome {
        let text = failure.to_string();
        let end = text.find("minimal failing input").unwrap_or(text.len());
        panic!("{}", &text[..end]);
    }
}

/// The law holds, or fails with its inputs.
pub(crate) fn ensure(holds: bool, what: &str, inputs: &dyn Debug) -> TestCaseResult {
    if holds { Ok(()) } else { Err(TestCaseError::fail(format!("{what}, inputs {inputs:?}"))) }
}

/// `got` lies within `tolerance` of `want`; false for NaN.
pub(crate) fn near(got: f64, want: f64, tolerance: f64, inputs: &dyn Debug) -> TestCaseResult {
    let error = (got - want).abs();
    if error <= tolerance {
        return Ok(());
    }
    Err(TestCaseError::fail(format!(
        "got {got:e}, want {want:e}: off by {error:e} (relative {:e}), allowed {tolerance:e}, \
            inputs {inputs:?}",
        error / want.abs()
    )))
}

/// Entries of a matrix agree within `tolerance`.
pub(crate) fn near_all(
    got: &[f64],
    want: &[f64],
    tolerance: f64,
    inputs: &dyn Debug,
) -> TestCaseResult {
    for (got, want) in got.iter().zip(want) {
        near(*got, *want, tolerance, inputs)?;
    }
    Ok(())
}
