//! Axes of plots: values to positions, ticks, labels.

use super::table::significant;

/// How values lie along an axis.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Scale {
    Linear,
    Logarithmic,
    /// The same with powers of two at the ticks.
    Binary,
}

impl Scale {
    fn forward(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Logarithmic | Self::Binary => value.ln(),
        }
    }

    fn back(self, x: f64) -> f64 {
        match self {
            Self::Linear => x,
            Self::Logarithmic | Self::Binary => x.exp(),
        }
    }
}

/// An axis: `at = origin + slope * value`, or its logarithm.
pub(super) struct Axis {
    pub(super) low: f64,
    pub(super) high: f64,
    origin: f64,
    slope: f64,
    scale: Scale,
}

impl Axis {
    /// The axis with `a` at position `from` and `b` at position `to`, drawn between two positions.
    pub(super) fn through(
        scale: Scale,
        [a, b]: [f64; 2],
        [from, to]: [f64; 2],
        drawn: [f64; 2],
    ) -> Self {
        let (first, last) = (scale.forward(a), scale.forward(b));
        let slope = (to - from) / (last - first);
        let origin = from - slope * first;
        let value = |at: f64| scale.back((at - origin) / slope);
        Self { low: value(drawn[0]), high: value(drawn[1]), origin, slope, scale }
    }

    /// The axis with `a` and `b` at its ends.
    pub(super) fn between(scale: Scale, values: [f64; 2], ends: [f64; 2]) -> Self {
        let axis = Self::through(scale, values, ends, ends);
        Self { low: values[0], high: values[1], ..axis }
    }

    pub(super) fn at(&self, value: f64) -> f64 {
        self.origin + self.slope * self.scale.forward(value)
    }

    /// 1, 2, 5 times powers of ten within the axis; on long logarithmic ones powers of ten only. On
    /// linear ones multiples of one such number, at most eight. None on an axis without a length.
    pub(super) fn ticks(&self) -> Vec<f64> {
        let [first, last] = [self.low, self.high].map(|end| self.scale.forward(end));
        if !(first < last && last - first < f64::INFINITY) {
            return Vec::new();
        }
        match self.scale {
            Scale::Linear => self.multiples(),
            Scale::Logarithmic => self.powers(),
            Scale::Binary => self.doublings(),
        }
    }

    fn powers(&self) -> Vec<f64> {
        let decades = (self.high / self.low).log10();
        let steps: &[f64] = if decades > 2.2 { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let first = self.low.log10().floor() as i32;
        let last = self.high.log10().ceil() as i32;
        let all = (first..=last).flat_map(|p| steps.iter().map(move |s| s * 10.0_f64.powi(p)));
        all.filter(|tick| (self.low..=self.high).contains(tick)).collect()
    }

    fn doublings(&self) -> Vec<f64> {
        let (first, last) = (self.low.log2().ceil() as i32, self.high.log2().floor() as i32);
        (first..=last).map(|power| 2.0_f64.powi(power)).collect()
    }

    fn multiples(&self) -> Vec<f64> {
        let least = (self.high - self.low) / 8.0;
        let power = 10.0_f64.powf(least.log10().floor());
        let factor = [1.0, 2.0, 5.0].into_iter().find(|f| f * power >= least).unwrap_or(10.0);
        let step = factor * power;
        let first = (self.low / step).ceil() as i32;
        let last = (self.high / step).floor() as i32;
        (first..=last).map(|k| f64::from(k) * step).collect()
    }
}

/// Heights (increasing), moved apart to a distance, as little as it takes, within bounds.
pub(super) fn spread(heights: &[f64], distance: f64, bounds: [f64; 2]) -> Vec<f64> {
    let half = |count: usize| 0.5 * distance * (count - 1) as f64;
    let within = |middle: f64, count: usize| {
        (middle.min(bounds[1] - half(count)).max(bounds[0] + half(count)), count)
    };
    // Clusters of touching labels, each centered on the mean of what it labels; merge until apart.
    let mut clusters: Vec<(f64, usize)> = Vec::new();
    for &height in heights {
        clusters.push(within(height, 1));
        while let [.., (a, m), (b, n)] = clusters[..] {
            if b - a >= 0.5 * distance * (m + n) as f64 {
                break;
            }
            clusters.truncate(clusters.len() - 2);
            let middle = (a * m as f64 + b * n as f64) / (m + n) as f64;
            clusters.push(within(middle, m + n));
        }
    }
    let spread = clusters.into_iter().flat_map(|(middle, count)| {
        (0..count).map(move |k| middle - half(count) + distance * k as f64)
    });
    spread.collect()
}

/// A power of ten, or 2 or 5 times one, without trailing zeros.
pub(super) fn plain(tick: f64) -> String {
    if (1e-4..1e6).contains(&tick) {
        let decimals = (-tick.log10().floor() as i32).max(0).unsigned_abs() as usize;
        format!("{tick:.decimals$}")
    } else {
        significant(tick)
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Scale, spread};

    #[test]
    fn axes_pass_through_their_points() {
        let axis = Axis::through(Scale::Logarithmic, [10.0, 1000.0], [100.0, 300.0], [0.0, 400.0]);
        assert!((axis.at(100.0) - 200.0).abs() < 1e-9);
        assert!((axis.low - 1.0).abs() < 1e-9 && (axis.high - 1e4).abs() < 1e-6);
        assert!(axis.ticks().contains(&100.0));
    }

    #[test]
    fn binary_axes_have_powers_of_two_at_both_ends() {
        let axis = Axis::between(Scale::Binary, [0.5, 8.0], [0.0, 100.0]);
        assert_eq!(axis.ticks(), [0.5, 1.0, 2.0, 4.0, 8.0]);
        assert!((axis.at(2.0) - 50.0).abs() < 1e-9);
    }

    #[test]
    fn axes_without_a_length_have_no_ticks() {
        for scale in [Scale::Linear, Scale::Logarithmic, Scale::Binary] {
            for ends in [[0.0, 0.0], [1.0, f64::NAN], [f64::INFINITY, 0.0], [1.0, f64::INFINITY]] {
                assert!(Axis::between(scale, ends, [0.0, 100.0]).ticks().is_empty(), "{ends:?}");
            }
        }
        assert!(Axis::between(Scale::Logarithmic, [0.0, 1.0], [0.0, 100.0]).ticks().is_empty());
    }

    #[test]
    fn labels_move_apart_and_keep_their_order() {
        let labels = spread(&[10.0, 12.0, 100.0], 10.0, [0.0, 200.0]);
        assert_eq!(labels, [6.0, 16.0, 100.0]);
        let labels = spread(&[1.0, 2.0, 3.0], 10.0, [0.0, 200.0]);
        assert_eq!(labels, [0.0, 10.0, 20.0]);
        // What the bounds push aside pushes its neighbor.
        let labels = spread(&[1.0, 1.0, 12.0], 10.0, [0.0, 200.0]);
        assert_eq!(labels, [0.0, 10.0, 20.0]);
    }

    #[test]
    fn linear_axes_have_round_ticks_and_zero_where_it_is_zero() {
        let axis = Axis::between(Scale::Linear, [-75.0, 50.0], [0.0, 250.0]);
        assert_eq!(axis.ticks(), [-60.0, -40.0, -20.0, 0.0, 20.0, 40.0]);
        assert!((axis.at(0.0) - 150.0).abs() < 1e-9);
    }
}
