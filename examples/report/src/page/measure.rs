//! The measures of the kernels' figures and tables: titles, axes, formats.

use super::axis::Scale;
use super::chart::Range;
use super::table::significant;
use crate::kernels::{Measures, REACH};

/// One of the measures, and how it is shown.
pub(super) struct Measure {
    pub(super) title: &'static str,
    note: &'static str,
    /// NaN where there is none.
    pub(super) value: fn(&Measures) -> f64,
    /// How far a value is from right.
    pub(super) distance: fn(f64) -> f64,
    pub(super) show: fn(f64) -> String,
    /// The vertical axis, and what values are multiplied by for it.
    pub(super) axis: Range,
    pub(super) factor: f64,
    /// The value without an error, on the axis.
    pub(super) right: Option<f64>,
}

impl Measure {
    /// What it says, in a sentence.
    pub(super) fn note(&self) -> String {
        self.note.replace("{reach}", &REACH.to_string())
    }
}

pub(super) const PEAK: Measure = Measure {
    title: "Peak error",
    note: "Filter over truth at the lobe\u{2019}s center, minus 1.",
    value: |m| m.peak_error,
    distance: f64::abs,
    show: signed_percent,
    axis: Range::new("filter / truth \u{2212} 1 at the center", Scale::Linear, [-75.0, 50.0])
        .with_unit(" %"),
    factor: 100.0,
    right: Some(0.0),
};

pub(super) const L1: Measure = Measure {
    title: "L1 error",
    note: "Integral of |filter \u{2212} truth| over the slope plane, tails included; at most 2. \
        Appendix A in f32 has none: \
           its rounding error does not fall with distance.",
    value: |m| m.l1_error.unwrap_or(f64::NAN),
    distance: f64::abs,
    show: significant,
    axis: Range::new("integral of |filter \u{2212} truth|", Scale::Logarithmic, [1e-3, 2.0]),
    factor: 1.0,
    right: None,
};

pub(super) const LARGEST: Measure = Measure {
    title: "Largest relative error",
    note: "Largest |filter / truth \u{2212} 1| from the center to {reach} alphas.",
    value: |m| m.largest_error,
    distance: f64::abs,
    show: percent,
    axis: Range::new("largest |filter / truth \u{2212} 1|", Scale::Logarithmic, [0.1, 3e4])
        .with_unit(" %"),
    factor: 100.0,
    right: None,
};

pub(super) const TAIL: Measure = Measure {
    title: "Tail ratio",
    note: "Filter over truth at {reach} alphas from the center; for the largest pixels that is \
        still near their edge.",
    value: |m| m.tail_ratio,
    distance: |ratio| ratio.ln().abs(),
    show: |ratio| format!("{}\u{d7}", significant(ratio)),
    axis: Range::new("filter / truth in the tail", Scale::Logarithmic, [0.1, 100.0]),
    factor: 1.0,
    right: Some(1.0),
};

/// In the order of the page.
pub(super) const MEASURES: [Measure; 4] = [PEAK, L1, LARGEST, TAIL];

/// Of what is not negative; what f64 and its quadrature cannot tell from 0 is so much less than
/// shown.
fn percent(x: f64) -> String {
    match x {
        x if x > 0.0 && x < ROUNDING => format!("<{} %", significant(100.0 * ROUNDING)),
        x => format!("{} %", significant(100.0 * x)),
    }
}

/// The relative error of the truths, at most.
const ROUNDING: f64 = 1e-11;

/// With a sign, and a true minus.
pub(super) fn signed_percent(x: f64) -> String {
    let sign = match x {
        x if x >= ROUNDING => "+",
        x if x <= -ROUNDING => "\u{2212}",
        _ => "",
    };
    format!("{sign}{}", percent(x.abs()))
}

#[cfg(test)]
mod tests {
    use super::{TAIL, signed_percent};

    #[test]
    fn signs_are_shown_and_nothing_has_none() {
        assert_eq!(signed_percent(0.24), "+24.0 %");
        assert_eq!(signed_percent(-0.031), "\u{2212}3.10 %");
        assert_eq!(signed_percent(0.0), "0 %");
        assert_eq!(signed_percent(-1e-14), "<1.0e-9 %");
    }

    #[test]
    fn a_tail_of_half_is_as_wrong_as_one_of_two_and_none_is_worse_than_any() {
        let distance = TAIL.distance;
        assert!((distance(0.5) - distance(2.0)).abs() < 1e-15);
        assert!(distance(0.0) > distance(1e9));
    }
}
