//! Pictures in false colors, each with the numbers of its colors.

use std::fmt::Write;

use super::axis::{Axis, Scale};
use super::picture::colored;
use crate::camera::Size;

/// Colors from low to high, evenly spaced: Viridis (van der Walt & Smith 2015), whose lightness
/// grows evenly.
const COLORS: [[u8; 3]; 9] = [
    [68, 1, 84],
    [71, 44, 122],
    [59, 81, 139],
    [44, 113, 142],
    [33, 144, 141],
    [39, 173, 129],
    [92, 200, 99],
    [170, 220, 50],
    [253, 231, 37],
];

/// What is drawn, and how colors are read.
pub(super) struct Colored<'a> {
    pub(super) size: Size,
    /// Width of the column that it stands in.
    pub(super) column: usize,
    /// Where there is anything; the rest is black.
    pub(super) on: &'a [bool],
    pub(super) caption: String,
    pub(super) values: &'a [f64],
    pub(super) scale: Scale,
    pub(super) ends: [f64; 2],
    pub(super) ticks: &'static [f64],
    pub(super) unit: &'static str,
}

impl Colored<'_> {
    /// The picture and a bar of its colors.
    pub(super) fn figure(&self) -> String {
        let axis = Axis::between(self.scale, self.ends, [0.0, 1.0]);
        let colors: Vec<_> = self
            .values
            .iter()
            .zip(self.on)
            .map(|(&value, &on)| if on { color(axis.at(value)) } else { [0; 3] })
            .collect();
        let Size { width, height } = self.size;
        // Whole multiples keep pixels square and of one size.
        let zoom = (self.column / width).max(1);
        let (width, height) = (zoom * width, zoom * height);
        let caption = super::escape(&self.caption);
        format!(
            "<figure><img alt=\"{caption}\" width=\"{width}\" height=\"{height}\" \
                src=\"{}\">{}<figcaption>{caption}\
         </figcaption></figure>\n",
            colored(self.size, &colors),
            legend(self),
        )
    }
}

/// The color at a place from 0 to 1.
fn color(place: f64) -> [u8; 3] {
    let place = place.clamp(0.0, 1.0) * (COLORS.len() - 1) as f64;
    // Not negative, and below the last one.
    #[allow(clippy::cast_sign_loss)]
    let first = (place as usize).min(COLORS.len() - 2);
    let part = place - first as f64;
    let mix = |k: usize| {
        let [a, b] = [COLORS[first], COLORS[first + 1]].map(|color| f64::from(color[k]));
        // A mean of bytes.
        #[allow(clippy::cast_sign_loss)]
        let byte = (a + part * (b - a) + 0.5) as u8;
        byte
    };
    [mix(0), mix(1), mix(2)]
}

const WIDTH: f64 = 560.0;
const LEFT: f64 = 16.0;
const RIGHT: f64 = 24.0;
/// Whole pixels each.
const STEPS: u32 = 104;

/// A bar of the colors with numbers below.
fn legend(shown: &Colored<'_>) -> String {
    let (left, right) = (LEFT, WIDTH - RIGHT);
    let axis = Axis::between(shown.scale, shown.ends, [left, right]);
    let mut svg = format!(
        "<svg viewBox=\"0 0 {WIDTH} 40\" width=\"{WIDTH}\" height=\"40\" role=\"img\" \
         shape-rendering=\"crispEdges\" aria-label=\"colors from {} to {}{}\">\n",
        shown.ends[0], shown.ends[1], shown.unit
    );
    let step = (right - left) / f64::from(STEPS);
    for k in 0..STEPS {
        let [r, g, b] = color((f64::from(k) + 0.5) / f64::from(STEPS));
        let x = left + f64::from(k) * step;
        let fill = format!("#{r:02x}{g:02x}{b:02x}");
        // Writing to a String cannot fail; the result is dropped with `.ok()`.
        writeln!(svg, "<rect x=\"{x}\" y=\"8\" width=\"{step}\" height=\"10\" fill=\"{fill}\"/>")
            .ok();
    }
    for &tick in shown.ticks {
        let (x, unit) = (axis.at(tick), shown.unit);
        writeln!(svg, "<text class=\"tick middle\" x=\"{x:.1}\" y=\"34\">{tick}{unit}</text>").ok();
    }
    svg + "</svg>\n"
}

#[cfg(test)]
mod tests {
    use super::{COLORS, color};

    #[test]
    fn colors_run_from_the_first_to_the_last() {
        assert_eq!(color(-1.0), COLORS[0]);
        assert_eq!(color(0.5), COLORS[4]);
        assert_eq!(color(2.0), COLORS[8]);
        assert_eq!(color(0.0625), [70, 23, 103]);
    }
}
