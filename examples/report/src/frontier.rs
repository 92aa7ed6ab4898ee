//! The line to beat: what plain supersampling pays for a given error.

use std::fmt;

use serde::Serialize;

/// What a picture costs, in nanoseconds or in samples, and its error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Point {
    pub(crate) cost: f64,
    pub(crate) error: f64,
}

/// What supersampling pays for an error, as far as its sample counts tell.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Price {
    /// Between two sample counts, by interpolation.
    About(f64),
    /// The largest count does not get there.
    MoreThan(f64),
    /// One sample is already as good.
    LessThan(f64),
}

/// Supersampling by increasing sample count.
pub(crate) struct Frontier(pub(crate) Vec<Point>);

impl Frontier {
    /// The price of an error, straight lines between the points on logarithmic axes.
    pub(crate) fn price(&self, error: f64) -> Option<Price> {
        let (first, last) = (self.0.first()?, self.0.last()?);
        if first.error <= error {
            return Some(Price::LessThan(first.cost));
        }
        let crossing = self.0.windows(2).find(|pair| pair[1].error <= error);
        Some(match crossing {
            Some(pair) => Price::About(interpolate(pair[0], pair[1], error)),
            None => Price::MoreThan(last.cost),
        })
    }
}

/// The cost at which the line through two points of falling error, straight on logarithmic axes,
/// has this error.
fn interpolate(before: Point, after: Point, error: f64) -> f64 {
    if after.error <= 0.0 || error <= 0.0 {
        return after.cost;
    }
    let t = (before.error / error).ln() / (before.error / after.error).ln();
    before.cost * (after.cost / before.cost).powf(t)
}

/// Which points no other beats in both cost and error.
pub(crate) fn pareto(points: &[Point]) -> Vec<bool> {
    let beats = |a: &Point, b: &Point| a.cost < b.cost && a.error < b.error;
    points.iter().map(|point| !points.iter().any(|other| beats(other, point))).collect()
}

impl Price {
    /// In multiples of `unit`.
    pub(crate) fn over(self, unit: f64) -> Self {
        match self {
            Self::About(cost) => Self::About(cost / unit),
            Self::MoreThan(cost) => Self::MoreThan(cost / unit),
            Self::LessThan(cost) => Self::LessThan(cost / unit),
        }
    }

    /// The number, whatever it bounds.
    pub(crate) fn value(self) -> f64 {
        match self {
            Self::About(cost) | Self::MoreThan(cost) | Self::LessThan(cost) => cost,
        }
    }
}

/// Two digits below ten, whole above.
impl fmt::Display for Price {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = match self {
            Self::About(_) => "",
            Self::MoreThan(_) => "> ",
            Self::LessThan(_) => "< ",
        };
        let value = self.value();
        let digits = usize::from(value < 9.95);
        write!(f, "{sign}{value:.digits$}")
    }
}

#[cfg(test)]
mod tests {
    use super::{Frontier, Point, Price, pareto};

    #[test]
    fn interpolation_is_straight_on_logarithmic_axes() {
        // Error falls like 1/sqrt(cost) up to 100, then like 1/cost.
        let points = [(1.0, 1.0), (100.0, 0.1), (1000.0, 0.01)];
        let line = Frontier(points.map(|(cost, error)| Point { cost, error }).into());
        for (error, cost) in [(10.0_f64.powf(-0.5), 10.0), (0.1, 100.0), (0.02, 500.0)] {
            match line.price(error) {
                Some(Price::About(price)) => assert!((price / cost - 1.0).abs() < 1e-12),
                other => panic!("{other:?}"),
            }
        }
        assert_eq!(line.price(0.001), Some(Price::MoreThan(1000.0)));
        assert_eq!(line.price(2.0), Some(Price::LessThan(1.0)));
        assert_eq!(Frontier(Vec::new()).price(0.1), None);
    }

    #[test]
    fn what_is_slower_and_worse_than_another_is_not_on_the_front() {
        let points = [(1.0, 9.0), (2.0, 4.0), (3.0, 5.0), (2.0, 6.0), (8.0, 1.0)];
        let points = points.map(|(cost, error)| Point { cost, error });
        // The fourth costs as much as the second: only both smaller beats.
        assert_eq!(pareto(&points), [true, true, false, true, true]);
        assert_eq!(pareto(&[]), [false; 0]);
    }

    #[test]
    fn prices_print_with_two_digits_or_whole() {
        assert_eq!(Price::About(3.25).to_string(), "3.2");
        assert_eq!(Price::MoreThan(1517.0).over(10.0).to_string(), "> 152");
        assert_eq!(Price::LessThan(1.0).over(2.0).to_string(), "< 0.5");
    }
}
