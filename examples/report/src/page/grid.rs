//! The ground of a plot: grid lines, numbers at their ends, two axes and what they are called.

use std::fmt::{Result, Write};

use super::axis::Axis;

/// Distance of the numbers' baseline from the x axis, and of the title's.
const NUMBERS: f64 = 18.0;
const TITLE: f64 = 40.0;

/// The plotting area's edges on the page.
#[derive(Clone, Copy)]
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) top: f64,
    pub(super) bottom: f64,
    /// Where the upright title of the y axis stands.
    pub(super) upright: f64,
}

/// An axis with its title and its numbers.
pub(super) struct Ruler<'a> {
    pub(super) axis: &'a Axis,
    pub(super) title: &'a str,
    pub(super) label: &'a dyn Fn(f64) -> String,
}

impl Frame {
    /// A line with its number for every tick.
    pub(super) fn lines(&self, svg: &mut String, x: &Ruler<'_>, y: &Ruler<'_>) -> Result {
        let Self { left, right, top, bottom, .. } = self;
        for tick in x.axis.ticks() {
            let at = x.axis.at(tick);
            writeln!(svg, "<path class=\"grid\" d=\"M{at:.1} {top}V{bottom}\"/>")?;
            let (base, label) = (bottom + NUMBERS, (x.label)(tick));
            writeln!(svg, "<text class=\"tick middle\" x=\"{at:.1}\" y=\"{base}\">{label}</text>")?;
        }
        for tick in y.axis.ticks() {
            let at = y.axis.at(tick);
            writeln!(svg, "<path class=\"grid\" d=\"M{left} {at:.1}H{right}\"/>")?;
            let (end, base, label) = (left - 7.0, at + 4.0, (y.label)(tick));
            writeln!(svg, "<text class=\"tick end\" x=\"{end}\" y=\"{base:.1}\">{label}</text>")?;
        }
        Ok(())
    }

    /// Both axes and their titles, over what was drawn before.
    pub(super) fn axes(&self, svg: &mut String, x: &Ruler<'_>, y: &Ruler<'_>) -> Result {
        let Self { left, right, top, bottom, upright } = self;
        writeln!(svg, "<path class=\"axis\" d=\"M{left} {top}V{bottom}H{right}\"/>")?;
        let (middle, base, title) = (0.5 * (left + right), bottom + TITLE, x.title);
        writeln!(svg, "<text class=\"title middle\" x=\"{middle}\" y=\"{base}\">{title}</text>")?;
        let (middle, title) = (0.5 * (top + bottom), y.title);
        writeln!(
            svg,
            "<text class=\"title middle\" transform=\"translate({upright} {middle}) \
                rotate(-90)\">{title}</text>"
        )
    }
}

#[cfg(test)]
mod tests {
    use super::{Frame, Ruler};
    use crate::page::axis::{Axis, Scale, plain};

    #[test]
    fn every_tick_has_a_line_and_a_number_and_both_axes_a_title() {
        let frame = Frame { left: 50.0, right: 250.0, top: 10.0, bottom: 110.0, upright: 9.0 };
        let x = Axis::between(Scale::Logarithmic, [1.0, 1000.0], [50.0, 250.0]);
        let y = Axis::between(Scale::Linear, [1.0, 2.0], [110.0, 10.0]);
        let x = Ruler { axis: &x, title: "time", label: &|tick| plain(tick) + " ns" };
        let y = Ruler { axis: &y, title: "error", label: &plain };
        let mut svg = String::new();
        frame.lines(&mut svg, &x, &y).unwrap();
        frame.axes(&mut svg, &x, &y).unwrap();
        let ticks = x.axis.ticks().len() + y.axis.ticks().len();
        assert_eq!(svg.matches("class=\"grid\"").count(), ticks);
        assert_eq!(svg.matches("class=\"tick ").count(), ticks);
        assert!(svg.contains("x=\"250.0\" y=\"128\">1000 ns<"), "{svg}");
        assert!(svg.contains("x=\"150\" y=\"150\">time<"), "{svg}");
        assert!(svg.contains("translate(9 60) rotate(-90)\">error<"), "{svg}");
    }
}
