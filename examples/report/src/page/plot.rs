//! The plot: RMSE over nanoseconds per pixel, logarithmic axes, as inline SVG.

use std::fmt::Write;

use super::axis::{Axis, Scale, plain, spread};
use super::escape;
use super::grid::{Frame, Ruler};
use crate::frontier::{Point, Price};
use crate::method::Family;
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
    ground(&mut svg, &axes).ok();
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
    let log = Scale::Logarithmic;
    Some(Axes {
        time: Axis::through(log, [fast, slow], [left + NAMES, right - 16.0], [left, right]),
        error: Axis::through(log, [small, large], [bottom - 18.0, top + 22.0], [bottom, top]),
    })
}

/// Grid and axes.
fn ground(svg: &mut String, axes: &Axes) -> std::fmt::Result {
    let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
    let frame = Frame { left: LEFT, right, top: TOP, bottom, upright: 14.0 };
    let time = Ruler { axis: &axes.time, title: "time per pixel", label: &duration };
    let error = Ruler { axis: &axes.error, title: "RMSE, mean radiance = 1", label: &plain };
    frame.lines(svg, &time, &error)?;
    frame.axes(svg, &time, &error)
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

/// Filters but for the engines', whose names would leave no room; they stand in the tables.
fn is_drawn(row: &Row) -> bool {
    row.filters && row.family != Family::Engine
}

/// The filters: a mark each, its name at the left.
fn filters(svg: &mut String, axes: &Axes, panel: &Panel) -> std::fmt::Result {
    let best = panel.best().map(|row| &row.name);
    let mut rows: Vec<_> =
        panel.rows.iter().filter(|row| is_drawn(row) && plottable(&row.point())).collect();
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

/// Nanoseconds in the unit that reads best.
fn duration(nanoseconds: f64) -> String {
    let units = [(1e9, "s"), (1e6, "ms"), (1e3, "\u{b5}s"), (1.0, "ns")];
    let (factor, unit) =
        units.into_iter().find(|(factor, _)| nanoseconds >= 0.999 * factor).unwrap_or((1.0, "ns"));
    format!("{} {unit}", plain(nanoseconds / factor))
}

#[cfg(test)]
mod tests {
    use super::duration;

    #[test]
    fn durations_read_in_their_unit() {
        assert_eq!(duration(100.0), "100 ns");
        assert_eq!(duration(1e4), "10 \u{b5}s");
        assert_eq!(duration(2e6), "2 ms");
    }
}
