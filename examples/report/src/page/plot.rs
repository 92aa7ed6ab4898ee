//! The plot: RMSE over nanoseconds per pixel, logarithmic axes, as inline SVG.

use std::fmt::Write;

use super::escape;
use super::table::significant;
use crate::frontier::{Point, Price};
use crate::study::{Panel, Row};

const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 400.0;
/// Margins of the plotting area.
const LEFT: f64 = 58.0;
const RIGHT: f64 = 22.0;
const TOP: f64 = 16.0;
const BOTTOM: f64 = 50.0;
/// Room for the filters' names, left of the fastest of them.
const NAMES: f64 = 224.0;
/// Distance of the names' baselines.
const LEADING: f64 = 17.0;

/// Positions on the page of times and errors.
struct Axes {
    time: Axis,
    error: Axis,
}

/// A logarithmic axis: `at = origin + slope * ln(value)`.
struct Axis {
    low: f64,
    high: f64,
    origin: f64,
    slope: f64,
}

impl Axis {
    /// The axis with `a` at position `from` and `b` at position `to`, drawn between two positions.
    fn through(a: f64, from: f64, b: f64, to: f64, drawn: [f64; 2]) -> Self {
        let slope = (to - from) / (b / a).ln();
        let origin = from - slope * a.ln();
        let value = |at: f64| ((at - origin) / slope).exp();
        Self { low: value(drawn[0]), high: value(drawn[1]), origin, slope }
    }

    fn at(&self, value: f64) -> f64 {
        self.origin + self.slope * value.ln()
    }

