//! The one table of error budgets: how wrong each golden table's quantity may come out.
//!
//! Every table has a forward budget, of relative errors; where matrix entries make a shape, it
//! holds for `slope::Compensated`. Densities, areas, masking and BRDFs by the default shapes of
//! such entries have one backward budget, of roundings.
//!
//! Loosening a number here is a change that someone reviews. The numbers are requirements, set
//! before the code was measured: some are far looser than what tests/laws/golden.rs finds.

/// Relative error allowed in one table at one precision: over all rows, and for 99 % of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Budget {
    /// Largest relative error of any row.
    pub(crate) max_rel: f64,
    /// 99th percentile of the relative error.
    pub(crate) p99_rel: f64,
}

impl Budget {
    /// What a measurement exceeds, in words; `bad` counts rows that no budget allows. NaN exceeds.
    pub(crate) fn broken_by(self, max_rel: f64, p99_rel: f64, bad: usize) -> Option<String> {
        let mut reasons = Vec::new();
        if !(max_rel <= self.max_rel) {
            reasons.push(format!("max {max_rel:.1e} > {:.0e}", self.max_rel));
        }
        if !(p99_rel <= self.p99_rel) {
            reasons.push(format!("p99 {p99_rel:.1e} > {:.0e}", self.p99_rel));
        }
        if bad > 0 {
            reasons.push(format!("{bad} bad rows"));
        }
        (!reasons.is_empty()).then(|| reasons.join(", "))
    }
}

/// The most roundings by which inputs and result may have to be moved for a result to be exact: the
/// promise of every default shape, in both precisions.
pub(crate) const ROUNDINGS: f64 = 16.0;

/// What a default shape's results exceed, in words: `roundings` is the largest backward error, and
/// `bad` counts rows that no budget allows. NaN exceeds.
pub(crate) fn broken_by_roundings(roundings: f64, bad: usize) -> Option<String> {
    let mut reasons = Vec::new();
    if !(roundings <= ROUNDINGS) {
        reasons.push(format!("{roundings} eps > {ROUNDINGS}"));
    }
    if bad > 0 {
        reasons.push(format!("{bad} bad rows"));
    }
    (!reasons.is_empty()).then(|| reasons.join(", "))
}

const fn budget(max_rel: f64, p99_rel: f64) -> Budget {
    Budget { max_rel, p99_rel }
}

/// Densities and areas of GGX in f32: a few roundings, however correlated the roughness.
const GGX_SINGLE: Budget = budget(3e-5, 3e-6);
/// The same for Beckmann: the exponent, up to 87, multiplies the relative error.
const BECKMANN_SINGLE: Budget = budget(2e-4, 2e-5);
/// Lambda in f32; asked for loosely, as Walter's fit is off by 100 % in places.
const LAMBDA_SINGLE: Budget = budget(1e-2, 2e-4);
/// Means over polygons in f32: 1e-5 near the lobe, 1e-3 anywhere.
const MEAN_SINGLE: Budget = budget(1e-3, 1e-5);
/// The one number of a proxy in f32: a few roundings.
const PROXY_SINGLE: Budget = budget(3e-6, 1e-6);
/// Closed forms in f64.
const DOUBLE: Budget = budget(1e-12, 1e-12);
/// Quadratures in f64.
const MEAN_DOUBLE: Budget = budget(1e-9, 1e-9);
/// Jacobians in f32, relative to the largest entry: sums of a few terms of one size.
const MATRIX_SINGLE: Budget = budget(1e-5, 2e-6);

/// Table stem, f32 budget, f64 budget.
pub(crate) const BUDGETS: &[(&str, Budget, Budget)] = &[
    ("beckmann_p22", BECKMANN_SINGLE, DOUBLE),
    ("ggx_p22", GGX_SINGLE, DOUBLE),
    ("beckmann_d", BECKMANN_SINGLE, DOUBLE),
    ("ggx_d", GGX_SINGLE, DOUBLE),
    ("beckmann_projected_area", BECKMANN_SINGLE, DOUBLE),
    ("ggx_projected_area", GGX_SINGLE, DOUBLE),
    ("beckmann_lambda", LAMBDA_SINGLE, DOUBLE),
    ("ggx_lambda", LAMBDA_SINGLE, DOUBLE),
    ("beckmann_brdf", BECKMANN_SINGLE, DOUBLE),
    ("ggx_brdf", GGX_SINGLE, DOUBLE),
    ("beckmann_rectangle_mean", MEAN_SINGLE, MEAN_DOUBLE),
    ("ggx_rectangle_mean", MEAN_SINGLE, MEAN_DOUBLE),
    ("ggx_parallelogram_mean", MEAN_SINGLE, MEAN_DOUBLE),
    ("ggx_gaussian_mean", MEAN_SINGLE, MEAN_DOUBLE),
    ("ggx_proxy_rectangle_alpha", PROXY_SINGLE, DOUBLE),
    ("ggx_proxy_gaussian_alpha", PROXY_SINGLE, DOUBLE),
    ("jacobians", MATRIX_SINGLE, DOUBLE),
    ("half_slope_jacobian", MATRIX_SINGLE, DOUBLE),
    ("chermain_m", MATRIX_SINGLE, DOUBLE),
];

/// The budget of a table, by stem, in f32 (`single`) or f64.
pub(crate) fn budget_of(stem: &str, single: bool) -> Option<Budget> {
    let &(_, in_single, in_double) = BUDGETS.iter().find(|(name, ..)| *name == stem)?;
    Some(if single { in_single } else { in_double })
}

#[test]
fn each_stem_has_one_budget_whose_percentile_is_no_looser_than_its_maximum() {
    for (index, &(stem, ..)) in BUDGETS.iter().enumerate() {
        assert!(BUDGETS[..index].iter().all(|(other, ..)| *other != stem), "{stem} appears twice");
        for single in [true, false] {
            let Budget { max_rel, p99_rel } = budget_of(stem, single).expect("a listed stem");
            assert!(0.0 < p99_rel && p99_rel <= max_rel && max_rel < 0.1, "{stem}, f32 {single}");
        }
    }
    assert_eq!(budget_of("no_such_table", true), None);
}

#[test]
fn a_budget_is_broken_by_each_of_its_numbers_alone() {
    let budget = budget(1e-3, 1e-5);
    assert_eq!(budget.broken_by(1e-3, 1e-5, 0), None);
    for (max_rel, p99_rel, bad, reason) in [
        (2e-3, 0.0, 0, "max 2.0e-3 > 1e-3"),
        (0.0, 2e-5, 0, "p99 2.0e-5 > 1e-5"),
        (0.0, 0.0, 3, "3 bad rows"),
        (f64::NAN, 0.0, 0, "max NaN > 1e-3"),
    ] {
        assert_eq!(budget.broken_by(max_rel, p99_rel, bad).as_deref(), Some(reason));
    }
}

#[test]
fn the_backward_budget_is_broken_by_each_of_its_numbers_alone() {
    assert_eq!(broken_by_roundings(16.0, 0), None);
    for (roundings, bad, reason) in [
        (32.0, 0, "32 eps > 16"),
        (f64::INFINITY, 0, "inf eps > 16"),
        (f64::NAN, 0, "NaN eps > 16"),
        (1.0, 2, "2 bad rows"),
    ] {
        assert_eq!(broken_by_roundings(roundings, bad).as_deref(), Some(reason));
    }
}
