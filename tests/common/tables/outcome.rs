//! How far results lie from the expected values: of one row, and of a table.

use lobe::Real;

/// How far one row lies from its expected values.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Deviation {
    /// Relative error; `f64::MAX` if a result is not finite.
    pub(crate) relative: f64,
    /// Error in units of the last place of the largest expected value.
    pub(crate) ulp: f64,
    /// Whether a result is NaN, infinite, or negative where it cannot be.
    pub(crate) bad: bool,
    /// Backward error in roundings; 0 where it is not judged.
    pub(crate) roundings: f64,
}

impl Deviation {
    /// The largest difference of the row's results, over the largest expected one, which counts as
    /// no less than the smallest normal number: below it there are no digits to compare.
    pub(crate) fn of<R: Real>(got: &[R], expected: &[f64], signed: bool) -> Self {
        assert_eq!(got.len(), expected.len(), "a result for every output column");
        let scale = expected.iter().fold(R::MIN_POSITIVE.to_f64(), |scale, x| scale.max(x.abs()));
        let mut difference = 0.0_f64;
        let mut bad = false;
        for (got, &expected) in got.iter().zip(expected) {
            let got = got.to_f64();
            bad |= !got.is_finite() || (got < 0.0 && !signed);
            difference =
                if got.is_finite() { difference.max((got - expected).abs()) } else { f64::MAX };
        }
        let ulp = (difference / unit_in_last_place::<R>(scale)).min(f64::MAX);
        Self { relative: (difference / scale).min(f64::MAX), ulp, bad, roundings: 0.0 }
    }
}

/// What one table says of one precision.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    /// Number of rows that were judged.
    pub(crate) rows: usize,
    /// Largest relative error; `f64::MAX` if a result is not finite.
    pub(crate) max_rel: f64,
    /// 99th percentile of the relative error.
    pub(crate) p99_rel: f64,
    /// Largest error in units of the last place of the expected value.
    pub(crate) max_ulp: f64,
    /// Largest backward error in roundings, a power of two; 0 where it is not judged.
    pub(crate) roundings: f64,
    /// The row of the largest backward error, and among rows of one backward error that of the
    /// largest relative one; counted from 1 below the header, 0 of no row.
    pub(crate) worst_row: usize,
    /// Rows with a NaN or infinite result, or a negative one of a quantity that cannot be negative.
    pub(crate) bad: usize,
    /// Rows with inputs that the precision does not hold.
    pub(crate) rounded: Rounded,
}

/// Rows with inputs that a precision does not hold.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Rounded {
    /// Number of rows.
    pub(crate) rows: usize,
    /// Index of the first row, and of its first input.
    pub(crate) first: Option<[usize; 2]>,
    /// Rows among them whose rounded inputs are refused or whose moved values say nothing: no
    /// deviation counts them.
    pub(crate) refused: usize,
}

impl Rounded {
    /// One more row, and its first input.
    pub(crate) fn add(&mut self, row: usize, column: usize) {
        self.rows += 1;
        self.first = self.first.or(Some([row, column]));
    }
}

impl Outcome {
    /// Over rows of a table with their indices, in their order. Without a row all numbers are 0.
    pub(crate) fn of(deviations: &[(usize, Deviation)], rounded: Rounded) -> Self {
        let mut errors: Vec<f64> = deviations.iter().map(|(_, row)| row.relative).collect();
        let worst = deviations.iter().max_by(|(_, a), (_, b)| {
            a.roundings.total_cmp(&b.roundings).then(a.relative.total_cmp(&b.relative))
        });
        errors.sort_by(f64::total_cmp);
        let rows = errors.len();
        let error = |rank: usize| errors.get(rank.saturating_sub(1)).copied().unwrap_or_default();
        Self {
            rows,
            max_rel: error(rows),
            p99_rel: error((rows * 99).div_ceil(100)),
            max_ulp: deviations.iter().fold(0.0, |largest, (_, row)| row.ulp.max(largest)),
            roundings: deviations.iter().fold(0.0, |largest, (_, row)| row.roundings.max(largest)),
            worst_row: worst.map_or(0, |(row, _)| row + 1),
            bad: deviations.iter().filter(|(_, row)| row.bad).count(),
            rounded,
        }
    }
}

/// The spacing of the numbers of `R` around `x > 0`.
fn unit_in_last_place<R: Real>(x: f64) -> f64 {
    let epsilon = R::EPSILON.to_f64();
    2.0_f64.powf(x.log2().floor()) * epsilon
}
