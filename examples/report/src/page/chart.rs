//! A chart: lines over a logarithmic axis, each named at its end, as inline SVG.

use std::fmt::Write;

use super::axis::{Axis, Scale, plain, spread};
use super::escape;
use super::grid::{Frame, Ruler};

const WIDTH: f64 = 560.0;
const HEIGHT: f64 = 372.0;
/// Margins of the plotting area; the names stand in the right one.
const LEFT: f64 = 78.0;
const RIGHT: f64 = 186.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 48.0;
/// Distance of the names' baselines.
const LEADING: f64 = 16.0;
/// Lines nowhere farther apart than this are drawn as one.
const SAME: f64 = 1.6;

/// A line with its name and its CSS class; a mark if it has one point.
pub(super) struct Line {
    pub(super) name: String,
    pub(super) class: String,
    /// Values of x, increasing, and of y.
    pub(super) points: Vec<[f64; 2]>,
}

/// Ends of an axis that holds all positive heights of some lines and another one, with `room`
/// beyond them, a factor; a decade on either side of 1 where there is nothing, which has no
/// logarithm.
pub(super) fn around(lines: &[Line], other: Option<f64>, room: f64) -> [f64; 2] {
    let heights = lines.iter().flat_map(|line| line.points.iter().map(|point| point[1]));
    let positive = heights.chain(other).filter(|height| *height > 0.0 && height.is_finite());
    let (low, high) = positive
        .fold((f64::INFINITY, 0.0_f64), |(low, high), height| (low.min(height), high.max(height)));
    if low < high { [low / room, high * room] } else { [0.1, 10.0] }
}

/// What one axis shows.
#[derive(Clone, Copy)]
pub(super) struct Range {
    pub(super) title: &'static str,
    pub(super) scale: Scale,
    pub(super) ends: [f64; 2],
    /// What follows the numbers at the ticks.
    pub(super) unit: &'static str,
}

impl Range {
    /// Of plain numbers.
    pub(super) const fn new(title: &'static str, scale: Scale, ends: [f64; 2]) -> Self {
        Self { title, scale, ends, unit: "" }
    }

    /// With this after the numbers.
    pub(super) const fn with_unit(self, unit: &'static str) -> Self {
        Self { unit, ..self }
    }
}

/// Lines within a frame; what leaves it is cut off.
pub(super) struct Chart {
    /// What a reader hears who does not see it.
    pub(super) title: String,
    pub(super) x: Range,
    pub(super) y: Range,
    /// The height that means no error, if it lies in the frame.
    pub(super) right: Option<f64>,
    pub(super) lines: Vec<Line>,
}

/// Lines that look the same, with the positions of the first.
struct Group<'a> {
    lines: Vec<&'a Line>,
    path: Vec<[f64; 2]>,
}

impl Group<'_> {
    /// The CSS class of the line and of all its names.
    fn class(&self) -> &str {
        self.lines.first().map_or("", |line| &line.class)
    }
}

impl Chart {
    /// As an SVG element.
    pub(super) fn svg(&self) -> String {
        let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
        let x = Axis::between(self.x.scale, self.x.ends, [LEFT, right]);
        let y = Axis::between(self.y.scale, self.y.ends, [bottom, TOP]);
        let mut svg = format!(
            "<svg viewBox=\"0 0 {WIDTH} {HEIGHT}\" width=\"{WIDTH}\" height=\"{HEIGHT}\" \
                role=\"img\" \
             aria-label=\"{}\">\n",
            escape(&self.title)
        );
        // Writing to a String cannot fail; the results are dropped with `.ok()`.
        self.ground(&mut svg, &x, &y).ok();
        let groups = self.groups(&x, &y);
        for group in &groups {
            let class = group.class();
            if let [at] = group.path[..] {
                mark(&mut svg, at, class).ok();
            } else {
                let path = cut(&group.path);
                writeln!(svg, "<path class=\"curve {class}\" d=\"{path}\"/>").ok();
            }
        }
        names(&mut svg, &groups).ok();
        svg + "</svg>\n"
    }

    /// Names of the lines that lie outside the frame throughout.
    pub(super) fn outside(&self) -> Vec<&str> {
        let [low, high] = self.y.ends;
        let outside = self.lines.iter().filter(|line| {
            let heights = line.points.iter().map(|point| point[1]);
            heights.clone().all(|y| y < low) || heights.clone().all(|y| y > high)
        });
        outside.map(|line| line.name.as_str()).collect()
    }

