//! The golden tables: the library against exact values, in both precisions and under both
//! promises, within tests/budget.rs.

use crate::budget::{BUDGETS, ROUNDINGS, broken_by_roundings, budget_of};
use crate::tables::{
    Deviation, Outcome, Promise, Quantity, Rounded, Table, evaluate, read_directory,
};
use lobe::Real;
use std::collections::BTreeSet;
use std::path::Path;

/// Every table that lies in tests/golden, with its quantity.
fn golden_tables() -> Vec<(Table, &'static Quantity)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    read_directory(&folder).unwrap_or_else(|message| panic!("{message}")).tables
}

/// What these rows say.
fn outcome_of(rows: &[Deviation]) -> Outcome {
    let rows: Vec<_> = rows.iter().copied().enumerate().collect();
    Outcome::of(&rows, Rounded::default())
}

/// So that f32 is judged by exact values, nowhere by the library in f64.
#[test]
fn every_input_is_exactly_f32() {
    for (table, quantity) in golden_tables() {
        let Rounded { rows, first, refused } =
            evaluate::<f32>(&table, quantity, Promise::Forward).unwrap().rounded;
        assert_eq!((rows, first, refused), (0, None, 0), "{}", table.stem);
    }
}

#[test]
fn only_their_generators_lie_beside_the_tables() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    assert_eq!(read_directory(&folder).unwrap().ignored, ["fit.py", "generate.py"]);
}

fn precision<R: Real>() -> &'static str {
    if R::SINGLE { "f32" } else { "f64" }
}

/// Why `table` is over its budget in the precision `R`: table, precision, promise, numbers and
/// worst row.
fn broken_budget<R: Real>(table: &Table, quantity: &Quantity, promise: Promise) -> Option<String> {
    let name = format!("{} {} {}", table.stem, precision::<R>(), promise.name());
    let Some(budget) = budget_of(&table.stem, R::SINGLE) else {
        return Some(format!("{name}: no budget in tests/budget.rs"));
    };
    let outcome = match evaluate::<R>(table, quantity, promise) {
        Ok(outcome) => outcome,
        Err(message) => return Some(format!("{name}: {message}")),
    };
    let Outcome { max_rel, p99_rel, roundings, worst_row, bad, .. } = outcome;
    let reason = match promise {
        Promise::Forward => budget.broken_by(max_rel, p99_rel, bad)?,
        Promise::Backward => broken_by_roundings(roundings, bad)?,
    };
    let numbers = &table.rows[worst_row - 1];
    Some(format!("{name}: {reason}; worst row {worst_row}: {numbers:?}"))
}

/// All tables are judged before the first failure is reported.
fn assert_within_budget<R: Real>() {
    let tables = golden_tables();
    let broken = tables.iter().flat_map(|(table, quantity)| {
        let promises = quantity.promises().iter();
        promises.filter_map(|&promise| broken_budget::<R>(table, quantity, promise))
    });
    let broken: Vec<String> = broken.collect();
    assert!(broken.is_empty(), "over budget:\n{}", broken.join("\n"));
}

/// The first rows of each table, so that what follows stays quick.
fn short_tables() -> impl Iterator<Item = (Table, &'static Quantity)> {
    golden_tables().into_iter().map(|(mut table, quantity)| {
        table.rows.truncate(20);
        (table, quantity)
    })
}

/// The largest expected value of the first row that is far above the smallest normal f32.
fn largest_expected<'a>(table: &'a mut Table, quantity: &Quantity) -> &'a mut f64 {
    let expected = table.rows.iter_mut().map(|row| &mut row[quantity.inputs.len()..]);
    expected
        .filter_map(|row| row.iter_mut().max_by(|a, b| a.abs().total_cmp(&b.abs())))
        .find(|value| value.abs() > 1e-30)
        .expect("a row with digits to compare")
}

#[test]
fn single_precision_stays_within_every_budget() {
    assert_within_budget::<f32>();
}

#[test]
fn double_precision_stays_within_every_budget() {
    assert_within_budget::<f64>();
}

#[test]
fn every_budget_has_a_table_and_every_table_a_budget() {
    let tables = golden_tables();
    let tables: BTreeSet<&str> = tables.iter().map(|(table, _)| table.stem.as_str()).collect();
    let budgets: BTreeSet<&str> = BUDGETS.iter().map(|&(stem, ..)| stem).collect();
    assert_eq!(tables, budgets, "left: tests/golden/*.csv, right: tests/budget.rs");
}

/// The error left after a change by d is at least (d - b)/(1 + d), which is above b for d = 3 b.
fn assert_change_is_noticed<R: Real>(change: impl Fn(f64) -> f64) {
    for (mut table, quantity) in short_tables() {
        let max_rel = budget_of(&table.stem, R::SINGLE).expect("a budget").max_rel;
        *largest_expected(&mut table, quantity) *= 1.0 + change(max_rel);
        let message = broken_budget::<R>(&table, quantity, Promise::Forward)
            .unwrap_or_else(|| panic!("{} {}: unnoticed", table.stem, precision::<R>()));
        let named = format!("{} {} forward: max ", table.stem, precision::<R>());
        assert!(message.starts_with(&named) && message.contains("worst row"), "{message}");
    }
}