    /// 1, 2, 5 times powers of ten within the axis; on long ones powers of ten only.
    fn ticks(&self) -> Vec<f64> {
        let decades = (self.high / self.low).log10();
        let steps: &[f64] = if decades > 2.2 { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let first = self.low.log10().floor() as i32;
        let last = self.high.log10().ceil() as i32;
        let all = (first..=last).flat_map(|p| steps.iter().map(move |s| s * 10.0_f64.powi(p)));
        all.filter(|tick| (self.low..=self.high).contains(tick)).collect()
    }
}

/// The plot of a panel as an SVG element.
pub(super) fn svg(panel: &Panel) -> String {
    let points: Vec<_> = panel.rows.iter().map(Row::point).filter(plottable).collect();
    let Some(axes) = axes(&points) else {
        return "<p>Nothing to plot: an error or a time is zero.</p>".into();
    };
    let mut svg = format!(
        "<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" role=\"img\" \
         aria-label=\"RMSE over nanoseconds per pixel, {}\">\n",
        panel.distribution.name()
    );
    // Writing to a String cannot fail; the results are dropped with `.ok()`.
    grid(&mut svg, &axes).ok();
    line_to_beat(&mut svg, &axes, panel).ok();
    gain(&mut svg, &axes, panel).ok();
    filters(&mut svg, &axes, panel).ok();
    svg + "</svg>\n"
}

fn plottable(point: &Point) -> bool {
    let positive = |x: f64| x.is_finite() && x > 0.0;
    positive(point.cost) && positive(point.error)
}

/// Axes that hold all points, with room for names at the left.
fn axes(points: &[Point]) -> Option<Axes> {
    let range = |value: fn(&Point) -> f64| {
        let values = points.iter().map(value);
        let low = values.clone().fold(f64::INFINITY, f64::min);
        let high = values.fold(0.0, f64::max);
        (low < high).then_some((low, high))
    };
    let (fast, slow) = range(|p| p.cost)?;
    let (small, large) = range(|p| p.error)?;
    let (left, right, top, bottom) = (LEFT, WIDTH - RIGHT, TOP, HEIGHT - BOTTOM);
    Some(Axes {
        time: Axis::through(fast, left + NAMES, slow, right - 16.0, [left, right]),
        error: Axis::through(small, bottom - 18.0, large, top + 22.0, [bottom, top]),
    })
}

fn grid(svg: &mut String, axes: &Axes) -> std::fmt::Result {
    let (left, right, top, bottom) = (LEFT, WIDTH - RIGHT, TOP, HEIGHT - BOTTOM);
    for tick in axes.time.ticks() {
        let x = axes.time.at(tick);
        writeln!(svg, "<path class=\"grid\" d=\"M{x:.1} {top}V{bottom}\"/>")?;
        let y = bottom + 18.0;
        let label = duration(tick);
        writeln!(svg, "<text class=\"tick middle\" x=\"{x:.1}\" y=\"{y}\">{label}</text>")?;
    }
    for tick in axes.error.ticks() {
        let y = axes.error.at(tick);
        writeln!(svg, "<path class=\"grid\" d=\"M{left} {y:.1}H{right}\"/>")?;
        let (x, base, label) = (left - 7.0, y + 4.0, plain(tick));
        writeln!(svg, "<text class=\"tick end\" x=\"{x}\" y=\"{base:.1}\">{label}</text>")?;
    }
    writeln!(svg, "<path class=\"axis\" d=\"M{left} {top}V{bottom}H{right}\"/>")?;
    let (x, y) = (0.5 * (left + right), HEIGHT - 10.0);
    writeln!(svg, "<text class=\"title middle\" x=\"{x}\" y=\"{y}\">time per pixel</text>")?;
    let (x, y) = (14.0, 0.5 * (top + bottom));
    writeln!(
        svg,
        "<text class=\"title middle\" transform=\"translate({x} {y}) rotate(-90)\">RMSE, mean \
         radiance = 1</text>"
    )
}

/// Supersampling: its points, connected, with their sample counts.
fn line_to_beat(svg: &mut String, axes: &Axes, panel: &Panel) -> std::fmt::Result {
    let mut path = String::new();
    let mut marks = String::new();
    for row in panel.rows.iter().filter(|row| !row.filters && plottable(&row.point())) {
        let (x, y) = (axes.time.at(row.pixel), axes.error.at(row.errors.rmse));
        write!(path, "{}{x:.1} {y:.1}", if path.is_empty() { 'M' } else { 'L' })?;
        writeln!(marks, "<circle class=\"plain\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\"/>")?;
        let unit = if row.samples == 1 { " sample" } else { "" };
        let (x, y) = (x + 7.0, y - 7.0);
        writeln!(
            marks,
            "<text class=\"count\" x=\"{x:.1}\" y=\"{y:.1}\">{}{unit}</text>",
            row.samples
        )?;
    }
    writeln!(svg, "<path class=\"line\" d=\"{path}\"/>\n{marks}")
}

/// From the best filter straight to supersampling of equal error.
fn gain(svg: &mut String, axes: &Axes, panel: &Panel) -> std::fmt::Result {
    let Some(best) = panel.best().filter(|row| plottable(&row.point())) else { return Ok(()) };
    let Some(speed_up @ (Price::About(_) | Price::MoreThan(_))) = best.speed_up else {
        return Ok(());
    };
    if speed_up.value() <= 1.0 {
        return Ok(());
    }
    let (from, to) = (axes.time.at(best.pixel), axes.time.at(best.pixel * speed_up.value()));
    let y = axes.error.at(best.errors.rmse);
    writeln!(svg, "<path class=\"gain\" d=\"M{from:.1} {y:.1}H{to:.1}\"/>")?;
    let (x, base) = (0.5 * (from + to), y + 17.0);
    writeln!(
        svg,
        "<text class=\"gain-label middle\" x=\"{x:.1}\" y=\"{base:.1}\">{speed_up}\u{d7}</text>"
    )
}

/// The filters: a mark each, its name at the left.
fn filters(svg: &mut String, axes: &Axes, panel: &Panel) -> std::fmt::Result {
    let best = panel.best().map(|row| &row.name);
    let mut rows: Vec<_> =
        panel.rows.iter().filter(|row| row.filters && plottable(&row.point())).collect();
    rows.sort_by(|a, b| b.errors.rmse.total_cmp(&a.errors.rmse));
    let heights: Vec<_> = rows.iter().map(|row| axes.error.at(row.errors.rmse)).collect();
    let baselines = spread(&heights, LEADING, [TOP + 10.0, HEIGHT - BOTTOM - 8.0]);
    for ((row, y), label) in rows.into_iter().zip(heights).zip(baselines) {
        let x = axes.time.at(row.pixel);
        let class = if Some(&row.name) == best { "filter best" } else { "filter" };
        let end = LEFT + NAMES - 20.0;
        writeln!(svg, "<path class=\"leader\" d=\"M{} {label:.1}L{x:.1} {y:.1}\"/>", end + 4.0)?;
        writeln!(svg, "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5\"/>")?;
        let base = label + 4.0;
        let name = escape(&row.name);
        writeln!(
            svg,
            "<text class=\"name end {class}\" x=\"{end}\" y=\"{base:.1}\">{name}</text>"
        )?;
    }
    Ok(())
}

/// Heights (increasing), moved apart to a distance, as little as it takes, within bounds.
fn spread(heights: &[f64], distance: f64, bounds: [f64; 2]) -> Vec<f64> {
    // Clusters of touching labels, each centred on the mean of what it labels; merge until apart.
    let mut clusters: Vec<(f64, usize)> = Vec::new();
    for &height in heights {
        clusters.push((height, 1));
        while let [.., (a, m), (b, n)] = clusters[..] {
            if b - a >= 0.5 * distance * (m + n) as f64 {
                break;
            }
            clusters.truncate(clusters.len() - 2);
            let middle = (a * m as f64 + b * n as f64) / (m + n) as f64;
            clusters.push((middle, m + n));
        }
    }
    let spread = clusters.into_iter().flat_map(|(middle, count)| {
        let half = 0.5 * distance * (count - 1) as f64;
        let low = (middle - half).min(bounds[1] - 2.0 * half).max(bounds[0]);
        (0..count).map(move |k| low + distance * k as f64)
    });
    spread.collect()
}

/// A power of ten, or 2 or 5 times one, without trailing zeros.
fn plain(tick: f64) -> String {
    if (1e-4..1e6).contains(&tick) {
        let decimals = (-tick.log10().floor() as i32).max(0).unsigned_abs() as usize;
        format!("{tick:.decimals$}")
    } else {
        significant(tick)
    }
}

/// Nanoseconds in the unit that reads best.
fn duration(nanoseconds: f64) -> String {
    let units = [(1e9, "s"), (1e6, "ms"), (1e3, "\u{b5}s"), (1.0, "ns")];
    let (factor, unit) =
        units.into_iter().find(|(factor, _)| nanoseconds >= 0.999 * factor).unwrap_or((1.0, "ns"));
    format!("{} {unit}", plain(nanoseconds / factor))
}

#[cfg(test)]
mod tests {
    use super::{Axis, duration, spread};

    #[test]
    fn axes_pass_through_their_points() {
        let axis = Axis::through(10.0, 100.0, 1000.0, 300.0, [0.0, 400.0]);
        assert!((axis.at(100.0) - 200.0).abs() < 1e-9);
        assert!((axis.low - 1.0).abs() < 1e-9 && (axis.high - 1e4).abs() < 1e-6);
        assert!(axis.ticks().contains(&100.0));
    }

    #[test]
    fn labels_move_apart_and_keep_their_order() {
        let labels = spread(&[10.0, 12.0, 100.0], 10.0, [0.0, 200.0]);
        assert_eq!(labels, [6.0, 16.0, 100.0]);
        let labels = spread(&[1.0, 2.0, 3.0], 10.0, [0.0, 200.0]);
        assert_eq!(labels, [0.0, 10.0, 20.0]);
    }

    #[test]
    fn durations_read_in_their_unit() {
        assert_eq!(duration(100.0), "100 ns");
        assert_eq!(duration(1e4), "10 \u{b5}s");
        assert_eq!(duration(2e6), "2 ms");
    }
}