    /// Grid and axes, and the height that means no error.
    fn ground(&self, svg: &mut String, x: &Axis, y: &Axis) -> std::fmt::Result {
        let (right, bottom) = (WIDTH - RIGHT, HEIGHT - BOTTOM);
        let frame = Frame { left: LEFT, right, top: TOP, bottom, upright: 13.0 };
        let [of_x, of_y] = [&self.x, &self.y].map(|range| |tick: f64| label(tick, range));
        let horizontal = Ruler { axis: x, title: self.x.title, label: &of_x };
        let vertical = Ruler { axis: y, title: self.y.title, label: &of_y };
        frame.lines(svg, &horizontal, &vertical)?;
        if let Some(value) = self.right {
            writeln!(svg, "<path class=\"right\" d=\"M{LEFT} {:.1}H{right}\"/>", y.at(value))?;
        }
        frame.axes(svg, &horizontal, &vertical)
    }

    /// The lines that enter the frame, those that look the same together.
    fn groups(&self, x: &Axis, y: &Axis) -> Vec<Group<'_>> {
        let outside = self.outside();
        let mut groups: Vec<Group<'_>> = Vec::new();
        for line in self.lines.iter().filter(|line| !outside.contains(&line.name.as_str())) {
            // A ratio of 0 has no logarithm; far below the frame is where it belongs.
            let height = |value: f64| y.at(value).clamp(-1e4, 1e4);
            let path: Vec<_> = line.points.iter().map(|p| [x.at(p[0]), height(p[1])]).collect();
            let visible = |at: f64| at.clamp(TOP, HEIGHT - BOTTOM);
            let same = |group: &&mut Group<'_>| {
                let mut pairs = group.path.iter().zip(&path);
                let alone = |path: &[[f64; 2]]| path.len() == 1;
                alone(&group.path) == alone(&path)
                    && pairs.all(|(a, b)| (visible(a[1]) - visible(b[1])).abs() < SAME)
                    && (!alone(&path) || (group.path[0][0] - path[0][0]).abs() < SAME)
            };
            match groups.iter_mut().find(same) {
                Some(group) => group.lines.push(line),
                None => groups.push(Group { lines: vec![line], path }),
            }
        }
        groups
    }
}

/// A line of one point.
fn mark(svg: &mut String, [x, y]: [f64; 2], class: &str) -> std::fmt::Result {
    let y = y.clamp(TOP, HEIGHT - BOTTOM);
    writeln!(svg, "<circle class=\"mark {class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"5\"/>")
}

/// A tick's number; with a true minus sign.
fn label(tick: f64, range: &Range) -> String {
    let number = match range.scale {
        Scale::Logarithmic => plain(tick),
        Scale::Binary => tick.to_string(),
        // Ticks are multiples of a rounded step: six decimals are right, and mostly zeros.
        Scale::Linear => {
            let digits = format!("{tick:.6}").replace('-', "\u{2212}");
            digits.trim_end_matches('0').trim_end_matches('.').into()
        }
    };
    number + range.unit
}

/// A path of straight pieces without what lies above or below the frame.
fn cut(points: &[[f64; 2]]) -> String {
    let (top, bottom) = (TOP, HEIGHT - BOTTOM);
    let mut path = String::new();
    let mut end = None;
    for pair in points.windows(2) {
        let ([x0, y0], [x1, y1]) = (pair[0], pair[1]);
        // The part of the piece, from 0 to 1, between the two heights.
        let at = |height: f64| (height - y0) / (y1 - y0);
        let (from, to) = if y0 == y1 {
            if (top..=bottom).contains(&y0) { (0.0, 1.0) } else { (1.0, 0.0) }
        } else {
            let (a, b) = (at(top), at(bottom));
            (a.min(b).max(0.0), a.max(b).min(1.0))
        };
        if from >= to {
            continue;
        }
        let point = |t: f64| format!("{:.1} {:.1}", x0 + t * (x1 - x0), y0 + t * (y1 - y0));
        let start = point(from);
        if end.as_ref() != Some(&start) {
            write!(path, "M{start}").ok();
        }
        let last = point(to);
        write!(path, "L{last}").ok();
        end = Some(last);
    }
    path
}