#[test]
fn one_expected_value_off_by_three_budgets_is_over_budget_in_every_table() {
    assert_change_is_noticed::<f32>(|max_rel| 3.0 * max_rel);
    assert_change_is_noticed::<f64>(|max_rel| 3.0 * max_rel);
}

#[test]
fn one_expected_value_off_by_a_thousandth_is_over_budget_in_every_table() {
    assert_change_is_noticed::<f64>(|_| 1e-3);
}

/// Moves of 16 roundings explain an error of 256 only where the result changes by 15 times as much
/// as the inputs. That is so in some rows of a table but not in all, so every row gets the error.
fn assert_backward_change_is_noticed<R: Real>() {
    let mut judged = 0;
    for (mut table, quantity) in short_tables() {
        if !quantity.promises().contains(&Promise::Backward) {
            continue;
        }
        assert_eq!(broken_budget::<R>(&table, quantity, Promise::Backward), None);
        let error = 256.0 * R::EPSILON.to_f64();
        table.rows.iter_mut().for_each(|row| *row.last_mut().expect("a result") *= 1.0 + error);
        let name = format!("{} {} backward: ", table.stem, precision::<R>());
        let message = broken_budget::<R>(&table, quantity, Promise::Backward)
            .unwrap_or_else(|| panic!("{name}unnoticed"));
        let ending = format!(" eps > {ROUNDINGS}; worst row");
        assert!(message.starts_with(&name) && message.contains(&ending), "{message}");
        judged += 1;
    }
    assert_eq!(judged, 10, "tables of default shapes");
}

#[test]
fn an_error_of_256_roundings_is_over_the_backward_budget_in_every_table_of_default_shapes() {
    assert_backward_change_is_noticed::<f32>();
    assert_backward_change_is_noticed::<f64>();
}

#[test]
fn the_worst_row_is_that_of_what_is_judged() {
    let of = |got: f64, roundings: f64| {
        let row = Deviation::of(&[got], &[1.0], false);
        Deviation { roundings, ..row }
    };
    let rows = [of(1.1, 1.0), of(1.2, 4.0), of(1.3, 4.0), of(2.0, 2.0)];
    let Outcome { roundings, worst_row, max_rel, .. } = outcome_of(&rows);
    assert_eq!((roundings, worst_row, max_rel), (4.0, 3, 1.0));
    let rows = rows.map(|row| Deviation { roundings: 0.0, ..row });
    assert_eq!((outcome_of(&rows).roundings, outcome_of(&rows).worst_row), (0.0, 4));
}

#[test]
fn one_wrong_row_in_a_hundred_passes_the_percentile_and_two_do_not() {
    let right = Deviation::of(&[1.0_f64], &[1.0], false);
    let wrong = Deviation::of(&[1.5_f64], &[1.0], false);
    let mut rows = vec![right; 100];
    rows[41] = wrong;
    let Outcome { rows: count, max_rel, p99_rel, worst_row, .. } = outcome_of(&rows);
    assert_eq!((count, max_rel, p99_rel, worst_row), (100, 0.5, 0.0, 42));
    rows[7] = wrong;
    assert_eq!(outcome_of(&rows).p99_rel, 0.5);
    let none = outcome_of(&[]);
    assert_eq!((none.rows, none.max_rel, none.p99_rel, none.worst_row), (0, 0.0, 0.0, 0));
}

fn assert_last_place_is_counted<R: Real>() {
    let next = R::ONE + R::EPSILON;
    for (got, expected) in [(next, 1.0), (R::TWO * next, 2.0), (R::HALF * next, 0.5)] {
        let right = Deviation::of(&[R::lit(expected)], &[expected], false);
        let wrong = Deviation::of(&[got], &[expected], false);
        assert_eq!(outcome_of(&[right, wrong, right]).max_ulp, 1.0, "{got:?}");
    }
}

#[test]
fn the_next_number_is_one_unit_in_the_last_place_away() {
    assert_last_place_is_counted::<f32>();
    assert_last_place_is_counted::<f64>();
}

fn assert_bad_results_are_counted<R: Real>() {
    let nan = R::lit(f64::NAN);
    let infinite = R::lit(f64::INFINITY);
    let (one, tiny) = (R::ONE, R::MIN_POSITIVE);
    for (got, signed, bad) in [
        ([one, one], false, false),
        ([nan, one], false, true),
        ([one, nan], true, true),
        ([infinite, one], true, true),
        ([one, -tiny], false, true),
        ([one, -tiny], true, false),
        ([one, -R::ZERO], false, false),
    ] {
        let row = Deviation::of(&got, &[1.0, 0.0], signed);
        assert_eq!(row.bad, bad, "{got:?}, signed {signed}");
        let finite = got.iter().all(|x| x.to_f64().is_finite());
        assert!(finite || row.relative == f64::MAX, "{got:?}: {}", row.relative);
        let good = Deviation::of(&[one], &[1.0], signed);
        let outcome = outcome_of(&[good, row, good]);
        assert_eq!(outcome.bad, usize::from(bad), "{got:?}, signed {signed}");
        // The smallest normal number below zero is within every error: only the count refuses it.
        let broken = BUDGETS[0].1.broken_by(0.0, 0.0, outcome.bad);
        assert_eq!(broken.is_some(), bad);
    }
}

#[test]
fn nan_infinite_and_negative_results_are_bad_rows() {
    assert_bad_results_are_counted::<f32>();
    assert_bad_results_are_counted::<f64>();
}
