//! The golden tables: the library against exact values, in both precisions, within tests/budget.rs.

use crate::budget::{BUDGETS, budget_of};
use crate::tables::{Deviation, Outcome, Quantity, Rounded, Table, evaluate, read_directory};
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
        let Rounded { rows, first, refused } = evaluate::<f32>(&table, quantity).unwrap().rounded;
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

/// Why `table` is over its budget in the precision `R`: table, precision, numbers and worst row.
fn broken_budget<R: Real>(table: &Table, quantity: &Quantity) -> Option<String> {
    let name = format!("{} {}", table.stem, precision::<R>());
    let Some(budget) = budget_of(&table.stem, R::SINGLE) else {
        return Some(format!("{name}: no budget in tests/budget.rs"));
    };
    let outcome = match evaluate::<R>(table, quantity) {
        Ok(outcome) => outcome,
        Err(message) => return Some(format!("{name}: {message}")),
    };
    let Outcome { max_rel, p99_rel, worst_row, bad, .. } = outcome;
    let reason = budget.broken_by(max_rel, p99_rel, bad)?;
    let numbers = &table.rows[worst_row - 1];
    Some(format!("{name}: {reason}; worst row {worst_row}: {numbers:?}"))
}

/// All tables are judged before the first failure is reported.
fn assert_within_budget<R: Real>() {
    let broken: Vec<String> = golden_tables()
        .iter()
        .filter_map(|(table, quantity)| broken_budget::<R>(table, quantity))
        .collect();
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
        let message = broken_budget::<R>(&table, quantity)
            .unwrap_or_else(|| panic!("{} {}: unnoticed", table.stem, precision::<R>()));
        let named = format!("{} {}: max ", table.stem, precision::<R>());
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