/// Names at the right ends, in the lines' order of height, joined to them; each with a piece of its
/// line.
fn names(svg: &mut String, groups: &[Group<'_>]) -> std::fmt::Result {
    let (top, bottom) = (TOP, HEIGHT - BOTTOM);
    let mut names = Vec::new();
    for group in groups {
        let Some(&[x, y]) = group.path.last() else { continue };
        let arrow = match y {
            y if y < top - 1.0 => " \u{2191}",
            y if y > bottom + 1.0 => " \u{2193}",
            _ => "",
        };
        let named = group.lines.iter().map(|line| format!("{}{arrow}", escape(&line.name)));
        let alone = group.path.len() == 1;
        names
            .extend(named.map(|name| (y, [x, y.clamp(top, bottom)], (group.class(), alone), name)));
    }
    names.sort_by(|a, b| a.0.total_cmp(&b.0));
    let heights: Vec<_> = names.iter().map(|(_, end, ..)| end[1]).collect();
    let baselines = spread(&heights, LEADING, [top, bottom]);
    for ((_, [x, y], (class, alone), name), at) in names.iter().zip(baselines) {
        if *alone {
            let (from, to, base) = (x + 5.0, x + 10.0, at + 4.0);
            writeln!(svg, "<path class=\"leader\" d=\"M{from:.1} {y:.1}L{to:.1} {at:.1}\"/>")?;
            let text = x + 12.0;
            writeln!(
                svg,
                "<text class=\"{class} near\" x=\"{text:.1}\" y=\"{base:.1}\">{name}</text>"
            )?;
            continue;
        }
        let (from, to, end) = (x + 2.0, x + 16.0, x + 36.0);
        writeln!(svg, "<path class=\"leader\" d=\"M{from:.1} {y:.1}L{to:.1} {at:.1}\"/>")?;
        writeln!(svg, "<path class=\"curve {class}\" d=\"M{to:.1} {at:.1}H{end:.1}\"/>")?;
        let (text, base) = (x + 41.0, at + 4.0);
        writeln!(svg, "<text class=\"{class}\" x=\"{text:.1}\" y=\"{base:.1}\">{name}</text>")?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{Chart, Line, Range, cut, label};
    use crate::page::axis::Scale;

    fn chart(lines: &[(&str, f64)]) -> Chart {
        let range = |ends| Range::new("t", Scale::Logarithmic, ends);
        let line = |&(name, y): &(&str, f64)| Line {
            name: name.into(),
            class: "c".into(),
            points: vec![[1.0, y], [10.0, y]],
        };
        Chart {
            title: "a < b".into(),
            x: range([1.0, 10.0]),
            y: range([0.1, 10.0]),
            right: Some(1.0),
            lines: lines.iter().map(line).collect(),
        }
    }

    #[test]
    fn lines_that_look_the_same_are_one_with_all_their_names() {
        let svg = chart(&[("one", 1.0), ("two", 1.001), ("three", 3.0)]).svg();
        // Two lines and a piece beside each of three names.
        assert_eq!(svg.matches("class=\"curve").count(), 2 + 3);
        assert!(["one", "two", "three"].iter().all(|name| svg.contains(name)));
        assert!(svg.contains("a &lt; b"));
    }

    #[test]
    fn what_never_enters_the_frame_is_told_not_drawn() {
        let chart = chart(&[("seen", 1.0), ("zero", 0.0), ("high", 1e9)]);
        assert_eq!(chart.outside(), ["zero", "high"]);
        assert!(!chart.svg().contains("high") && !chart.svg().contains("NaN"));
    }

    #[test]
    fn lines_of_one_point_are_marks_wherever_others_are_as_high() {
        let mut chart = chart(&[("line", 1.0), ("left", 2.0), ("right", 2.0)]);
        chart.lines[1].points = vec![[2.0, 2.0]];
        chart.lines[2].points = vec![[5.0, 2.0]];
        let svg = chart.svg();
        assert_eq!(svg.matches("<circle class=\"mark c\"").count(), 2);
        assert_eq!(svg.matches("class=\"c near\"").count(), 2);
    }

    #[test]
    fn ticks_are_plain_numbers() {
        let range = Range::new("t", Scale::Linear, [-1.0, 1.0]).with_unit(" %");
        let labels = [3.0 * 0.2, 0.0, 40.0, -20.0].map(|tick| label(tick, &range));
        assert_eq!(labels, ["0.6 %", "0 %", "40 %", "\u{2212}20 %"]);
    }

    #[test]
    fn paths_are_cut_at_the_frame() {
        // From 100 above the top to 100 below it, and out again.
        let path = cut(&[[0.0, -86.0], [200.0, 114.0], [400.0, 114.0], [600.0, -86.0]]);
        assert_eq!(path, "M100.0 14.0L200.0 114.0L400.0 114.0L500.0 14.0");
        assert_eq!(cut(&[[0.0, -1.0], [9.0, -1.0]]), "");
    }
}
