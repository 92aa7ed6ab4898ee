//! The filters without a renderer: figures, tables and what they say, as HTML and as text.

use super::axis::Scale;
use super::chart::{Chart, Line as Curved, Range};
use super::measure::{L1, MEASURES, Measure, PEAK};
use super::table::{Line, Table, significant};
use super::{escape, proxy};
use crate::kernels::{Curve, FAR, Family, Kernels, Truth};

/// Figures, tables, findings.
pub(super) fn html(kernels: &Kernels) -> String {
    let measures = MEASURES.iter().map(|measure| {
        let figures = Truth::ALL.map(|truth| figure(kernels, measure, truth));
        format!(
            "<h3>{}</h3>\n<p class=\"note\">{}</p>\n<div class=\"plots\">\n{}</div>\n",
            measure.title,
            escape(&measure.note()),
            figures.concat()
        )
    });
    format!(
        "{}<p>{}</p>\n{}<h3>Worst over \u{3ba}</h3>\n{}<p class=\"note\">{}</p>\n{}<h3>The \
            filters</h3>\n\
         <div class=\"methods\">{}</div>\n",
        include_str!("kernels.html"),
        escape(&finding(kernels)),
        measures.collect::<Vec<_>>().concat(),
        worst(kernels).html(),
        escape(&tails(kernels)),
        proxy::html(&kernels.proxies),
        legend(kernels).html(),
    )
}

/// The table and the findings, for the terminal.
pub(super) fn text(kernels: &Kernels) -> String {
    let findings = [finding(kernels), tails(kernels), proxy::finding(&kernels.proxies)];
    format!(
        "\nFilters without a renderer: worst over kappa, against the exact box and the exact \
            Gaussian pixel\n\
         {}{}\n",
        worst(kernels).text(),
        findings.join("\n")
    )
}

fn of(kernels: &Kernels, truth: Truth) -> impl Iterator<Item = &Curve> + Clone {
    kernels.curves.iter().filter(move |curve| curve.truth == truth)
}

fn worst_of(curve: &Curve, measure: &Measure) -> f64 {
    curve.worst(measure.value, measure.distance)
}

/// Every filter's worst values against both truths.
fn worst(kernels: &Kernels) -> Table {
    let [square, gaussian] = Truth::ALL.map(|truth| of(kernels, truth));
    let rows = square.zip(gaussian).map(|curves| {
        let cells = <[_; 2]>::from(curves)
            .map(|curve| MEASURES.iter().map(|m| (m.show)(worst_of(curve, m))).collect::<Vec<_>>());
        Line { cells: [vec![curves.0.filter.name.into()], cells.concat()].concat(), class: "" }
    });
    let headers = &[
        "Filter",
        "Box: peak",
        "L1",
        "largest",
        "tail",
        "Gaussian: peak",
        "L1",
        "largest",
        "tail",
    ];
    Table { headers, rows: rows.collect() }
}

/// What the filters are.
fn legend(kernels: &Kernels) -> Table {
    let rows = of(kernels, Truth::Box).map(|curve| Line {
        cells: [curve.filter.name, curve.filter.formula, curve.filter.source]
            .map(Into::into)
            .into(),
        class: "",
    });
    Table { headers: &["Filter", "What it gives", "Source"], rows: rows.collect() }
}

/// Which filters are least wrong, and how much the pixel's own shape matters.
fn finding(kernels: &Kernels) -> String {
    let l1 = |curve: &Curve| worst_of(curve, &L1);
    let least = |truth: Truth| {
        let closed = of(kernels, truth).filter(|curve| curve.filter.is_closed());
        let best = closed.min_by(|a, b| l1(a).total_cmp(&l1(b)))?;
        let (error, peak) = (significant(l1(best)), (PEAK.show)(worst_of(best, &PEAK)));
        let (name, pixel) = (best.filter.name, truth.name());
        Some(format!("{error} under the {pixel} ({name}; its peak wrong by up to {peak})"))
    };
    // Of the two exact filters one is the truth; what is left is the exchange.
    let exact = kernels.curves.iter().filter(|curve| curve.filter.family == Family::Exact);
    let exchange = exact.map(l1).fold(0.0, f64::max);
    format!(
        "Of the filters that give a GGX again, the least L1 error at the worst \u{3ba} is {}; \
            taking one \
         pixel for the other, all else exact, costs {}.",
        Truth::ALL.into_iter().filter_map(least).collect::<Vec<_>>().join(" and "),
        significant(exchange)
    )
}

/// How far off the tails of widened lobes are, once only tails are left.
fn tails(kernels: &Kernels) -> String {
    let widened = kernels
        .curves
        .iter()
        .filter(|curve| curve.filter.is_closed() && curve.filter.family != Family::Nothing);
    let last = widened.filter_map(|curve| curve.points.last());
    let (least, most) = last
        .clone()
        .map(|point| point.far_ratio)
        .fold((f64::INFINITY, 0.0_f64), |(least, most), ratio| (least.min(ratio), most.max(ratio)));
    let kappa = last.map(|point| point.kappa).fold(0.0, f64::max);
    format!(
        "At {FAR} alphas, far beyond the pixel, every widened GGX is too bright by \
            (\u{3b1}\u{2032}/\u{3b1})\u{b2}, the truths\u{2019} \
         tails being those of the lobe itself: {} to {} times at \u{3ba} = {}.",
        significant(least),
        significant(most),
        significant(kappa)
    )
}

/// Both pixels' figures of a measure are alike but for the truth.
fn figure(kernels: &Kernels, measure: &Measure, truth: Truth) -> String {
    let lines = of(kernels, truth).enumerate().map(|(index, curve)| Curved {
        name: curve.filter.label.into(),
        class: class(of(kernels, truth).take(index).map(|c| c.filter.family), curve.filter.family),
        points: curve
            .points
            .iter()
            .map(|point| [point.kappa, measure.factor * (measure.value)(point)])
            .filter(|[_, value]| value.is_finite())
            .collect(),
    });
    let pixel = truth.name();
    drawn(
        match truth {
            Truth::Box => "Box pixel",
            Truth::Gaussian => "Gaussian pixel",
        },
        &Chart {
            title: format!("{} over kappa, {pixel} pixel", measure.title),
            x: Range::new(
                "\u{3ba} = 2\u{3c3}\u{b2}/\u{3b1}\u{b2}",
                Scale::Logarithmic,
                [0.01, 100.0],
            ),
            y: measure.axis,
            right: measure.right,
            lines: lines.collect(),
        },
    )
}

/// A figure element; below it what lies outside the frame.
pub(super) fn drawn(heading: &str, chart: &Chart) -> String {
    let outside = match chart.outside() {
        names if names.is_empty() => String::new(),
        names => {
            format!("<figcaption>Outside the frame: {}.</figcaption>", escape(&names.join("; ")))
        }
    };
    format!("<figure><h4>{heading}</h4>\n{}{outside}</figure>\n", chart.svg())
}

/// CSS classes of a filter's line: color by idea, dashes within it.
fn class(before: impl Iterator<Item = Family>, family: Family) -> String {
    let color = match family {
        Family::Nothing => "nothing",
        Family::Added => "added",
        Family::Published => "published",
        Family::Peak => "peak",
        Family::Exact => "exact",
    };
    let before = before.filter(|&other| other == family).count();
    let dashes = ["", " second", " third"][before.min(2)];
    format!("{color}{dashes}")
}
